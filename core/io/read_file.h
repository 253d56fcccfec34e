#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>

#include "core/base/error.h"
#include "core/base/progress.h"

namespace graftsman {

/// A file's content in memory.
class FileBytes {
 public:
  FileBytes() = default;
  FileBytes(std::unique_ptr<char[]> data, std::size_t size) : data_(std::move(data)), size_(size) {}
  [[nodiscard]] std::span<const char> bytes() const { return {data_.get(), size_}; }

 private:
  std::unique_ptr<char[]> data_;
  std::size_t size_ = 0;
};

/// Reads a whole file, or a pipe until its writers have closed it. The bytes are a copy: another program that
/// truncates the file afterwards does no harm. Errors: FileUnreadable (missing, a folder, a device, no
/// permission; the message says which), OutOfMemory, Cancelled.
[[nodiscard]] Result<FileBytes> readFile(const std::filesystem::path& path, const Progress& progress);

}  // namespace graftsman
