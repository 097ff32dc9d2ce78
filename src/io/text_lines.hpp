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
/// Words and numbers of a text file. Numbers are read independently of the locale.
namespace hapticut {

/// A word for a message: short, and without control characters.
[[nodiscard]] std::string in_quotes(std::string_view word);

/// The text without blanks at its ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

[[nodiscard]] inline std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = char(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

/// The whole word as a number; infinity when it is too large; nullopt when it is not a number.
[[nodiscard]] std::optional<double> parse_real(std::string_view word);

/// The whole word as a whole number of 64 bits; nullopt when it is not one.
[[nodiscard]] std::optional<std::int64_t> parse_whole(std::string_view word);

/// The numbers of a text; nullopt when a word is not a number.
/// @param separators  any of these characters separate two numbers
[[nodiscard]] std::optional<std::vector<double>> numbers_in(std::string_view text, std::string_view separators);

/// The lines that begin with # at the start of a text.
[[nodiscard]] std::string_view leading_comments(std::string_view text);

/// The items of a list between commas.
[[nodiscard]] inline std::vector<std::string> items_of(std::string_view list) {
  std::vector<std::string> items;
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t end = std::min(list.find(',', at), list.size());
    items.emplace_back(list.substr(at, end - at));
    at = end + 1;
  }
  return items;
}

/// Appends an item to a list.
inline void append_item(std::string& list, std::string_view item, std::string_view separator = ",") {
  if (!list.empty()) list += separator;
  list += item;
}

/// Words separated by blanks.
template <class Words>
[[nodiscard]] std::string in_one_line(const Words& words) {
  std::string line;
  for (const std::string_view word : words) append_item(line, word, " ");
  return line;
}

/// The value of a key in a table; null when there is none.
template <class Key, class Value, std::size_t kCount, class Wanted>
[[nodiscard]] constexpr const Value* found_in(const std::pair<Key, Value> (&table)[kCount], const Wanted& wanted) {
  for (const auto& [key, value] : table)
    if (key == wanted) return &value;
  return nullptr;
}

/// Appends a number to a text, in the shortest form that reads back as the same number.
template <class Number>
void append_number(std::string& text, Number number) {
  std::array<char, 32> digits;
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
}

/// How a format writes comments and continuation lines.
struct TextRules {
  bool comments = false;       ///< `#` begins a comment
  bool continuations = false;  ///< a backslash at the end of a line joins the next line
};

/// Iterates over the lines of a text (ended by LF, CR LF or CR) and the words of each line.
class TextLines {
 public:
  /// @param first_line  number of the first line of the text within its file
  explicit TextLines(std::string_view text, TextRules rules = {}, std::size_t first_line = 1);

  /// Goes to the next line.
  /// @return false at the end of the text
  bool next_line();

  /// The next word of the line; empty at its end.
  std::string_view word();

  /// The rest of the line including comments, without blanks at its ends. The line is at its end afterwards.
  std::string_view rest();

  /// The next word of this line or of a later one; empty at the end of the text.
  std::string_view word_of_any_line();

  /// The next word of the line, or a given word, as a number.
  /// @param what  name of the number, for the message
  /// @throws Error when there is no word, or it is not a number
  double real(const char* what) { return real(what, word()); }
  [[nodiscard]] double real(const char* what, std::string_view text) const;

  /// Number of the line, counted from 1.
  [[nodiscard]] std::size_t number() const { return number_; }

  /// @throws Error "line 12: reason"
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  void read_line();

  std::string_view text_, line_;
  TextRules rules_;
  std::size_t number_;
  std::size_t at_ = 0;  // place in text_
};

}  // namespace hapticut
