// SPDX-License-Identifier: Apache-2.0
#include "settings/csv_file.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string_view>

#include "io/file_errors.hpp"
#include "io/text_lines.hpp"
#include "settings/setting.hpp"

namespace hapticut::settings {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kBlanks = " \t";

std::string trimmed(std::string_view text) {
  const std::size_t first = std::min(text.find_first_not_of(kBlanks), text.size());
  return std::string(text.substr(first, text.find_last_not_of(kBlanks) + 1 - first));
}

bool same_name(const std::string& a, const std::string& b) { return lower_case(a) == lower_case(b); }

auto find_name(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find_if(names, [&](const std::string& other) { return same_name(name, other); });
}

/// Whether a name is empty or has digits and no letters, as in a table without names: "-1,5".
bool is_like_a_number(const std::string& name) {
  return name.find_first_not_of("0123456789+-.,eE ") == std::string::npos &&
         !std::isalpha(name.empty() ? '0' : name[0]);
}

/// Whether two names differ in what follows the last underscore, the unit: t_ms and t_s.
bool differ_in_unit(const std::string& a, const std::string& b) {
  const std::size_t unit = a.rfind('_');
  return unit != std::string::npos && b.rfind('_') == unit && same_name(a.substr(0, unit), b.substr(0, unit));
}

/// The most frequent separator of the first line; a blank when there is none of them.
char separator_of(std::string_view line) {
  std::size_t max_count = 0;
  char separator = ' ';
  for (const char candidate : {';', '\t', ','}) {
    std::size_t count = 0;
    bool quoted = false;
    for (const char c : line) {
      quoted ^= c == '"';
      count += std::size_t(!quoted && c == candidate);
    }
    if (count > max_count) max_count = count, separator = candidate;
  }
  return separator;
}

/// Whether a number may be 1234 with a mark for thousands: 1,234 or 1.234.
bool may_mark_thousands(std::string_view number, std::size_t mark) {
  const std::size_t sign = number[0] == '-' || number[0] == '+' ? 1 : 0;
  return mark > sign && mark <= sign + 3 && number[sign] != '0' && number.size() == mark + 4 &&
         std::all_of(number.begin() + std::ptrdiff_t(mark) + 1, number.end(),
                     [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

CsvFile::CsvFile(const std::filesystem::path& path, const std::string& what, const Sentence& setting)
    : name_(path.string()) {
  std::error_code error;
  auto file = std::make_unique<std::ifstream>();
  // Check the type before opening: opening a pipe blocks, and a device has no end.
  if (std::filesystem::is_regular_file(path, error)) file->open(path, std::ios::binary);
  if (!file->is_open())
    throw FileError(std::filesystem::absolute(path).string() + ": this " + what +
                    " does not exist or cannot be read. Check the name given to " + setting + ".");
  constexpr std::size_t kHead = 200;  // [bytes]
  if (const std::string other = not_the_file(first_bytes(path, kHead)); !other.empty())
    throw FileError(std::filesystem::absolute(path).string() + ": " + other);
  stream_ = std::move(file);
}

CsvFile::CsvFile(std::string text, std::string name)
    : name_(std::move(name)), stream_(std::make_unique<std::istringstream>(std::move(text))) {}

const std::vector<std::string>& CsvFile::read_names(const std::string& must) {
  if (!next(names_)) fail("the file is empty; its first line must " + must + ".");
  if (std::ranges::all_of(names_, is_like_a_number)) fail("the first line has numbers; it must " + must + ".");
  for (auto name = names_.begin(); name != names_.end(); ++name)
    if (!name->empty() &&
        std::find_if(names_.begin(), name, [&](const auto& n) { return same_name(n, *name); }) != name)
      fail("the column " + *name + " is named twice; leave one of them out.");
  return names_;
}

std::optional<std::size_t> CsvFile::column(const std::string& name) const {
  const auto place = find_name(names_, name);
  return place == names_.end() ? std::nullopt : std::optional(std::size_t(place - names_.begin()));
}

void CsvFile::require_known(const std::vector<std::string>& known, const std::vector<std::string>& skipped) const {
  for (const std::string& name : names_) {
    if (name.empty() || find_name(known, name) != known.end() || find_name(skipped, name) != skipped.end()) continue;
    const auto other_unit = std::ranges::find_if(known, [&](const auto& one) { return differ_in_unit(name, one); });
    fail("there is no column " + name + "; must be one of " + joined(known) + "." +
         (other_unit == known.end() ? suggestion(name, known)
                                    : " If it is " + *other_unit + " in another unit, convert its numbers.") +
         (skipped.empty() ? "" : " Leave it out, or name it comment if it says nothing about the poses."));
  }
}

double CsvFile::number_at(const std::vector<std::string>& cells, std::size_t column) {
  const std::optional<double> value = number(cells[column]);
  if (!value || !std::isfinite(*value)) fail(names_[column] + " = \"" + cells[column] + "\"; must be a number.");
  return *value;
}

bool CsvFile::next_line(std::string& line) {
  line.clear();
  ++line_;
  std::streambuf& bytes = *stream_->rdbuf();
  constexpr int kEnd = std::streambuf::traits_type::eof();
  for (int c = bytes.sbumpc(); c != kEnd; c = bytes.sbumpc()) {
    if (c == '\r' && bytes.sgetc() == '\n') continue;
    if (c == '\n' || c == '\r') return true;
    line += char(c);
  }
  if (line.empty()) --line_;
  return !line.empty();
}

std::vector<std::string> CsvFile::cells_of(const std::string& line) const {
  std::vector<std::string> cells;
  const std::string text = separator_ == ' ' ? trimmed(line) : line;
  for (std::size_t at = 0;;) {
    std::string cell;
    bool quoted = false;
    for (; at < text.size() && (quoted || text[at] != separator_); ++at) {
      if (text[at] != '"' || (!quoted && !trimmed(cell).empty()))
        cell += text[at];
      else if (quoted && text.substr(at, 2) == "\"\"")
        cell += text[at++];
      else
        quoted = !quoted;
    }
    if (quoted) fail("a quotation mark is not closed.");
    cells.push_back(trimmed(cell));
    if (at >= text.size()) return cells;
    for (++at; separator_ == ' ' && text[at] == ' '; ++at) continue;
  }
}

bool CsvFile::next(std::vector<std::string>& cells) {
  for (std::string line; next_line(line);) {
    if (line_ == 1 && line.starts_with(kByteOrderMark)) line.erase(0, kByteOrderMark.size());
    if (line_ == 1 && (line.starts_with("\xFF\xFE") || line.starts_with("\xFE\xFF")))
      fail("the text is in UTF-16; save it in UTF-8.");
    const std::string text = trimmed(line);
    if (text.empty() || text.front() == '#') continue;
    if (separator_ == 0 && line.size() == 5 && line.starts_with("sep=")) {
      separator_ = line.back();
      continue;
    }
    if (separator_ == 0) separator_ = separator_of(line);
    cells = cells_of(line);
    if (std::all_of(cells.begin(), cells.end(), [](const std::string& cell) { return cell.empty(); })) continue;
    if (columns_ == 0) columns_ = cells.size();
    if (cells.size() == columns_) return true;
    fail(std::to_string(cells.size()) + " values; there must be " + std::to_string(columns_) +
         ", as in the first line." +
         (separator_ == ',' && cells.size() > columns_
              ? " Where numbers have a decimal comma, separate the columns by semicolons."
              : ""));
  }
  require_decimals();
  return false;
}

std::optional<double> CsvFile::number(std::string cell) {
  const std::size_t mark = cell.find_first_of(",.");
  if (mark == std::string::npos) return parse_number(cell);
  const bool is_comma = cell[mark] == ',';
  if (cell.find(is_comma ? '.' : ',') != std::string::npos) return std::nullopt;
  (is_comma ? has_commas_ : has_points_) = true;
  if (has_commas_ && has_points_)
    fail("some numbers have a decimal point, others a comma; use the same in all numbers.");
  // With semicolons between columns, a comma is usually decimal and a point marks thousands.
  if (!may_mark_thousands(cell, mark) || (!is_comma && separator_ != ';'))
    has_decimals_ = true;
  else if (doubtful_.empty())
    doubtful_ = cell, doubtful_line_ = line_;
  cell[mark] = '.';
  return parse_number(cell);
}

void CsvFile::require_decimals() {
  if (doubtful_.empty() || has_decimals_) return;
  line_ = doubtful_line_;
  const std::size_t mark = doubtful_.find_first_of(",.");
  fail("\"" + doubtful_ + "\" may have a decimal " + (doubtful_[mark] == ',' ? "comma" : "point") +
       " or a mark for thousands; write " + doubtful_ + "0, or " + doubtful_.substr(0, mark) +
       doubtful_.substr(mark + 1) + ".");
}

void CsvFile::fail(const std::string& message) const {
  throw FileError(name_ + ":" + std::to_string(line_) + ": " + message);
}

}  // namespace hapticut::settings
