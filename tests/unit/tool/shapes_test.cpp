// SPDX-License-Identifier: Apache-2.0
#include "hapticut/tool/shapes.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

#include "hapticut/tool/catalogue.hpp"
#include "hapticut/tool/head_outline.hpp"
#include "support/generators.hpp"
#include "support/places.hpp"
#include "support/springs.hpp"

namespace hapticut::shapes_test {
namespace {

using test::arbitrary_head;
using test::margin_at;
using test::number_between;
using test::spring_at;
using units::kPi;
using units::mm;

/// Whether a point of the meridian plane is inside the body, from the definition of a known shape, else from its edges.
bool is_inside(const ToolHead& head, double rho, double z) {
  if (const auto* sphere = std::get_if<SphereHead>(&head.shape()))
    return rho * rho + z * z < sphere->radius * sphere->radius;
  if (const auto* cone = std::get_if<ConeHead>(&head.shape()))
    return z > 0 && z < cone->height && rho < z * std::tan(cone->half_angle);
  if (const auto* flat = std::get_if<FlatHead>(&head.shape())) return z > 0 && z < flat->height && rho < flat->radius;
  return HeadOutline(head).distance(rho, z) < 0;
}

RC_GTEST_PROP(Shapes, MarginChangesByAtMostTheDistance, ()) {
  const ToolHead head = *arbitrary_head();
  const double reach = 2 * head.reach();
  const double rho_1 = *number_between(0, reach), rho_2 = *number_between(0, reach);
  const double z_1 = *number_between(-reach, reach), z_2 = *number_between(-reach, reach);
  const double distance = std::hypot(rho_1 - rho_2, z_1 - z_2);
  RC_ASSERT(std::abs(margin_at(head, rho_1, z_1) - margin_at(head, rho_2, z_2)) <= distance * (1 + 1e-9) + 1e-15);
}

RC_GTEST_PROP(Shapes, MarginIsPositiveExactlyInside, ()) {
  const ToolHead head = *arbitrary_head();
  const double reach = 1.2 * head.reach();
  const double rho = *number_between(0, reach), z = *number_between(-reach, reach);
  const double margin = margin_at(head, rho, z);
  if (std::abs(margin) < 1e-12) return;  // on the surface, within rounding
  RC_ASSERT((margin > 0) == is_inside(head, rho, z));
}

// The springs push along the negative gradient of the depth: with one spring per point, scale times n is -grad w.
RC_GTEST_PROP(Shapes, DirectionIsTheSteepestDescentOfDepth, ()) {
  const ToolHead head = *arbitrary_head();
  if (const auto* flat = std::get_if<FlatHead>(&head.shape())) RC_PRE(flat->rule != FlatRule::both);
  const double rho = *number_between(1e-5, head.reach()), z = *number_between(-head.reach(), head.reach());
  constexpr double kStep = 1e-9;  // [m]
  RC_PRE(margin_at(head, rho, z) > 3 * kStep);
  if (const auto* flat = std::get_if<FlatHead>(&head.shape()))
    RC_PRE(std::abs(flat->radius - rho - z) > 3 * kStep);  // where `nearest` changes sides
  const double radial = (spring_at(head, rho + kStep, z).depth - spring_at(head, rho - kStep, z).depth) / (2 * kStep);
  const double axial = (spring_at(head, rho, z + kStep).depth - spring_at(head, rho, z - kStep).depth) / (2 * kStep);
  const MeridianSpring<double> s = spring_at(head, rho, z);
  for (int side = -1; side <= 1; side += 2)  // where the smooth end is equally near
    RC_PRE(spring_at(head, rho + side * kStep, z).on_smooth() == s.on_smooth() &&
           spring_at(head, rho, z + side * kStep).on_smooth() == s.on_smooth());
  // Error: rounding of numbers of 1e-3 divided by 2e-9, and the curvature 1/rho of the ball over the step.
  RC_ASSERT(std::abs(s.scale() * s.n_radial + radial) < 2e-6 + kStep / rho);
  RC_ASSERT(std::abs(s.scale() * s.n_axial + axial) < 2e-6 + kStep / rho);
}

RC_GTEST_PROP(Shapes, BothSpringsAreTheSumOfBottomAndSide, ()) {
  const double radius = *number_between(0.1 * mm, 3 * mm), height = *number_between(0.1 * mm, 3 * mm);
  const double rho = *number_between(0, radius * 0.999), z = *number_between(1e-9, height * 0.999);
  const auto at = [&](FlatRule rule) { return spring_at(FlatHead{radius, height, rule}, rho, z); };
  const MeridianSpring<double> both = at(FlatRule::both), bottom = at(FlatRule::bottom_only),
                               side = at(FlatRule::side_only);
  RC_ASSERT(std::abs(both.depth * both.n_radial - side.depth) < 1e-12);
  RC_ASSERT(std::abs(both.depth * both.n_axial + bottom.depth) < 1e-12);
}

RC_GTEST_PROP(Shapes, NearestIsTheShallowestOfBottomSideAndTop, ()) {
  const double radius = *number_between(0.1 * mm, 3 * mm), height = *number_between(0.1 * mm, 3 * mm);
  const double rho = *number_between(0, radius * 0.999), z = *number_between(1e-9, height * 0.999);
  const auto at = [&](FlatRule rule) { return spring_at(FlatHead{radius, height, rule}, rho, z).depth; };
  const double cutting = std::min(at(FlatRule::bottom_only), at(FlatRule::side_only)),
               top = kSmoothScale * (height - z);
  RC_ASSERT(at(FlatRule::nearest) == std::min(cutting, top));
}

// At a corner of 90 degrees between a cutting and a smooth surface, the two distances are independent.
TEST(Shapes, OutsideOfTwoSurfacesDepthIsTheDistanceFromTheirEdge) {
  const auto below = [](double cutting, double smooth) {
    return formulas::depth_below_both(formulas::depth_below(cutting, 1.0), formulas::depth_below(smooth, kSmoothScale));
  };
  EXPECT_DOUBLE_EQ(below(-3, -4), -5);
  EXPECT_DOUBLE_EQ(below(-3, 4), -3);
  EXPECT_DOUBLE_EQ(below(3, -4), -4);
  EXPECT_DOUBLE_EQ(below(3, 1), kSmoothScale);
  EXPECT_DOUBLE_EQ(below(1, 3), 1);
  EXPECT_NEAR(below(-1e-9, -4), below(1e-9, -4), 1e-8) << "continuous";
  for (const double distance : {-2.0, 0.0, 0.7})
    EXPECT_DOUBLE_EQ(formulas::distance_below(formulas::depth_below(distance, kSmoothScale), kSmoothScale), distance);
  // A cone, past the rim of its base.
  const ConeHead cone = {30 * kPi / 180, 1 * mm};
  const double rho = cone.height * std::tan(cone.half_angle) + 0.2 * mm, z = cone.height + 0.1 * mm;
  const double side = z * std::sin(cone.half_angle) - rho * std::cos(cone.half_angle);
  EXPECT_NEAR(spring_at(cone, rho, z).depth, -std::hypot(side, 0.1 * mm), 1e-12);
}

// A new shape needs no other line for settings, browser page, recordings, kernels and these tests: they read the list.
TEST(Shapes, AreInTheCatalogueInPythonAndOnThePages) {
  const auto text_of = [](const char* file) {
    std::ifstream in(test::source_path(file));
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const std::string python = text_of("bindings/python/hapticut/__init__.py");
  const std::string heads = text_of("docs/heads-and-materials.md"), settings = text_of("docs/command-line.md");
  const std::size_t row = settings.find("| `head` | shape |");
  const std::string words = settings.substr(row, settings.find('\n', row) - row);
  for_each_shape([&]<class Shape>(Of<Shape>) {
    const std::string name = Shape::kName, word = Shape::kWord;
    EXPECT_NE(python.find(name + " as " + name), std::string::npos) << name;
    EXPECT_NE(heads.find("`" + name + "`"), std::string::npos) << name;
    EXPECT_TRUE(words.find(" " + word + ",") != std::string::npos || words.ends_with(" " + word + " |")) << word;
    if constexpr (Described<Shape>) {
      const auto named = [&](const HeadShape& one) { return one.name == word; };
      const auto entry = std::find_if(head_shapes().begin(), head_shapes().end(), named);
      ASSERT_NE(entry, head_shapes().end()) << word;
      const ToolHead head = entry->usual();
      ASSERT_TRUE(std::holds_alternative<Shape>(head.shape())) << word;
      for_each_number<Shape>([&](const auto& field) {
        EXPECT_EQ(std::get<Shape>(head.shape()).*field.member, Shape::usual().*field.member) << word << field.name;
        const HeadShape::Dimension* dimension = entry->find(field.name);
        ASSERT_NE(dimension, nullptr) << word << field.name;
        EXPECT_EQ(dimension->what.unit, field.unit) << word << field.name;
        EXPECT_EQ(std::ranges::count(head_dimensions(), field.name, &HeadDimension::name), 1) << word << field.name;
      });
    }
  });
}

TEST(Shapes, HaveTheirTipWhereTheMeridianAndTheSpringsBegin) {
  constexpr double kBeside = 1e-9;  // [m]
  for (const HeadShape& shape : head_shapes()) {
    const ToolHead head = shape.usual();
    EXPECT_EQ(head.tip(), head.profile().tip) << shape.name;
    EXPECT_GT(margin_at(head, 0, head.tip() + kBeside), 0) << shape.name;
    EXPECT_LT(margin_at(head, 0, head.tip() - kBeside), 0) << shape.name;
  }
}

}  // namespace
}  // namespace hapticut::shapes_test
