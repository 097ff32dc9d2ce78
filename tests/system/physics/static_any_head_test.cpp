// SPDX-License-Identifier: Apache-2.0
// What every head whose depth vanishes on its surface has in common, with the spindle standing: C13, C16 and C19.
#include <gtest/gtest.h>

#include "hapticut/bench/closed_forms.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "support/random_pose.hpp"
#include "support/static_contact.hpp"

namespace hapticut::static_any_head_test {
namespace {

using test::box_at_phase;
using test::converge;
using test::expect_convergence;
using test::half_space;
using test::hold;
using test::kStiffness;
using test::static_config;
using units::deg;
using units::kPi;
using units::mm;

/// A head, and its depth on the section at height z above its lowest point, from the distance to its axis.
struct HeadCase {
  const char* name;
  ToolHead head;
  std::function<double(double rho, double z)> depth;
};

void PrintTo(const HeadCase& c, std::ostream* out) { *out << c.name; }

HeadCase ball() {
  const double R = 0.9 * mm;
  return {"Ball", SphereHead{R}, [=](double rho, double z) { return R - std::hypot(rho, z - R); }};
}
HeadCase cone() {
  const double a = 35 * deg, H = 1.3 * mm;
  return {"Cone", ConeHead{a, H}, [=](double rho, double z) { return z * std::sin(a) - rho * std::cos(a); }};
}
HeadCase flat() {
  const double R = 0.8 * mm, H = 1.4 * mm;
  return {"Flat", FlatHead{R, H}, [=](double rho, double z) { return std::min(z, R - rho); }};
}
HeadCase flat_bottom() {
  const double R = 0.8 * mm, H = 1.4 * mm;
  return {"FlatBottomOnly", FlatHead{R, H, FlatRule::bottom_only},
          [=](double rho, double z) { return rho < R ? z : 0.0; }};
}

HeadCase round_end() {
  const double R = 0.8 * mm, H = 1.4 * mm;
  return {"RoundEnd", round_end_cylinder_head(2 * R, H),
          [=](double rho, double z) { return R - std::hypot(rho, std::min(0.0, z - R)); }};
}

const auto kName = [](const auto& c) { return std::string(c.param.name); };

/// Pose of the head's origin with its lowest point `depth` below the surface.
Vec3 origin_at(const ToolHead& head, double depth) { return {0, 0, -depth - head.bounding_box().min.z()}; }

class AxialPress : public testing::TestWithParam<HeadCase> {};

// Proves: normal force.
TEST_P(AxialPress, C16ForceIsThePressureOnTheSection) {
  const HeadCase& c = GetParam();
  const double reach = c.head.largest_radius();
  for (const double depth : {0.3 * mm, 0.6 * mm}) {
    const double expected = closed_forms::section_force(
        kStiffness, [&](double rho) { return c.depth(rho, depth); }, reach);
    const bool has_rim = std::holds_alternative<FlatHead>(c.head.shape());
    // C1, C4: at most 0.7 (l/d)^2. C5, C6: lattice points in the disk, 1.5th order, and the end of the springs at z =
    // 0.
    const auto bound = [&](double l) {
      return has_rim ? 0.7 * std::pow(l / reach, 1.5) + 0.4 * std::pow(l / depth, 2) : 0.7 * std::pow(l / depth, 2);
    };
    expect_convergence(converge(0.08 * mm,
                                [&](double l, const Vec3& phase) {
                                  Simulation simulation(box_at_phase(half_space(reach, depth, l), l, phase),
                                                        Tool(c.head), static_config());
                                  return hold(simulation, origin_at(c.head, depth)).force.z() / expected - 1;
                                }),
                       has_rim ? 1.25 : 1.7, bound);
  }
}

INSTANTIATE_TEST_SUITE_P(Heads, AxialPress, testing::Values(ball(), cone(), flat(), flat_bottom(), round_end()), kName);

// --- closed paths -----------------------------------------------------------------------------------------------

class ClosedPath : public testing::TestWithParam<HeadCase> {};

struct PathWork {
  double net, total;  // [J] sum, and sum of magnitudes
};

/// Around the edge of a quarter space, in and out and tilting, and back to the start.
PathWork work_around_an_edge(const ToolHead& head, double l, int steps, const Vec3& phase) {
  const Box quarter = {Vec3(-2.4 * mm, -2.4 * mm, -2 * mm), Vec3(0, 2.4 * mm, 0)};
  SimulationConfig config = static_config();
  config.longest_sweep = 64;
  Simulation simulation(box_at_phase(quarter, l, phase), Tool(head, LHandle{3 * mm, 1 * mm, 0.7}), config);
  const Pose X_TH = simulation.tool().X_HT().inverse();
  PathWork work = {0, 0};
  double start = 0, before = 0;
  for (int i = 0; i <= steps; ++i) {
    const double t = 2 * kPi * i / steps;
    const Pose X_WT = {
        rotation_from_vector(Vec3(0.25 * std::sin(t), 0.2 * std::sin(2 * t), 0.9 * std::sin(t))),
        Vec3(-0.1 + 0.45 * std::cos(t), 0.2 * std::sin(t), 0.1 + 0.25 * std::sin(t)) * mm + origin_at(head, 0.35 * mm)};
    const StepResult& result = simulation.step(X_WT * X_TH, {}, 1e-3);
    EXPECT_EQ(result.status, StepStatus::ok);
    if (i == 0) start = before = result.energy.hand_work;  // what it found where it appeared
    work.total += std::abs(result.energy.hand_work - before);
    before = result.energy.hand_work;
  }
  work.net = before - start;
  return work;
}

// A voxel's force is not the gradient of an energy where its section turns with the normal: what that leaves falls with
// the voxel. Beside it stands the midpoint rule in time, 4e-6, and 2e-5 where the direction of the springs jumps inside
// the material, on a cone's axis and between wall and bottom of a flat head.
TEST_P(ClosedPath, C13CostsAWorkThatFallsWithTheVoxel) {
  constexpr int kSteps = 2000;
  const test::Convergence c = test::converge(0.2 * mm, [&](double l, const Vec3& phase) {
    const PathWork work = work_around_an_edge(GetParam().head, l, kSteps, phase);
    EXPECT_GT(work.total, 1e-7);
    return work.net / work.total;
  });
  test::expect_convergence(c, 1.5, [](double l) { return 1.2e-4 * std::pow(l / (0.05 * mm), 2); });
}

INSTANTIATE_TEST_SUITE_P(Heads, ClosedPath, testing::Values(ball(), cone(), flat(), round_end()), kName);

// --- handles ----------------------------------------------------------------------------------------------------

class HandleTransport : public testing::TestWithParam<HeadCase> {};

/// C19 is an identity of what is computed, not of its limit: it holds to rounding on every grid.
constexpr std::array kGrids = {0.16 * mm, 0.08 * mm, 0.04 * mm};

// Proves: full wrench.
TEST_P(HandleTransport, C19PowerIsTheSameAtEveryReferencePointOnThreeGrids) {
  for (const double l : kGrids) {
    test::RandomPoses random(20);
    const Box block = {Vec3(-3, -3, -3) * mm, Vec3(3, 3, 0) * mm};
    const Workpiece workpiece = box_at_phase(block, l, test::phase(4));
    Simulation at_head(workpiece.clone(), Tool(GetParam().head), static_config());
    for (int n = 0; n < 20; ++n) {
      const Handle handle =
          n % 2 == 0
              ? Handle(RayHandle{random.between(0, 20 * mm)})
              : Handle(LHandle{random.between(0, 20 * mm), random.between(0, 10 * mm), random.between(-kPi, kPi)});
      Simulation at_hand(workpiece.clone(), Tool(GetParam().head, handle), static_config());
      const HeadBox box = GetParam().head.bounding_box();
      const Mat3 R_WT = random.rotation();
      const Pose X_WT = {R_WT, Vec3(0, 0, random.between(-0.5, 0.2)) * mm - R_WT * Vec3(0.5 * (box.min + box.max))};
      const Pose X_WH = X_WT * at_hand.tool().X_HT().inverse();
      const StepResult felt = hold(at_hand, X_WH);
      const StepResult direct = hold(at_head, X_WT);
      ASSERT_GT(direct.force.norm(), 0);

      const Vec3 p_HoTo_W = X_WT.translation - X_WH.translation;
      const double lever = p_HoTo_W.norm() + 1 * mm;
      const Wrench at_hand_by_transport = transport(Wrench{direct.force, direct.torque}, p_HoTo_W);
      // The two poses of the head agree to double precision; the samples are single.
      const double tolerance = 2e-6 * direct.force.norm();
      EXPECT_LT((felt.force - direct.force).norm(), tolerance);
      EXPECT_LT((felt.torque - at_hand_by_transport.torque).norm(), tolerance * lever);

      const Twist hand = {random.vector(0.1), random.vector(5)};
      const double power_of_hand = closed_forms::power({felt.force, felt.torque}, hand);
      const Twist head = transport(hand, p_HoTo_W);
      const double power_of_head = closed_forms::power({direct.force, direct.torque}, head);
      const double scale = direct.force.norm() * (head.linear.norm() + hand.angular.norm() * lever);
      EXPECT_NEAR(power_of_hand, power_of_head, 2e-6 * scale);

      const Vec3 p_HoP_W = random.vector(20 * mm);
      const Wrench at_p = transport(Wrench{felt.force, felt.torque}, -p_HoP_W);
      const Twist of_p = transport(hand, p_HoP_W);
      EXPECT_NEAR(closed_forms::power(at_p, of_p), power_of_hand, 1e-12 * (1 + scale));
    }
  }
}

TEST_P(HandleTransport, C19TheLedgerCountsTheSameWorkAtHeadAndHandleOnThreeGrids) {
  // The ledger books at the head; here the same work is summed from what the hand feels and how it moves.
  for (const double l : kGrids) {
    const Box block = {Vec3(-3, -3, -3) * mm, Vec3(3, 3, 0) * mm};
    SimulationConfig config = static_config();
    config.longest_sweep = 64;
    Simulation simulation(box_at_phase(block, l, test::phase(5)), Tool(GetParam().head, LHandle{8 * mm, 3 * mm, 1.2}),
                          config);
    const Pose X_TH = simulation.tool().X_HT().inverse();
    const auto pose = [&](double t) {
      return Pose{rotation_from_vector(Vec3(0.3 * t, -0.2 * t, 0.8 * t)),
                  origin_at(GetParam().head, 0) + Vec3(0.2 * t, 0.1 * t, -0.5 * t) * mm} *
             X_TH;
    };
    constexpr int kSteps = 400;
    constexpr double kDt = 1e-3;
    double work = 0;
    Pose before = pose(0);
    for (int i = 0; i <= kSteps; ++i) {
      const Pose now = pose(double(i) / kSteps);
      const StepResult& result = simulation.step(now, {}, kDt);
      ASSERT_EQ(result.status, StepStatus::ok);
      const Twist path = twist_between(before, now, kDt);
      work -= closed_forms::power({result.force, result.torque}, path) * kDt;
      before = now;
    }
    EXPECT_NEAR(simulation.last_result().energy.hand_work / work, 1, 1e-6) << "l = " << l / mm << " mm";
  }
}

INSTANTIATE_TEST_SUITE_P(Heads, HandleTransport, testing::Values(ball(), cone(), flat(), round_end()), kName);

}  // namespace
}  // namespace hapticut::static_any_head_test
