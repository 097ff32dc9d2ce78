// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>

#include "hapticut/core/errors.hpp"
#include "import/mesh/mesh_formats.hpp"
#include "import/mesh/ply_header.hpp"
#include "io/byte_reader.hpp"
#include "io/text_lines.hpp"
#include "io/value_types.hpp"

namespace hapticut {
namespace {

static_assert(std::endian::native == std::endian::little, "the reader reverses the bytes of a big-endian PLY file");

/// Reads the values after the header in order, in any format.
class PlyValues {
 public:
  PlyValues(std::string_view file, const PlyHeader& header)
      : format_(header.format), bytes_(file.substr(header.size)), lines_(bytes_, {}, header.lines + 1) {}

  /// Sets the element that messages name.
  void set_place(const PlyElement* element, std::uint64_t index) {
    element_ = element;
    index_ = index;
  }

  double read(ValueType type) {
    if (format_ == PlyFormat::text) return read_text();
    return with_value_type(type, [&](auto zero) { return double(read_binary<decltype(zero)>()); });
  }

  /// The length of a list, or 1 for a single value.
  std::uint64_t read_length(const PlyProperty& property) {
    if (!property.length) return 1;
    const double length = read(*property.length);
    if (!(length >= 0 && length == std::floor(length) && length <= double(bytes_.size())))
      fail("has a list '" + property.name + "' of " + format_number(length) + " values.");
    return std::uint64_t(length);
  }

  void skip(const PlyProperty& property) {
    for (std::uint64_t left = read_length(property); left > 0; --left) (void)read(property.value);
  }

  /// Maximum number of vertices that can follow: each takes at least three bytes.
  [[nodiscard]] std::size_t max_vertices(std::uint64_t announced) const {
    return std::size_t(std::min<std::uint64_t>(announced, bytes_.size() / 3));
  }

  /// @throws Error when the file continues after its last element, because then values were misread or left out
  void require_end() {
    if (format_ != PlyFormat::text) {
      const std::string_view behind = bytes_.substr(at_);
      if (behind.find_first_not_of(std::string_view("\0 \t\r\n", 5)) == std::string_view::npos) return;
      throw Error(std::to_string(behind.size()) +
                  " bytes follow after the last element of the header; it is damaged, so export the mesh again.");
    }
    const std::string_view more = lines_.word_of_any_line();
    if (!more.empty()) lines_.fail(in_quotes(more) + " follows after the last element of the header.");
  }

  [[noreturn]] void fail(const std::string& reason) const {
    throw Error("element " + std::to_string(index_ + 1) + " of " + std::to_string(element_->count) + " of " +
                in_quotes(element_->name) + " " + reason);
  }

 private:
  double read_text() {
    const std::string_view word = lines_.word_of_any_line();
    if (word.empty()) fail("is missing; the file is truncated.");
    const std::optional<double> value = parse_real(word);
    if (!value) lines_.fail(in_quotes(word) + " is not a number.");
    return *value;
  }

  template <class Number>
  Number read_binary() {
    if (bytes_.size() - at_ < sizeof(Number)) fail("is missing; the file is truncated.");
    const std::string_view next = bytes_.substr(at_, sizeof(Number));
    at_ += sizeof(Number);
    return number_in<Number>(next, format_ == PlyFormat::big_endian);
  }

  PlyFormat format_;
  std::string_view bytes_;
  TextLines lines_;
  std::size_t at_ = 0;  // position in bytes_, for binary values
  const PlyElement* element_ = nullptr;
  std::uint64_t index_ = 0;
};

class PlyParser {
 public:
  explicit PlyParser(std::string_view file)
      : header_(parse_ply_header(file)), header_text_(file.substr(0, header_.size)), values_(file, header_) {
    for (const PlyElement& element : header_.elements)
      if (element.name == "vertex") vertices_ = element.count;
  }

  Polygons parse() {
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") {
        parse_vertices(element);
      } else if (element.name == "face") {
        parse_lists(element, [this] { parse_face(); });
      } else if (element.name == "tristrips") {
        parse_lists(element, [this] { parse_strip(); });
      } else if (!element.properties.empty()) {
        for_each(element, [&] {
          for (const PlyProperty& property : element.properties) values_.skip(property);
        });
      }
    }
    values_.require_end();
    polygons_.objects.push_back(std::move(faces_));
    turn_to_patient_axes(polygons_, header_text_);
    return std::move(polygons_);
  }

 private:
  template <class Use>
  void for_each(const PlyElement& element, const Use& use) {
    for (std::uint64_t n = 0; n < element.count; ++n) {
      values_.set_place(&element, n);
      use();
    }
  }

  void parse_vertices(const PlyElement& element) {
    std::vector<int> axis_of;  // axis of each property; -1: not a coordinate
    for (const PlyProperty& property : element.properties) {
      const bool is_axis =
          !property.length && property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z';
      axis_of.push_back(is_axis ? property.name[0] - 'x' : -1);
    }
    for (int axis = 0; axis < 3; ++axis)
      if (std::count(axis_of.begin(), axis_of.end(), axis) != 1)
        throw Error("its vertices must have exactly one property x, one y and one z.");
    polygons_.vertices.reserve(values_.max_vertices(element.count));
    for_each(element, [&] {
      Vec3& position = polygons_.vertices.emplace_back();
      for (std::size_t n = 0; n < axis_of.size(); ++n) {
        if (axis_of[n] < 0)
          values_.skip(element.properties[n]);
        else
          position[axis_of[n]] = values_.read(element.properties[n].value);
      }
    });
  }

  /// Calls `use()` with each list of vertices in `list_`.
  template <class Use>
  void parse_lists(const PlyElement& element, const Use& use) {
    const auto is_list = [](const PlyProperty& property) {
      return property.length && (property.name == "vertex_indices" || property.name == "vertex_index");
    };
    if (element.count > 0 && std::count_if(element.properties.begin(), element.properties.end(), is_list) != 1)
      throw Error("its elements " + in_quotes(element.name) + " must have one list named vertex_indices.");
    for_each(element, [&] {
      for (const PlyProperty& property : element.properties) {
        if (!is_list(property)) {
          values_.skip(property);
          continue;
        }
        list_.clear();
        for (std::uint64_t left = values_.read_length(property); left > 0; --left)
          list_.push_back(values_.read(property.value));
      }
      use();
    });
  }

  void add_corner(double index) {
    if (!(index >= 0 && index < double(vertices_) && index == std::floor(index)))
      values_.fail("names vertex " + format_number(index) + "; there are " + std::to_string(vertices_) +
                   ", counted from 0.");
    faces_.corners.push_back(std::uint32_t(index));
  }

  void parse_face() {
    if (list_.size() < 3) values_.fail("has " + std::to_string(list_.size()) + " corners; at least 3 are needed.");
    for (const double index : list_) add_corner(index);
    faces_.ends.push_back(faces_.corners.size());
  }

  /// Three consecutive vertices of a strip are a triangle; every second triangle is reversed. -1 begins a new strip.
  void parse_strip() {
    std::size_t begin = 0;
    for (std::size_t n = 0; n < list_.size(); ++n) {
      if (list_[n] == -1) begin = n + 1;
      if (n < begin + 2) continue;
      const bool reversed = (n - begin) % 2 == 1;
      for (const double index : {list_[n - 2], list_[reversed ? n : n - 1], list_[reversed ? n - 1 : n]})
        add_corner(index);
      faces_.ends.push_back(faces_.corners.size());
    }
  }

  PlyHeader header_;
  std::string_view header_text_;
  PlyValues values_;
  std::uint64_t vertices_ = 0;
  Polygons polygons_;
  PolygonObject faces_;
  std::vector<double> list_;
};

}  // namespace

Polygons parse_ply(std::string_view file) { return PlyParser(file).parse(); }

}  // namespace hapticut
