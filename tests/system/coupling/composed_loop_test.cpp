// SPDX-License-Identifier: Apache-2.0
// Random ticks through the whole chain of device, map, guard, coupling and step,
// with the commands of a loop.
#include <gtest/gtest.h>

#include <optional>
#include <string_view>
#include <vector>

#include "hapticut/loop/coupling_gains.hpp"
#include "hapticut/loop/simulation_model.hpp"
#include "support/composed_hand.hpp"
#include "support/composed_scenes.hpp"
#include "support/followed_mock.hpp"
#include "support/random_commands.hpp"

namespace hapticut::composed_loop_test {
namespace {

using namespace test;
using units::mm;

class Course {
 public:
  explicit Course(std::uint64_t seed)
      : random_(seed),
        voxel_(random_.between(0.12, 0.25) * mm),
        simulation_{some_piece(voxel_, random_), some_tool(random_), some_config(random_)},  // drawn in this order
        hand_(simulation_.tool()),
        device_(
            rigid_touch(), [this](DeviceState& state) { read(state); }, [this](const Wrench& given) { look(given); }),
        model_(simulation_, device_, options()),
        invariants_(simulation_) {
    period_ = 1 / random_.between(500, 4000);
  }

  /// @return whether all invariants hold
  bool run(int ticks) {
    RunOptions options;
    options.simulated_time = true;
    options.stop_on_signals = false;
    options.guard.period = period_;
    options.guard.arming.ramp = options.guard.arming.short_ramp = 0.02;
    const RunReport report = device_.run(
        [&](const DeviceState& reading) {
          if (left_-- == 0) begin_action();
          const double dt = tick_ == 0 ? period_ : reading.time - last_time_;
          last_time_ = reading.time;
          DeviceCommand command;
          command.wrench = model_.step(reading, dt > 0 ? dt : period_, snapshot_);
          command.contact = model_.contact();
          command.stop = ++tick_ >= ticks || !invariants_.broken().empty();
          is_under_way_ = true;
          return command;
        },
        options);
    if (invariants_.broken().empty() && report.fault != DeviceFault::none) return false;
    return invariants_.broken().empty();
  }

  [[nodiscard]] std::string what_is_broken() const {
    return invariants_.broken() + "; tick " + std::to_string(tick_ - 1) + ", the hand does " +
           std::string(name_or_null(hand_.motion())) + ", command " + std::to_string(command_) + ", reading " +
           std::string(spoilt_->name) + ", " + std::to_string(period_ * 1e3) + " ms, status " +
           describe(snapshot_.tool.status) + ", arming " + std::string(name_or_null(device_.last_arming()));
  }
  [[nodiscard]] std::uint64_t hash() const { return invariants_.hash() ^ simulation_.workpiece().hash(); }
  [[nodiscard]] const Margins& margins() const { return invariants_.margins; }

 private:
  SimulationModelOptions options() {
    SimulationModelOptions options;
    options.coupling = coupling_gains(device_.capabilities());
    options.undo_blocks = 2000;
    return options;
  }

  /// Moves the hand, and changes the reading if a fault is drawn.
  void read(DeviceState& state) noexcept {
    hand_.move(applied_.force.norm(), period_);
    state.X_BS = hand_.X_WD();
    state.velocity = hand_.velocity();
    state.time += late_;
    if (left_ % every_ != 0) return;
    spoilt_->happens(*this, state);
  }

  /// Faults of a reading on its way from the device.
  struct Spoilt {
    std::string_view name;
    void (*happens)(Course& course, DeviceState& state);
  };

  static const std::vector<Spoilt>& spoilt() {
    static const std::vector<Spoilt> all = {
        {"not_at_all", [](Course&, DeviceState&) {}},
        {"no_number",
         [](Course&, DeviceState& state) { state.X_BS.translation.y() = std::numeric_limits<double>::quiet_NaN(); }},
        {"flip",
         [](Course&, DeviceState& state) {
           state.X_BS.rotation = rotation_from_vector(Vec3(units::kPi, 0, 0)) * state.X_BS.rotation;
         }},
        {"no_rotation", [](Course&, DeviceState& state) { state.X_BS.rotation.col(0) *= -1; }},
        {"late",
         [](Course& course, DeviceState& state) {
           state.time -= course.late_;
           course.late_ += course.random_.between(2e-3, 0.2);  // delays this and all later readings
           state.time += course.late_;
         }},
        {"jump", [](Course& course, DeviceState& state) { state.X_BS.translation += course.random_.vector(40 * mm); }},
        {"invalid", [](Course&, DeviceState& state) { state.valid = false; }}};
    return all;
  }

  /// Called when the motors have the wrench and the tick is complete. Checks the output.
  void look(const Wrench& applied) noexcept {
    applied_ = applied;
    if (!std::exchange(is_under_way_, false)) return;
    const double removed = snapshot_.tool.removed_volume;
    invariants_.look(removed - std::exchange(last_removed_, removed), applied, device_.capabilities().peak_force,
                     snapshot_.X_WT);
  }

  void begin_action() {
    left_ = int(random_.between(0.01, 0.3) / period_);
    hand_.begin(snapshot_.tool.status == StepStatus::ok ? Motion(below(9, random_)) : Motion::lift, random_);
    spoilt_ = &spoilt()[below(3, random_) == 0 ? std::size_t(below(int(spoilt().size()), random_)) : 0];
    every_ = below(2, random_) == 0 ? 1000 : 1 + below(30, random_);
    command_ = below(2, random_) == 0 ? -1 : below(15 + test::kCommandsWithoutACase, random_);
    if (is_open_ && below(3, random_) != 0) command_ = 1;  // else nothing would happen
    std::optional<LoopCommand> command = next();
    if (!command) return;
    if (command_ == 9) hand_.grip(std::get<commands::SetTool>(*command).tool.tool());
    if (command_ == 9) invariants_.forget_motor();
    model_.check(*command);
    (void)model_.apply(*command);
  }

  std::optional<LoopCommand> next() {
    using namespace commands;
    const double own = simulation_.tool().spindle().speed;
    if (command_ == 0 || command_ == 1) is_open_ = command_ == 0;
    switch (command_) {
      case 0:
        return OpenClutch{};
      case 1:
        return CloseClutch{};
      case 2:
        return SetSpindleSpeed{-own * units::rad_per_s};
      case 3:
        return SetSpindleSpeed{};
      case 4:
        return SetSpindleSpeed{random_.between(0.2, 1) * own * units::rad_per_s};
      case 5:
        return SetScale{random_.between(0.8, 1.2)};
      case 6:
        return SetUndoMark{};
      case 7:
        return Undo{};
      case 8:
        return Redo{};
      case 9:
        return model_.prepare_tool(some_tool(random_));
      case 10:
        return model_.prepare_materials(some_materials(random_));
      case 11:
        return SetFriction{DryFriction{0.4, 0.3, 1000}};
      case 12:
        return SetRemoval{below(4, random_) == 0 ? RemovalLaw::none : RemovalLaw::constant_energy};
      case 13:
        return HoldForce{below(3, random_) == 0};
      case 14:
        return SetForceMask{{{below(4, random_) != 0, true, true}, {true, true, true}}};
      default:
        break;
    }
    if (command_ < 0) return std::nullopt;
    return test::random_command(test::kFirstWithoutACase + std::size_t(command_ - 15),
                                [this](double low, double high) { return random_.between(low, high); });
  }

  RandomPoses random_;
  double voxel_;
  double period_ = 1e-3;  // [s]
  Simulation simulation_;
  ComposedHand hand_;
  FollowedMock device_;
  SimulationModel model_;
  ComposedInvariants invariants_;
  LoopSnapshot snapshot_;
  Wrench applied_;
  const Spoilt* spoilt_ = &spoilt()[0];
  double last_time_ = 0, last_removed_ = 0, late_ = 0;  // [s], [m^3], [s]
  int tick_ = 0, left_ = 0, every_ = 1, command_ = -1;
  bool is_under_way_ = false, is_open_ = false;
};

TEST(ComposedLoop, KeepsTheInvariants) { compose<Course>(kFewTicks); }

TEST(ComposedLoop, KeepsTheInvariantsForLong) { compose<Course>(many_ticks()); }

TEST(ComposedLoop, GivesTheSameBitsAgain) { expect_the_same_bits<Course>(1, 1500); }

}  // namespace
}  // namespace hapticut::composed_loop_test
