// SPDX-License-Identifier: Apache-2.0
// A ball pressed into a half space, with the spindle standing: closed forms C1-C3, C10, C12, C14 and C15.
#include <gtest/gtest.h>

#include "hapticut/bench/closed_forms.hpp"
#include "support/static_contact.hpp"

namespace hapticut::static_sphere_test {
namespace {

namespace forms = closed_forms;
using test::box_at_phase;
using test::converge;
using test::Convergence;
using test::expect_convergence;
using test::half_space;
using test::hold;
using test::kStiffness;
using test::materials_of_stiffness;
using test::static_config;
using units::mm;

constexpr double kRadius = 1 * mm;
constexpr double kCoarsest = 0.1 * mm;  // voxel size, then 0.05 and 0.025 mm

// The order is that of a root mean square over twelve phases, which is known to about 0.2.
constexpr double kSecondOrder = 1.7;

/// [1] The error of the force, over (l/d)^2: root mean square over the fills f of the voxels that the surface z = 0
/// cuts.
///
/// A whole voxel has the spring of its centre, not the mean over it; a cut one has the direction of its centre, not of
/// its filled part, and that part is taken to lie beyond a plane across n. Together that is k_v l^2 (pi/12) d^2
/// (1 - 6 f (1 - f)), which vanishes in the mean; 6 f (1 - f) deviates from 1 by sqrt(0.2). Where the ball's centre is
/// below z = 0 the material lies on the near side of the plane, not beyond it: k_v l^2 f (1 - f) times the integral of
/// |n_z| over the surface, 2 pi (d - R) (2 R - d), in the mean a sixth of that.
double error_of_cap(double R, double d) {
  const double error = d <= R ? std::sqrt(0.2) * units::kPi / 12 * d * d : units::kPi / 3 * (d - R) * (2 * R - d);
  return error * d * d / forms::cap_force(1, R, d);
}

Simulation press_ball(double depth, double voxel_size, const Vec3& phase, const Handle& handle = RayHandle{0},
                      MaterialTable materials = materials_of_stiffness({1}),
                      const test::MaterialAt& material_at = nullptr) {
  return Simulation(
      box_at_phase(half_space(kRadius, depth, voxel_size), voxel_size, phase, std::move(materials), material_at),
      Tool(SphereHead{kRadius}, handle), static_config());
}

Vec3 center_at(double depth) { return {0, 0, kRadius - depth}; }

class BallDepth : public testing::TestWithParam<double> {
 protected:
  const double depth_ = GetParam() * kRadius;
};

// Proves: normal force.
TEST_P(BallDepth, C1ForceIsThatOfTheCap) {
  const double expected = forms::cap_force(kStiffness, kRadius, depth_);
  const Convergence c = converge(kCoarsest, [&](double l, const Vec3& phase) {
    Simulation simulation = press_ball(depth_, l, phase);
    return (hold(simulation, center_at(depth_)).force - Vec3(0, 0, expected)).norm() / expected;
  });
  const double constant = error_of_cap(kRadius, depth_);
  expect_convergence(c, kSecondOrder, 1.2 * constant, depth_);
  EXPECT_NEAR(c.error[2] / (constant * std::pow(c.size[2] / depth_, 2)), 1, 0.3);  // of twelve phases
}

// Proves: torque.
TEST_P(BallDepth, C14TorqueAboutTheCentreVanishesAndTheHandleFeelsTheArmOnThreeGrids) {
  const Handle bent = LHandle{12 * mm, 5 * mm, 1.1};
  const Pose X_WT = {rotation_from_vector(Vec3(0.3, -0.8, 0.5)), center_at(depth_)};
  for (const double l : {kCoarsest, kCoarsest / 2, kCoarsest / 4}) {
    Simulation simulation = press_ball(depth_, l, test::phase(1), bent);
    Simulation straight = press_ball(depth_, l, test::phase(1));
    const Pose X_WH = X_WT * simulation.tool().X_HT().inverse();
    const StepResult& felt = hold(simulation, X_WH);
    const StepResult& at_center = hold(straight, X_WT);
    const double force = felt.force.norm();
    // Every spring points at the centre, on any grid. Single-precision samples: rounding only.
    EXPECT_LT(at_center.torque.norm(), 1e-6 * force * kRadius) << "l = " << l / mm << " mm";
    EXPECT_LT((felt.torque - forms::ball_torque(X_WT.translation - X_WH.translation, felt.force)).norm(),
              1e-6 * force * 13 * mm);
  }
}

INSTANTIATE_TEST_SUITE_P(Depths, BallDepth, testing::Values(0.2, 0.5, 1.0, 1.4), [](const auto& depth) {
  return std::to_string(int(depth.param * 100 + 0.5)) + "PercentOfTheRadius";
});

/// Derivative of the force from five depths 0.1 R apart: exact for C1, a quartic, so that only voxels make errors.
double stiffness_at(Simulation& simulation, double depth) {
  const double h = 0.1 * kRadius;
  const auto force = [&](double d) { return hold(simulation, center_at(d)).force.z(); };
  return (8 * (force(depth + h) - force(depth - h)) - (force(depth + 2 * h) - force(depth - 2 * h))) / (12 * h);
}

TEST(Ball, C2StiffnessConvergesToThatOfTheCap) {
  for (const double depth : {0.4 * kRadius, 0.7 * kRadius}) {
    const double expected = forms::cap_stiffness(kStiffness, kRadius, depth);
    expect_convergence(converge(kCoarsest,
                                [&](double l, const Vec3& phase) {
                                  Simulation simulation = press_ball(kRadius, l, phase);
                                  return stiffness_at(simulation, depth) / expected - 1;
                                }),
                       kSecondOrder, 1.0, kRadius);
  }
}

TEST(Ball, C2IsStiffestAtTwoThirdsOfTheRadius) {
  Simulation simulation = press_ball(kRadius, 0.025 * mm, test::phase(2));
  double stiffest = 0, at = 0;
  for (double depth = 0.3 * kRadius; depth < 0.8 * kRadius; depth += 0.02 * kRadius) {
    const double stiffness = stiffness_at(simulation, depth);
    if (stiffness > stiffest) stiffest = stiffness, at = depth;
  }
  EXPECT_NEAR(stiffest / forms::largest_cap_stiffness(kStiffness, kRadius), 1, 0.005);
  EXPECT_NEAR(at / kRadius, 2.0 / 3, 0.05);
}

TEST(Ball, C3StoredEnergyIsThatOfTheCap) {
  for (const double depth : {0.2 * kRadius, 0.5 * kRadius, 1.0 * kRadius}) {
    const double expected = forms::cap_energy(kStiffness, kRadius, depth);
    // As that of the force: k_v l^2 (pi/36) d^3 (1 - 6 f (1 - f)).
    const double constant = std::sqrt(0.2) * kStiffness * units::kPi / 36 * std::pow(depth, 5) / expected;
    expect_convergence(converge(kCoarsest,
                                [&](double l, const Vec3& phase) {
                                  Simulation simulation = press_ball(depth, l, phase);
                                  return hold(simulation, center_at(depth)).energy.elastic / expected - 1;
                                }),
                       kSecondOrder, 1.2 * constant, depth);
  }
}

TEST(Ball, C3TheHandPaysForTheStoredEnergy) {
  const double depth = 0.5 * kRadius;
  Simulation simulation = press_ball(depth, 0.025 * mm, test::phase(3));
  for (int i = 0; i <= 500; ++i) (void)simulation.step(Pose::from_translation(center_at(depth * i / 500)), {}, 1e-3);
  const EnergyLedger& energy = simulation.last_result().energy;
  EXPECT_NEAR(energy.hand_work / forms::cap_energy(kStiffness, kRadius, depth), 1, 2e-3);
  EXPECT_NEAR((energy.hand_work + energy.entered) / energy.elastic, 1, 1e-5);
  // A section is at least 0.3 wide, and stores what its normal near the grid's axis must not.
  EXPECT_LT(std::abs(energy.entered), 0.01 * std::pow(0.025 * mm / depth, 2) * energy.elastic);
}

// What was given in and taken out again was turned over too: the rest is not all of it.
TEST(Ball, TheLedgerOfAPressThatIsLiftedOutIsClosed) {
  const double depth = 0.3 * kRadius;
  Simulation simulation = press_ball(depth, 0.05 * mm, test::phase(3));
  double given = 0, last = 0, turned = 0;  // [J]
  for (int i = 0; i <= 200; ++i) {
    const double deep = depth * std::min(i, 200 - i) / 100 - 0.01 * depth;
    const EnergyLedger& energy = simulation.step(Pose::from_translation(center_at(deep)), {}, 1e-3).energy;
    given += std::max(0.0, energy.hand_work - last);
    last = energy.hand_work;
    EXPECT_GE(energy.turnover, turned);
    turned = energy.turnover;
  }
  const EnergyLedger& energy = simulation.last_result().energy;
  EXPECT_EQ(energy.elastic, 0) << "it is out again";
  EXPECT_LT(std::abs(energy.hand_work), 1e-3 * given);
  EXPECT_GT(energy.turnover, 1.99 * given);
  EXPECT_LT(fixtures::unbooked(energy), 1e-5);
  EXPECT_EQ(energy.closure(), energy.imbalance() / energy.turnover);
}

// --- layers -----------------------------------------------------------------------------------------------------

struct Layers {
  double first, second;  // [1] relative stiffness; second 0: nothing below the first layer
  double thickness;      // [m] of the first
};

double layered_force(const Layers& layers, double depth) {
  return forms::layered_cap_force(layers.first * kStiffness, layers.second * kStiffness, layers.thickness, kRadius,
                                  depth);
}

/// @param interface_on_grid  the layers meet on a face of the voxels
Convergence press_into_layers(const Layers& layers, double depth, bool interface_on_grid) {
  return converge(kCoarsest, [&](double l, const Vec3& phase) {
    Vec3 p = phase;
    if (interface_on_grid) p.z() = -layers.thickness / l;
    const bool breaks_through = layers.second == 0;
    Box box = half_space(kRadius, depth, l);
    if (breaks_through) box.min.z() = -layers.thickness;
    Simulation simulation(
        box_at_phase(box, l, p, materials_of_stiffness({layers.first, breaks_through ? 1 : layers.second}),
                     [&](const Vec3& p_WQ) { return MaterialId(p_WQ.z() > -layers.thickness ? 1 : 2); }),
        Tool(SphereHead{kRadius}), static_config());
    return hold(simulation, center_at(depth)).force.z() / layered_force(layers, depth) - 1;
  });
}

// Proves: layers and grades.
TEST(Ball, C10LayersThatMeetOnAVoxelFaceConvergeWithSecondOrder) {
  // 0.33 (l/d)^2 by the fluxes of error_of_cap, which no longer cancel where the stiffness changes.
  expect_convergence(press_into_layers({1, 0.2, 0.267 * kRadius}, 0.7 * kRadius, true), kSecondOrder, 0.4,
                     0.7 * kRadius);
}

// A voxel is of one material: where layers meet inside it, the interface is off by up to half a voxel, which is first
// order, l/4 in the root mean square times the change of stiffness there.
TEST(Ball, C10LayersThatMeetInsideVoxelsConvergeWithFirstOrder) {
  const double depth = 0.7 * kRadius;
  expect_convergence(press_into_layers({1, 0.2, 0.267 * kRadius}, depth, false), 0.7,
                     [&](double l) { return 0.8 * l / depth; });
}

TEST(Ball, C10BreakthroughLeavesTheForceOfTheShell) {
  const double thickness = 0.267 * kRadius, depth = 0.7 * kRadius, below = kRadius - depth + thickness;
  // Of the plate's lower face the material lies on the near side (error_of_cap).
  const double near_side = units::kPi / 3 * below * (kRadius - below) * kStiffness;
  expect_convergence(press_into_layers({1, 0, thickness}, depth, false), kSecondOrder,
                     1.2 * near_side * thickness * thickness / layered_force({1, 0, thickness}, depth), thickness);
}

TEST(Ball, C10TheLibrarysSlabHasTheForceOfItsLayers) {
  Material hard, soft;
  hard.name = "hard", soft.name = "soft", soft.relative_stiffness = 0.2;
  const double l = 0.025 * mm, depth = 0.7 * kRadius, side = 1.1 * kRadius;
  // The grid of the slab starts at the box's lower corner: the layers meet on the face of a voxel, 16 above it.
  const Layers layers = {1, 0.2, 0.2675 * kRadius};
  const Box box = {Vec3(-side - 0.3 * l, -side - 0.6 * l, -layers.thickness - 32 * l), Vec3(side, side, 0)};
  Simulation simulation(build_layered_slab(box, l, {{hard, layers.thickness}, {soft, 2 * kRadius}}),
                        Tool(SphereHead{kRadius}), static_config());
  EXPECT_NEAR(hold(simulation, center_at(depth)).force.z() / layered_force(layers, depth), 1, 1e-3);
}

// --- graded stiffness -------------------------------------------------------------------------------------------

/// k_v = kStiffness (1 + slope . p) for p in the half space.
struct Grade {
  Vec3 slope;  // [1/m]
  [[nodiscard]] double stiffness(const Vec3& p) const { return 1 + slope.dot(p); }
};

Vec3 graded_force(const Grade& grade, double depth) {
  return forms::graded_cap_force(kStiffness, kStiffness * grade.slope, kRadius, depth);
}

// Proves: layers and grades.
TEST(Ball, C12StiffnessThatGrowsWithDepthAddsTheEnergyTimesItsSlope) {
  const double depth = 0.7 * kRadius;
  const Grade grade = {Vec3(0, 0, -2 / mm)};
  const Vec3 expected = graded_force(grade, depth);
  const auto error = [&](double l, const Vec3& phase) {
    // One material for each layer of voxels, as stiff as the grade is at the middle of the layer.
    std::vector<double> stiffnesses;
    const double first_face = (phase.z() - 1) * l;  // the lower face of the partly filled layer
    stiffnesses.push_back(grade.stiffness(Vec3(0, 0, first_face / 2)));
    for (double face = first_face; face > -depth - 3 * l; face -= l)
      stiffnesses.push_back(grade.stiffness(Vec3(0, 0, face - l / 2)));
    const auto layer = [&](const Vec3& p) { return MaterialId(1 + std::max(0, int((first_face - p.z()) / l + 1))); };
    Simulation simulation = press_ball(depth, l, phase, RayHandle{0}, materials_of_stiffness(stiffnesses), layer);
    return (hold(simulation, center_at(depth)).force - expected).norm() / expected.norm();
  };
  expect_convergence(converge(kCoarsest, error), kSecondOrder, 0.5, depth);
}

//
// A whole voxel has the stiffness of its centre and lacks -l^2/12 of grad(k) . grad(w n) too: 0.19 (l/d)^2 with the
// fills of error_of_cap.
TEST(Ball, C12StiffnessThatGrowsSidewaysPushesTheBallToTheSofterSide) {
  const double depth = 0.7 * kRadius;
  const Grade grade = {Vec3(0.6 / mm, -0.3 / mm, -0.5 / mm)};
  const Vec3 expected = graded_force(grade, depth);
  // A whole table of materials, in equal steps of stiffness from 0 to 3: half a step is 0.006, with either sign all
  // over the contact, so that it averages out.
  constexpr int kSteps = kMaxMaterials;
  std::vector<double> stiffnesses;
  for (int i = 0; i < kSteps; ++i) stiffnesses.push_back(3 * (i + 0.5) / kSteps);
  const auto step = [&](const Vec3& p) {
    return MaterialId(1 + std::clamp(int(grade.stiffness(p) / 3 * kSteps), 0, kSteps - 1));
  };
  const auto error = [&](double l, const Vec3& phase) {
    Simulation simulation = press_ball(depth, l, phase, RayHandle{0}, materials_of_stiffness(stiffnesses), step);
    return (hold(simulation, center_at(depth)).force - expected).norm() / expected.norm();
  };
  expect_convergence(converge(kCoarsest, error), kSecondOrder, 0.21, depth);
}

// --- damping ----------------------------------------------------------------------------------------------------

constexpr double kDamping = 20;  // [s/m] chi

double damping_force(double depth, double speed) {
  return forms::ball_damping_force(kStiffness, kDamping, kRadius, depth, speed);
}

MaterialTable damped_material() {
  Material material;
  material.name = "damped";
  material.damping = kDamping;
  return MaterialTable({material});
}

// Proves: damping.
TEST(Ball, C15DampingForceOfAnApproachingBall) {
  const double speed = 0.02;  // [m/s]
  for (const double depth : {0.3 * kRadius, 0.8 * kRadius})
    expect_convergence(
        converge(
            kCoarsest,
            [&](double l, const Vec3& phase) {
              Simulation simulation = press_ball(depth, l, phase, RayHandle{0}, damped_material());
              const double still = hold(simulation, center_at(depth)).force.z();
              const double moving = hold(simulation, center_at(depth), {Vec3(0, 0, -speed), Vec3::Zero()}).force.z();
              return (moving - still) / damping_force(depth, speed) - 1;
            }),
        kSecondOrder, 0.3, depth);
}

TEST(Ball, C15HoldsAlongARealDescentAndItsWorkIsInTheLedger) {
  const double speed = 0.02, dt = 1e-4, l = 0.025 * mm, depth = 0.8 * kRadius;
  Simulation simulation = press_ball(depth, l, test::phase(4), RayHandle{0}, damped_material());
  const Twist velocity = {Vec3(0, 0, -speed), Vec3::Zero()};
  double expected_loss = 0;  // [J]
  for (int i = 1; speed * dt * i <= depth; ++i) {
    const StepResult& result = simulation.step(Pose::from_translation(center_at(speed * dt * i)), velocity, dt);
    const double middle = speed * dt * (i - 0.5);
    expected_loss += damping_force(middle, speed) * speed * dt;
    if (middle < 0.3 * kRadius) continue;
    // 0.5 (l/d)^2 of C15 at d = 0.3 R
    EXPECT_NEAR(result.force.z() / (forms::cap_force(kStiffness, kRadius, middle) + damping_force(middle, speed)), 1,
                0.004);
  }
  const EnergyLedger& energy = simulation.last_result().energy;
  EXPECT_NEAR(energy.damping / expected_loss, 1, 2e-3);
  EXPECT_LT(fixtures::unbooked(energy), 1e-5);
}

// Proves: damping.
TEST(Ball, C15DampingNeverPullsARetreatingBallIn) {
  const double depth = 0.5 * kRadius;
  Simulation simulation = press_ball(depth, kCoarsest, test::phase(5), RayHandle{0}, damped_material());
  const double still = hold(simulation, center_at(depth)).force.z();
  for (const double speed : {0.01, 0.05, 0.1, 1.0}) {  // by 1/(1 + chi v c), c from 1/2 at the rim to 1 at the tip
    const double force = hold(simulation, center_at(depth), {Vec3(0, 0, speed), Vec3::Zero()}).force.z();
    EXPECT_GT(force, still / (1 + kDamping * speed)) << speed << " m/s";
    EXPECT_LT(force, still / (1 + kDamping * speed / 2)) << speed << " m/s";
  }
}

}  // namespace
}  // namespace hapticut::static_sphere_test
