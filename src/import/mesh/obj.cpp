// SPDX-License-Identifier: Apache-2.0
#include <map>

#include "hapticut/core/errors.hpp"
#include "import/mesh/mesh_formats.hpp"
#include "io/text_lines.hpp"

namespace hapticut {
namespace {

constexpr std::array<std::string_view, 6> kNumbersThatAreSkipped = {"vt", "vn", "vp", "l", "p", "s"};
constexpr std::array<std::string_view, 11> kTextThatIsSkipped = {
    "usemtl", "mtllib", "usemap", "maplib", "mg", "lod", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj"};
constexpr std::array<std::string_view, 16> kFreeForm = {"cstype", "deg",  "bmat",  "step", "curv", "curv2",
                                                        "surf",   "parm", "trim",  "hole", "scrv", "sp",
                                                        "end",    "con",  "ctech", "stech"};
constexpr std::int64_t kMaxVertices = 0xffffffff;

template <std::size_t kCount>
bool is_one_of(const std::array<std::string_view, kCount>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

class ObjParser {
 public:
  explicit ObjParser(std::string_view text) : lines_(text, {.comments = true, .continuations = true}) {}

  Polygons parse() {
    while (lines_.next_line()) parse_line();
    if (max_ > std::int64_t(polygons_.vertices.size()))
      throw Error("line " + std::to_string(line_of_max_) + ": a face names vertex " + std::to_string(max_) +
                  ", but the file has only " + std::to_string(polygons_.vertices.size()) + ".");
    return std::move(polygons_);
  }

 private:
  void parse_line() {
    const std::string_view key = lines_.word();
    if (key.empty()) return;
    if (key == "v") {
      parse_vertex();
    } else if (key == "f" || key == "fo") {  // `fo` is an old form of `f`
      parse_face();
    } else if (key == "o" || key == "g") {
      start_object(std::string(lines_.rest()));
    } else if (is_one_of(kNumbersThatAreSkipped, key)) {
      while (!lines_.word().empty()) continue;  // follows continuation lines
    } else if (is_one_of(kFreeForm, key)) {
      lines_.fail(in_quotes(key) + " belongs to a free-form curve or surface; save the shape as polygons.");
    } else if (!is_one_of(kTextThatIsSkipped, key)) {
      lines_.fail(in_quotes(key) + " is not a keyword of an OBJ file; the file is damaged or of another format.");
    }
  }

  /// Three coordinates, then optionally a weight that divides them, or a colour of three or four values.
  void parse_vertex() {
    Vec3 position;
    for (double& coordinate : position) coordinate = lines_.real("a coordinate");
    std::array<std::string_view, 4> more;
    std::size_t count = 0;
    for (std::string_view word = lines_.word(); !word.empty(); word = lines_.word()) {
      if (count == more.size()) lines_.fail("a vertex has more than three coordinates and a colour.");
      more[count++] = word;
    }
    if (count == 2)
      lines_.fail("a vertex has 5 numbers; allowed are coordinates with or without a weight or a colour.");
    if (count == 1) {
      const std::optional<double> weight = parse_real(more[0]);
      if (!weight || !(*weight > 0)) lines_.fail("the weight " + in_quotes(more[0]) + " of a vertex is not positive.");
      position /= *weight;
    }
    polygons_.vertices.push_back(position);
  }

  void parse_face() {
    PolygonObject& object = current_object();
    std::size_t corners = 0;
    for (std::string_view word = lines_.word(); !word.empty(); word = lines_.word(), ++corners)
      object.corners.push_back(parse_corner(word));
    if (corners < 3) lines_.fail("a face has " + std::to_string(corners) + " corners; at least 3 are needed.");
    object.ends.push_back(object.corners.size());
  }

  /// A corner `v`, `v/vt`, `v//vn` or `v/vt/vn`. Indices start at 1; negative ones count back from the last vertex so
  /// far, which is -1.
  std::uint32_t parse_corner(std::string_view word) {
    const std::string_view whole = word;
    std::int64_t index = 0;
    for (int part = 0; part < 3; ++part) {
      const std::size_t slash = std::min(word.find('/'), word.size());
      const std::optional<std::int64_t> number = parse_whole(word.substr(0, slash));
      if (!number && (part == 0 || slash > 0)) lines_.fail(in_quotes(whole) + " is not a corner of a face.");
      if (part == 0) index = *number;
      const bool last = slash == word.size();
      word.remove_prefix(last ? slash : slash + 1);
      if (last) break;
      if (part == 2) lines_.fail(in_quotes(whole) + " is not a corner of a face.");
    }
    const auto count = std::int64_t(polygons_.vertices.size());
    if (index == 0) lines_.fail("a face names vertex 0; vertices are counted from 1.");
    if (index < -count || index > kMaxVertices)
      lines_.fail("a face names vertex " + std::to_string(index) + ", but there are " + std::to_string(count) +
                  " before it.");
    if (index < 0) return std::uint32_t(count + index);
    if (index > max_) {
      max_ = index;
      line_of_max_ = lines_.number();
    }
    return std::uint32_t(index - 1);
  }

  void start_object(std::string name) {
    const auto [entry, is_new] = object_by_name_.try_emplace(name, polygons_.objects.size());
    if (is_new) polygons_.objects.push_back({std::move(name), {}, {}});
    object_ = entry->second;
  }

  PolygonObject& current_object() {
    if (polygons_.objects.empty()) start_object("");
    return polygons_.objects[object_];
  }

  TextLines lines_;
  Polygons polygons_;
  std::map<std::string, std::size_t> object_by_name_;
  std::size_t object_ = 0;
  std::int64_t max_ = 0;  // vertices may follow the faces that use them
  std::size_t line_of_max_ = 0;
};

}  // namespace

Polygons parse_obj(std::string_view file) {
  Polygons polygons = ObjParser(file).parse();
  turn_to_patient_axes(polygons, leading_comments(file));
  return polygons;
}

}  // namespace hapticut
