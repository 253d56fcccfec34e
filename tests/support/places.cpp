#include "tests/support/places.h"

namespace graftsman::places {

std::filesystem::path samples() {
  return GRAFTSMAN_SAMPLES;
}

std::filesystem::path testData() {
  return GRAFTSMAN_TEST_DATA;
}

std::filesystem::path commandLine() {
  return GRAFTSMAN_CLI;
}

}  // namespace graftsman::places
