// SPDX-License-Identifier: Apache-2.0
// Cutting with Quadrature::sub_voxel: an engaged layer thinner than a voxel gives the closed forms without a ripple, in
// every direction of the grid, and a tool that is pushed does not lock (docs/decisions/0009-cut-voxels.md).
#include <gtest/gtest.h>

#include "hapticut/bench/closed_forms.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/force/laws/hertzian_burr.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "support/cutting.hpp"
#include "support/fed_tool.hpp"
#include "support/profiles.hpp"
#include "support/static_contact.hpp"

namespace hapticut::sub_voxel_test {
namespace {

namespace forms = closed_forms;
using test::Fed;
using test::feed_along;
using test::kWays;
using test::plain_material;
using test::push_down;
using test::Pushed;
using test::Way;
using units::deg;
using units::kPi;
using units::mm;

constexpr double kRadius = 1 * mm;
constexpr double kVoxel = 0.1 * mm;
constexpr double kFeed = 2 * mm;  // [m/s]
constexpr double kSpin = 2000;    // [rad/s]
constexpr double kDt = 1e-3;      // [s]

// Measured, [1]: what is left of each is in docs/decisions/0009-cut-voxels.md.
constexpr double kMean = 0.02;           // of the closed form
constexpr double kAboutTheAxis = 0.022;  // the same where a tenth of the thrust comes from one voxel about the axis
constexpr double kRipple = 0.015;        // standard deviation over mean
constexpr double kStiffest = 0.02;       // the same at k_v = 1e17 along <111>
constexpr double kInSlot = 0.008;        // the same for walls
constexpr double kTenLayers = 0.03;      // the same where a wall advances by ten layers, half a voxel, in a tick
constexpr double kPushed = 0.04;         // of the speed under a push
constexpr double kClosure = 1e-5;        // of the ledger

forms::SteadyCut cut_with(const Material& m) {
  return {m.specific_cutting_energy, m.cutting_ratio, kSpin, kFeed, m.edge_pressure};
}

SimulationConfig config_with(double stiffness) {
  SimulationConfig config;
  config.reference_stiffness = stiffness;
  return config;
}

/// A flat head drilled down its axis into a block that it enters askew, until all of its bottom cuts.
Fed drill(const Way& way, double stiffness, const Material& material) {
  const Vec3 axis = way.R_WT.col(2);
  Simulation simulation(
      build_block({Vec3::Constant(-2.2 * mm), Vec3::Constant(2.2 * mm)}, kVoxel, material),
      Tool(FlatHead{kRadius, 8 * mm, FlatRule::bottom_only}, RayHandle{0}, Spindle{kSpin * units::rad_per_s}),
      config_with(stiffness));
  // Deep in a hole of its own radius: fed fast to where the measurement begins.
  const Vec3 deep = axis * 0.3 * mm + Vec3(0.017, 0.006, 0.003) * mm;
  (void)feed_along(simulation, way.R_WT, deep + axis * 4 * mm, -axis * 20 * mm, 4 * mm, 1);
  return feed_along(simulation, way.R_WT, deep, -axis * kFeed, 0.5 * mm, 0.3);
}

TEST(SubVoxel, C20AndC22DrillingInEveryDirectionOfTheGrid) {
  for (const double edge_pressure : {0.0, 1e6})
    for (const Way& way : kWays)
      for (const double stiffness : {1e15, 1e16, 1e17}) {
        Material material = plain_material();
        material.edge_pressure = edge_pressure;
        const Fed s = drill(way, stiffness, material);
        const forms::SteadyCut cut = cut_with(material);
        const double thrust = forms::axial_cutting_force_of_a_flat_head(cut, kRadius);
        SCOPED_TRACE(std::string(way.name) + ", k_v " + std::to_string(stiffness) + ", p_e " +
                     std::to_string(edge_pressure));
        EXPECT_NEAR(s.force_T.z() / thrust, 1, kAboutTheAxis);
        EXPECT_NEAR(s.torque_T.z() / forms::axial_cutting_torque_of_a_flat_head(cut, kRadius), 1, kMean);
        EXPECT_LT(s.ripple_T.z() / thrust, stiffness > 5e16 && edge_pressure == 0 ? kStiffest : kRipple);
        EXPECT_LT(fixtures::unbooked(s.energy), kClosure);
      }
}

/// A wall fed at an angle to the grid through a plate, along and across the feed.
void expect_slot(double angle, double feed, double spin, double stiffness, double mean, double ripple) {
  const double height = 0.4 * mm;
  const Vec3 way(std::cos(angle * deg), std::sin(angle * deg), 0);
  const Mat3 R = Eigen::AngleAxisd(angle * deg, Vec3::UnitZ()).toRotationMatrix();
  Simulation simulation(
      build_block({Vec3(-3, -3, -height / mm) * mm, Vec3(3, 3, 0) * mm}, kVoxel, plain_material()),
      Tool(FlatHead{kRadius, 4 * mm, FlatRule::side_only}, RayHandle{0}, Spindle{spin * units::rad_per_s}),
      config_with(stiffness));
  const Vec3 start = Vec3(0.017, 0.006, -1.503) * mm - 0.5 * mm * way;
  (void)feed_along(simulation, R, start - way * 4 * mm, way * 20 * mm, 4 * mm, 1);
  const Fed s = feed_along(simulation, R, start, way * feed, 1.6 * mm, 0.4);
  forms::SteadyCut cut = cut_with(plain_material());
  cut.feed_speed = feed;
  cut.spin = spin;
  const Wrench expected = forms::slotting_wrench(cut, kRadius, height);
  SCOPED_TRACE(std::to_string(angle) + " deg, k_v " + std::to_string(stiffness) + ", feed " + std::to_string(feed));
  EXPECT_NEAR(s.force_T.x() / expected.force.x(), 1, mean);
  EXPECT_NEAR(s.force_T.y() / expected.force.y(), 1, mean);
  EXPECT_NEAR(s.torque_T.z() / expected.torque.z(), 1, mean);
  EXPECT_LT(s.ripple_T.x() / std::abs(expected.force.x()), ripple);
  EXPECT_LT(fixtures::unbooked(s.energy), kClosure);
}

TEST(SubVoxel, C24SlottingAtAnAngleToTheGrid) {
  for (const double angle : {0.0, 29.0, 45.0})
    for (const double stiffness : {1e15, 1e16, 1e17}) expect_slot(angle, kFeed, kSpin, stiffness, kMean, kInSlot);
}

// Half a voxel a tick, ten times the engaged layer; the spin is such that the feed is a 400th of the rim's speed, as
// the closed form asks for.
TEST(SubVoxel, C24SlottingTenLayersDeepInATick) {
  for (const double angle : {0.0, 29.0, 45.0}) expect_slot(angle, 50 * mm, 20000, 1e17, kMean, kTenLayers);
}

/// A flat bur under a constant push of the hand.
Pushed push(double stiffness, double hand_force, double edge_pressure) {
  Material material = plain_material();
  material.edge_pressure = edge_pressure;
  Simulation simulation(
      build_block({Vec3(-1.4, -1.4, -1.5) * mm, Vec3(1.4, 1.4, 0) * mm}, kVoxel, material),
      Tool(FlatHead{kRadius, 4 * mm, FlatRule::bottom_only}, RayHandle{0}, Spindle{kSpin * units::rad_per_s}),
      config_with(stiffness));
  return push_down(simulation, hand_force);
}

// Where forces are taken at points, a whole layer of voxels is cut only where k_v w0 l = 2 p_e l/w0, so a push below
// sqrt(2 p_e k_v) l per area stands for ever, far above the threshold p_e of the model itself.
TEST(SubVoxel, C23APushedToolCutsWherePointsWouldLockIt) {
  const double edge_pressure = 5e5, area = kPi * kRadius * kRadius, hand = 4;
  for (const double stiffness : {1e15, 1e16, 1e17}) {
    ASSERT_LT(hand, area * kVoxel * std::sqrt(2 * edge_pressure * stiffness)) << "or nothing would lock";
    Material material = plain_material();
    material.edge_pressure = edge_pressure;
    const Pushed s = push(stiffness, hand, edge_pressure);
    const double expected = forms::feed_of_a_flat_head_under(s.force, cut_with(material), kRadius);
    EXPECT_NEAR(s.speed / expected, 1, kPushed);
  }
}

TEST(SubVoxel, C23BelowTheThresholdItStands) {
  const double edge_pressure = 5e5, threshold = kPi * kRadius * kRadius * edge_pressure;
  EXPECT_LT(push(1e16, 0.95 * threshold, edge_pressure).speed, 1e-3 * mm);
}

/// [1] rms error of C1 over shifts of the grid against the surface, whose normal is given in the grid's axes.
double static_error(const Vec3& normal, double voxel) {
  const double depth = 0.4 * mm;
  double square = 0;
  constexpr int kPhases = 6;
  for (int phase = 0; phase < kPhases; ++phase) {
    const Vec3 surface = voxel * Vec3(0.11, 0.37, 0.13) * phase;  // a point of it
    const BodyDescription half_space = {{Vec3::Constant(-1.8 * mm), Vec3::Constant(1.8 * mm)},
                                        [&](const Vec3& p) { return normal.dot(p - surface); },
                                        [](const Vec3&) { return MaterialId(1); }};
    Simulation simulation(build_body(half_space, voxel, MaterialTable({plain_material()})),
                          Tool(SphereHead{kRadius}, RayHandle{0}, Spindle{0}), fixtures::static_config());
    const Pose pose = Pose::from_translation(surface + normal * (kRadius - depth));
    const double force = fixtures::hold(simulation, pose).force.dot(normal);
    square += std::pow(force / forms::cap_force(fixtures::kStiffness, kRadius, depth) - 1, 2) / kPhases;
  }
  return std::sqrt(square);
}

// Two errors of second order, of curvature and of the part that lies on the far side, cancel where directions mix.
TEST(SubVoxel, C1StaticForceOfABallConvergesAtThirdOrderAskewAndAtSecondAlongTheGrid) {
  const Vec3 askew = Vec3(0.3, 0.2, 1).normalized();
  const double coarse = static_error(askew, 0.2 * mm), fine = static_error(askew, 0.1 * mm);
  EXPECT_LT(coarse, 0.006);
  EXPECT_GT(std::log2(coarse / fine), 2.3);
  const double coarse_along = static_error(Vec3::UnitZ(), 0.2 * mm), fine_along = static_error(Vec3::UnitZ(), 0.1 * mm);
  EXPECT_LT(coarse_along, 0.019);
  EXPECT_GT(std::log2(coarse_along / fine_along), 1.8);
}

// Just outside a profile its table must know the surface too. The side of the second one is in two pieces, which makes
// three curves: it needs its cells, where the other two have one rule for all places.
TEST(SubVoxel, AProfilePressesAsTheShapeThatItDraws) {
  struct Case {
    ToolHead profile, shape;
    double tip;  // [m] from the shape's origin to its lowest point, less that of the profile
  };
  const double height = 3 * mm;
  const Profile in_pieces = {0,
                             {{kRadius, 0}, {kRadius, 0.2 * mm}, {kRadius, height}, {0, height, 0, EdgeKind::smooth}}};
  ASSERT_EQ(ProfileHead(in_pieces).table().everywhere, 0U);
  for (const Case& c : {Case{ProfileHead(test::flat_profile(kRadius, height)), FlatHead{kRadius, height}, 0},
                        Case{ProfileHead(in_pieces), FlatHead{kRadius, height}, 0},
                        Case{round_end_cylinder_head(2 * kRadius, height), SphereHead{kRadius}, kRadius}}) {
    const double bottom = c.profile.bounding_box().min.z();
    const auto force_of = [&](const ToolHead& head, double lowest) {
      Simulation simulation(
          build_block({Vec3(-1.63, -1.57, -1.2) * mm, Vec3(1.6, 1.6, 0) * mm}, kVoxel, plain_material()),
          Tool(head, RayHandle{0}, Spindle{0}), fixtures::static_config());
      return fixtures::hold(simulation, Pose::from_translation({0, 0, -0.36 * mm - lowest})).force.z();
    };
    EXPECT_NEAR(force_of(c.profile, bottom) / force_of(c.shape, -c.tip), 1, 0.005);
  }
}

TEST(SubVoxel, RefusesWhatItCannotDo) {
  const auto refusal_of = [](const SimulationConfig& config) -> std::string {
    try {
      (void)Simulation(build_block({Vec3::Zero(), Vec3::Constant(1 * mm)}, kVoxel, plain_material()),
                       Tool(SphereHead{kRadius}, RayHandle{0}, Spindle{kSpin * units::rad_per_s}), config);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  SimulationConfig config = config_with(1e15);
  EXPECT_EQ(refusal_of(config), "");
  config.quadrature = Quadrature::centroid;
  EXPECT_NE(refusal_of(config).find("points are for other laws"), std::string::npos) << refusal_of(config);
  config.quadrature = Quadrature::sub_voxel;
  config.law = std::make_shared<HertzianBurrLaw>(1e6);
  EXPECT_NE(refusal_of(config).find("Choose automatic or centroid"), std::string::npos) << refusal_of(config);
  config.law = nullptr;
  EXPECT_NE(refusal_of(config).find("SimulationConfig::law is null"), std::string::npos) << refusal_of(config);
}

}  // namespace
}  // namespace hapticut::sub_voxel_test
