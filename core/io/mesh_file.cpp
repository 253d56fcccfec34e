#include "core/io/mesh_file.h"

#include <algorithm>
#include <cctype>
#include <exception>
#include <new>
#include <stdexcept>

#include "core/io/mesh_parse.h"
#include "core/io/obj_reader.h"
#include "core/io/off_reader.h"
#include "core/io/ply_reader.h"
#include "core/io/printable.h"
#include "core/io/read_file.h"
#include "core/io/stl_reader.h"

namespace graftsman {
namespace {

// Shares of a reading's time, about.
constexpr double kReadShare = 0.1;
constexpr double kParseShare = 0.7;

Result<RawMesh> readRaw(const ReadInput& input, MeshFormat format) {
  switch (format) {
    case MeshFormat::Obj:
      return readObj(input);
    case MeshFormat::Ply:
      return readPly(input);
    case MeshFormat::Stl:
      return readStl(input);
    case MeshFormat::Off:
      return readOff(input);
  }
  return fail(ErrorCode::FormatUnknown, input.name + ": unknown format");
}

// What `read` returns; exceptions as errors.
template <class Read>
auto guarded(const std::filesystem::path& path, std::size_t size, Read read) -> decltype(read()) {
  const auto outOfMemory = [&] {
    return fail(ErrorCode::OutOfMemory, printable(path.filename().string()) +
                                            ": not enough memory for the mesh in a file of " +
                                            std::to_string(size) + " bytes");
  };
  try {
    return read();
  } catch (const std::bad_alloc&) {
    return outOfMemory();
  } catch (const std::length_error&) {
    return outOfMemory();
  } catch (const std::exception& e) {
    return fail(ErrorCode::Unexpected, printable(path.filename().string()) + ": " + e.what());
  }
}

}  // namespace

Result<MeshFormat> formatOf(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  static constexpr std::pair<const char*, MeshFormat> kEndings[] = {{".obj", MeshFormat::Obj},
                                                                    {".ply", MeshFormat::Ply},
                                                                    {".stl", MeshFormat::Stl},
                                                                    {".off", MeshFormat::Off}};
  for (const auto& [known, format] : kEndings) {
    if (ending == known) {
      return format;
    }
  }
  if (path.empty()) {
    return fail(ErrorCode::FormatUnknown,
                "The mesh file's name is empty; the name must end in .obj, .ply, .stl or .off");
  }
  return fail(ErrorCode::FormatUnknown,
              printable(path.string(), kLongestPathShown) +
                  ": unknown format; the name must end in .obj, .ply, .stl or .off");
}

Result<TriangleSoup> parseTriangles(std::span<const char> bytes, MeshFormat format,
                                    const std::filesystem::path& path, const Progress& progress) {
  return guarded(path, bytes.size(), [&]() -> Result<TriangleSoup> {
    const std::string name = printable(path.filename().string());
    if (bytes.empty()) {
      return fail(ErrorCode::FileMalformed, name + ": the file is empty");
    }
    Result<RawMesh> raw = readRaw({bytes, name, progress}, format);
    if (!raw) {
      return fail(std::move(raw.error()));
    }
    TriangleSoup soup = triangulated(std::move(*raw));
    soup.report.format = format;
    return soup;
  });
}

// The bytes after a byte order mark, which editors put before text. A binary STL's header may be anything.
std::span<const char> withoutByteOrderMark(std::span<const char> bytes, MeshFormat format) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  const bool marked =
      format != MeshFormat::Stl && std::string_view(bytes.data(), bytes.size()).starts_with(kMark);
  return marked ? bytes.subspan(kMark.size()) : bytes;
}

Result<MeshFile> parseMesh(std::span<const char> bytes, MeshFormat format, const std::filesystem::path& path,
                           const Progress& progress) {
  return guarded(path, bytes.size(), [&]() -> Result<MeshFile> {
    Result<TriangleSoup> soup =
        parseTriangles(withoutByteOrderMark(bytes, format), format, path, progress.span(0, kParseShare));
    if (!soup) {
      return fail(std::move(soup.error()));
    }
    if (!progress.keepGoing(kParseShare)) {
      return fail(ErrorCode::Cancelled, "Reading was cancelled.");
    }
    return assembled(std::move(*soup), printable(path.filename().string()));
  });
}

Result<MeshFile> readMesh(const std::filesystem::path& path, const Progress& progress) {
  const Result<MeshFormat> format = formatOf(path);
  if (!format) {
    return fail(format.error());
  }
  const Result<FileBytes> file = readFile(path, progress.span(0, kReadShare));
  if (!file) {
    return fail(file.error());
  }
  return parseMesh(file->bytes(), *format, path, progress.span(kReadShare, 1));
}

}  // namespace graftsman
