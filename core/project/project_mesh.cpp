#include "core/project/project_mesh.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <utility>

namespace graftsman {
namespace {

static_assert(std::endian::native == std::endian::little, "meshes are written as they lie in memory");
static_assert(sizeof(Point) == 3 * sizeof(double) && sizeof(Face) == 3 * sizeof(Index));

constexpr std::string_view kMagic = "grafmesh";
constexpr std::size_t kCountsAt = kMagic.size();
constexpr double kMeshReadShare = 0.5;  // of the progress; finding the neighbours is the rest

template <class T>
std::string_view bytesOf(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

template <class T>
std::span<char> bytesOf(std::vector<T>& values) {
  return {reinterpret_cast<char*>(values.data()), values.size() * sizeof(T)};
}

tl::unexpected<Error> malformedEntry(const std::string& what) {
  return fail(ErrorCode::FileMalformed, what);
}

// What is wrong with the content, if anything is.
Result<void> check(const std::vector<Point>& points, const std::vector<Face>& faces) {
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (!points[v].allFinite()) {
      return malformedEntry("vertex " + std::to_string(v) + " has a coordinate that is no finite number");
    }
  }
  const auto isVertex = [&](Index v) { return v >= 0 && static_cast<std::size_t>(v) < points.size(); };
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto& [a, b, c] = faces[f];
    if (!isVertex(a) || !isVertex(b) || !isVertex(c) || a == b || b == c || c == a) {
      return malformedEntry("face " + std::to_string(f) + " does not name three different vertices");
    }
  }
  return {};
}

}  // namespace

MeshEntry::MeshEntry(const TriangleMesh& mesh) {
  const std::array<Index, 2> counts = {mesh.vertexCount(), mesh.faceCount()};
  std::memcpy(header_.data(), kMagic.data(), kMagic.size());
  std::memcpy(header_.data() + kCountsAt, counts.data(), sizeof(counts));
  blocks_ = {std::string_view(header_.data(), header_.size()), bytesOf(mesh.points()), bytesOf(mesh.faces())};
}

std::uint32_t MeshEntry::crc32() const {
  uLong sum = ::crc32(0, nullptr, 0);
  for (const std::string_view block : blocks_) {
    sum = crc32_z(sum, reinterpret_cast<const Bytef*>(block.data()), block.size());
  }
  return static_cast<std::uint32_t>(sum);
}

Result<std::shared_ptr<const TriangleMesh>> readMeshEntry(ZipReader& zip, const ZipEntry& entry,
                                                          const Progress& progress) {
  Result<ZipStream> stream = zip.stream(entry);
  if (!stream) {
    return fail(std::move(stream.error()));
  }
  const Progress reading = progress.span(0, kMeshReadShare);
  std::array<char, kCountsAt + 2 * sizeof(Index)> header = {};
  if (Result<void> read = stream->read(header, reading); !read) {
    return fail(std::move(read.error()));
  }
  std::array<Index, 2> counts = {};
  std::memcpy(counts.data(), header.data() + kCountsAt, sizeof(counts));
  const auto [vertexCount, faceCount] = counts;
  if (std::string_view(header.data(), kMagic.size()) != kMagic) {
    return malformedEntry("it is no mesh");
  }
  if (vertexCount < 0 || faceCount <= 0 || faceCount > std::numeric_limits<Index>::max() / 3 ||
      entry.size != header.size() + static_cast<std::uint64_t>(vertexCount) * sizeof(Point) +
                        static_cast<std::uint64_t>(faceCount) * sizeof(Face)) {
    return malformedEntry("it holds " + std::to_string(entry.size) + " bytes, which does not fit its " +
                          std::to_string(vertexCount) + " vertices and " + std::to_string(faceCount) +
                          " faces");
  }
  std::vector<Point> points(static_cast<std::size_t>(vertexCount));
  std::vector<Face> faces(static_cast<std::size_t>(faceCount));
  Result<void> read = stream->read(bytesOf(points), reading);
  read = read ? stream->read(bytesOf(faces), reading) : std::move(read);
  read = read ? stream->finish() : std::move(read);
  read = read ? check(points, faces) : std::move(read);
  if (!read) {
    return fail(std::move(read.error()));
  }
  if (!progress.keepGoing(kMeshReadShare)) {
    return fail(ErrorCode::Cancelled, "Reading was cancelled.");
  }
  return std::make_shared<const TriangleMesh>(std::move(points), std::move(faces));
}

}  // namespace graftsman
