// SPDX-License-Identifier: Apache-2.0
// Random ticks of a coupled tool with all possible events, from a seed: actions of the hand, readings of the device,
// commands to the simulation. Whatever the sequence, the invariants hold after every tick.
//
//     HAPTICUT_COMPOSED_TICKS=1000000 test_coupling --gtest_filter='ComposedTicks.KeepTheInvariantsForLong'
//
// runs that many ticks; HAPTICUT_COMPOSED_SEED=n begins with the episode that a failure names.
#include <gtest/gtest.h>

#include <optional>
#include <string_view>

#include "experiments/setup/cutting.hpp"
#include "support/composed_hand.hpp"
#include "support/composed_scenes.hpp"

namespace hapticut::composed_ticks_test {
namespace {

using namespace test;
using units::mm;

/// A scene, a hand and events, for some ticks.
class Episode {
 public:
  explicit Episode(std::uint64_t seed)
      : random_(seed),
        voxel_(random_.between(0.12, 0.25) * mm),
        turns_(below(2, random_) == 0),
        simulation_{some_piece(voxel_, random_), some_tool(random_), some_config(random_)},  // drawn in this order
        fresh_(simulation_.workpiece().snapshot()),
        coupling_(simulation_, some_gains(turns_, random_)),
        invariants_(simulation_),
        hand_(simulation_.tool()) {
    simulation_.history().reserve(below(2, random_) == 0 ? 200 : 4096);
    other_rate();
  }

  /// @return whether all invariants hold
  bool run(int ticks) {
    for (tick_ = 0; tick_ < ticks && invariants_.broken().empty(); ++tick_) {
      if (left_-- == 0) begin_action();
      move();
    }
    if (invariants_.broken().empty()) invariants_.end_volume();
    return invariants_.broken().empty();
  }

  [[nodiscard]] std::string what_is_broken() const {
    return invariants_.broken() + "; tick " + std::to_string(tick_ - 1) + ", the hand does " +
           std::string(name_or_null(hand_.motion())) + ", event " + std::string(event_->name) + ", " +
           std::to_string(dt_ * 1e3) + " ms, " + (turns_ ? "6" : "3") + " degrees of freedom, status " +
           describe(coupling_.last_result().status) + ", of the step " + describe(simulation_.last_result().status);
  }
  [[nodiscard]] std::uint64_t hash() const { return invariants_.hash() ^ simulation_.workpiece().hash(); }
  [[nodiscard]] const Margins& margins() const { return invariants_.margins; }

 private:
  void begin_action() {
    left_ = int(random_.between(0.01, 0.3) / dt_);
    // The hand soon moves a waiting tool out of the material. Otherwise nothing would happen in the episode.
    const bool waits = has_any(coupling_.last_result().status, StepStatus::tool_waits);
    const auto motion = waits && below(2, random_) == 0 ? Motion::lift : Motion(below(9, random_));
    hand_.begin(motion, random_);
    event_ = &events()[below(2, random_) == 0 ? 0 : std::size_t(below(int(events().size()), random_))];
    every_ = below(2, random_) == 0 ? 1000 : 1 + below(30, random_);
    if (event_->exchanges) invariants_.end_volume();
    event_->happens(*this);
    if (event_->exchanges) invariants_.begin_volume();
  }

  void other_rate() { dt_ = 1 / random_.between(500, 4000); }

  /// A reading of a device.
  struct Reading {
    Pose pose;
    Twist velocity;
    double dt;  // [s]
  };

  /// An event before a motion of the hand, or during it.
  struct Event {
    std::string_view name;
    void (*happens)(Episode& e);
    bool exchanges = false;                                  // exchanges the material or the hand
    bool (*spoils)(Episode& e, Reading& reading) = nullptr;  // @return whether it must be refused
  };

  static const std::vector<Event>& events() {
    constexpr auto kNothing = [](Episode&) {};
    static const std::vector<Event> all = {
        {"nothing", kNothing},
        {"spindle_stops",
         [](Episode& e) {
           if (below(2, e.random_) == 0)
             e.simulation_.spindle().halt();
           else
             e.simulation_.spindle().set_speed({});
         }},
        {"spindle_turns",
         [](Episode& e) {
           e.simulation_.spindle().hold(false);
           e.simulation_.spindle().set_speed(e.random_.between(0.2, 1) * e.own_speed() * units::rad_per_s);
         }},
        {"spindle_reverses",
         [](Episode& e) {
           const double setting = e.simulation_.spindle().setting();
           e.simulation_.spindle().set_speed((setting != 0 ? -setting : -e.own_speed()) * units::rad_per_s);
         }},
        {"spindle_is_held", [](Episode& e) { e.simulation_.spindle().hold(!e.simulation_.spindle().is_held()); }},
        {"hand_releases",
         [](Episode& e) {
           e.coupling_.reset();
           e.invariants_.expect_new_grip();
         }},
        {"hand_leaves", [](Episode& e) { e.leave(VirtualCoupling::Rejoin::near); }},
        {"hand_leaves_until_free", [](Episode& e) { e.leave(VirtualCoupling::Rejoin::free); }},
        {kClutchOpens, kNothing},
        {"other_tool",
         [](Episode& e) {
           const Tool tool = some_tool(e.random_);
           e.simulation_.set(tool);
           VirtualCoupling::Lists lists(e.simulation_.worst_case(), e.simulation_.config());
           e.coupling_.exchange_lists(lists);
           e.hand_.grip(tool);
           e.invariants_.forget_motor();
         },
         true},
        {"other_materials", [](Episode& e) { e.simulation_.set(some_materials(e.random_)); }, true},
        {"other_friction",
         [](Episode& e) {
           const std::optional<DryFriction> friction = DryFriction{0.4, 0.3, 1000};
           e.simulation_.set(below(2, e.random_) == 0 ? std::nullopt : friction);
         }},
        {"other_effects",
         [](Episode& e) {
           Effects effects;
           if (below(2, e.random_) == 0) {
             effects.limits.max_force = e.random_.between(0.5, 3);
             effects.limits.max_torque = 0.1;
             effects.limits.force_growth = 1000;
             effects.limits.ramp_time = 0.1;
           }
           e.simulation_.set(effects);
         }},
        {"other_gains",
         [](Episode& e) {
           e.coupling_.set_gains(some_gains(e.turns_, e.random_));
           e.invariants_.expect_jump_of_stored();
         }},
        {"other_rate", [](Episode& e) { e.other_rate(); }},
        {"removal_changes",
         [](Episode& e) {
           e.simulation_.set(below(3, e.random_) == 0 ? RemovalLaw::none : RemovalLaw::constant_energy);
         }},
        {"mark", [](Episode& e) { e.simulation_.history().mark(); }},
        {"undo", [](Episode& e) { undo_all(e.simulation_); }, true},
        {"part_of_undo", [](Episode& e) { (void)e.simulation_.history().undo(1); }, true},
        {"redo", [](Episode& e) { redo_all(e.simulation_); }, true},
        {"restore", [](Episode& e) { e.simulation_.history().restore(e.fresh_); }, true},
        {"other_workpiece",
         [](Episode& e) {
           e.simulation_.reset(some_piece(e.voxel_, e.random_));
           e.fresh_ = e.simulation_.workpiece().snapshot();
           e.invariants_.begin_ledger();
           e.invariants_.forget_motor();
         },
         true},
        {"no_number", kNothing, false,
         [](Episode& e, Reading& reading) {
           reading.pose.translation[below(3, e.random_)] = std::numeric_limits<double>::quiet_NaN();
           return true;
         }},
        {"flip", kNothing, false,
         [](Episode&, Reading& reading) {
           reading.pose.rotation = rotation_from_vector(Vec3(units::kPi, 0, 0)) * reading.pose.rotation;
           return false;  // a waiting tool in the air accepts it
         }},
        {"no_rotation", kNothing, false,
         [](Episode&, Reading& reading) {
           reading.pose.rotation.col(0) *= -1;
           return true;
         }},
        {"no_speed", kNothing, false,
         [](Episode&, Reading& reading) {
           reading.velocity.linear[1] = std::numeric_limits<double>::infinity();
           return true;
         }},
        {"late", kNothing, false,
         [](Episode& e, Reading& reading) {
           reading.dt = e.random_.between(0.11, 1);
           return true;
         }},
        {"jump", kNothing, false, [](Episode& e, Reading& reading) {
           reading.pose.translation += e.random_.vector(80 * mm);
           return false;
         }}};
    return all;
  }

  [[nodiscard]] double own_speed() const { return simulation_.tool().spindle().speed; }

  void leave(VirtualCoupling::Rejoin rejoin) {
    coupling_.park(rejoin);
    invariants_.expect_new_grip();
  }

  void move() {
    hand_.move(coupling_.last_result().hand.force.norm(), dt_);
    if (event_->name == kClutchOpens) return leave(VirtualCoupling::Rejoin::near);  // while the hand moves
    Reading reading{hand_.X_WD(), hand_.velocity(), dt_};
    const bool refused = left_ % every_ == 0 && event_->spoils != nullptr && event_->spoils(*this, reading);
    const CoupledResult& result = coupling_.step(reading.pose, reading.velocity, reading.dt);
    invariants_.look(result, coupling_.gains(), simulation_.config().effects, refused);
  }

  static constexpr std::string_view kClutchOpens = "clutch_opens";

  RandomPoses random_;
  double voxel_;
  bool turns_;
  Simulation simulation_;
  WorkpieceSnapshot fresh_;
  VirtualCoupling coupling_;
  ComposedInvariants invariants_;
  ComposedHand hand_;
  const Event* event_ = &events()[0];
  double dt_ = 1e-3;  // [s]
  int tick_ = 0, left_ = 0, every_ = 1;
};

TEST(ComposedTicks, KeepTheInvariants) { compose<Episode>(kFewTicks); }

TEST(ComposedTicks, KeepTheInvariantsForLong) {
  const Margins margins = compose<Episode>(many_ticks());
  if (many_ticks() < 50000) return;
  EXPECT_GT(margins.cutting * 20, margins.ticks);
  EXPECT_GT(margins.refused * 500, margins.ticks);
  EXPECT_GT(margins.stalled, 0U);
  EXPECT_GT(margins.crushing, 0U);
}

TEST(ComposedTicks, GiveTheSameBitsAgain) {
  for (const std::uint64_t seed : {1, 2, 3}) expect_the_same_bits<Episode>(seed, 600);
}

}  // namespace
}  // namespace hapticut::composed_ticks_test
