#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/sweep/sweep_file.h"

// Whatever the bytes: a sweep that survives formatting and parsing again and whose combinations have names,
// or an error with a message.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace graftsman;
  const std::filesystem::path path = "folder/fuzz.json";
  const Result<SweepFile> file = parseSweep({reinterpret_cast<const char*>(data), size}, path);
  if (!file) {
    return file.error().message.empty() ? std::abort(), 0 : 0;
  }
  const std::string text = formatSweep(*file, path);
  const Result<SweepFile> back = parseSweep(text, path);
  if (!back || back->sweep.count() != file->sweep.count() || formatSweep(*back, path) != text) {
    std::abort();
  }
  const std::size_t last = file->sweep.count() - 1;
  const std::string name = file->sweep.name(last);
  if (name.empty() || name.size() >= 240 || name.find('/') != std::string::npos ||
      back->sweep.name(last) != name) {
    std::abort();
  }
  return 0;
}
