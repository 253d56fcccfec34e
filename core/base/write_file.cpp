#include "core/base/write_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

namespace graftsman {
namespace {

tl::unexpected<Error> cannotWrite(const std::filesystem::path& path, int reason) {
  return fail(ErrorCode::FileUnwritable,
              path.string() + ": cannot be written: " + std::generic_category().message(reason));
}

// 0 or an errno.
int writeAll(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) {
      return errno;
    }
    bytes.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
  }
  return 0;
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

Result<void> writeDirectly(const std::filesystem::path& path, std::string_view bytes) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) {
    return cannotWrite(path, errno);
  }
  const int failure = writeAll(file, bytes);
  const int closed = ::close(file) == 0 ? 0 : errno;
  if (failure != 0 || closed != 0) {
    return cannotWrite(path, failure != 0 ? failure : closed);
  }
  return {};
}

}  // namespace

Result<void> writeFile(const std::filesystem::path& path, std::string_view bytes) {
  std::error_code ignored;
  const std::filesystem::path resolved = std::filesystem::weakly_canonical(path, ignored);
  const std::filesystem::path target = resolved.empty() ? path : resolved;
  const std::filesystem::file_status status = std::filesystem::status(target, ignored);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    return std::filesystem::is_directory(status) ? cannotWrite(path, EISDIR) : writeDirectly(target, bytes);
  }
  std::string beside;
  const int file = createBeside(target, beside);
  if (file < 0) {
    return cannotWrite(path, errno);
  }
  int failure = writeAll(file, bytes);
  if (failure == 0) {
    failure = keepPermissions(file, target);
  }
  if (failure == 0 && ::fsync(file) != 0) {
    failure = errno;
  }
  if (::close(file) != 0 && failure == 0) {
    failure = errno;
  }
  if (failure == 0 && ::rename(beside.c_str(), target.c_str()) != 0) {
    failure = errno;
  }
  if (failure != 0) {
    ::unlink(beside.c_str());
    return cannotWrite(path, failure);
  }
  return {};
}

}  // namespace graftsman
