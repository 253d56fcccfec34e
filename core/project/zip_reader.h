#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"

namespace graftsman {

/// One entry of a zip, as the zip's directory has it.
struct ZipEntry {
  std::string name;
  std::uint64_t size = 0;  // bytes, unpacked
  std::uint32_t crc32 = 0;
  bool stored = false;  // uncompressed
};

/// The content of one entry, from its beginning to its end. Its errors are one clause about the entry
/// ("its checksum is wrong"), code FileMalformed.
class ZipStream {
 public:
  /// Fills `into` with the next bytes. Errors: FileMalformed (also if the entry ends before), Cancelled.
  [[nodiscard]] Result<void> read(std::span<char> into, const Progress& progress);
  /// Checks that this was all, and the checksum. Error: FileMalformed.
  [[nodiscard]] Result<void> finish();

 private:
  friend class ZipReader;
  struct File;
  std::shared_ptr<File> file_;
};

/// The entries of a zip in memory.
class ZipReader {
 public:
  /// `bytes` must outlive the reader. Error: FileMalformed, one clause.
  [[nodiscard]] static Result<ZipReader> open(std::span<const char> bytes);

  [[nodiscard]] const std::vector<ZipEntry>& entries() const { return entries_; }
  /// The first entry of that name, or null.
  [[nodiscard]] const ZipEntry* find(const std::string& name) const;

  /// Starts to read one of entries(). All entries that are opened may together hold no more than a generous
  /// multiple of the zip's size, so that a small file cannot ask for all the memory. Error: FileMalformed.
  [[nodiscard]] Result<ZipStream> stream(const ZipEntry& entry);
  /// An entry's whole content. Errors: FileMalformed, Cancelled.
  [[nodiscard]] Result<std::string> content(const ZipEntry& entry, const Progress& progress);

 private:
  struct Archive;
  std::shared_ptr<Archive> archive_;
  std::vector<ZipEntry> entries_;
  std::uint64_t unpackable_ = 0;  // bytes that may still be unpacked
};

}  // namespace graftsman
