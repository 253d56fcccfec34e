#include "app/document/commands.h"
int main() { return 0; }
