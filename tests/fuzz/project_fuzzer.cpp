#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/io/read_file.h"
#include "core/project/project_parse.h"
#include "core/project/zip_writer.h"

namespace {

using namespace graftsman;

void require(bool holds) {
  if (!holds) {
    std::abort();
  }
}

std::filesystem::path scratch() {
  return std::filesystem::temp_directory_path() / ("project_fuzzer." + std::to_string(::getpid()) + ".graft");
}

FileBytes takeScratch() {
  Result<FileBytes> bytes = readFile(scratch(), {});
  std::filesystem::remove(scratch());
  require(bytes.has_value());
  return std::move(*bytes);
}

FileBytes save(const Project& project) {
  require(writeProject(scratch(), project, {}).has_value());
  return takeScratch();
}

// Takes what stands before the next zero byte, and the byte.
std::string_view takeUpToZero(std::string_view& data) {
  const std::size_t zero = std::min(data.find('\0'), data.size());
  const std::string_view taken = data.substr(0, zero);
  data.remove_prefix(std::min(zero + 1, data.size()));
  return taken;
}

// Since no mutation hits a zip's checksums, bytes that are no zip are put into one: document.json, after a
// zero byte history.json (empty: none), after another one a mesh.
FileBytes zipOf(std::string_view data) {
  const std::string_view document = takeUpToZero(data);
  const std::string_view history = takeUpToZero(data);
  const std::string_view mesh = data;
  ZipWriter zip;
  require(zip.add("document.json", {document}, ZipWriter::Packing::Stored).has_value());
  if (!history.empty()) {
    require(zip.add("history.json", {history}, ZipWriter::Packing::Stored).has_value());
  }
  require(zip.add("meshes/1.mesh", {mesh}, ZipWriter::Packing::Stored).has_value());
  require(zip.write(scratch(), {}).has_value());
  return takeScratch();
}

}  // namespace

// Whatever the bytes: an error with a message, or a project that can be saved, is then without damage, and
// saved again gives the same bytes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const bool isZip = input.starts_with("PK");
  const FileBytes made = isZip ? FileBytes() : zipOf(input);
  const Result<LoadedProject> loaded =
      parseProject(isZip ? std::span<const char>(input) : made.bytes(), "fuzzed", {});
  if (!loaded) {
    require(loaded.error().message.starts_with("fuzzed: "));
    return 0;
  }
  for (const Error& error : loaded->damage) {
    require(!error.message.empty());
  }
  const FileBytes once = save(loaded->project);
  const Result<LoadedProject> back = parseProject(once.bytes(), "fuzzed", {});
  require(back && back->damage.empty() && back->fusionIntact);
  const FileBytes twice = save(back->project);
  require(std::string_view(once.bytes().data(), once.bytes().size()) ==
          std::string_view(twice.bytes().data(), twice.bytes().size()));
  return 0;
}
