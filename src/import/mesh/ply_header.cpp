// SPDX-License-Identifier: Apache-2.0
#include "import/mesh/ply_header.hpp"

#include "hapticut/core/errors.hpp"
#include "io/text_lines.hpp"

namespace hapticut {
namespace {

[[noreturn]] void fail_in_header(std::size_t line, const std::string& reason) {
  throw Error("line " + std::to_string(line) + " of its header: " + reason);
}

std::optional<ValueType> type_named(std::string_view name) {
  using enum ValueType;
  static constexpr std::pair<std::string_view, ValueType> kTypes[] = {
      {"char", int8},     {"int8", int8},       {"uchar", uint8},    {"uint8", uint8},
      {"short", int16},   {"int16", int16},     {"ushort", uint16},  {"uint16", uint16},
      {"int", int32},     {"int32", int32},     {"uint", uint32},    {"uint32", uint32},
      {"float", float32}, {"float32", float32}, {"double", float64}, {"float64", float64}};
  const ValueType* const type = found_in(kTypes, name);
  return type == nullptr ? std::nullopt : std::optional(*type);
}

/// Parses the lines of a header.
class PlyHeaderParser {
 public:
  /// @return false at the last line
  bool parse_line(std::string_view line) {
    ++header.lines;
    TextLines words(line);
    words.next_line();
    const std::string_view key = words.word();
    if (key == "end_header") {
      if (!has_format_) fail("it ends without a line 'format'.");
      return false;
    }
    if (key == "format") {
      parse_format(words.word());
    } else if (key == "element") {
      parse_element(words);
    } else if (key == "property") {
      parse_property(words);
    } else if (!key.empty() && key != "comment" && key != "obj_info") {
      fail(in_quotes(key) + " is not a keyword of a PLY header.");
    }
    return true;
  }

  PlyHeader header;

 private:
  [[noreturn]] void fail(const std::string& reason) const { fail_in_header(header.lines, reason); }

  void parse_format(std::string_view name) {
    has_format_ = true;
    if (name == "ascii")
      header.format = PlyFormat::text;
    else if (name == "binary_little_endian")
      header.format = PlyFormat::little_endian;
    else if (name == "binary_big_endian")
      header.format = PlyFormat::big_endian;
    else
      fail("the format " + in_quotes(name) +
           " is unknown; the formats are ascii, binary_little_endian and binary_big_endian.");
  }

  void parse_element(TextLines& words) {
    const std::string name(words.word());
    const std::string_view count = words.word();
    const std::optional<std::int64_t> number = parse_whole(count);
    if (!number || *number < 0)
      fail("the number " + in_quotes(count) + " of elements " + in_quotes(name) + " is not a whole number >= 0.");
    for (const PlyElement& other : header.elements)
      if (other.name == name) fail("the element " + in_quotes(name) + " appears twice.");
    header.elements.push_back({name, std::uint64_t(*number), {}});
  }

  void parse_property(TextLines& words) {
    if (header.elements.empty()) fail("a property precedes the first element.");
    PlyProperty property{};
    std::string_view type = words.word();
    if (type == "list") {
      const std::string_view length = words.word();
      property.length = type_named(length);
      if (!property.length) fail(in_quotes(length) + " is not a type of numbers.");
      type = words.word();
    }
    const std::optional<ValueType> value = type_named(type);
    if (!value) fail(in_quotes(type) + " is not a type of numbers.");
    property.value = *value;
    property.name = words.word();
    if (property.name.empty()) fail("a property has no name.");
    header.elements.back().properties.push_back(std::move(property));
  }

  bool has_format_ = false;
};

}  // namespace

PlyHeader parse_ply_header(std::string_view file) {
  const std::size_t begin = file.starts_with("\xef\xbb\xbf") ? 3 : 0;  // after the byte order mark of UTF-8
  // The first line shows how lines end. Looking later is unsafe: the first value of a binary file may begin with a line
  // feed byte.
  const std::size_t first = std::min(file.find_first_not_of(' ', begin + 3), file.size());
  const std::string_view line_end = file.substr(first, 2) == "\r\n" ? "\r\n" : file.substr(first, 1);
  if (!file.substr(begin).starts_with("ply") || (line_end != "\r\n" && line_end != "\n" && line_end != "\r"))
    throw Error("it does not begin like a PLY file.");
  PlyHeaderParser parser;
  parser.header.lines = 1;
  std::size_t at = first + line_end.size();
  for (;;) {
    const std::size_t end = file.find(line_end, at);
    if (end == std::string_view::npos) throw Error("it ends before 'end_header'; it is truncated.");
    const std::string_view line = file.substr(at, end - at);
    at = end + line_end.size();
    if (!parser.parse_line(line)) break;
  }
  parser.header.size = at;
  return std::move(parser.header);
}

}  // namespace hapticut
