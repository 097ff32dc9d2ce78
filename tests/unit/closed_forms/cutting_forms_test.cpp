// SPDX-License-Identifier: Apache-2.0
// The closed forms C20-C38, C42 and C43 of docs/model.md against integrals of their equations, without voxels and
// steps. The tests integrate the pressure of the cut over the head's surface, or the layer in which the material
// decays.
#include <gtest/gtest.h>

#include <vector>

#include "hapticut/closed_forms.hpp"

namespace hapticut::cutting_forms_test {
namespace {

namespace forms = closed_forms;
using forms::SteadyCut;
using units::deg;
using units::kPi;
using units::mm;

constexpr double kStiffness = 1e12;  // [N/m^4] stiffness of C33
constexpr double kR = 1 * mm;
constexpr SteadyCut kCut{3e8, 0.5, 1000, 5e-3};

constexpr double kLine = 1e-5;   // [1] error of an integral over a line or surface with thousands of points
constexpr double kRoots = 5e-5;  // [1] error of an integral with a root of the cosine at its end
constexpr double kRounding = 1e-12;

/// A point of a meridian: distance from the axis, the normal out of the head, and the length that it represents.
struct MeridianPoint {
  double rho, n_radial, n_axial, length;
};

/// In a steady cut the surface of the material recedes with the head. The power of the pressure, kappa p s, pays for
/// the removal, u V . n; so `p = p_e + u (V . n)/(kappa s)`, s = omega rho, wherever V . n > 0. With chips, their
/// energy u (1 + h_e f_z/(V . n) + sqrt(h_s f_z/(V . n))) takes the place of u. The force per area on the tool is -p n
/// and, against the slip, kappa p.
/// @param feed  [1] direction of V
/// @param from, to  [rad] of the engaged angles, from +x towards +y
Wrench integrate(const SteadyCut& cut, const std::vector<MeridianPoint>& meridian, const Vec3& feed, double from = 0,
                 double to = 2 * kPi) {
  constexpr int kAngles = 4000;
  Wrench wrench;
  for (const MeridianPoint& point : meridian)
    for (int i = 0; i < kAngles; ++i) {
      const double angle = from + (to - from) * (i + 0.5) / kAngles;
      const Vec3 radial(std::cos(angle), std::sin(angle), 0), slip = Vec3::UnitZ().cross(radial);
      const Vec3 n = point.n_radial * radial + point.n_axial * Vec3::UnitZ();
      const double recession = cut.feed_speed * feed.dot(n);
      if (recession <= 0) continue;
      const double chips = std::sqrt(cut.size_length * cut.tooth_rate * recession) + cut.edge_length * cut.tooth_rate;
      const double pressure =
          cut.edge_pressure + cut.viscosity * recession +
          cut.specific_cutting_energy * (recession + chips) / (cut.cutting_ratio * cut.spin * point.rho);
      const double area = point.rho * (to - from) / kAngles * point.length;
      wrench.force -= pressure * area * (n + cut.cutting_ratio * slip);
      wrench.torque.z() -= pressure * area * cut.cutting_ratio * point.rho;
    }
  return wrench;
}

std::vector<MeridianPoint> meridian_of_a_ball(double from, double to) {  // [rad] from the lowest point
  std::vector<MeridianPoint> points;
  constexpr int kPoints = 300;
  for (int i = 0; i < kPoints; ++i) {
    const double th = from + (to - from) * (i + 0.5) / kPoints;
    points.push_back({kR * std::sin(th), std::sin(th), -std::cos(th), kR * (to - from) / kPoints});
  }
  return points;
}

std::vector<MeridianPoint> meridian_of_a_bottom() {
  std::vector<MeridianPoint> points;
  constexpr int kPoints = 300;
  for (int i = 0; i < kPoints; ++i) points.push_back({kR * (i + 0.5) / kPoints, 0, -1, kR / kPoints});
  return points;
}

void expect_force(const Wrench& integral, const Wrench& form, double within = kLine) {
  EXPECT_LT((integral.force - form.force).norm(), within * form.force.norm())
      << integral.force.transpose() << " and " << form.force.transpose();
  EXPECT_NEAR(integral.torque.z() / form.torque.z(), 1, within);
}

TEST(CuttingForms, C20C22OfAFlatHeadAreTheIntegralOfItsPressure) {
  for (const double edge : {0.0, 1e6}) {
    SteadyCut cut = kCut;
    cut.edge_pressure = edge;
    cut.viscosity = edge / cut.feed_speed;
    expect_force(integrate(cut, meridian_of_a_bottom(), -Vec3::UnitZ()),
                 {Vec3(0, 0, forms::axial_cutting_force_of_a_flat_head(cut, kR)),
                  Vec3(0, 0, forms::axial_cutting_torque_of_a_flat_head(cut, kR))});
  }
}

/// [Pa, m] Pressure and filled depth at one distance from the axis. A point moves up through the springs at the feed
/// speed, and their power cuts it: dphi/dw = -kappa k_v w s phi/(price v_f).
struct Layer {
  double pressure = 0, filled = 0, one_over_e = 0;
};

Layer layer_at(const SteadyCut& cut, double k_v, double rho, bool elastic_release) {
  const double u = cut.specific_cutting_energy, slip = cut.spin * rho;
  const double end = elastic_release ? std::sqrt(2 * u / k_v) : 12 * forms::engaged_layer(cut, k_v, rho);
  constexpr int kSteps = 40000;
  Layer layer;
  double phi = 1;
  for (int i = 0; i < kSteps && phi > 1e-12; ++i) {
    const double dw = end / kSteps, w = (i + 0.5) * dw, stored = elastic_release ? k_v * w * w / 2 : 0;
    const double x = cut.cutting_ratio * k_v * w * slip / ((u - stored) * cut.feed_speed) * dw;
    const double left = phi * std::exp(-x), mean = x > 1e-9 ? (phi - left) / x : phi;
    layer.pressure += k_v * w * mean * dw;
    layer.filled += mean * dw;
    if (phi > std::exp(-1.0)) layer.one_over_e = w;
    phi = left;
  }
  return layer;
}

TEST(CuttingForms, C21OfLawGIsTheIntegralOfItsLayerForAnyStiffness) {
  // The feed is fast enough for elastic release to matter: the rim is only 20 times faster.
  const SteadyCut cut{3e8, 0.5, 200, 5e-3};
  for (const double k_v : {1e14, 1e16}) {
    double thrust = 0;
    constexpr int kRings = 100;
    for (int i = 0; i < kRings; ++i) {
      const double rho = kR * (i + 0.5) / kRings;
      thrust += layer_at(cut, k_v, rho, true).pressure * 2 * kPi * rho * kR / kRings;
    }
    EXPECT_NEAR(thrust / forms::axial_cutting_force_with_elastic_release(cut, kR), 1, 1e-3);
  }
}

TEST(CuttingForms, C34IsTheLayerThatTheDecayLeaves) {
  const double k_v = 1e15;
  double filled = 0;
  constexpr int kRings = 400;
  for (int i = 0; i < kRings; ++i) {
    // The rings are narrower towards the axis, where the layer is thickest.
    const double rho = kR * std::pow((i + 0.5) / kRings, 2), width = 2 * kR * (i + 0.5) / (kRings * kRings);
    filled += layer_at(kCut, k_v, rho, false).filled * 2 * kPi * rho * width;
  }
  const double rim = forms::engaged_layer(kCut, k_v, kR);
  EXPECT_NEAR(filled / forms::decaying_volume_under_a_flat_head(kR, rim), 1, 1e-4);
  EXPECT_NEAR(layer_at(kCut, k_v, kR, false).one_over_e / rim, 1, 1e-3);
  EXPECT_NEAR(forms::stiffness_for_layer(kCut, rim, kR) / k_v, 1, kRounding);
}

TEST(CuttingForms, C23IsTheFeedWhoseThrustIsTheForceOfTheHand) {
  SteadyCut cut = kCut;
  cut.edge_pressure = 3e5;
  cut.viscosity = 2e8;
  const double thrust = forms::axial_cutting_force_of_a_flat_head(cut, kR);
  EXPECT_NEAR(forms::feed_of_a_flat_head_under(thrust, cut, kR) / cut.feed_speed, 1, kRounding);
  EXPECT_EQ(forms::feed_of_a_flat_head_under(0.9 * kPi * kR * kR * cut.edge_pressure, cut, kR), 0);
}

TEST(CuttingForms, C24C25OfASideAreTheIntegralOfItsPressure) {
  const double height = 0.5 * mm;
  const std::vector<MeridianPoint> side = {{kR, 1, 0, height}};
  const Vec3 feed = Vec3::UnitX();
  expect_force(integrate(kCut, side, feed), forms::slotting_wrench(kCut, kR, height));
  expect_force(integrate(kCut, side, feed, -kPi / 2, kPi / 2),
               forms::side_milling_wrench(kCut, kR, height, -kPi / 2, kPi / 2));
  expect_force(integrate(kCut, side, feed, 0, kPi / 2), forms::side_milling_wrench(kCut, kR, height, 0, kPi / 2));
  expect_force(integrate(kCut, side, feed, -1.2, 0.4), forms::side_milling_wrench(kCut, kR, height, -1.2, 0.4));
}

TEST(CuttingForms, C26C27C28OfABallAreTheIntegralOfItsPressure) {
  for (const double depth : {0.6 * kR, 1.5 * kR})
    expect_force(integrate(kCut, meridian_of_a_ball(0, std::acos(1 - depth / kR)), Vec3::UnitX()),
                 forms::groove_wrench(kCut, kR, depth));
  expect_force(integrate(kCut, meridian_of_a_ball(0, kPi), Vec3::UnitX()), forms::buried_ball_wrench(kCut, kR));
  for (const double depth : {0.4 * kR, 1.0 * kR})
    expect_force(integrate(kCut, meridian_of_a_ball(0, std::acos(1 - depth / kR)), -Vec3::UnitZ()),
                 forms::ball_plunge_wrench(kCut, kR, depth));
  EXPECT_EQ(forms::ball_plunge_wrench(kCut, kR, 5 * kR).force, forms::ball_plunge_wrench(kCut, kR, kR).force);
}

TEST(CuttingForms, C35C36C37C38C42WithChipsAreTheIntegralOfTheirPressure) {
  SteadyCut cut = kCut;
  cut.tooth_rate = 600;
  for (const auto& [edge, size] : {std::pair{0.0, 0.0}, {5e-6, 0.0}, {0.0, 9e-6}, {4e-6, 3e-6}}) {
    cut.edge_length = edge;
    cut.size_length = size;
    expect_force(integrate(cut, meridian_of_a_bottom(), -Vec3::UnitZ()), forms::axial_chip_wrench(cut, kR));
    const double height = 0.7e-3;
    const std::vector<MeridianPoint> side = {{kR, 1, 0, height}};
    expect_force(integrate(cut, side, Vec3::UnitX(), -kPi / 2, kPi / 2), forms::slotting_chip_wrench(cut, kR, height),
                 kRoots);
    expect_force(integrate(cut, meridian_of_a_ball(0, kPi / 2), -Vec3::UnitZ()),
                 forms::ball_plunge_chip_wrench(cut, kR), kRoots);
    for (const double depth : {0.3 * kR, 1.0 * kR, 1.6 * kR})
      expect_force(integrate(cut, meridian_of_a_ball(0, std::acos(1 - depth / kR)), Vec3::UnitX(), -kPi / 2, kPi / 2),
                   forms::groove_chip_wrench(cut, kR, depth), 2 * kRoots);
    const double thrust = forms::axial_chip_wrench(cut, kR).force.z();
    EXPECT_NEAR(forms::feed_with_chips_under(thrust, cut, kR) / cut.feed_speed, 1, kRounding);
  }
  EXPECT_EQ(forms::feed_with_chips_under(
                0.99 * 2 * kPi * kR * cut.specific_cutting_energy * cut.edge_speed() / (cut.cutting_ratio * cut.spin),
                cut, kR),
            0);
  cut.edge_length = cut.size_length = 0;
  EXPECT_LT((forms::groove_chip_wrench(cut, kR, 0.6 * kR).force - forms::groove_wrench(cut, kR, 0.6 * kR).force).norm(),
            1e-5 * forms::groove_wrench(cut, kR, 0.6 * kR).force.norm());
}

TEST(CuttingForms, C29OfAConeIsTheIntegralOfItsPressure) {
  const double angle = 35 * deg, depth = 0.9 * mm, slope = depth / std::cos(angle);
  std::vector<MeridianPoint> points;
  for (int i = 0; i < 300; ++i)
    points.push_back({slope * (i + 0.5) / 300 * std::sin(angle), std::cos(angle), -std::sin(angle), slope / 300});
  expect_force(integrate(kCut, points, -Vec3::UnitZ()), forms::cone_plunge_wrench(kCut, angle, depth));
}

TEST(CuttingForms, C30EveryTorquePaysForTheRemovedVolume) {
  const double h = 0.5 * mm, v = kCut.feed_speed;
  const auto expect_paid = [&](double torque, double section) {
    EXPECT_NEAR(-torque * kCut.spin / forms::cutting_power(kCut, section * v), 1, kRounding);
  };
  expect_paid(forms::axial_cutting_torque_of_a_flat_head(kCut, kR), kPi * kR * kR);
  expect_paid(forms::slotting_wrench(kCut, kR, h).torque.z(), 2 * kR * h);
  expect_paid(forms::buried_ball_wrench(kCut, kR).torque.z(), kPi * kR * kR);
  const double depth = 0.6 * kR, th = std::acos(1 - depth / kR);
  expect_paid(forms::groove_wrench(kCut, kR, depth).torque.z(), kR * kR * (th - std::sin(th) * std::cos(th)));
  expect_paid(forms::ball_plunge_wrench(kCut, kR, depth).torque.z(), kPi * std::pow(kR * std::sin(th), 2));
  expect_paid(forms::cone_plunge_wrench(kCut, 0.7, depth).torque.z(), kPi * std::pow(depth * std::tan(0.7), 2));
  expect_paid(forms::twist_drill_wrench(kCut, 2 * kR, 2).torque.z(), kPi * kR * kR);
}

TEST(CuttingForms, C31IsC20WithTheSineOfThePointInKappaAndC29WithoutIt) {
  const double point = 118 * deg;
  SteadyCut flat = kCut, cone = kCut;
  flat.cutting_ratio = 1 / std::sin(point / 2), cone.cutting_ratio = 1;
  const Wrench drill = forms::twist_drill_wrench(kCut, 2 * kR, point);
  expect_force({Vec3(0, 0, forms::axial_cutting_force_of_a_flat_head(flat, kR)),
                Vec3(0, 0, forms::axial_cutting_torque_of_a_flat_head(flat, kR))},
               drill);
  expect_force(forms::cone_plunge_wrench(cone, point / 2, kR / std::tan(point / 2)), drill);
}

TEST(CuttingForms, C32IsTheRatioOfC22WithoutAndWithNothingButEdges) {
  SteadyCut edges = kCut;
  edges.edge_pressure = 1e15;
  const auto ratio = [](const SteadyCut& cut) {
    return -forms::axial_cutting_torque_of_a_flat_head(cut, kR) / forms::axial_cutting_force_of_a_flat_head(cut, kR);
  };
  EXPECT_NEAR(ratio(kCut) / forms::torque_over_thrust_of_chips(kCut.cutting_ratio, kR), 1, kRounding);
  EXPECT_NEAR(ratio(edges) / forms::torque_over_thrust_of_edges(kCut.cutting_ratio, kR), 1, 1e-6);
}

TEST(CuttingForms, C33StepsAddUpToTheHeadAndPushLikeThePressureOfTheirLayer) {
  const double D = 0.02 * mm;
  double cone = 0, ball = 0;
  for (int i = 1; i <= 50; ++i) {
    cone += forms::step_volume_of_a_cone(45 * deg, i * D, D);
    ball += forms::step_volume_of_a_ball(kR, i * D, D);
  }
  EXPECT_NEAR(cone / (kPi / 3 * 1e-9), 1, 1e-9);
  EXPECT_NEAR(ball / (2 * kPi / 3 * 1e-9), 1, 1e-9);
  // A step presses a layer with a thickness of D times the sine of the slope. The pressure is k_v/2 times the square of
  // this thickness.
  const double depth = 0.7 * kR;
  double sum = 0;
  for (const MeridianPoint& p : meridian_of_a_ball(0, std::acos(1 - depth / kR)))
    sum += forms::surface_pressure(kStiffness, -p.n_axial * D) * -p.n_axial * 2 * kPi * p.rho * p.length;
  EXPECT_NEAR(forms::step_force_of_a_ball(kStiffness, kR, depth, D) / sum, 1, 1e-4);
  const double angle = 40 * deg, radius = depth * std::tan(angle);
  EXPECT_NEAR(forms::step_force_of_a_cone(kStiffness, angle, depth, D) /
                  (forms::surface_pressure(kStiffness, D * std::sin(angle)) * kPi * radius * radius),
              1, kRounding);
  EXPECT_NEAR(
      forms::step_force_of_a_flat_head(kStiffness, kR, D) / (forms::surface_pressure(kStiffness, D) * kPi * kR * kR), 1,
      kRounding);
  EXPECT_NEAR(forms::step_volume_of_a_flat_head(kR, D) / (kPi * kR * kR * D), 1, kRounding);
}

// The layer in small steps, from before the head is nearest until nothing is pressed.
TEST(CuttingForms, C43IsTheEndOfTheLayerBesideAPassingHead) {
  const double k_v = 2e16, decay = kCut.cutting_ratio * k_v * kCut.spin * kR / (2 * kCut.specific_cutting_energy);
  const double bend = kCut.feed_speed * kCut.feed_speed / kR, scale = std::cbrt(1 / (bend * decay));  // [m/s^2], [s]
  double tau = -8 * scale, t = std::sqrt(-bend * tau / decay);
  for (const double step = 1e-4 * scale; t > 0; tau += step) t -= step * (bend * tau + decay * t * t);
  EXPECT_NEAR(forms::wall_left_by_a_pass(kCut, k_v, kR, kR) / (bend * tau * tau / 2), 1, 1e-3);
}

TEST(OtherForms, ADroopedSpindleTurnsAsFastAsItsLoadLetsIt) {
  const double setting = 2000, power = 1.9, droop = 0.15 * setting * setting / power;
  const double speed = forms::drooped_speed(setting, droop, power);
  EXPECT_NEAR(setting - droop * power / speed, speed, 1e-9 * setting);
  EXPECT_GT(speed, setting / 2) << "the larger root";
}

}  // namespace
}  // namespace hapticut::cutting_forms_test
