// SPDX-License-Identifier: Apache-2.0
// The alternative force laws in the whole step, against their own closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "hapticut/bench/closed_forms.hpp"
#include "support/cutting.hpp"
#include "support/laws.hpp"
#include "support/static_contact.hpp"

namespace hapticut::laws_test {
namespace {

using units::deg;
using units::kPi;
using units::mm;

constexpr double kRadius = 1 * mm;
constexpr double kFeed = 2 * mm;  // [m/s]
constexpr double kSpin = 2000;    // [rad/s]

constexpr double kQuadrature = 1e-6;       // [1] of the midpoint rule with thousands of points
constexpr double kMidpointWork = 1e-4;     // [1] of a work over thousands of steps
constexpr double kEighthOfDepth = 0.03;    // [1] of a force on voxels an eighth of the depth
constexpr double kFineVoxels = 0.02;       // [1] the same for a fifth of it or less, with a form that is steeper
constexpr double kSinglePrecision = 1e-6;  // [1] of forces
constexpr double kVolumeSum = 1e-3;        // [1] of a volume and a depth that are reported in single precision
constexpr double kThinLayer = 0.03;        // [1] of an engaged layer of a tenth of the radius

Simulation over_half_space(const std::shared_ptr<const ForceLaw>& law, const ToolHead& head, double depth,
                           double voxel = 0.05 * mm) {
  SimulationConfig config = test::static_config();
  config.law = law;
  const Box box = test::half_space(head.largest_radius(), depth, voxel);
  return Simulation(test::box_at_phase(box, voxel, Vec3(0.3, 0.6, 0.2)), Tool(head), config);
}

/// Height of the origin of a head whose tip is `depth` below z = 0.
Vec3 at_depth(const ToolHead& head, double depth) { return {0, 0, -depth - head.bounding_box().min.z()}; }

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

TEST(ContactMechanics, EnergyIsTheWorkOfTheForce) {
  const ContactMechanicsLaw law(3e6);
  for (const ToolHead& head :
       {ToolHead(SphereHead{kRadius}), ToolHead(ConeHead{0.6, 2 * mm}), ToolHead(FlatHead{kRadius, 2 * mm})}) {
    double work = 0;
    constexpr int kSteps = 2000;
    for (int i = 0; i < kSteps; ++i) work += law.force(head, 0.3 * mm * (i + 0.5) / kSteps) * 0.3 * mm / kSteps;
    EXPECT_NEAR(law.energy(head, 0.3 * mm) / work, 1, kMidpointWork);
  }
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

// Voxels of an eighth of the depth: on a misaligned grid a volume of 2 % off makes a force of up to 3 %, and a side
// force.
// Proves: contact mechanics.
TEST(ContactMechanics, OfTheStepIsTable51) {
  const ContactMechanicsLaw law(3e6);
  const double d = 0.4 * mm;
  for (const ToolHead& head :
       {ToolHead(SphereHead{kRadius}), ToolHead(ConeHead{50 * deg, 2 * mm}), ToolHead(FlatHead{kRadius, 2 * mm})}) {
    Simulation simulation = over_half_space(std::make_shared<ContactMechanicsLaw>(law), head, d);
    const StepResult& result = test::hold(simulation, at_depth(head, d));
    EXPECT_NEAR(result.force.z() / law.force(head, d), 1, kEighthOfDepth);
    EXPECT_LT(result.force.head<2>().norm(), 0.02 * result.force.z());
  }
}

// --- Hertzian burr ---------------------------------------------------------------------------------------------------

// Proves: Hertzian burr.
TEST(HertzianBurr, ForceOfTheStepIsThatOfItsDepth) {
  const HertzianBurrLaw law(2e6);
  for (const double d : {0.2 * mm, 0.5 * mm}) {
    Simulation simulation = over_half_space(std::make_shared<HertzianBurrLaw>(law), SphereHead{kRadius}, d);
    const StepResult& result = test::hold(simulation, at_depth(SphereHead{kRadius}, d));
    EXPECT_NEAR(result.force.z() / closed_forms::hertzian_burr_force(2e6, kRadius, d), 1, kFineVoxels);
    EXPECT_LT(result.torque.norm(), 0.01 * kRadius * result.force.z()) << "normal to a ball: no arm";
  }
}

// The mass flux alpha mu P omega r, over the contact, is the power of the friction over the cost of a volume. With the
// spindle parallel to the surface, omega r is the rim speed omega R (up to the size of the contact).
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

// --- damping matrix (5.1, 5.2) ---------------------------------------------------------------------------------------

// Proves: damping matrix.
TEST(DampingMatrix, ResistsAlongTheMotionAndTurnsAPartOfItAcrossWithTheSpin) {
  const double mu = 0.4;
  for (const double spin : {500.0, -500.0}) {
    SimulationConfig config;
    config.law = std::make_shared<DampingMatrixLaw>(DampingMatrixLaw::Constants{2e8, mu});
    config.removal = RemovalLaw::none;
    Simulation simulation(build_block({Vec3(-2, -2, -2) * mm, Vec3(2, 2, 0) * mm}, 0.1 * mm, test::plain_material()),
                          Tool(SphereHead{kRadius}, RayHandle{0}, Spindle{spin * units::rad_per_s}), config);
    Pose pose = Pose::from_translation(Vec3(0, 0, 0.7 * mm));
    (void)simulation.step(pose, {}, 1e-3);
    pose.translation.x() += 5e-6;
    const StepResult& result = simulation.step(pose, {}, 1e-3);
    const double area = result.contact.volume / result.contact.depth;
    EXPECT_NEAR(result.force.x() / (-2e8 * area * 5e-3), 1, kVolumeSum);
    EXPECT_NEAR(result.force.y() / result.force.x(), std::copysign(mu, spin), kSinglePrecision)
        << "-m mu omega_hat x V";
    EXPECT_NEAR(result.force.z(), 0, 1e-9);
    EXPECT_EQ(simulation.step(pose, {}, 1e-3).force, Vec3(0, 0, 0)) << "no motion, no force";
  }
}

// --- twist drill (C31) -----------------------------------------------------------------------------------------------

test::SteadyState drill(const std::shared_ptr<const ForceLaw>& law, const ToolHead& head, double kappa, double travel) {
  SimulationConfig config;
  config.law = law;
  config.reference_stiffness = 1e14;
  Material material = test::plain_material();
  material.cutting_ratio = kappa;
  Simulation simulation(build_block({Vec3(-1.3, -1.3, -3.5) * mm, Vec3(1.3, 1.3, 0) * mm}, 0.1 * mm, material),
                        Tool(head, RayHandle{0}, Spindle{kSpin * units::rad_per_s}), config);
  return test::feed(simulation, Vec3(0.029, 0.011, 0.01) * mm, Vec3(0, 0, -kFeed), travel, 1e-3, 0.8);
}

// Proves: twist drill.
TEST(TwistDrill, C31OfTheStepIsItsFormulaAndRemovesTheFedVolume) {
  const double a = 2 * kPi * kFeed / kSpin, u = 3e8, travel = 2 * mm;
  const TwistDrillLaw law({u});
  EXPECT_NEAR(law.torque(2 * kRadius, a) * kSpin,
              closed_forms::cutting_power({u, 1, kSpin, kFeed}, kPi * kRadius * kRadius * kFeed), 1e-9)
      << "M omega is what the fed volume costs";
  const auto cut = drill(std::make_shared<TwistDrillLaw>(law), FlatHead{kRadius, 4 * mm}, 0.5, travel);
  // The drill takes as its radius that of the outermost voxel centre in material, up to a voxel too little.
  const double voxel = 0.1;  // of the radius
  EXPECT_NEAR(cut.force.z() / law.thrust(2 * kRadius, a, kPi), 1, voxel);
  EXPECT_LE(cut.force.z(), law.thrust(2 * kRadius, a, kPi) * (1 + 1e-9));
  EXPECT_NEAR(-cut.torque.z() / law.torque(2 * kRadius, a), 1, 2 * voxel);
  EXPECT_NEAR(cut.removed_volume / (kPi * kRadius * kRadius * travel), 1, 2 * voxel);
}

// The default law, with kappa = 1/sin(beta/2) and no edge pressure, arrives at the same steady state.
// Proves: twist drill.
TEST(TwistDrill, C31IsTheSteadyStateOfTheDefaultLaw) {
  const double a = 2 * kPi * kFeed / kSpin, u = 3e8;
  const TwistDrillLaw law({u});
  const auto flat =
      drill(std::make_shared<FoundationLaw>(), FlatHead{kRadius, 4 * mm, FlatRule::bottom_only}, 1, 2 * mm);
  EXPECT_NEAR(flat.force.z() / law.thrust(2 * kRadius, a, kPi), 1, kThinLayer);
  EXPECT_NEAR(-flat.torque.z() / law.torque(2 * kRadius, a), 1, kThinLayer);
}

// C32: the ratio of torque and thrust of a flat head is kappa R/2 without edge pressure.
// Proves: twist drill.
TEST(TwistDrill, C32TheRatioOfTorqueToThrustIsKappaRHalf) {
  const auto flat =
      drill(std::make_shared<FoundationLaw>(), FlatHead{kRadius, 4 * mm, FlatRule::bottom_only}, 0.7, 2 * mm);
  EXPECT_NEAR(-flat.torque.z() / flat.force.z() / closed_forms::torque_over_thrust_of_chips(0.7, kRadius), 1,
              kThinLayer);
}

}  // namespace
}  // namespace hapticut::laws_test
