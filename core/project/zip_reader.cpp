#include "core/project/zip_reader.h"

#include <algorithm>
#include <new>
#include <utility>

#include "core/project/zip_error.h"

namespace graftsman {
namespace {

constexpr std::uint64_t kUnpackBlock = std::uint64_t{1} << 22;  // read between two looks at the progress
// What a file may unpack to: meshes and texts pack to a tenth at best.
constexpr std::uint64_t kGreatestRatio = 64;
constexpr std::uint64_t kAlwaysUnpackable = std::uint64_t{16} << 20;

tl::unexpected<Error> damaged(const std::string& how) {
  return fail(ErrorCode::FileMalformed, how);
}

tl::unexpected<Error> damaged(zip_error_t& error) {
  if (zip_error_code_zip(&error) == ZIP_ER_MEMORY) {
    throw std::bad_alloc();
  }
  return damaged(std::string(zip_error_strerror(&error)));
}

}  // namespace

struct ZipReader::Archive {
  zip_t* zip = nullptr;
  Archive() = default;
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;
  ~Archive() { zip_discard(zip); }
};

struct ZipStream::File {
  std::shared_ptr<void> archive;  // kept while the entry is read
  zip_file_t* file = nullptr;
  std::uint64_t size = 0;
  std::uint64_t done = 0;
  File() = default;
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    if (file != nullptr) {
      zip_fclose(file);
    }
  }
};

Result<void> ZipStream::read(std::span<char> into, const Progress& progress) {
  while (!into.empty()) {
    const std::int64_t got =
        zip_fread(file_->file, into.data(), std::min<std::uint64_t>(into.size(), kUnpackBlock));
    if (got < 0) {
      return damaged(*zip_file_get_error(file_->file));
    }
    if (got == 0) {
      return damaged("it ends too early");
    }
    into = into.subspan(static_cast<std::size_t>(got));
    file_->done += static_cast<std::uint64_t>(got);
    const double share = static_cast<double>(file_->done) / static_cast<double>(file_->size);
    if (!progress.keepGoing(share)) {
      return fail(ErrorCode::Cancelled, "Reading was cancelled.");
    }
  }
  return {};
}

Result<void> ZipStream::finish() {
  char more = 0;
  const std::int64_t got = zip_fread(file_->file, &more, 1);
  if (got > 0) {
    return damaged("it goes on beyond its end");
  }
  return got == 0 ? Result<void>() : damaged(*zip_file_get_error(file_->file));
}

Result<ZipReader> ZipReader::open(std::span<const char> bytes) {
  ZipError error;
  auto archive = std::make_shared<Archive>();
  if (zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error.value)) {
    archive->zip = zip_open_from_source(source, ZIP_RDONLY, &error.value);
    if (archive->zip == nullptr) {
      zip_source_free(source);
    }
  }
  if (archive->zip == nullptr) {
    return damaged(error.value);
  }
  ZipReader reader;
  reader.unpackable_ = kAlwaysUnpackable + kGreatestRatio * bytes.size();
  const std::int64_t count = zip_get_num_entries(archive->zip, 0);
  for (std::int64_t i = 0; i < count; ++i) {
    zip_stat_t stat;
    constexpr std::uint64_t kNeeded = ZIP_STAT_NAME | ZIP_STAT_SIZE | ZIP_STAT_CRC | ZIP_STAT_COMP_METHOD;
    if (zip_stat_index(archive->zip, static_cast<std::uint64_t>(i), 0, &stat) != 0) {
      return damaged(*zip_get_error(archive->zip));
    }
    if ((stat.valid & kNeeded) != kNeeded) {
      return damaged("its directory is incomplete");
    }
    reader.entries_.push_back({stat.name, stat.size, stat.crc, stat.comp_method == ZIP_CM_STORE});
  }
  reader.archive_ = std::move(archive);
  return reader;
}

const ZipEntry* ZipReader::find(const std::string& name) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const ZipEntry& entry) { return entry.name == name; });
  return found == entries_.end() ? nullptr : &*found;
}

Result<ZipStream> ZipReader::stream(const ZipEntry& entry) {
  if (entry.size > unpackable_) {
    return damaged("it claims to hold " + std::to_string(entry.size) +
                   " bytes, more than a file of this size can");
  }
  unpackable_ -= entry.size;
  ZipStream stream;
  stream.file_ = std::make_shared<ZipStream::File>();
  stream.file_->archive = archive_;
  stream.file_->size = entry.size;
  const auto number = static_cast<std::uint64_t>(&entry - entries_.data());
  stream.file_->file = zip_fopen_index(archive_->zip, number, 0);
  if (stream.file_->file == nullptr) {
    return damaged(*zip_get_error(archive_->zip));
  }
  return stream;
}

Result<std::string> ZipReader::content(const ZipEntry& entry, const Progress& progress) {
  Result<ZipStream> opened = stream(entry);
  if (!opened) {
    return fail(std::move(opened.error()));
  }
  std::string bytes(entry.size, '\0');
  Result<void> read = opened->read(bytes, progress);
  read = read ? opened->finish() : std::move(read);
  if (!read) {
    return fail(std::move(read.error()));
  }
  return bytes;
}

}  // namespace graftsman
