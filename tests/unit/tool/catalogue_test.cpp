// SPDX-License-Identifier: Apache-2.0
#include "hapticut/tool/catalogue.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <sstream>

#include "hapticut/tool/tool.hpp"
#include "support/catalogue_heads.hpp"
#include "support/places.hpp"
#include "support/refusal.hpp"
#include "support/springs.hpp"

namespace hapticut::catalogue_test {
namespace {

using test::CatalogueHead;
using test::margin_at;
using units::deg;
using units::kPi;
using units::mm;

constexpr double kRounding = 1e-12;  // [1]

double volume_of_frustum(double r, double R, double h) { return kPi * h / 3 * (r * r + r * R + R * R); }
double volume_of_cap(double R, double h) { return kPi * h * h * (R - h / 3); }

TEST(Catalogue, VolumesAreThoseOfTheSolids) {
  EXPECT_NEAR(round_head(2 * mm).volume() / (4 * kPi / 3 * 1e-9), 1, kRounding);
  EXPECT_NEAR(inverted_cone_head(1.4 * mm, 1 * mm, 2 * mm).volume() / volume_of_frustum(0.5 * mm, 0.7 * mm, 2 * mm), 1,
              kRounding);
  EXPECT_NEAR(cylinder_head(1.2 * mm, 4 * mm).volume() / (kPi * 0.36 * 4e-9), 1, kRounding);
  EXPECT_NEAR(round_end_cylinder_head(2 * mm, 5 * mm).volume() / (kPi * (4 + 2.0 / 3) * 1e-9), 1, kRounding);
  EXPECT_NEAR(tapered_head(0.8 * mm, 1.6 * mm, 4 * mm).volume() / volume_of_frustum(0.4 * mm, 0.8 * mm, 4 * mm), 1,
              kRounding);
  EXPECT_NEAR(needle_head(1.2 * mm, 5 * mm).volume() / volume_of_frustum(0, 0.6 * mm, 5 * mm), 1, kRounding);
  EXPECT_NEAR(wheel_head(4 * mm, 1 * mm, 1 * mm).volume() / (kPi * 4e-9), 1, kRounding);
  EXPECT_NEAR(twist_drill_head(2 * mm, 5 * mm, 90 * deg).volume() / (kPi * (4 + 1.0 / 3) * 1e-9), 1, kRounding);
  EXPECT_NEAR(christmas_tree_head(2 * mm, 2 * mm, 2).volume() /
                  (volume_of_frustum(0, 0.5 * mm, 1 * mm) + volume_of_frustum(0.3 * mm, 1 * mm, 1 * mm)),
              1, kRounding);
}

TEST(Catalogue, RoundEndsTouchTheirWallsWithoutAnEdge) {
  // A ball of radius r touches a wall that leans by the angle `lean`. The volume is a cap plus a frustum.
  const double r = 0.4 * mm, R = 0.8 * mm, length = 4 * mm;
  const ToolHead taper = round_end_tapered_head(2 * r, 2 * R, length);
  const ProfileEdge ball = taper.profile().edges[0], wall = taper.profile().edges[1];
  const double lean = std::atan2(wall.rho - ball.rho, wall.z - ball.z);
  EXPECT_NEAR(ball.rho, r * std::cos(lean), kRounding * mm);
  EXPECT_NEAR(ball.z, r - r * std::sin(lean), kRounding * mm);
  EXPECT_NEAR(taper.volume() / (volume_of_cap(r, ball.z) + volume_of_frustum(ball.rho, R, length - ball.z)), 1,
              kRounding);

  const ToolHead pear = pear_head(1.4 * mm, 2.6 * mm, 0.8 * mm);
  const ProfileEdge end = pear.profile().edges[0], neck = pear.profile().edges[1];
  const double inwards = std::atan2(end.rho - neck.rho, neck.z - end.z);
  EXPECT_NEAR(end.rho, 0.7 * mm * std::cos(inwards), kRounding * mm);
  EXPECT_NEAR(end.z, 0.7 * mm * (1 + std::sin(inwards)), kRounding * mm);
  EXPECT_NEAR(pear.max_radius(), 0.7 * mm, kRounding * mm);
}

TEST(Catalogue, TheFlameIsWidestAtItsWidestHeight) {
  const ToolHead flame = flame_head(1.4 * mm, 4 * mm, 0.9 * mm, 2.2 * mm);
  EXPECT_NEAR(flame.max_radius(), 0.7 * mm, kRounding * mm);
  EXPECT_GT(margin_at(flame, 0.6999 * mm, 2.2 * mm), 0);
  EXPECT_LT(margin_at(flame, 0.6999 * mm, 2.0 * mm), 0);
  EXPECT_LT(margin_at(flame, 0.6999 * mm, 2.4 * mm), 0);
}

TEST(Catalogue, TheTwistDrillCutsWithItsPointOnly) {
  const double point = 118 * deg;
  const ToolHead drill = twist_drill_head(2 * mm, 5 * mm, point);
  const double rho = 0.2 * mm, z = 1.2 * mm;
  const auto at = drill.spring_at({rho, 0, z});
  EXPECT_NEAR(at.depth, z * std::sin(point / 2) - rho * std::cos(point / 2), kRounding * mm);
  EXPECT_LT((at.direction - Vec3(std::cos(point / 2), 0, -std::sin(point / 2))).norm(), 1e-9);
  EXPECT_FALSE(at.on_smooth());
  EXPECT_LE(drill.spring_at({1.001 * mm, 0, z}).depth, 0);
  const auto margin = drill.spring_at({0.9 * mm, 0, 3 * mm});
  EXPECT_NEAR(margin.depth, kSmoothScale * 0.1 * mm, kRounding * mm);
  EXPECT_LT((margin.direction - Vec3(1, 0, 0)).norm(), 1e-9);
  EXPECT_TRUE(margin.on_smooth());
}

class CatalogueShape : public testing::TestWithParam<CatalogueHead> {};

TEST_P(CatalogueShape, IsTheSameAsAProfile) {
  const ToolHead head = GetParam().make();
  const ToolHead twin = ProfileHead(head.profile());
  EXPECT_NEAR(twin.volume() / head.volume(), 1, kRounding);
  EXPECT_NEAR(twin.reach() / head.reach(), 1, kRounding);
  EXPECT_LT((twin.bounding_box().max - head.bounding_box().max).norm(), kRounding * mm);
  EXPECT_LT((twin.bounding_box().min - head.bounding_box().min).norm(), kRounding * mm);
}

INSTANTIATE_TEST_SUITE_P(Heads, CatalogueShape, testing::ValuesIn(test::catalogue_heads()),
                         [](const auto& h) { return h.param.name; });

// Regression: a drill had six lips and pressed with nearly three times the right force.
TEST(Catalogue, ADrillHasTwoLipsAndABurSix) {
  const Tool drill(twist_drill_head(2 * mm, 5 * mm));
  EXPECT_EQ(drill.cutter().kind, CutterKind::twist_drill);
  EXPECT_EQ(drill.cutter().lips, 2);
  EXPECT_EQ(Tool(round_head(1 * mm), RayHandle{0}, {}, Cutter{CutterKind::twist_drill}).cutter().lips, 2);
  EXPECT_EQ(Tool(round_head(1 * mm), RayHandle{0}, {}, Cutter{CutterKind::coarse_diamond}).cutter().lips, 1);
  EXPECT_EQ(Tool(round_head(1 * mm), RayHandle{0}, {}, Cutter{CutterKind::twist_drill, 3}).cutter().lips, 3);
  for (const ToolHead& bur : {round_head(1 * mm), needle_head(1 * mm, 4 * mm), cylinder_head(1 * mm, 4 * mm),
                              pear_head(1 * mm, 2 * mm, 0.5 * mm), wheel_head(3 * mm, 1 * mm, 1 * mm),
                              christmas_tree_head(2 * mm, 6 * mm, 3), ToolHead(ConeHead{0.5, 1 * mm})}) {
    EXPECT_EQ(Tool(bur).cutter().kind, CutterKind::carbide_bur) << bur.description();
    EXPECT_EQ(Tool(bur).cutter().lips, 6) << bur.description();
  }
  EXPECT_EQ(tooth_rate(Cutter{CutterKind::twist_drill}, 2 * units::kPi), 2);
}

// --- bad input -------------------------------------------------------------------------------------------------------

TEST(Catalogue, RefusesDimensionsThatDoNotFitTogether) {
  using test::expect_refused;
  expect_refused([] { (void)round_head(0); }, {"diameter", "= 0", "> 0"});
  expect_refused([] { (void)inverted_cone_head(1 * mm, 1 * mm, 1 * mm); }, {"neck_diameter = 1 mm", "less", "tip"});
  expect_refused([] { (void)tapered_head(2 * mm, 1 * mm, 1 * mm); }, {"tip_diameter = 2 mm", "less", "1 mm"});
  expect_refused([] { (void)round_end_cylinder_head(2 * mm, 0.5 * mm); }, {"length = 0.5 mm", "radius", "1 mm"});
  expect_refused([] { (void)round_end_tapered_head(2 * mm, 1 * mm, 1 * mm); }, {"tip_diameter = 2 mm", "less"});
  expect_refused([] { (void)round_end_tapered_head(0.5 * mm, 3 * mm, 1 * mm); }, {"1.5 mm", "length, 1 mm"});
  expect_refused([] { (void)flame_head(2 * mm, 4 * mm, 1 * mm, 0.5 * mm); }, {"widest_height = 0.5 mm", "radius"});
  expect_refused([] { (void)flame_head(2 * mm, 4 * mm, 3 * mm, 2 * mm); }, {"neck_diameter = 3 mm", "less"});
  expect_refused([] { (void)pear_head(2 * mm, 1.5 * mm, 0.5 * mm); }, {"length above", "0.5 mm"});
  expect_refused([] { (void)wheel_head(2 * mm, 1 * mm, 2 * mm); }, {"shank_diameter = 2 mm", "less"});
  expect_refused([] { (void)christmas_tree_head(2 * mm, 1 * mm, 0); }, {"tiers = 0", "between 1 and 20"});
  expect_refused([] { (void)twist_drill_head(2 * mm, 5 * mm, 4); }, {"point_angle = 4 rad", "pi"});
  expect_refused([] { (void)twist_drill_head(2 * mm, 0.3 * mm); }, {"point", "less", "length, 0.3 mm"});
}

// --- docs/heads-and-materials.md -------------------------------------------------------------------------------------

TEST(Catalogue, HasARowForEachHeadInTheDocs) {
  std::ifstream page(test::source_path("docs/heads-and-materials.md"));
  std::vector<std::string> rows, functions;
  for (std::string line; std::getline(page, line);)
    if (const std::size_t end = line.find("_head` |"); line.starts_with("| `") && end != std::string::npos)
      rows.push_back(line.substr(3, end - 3));
  for (const CatalogueHead& head : test::catalogue_heads()) functions.push_back(head.name);
  EXPECT_EQ(rows, functions);
}

constexpr double kScale = 40;  // [px/mm]

/// A number of pixels as text, rounded to a hundredth, so that every machine writes equal text.
std::string px(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

struct Place {
  double x, y;  // [px] position of the frame's origin

  [[nodiscard]] std::string point(double rho, double z) const {
    return px(x + rho / mm * kScale) + ' ' + px(y - z / mm * kScale) + ' ';
  }
};

/// SVG path from the previous point along an edge.
std::string along(const ProfileEdge& edge, const std::string& to) {
  if (edge.radius == 0) return "L " + to;
  const std::string radius = px(std::abs(edge.radius) / mm * kScale);
  return "A " + radius + ' ' + radius + " 0 0 " + (edge.radius > 0 ? "0 " : "1 ") + to;
}

/// The outline of a head, both sides of the axis, tip down, as the path of an SVG.
std::string outline(const Profile& profile, const Place& place) {
  std::string path = "M " + place.point(0, profile.tip);
  for (const ProfileEdge& e : profile.edges) path += along(e, place.point(e.rho, e.z));
  for (std::size_t n = profile.edges.size(); n-- > 1;)  // and back on the other side
    path += along(profile.edges[n], place.point(-profile.edges[n - 1].rho, profile.edges[n - 1].z));
  return path + along(profile.edges[0], place.point(0, profile.tip)) + 'Z';
}

/// The smooth edges of a head, to be drawn over its outline.
std::string smooth_edges(const Profile& profile, const Place& place) {
  std::string path;
  double rho = 0, z = profile.tip;
  for (const ProfileEdge& e : profile.edges) {
    if (e.kind == EdgeKind::smooth)
      for (const int side : {1, -1}) path += "M " + place.point(side * rho, z) + "L " + place.point(side * e.rho, e.z);
    rho = e.rho;
    z = e.z;
  }
  return path;
}

std::string drawing() {
  constexpr int kColumns = 6, kWidth = 190, kHeight = 270;
  std::ostringstream svg;
  const std::vector<CatalogueHead> heads = test::catalogue_heads();
  const int rows = (int(heads.size()) + kColumns - 1) / kColumns;
  svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << kColumns * kWidth << "\" height=\"" << rows * kHeight
      << "\" font-family=\"sans-serif\" font-size=\"13\" text-anchor=\"middle\">\n"
      << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  for (int n = 0; n < int(heads.size()); ++n) {
    const double x0 = (n % kColumns + 0.5) * kWidth, y0 = (n / kColumns + 1) * kHeight - 40;
    const ToolHead head = heads[std::size_t(n)].make();
    const Profile profile = head.profile();
    const Place place = {x0, y0 + head.bounding_box().min.z() / mm * kScale};
    svg << "<path d=\"" << outline(profile, place) << "\" fill=\"#dde6f0\" stroke=\"#1f4e79\" stroke-width=\"2\"/>\n";
    const std::string smooth = smooth_edges(profile, place);
    if (!smooth.empty())
      svg << "<path d=\"" << smooth << "\" fill=\"none\" stroke=\"#c9c9c9\" stroke-width=\"2.5\"/>\n";
    svg << "<text x=\"" << px(x0) << "\" y=\"" << px(y0 + 25) << "\">" << heads[std::size_t(n)].name << "</text>\n";
  }
  svg << "</svg>\n";
  return svg.str();
}

TEST(Catalogue, IsDrawnInTheDocs) {
  std::ifstream file(test::source_path("docs/images/heads.svg"));
  const std::string drawn((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const std::string expected = drawing();
  if (drawn != expected) std::ofstream("heads.svg") << expected;
  EXPECT_TRUE(drawn == expected)
      << "the catalogue has changed: check heads.svg in the working folder of this test, and "
         "copy it to docs/images";
}

}  // namespace
}  // namespace hapticut::catalogue_test
