// SPDX-License-Identifier: Apache-2.0
// Ticks of a coupled tool with everything that may come between, composed from a seed: what the hand does, what the
// device reads, what is told to the simulation. Whatever the sequence, the invariants hold after every tick.
//
//     HAPTICUT_COMPOSED_TICKS=1000000 test_coupling --gtest_filter='ComposedTicks.KeepTheInvariantsForLong'
//
// runs as many as one likes; HAPTICUT_COMPOSED_SEED=n begins with the episode that a failure names.
#include <gtest/gtest.h>

#include <iostream>
#include <optional>

#include "support/composed_hand.hpp"
#include "support/composed_invariants.hpp"
#include "support/composed_scenes.hpp"
#include "support/sanitizers.hpp"

namespace hapticut::composed_ticks_test {
namespace {

using namespace test;
using units::mm;

constexpr int kEpisode = 2500;  // [ticks] of one scene

/// What happens before a motion of the hand, or during it.
enum class Event {
  nothing,
  spindle_stops,
  spindle_turns,
  spindle_reverses,
  spindle_is_held,
  hand_releases,
  hand_leaves,
  hand_leaves_until_free,
  clutch_opens,
  other_tool,
  other_materials,
  other_friction,
  other_effects,
  other_gains,
  other_rate,
  removal_changes,
  mark,
  undo,
  part_of_undo,
  redo,
  restore,
  other_workpiece,
  no_number,
  flip,
  no_rotation,
  no_speed,
  late,
  jump,
};

constexpr auto names_of(Of<Event>) {
  using enum Event;
  return std::array{
      Named{nothing, "nothing"},
      Named{spindle_stops, "spindle_stops"},
      Named{spindle_turns, "spindle_turns"},
      Named{spindle_reverses, "spindle_reverses"},
      Named{spindle_is_held, "spindle_is_held"},
      Named{hand_releases, "hand_releases"},
      Named{hand_leaves, "hand_leaves"},
      Named{hand_leaves_until_free, "hand_leaves_until_free"},
      Named{clutch_opens, "clutch_opens"},
      Named{other_tool, "other_tool"},
      Named{other_materials, "other_materials"},
      Named{other_friction, "other_friction"},
      Named{other_effects, "other_effects"},
      Named{other_gains, "other_gains"},
      Named{other_rate, "other_rate"},
      Named{removal_changes, "removal_changes"},
      Named{mark, "mark"},
      Named{undo, "undo"},
      Named{part_of_undo, "part_of_undo"},
      Named{redo, "redo"},
      Named{restore, "restore"},
      Named{other_workpiece, "other_workpiece"},
      Named{no_number, "no_number"},
      Named{flip, "flip"},
      Named{no_rotation, "no_rotation"},
      Named{no_speed, "no_speed"},
      Named{late, "late"},
      Named{jump, "jump"},
  };
}

/// A scene, a hand and what comes between, for some ticks.
class Episode {
 public:
  explicit Episode(std::uint64_t seed)
      : random_(seed),
        voxel_(random_.between(0.12, 0.25) * mm),
        turns_(below(2, random_) == 0),
        simulation_{some_piece(voxel_, random_), some_tool(random_), some_config(random_)},  // in this order
        fresh_(simulation_.snapshot()),
        coupling_(simulation_, some_gains(turns_, random_)),
        invariants_(simulation_),
        hand_(simulation_.tool()) {
    simulation_.reserve_undo(below(2, random_) == 0 ? 200 : 4096);
    other_rate();
  }

  /// @return that no invariant is broken
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
           std::string(name_or_null(hand_.motion())) + ", event " + std::string(name_or_null(event_)) + ", " +
           std::to_string(dt_ * 1e3) + " ms, " + (turns_ ? "6" : "3") + " degrees of freedom, status " +
           describe(coupling_.last_result().status) + ", of the step " + describe(simulation_.last_result().status);
  }
  [[nodiscard]] std::uint64_t hash() const { return invariants_.hash() ^ simulation_.workpiece().hash(); }
  [[nodiscard]] const Margins& margins() const { return invariants_.margins; }

 private:
  void begin_action() {
    left_ = int(random_.between(0.01, 0.3) / dt_);
    // A tool that waits is led out of the material soon, or nothing would come of an episode.
    const bool waits = has_any(coupling_.last_result().status, StepStatus::tool_waits);
    const auto motion = waits && below(2, random_) == 0 ? Motion::lift : Motion(below(9, random_));
    hand_.begin(motion, random_);
    event_ = below(2, random_) == 0 ? Event::nothing : Event(below(1 + int(Event::jump), random_));
    every_ = below(2, random_) == 0 ? 1000 : 1 + below(30, random_);
    exchange_if(event_);
  }

  void other_rate() { dt_ = 1 / random_.between(500, 4000); }

  void exchange_if(Event event) {
    using enum Event;
    const bool exchanges = event == other_tool || event == other_materials || event == undo || event == part_of_undo ||
                           event == redo || event == restore || event == other_workpiece;
    if (exchanges) invariants_.end_volume();
    tell(event);
    if (exchanges) invariants_.begin_volume();
  }

  void tell(Event event) {
    const double setting = simulation_.spindle_setting(), own = simulation_.tool().spindle().speed;
    switch (event) {
      case Event::spindle_stops:
        if (below(2, random_) == 0)
          simulation_.halt_spindle();
        else
          simulation_.set_spindle_speed({});
        break;
      case Event::spindle_turns:
        simulation_.hold_spindle(false);
        simulation_.set_spindle_speed(random_.between(0.2, 1) * own * units::rad_per_s);
        break;
      case Event::spindle_reverses:
        simulation_.set_spindle_speed((setting != 0 ? -setting : -own) * units::rad_per_s);
        break;
      case Event::spindle_is_held:
        simulation_.hold_spindle(!simulation_.spindle_is_held());
        break;
      case Event::hand_releases:
        coupling_.release();
        invariants_.expect_new_grip();
        break;
      case Event::hand_leaves:
        coupling_.leave(VirtualCoupling::Rejoin::near);
        invariants_.expect_new_grip();
        break;
      case Event::hand_leaves_until_free:
        coupling_.leave(VirtualCoupling::Rejoin::free);
        invariants_.expect_new_grip();
        break;
      case Event::other_tool: {
        const Tool tool = some_tool(random_);
        simulation_.set_tool(tool);
        VirtualCoupling::Lists lists(simulation_.worst_case(), simulation_.config());
        coupling_.exchange_lists(lists);
        hand_.hold(tool);
        invariants_.forget_motor();
        break;
      }
      case Event::other_materials:
        simulation_.set_materials(some_materials(random_));
        break;
      case Event::other_friction:
        simulation_.set_friction(below(2, random_) == 0 ? std::nullopt : std::optional(DryFriction{0.4, 0.3, 1000}));
        break;
      case Event::other_effects: {
        Effects effects;
        if (below(2, random_) == 0) {
          effects.limits.largest_force = random_.between(0.5, 3);
          effects.limits.largest_torque = 0.1;
          effects.limits.force_growth = 1000;
          effects.limits.ramp_time = 0.1;
        }
        simulation_.set_effects(effects);
        break;
      }
      case Event::other_gains:
        coupling_.set_gains(some_gains(turns_, random_));
        invariants_.expect_jump_of_stored();
        break;
      case Event::other_rate:
        other_rate();
        break;
      case Event::removal_changes:
        simulation_.set_removal(below(3, random_) == 0 ? RemovalLaw::none : RemovalLaw::constant_energy);
        break;
      case Event::mark:
        simulation_.set_undo_mark();
        break;
      case Event::undo:
        while (!simulation_.undo(64)) continue;
        break;
      case Event::part_of_undo:
        (void)simulation_.undo(1);
        break;
      case Event::redo:
        while (!simulation_.redo(64)) continue;
        break;
      case Event::restore:
        simulation_.restore(fresh_);
        break;
      case Event::other_workpiece: {
        simulation_.reset(some_piece(voxel_, random_));
        fresh_ = simulation_.snapshot();
        invariants_.begin_ledger();
        invariants_.forget_motor();
        break;
      }
      default:
        break;
    }
  }

  /// A reading as a device may give it.  @return that it must be refused
  bool spoil(Pose& pose, Twist& velocity, double& dt) {
    switch (event_) {
      case Event::no_number:
        pose.translation[below(3, random_)] = std::numeric_limits<double>::quiet_NaN();
        return true;
      case Event::flip:
        pose.rotation = rotation_from_vector(Vec3(units::kPi, 0, 0)) * pose.rotation;
        return false;  // by a tool that waits, when it is in the air
      case Event::no_rotation:
        pose.rotation.col(0) *= -1;
        return true;
      case Event::no_speed:
        velocity.linear[1] = std::numeric_limits<double>::infinity();
        return true;
      case Event::late:
        dt = random_.between(0.11, 1);
        return true;
      case Event::jump:
        pose.translation += random_.vector(80 * mm);
        return false;
      default:
        return false;
    }
  }

  void move() {
    hand_.move(coupling_.last_result().hand.force.norm(), dt_);
    Pose pose = hand_.X_WD();
    Twist velocity = hand_.velocity();
    double dt = dt_;
    if (event_ == Event::clutch_opens) {  // the hand moves on, as a loop tells the coupling
      coupling_.leave(VirtualCoupling::Rejoin::near);
      invariants_.expect_new_grip();
      return;
    }
    const bool refused = left_ % every_ == 0 && spoil(pose, velocity, dt);
    const CoupledResult& result = coupling_.step(pose, velocity, dt);
    invariants_.look(result, coupling_.gains(), simulation_.config().effects, refused);
  }

  RandomPoses random_;
  double voxel_;
  bool turns_;
  Simulation simulation_;
  WorkpieceSnapshot fresh_;
  VirtualCoupling coupling_;
  ComposedInvariants invariants_;
  ComposedHand hand_;
  Event event_ = Event::nothing;
  double dt_ = 1e-3;  // [s]
  int tick_ = 0, left_ = 0, every_ = 1;
};

void compose(std::uint64_t ticks) {
  const std::uint64_t first = number_from("HAPTICUT_COMPOSED_SEED", 1);
  Margins margins;
  int broken = 0;
  for (std::uint64_t done = 0, seed = first; done < ticks && broken < 10; done += kEpisode, ++seed) {
    Episode episode(seed);
    if (!episode.run(int(std::min<std::uint64_t>(kEpisode, ticks - done)))) {
      ++broken;
      ADD_FAILURE() << "seed " << seed << ": " << episode.what_is_broken();
    }
    margins.add(episode.margins());
  }
  testing::Test::RecordProperty("composed", margins.in_words());
  std::cout << margins.in_words() << "\n";
  EXPECT_GT(margins.cutting, 0U) << "or the invariants were not tried";
  if (ticks < 50000) return;
  EXPECT_GT(margins.cutting * 20, margins.ticks);
  EXPECT_GT(margins.refused * 500, margins.ticks);
  EXPECT_GT(margins.stalled, 0U);
  EXPECT_GT(margins.crushing, 0U);
}

TEST(ComposedTicks, KeepTheInvariants) { compose(kWithAddressSanitizer ? 2500 : 5000); }

TEST(ComposedTicks, KeepTheInvariantsForLong) { compose(number_from("HAPTICUT_COMPOSED_TICKS", 100000)); }

TEST(ComposedTicks, GiveTheSameBitsAgain) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    Episode once(seed), again(seed);
    once.run(600);
    again.run(600);
    EXPECT_EQ(once.hash(), again.hash()) << "seed " << seed;
  }
}

}  // namespace
}  // namespace hapticut::composed_ticks_test
