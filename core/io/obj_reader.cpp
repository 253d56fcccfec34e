#include "core/io/obj_reader.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>

#include "core/io/text_scanner.h"

namespace graftsman {
namespace {

constexpr std::size_t kBytesPerLook = std::size_t{1} << 20;  // bytes between two looks at the progress
constexpr std::size_t kShortVertex = 24;                     // bytes of a line with a vertex; few are shorter
constexpr std::size_t kShortFace = 14;                       // bytes of a line with a triangle

bool isContinuation(const char* at, const char* end) {
  return *at == '\\' && at + 1 != end && isLineEnd(at[1]);
}

// Over blanks, and over line ends after a backslash.
const char* skipContinuations(const char* at, const char* end) {
  while (at != end && isContinuation(at, end)) {
    at += at[1] == '\r' && at + 2 != end && at[2] == '\n' ? 3 : 2;
    at = skipBlanks(at, end);
  }
  return at;
}

inline const char* skipInLine(const char* at, const char* end) {
  at = skipBlanks(at, end);
  return at == end || *at != '\\' ? at : skipContinuations(at, end);
}

// Over the rest of a statement, with the lines that continue it.
const char* skipStatement(const char* at, const char* end) {
  while (true) {
    const char* const last = lineEnd(at, end);
    if (last == end || last == at || last[-1] != '\\' ||
        std::memchr(at, '#', static_cast<std::size_t>(last - at)) != nullptr) {
      return last;  // a backslash at the end of a comment continues nothing
    }
    at = last + (*last == '\r' && last + 1 != end && last[1] == '\n' ? 2 : 1);
  }
}

class ObjParser {
 public:
  // With `vertexCount` given, a corner beyond it is an error at its place; else it is only noticed.
  ObjParser(const ReadInput& input, std::optional<std::size_t> vertexCount)
      : input_(input), end_(input.bytes.data() + input.bytes.size()), vertexCount_(vertexCount) {}

  Result<RawMesh> parse() {
    // More than most files need. What is not written to takes no memory.
    mesh_.points.reserve(input_.bytes.size() / kShortVertex);
    mesh_.triangles.reserve(input_.bytes.size() / kShortFace);
    const char* at = input_.bytes.data();
    const auto size = static_cast<double>(input_.bytes.size());
    while (at != end_) {
      if (!input_.progress.keepGoing(static_cast<double>(at - input_.bytes.data()) / size)) {
        return readingCancelled();
      }
      const char* const blockEnd = at + std::min(kBytesPerLook, static_cast<std::size_t>(end_ - at));
      at = parseLines(at, blockEnd);
      if (at == nullptr) {
        return tl::unexpected<Error>(std::move(*error_));
      }
    }
    return std::move(mesh_);
  }

  [[nodiscard]] Index greatestVertex() const { return greatest_; }

 private:
  // Parses the statements that begin before blockEnd. Null: error_ says why.
  const char* parseLines(const char* at, const char* blockEnd) {
    while (at < blockEnd) {
      if (isSpace(*at)) {
        ++at;
        continue;
      }
      const char second = at + 1 != end_ ? at[1] : '\n';
      if (*at == 'v' && (isBlank(second) || second == '\\')) {
        at = parseVertex(at + 1);
      } else if (*at == 'f' && (isSpace(second) || second == '\\')) {
        at = parseFace(at, at + 1);
      } else if (*at == 'f' && second == 'o' && (at + 2 == end_ || isSpace(at[2]))) {
        at = parseFace(at, at + 2);  // the face statement of OBJ's first version
      } else {
        at = skipStatement(at, end_);
      }
      if (at == nullptr) {
        return nullptr;
      }
    }
    return at;
  }

  const char* parseVertex(const char* at) {
    Point point;
    const char* const after = parsePoint(at, end_, skipInLine, point);
    if (after == nullptr) {
      error_ = malformedPoint(input_, at, end_, skipInLine, mesh_.points.size() + 1).value();
      return nullptr;
    }
    mesh_.points.push_back(point);
    return after == end_ || isLineEnd(*after) ? after : skipStatement(after, end_);
  }

  const char* parseFace(const char* statement, const char* at) {
    Face face;
    std::size_t count = 0;
    while (true) {
      at = skipInLine(at, end_);
      if (at == end_ || isLineEnd(*at) || *at == '#') {
        break;
      }
      Index corner = 0;
      const char* const after = parsePlainCorner(at, corner);
      at = after != nullptr ? after : parseCorner(at, corner);
      if (at == nullptr) {
        return nullptr;
      }
      greatest_ = std::max(greatest_, corner);
      if (count < 3) {
        face[count] = corner;
      } else {
        if (count == 3) {
          mesh_.beginPolygon();
          mesh_.polygonCorners.insert(mesh_.polygonCorners.end(), face.begin(), face.end());
        }
        mesh_.polygonCorners.push_back(corner);
      }
      ++count;
    }
    if (count < 3) {
      return failAt(statement, count == 0 ? "the face has no corner"
                                          : "the face has " + std::to_string(count) +
                                                (count == 1 ? " corner" : " corners") +
                                                ", but a face needs 3 or more; is the file cut off?");
    }
    if (count == 3) {
      mesh_.triangles.push_back(face);
    }
    return skipStatement(at, end_);
  }

  // The corners that nearly all are: a positive number of a few digits. Null: not one of these.
  const char* parsePlainCorner(const char* at, Index& corner) const {
    std::uint64_t number = 0;
    const char* after = parseDigits(at, end_, number);
    if (number == 0 || after - at > kSurelyIndexDigits || after == end_ || vertexCount_) {
      return nullptr;
    }
    corner = static_cast<Index>(number) - 1;
    return *after == '/' ? skipCornerTail(after) : isSpace(*after) ? after : nullptr;
  }

  // A corner is v, v/vt, v//vn or v/vt/vn; what follows the first slash is of no use here.
  const char* parseCorner(const char* at, Index& corner) {
    std::int64_t number = 0;
    const char* after = parseInteger(at, end_, number);
    if (after == nullptr || !(endsToken(after, end_) || *after == '/')) {
      return failAt(at, "expected a vertex number, found " + shown(tokenAt(at, end_)));
    }
    const auto soFar = static_cast<std::int64_t>(mesh_.points.size());
    const std::int64_t vertex = number > 0 ? number - 1 : soFar + number;
    if (number == 0 || vertex < 0) {
      return failAt(at, number == 0 ? "a face refers to vertex 0, but OBJ counts vertices from 1"
                                    : "a face refers to vertex " + std::to_string(number) +
                                          ", but the file has " + std::to_string(soFar) + " vertices so far");
    }
    if (vertexCount_ && vertex >= static_cast<std::int64_t>(*vertexCount_)) {
      return failAt(at, "a face refers to vertex " + numberShown(at, after) + ", but the file has " +
                            std::to_string(*vertexCount_) + " vertices");
    }
    corner = static_cast<Index>(std::min<std::int64_t>(vertex, std::numeric_limits<Index>::max()));
    return skipCornerTail(after);
  }

  const char* skipCornerTail(const char* at) const {
    while (at != end_ && !endsToken(at, end_)) {
      ++at;
    }
    return at;
  }

  std::nullptr_t failAt(const char* at, const std::string& message) {
    error_ = malformedLine(input_, at, message).value();
    return nullptr;
  }

  const ReadInput& input_;
  const char* end_;
  std::optional<std::size_t> vertexCount_;
  RawMesh mesh_;
  Index greatest_ = -1;
  std::optional<Error> error_;
};

}  // namespace

Result<RawMesh> readObj(const ReadInput& input) {
  ObjParser parser(input, std::nullopt);
  Result<RawMesh> mesh = parser.parse();
  if (mesh && parser.greatestVertex() >= static_cast<Index>(mesh->points.size())) {
    return ObjParser(input, mesh->points.size()).parse();  // once more, to find the place
  }
  if (mesh && mesh->points.empty() && mesh->faceCount() == 0) {
    return fail(
        ErrorCode::FileMalformed,
        input.name + ": does not look like an OBJ file: it has no line with a vertex (v) or a face (f)");
  }
  return mesh;
}

}  // namespace graftsman
