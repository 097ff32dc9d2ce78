// SPDX-License-Identifier: Apache-2.0
// The formulas of contact mechanics against integrals, the layers of the thesis, and the erosion of the Hertzian burr.
// Rows of `hapticut validate` test each law in the step.
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/setup/cutting.hpp"
#include "experiments/setup/static_contact.hpp"
#include "support/laws.hpp"

namespace hapticut::laws_test {
namespace {

using test::kRadius;
using units::deg;
using units::kPi;
using units::mm;

constexpr double kQuadrature = 1e-6;       // [1] error of the midpoint rule with thousands of points
constexpr double kSinglePrecision = 1e-4;  // [1] error of sums of some thousand forces
constexpr double kFineVoxels = 0.02;       // [1] error of sums of a fifth as many forces, with a steeper form

// --- contact mechanics (Table 5.1) -----------------------------------------------------------------------------------

/// Sneddon's force on a punch of profile f(r) with slope f'(r), by quadrature: the contact radius a follows from
/// d = a Int f'/sqrt(a^2 - r^2) dr, and F = 2 E* Int r^2 f'/sqrt(a^2 - r^2) dr.
double sneddon(const std::function<double(double)>& slope, double depth, double modulus) {
  const auto integral = [&](double a, int power) {
    constexpr int kPoints = 4000;
    double sum = 0;
    for (int i = 0; i < kPoints; ++i) {
      const double r = a * std::sin((i + 0.5) / kPoints * kPi / 2);
      sum += std::pow(r, power) * slope(r) * kPi / 2 / kPoints;
    }
    return sum;
  };
  double low = 0, high = 1;
  for (int n = 0; n < 100; ++n) {
    const double a = 0.5 * (low + high);
    (a * integral(a, 0) < depth ? low : high) = a;
  }
  return 2 * modulus * integral(low, 2);
}

// Proves: contact mechanics.
TEST(ContactMechanics, FormulasAreThoseOfSneddonsIntegrals) {
  const double E = 3e6, d = 0.05 * mm;
  const ContactMechanicsLaw law(E);
  // A paraboloid of curvature 1/R stands for the sphere, as in Hertz's theory.
  EXPECT_NEAR(law.force(SphereHead{kRadius}, d) / sneddon([](double r) { return r / kRadius; }, d, E), 1, kQuadrature);
  for (const double angle : {30 * deg, 60 * deg, 80 * deg})
    EXPECT_NEAR(law.force(ConeHead{angle, 3 * mm}, d) / sneddon([=](double) { return 1 / std::tan(angle); }, d, E), 1,
                kQuadrature);
  // Boussinesq: pressure E* d / (pi sqrt(R^2 - r^2)) over the disk.
  double flat = 0;
  constexpr int kPoints = 1000;
  for (int i = 0; i < kPoints; ++i)
    flat += 2 * kPi * kRadius * std::sin((i + 0.5) / kPoints * kPi / 2) * E * d / kPi * kPi / 2 / kPoints;
  EXPECT_NEAR(law.force(FlatHead{kRadius, 1 * mm}, d) / flat, 1, kQuadrature);
}

TEST(ContactMechanics, DepthIsThatOfTheHalfSpaceThatFillsTheSameVolume) {
  const SphereHead ball{kRadius};
  for (const double d : {0.01, 0.3, 1.0, 1.7, 1.99}) {
    const double h = d * mm, volume = kPi * h * h * (kRadius - h / 3);
    EXPECT_NEAR(ContactMechanicsLaw::depth_of(ball, volume) / h, 1, kQuadrature);
  }
  EXPECT_NEAR(ContactMechanicsLaw::depth_of(ConeHead{45 * deg, 2 * mm}, kPi / 3 * std::pow(0.5 * mm, 3)), 0.5 * mm,
              1e-12);
  EXPECT_NEAR(ContactMechanicsLaw::depth_of(FlatHead{kRadius, 2 * mm}, kPi * 1e-6 * 0.5 * mm), 0.5 * mm, 1e-12);
}

// --- the law of the thesis -------------------------------------------------------------------------------------------

// Proves: layers and grades; law of the thesis.
TEST(ThesisLaw, ForceFollowsTheStiffnessOfEachVoxel) {
  SimulationConfig config = test::static_config();
  config.law = std::make_shared<ThesisLaw>(ThesisLaw::Constants{});
  const auto layered = [&](double left, double right) {
    Simulation simulation(test::box_at_phase({Vec3(-1.2, -1.2, -0.8) * mm, Vec3(1.2, 1.2, 0) * mm}, 0.1 * mm,
                                             Vec3::Zero(), test::materials_of_stiffness({left, right}),
                                             [](const Vec3& p) { return MaterialId(p.x() < 0 ? 1 : 2); }),
                          Tool(SphereHead{1 * mm}), config);
    return test::rest_ok_at(simulation, Vec3(0, 0, 0.6 * mm)).force;
  };
  const Vec3 equal = layered(0.5, 0.5), unequal = layered(0.3, 0.7);
  EXPECT_NEAR(unequal.z() / equal.z(), 1, kSinglePrecision) << "the halves have equal weights";
  EXPECT_LT(unequal.x(), -0.01 * equal.z()) << "the stiffer half pushes the tool away";
  EXPECT_NEAR(equal.x(), 0, kSinglePrecision * equal.z());
}

// --- Hertzian burr ---------------------------------------------------------------------------------------------------

// The mass flux alpha mu P omega r, over the contact, is the power of the friction over the specific cutting energy.
// With the spindle parallel to the surface, omega r is the rim speed omega R (up to the size of the contact).
// Proves: Hertzian burr.
TEST(HertzianBurr, ErodesThePowerOfItsFrictionOverTheCuttingEnergy) {
  const double spin = 3000, u = 3e8, kappa = 0.5;
  SimulationConfig config;
  config.law = std::make_shared<HertzianBurrLaw>(2e6);
  Simulation simulation(build_block({Vec3(-2, -2, -2) * mm, Vec3(2, 2, 0) * mm}, 0.05 * mm, test::plain_material()),
                        Tool(SphereHead{kRadius}, RayHandle{0}, Spindle{spin * units::rad_per_s}), config);
  Pose pose{rotation_from_vector(Vec3(90 * deg, 0, 0)), Vec3(0, 0, kRadius)};
  double removed = 0, expected = 0;
  for (int i = 0; i < 200; ++i) {
    pose.translation.z() -= 1e-6;
    const StepResult& result = simulation.step(pose, {}, 1e-3);
    removed += result.removed_volume;
    expected += kappa * result.force.z() * spin * kRadius * 1e-3 / u;
  }
  const EnergyLedger& e = simulation.last_result().energy;
  EXPECT_NEAR((removed * u - e.credited) / (e.motor_work + e.hand_work - e.elastic - e.rubbing - e.released), 1,
              kFineVoxels);
  EXPECT_LT(e.rubbing, 0.1 * e.cutting);
  EXPECT_NEAR(removed / expected, 1, 0.1) << "the contact is 0.4 R wide, so the mean omega r is a little smaller";
}

}  // namespace
}  // namespace hapticut::laws_test
