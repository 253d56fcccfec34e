#include "core/base/write_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

namespace graftsman {
namespace {

tl::unexpected<Error> cannotWrite(const std::filesystem::path& path, int reason) {
  return fail(ErrorCode::FileUnwritable,
              path.string() + ": cannot be written: " + std::generic_category().message(reason));
}

using Blocks = std::function<Result<std::string_view>()>;

Result<void> writeAll(int file, const std::filesystem::path& path, const Blocks& next) {
  while (true) {
    Result<std::string_view> block = next();
    if (!block) {
      return fail(std::move(block.error()));
    }
    if (block->empty()) {
      return {};
    }
    for (std::string_view bytes = *block; !bytes.empty();) {
      const ssize_t written = ::write(file, bytes.data(), bytes.size());
      if (written < 0 && errno != EINTR) {
        return cannotWrite(path, errno);
      }
      bytes.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
    }
  }
}

// Creates a file beside `target` under a name that nobody has; -1 with errno if that fails.
int createBeside(const std::filesystem::path& target, std::string& name) {
  for (int attempt = 0;; ++attempt) {
    name = target.string() + "." + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".part";
    const int file = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0 || errno != EEXIST) {
      return file;
    }
  }
}

// Gives the new file the permissions of the one that it replaces, if there is one. 0 or an errno.
int keepPermissions(int file, const std::filesystem::path& target) {
  struct stat status = {};
  if (::stat(target.c_str(), &status) != 0) {
    return 0;
  }
  return ::fchmod(file, status.st_mode & 07777) == 0 ? 0 : errno;
}

Result<void> writeDirectly(const std::filesystem::path& path, const Blocks& next) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) {
    return cannotWrite(path, errno);
  }
  Result<void> written = writeAll(file, path, next);
  if (::close(file) != 0 && written) {
    return cannotWrite(path, errno);
  }
  return written;
}

// Writes the new file and puts it on the disk.
Result<void> fill(int file, const std::filesystem::path& path, const std::filesystem::path& target,
                  const Blocks& next) {
  if (Result<void> written = writeAll(file, path, next); !written) {
    return written;
  }
  if (const int failure = keepPermissions(file, target); failure != 0) {
    return cannotWrite(path, failure);
  }
  return ::fsync(file) == 0 ? Result<void>() : cannotWrite(path, errno);
}

}  // namespace

Result<void> writeFile(const std::filesystem::path& path, const Blocks& next) {
  std::error_code ignored;
  const std::filesystem::path resolved = std::filesystem::weakly_canonical(path, ignored);
  const std::filesystem::path target = resolved.empty() ? path : resolved;
  const std::filesystem::file_status status = std::filesystem::status(target, ignored);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    return std::filesystem::is_directory(status) ? cannotWrite(path, EISDIR) : writeDirectly(target, next);
  }
  std::string beside;
  const int file = createBeside(target, beside);
  if (file < 0) {
    return cannotWrite(path, errno);
  }
  Result<void> written = fill(file, path, target, next);
  if (::close(file) != 0 && written) {
    written = cannotWrite(path, errno);
  }
  if (written && ::rename(beside.c_str(), target.c_str()) != 0) {
    written = cannotWrite(path, errno);
  }
  if (!written) {
    ::unlink(beside.c_str());
  }
  return written;
}

Result<void> writeFile(const std::filesystem::path& path, std::string_view bytes) {
  return writeFile(path, [&]() -> Result<std::string_view> { return std::exchange(bytes, {}); });
}

}  // namespace graftsman
