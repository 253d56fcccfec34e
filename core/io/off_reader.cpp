#include "core/io/off_reader.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "core/io/text_scanner.h"

namespace graftsman {
namespace {

constexpr std::size_t kLongestKeyword = 9;     // STCN4nOFF
constexpr std::size_t kOffRowsPerLook = 4096;  // at the progress

class OffParser {
 public:
  explicit OffParser(const ReadInput& input)
      : input_(input), at_(input.bytes.data()), end_(at_ + input.bytes.size()) {}

  Result<RawMesh> parse() {
    bool done = parseKeyword() && parseCounts();
    for (std::size_t row = 0; done && row < vertices_ + faces_; ++row) {
      const double rows = static_cast<double>(vertices_ + faces_);
      if (row % kOffRowsPerLook == 0 && !input_.progress.keepGoing(static_cast<double>(row) / rows)) {
        return readingCancelled();
      }
      done = row < vertices_ ? parseVertex(row) : parseFace(row - vertices_);
    }
    if (!done) {
      return fail(std::move(*error_));
    }
    return std::move(mesh_);
  }

 private:
  // All functions below return false where error_ says why.
  bool parseKeyword() {
    at_ = skipSpaceAndComments(at_, end_);
    std::string_view token = tokenAt(at_, end_);
    token = token.substr(0, token.find('#'));
    if (!token.empty() && std::all_of(token.begin(), token.end(), [](char c) { return digitOf(c) < 10; })) {
      return true;  // no keyword: the counts come first
    }
    std::string prefix(token.substr(0, kLongestKeyword));
    const bool isN = prefix.ends_with("nOFF");  // n coordinates; N is for normals
    for (char& c : prefix) {
      c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    if (!prefix.ends_with("OFF")) {
      return failHere("expected the keyword OFF, found " + shown(token));
    }
    prefix.resize(prefix.size() - 3);
    if (isN || prefix.find('4') != std::string::npos) {
      return failHere("files of the kind " + shown(token) +
                      " are not read: their vertices do not have three coordinates");
    }
    for (const std::string_view part : {"ST", "C", "N"}) {
      const std::size_t found = prefix.find(part);
      if (found != std::string::npos) {
        prefix.erase(found, part.size());
      }
    }
    if (!prefix.empty()) {
      return failHere("expected the keyword OFF, found " + shown(token));
    }
    at_ = skipBlanks(at_ + token.size(), end_);
    if (tokenAt(at_, end_) == "BINARY") {
      return failHere("binary OFF files are not read; save the mesh as text");
    }
    return true;
  }

  bool parseCounts() {
    std::array<std::string, 2> declared;
    for (std::size_t* const count : {&vertices_, &faces_}) {
      at_ = skipSpaceAndComments(at_, end_);
      std::int64_t value = 0;
      const char* const after = parseInteger(at_, end_, value);
      if (after == nullptr || !endsToken(after, end_) || value < 0) {
        return expected(count == &vertices_ ? "the number of vertices" : "the number of faces");
      }
      *count = static_cast<std::size_t>(value);
      declared[count == &vertices_ ? 0 : 1] = numberShown(at_, after);
      at_ = after;
    }
    // The number of edges is of no use, and some programs leave it out: it stands on the same line, or alone
    // on the next one.
    at_ = skipBlanks(at_, end_);
    if (at_ == end_ || isLineEnd(*at_) || *at_ == '#') {
      const char* const next = skipSpaceAndComments(at_, end_);
      const char* const after = skipBlanks(next + tokenAt(next, end_).size(), end_);
      if (after == end_ || isLineEnd(*after) || *after == '#') {
        at_ = after;
      }
    }
    at_ = lineEnd(at_, end_);
    // A vertex takes six bytes with its separators, a face two; the last one has no separator.
    const std::size_t left = static_cast<std::size_t>(end_ - at_) + 1;
    if (vertices_ > left / 6 || faces_ > (left - 6 * vertices_) / 2) {
      return failHere("the header declares " + declared[0] + " vertices and " + declared[1] +
                      " faces, too many for a file of " + std::to_string(input_.bytes.size()) +
                      " bytes; is it cut off?");
    }
    if (std::max(vertices_, faces_) > kGreatestCount) {
      return failHere("more than " + std::to_string(kGreatestCount) + " vertices or faces");
    }
    mesh_.points.reserve(vertices_);
    mesh_.triangles.reserve(faces_);
    return true;
  }

  bool parseVertex(std::size_t vertex) {
    at_ = skipSpaceAndComments(at_, end_);
    Point point;
    const char* const after = parsePoint(at_, end_, skipSpaceAndComments, point);
    if (after == nullptr) {
      error_ = malformedPoint(input_, at_, end_, skipSpaceAndComments, vertex).value();
      return false;
    }
    mesh_.points.push_back(point);
    at_ = lineEnd(after, end_);
    return true;
  }

  bool parseFace(std::size_t number) {
    at_ = skipSpaceAndComments(at_, end_);
    std::int64_t count = 0;
    const char* after = parseInteger(at_, end_, count);
    if (after == nullptr || !endsToken(after, end_)) {
      return expected("the number of corners of face " + std::to_string(number));
    }
    if (count < 0 || count > (end_ - after) / 2 + 1) {
      return failHere("face " + std::to_string(number) + " declares " + numberShown(at_, after) +
                      " corners, which the rest of the file has no room for");
    }
    at_ = after;
    Face face = {};
    if (count != 3) {
      mesh_.beginPolygon();
    }
    for (std::int64_t k = 0; k < count; ++k) {
      at_ = skipSpaceAndComments(at_, end_);
      std::int64_t vertex = 0;
      after = parseInteger(at_, end_, vertex);
      if (after == nullptr || !endsToken(after, end_)) {
        return expected("a vertex number of face " + std::to_string(number));
      }
      if (vertex < 0 || vertex >= static_cast<std::int64_t>(vertices_)) {
        return failHere("face " + std::to_string(number) + " refers to vertex " + numberShown(at_, after) +
                        ", but the file has " + std::to_string(vertices_) + " vertices, counted from 0");
      }
      at_ = after;
      if (count == 3) {
        face[static_cast<std::size_t>(k)] = static_cast<Index>(vertex);
      } else {
        mesh_.polygonCorners.push_back(static_cast<Index>(vertex));
      }
    }
    if (count == 3) {
      mesh_.triangles.push_back(face);
    }
    at_ = lineEnd(at_, end_);
    return true;
  }

  bool expected(const std::string& what) {
    const std::string_view token = tokenAt(at_, end_);
    return failHere("expected " + what + ", found " + (token.empty() ? "the end of the file" : shown(token)));
  }

  bool failHere(const std::string& message) {
    error_ = malformedLine(input_, at_, message).value();
    return false;
  }

  const ReadInput& input_;
  const char* at_;
  const char* end_;
  std::size_t vertices_ = 0;
  std::size_t faces_ = 0;
  RawMesh mesh_;
  std::optional<Error> error_;
};

}  // namespace

Result<RawMesh> readOff(const ReadInput& input) {
  return OffParser(input).parse();
}

}  // namespace graftsman
