// SPDX-License-Identifier: Apache-2.0
#include "hapticut/tool/catalogue.hpp"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

using units::kPi;

constexpr EdgeKind kSmooth = EdgeKind::smooth;

using detail::in_mm;

/// Checks that each dimension of a head is positive.
void require_dimensions(const std::string& head, std::initializer_list<std::pair<const char*, double>> dimensions) {
  for (const auto& [name, value] : dimensions) {
    std::string words = " ";  // in steps, because GCC 12 warns wrongly about operator+
    words.append(name).append(" [m]");
    require_positive(value, {Name(head), words});
  }
}

void require_less(double value, const std::string& name, double limit, const std::string& limit_name) {
  if (!(value < limit))
    throw Error(name + " = " + in_mm(value) + "; must be less than the " + limit_name + ", " + in_mm(limit) + ".");
}

void require_at_least(double value, const std::string& name, double limit, const std::string& limit_name) {
  if (!(value >= limit))
    throw Error(name + " = " + in_mm(value) + "; must be at least the " + limit_name + ", " + in_mm(limit) + ".");
}

ProfileHead closed(std::vector<ProfileEdge> edges) {
  edges.push_back({0, edges.back().z, 0, kSmooth});
  return ProfileHead({0, std::move(edges)});
}

}  // namespace

ToolHead round_head(double diameter) {
  require_dimensions("round_head", {{"diameter", diameter}});
  return SphereHead{diameter / 2};
}

ToolHead inverted_cone_head(double tip_diameter, double neck_diameter, double length) {
  require_dimensions("inverted_cone_head",
                     {{"tip_diameter", tip_diameter}, {"neck_diameter", neck_diameter}, {"length", length}});
  require_less(neck_diameter, "inverted_cone_head neck_diameter", tip_diameter, "tip_diameter");
  return closed({{tip_diameter / 2, 0}, {neck_diameter / 2, length}});
}

ToolHead cylinder_head(double diameter, double length) {
  require_dimensions("cylinder_head", {{"diameter", diameter}, {"length", length}});
  return FlatHead{diameter / 2, length};
}

ToolHead round_end_cylinder_head(double diameter, double length) {
  require_dimensions("round_end_cylinder_head", {{"diameter", diameter}, {"length", length}});
  const double r = diameter / 2;
  require_at_least(length, "round_end_cylinder_head length", r, "radius");
  std::vector<ProfileEdge> edges = {{r, r, r}};
  if (length > r) edges.push_back({r, length});
  return closed(std::move(edges));
}

ToolHead tapered_head(double tip_diameter, double diameter, double length) {
  require_dimensions("tapered_head", {{"tip_diameter", tip_diameter}, {"diameter", diameter}, {"length", length}});
  require_less(tip_diameter, "tapered_head tip_diameter", diameter, "diameter");
  return closed({{tip_diameter / 2, 0}, {diameter / 2, length}});
}

ToolHead round_end_tapered_head(double tip_diameter, double diameter, double length) {
  require_dimensions("round_end_tapered_head",
                     {{"tip_diameter", tip_diameter}, {"diameter", diameter}, {"length", length}});
  require_less(tip_diameter, "round_end_tapered_head tip_diameter", diameter, "diameter");
  const double r = tip_diameter / 2, R = diameter / 2, above = length - r;
  require_less(R, "half of the round_end_tapered_head diameter", length, "length");
  // The wall leans outwards by the angle a and touches the ball: R cos(a) - above sin(a) = r.
  const double a = std::acos(r / std::hypot(R, above)) - std::atan2(above, R);
  return closed({{r * std::cos(a), r - r * std::sin(a), r}, {R, length}});
}

ToolHead needle_head(double diameter, double length) {
  require_dimensions("needle_head", {{"diameter", diameter}, {"length", length}});
  return ConeHead{std::atan2(diameter / 2, length), length};
}

ToolHead flame_head(double diameter, double length, double neck_diameter, double widest_height) {
  require_dimensions(
      "flame_head",
      {{"diameter", diameter}, {"length", length}, {"neck_diameter", neck_diameter}, {"widest_height", widest_height}});
  require_less(neck_diameter, "flame_head neck_diameter", diameter, "diameter");
  require_less(widest_height, "flame_head widest_height", length, "length");
  const double R = diameter / 2, narrowing = R - neck_diameter / 2, above = length - widest_height;
  require_at_least(widest_height, "flame_head widest_height", R, "radius");
  require_at_least(above, "flame_head length above widest_height", narrowing, "difference of the radii");
  // Where the arcs meet, both tangents are parallel to the axis.
  const double below_radius = (R * R + widest_height * widest_height) / (2 * R);
  const double above_radius = (narrowing * narrowing + above * above) / (2 * narrowing);
  return closed({{R, widest_height, below_radius}, {neck_diameter / 2, length, above_radius}});
}

ToolHead pear_head(double diameter, double length, double neck_diameter) {
  require_dimensions("pear_head", {{"diameter", diameter}, {"length", length}, {"neck_diameter", neck_diameter}});
  require_less(neck_diameter, "pear_head neck_diameter", diameter, "diameter");
  const double R = diameter / 2, r = neck_diameter / 2, above = length - R;
  require_less(R, "half of the pear_head diameter", length, "length");
  require_less(std::sqrt(R * R - r * r), "height of the pear_head's ball above its centre, at the neck,", above,
               "length above the centre");
  // The wall leans inwards by the angle a and touches the ball: r cos(a) + above sin(a) = R.
  const double a = std::atan2(above, r) - std::acos(R / std::hypot(r, above));
  return closed({{R * std::cos(a), R + R * std::sin(a), R}, {r, length}});
}

ToolHead wheel_head(double diameter, double thickness, double shank_diameter) {
  require_dimensions("wheel_head",
                     {{"diameter", diameter}, {"thickness", thickness}, {"shank_diameter", shank_diameter}});
  require_less(shank_diameter, "wheel_head shank_diameter", diameter, "diameter");
  return closed({{diameter / 2, 0}, {diameter / 2, thickness}, {shank_diameter / 2, thickness}});
}

ToolHead christmas_tree_head(double diameter, double length, int tiers) {
  require_dimensions("christmas_tree_head", {{"diameter", diameter}, {"length", length}});
  require_between(tiers, 1, kMaxTiers, "christmas_tree_head tiers");
  std::vector<ProfileEdge> edges;
  for (int n = 1; n <= tiers; ++n) {
    const double rim = diameter / 2 * n / tiers, z = length * n / tiers;
    edges.push_back({rim, z});
    if (n < tiers) edges.push_back({kTreeWaist * rim, z});
  }
  return closed(std::move(edges));
}

ToolHead twist_drill_head(double diameter, double length, double point_angle) {
  require_dimensions("twist_drill_head", {{"diameter", diameter}, {"length", length}});
  if (!(point_angle > 0 && point_angle < kPi))
    throw Error("twist_drill_head point_angle = " + format_number(point_angle) +
                " rad; must be > 0 and < pi. Give the full angle of the point.");
  const double R = diameter / 2, point = R / std::tan(point_angle / 2);
  require_less(point, "height of the twist_drill_head's point", length, "length");
  return closed({{R, point}, {R, length, 0, kSmooth}});
}

namespace {

using Values = std::span<const double>;

/// The dimensions of burs, and those of shapes whose text says more than that of the field; in the order of the help.
constexpr HeadDimension kTold[] = {
    {"radius", "m", Range::positive(), "radius of a sphere or flat head"},
    {"height", "m", Range::positive(), "height of a cone or flat head"},
    {"half_angle", "rad", range_of(&ConeHead::half_angle), "angle of a cone between axis and side"},
    {"diameter", "m", Range::positive(), "largest diameter of a catalogue head"},
    {"length", "m", Range::positive(), "length of a catalogue head, thickness of a wheel"},
    {"tip_diameter", "m", Range::positive(),
     "diameter at the tip of an inverted_cone, tapered or round_end_tapered head"},
    {"neck_diameter", "m", Range::positive(), "diameter at the shank of an inverted_cone, flame or pear"},
    {"shank_diameter", "m", Range::positive(), "of a wheel: its upper face does not cut within this diameter"},
    {"widest_height", "m", Range::positive(), "of a flame: from the tip to its widest place"},
    {"tiers", "1", Range::between(1, kMaxTiers), "of a christmas_tree: number of cones", true},
    {"point_angle", "rad", Range{0, kPi, true}, "of a twist_drill: full angle of its point"}};

constexpr const HeadDimension* find_told(std::string_view name) {
  for (const HeadDimension& one : kTold)
    if (one.name == name) return &one;
  return nullptr;
}
/// Not a constant, and so refused by the compiler, for a name that kTold does not have.
constexpr HeadDimension told(std::string_view name) { return *find_told(name); }

/// A field of a shape as a dimension.
template <class S, class T>
constexpr HeadDimension dimension_of(const Field<S, T>& field) {
  if (const HeadDimension* known = find_told(field.name); known != nullptr) return *known;
  return {field.name, field.unit, field.range, field.text, std::is_integral_v<T>};
}

/// Whether what kTold says is true for the fields of all shapes.
constexpr bool is_told_right() {
  bool right = true;
  for_each_shape([&]<class Shape>(Of<Shape>) {
    if constexpr (Described<Shape>)
      for_each_number<Shape>([&](const auto& field) {
        const HeadDimension* known = find_told(field.name);
        right = right && (known == nullptr ||
                          (known->unit == field.unit && known->meaning.find(Shape::kWord) != std::string_view::npos));
      });
  });
  return right;
}
static_assert(is_told_right(),
              "a shape has a field with the name of a dimension in kTold: that text must name the shape, and the units "
              "must be equal; add the shape to the text, or rename the field");

/// The entry of a shape; its dimensions are those of its fields that are numbers.
template <class Shape>
HeadShape entry_of() {
  HeadShape entry = {Shape::kWord, Shape::kInSentences, {}, [](Values values) {
                       Shape shape = Shape::usual();
                       for_each_number<Shape>([&, n = values.begin()]<class T>(const Field<Shape, T>& field) mutable {
                         shape.*field.member = T(*n++);
                       });
                       return ToolHead(shape);
                     }};
  for_each_number<Shape>([&](const auto& field) {
    entry.dimensions.push_back({dimension_of(field), double(Shape::usual().*field.member)});
  });
  return entry;
}

std::vector<HeadShape> burs() {
  using units::mm;
  constexpr HeadDimension diameter = told("diameter"), length = told("length"), tip_diameter = told("tip_diameter"),
                          neck_diameter = told("neck_diameter"), shank_diameter = told("shank_diameter"),
                          widest_height = told("widest_height"), tiers = told("tiers"),
                          point_angle = told("point_angle");
  return {{"round", "a round head", {{diameter, 1.4 * mm}}, [](Values v) { return round_head(v[0]); }},
          {"inverted_cone",
           "an inverted cone",
           {{tip_diameter, 1.4 * mm}, {neck_diameter, 0.9 * mm}, {length, 1.2 * mm}},
           [](Values v) { return inverted_cone_head(v[0], v[1], v[2]); }},
          {"cylinder",
           "a cylinder",
           {{diameter, 1.2 * mm}, {length, 4 * mm}},
           [](Values v) { return cylinder_head(v[0], v[1]); }},
          {"round_end_cylinder",
           "a round-end cylinder",
           {{diameter, 1.2 * mm}, {length, 4 * mm}},
           [](Values v) { return round_end_cylinder_head(v[0], v[1]); }},
          {"tapered",
           "a tapered head",
           {{tip_diameter, 0.9 * mm}, {diameter, 1.6 * mm}, {length, 4 * mm}},
           [](Values v) { return tapered_head(v[0], v[1], v[2]); }},
          {"round_end_tapered",
           "a round-end tapered head",
           {{tip_diameter, 0.8 * mm}, {diameter, 1.6 * mm}, {length, 4 * mm}},
           [](Values v) { return round_end_tapered_head(v[0], v[1], v[2]); }},
          {"needle",
           "a needle",
           {{diameter, 1.2 * mm}, {length, 5 * mm}},
           [](Values v) { return needle_head(v[0], v[1]); }},
          {"flame",
           "a flame",
           {{diameter, 1.4 * mm}, {length, 4 * mm}, {neck_diameter, 0.9 * mm}, {widest_height, 2 * mm}},
           [](Values v) { return flame_head(v[0], v[1], v[2], v[3]); }},
          {"pear",
           "a pear",
           {{diameter, 1.4 * mm}, {length, 2.6 * mm}, {neck_diameter, 0.8 * mm}},
           [](Values v) { return pear_head(v[0], v[1], v[2]); }},
          {"wheel",
           "a wheel",
           {{diameter, 4 * mm}, {length, 0.8 * mm}, {shank_diameter, 1.4 * mm}},
           [](Values v) { return wheel_head(v[0], v[1], v[2]); }},
          {"christmas_tree",
           "a christmas tree",
           {{diameter, 2 * mm}, {length, 3 * mm}, {tiers, 3}},
           [](Values v) { return christmas_tree_head(v[0], v[1], int(v[2])); }},
          {"twist_drill",
           "a twist drill",
           {{diameter, 2 * mm}, {length, 5 * mm}, {point_angle, kCommonDrillPoint, true}},
           [](Values v) { return twist_drill_head(v[0], v[1], v[2]); }}};
}

}  // namespace

const HeadShape::Dimension* HeadShape::find(std::string_view dimension) const {
  for (const Dimension& one : dimensions)
    if (one.what.name == dimension) return &one;
  return nullptr;
}

ToolHead HeadShape::usual() const {
  std::vector<double> values;
  for (const Dimension& dimension : dimensions) values.push_back(dimension.usual);
  return make(values);
}

const std::vector<HeadDimension>& head_dimensions() {
  static const std::vector<HeadDimension> dimensions = [] {
    std::vector<HeadDimension> all(std::begin(kTold), std::end(kTold));
    for (const HeadShape& shape : head_shapes())
      for (const auto& [what, usual, optional] : shape.dimensions)
        if (std::ranges::find(all, what.name, &HeadDimension::name) == all.end()) all.push_back(what);
    return all;
  }();
  return dimensions;
}

const std::vector<HeadShape>& head_shapes() {
  static const std::vector<HeadShape> shapes = [] {
    std::vector<HeadShape> all;
    for_each_shape([&]<class Shape>(Of<Shape>) {
      if constexpr (Described<Shape>) all.push_back(entry_of<Shape>());
    });
    for (HeadShape& bur : burs()) all.push_back(std::move(bur));
    return all;
  }();
  return shapes;
}

}  // namespace hapticut
