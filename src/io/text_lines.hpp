// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// @file
/// The words and numbers of a text file. Numbers are read the same whatever the language of the machine.
namespace hapticut {

/// A word as a message can show it: short, and without characters that do not print.
[[nodiscard]] std::string in_quotes(std::string_view word);

/// Without blanks at its ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

[[nodiscard]] inline std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = char(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

/// The whole word as a number; infinity where it is too large for one.
[[nodiscard]] std::optional<double> parse_real(std::string_view word);

/// The whole word as a whole number of 64 bits.
[[nodiscard]] std::optional<std::int64_t> parse_whole(std::string_view word);

/// The numbers of a text; nothing where one of its words is none.
/// @param separators  any of these characters stand between two numbers
[[nodiscard]] std::optional<std::vector<double>> numbers_in(std::string_view text, std::string_view separators);

/// The parts of a list, between commas.
[[nodiscard]] inline std::vector<std::string> parts_of(std::string_view list) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t end = std::min(list.find(',', at), list.size());
    parts.emplace_back(list.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

/// Puts a part behind those that a list has.
inline void append_part(std::string& list, std::string_view part, std::string_view separator = ",") {
  if (!list.empty()) list += separator;
  list += part;
}

/// Words with a blank between each two.
template <class Words>
[[nodiscard]] std::string in_one_line(const Words& words) {
  std::string line;
  for (const std::string_view word : words) append_part(line, word, " ");
  return line;
}

/// What a table has for a key, or null.
template <class Key, class Value, std::size_t kCount, class Wanted>
[[nodiscard]] constexpr const Value* found_in(const std::pair<Key, Value> (&table)[kCount], const Wanted& wanted) {
  for (const auto& [key, value] : table)
    if (key == wanted) return &value;
  return nullptr;
}

/// Puts a number behind a text: the shortest one that reads back as the same number.
template <class Number>
void append_number(std::string& text, Number number) {
  std::array<char, 32> digits;
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
}

/// How a format writes what is not part of a line, and what belongs to it though it stands in the next.
struct TextRules {
  bool comments = false;       ///< `#` and what follows it in the line is a comment
  bool continuations = false;  ///< a backslash at the end of a line joins the next one to it
};

/// Goes through the lines of a text, which end with LF, CR LF or CR, and through the words of each.
class TextLines {
 public:
  /// @param first_line  number of the text's first line, where something else stands before it in the file
  explicit TextLines(std::string_view text, TextRules rules = {}, std::size_t first_line = 1);

  /// Goes on to the next line.  @return false at the end of the text
  bool next_line();

  /// The next word of the line; empty at its end.
  std::string_view word();

  /// What is left of the line, without blanks at its ends, comments and all; the line is at its end afterwards.
  std::string_view rest();

  /// The next word of this line or of a later one; empty at the end of the text.
  std::string_view word_of_any_line();

  /// The next word of the line as a number, or one that was taken.
  /// @param what  it is, for the message
  /// @throws Error when there is no word, or it is not a number
  double real(const char* what) { return real(what, word()); }
  [[nodiscard]] double real(const char* what, std::string_view text) const;

  /// Of the line, counted from 1.
  [[nodiscard]] std::size_t number() const { return number_; }

  /// @throws Error "line 12: reason"
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  void take_line();

  std::string_view text_, line_;
  TextRules rules_;
  std::size_t number_;
  std::size_t at_ = 0;  // in text_
};

}  // namespace hapticut
