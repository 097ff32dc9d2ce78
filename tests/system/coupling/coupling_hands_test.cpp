// SPDX-License-Identifier: Apache-2.0
// Energy that 10^3 random hands get at the device, computed from the poses and from the wrenches that the device holds.
// Section "Passivity at the hand" of docs/decisions/0005-implicit-coupling.md has the argument.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "experiments/setup/random_pose.hpp"
#include "hapticut/analysis/closed_loop.hpp"
#include "hapticut/loop/coupling_gains.hpp"
#include "hapticut/simulation/coupling.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/catalogue_heads.hpp"

namespace hapticut::coupling_hands_test {
namespace {

using test::RandomPoses;
using units::mm;

constexpr std::uint64_t kSeed = 1;
constexpr int kHands = 250;          // number of each of the four kinds
constexpr double kShare = 1e-3;      // [1] part of its turnover that a hand may get
constexpr double kNothing = 1e-7;    // [J] below the turnover of any hand
constexpr double kAbove = 0.6 * mm;  // above the surface, where a path begins

template <class Choices>
auto& one_of(RandomPoses& random, Choices&& choices) {
  return choices[std::min(std::size(choices) - 1, std::size_t(random.between(0, double(std::size(choices)))))];
}

// --- random scenes ---------------------------------------------------------------------------------------------------

const ToolHead& any_head(RandomPoses& random) {
  static const std::vector<ToolHead> heads = [] {
    std::vector<ToolHead> made;
    for (const test::CatalogueHead& head : test::catalogue_heads()) made.push_back(head.make());
    return made;
  }();
  return one_of(random, heads);
}

/// The device's gains with a damper that is weaker by a random factor, because a damper hides the energy of the spring.
CouplingGains any_gains(RandomPoses& random, const DeviceModel& device) {
  CouplingGains gains = coupling_gains(capabilities(device));
  const double weak = random.between(0, 1);
  gains.damping *= weak;
  gains.angular_damping *= weak;
  return gains;
}

Material any_material(RandomPoses& random) {
  Material material = find_preset(one_of(random, preset_names()));
  if (random.between(0, 1) < 0.5) return material;
  material.damping = random.between(0, 300);
  material.static_friction = random.between(0, 0.6);
  material.dynamic_friction = random.between(0, 1) * material.static_friction;
  return material;
}

Handle any_handle(RandomPoses& random) {
  const double kind = random.between(0, 1), length = random.between(10 * mm, 100 * mm);
  if (kind < 0.3) return RayHandle{0};
  if (kind < 0.7) return RayHandle{length};
  const double neck = random.between(0, 30 * mm);
  return LHandle{length, neck, random.between(0.3, 2)};
}

Workpiece any_slab(RandomPoses& random) {
  const double voxel = random.between(0.2 * mm, 0.3 * mm);
  const Vec3 aside = voxel * Vec3(random.between(0, 1), random.between(0, 1), random.between(0, 1));
  return build_block({Vec3(-4, -4, -3) * mm - aside, Vec3(4, 4, 0) * mm}, voxel, any_material(random));
}

SimulationConfig at_the_end() {
  SimulationConfig config;
  config.contact_time = ContactTime::end;
  return config;
}

Pose above_the_slab(RandomPoses& random, const Tool& tool) {
  const Vec3 axis = random.direction();
  const Mat3 tilt = rotation_from_vector(random.between(0, 0.4) * Vec3(axis.x(), axis.y(), 0));
  const HeadBox box = tool.head().bounding_box();
  double lowest = 0;
  for (const double x : {box.min.x(), box.max.x()})
    for (const double y : {box.min.y(), box.max.y()})
      for (const double z : {box.min.z(), box.max.z()}) lowest = std::min(lowest, (tilt * Vec3(x, y, z)).z());
  const Vec3 aside = random.vector(1 * mm);
  return Pose{tilt, Vec3(aside.x(), aside.y(), kAbove - lowest)} * tool.X_HT().inverse();
}

/// A smooth closed path of the hand into the material and elsewhere.
struct ClosedPath {
  static constexpr int kWaves = 3;
  Pose start;
  std::array<Vec3, kWaves> shifts, rotations;  // [m], [rad]
  double seconds = 0;

  [[nodiscard]] Pose at(double time) const {
    Vec3 shift = Vec3::Zero(), rotation = Vec3::Zero();
    const double angle = std::numbers::pi * std::clamp(time / seconds, 0.0, 1.0);
    for (int n = 0; n < kWaves; ++n) {
      const double wave = std::pow(std::sin((n + 1) * angle), 2);
      shift += wave * shifts[std::size_t(n)];
      rotation += wave * rotations[std::size_t(n)];
    }
    return {rotation_from_vector(rotation) * start.rotation, start.translation + shift};
  }
};

struct Scene {
  double period;
  const DeviceModel& device;
  CouplingGains gains;
  Tool tool;
  Simulation simulation;
  VirtualCoupling coupling;
  ClosedPath path;

  /// @param turns  whether the hand rotates as well
  Scene(RandomPoses& random, const DeviceModel& model, bool spins, bool turns)
      : period(1 / one_of(random, std::array{500.0, 1000.0, 2000.0, 4000.0})),
        device(model),
        gains(any_gains(random, device)),
        tool(any_head(random), any_handle(random), Spindle{(spins ? random.between(500, 4000) : 0) * units::rad_per_s}),
        simulation(any_slab(random), tool, at_the_end()),
        coupling(simulation, gains) {
    path.start = above_the_slab(random, tool);
    path.seconds = random.between(0.05, 0.2);
    const double reach = tool.head().reach() + tool.X_HT().translation.norm();
    for (int n = 0; n < ClosedPath::kWaves; ++n) {
      path.shifts[std::size_t(n)] = random.vector((n == 0 ? 1.5 : 0.5) * mm);
      path.rotations[std::size_t(n)] =
          turns ? random.vector(std::min(0.3, 2 * mm / reach) / (n + 1)) : Vec3(Vec3::Zero());
    }
    path.shifts[0].z() = -kAbove - random.between(0.1, 1.2) * gains.max_force / gains.stiffness;
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  [[nodiscard]] std::string words() const {
    return std::string(device.name) + " at " + std::to_string(std::lround(1 / period)) + " Hz, " +
           simulation.workpiece().materials().all().back().name + ", reach " + std::to_string(tool.head().reach()) +
           " m, damping " + std::to_string(gains.damping) + " N s/m";
  }
};

// --- the work --------------------------------------------------------------------------------------------------------

/// Work of the motor and of rotations, summed over the steps.
class Steps final : public StepObserver {
 public:
  double motor = 0;     // [J] work of the spindle
  double rotation = 0;  // [J] work of a hand that feels the contact's torque at the end of each step
  Pose last;

  void on_step(const ObservedStep& step) noexcept override {
    if (has_any(step.result.status, kRejected)) return;
    motor += step.result.spindle.torque * step.result.spindle.speed * step.input.dt;
    const Mat3 moved = step.input.X_WH.rotation * last.rotation.transpose();
    rotation -= step.result.model.torque.dot(vector_from_rotation(moved));
    last = step.input.X_WH;
  }
};

/// Work of a hand on a device that holds each wrench until the next one, and the allowance for holding and reading.
class HandWork {
 public:
  explicit HandWork(const Scene& scene, double encoder_step = 0)
      : gains_(scene.gains), period_(scene.period), encoder_step_(encoder_step) {}

  /// Adds the work from pose to pose, with the wrench of the tick before.
  /// @param read  the motion in the device's readings, as a twist in a tick, and its estimate of the velocity
  void go(const Pose& from, const Pose& to, const Twist& read, const Twist& estimate, const CoupledResult& result) {
    const Twist path = twist_between(from, to, 1);
    const double work = -held.force.dot(path.linear) - held.torque.dot(path.angular);
    const double sub_ticks = std::max(1, result.sub_ticks),
                 hold = (sub_ticks + 1) * (2 * sub_ticks + 1) / (6 * sub_ticks);
    allowed += 0.5 * hold * gains_.stiffness * read.linear.squaredNorm();
    allowed += 0.5 * hold * gains_.angular_stiffness * read.angular.squaredNorm();
    allowed += 0.5 * std::sqrt(3) * encoder_step_ * (result.hand.force - held.force).norm();
    allowed += 0.25 * gains_.damping * period_ * (estimate.linear - read.linear / period_).squaredNorm();
    allowed += 0.25 * gains_.angular_damping * period_ * (estimate.angular - read.angular / period_).squaredNorm();
    given += work;
    turnover += std::abs(work);
    booked -= result.coupling.force.dot(path.linear) + result.coupling.torque.dot(path.angular);
    held = result.hand;
    if (gains_.angular_stiffness == 0) held.torque.setZero();  // no motors for torque
    max_force = std::max(max_force, held.force.norm());
    max_sub_ticks = std::max(max_sub_ticks, result.sub_ticks);
    waited = waited || has_any(result.status, StepStatus::tool_waits | kRejected);
  }

  /// Called after each tick. @param by_others  [J] work of others than the hand
  void judge(double by_others) {
    others = by_others;
    min_work = std::min(min_work, given + allowed + others);
  }

  Wrench held;           // by the motors
  double given = 0;      // [J] by the hand so far
  double allowed = 0;    // [J] allowance for holding and reading
  double turnover = 0;   // [J] turnover of the hand
  double others = 0;     // [J] work of others
  double booked = 0;     // [J] by the coupling, of the hand
  double min_work = 0;   // [J] minimum of the work of hand and others, with the allowance
  double max_force = 0;  // [N]
  int max_sub_ticks = 0;
  bool waited = false;

 private:
  CouplingGains gains_;
  double period_, encoder_step_;
};

/// A hand that moves along the path at any force.
HandWork follow(Scene& scene, Steps& steps, bool counts_turning) {
  HandWork work(scene);
  steps.last = scene.path.start;
  scene.simulation.observers().add(steps);
  Pose last = scene.path.start;
  const long ticks = std::lround(std::ceil(scene.path.seconds / scene.period));
  for (long n = 0; n <= ticks; ++n) {
    const Pose pose = scene.path.at(double(n) * scene.period);
    const Twist read = twist_between(last, pose, 1), velocity = twist_between(last, pose, scene.period);
    work.go(last, pose, read, velocity, scene.coupling.step(pose, velocity, scene.period));
    work.judge(steps.motor + (counts_turning ? steps.rotation : 0));
    last = pose;
  }
  scene.simulation.observers().remove(steps);
  return work;
}

/// Totals of all hands of a kind, which prove that something happened in the test.
struct Tally {
  int touched = 0, cut = 0, got = 0;
  double max_got = 0;  // [J]

  void add(const Scene& scene, const HandWork& work) {
    touched += work.max_force > 0.1 ? 1 : 0;
    cut += scene.simulation.totals().removed_volume[1] > 0 ? 1 : 0;
    got += work.given < -kNothing ? 1 : 0;
    max_got = std::max(max_got, -work.given);
  }
  ~Tally() {
    testing::Test::RecordProperty("hands_that_got_energy", got);
    testing::Test::RecordProperty("max_energy_in_mJ", std::to_string(1e3 * max_got));
  }
};

void expect_passive(const Scene& scene, const HandWork& work) {
  EXPECT_GE(work.min_work, -kShare * (work.turnover + std::abs(work.others)) - kNothing) << scene.words();
  EXPECT_FALSE(work.waited) << scene.words();
}

std::string named(const char* kind, int n) {
  return std::string(kind) + ", hand " + std::to_string(n) + " of seed " + std::to_string(kSeed);
}

RandomPoses hand(int kind, int n) {
  return RandomPoses(kSeed + std::uint64_t(1000003) * std::uint64_t(kHands * kind + n));
}

/// Runs all hands of a kind, each with a random device.
void expect_all_passive(int kind, const char* name, bool turning, Tally& tally) {
  for (int n = 0; n < kHands; ++n) {
    SCOPED_TRACE(named(name, n));
    RandomPoses random = hand(kind, n);
    const DeviceModel& device = one_of(random, device_models());
    Scene scene(random, device, turning, device.peak_torque > 0);
    Steps steps;
    const HandWork work = follow(scene, steps, false);
    expect_passive(scene, work);
    tally.add(scene, work);
    if (turning || work.max_sub_ticks > 1 || !(scene.gains.angular_stiffness > 0)) continue;
    const CouplingEnergy& energy = scene.coupling.last_result().energy;
    EXPECT_NEAR(work.booked, energy.hand_work, 1e-9 + 1e-6 * energy.turnover);
  }
}

TEST(RandomHands, GetNothingFromAHeadThatStands) {
  Tally tally;
  expect_all_passive(0, "standing", false, tally);
  EXPECT_GT(tally.touched, kHands * 9 / 10);
}

TEST(RandomHands, AndTheMotorGetNothingFromAHeadThatTurns) {
  Tally tally;
  expect_all_passive(1, "turning", true, tally);
  EXPECT_GT(tally.touched, kHands * 3 / 4);
  EXPECT_GT(tally.cut, kHands * 3 / 4);
}

// On a device without motors for torque, the hand rotates the tool and feels no torque. The hand may gain the work of
// this rotation, but not more.
TEST(RandomHands, GetAtMostTheWorkOfARotationWithoutTorqueMotors) {
  Tally tally;
  for (int n = 0; n < kHands; ++n) {
    SCOPED_TRACE(named("no motors for torque", n));
    RandomPoses random = hand(2, n);
    const DeviceModel* device = &one_of(random, device_models());
    while (device->peak_torque > 0) device = &one_of(random, device_models());
    Scene scene(random, *device, false, true);
    Steps steps;
    const HandWork work = follow(scene, steps, true);
    expect_passive(scene, work);
    tally.add(scene, work);
  }
  EXPECT_GT(tally.touched, kHands * 9 / 10);
  EXPECT_GT(tally.got, 0) << "the page documents this loss";
}

// A hand of mass, spring and damper, bonded or behind a pad, that follows the path and yields to the force.
TEST(RandomHands, ThatTheForceMovesGetNothing) {
  Tally tally;
  for (int n = 0; n < kHands; ++n) {
    SCOPED_TRACE(named("moved", n));
    RandomPoses random = hand(3, n);
    const DeviceModel& device = one_of(random, device_models());
    const bool turns = device.peak_torque > 0;
    Scene scene(random, device, random.between(0, 1) < 0.5, turns);
    ClosedLoopConfig config;
    config.device = device;
    config.hand = one_of(random, hand_models().subspan(1));
    for (double HandModel::*number : {&HandModel::mass, &HandModel::damping, &HandModel::stiffness})
      config.hand.*number *= random.between(0.5, 2);
    config.period = scene.period;
    config.encoder = random.between(0, 1) < 0.5;
    config.velocity_filter = random.between(0, 1) < 0.5 ? 100 : 0;
    config.rotation = turns;
    ClosedLoop loop(config);
    loop.reset(scene.path.start);
    Steps steps;
    steps.last = scene.path.start;
    scene.simulation.observers().add(steps);
    HandWork work(scene, config.encoder ? device.encoder_step : 0);
    Pose last = loop.plant().pose(), last_read = loop.read().X_BS;
    const long ticks = std::lround(1.5 * scene.path.seconds / scene.period);  // then it rests
    for (long k = 0; k <= ticks; ++k) {
      loop.plant().set_target(scene.path.at(double(k) * scene.period));
      const DeviceState& state = loop.read();
      const Pose now = loop.plant().pose();
      work.go(last, now, twist_between(last_read, state.X_BS, 1), state.velocity,
              scene.coupling.step(state.X_BS, state.velocity, scene.period));
      work.judge(steps.motor);
      last = now, last_read = state.X_BS;
      loop.write(work.held);
    }
    scene.simulation.observers().remove(steps);
    expect_passive(scene, work);
    tally.add(scene, work);
  }
  EXPECT_GT(tally.touched, kHands * 3 / 4);
}

}  // namespace
}  // namespace hapticut::coupling_hands_test
