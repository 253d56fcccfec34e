#include "tests/fuzz/mesh_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return graftsman::fuzz::run(data, size, graftsman::MeshFormat::Off);
}
