#include "core/io/csv.h"

#include "core/io/printable.h"

namespace graftsman::csv {
namespace {

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  // False: malformed in line().
  bool run() {
    while (at_ < text_.size()) {
      Row row;
      do {
        row.emplace_back();
        if (!cell(row.back())) {
          return false;
        }
      } while (take(','));
      rows_.push_back(std::move(row));
      if (at_ < text_.size() && !take("\r\n") && !take('\n')) {
        return false;  // something after a quoted cell, or a lone carriage return
      }
      ++line_;
    }
    return true;
  }

  [[nodiscard]] std::size_t line() const { return line_; }
  [[nodiscard]] std::vector<Row> takeRows() { return std::move(rows_); }

 private:
  bool take(char c) {
    if (at_ < text_.size() && text_[at_] == c) {
      ++at_;
      return true;
    }
    return false;
  }
  bool take(std::string_view wanted) {
    if (text_.substr(at_).starts_with(wanted)) {
      at_ += wanted.size();
      return true;
    }
    return false;
  }

  bool cell(std::string& value) {
    if (take('"')) {
      return quoted(value);
    }
    const std::size_t end = std::min(text_.find_first_of(",\"\r\n", at_), text_.size());
    value = text_.substr(at_, end - at_);
    at_ = end;
    return at_ == text_.size() || text_[at_] != '"';
  }

  bool quoted(std::string& value) {
    while (at_ < text_.size()) {
      const char c = text_[at_++];
      if (c == '"' && !take('"')) {
        return true;
      }
      line_ += c == '\n' ? 1 : 0;
      value += c;
    }
    return false;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::vector<Row> rows_;
};

}  // namespace

void append(std::string& text, const Row& row) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    text += i > 0 ? "," : "";
    if (row[i].find_first_of(",\"\r\n") == std::string::npos) {
      text += row[i];
      continue;
    }
    text += '"';
    for (const char c : row[i]) {
      text += c == '"' ? "\"\"" : std::string(1, c);
    }
    text += '"';
  }
  text += "\r\n";
}

Result<std::vector<Row>> parse(std::string_view text, std::string_view path) {
  Parser parser(text);
  if (!parser.run()) {
    return fail(ErrorCode::FileMalformed, printable(path, 400) + ": is no table with commas: line " +
                                              std::to_string(parser.line()) +
                                              " has a quote that does not belong there or is never closed.");
  }
  return parser.takeRows();
}

}  // namespace graftsman::csv
