// SPDX-License-Identifier: Apache-2.0
#include "io/text_lines.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

constexpr std::string_view kBlanks = " \t\v\f";

void skip_blanks(std::string_view& line) { line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size())); }

}  // namespace

std::string in_quotes(std::string_view word) {
  constexpr std::size_t kMaxShown = 40;
  std::string text = "'";
  for (const char c : word.substr(0, kMaxShown)) text += c >= ' ' && c < 127 ? c : '?';
  return text + (word.size() > kMaxShown ? "...'" : "'");
}

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r"), text.size()));
  return text.substr(0, text.find_last_not_of(" \t\r") + 1);
}

std::optional<double> parse_real(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::invalid_argument || end != word.data() + word.size()) return std::nullopt;
  if (error == std::errc{}) return value;
  // Out of range: too small for a number is nothing, too large is infinite.
  const bool small = word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos ||
                     word.find_first_not_of("-0.") == std::string_view::npos || word.starts_with("0.") ||
                     word.starts_with("-0.") || word.starts_with('.') || word.starts_with("-.");
  return small ? 0 : std::numeric_limits<double>::infinity();
}

std::optional<std::int64_t> parse_whole(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return value;
}

std::optional<std::vector<double>> numbers_in(std::string_view text, std::string_view separators) {
  std::vector<double> numbers;
  for (std::size_t at = text.find_first_not_of(separators); at != std::string_view::npos;
       at = text.find_first_not_of(separators, at)) {
    const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
    const std::optional<double> number = parse_real(text.substr(at, end - at));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    at = end;
  }
  return numbers;
}

std::string_view leading_comments(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::size_t end = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t line_end = std::min(text.find_first_of("\r\n", at), text.size());
    const std::string_view line = trimmed(text.substr(at, line_end - at));
    if (!line.empty() && line.front() != '#') break;
    at = end = std::min(line_end + 1, text.size());
  }
  return text.substr(0, end);
}

TextLines::TextLines(std::string_view text, TextRules rules, std::size_t first_line)
    : text_(text), rules_(rules), number_(first_line - 1) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
}

bool TextLines::next_line() {
  if (at_ >= text_.size()) return false;
  read_line();
  return true;
}

void TextLines::read_line() {
  const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
  line_ = text_.substr(at_, end - at_);
  at_ = end + (text_.substr(end, 2) == "\r\n" ? 2 : 1);
  ++number_;
}

std::string_view TextLines::word() {
  for (;;) {
    skip_blanks(line_);
    if (rules_.comments && line_.starts_with('#')) line_ = {};
    if (line_.empty()) return {};
    const std::size_t end = std::min(line_.find_first_of(kBlanks), line_.size());
    std::string_view word = line_.substr(0, end);
    line_.remove_prefix(end);
    if (rules_.continuations && word.ends_with('\\') && line_.find_first_not_of(kBlanks) == std::string_view::npos) {
      word.remove_suffix(1);
      line_ = {};
      if (at_ < text_.size()) read_line();
    }
    if (!word.empty()) return word;
  }
}

std::string_view TextLines::rest() {
  skip_blanks(line_);
  std::string_view all = line_;
  line_ = {};
  return all.substr(0, all.find_last_not_of(kBlanks) + 1);
}

std::string_view TextLines::word_of_any_line() {
  for (;;) {
    const std::string_view next = word();
    if (!next.empty() || !next_line()) return next;
  }
}

double TextLines::real(const char* what, std::string_view text) const {
  if (text.empty()) fail(std::string(what) + " is missing.");
  const std::optional<double> value = parse_real(text);
  if (!value) fail(in_quotes(text) + ", where " + what + " should stand, is not a number.");
  return *value;
}

void TextLines::fail(const std::string& reason) const {
  throw Error("line " + std::to_string(number_) + ": " + reason);
}

}  // namespace hapticut
