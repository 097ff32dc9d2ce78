// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <cctype>

#include "import/mesh/mesh_formats.hpp"
#include "import/mesh/stl_layout.hpp"
#include "io/byte_reader.hpp"
#include "io/text_lines.hpp"

namespace hapticut {
namespace {

static_assert(std::endian::native == std::endian::little, "a binary STL file is read as the memory has it");

bool is_word(std::string_view word, std::string_view expected) {
  return std::equal(word.begin(), word.end(), expected.begin(), expected.end(),
                    [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

/// `solid name`, then per triangle `facet normal x y z outer loop`, three times `vertex x y z`, `endloop endfacet`, at
/// last `endsolid`. Upper or lower case, any line breaks; `end solid` is accepted too.
class StlTextParser {
 public:
  explicit StlTextParser(std::string_view text) : lines_(text) {}

  Polygons parse() {
    for (std::string_view word = lines_.word_of_any_line(); !word.empty(); word = lines_.word_of_any_line()) {
      if (!is_word(word, "solid")) fail_at(word, "solid");
      polygons_.objects.push_back({std::string(lines_.rest()), {}, {}});
      while (parse_facet(polygons_.objects.back())) continue;
    }
    return std::move(polygons_);
  }

 private:
  /// @return false at the end of the solid
  bool parse_facet(PolygonObject& object) {
    const std::string_view word = next();
    if (ends(word, "solid")) {
      (void)lines_.rest();  // its name
      return false;
    }
    if (!is_word(word, "facet")) fail_at(word, "facet");
    expect("normal");
    // The normal is ignored: it follows from the vertices. For a triangle without area it may be missing or not a
    // number.
    std::string_view after = next();
    for (int n = 0; n < 3 && !is_word(after, "outer"); ++n) after = next();
    if (!is_word(after, "outer")) fail_at(after, "outer");
    expect("loop");
    for (int corner = 0; corner < 3; ++corner) {
      expect("vertex");
      Vec3 position;
      for (double& coordinate : position) coordinate = lines_.real("a coordinate");
      object.corners.push_back(std::uint32_t(polygons_.vertices.size()));
      polygons_.vertices.push_back(position);
      if (!is_finite(position)) lines_.fail("a coordinate is not a finite number; repair the mesh.");
    }
    object.ends.push_back(object.corners.size());
    for (const std::string_view part : {"loop", "facet"})
      if (const std::string_view end = next(); !ends(end, part)) fail_at(end, "end" + std::string(part));
    return true;
  }

  std::string_view next() {
    const std::string_view word = lines_.word_of_any_line();
    if (word.empty()) throw Error("it ends before 'endsolid'; it is truncated.");
    return word;
  }

  /// Whether the word, or `end` and the next word, ends a part.
  bool ends(std::string_view word, std::string_view part) {
    if (is_word(word, "end")) return is_word(next(), part);
    return word.size() == 3 + part.size() && is_word(word.substr(0, 3), "end") && is_word(word.substr(3), part);
  }

  void expect(std::string_view expected) {
    const std::string_view word = next();
    if (!is_word(word, expected)) fail_at(word, expected);
  }

  [[noreturn]] void fail_at(std::string_view word, std::string_view expected) const {
    lines_.fail(in_quotes(word) + " is in the place of '" + std::string(expected) + "'; the file is damaged.");
  }

  TextLines lines_;
  Polygons polygons_;
};

/// 0 when the file is shorter than the header.
std::uint64_t announced_triangles(std::string_view bytes) {
  return bytes.size() < kStlHeader ? 0 : number_in<std::uint32_t>(bytes.substr(kStlHeader - sizeof(std::uint32_t)));
}

/// Some binary files begin with `solid` too. So the length of the file decides, then bytes that no text has.
bool is_text_stl(std::string_view bytes) {
  if (bytes.size() >= kStlHeader && bytes.size() == kStlHeader + announced_triangles(bytes) * kStlTriangle)
    return false;
  constexpr std::size_t kLookedAt = 1000;
  return bytes.substr(0, kLookedAt).find('\0') == std::string_view::npos &&
         is_word(TextLines(bytes).word_of_any_line(), "solid");
}

Polygons parse_binary(std::string_view bytes) {
  if (bytes.size() < kStlHeader)
    throw Error("it is neither a text that begins with 'solid' nor long enough for a binary STL file.");
  const std::uint64_t triangles = announced_triangles(bytes);
  const std::uint64_t has = (bytes.size() - kStlHeader) / kStlTriangle;
  if (has < triangles)
    throw Error("it announces " + std::to_string(triangles) + " triangles, but has bytes for " + std::to_string(has) +
                "; it is truncated or no STL file, so get a complete copy.");
  const std::string_view behind = bytes.substr(kStlHeader + triangles * kStlTriangle);
  if (has > triangles && behind.find_first_not_of(std::string_view("\0 \t\r\n", 5)) != std::string_view::npos)
    throw Error("it announces " + std::to_string(triangles) + " triangles, but has bytes for " + std::to_string(has) +
                "; it is damaged or no STL file, so export the mesh again.");
  Polygons polygons;
  polygons.vertices.reserve(3 * triangles);
  PolygonObject object;
  object.corners.reserve(3 * triangles);
  object.ends.reserve(triangles);
  for (std::uint64_t n = 0; n < triangles; ++n) {
    // Normal, then three vertices.
    const auto numbers = number_in<std::array<float, 12>>(bytes.substr(kStlHeader + n * kStlTriangle));
    for (std::size_t at = 3; at < numbers.size(); at += 3) {
      const Vec3 position = Eigen::Vector3f(numbers.data() + at).cast<double>();
      if (!is_finite(position))
        throw Error("triangle " + std::to_string(n + 1) +
                    " has a coordinate that is not a finite number; repair the mesh.");
      object.corners.push_back(std::uint32_t(polygons.vertices.size()));
      polygons.vertices.push_back(position);
    }
    object.ends.push_back(object.corners.size());
  }
  polygons.objects.push_back(std::move(object));
  return polygons;
}

}  // namespace

Polygons parse_stl(std::string_view bytes) {
  const bool is_text = is_text_stl(bytes);
  Polygons polygons = is_text ? StlTextParser(bytes).parse() : parse_binary(bytes);
  turn_to_patient_axes(polygons, bytes.substr(0, is_text ? bytes.find_first_of("\r\n") : kStlHeader));
  return polygons;
}

}  // namespace hapticut
