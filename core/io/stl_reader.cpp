#include "core/io/stl_reader.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cstring>
#include <optional>

#include "core/io/text_scanner.h"
#include "core/io/weld.h"

namespace graftsman {
namespace {

constexpr std::size_t kHeaderSize = 80;
constexpr std::size_t kCountEnd = 84;
constexpr std::size_t kFacetSize = 50;  // normal, three corners, attribute
constexpr std::size_t kCornerSize = 12;
constexpr std::size_t kCornersAt = 12;        // in a facet
constexpr std::size_t kFacetsPerLook = 4096;  // at the progress
constexpr std::size_t kTextFacetSize = 100;   // bytes of an ASCII facet, at least (a guess for reserving)

std::uint32_t littleEndian32(const char* at) {
  const auto byte = [at](int i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(at[i])); };
  return byte(0) | byte(1) << 8 | byte(2) << 16 | byte(3) << 24;
}

Point cornerAt(const char* at) {
  return {std::bit_cast<float>(littleEndian32(at)), std::bit_cast<float>(littleEndian32(at + 4)),
          std::bit_cast<float>(littleEndian32(at + 8))};
}

std::size_t declaredFacets(const ReadInput& input) {
  return littleEndian32(input.bytes.data() + kHeaderSize);
}

bool startsWithSolid(const ReadInput& input) {
  const char* const end = input.bytes.data() + input.bytes.size();
  const char* at = input.bytes.data();
  while (at != end && isSpace(*at)) {
    ++at;
  }
  static constexpr std::string_view kSolid = "solid";
  return static_cast<std::size_t>(end - at) >= kSolid.size() &&
         std::equal(kSolid.begin(), kSolid.end(), at, [](char a, char b) { return a == (b | 0x20); });
}

bool isBinary(const ReadInput& input) {
  const std::size_t size = input.bytes.size();
  if (size >= kCountEnd && size == kCountEnd + kFacetSize * declaredFacets(input)) {
    return true;
  }
  // A text never has a zero byte; a binary header that says "solid" is filled up with them, or its count has
  // one.
  const std::size_t looked = std::min(size, kCountEnd);
  return !startsWithSolid(input) || std::memchr(input.bytes.data(), 0, looked) != nullptr;
}

Result<RawMesh> readBinary(const ReadInput& input) {
  const char* const data = input.bytes.data();
  const std::size_t size = input.bytes.size();
  if (size < kCountEnd) {
    return malformedByte(
        input, data + size,
        "the file is too short for an STL file: it neither begins with 'solid' nor has the 84 "
        "bytes of a binary header");
  }
  const std::size_t facets = declaredFacets(input);
  const std::size_t room = (size - kCountEnd) / kFacetSize;
  if (facets != room) {
    return malformedByte(input, data + kHeaderSize,
                         "the header declares " + std::to_string(facets) + " facets, but the file of " +
                             std::to_string(size) + " bytes holds " + std::to_string(room) +
                             (facets > room ? "; is it cut off?" : ""));
  }
  if (facets > kGreatestCount / 3) {
    return malformedByte(input, data + kHeaderSize,
                         "more than " + std::to_string(kGreatestCount / 3) + " facets");
  }
  RawMesh mesh;
  mesh.binary = true;
  mesh.fileVertices = 3 * facets;
  mesh.triangles.resize(facets);
  PointWelder welder(facets / 2 + 2);
  std::vector<Point> corners(3 * std::min(facets, kFacetsPerLook));
  for (std::size_t first = 0; first < facets; first += kFacetsPerLook) {
    if (!input.progress.keepGoing(static_cast<double>(first) / static_cast<double>(facets))) {
      return readingCancelled();
    }
    const std::size_t count = std::min(kFacetsPerLook, facets - first);
    for (std::size_t i = 0; i < 3 * count; ++i) {
      const char* const at =
          data + kCountEnd + (first + i / 3) * kFacetSize + kCornersAt + i % 3 * kCornerSize;
      corners[i] = cornerAt(at);
      if (!corners[i].allFinite()) {
        return malformedByte(
            input, at, "a coordinate of facet " + std::to_string(first + i / 3) + " is not a finite number");
      }
    }
    welder.add({corners.data(), 3 * count}, {mesh.triangles[first].data(), 3 * count});
  }
  mesh.points = welder.takePoints();
  return mesh;
}

// "vertex" and its like, in any case.
bool isKeyword(std::string_view token, std::string_view keyword) {
  return token.size() == keyword.size() &&
         std::equal(token.begin(), token.end(), keyword.begin(),
                    [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

class AsciiParser {
 public:
  explicit AsciiParser(const ReadInput& input)
      : input_(input),
        end_(input.bytes.data() + input.bytes.size()),
        welder_(input.bytes.size() / (2 * kTextFacetSize) + 2) {}

  Result<RawMesh> parse() {
    const char* at = skipSpace(input_.bytes.data());
    for (std::size_t statement = 0; at != end_; ++statement) {
      if (statement % kFacetsPerLook == 0 &&
          !input_.progress.keepGoing(static_cast<double>(at - input_.bytes.data()) /
                                     static_cast<double>(input_.bytes.size()))) {
        return readingCancelled();
      }
      const char* const after = inFacet_ ? nullptr : parsePlainFacet(at);
      at = after != nullptr ? after : parseStatement(at, tokenAt(at, end_));
      if (at == nullptr) {
        return fail(std::move(*error_));
      }
      at = skipSpace(at);
    }
    if (inFacet_) {
      return malformedLine(input_, end_, "the file ends within a facet; is it cut off?");
    }
    weldPending();
    mesh_.fileVertices = 3 * mesh_.triangles.size();
    mesh_.points = welder_.takePoints();
    return std::move(mesh_);
  }

 private:
  const char* skipSpace(const char* at) const {
    while (at != end_ && isSpace(*at)) {
      ++at;
    }
    return at;
  }

  // The position after `word` and the space around it; null if something else stands at `at`.
  const char* skipWord(const char* at, std::string_view word) const {
    at = skipSpace(at);
    const bool isThere = static_cast<std::size_t>(end_ - at) > word.size() &&
                         std::memcmp(at, word.data(), word.size()) == 0 && isSpace(at[word.size()]);
    return isThere ? at + word.size() : nullptr;
  }

  // A facet as all programs write it, in lower case. Null: look at it statement by statement.
  const char* parsePlainFacet(const char* at) {
    at = skipWord(at, "facet");
    at = at != nullptr ? skipWord(lineEnd(at, end_), "outer") : nullptr;
    at = at != nullptr ? skipWord(at, "loop") : nullptr;
    std::array<Point, 3> corners;
    for (Point& corner : corners) {
      at = at != nullptr ? skipWord(at, "vertex") : nullptr;
      at = at != nullptr ? parsePoint(at, end_, skipBlanks, corner) : nullptr;
    }
    at = at != nullptr ? skipWord(at, "endloop") : nullptr;
    at = at != nullptr ? skipWord(at, "endfacet") : nullptr;
    if (at != nullptr) {
      addFacet(corners);
    }
    return at;
  }

  void addFacet(const std::array<Point, 3>& corners) {
    mesh_.triangles.emplace_back();
    pending_.insert(pending_.end(), corners.begin(), corners.end());
    if (pending_.size() >= 3 * kFacetsPerLook) {
      weldPending();
    }
  }

  // Numbers the corners of the last facets.
  void weldPending() {
    if (!pending_.empty()) {
      const std::size_t first = mesh_.triangles.size() - pending_.size() / 3;
      welder_.add(pending_, {mesh_.triangles[first].data(), pending_.size()});
      pending_.clear();
    }
  }

  // A facet is "facet normal … / outer loop / three vertices / endloop / endfacet". Of the keywords only
  // those that begin and end a facet, and "vertex", carry something. Null: error_ says why.
  const char* parseStatement(const char* at, std::string_view token) {
    if (isKeyword(token, "vertex")) {
      return parseVertex(at, at + token.size());
    }
    if (isKeyword(token, "facet")) {
      if (inFacet_) {
        return failAt(at, "a facet begins before the one above has ended");
      }
      inFacet_ = true;
      corners_ = 0;
      return lineEnd(at, end_);
    }
    if (isKeyword(token, "endfacet")) {
      if (!inFacet_ || corners_ != 3) {
        return failAt(at, inFacet_
                              ? "the facet has " + std::to_string(corners_) + " vertices instead of three"
                              : std::string("'endfacet' without a facet"));
      }
      inFacet_ = false;
      addFacet(facet_);
      return at + token.size();
    }
    if (isKeyword(token, "outer") || isKeyword(token, "loop") || isKeyword(token, "endloop")) {
      return at + token.size();
    }
    if (isKeyword(token, "solid") || isKeyword(token, "endsolid")) {
      return inFacet_ ? failAt(at, "a facet has not ended") : lineEnd(at, end_);  // a name follows
    }
    return failAt(at, "expected a keyword of STL such as 'facet' or 'vertex', found " + shown(token));
  }

  const char* parseVertex(const char* keyword, const char* at) {
    if (!inFacet_ || corners_ == 3) {
      return failAt(keyword,
                    inFacet_ ? "the facet has more than three vertices" : "a vertex outside of a facet");
    }
    const char* const after = parsePoint(at, end_, skipBlanks, facet_[corners_]);
    if (after == nullptr) {
      error_ = malformedPoint(input_, at, end_, skipBlanks, 3 * mesh_.triangles.size() + corners_).value();
    }
    ++corners_;
    return after;
  }

  std::nullptr_t failAt(const char* at, const std::string& message) {
    error_ = malformedLine(input_, at, message).value();
    return nullptr;
  }

  const ReadInput& input_;
  const char* end_;
  PointWelder welder_;
  RawMesh mesh_;
  std::vector<Point> pending_;  // corners of the last facets, not yet welded
  std::array<Point, 3> facet_;  // the current one, if it is read by statements
  std::size_t corners_ = 0;     // of that, so far
  bool inFacet_ = false;
  std::optional<Error> error_;
};

}  // namespace

Result<RawMesh> readStl(const ReadInput& input) {
  return isBinary(input) ? readBinary(input) : AsciiParser(input).parse();
}

}  // namespace graftsman
