// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "hapticut/core/errors.hpp"
#include "import/mesh/mesh_formats.hpp"
#include "io/text_lines.hpp"

namespace hapticut {
namespace {

/// `OFF`, the numbers of vertices, faces and edges, then one line per vertex and one line per face. Normals, colours
/// and texture coordinates are at the ends of these lines.
class OffParser {
 public:
  explicit OffParser(std::string_view text) : lines_(text, {.comments = true}) {}

  Polygons parse() {
    const std::string_view behind_key = parse_key();
    const std::uint64_t vertices = count(behind_key.empty() ? lines_.word_of_any_line() : behind_key, "vertices");
    const std::uint64_t faces = count(lines_.word_of_any_line(), "faces");
    for (std::uint64_t n = 0; n < vertices; ++n) {
      const std::string_view x = first_word("vertex", n, vertices);
      Vec3& position = polygons_.vertices.emplace_back(Vec3::Zero());
      for (int axis = 0; axis < 3; ++axis) position[axis] = lines_.real("a coordinate", axis == 0 ? x : lines_.word());
    }
    PolygonObject object;
    for (std::uint64_t n = 0; n < faces; ++n) {
      const std::string_view number = first_word("face", n, faces);
      const std::optional<std::int64_t> corners = parse_whole(number);
      if (!corners || *corners < 3) lines_.fail("a face has " + in_quotes(number) + " corners; at least 3 are needed.");
      for (std::int64_t k = 0; k < *corners; ++k) object.corners.push_back(corner());
      object.ends.push_back(object.corners.size());
    }
    while (lines_.next_line())
      if (const std::string_view more = lines_.word(); !more.empty())
        lines_.fail(in_quotes(more) + " follows after the last face that is announced.");
    polygons_.objects.push_back(std::move(object));
    return std::move(polygons_);
  }

 private:
  /// Letters before `OFF` name the extra data of a vertex: texture coordinates, colour, normal.
  /// @return the text that follows without a blank: in files of ModelNet the number of vertices
  std::string_view parse_key() {
    const std::string_view word = lines_.word_of_any_line();
    const std::size_t end = std::min(word.find_first_of("0123456789", 1), word.size());
    const std::string_view key = word.substr(0, end);
    constexpr std::array<std::string_view, 8> kKeys = {"OFF",   "COFF",   "NOFF",   "CNOFF",
                                                       "STOFF", "STCOFF", "STNOFF", "STCNOFF"};
    if (std::find(kKeys.begin(), kKeys.end(), key) == kKeys.end())
      throw Error("it begins with " + in_quotes(word) + ", but a three-dimensional OFF file begins with 'OFF'.");
    return word.substr(end);
  }

  std::uint64_t count(std::string_view word, const std::string& what) const {
    const std::optional<std::int64_t> number = parse_whole(word);
    if (!number || *number < 0)
      lines_.fail(in_quotes(word) + " is not the number of " + what + "; only OFF files in text form are supported.");
    return std::uint64_t(*number);
  }

  /// Goes to the next line that is not empty.
  std::string_view first_word(const char* what, std::uint64_t n, std::uint64_t announced) {
    while (lines_.next_line())
      if (const std::string_view word = lines_.word(); !word.empty()) return word;
    throw Error("it announces " + std::to_string(announced) + (announced == 1 ? " " : " times a ") + what +
                ", but ends after " + std::to_string(n) + "; it is truncated.");
  }

  std::uint32_t corner() {
    const std::string_view word = lines_.word();
    if (word.empty()) lines_.fail("a face has fewer corners than it announces.");
    const std::optional<std::int64_t> index = parse_whole(word);
    if (!index || *index < 0 || std::uint64_t(*index) >= polygons_.vertices.size())
      lines_.fail("a face names vertex " + in_quotes(word) + "; there are 0 to " +
                  std::to_string(std::int64_t(polygons_.vertices.size()) - 1) + ".");
    return std::uint32_t(*index);
  }

  TextLines lines_;
  Polygons polygons_;
};

}  // namespace

Polygons parse_off(std::string_view file) { return OffParser(file).parse(); }

}  // namespace hapticut
