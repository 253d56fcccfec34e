#include "core/io/stl_reader.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cstring>

#include "core/io/text_scanner.h"
#include "core/io/weld.h"

namespace graftsman {
namespace {

constexpr std::size_t kHeaderSize = 80;
constexpr std::size_t kCountEnd = 84;
constexpr std::size_t kFacetSize = 50;        // normal, three corners, attribute
constexpr std::size_t kCornersAt = 12;        // in a facet
constexpr std::size_t kFacetsPerLook = 4096;  // at the progress
constexpr std::size_t kTextFacetSize = 100;   // bytes of an ASCII facet, at least (a guess for reserving)

std::uint32_t littleEndian32(const char* at) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) {
    value = value << 8 | static_cast<unsigned char>(at[i]);
  }
  return value;
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
  for (std::size_t f = 0; f < facets; ++f) {
    if (f % kFacetsPerLook == 0 &&
        !input.progress.keepGoing(static_cast<double>(f) / static_cast<double>(facets))) {
      return readingCancelled();
    }
    const char* at = data + kCountEnd + f * kFacetSize + kCornersAt;
    for (Index& corner : mesh.triangles[f]) {
      Point point;
      for (double& coordinate : point) {
        coordinate = std::bit_cast<float>(littleEndian32(at));
        if (!std::isfinite(coordinate)) {
          return malformedByte(input, at,
                               "a coordinate of facet " + std::to_string(f) + " is not a finite number");
        }
        at += sizeof(float);
      }
      corner = welder.add(point);
    }
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

  // A facet is "facet normal … / outer loop / three vertices / endloop / endfacet". Of the keywords only
  // those that begin and end a facet, and "vertex", carry something.
  Result<RawMesh> parse() {
    const char* at = input_.bytes.data();
    for (std::size_t statement = 0;; ++statement) {
      while (at != end_ && isSpace(*at)) {
        ++at;
      }
      if (statement % kFacetsPerLook == 0 &&
          !input_.progress.keepGoing(static_cast<double>(at - input_.bytes.data()) /
                                     static_cast<double>(input_.bytes.size()))) {
        return readingCancelled();
      }
      if (at == end_) {
        break;
      }
      const std::string_view token = tokenAt(at, end_);
      Result<const char*> after = parseStatement(at, token);
      if (!after) {
        return tl::unexpected<Error>(std::move(after.error()));
      }
      at = *after;
    }
    if (inFacet_) {
      return malformedLine(input_, end_, "the file ends within a facet; is it cut off?");
    }
    mesh_.fileVertices = 3 * mesh_.triangles.size();
    mesh_.points = welder_.takePoints();
    return std::move(mesh_);
  }

 private:
  Result<const char*> parseStatement(const char* at, std::string_view token) {
    if (isKeyword(token, "vertex")) {
      return parseVertex(at, at + token.size());
    }
    if (isKeyword(token, "facet")) {
      if (inFacet_) {
        return malformedLine(input_, at, "a facet begins before the one above has ended");
      }
      inFacet_ = true;
      corners_ = 0;
      return lineEnd(at, end_);
    }
    if (isKeyword(token, "endfacet")) {
      if (!inFacet_ || corners_ != 3) {
        return malformedLine(input_, at,
                             inFacet_
                                 ? "the facet has " + std::to_string(corners_) + " vertices instead of three"
                                 : std::string("'endfacet' without a facet"));
      }
      inFacet_ = false;
      mesh_.triangles.push_back(facet_);
      return at + token.size();
    }
    if (isKeyword(token, "outer") || isKeyword(token, "loop") || isKeyword(token, "endloop")) {
      return at + token.size();
    }
    if (isKeyword(token, "solid") || isKeyword(token, "endsolid")) {
      if (inFacet_) {
        return malformedLine(input_, at, "a facet has not ended");
      }
      return lineEnd(at, end_);  // a name follows
    }
    return malformedLine(input_, at,
                         "expected a keyword of STL such as 'facet' or 'vertex', found " + shown(token));
  }

  Result<const char*> parseVertex(const char* keyword, const char* at) {
    if (!inFacet_ || corners_ == 3) {
      return malformedLine(
          input_, keyword,
          inFacet_ ? "the facet has more than three vertices" : "a vertex outside of a facet");
    }
    Point point;
    const char* const after = parsePoint(at, end_, skipBlanks, point);
    if (after == nullptr) {
      return malformedPoint(input_, at, end_, skipBlanks, 3 * mesh_.triangles.size() + corners_);
    }
    facet_[corners_++] = welder_.add(point);
    return after;
  }

  const ReadInput& input_;
  const char* end_;
  PointWelder welder_;
  RawMesh mesh_;
  Face facet_ = {};
  std::size_t corners_ = 0;  // of the current facet, so far
  bool inFacet_ = false;
};

}  // namespace

Result<RawMesh> readStl(const ReadInput& input) {
  return isBinary(input) ? readBinary(input) : AsciiParser(input).parse();
}

}  // namespace graftsman
