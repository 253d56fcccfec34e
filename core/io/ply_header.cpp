#include "core/io/ply_header.h"

#include <array>
#include <optional>
#include <utility>

#include "core/io/text_scanner.h"

namespace graftsman {
namespace {

constexpr std::size_t kMaxProperties = 1000;  // of all elements: each row is walked property by property

std::optional<PlyType> typeNamed(std::string_view name) {
  using enum PlyType;
  static constexpr std::pair<std::string_view, PlyType> kNames[] = {
      {"char", Int8},     {"int8", Int8},       {"uchar", UInt8},    {"uint8", UInt8},
      {"short", Int16},   {"int16", Int16},     {"ushort", UInt16},  {"uint16", UInt16},
      {"int", Int32},     {"int32", Int32},     {"uint", UInt32},    {"uint32", UInt32},
      {"float", Float32}, {"float32", Float32}, {"double", Float64}, {"float64", Float64}};
  for (const auto& [known, type] : kNames) {
    if (known == name) {
      return type;
    }
  }
  return std::nullopt;
}

class HeaderParser {
 public:
  explicit HeaderParser(const ReadInput& input)
      : input_(input), at_(input.bytes.data()), end_(at_ + input.bytes.size()) {}

  Result<PlyHeader> parse() {
    if (nextWord() != "ply") {
      return malformedLine(
          input_, at_,
          "a PLY file begins with 'ply', this one with " + shown(tokenAt(input_.bytes.data(), end_)));
    }
    learnLineEnd();
    bool hasFormat = false;
    while (true) {
      if (!nextLine()) {
        return malformedLine(input_, end_, "the header has no 'end_header'");
      }
      const char* const line = at_;
      const std::string_view keyword = nextWord();
      if (keyword == "end_header") {
        break;
      }
      Result<void> parsed;
      if (keyword == "format") {
        parsed = parseFormat(line);
        hasFormat = true;
      } else if (keyword == "element") {
        parsed = parseElement(line);
      } else if (keyword == "property") {
        parsed = parseProperty(line);
      } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
        parsed = malformedLine(input_, line, "unknown keyword " + shown(keyword) + " in the header");
      }
      if (!parsed) {
        return tl::unexpected<Error>(std::move(parsed.error()));
      }
    }
    if (!hasFormat) {
      return malformedLine(input_, at_, "the header has no 'format'");
    }
    nextLine();
    header_.body = at_;
    return checkCounts();
  }

 private:
  // The next word of the current line; empty at its end.
  std::string_view nextWord() {
    at_ = skipBlanks(at_, end_);
    const std::string_view word = tokenAt(at_, end_);
    at_ += word.size();
    return word;
  }

  // Which line end the file has matters after the last one: a binary body may begin with any byte.
  void learnLineEnd() {
    const char* const last = lineEnd(at_, end_);
    lineFeed_ = last == end_ || *last == '\n' || (last + 1 != end_ && last[1] == '\n');
  }

  // Moves behind the current line's end. False if there is none.
  bool nextLine() {
    while (at_ != end_ && *at_ != (lineFeed_ ? '\n' : '\r')) {
      ++at_;
    }
    if (at_ == end_) {
      return false;
    }
    ++at_;
    return true;
  }

  Result<void> parseFormat(const char* line) {
    const std::string_view name = nextWord();
    if (name == "ascii") {
      header_.encoding = PlyEncoding::Ascii;
    } else if (name == "binary_little_endian") {
      header_.encoding = PlyEncoding::BinaryLittleEndian;
    } else if (name == "binary_big_endian") {
      header_.encoding = PlyEncoding::BinaryBigEndian;
    } else {
      return malformedLine(input_, line, "unknown PLY format " + shown(name));
    }
    return {};
  }

  Result<void> parseElement(const char* line) {
    PlyElement element;
    element.line = line;
    element.name = nextWord();
    const std::string_view count = nextWord();
    std::int64_t value = 0;
    const char* const after = parseInteger(count.data(), count.data() + count.size(), value);
    if (element.name.empty() || after != count.data() + count.size() || value < 0) {
      return malformedLine(input_, line, "expected 'element NAME COUNT', found a count " + shown(count));
    }
    for (const PlyElement& other : header_.elements) {
      if (other.name == element.name) {
        return malformedLine(input_, line, "the element " + shown(element.name) + " is declared twice");
      }
    }
    if (header_.elements.size() >= kMaxProperties) {
      return malformedLine(input_, line, "more than " + std::to_string(kMaxProperties) + " elements");
    }
    element.count = static_cast<std::size_t>(value);
    element.declared = numberShown(count.data(), after);
    header_.elements.push_back(std::move(element));
    return {};
  }

  Result<void> parseProperty(const char* line) {
    if (header_.elements.empty()) {
      return malformedLine(input_, line, "a property comes before the first element");
    }
    if (++properties_ > kMaxProperties) {
      return malformedLine(input_, line, "more than " + std::to_string(kMaxProperties) + " properties");
    }
    PlyProperty property;
    std::string_view typeName = nextWord();
    if (typeName == "list") {
      property.isList = true;
      const std::string_view countName = nextWord();
      const std::optional<PlyType> countType = typeNamed(countName);
      if (!countType || *countType == PlyType::Float32 || *countType == PlyType::Float64) {
        return malformedLine(input_, line, shown(countName) + " is no integer type for a list's length");
      }
      property.countType = *countType;
      typeName = nextWord();
    }
    const std::optional<PlyType> type = typeNamed(typeName);
    if (!type) {
      return malformedLine(input_, line, "unknown type " + shown(typeName) + " of a property");
    }
    property.type = *type;
    property.name = nextWord();
    header_.elements.back().properties.push_back(std::move(property));
    return {};
  }

  // Before anything is allocated: are there bytes enough for what is declared?
  Result<PlyHeader> checkCounts() {
    const bool ascii = header_.encoding == PlyEncoding::Ascii;
    std::size_t left = static_cast<std::size_t>(end_ - header_.body) + (ascii ? 1 : 0);
    for (const PlyElement& element : header_.elements) {
      std::size_t row = 0;  // the fewest bytes of one
      for (const PlyProperty& p : element.properties) {
        row += ascii ? 2 : sizeOf(p.isList ? p.countType : p.type);
      }
      if (row > 0 && element.count > left / row) {
        return malformedLine(input_, element.line,
                             "the header declares " + element.declared + " elements " + shown(element.name) +
                                 ", too many for a file of " + std::to_string(input_.bytes.size()) +
                                 " bytes; is it cut off?");
      }
      if (row > 0 && element.count > kGreatestCount) {
        return malformedLine(
            input_, element.line,
            "more than " + std::to_string(kGreatestCount) + " elements " + shown(element.name));
      }
      left -= element.count * row;
    }
    return std::move(header_);
  }

  const ReadInput& input_;
  const char* at_;
  const char* end_;
  bool lineFeed_ = true;
  std::size_t properties_ = 0;
  PlyHeader header_;
};

}  // namespace

std::size_t sizeOf(PlyType type) {
  static constexpr std::array<std::size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

Result<PlyHeader> parsePlyHeader(const ReadInput& input) {
  return HeaderParser(input).parse();
}

}  // namespace graftsman
