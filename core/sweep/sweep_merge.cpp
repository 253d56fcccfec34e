#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <utility>

#include "core/base/write_file.h"
#include "core/io/printable.h"
#include "core/io/read_file.h"
#include "core/sweep/sweep_table.h"

namespace graftsman {
namespace {

std::string shownPath(const std::filesystem::path& path) {
  return printable(path.string(), 400);
}

std::optional<std::size_t> numberIn(std::string_view text) {
  std::size_t number = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  return failure == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

// The share whose table has this name, if it is one's.
std::optional<SweepShare> shareNamed(const std::string& name) {
  const std::size_t of = name.find("-of-");
  if (!name.starts_with("table-") || !name.ends_with(".csv") || of == std::string::npos) {
    return std::nullopt;
  }
  const auto number = numberIn(std::string_view(name).substr(6, of - 6));
  const auto all = numberIn(std::string_view(name).substr(of + 4, name.size() - of - 8));
  if (!number || !all || *all < 2 || *all > SweepShare::kMost || *number < 1 || *number > *all ||
      tableName({*number, *all}) != name) {
    return std::nullopt;
  }
  return SweepShare{*number, *all};
}

// The shares in the folder, all of one N, none missing.
Result<std::vector<SweepShare>> sharesIn(const std::filesystem::path& folder) {
  std::vector<SweepShare> shares;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (const auto share = shareNamed(entry->path().filename().string())) {
      shares.push_back(*share);
    }
  }
  if (error) {
    return fail(ErrorCode::FileUnreadable, shownPath(folder) + ": cannot be read: " + error.message());
  }
  if (shares.empty()) {
    return fail(ErrorCode::FileUnreadable, shownPath(folder) +
                                               ": has no table of a share (table-K-of-N.csv). Run the shares "
                                               "with --only K/N into this folder first.");
  }
  std::sort(shares.begin(), shares.end(), [](const SweepShare& a, const SweepShare& b) {
    return a.of != b.of ? a.of < b.of : a.number < b.number;
  });
  if (shares.front().of != shares.back().of) {
    return fail(ErrorCode::FileMalformed,
                shownPath(folder) + ": " + tableName(shares.front()) + " and " + tableName(shares.back()) +
                    " are of different divisions. Remove those that are left over.");
  }
  for (std::size_t i = 0; i < shares.front().of; ++i) {
    if (i >= shares.size() || shares[i].number != i + 1) {
      const std::string missing = std::to_string(i + 1) + "/" + std::to_string(shares.front().of);
      std::string message = shownPath(folder);
      message.append(": share ").append(missing).append(" is missing (");
      message.append(tableName({i + 1, shares.front().of}));
      message.append("). Run it with --only ").append(missing).append(".");
      return fail(ErrorCode::FileUnreadable, std::move(message));
    }
  }
  return shares;
}

// A row of a share's table, with where it is from.
struct Line {
  std::size_t number;
  csv::Row row;
  SweepShare share;
};

Result<void> readTable(const std::filesystem::path& path, const SweepShare& share, std::vector<Line>& lines) {
  const Result<FileBytes> file = readFile(path, {});
  if (!file) {
    return fail(file.error());
  }
  Result<std::vector<csv::Row>> rows =
      csv::parse({file->bytes().data(), file->bytes().size()}, path.string());
  if (!rows) {
    return fail(std::move(rows.error()));
  }
  const std::string otherwise =
      shownPath(path) + ": is no table of a sweep that this version wrote. Run the share again.";
  if (rows->empty() || rows->front() != SweepTable::header()) {
    return fail(ErrorCode::FileMalformed, otherwise);
  }
  for (std::size_t i = 1; i < rows->size(); ++i) {
    csv::Row& row = (*rows)[i];
    const auto number = row.size() == SweepTable::header().size() ? numberIn(row[1]) : std::nullopt;
    if (!number) {
      return fail(ErrorCode::FileMalformed, otherwise);
    }
    lines.push_back({*number, std::move(row), share});
  }
  return {};
}

}  // namespace

Result<MergedTables> mergeTables(const std::filesystem::path& folder) {
  const Result<std::vector<SweepShare>> shares = sharesIn(folder);
  if (!shares) {
    return fail(shares.error());
  }
  std::vector<Line> lines;
  for (const SweepShare& share : *shares) {
    if (Result<void> read = readTable(folder / tableName(share), share, lines); !read) {
      return fail(std::move(read.error()));
    }
  }
  std::stable_sort(lines.begin(), lines.end(),
                   [](const Line& a, const Line& b) { return a.number < b.number; });
  const auto refuse = [&](const Line& a, const Line& b, const std::string& why) {
    return fail(ErrorCode::FileMalformed, shownPath(folder) + ": " + tableName(a.share) + " and " +
                                              tableName(b.share) + " " + why +
                                              ". Run the shares of one sweep again.");
  };
  std::string text;
  csv::append(text, SweepTable::header());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Line& before = lines[i > 0 ? i - 1 : 0];
    if (lines[i].row[0] != before.row[0]) {
      return refuse(before, lines[i], "are of different sweeps");
    }
    if (i > 0 && lines[i].number == before.number) {
      return refuse(before, lines[i], "both have result " + std::to_string(lines[i].number));
    }
    csv::append(text, lines[i].row);
  }
  if (Result<void> written = writeFile(folder / tableName({}), text); !written) {
    return fail(std::move(written.error()));
  }
  return MergedTables{shares->size(), lines.size()};
}

}  // namespace graftsman
