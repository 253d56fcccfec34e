#include "core/io/read_file.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <string>
#include <system_error>

#include "core/io/printable.h"

namespace graftsman {
namespace {

constexpr std::size_t kReadBlock = std::size_t{1} << 22;  // read at a time, between two looks at the progress
constexpr std::size_t kPipeStart = std::size_t{1} << 16;
constexpr int kPollMilliseconds = 50;

class Descriptor {
 public:
  explicit Descriptor(int file) : file_(file) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (file_ >= 0) {
      ::close(file_);
    }
  }
  [[nodiscard]] int get() const { return file_; }

 private:
  int file_;
};

tl::unexpected<Error> cannotRead(const std::filesystem::path& path, const std::string& reason) {
  return fail(ErrorCode::FileUnreadable,
              printable(path.string(), kLongestPathShown) + ": cannot be read: " + reason);
}

std::string textOf(int systemError) {
  return std::generic_category().message(systemError);
}

// Waits until a pipe has data or no writer any more. False if cancelled.
bool waitForPipe(int file, const Progress& progress) {
  pollfd wanted = {file, POLLIN, 0};
  while (::poll(&wanted, 1, kPollMilliseconds) <= 0) {
    if (!progress.keepGoing(0)) {
      return false;
    }
  }
  return true;
}

}  // namespace

Result<FileBytes> readFile(const std::filesystem::path& path, const Progress& progress) {
  // Without O_NONBLOCK a pipe that nobody writes to would hold us here for ever.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat status = {};
  if (file.get() < 0 || ::fstat(file.get(), &status) != 0) {
    return cannotRead(path, textOf(errno));
  }
  const bool pipe = S_ISFIFO(status.st_mode);
  if (S_ISDIR(status.st_mode)) {
    return cannotRead(path, "it is a folder");
  }
  if (!pipe && !S_ISREG(status.st_mode)) {
    return cannotRead(path, "it is a device or a socket, not a file");
  }
  try {
    // One byte more than the file has, so that the end is seen without growing.
    std::size_t capacity = pipe ? kPipeStart : static_cast<std::size_t>(status.st_size) + 1;
    auto data = std::make_unique_for_overwrite<char[]>(capacity);
    std::size_t size = 0;
    while (true) {
      if (pipe && !waitForPipe(file.get(), progress)) {
        return fail(ErrorCode::Cancelled, "Reading was cancelled.");
      }
      const ssize_t got = ::read(file.get(), data.get() + size, std::min(capacity - size, kReadBlock));
      if (got == 0) {
        return FileBytes(std::move(data), size);
      }
      if (got < 0 && errno != EINTR && errno != EAGAIN) {
        return cannotRead(path, textOf(errno));
      }
      size += got > 0 ? static_cast<std::size_t>(got) : 0;
      if (size == capacity) {
        capacity *= 2;
        auto larger = std::make_unique_for_overwrite<char[]>(capacity);
        std::memcpy(larger.get(), data.get(), size);
        data = std::move(larger);
      }
      if (!progress.keepGoing(static_cast<double>(size) / static_cast<double>(capacity))) {
        return fail(ErrorCode::Cancelled, "Reading was cancelled.");
      }
    }
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::OutOfMemory, printable(path.string(), kLongestPathShown) +
                                            ": not enough memory to read the file (" +
                                            std::to_string(status.st_size) + " bytes)");
  }
}

}  // namespace graftsman
