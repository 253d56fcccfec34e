#include "core/project/zip_writer.h"

#include <cstdint>
#include <new>

#include "core/base/write_file.h"
#include "core/project/zip_error.h"

namespace graftsman {
namespace {

constexpr std::size_t kPackBlock = std::size_t{1} << 20;
constexpr double kPackingShare = 0.7;    // of the progress; writing to the disk is the rest
constexpr double kProgressStep = 0.001;  // of the packing, between two looks at the progress
// 1 January 1980, the zip's first day: a project's bytes depend on nothing but its content.
constexpr std::uint16_t kDate = (1U << 5) | 1U;
constexpr std::uint16_t kTime = 0;

tl::unexpected<Error> cannotPack(zip_error_t& error) {
  const int code = zip_error_code_zip(&error);
  if (code == ZIP_ER_MEMORY) {
    return fail(ErrorCode::OutOfMemory, "Not enough memory to pack the project.");
  }
  if (code == ZIP_ER_CANCELLED) {
    return fail(ErrorCode::Cancelled, "Writing was cancelled.");
  }
  return fail(ErrorCode::FileUnwritable,
              std::string("The project cannot be packed: ") + zip_error_strerror(&error));
}

}  // namespace

struct ZipWriter::Archive {
  zip_source_t* packed = nullptr;  // the finished bytes
  zip_t* zip = nullptr;
  Archive() = default;
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;
  ~Archive() {
    zip_discard(zip);
    zip_source_free(packed);
  }
};

ZipWriter::ZipWriter() : archive_(std::make_shared<Archive>()) {
  archive_->packed = zip_source_buffer_create(nullptr, 0, 0, nullptr);
  if (archive_->packed == nullptr) {
    throw std::bad_alloc();
  }
  zip_source_keep(archive_->packed);
  archive_->zip = zip_open_from_source(archive_->packed, ZIP_CREATE | ZIP_TRUNCATE, nullptr);
  if (archive_->zip == nullptr) {
    zip_source_free(archive_->packed);
    throw std::bad_alloc();
  }
}

Result<void> ZipWriter::add(const std::string& name, const std::vector<std::string_view>& blocks,
                            Packing packing) {
  zip_t* const zip = archive_->zip;
  std::vector<zip_buffer_fragment_t> fragments;
  for (const std::string_view block : blocks) {
    // libzip reads through a pointer that its own structure holds as one to bytes that may be written.
    auto* const data = const_cast<std::uint8_t*>(reinterpret_cast<const std::uint8_t*>(block.data()));
    fragments.push_back({data, block.size()});
  }
  ZipError error;
  zip_source_t* const source =
      zip_source_buffer_fragment_create(fragments.data(), fragments.size(), 0, &error.value);
  if (source == nullptr) {
    return cannotPack(error.value);
  }
  const std::int64_t added = zip_file_add(zip, name.c_str(), source, 0);
  if (added < 0) {
    zip_source_free(source);
    return cannotPack(*zip_get_error(zip));
  }
  const auto number = static_cast<std::uint64_t>(added);
  const int method = packing == Packing::Stored ? ZIP_CM_STORE : ZIP_CM_DEFLATE;
  if (zip_set_file_compression(zip, number, method, 0) != 0 ||
      zip_file_set_dostime(zip, number, kTime, kDate, 0) != 0) {
    return cannotPack(*zip_get_error(zip));
  }
  return {};
}

Result<void> ZipWriter::write(const std::filesystem::path& path, const Progress& progress) {
  Progress packing = progress.span(0, kPackingShare);
  zip_register_progress_callback_with_state(
      archive_->zip, kProgressStep,
      [](zip_t*, double done, void* state) {
        static_cast<void>(static_cast<const Progress*>(state)->keepGoing(done));
      },
      nullptr, &packing);
  zip_register_cancel_callback_with_state(
      archive_->zip,
      [](zip_t*, void* state) { return static_cast<const Progress*>(state)->cancelled() ? 1 : 0; }, nullptr,
      &packing);
  if (zip_close(archive_->zip) != 0) {
    return cannotPack(*zip_get_error(archive_->zip));
  }
  archive_->zip = nullptr;
  zip_source_t* const packed = archive_->packed;
  zip_stat_t stat;
  if (zip_source_stat(packed, &stat) != 0 || zip_source_open(packed) != 0) {
    return cannotPack(*zip_source_error(packed));
  }
  std::string block(kPackBlock, '\0');
  double written = 0;
  const Progress writing = progress.span(kPackingShare, 1);
  return writeFile(path, [&]() -> Result<std::string_view> {
    const std::int64_t got = zip_source_read(packed, block.data(), block.size());
    if (got < 0) {
      return cannotPack(*zip_source_error(packed));
    }
    if (!writing.keepGoing(written / static_cast<double>(stat.size))) {
      return fail(ErrorCode::Cancelled, "Writing was cancelled.");
    }
    written += static_cast<double>(got);
    return std::string_view(block.data(), static_cast<std::size_t>(got));
  });
}

}  // namespace graftsman
