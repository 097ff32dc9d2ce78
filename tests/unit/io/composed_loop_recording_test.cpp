// SPDX-License-Identifier: Apache-2.0
// Random runs of a loop, from a seed: commands, a pedal, a guard that holds the spindle, and readings that are refused.
// The replay of each recording has the same bits. HAPTICUT_COMPOSED_SEED=n begins with the seed that a failure names.
#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "hapticut/loop/coupling_gains.hpp"
#include "hapticut/loop/simulation_model.hpp"
#include "support/composed_hand.hpp"
#include "support/composed_scenes.hpp"
#include "support/followed_mock.hpp"
#include "support/random_commands.hpp"
#include "support/recordings.hpp"
#include "support/temporary_folder.hpp"

namespace hapticut::composed_loop_recording_test {
namespace {

using namespace test;
using units::mm;

class RecordedLoop {
 public:
  explicit RecordedLoop(std::uint64_t seed)
      : random_(seed),
        voxel_(random_.between(0.12, 0.25) * mm),
        simulation_{some_piece(voxel_, random_), some_tool(random_), some_config(random_)},  // drawn in this order
        hand_(simulation_.tool()),
        device_(rigid_touch(), [this](DeviceState& state) { read(state); }) {
    simulation_.history().reserve(2000);
  }

  /// Records a run of the loop, and replays it. The next run begins with a clone of the workpiece.
  void record(const std::filesystem::path& path, int ticks) {
    {
      SimulationModelOptions with;
      with.coupling = coupling_gains(device_.capabilities());
      with.undo_blocks = 2000;
      with.pedal = below(2, random_) == 0 ? 0 : -1;
      SimulationModel model(simulation_, device_, with);
      const StepLog log(simulation_);
      RecorderOptions options = patient();
      options.driven_by = &device_;
      Recorder recorder(path, simulation_, options);
      run(model, ticks);
      recorder.close();
      expect_repeats(path, log);
      steps_ += log.bits().size();
    }
    simulation_.reset(simulation_.workpiece().clone());
    simulation_.set(RemovalLaw::constant_energy);
  }
  [[nodiscard]] std::uint64_t steps() const { return steps_; }                      // recorded ones
  [[nodiscard]] std::uint64_t held_in_contact() const { return held_in_contact_; }  // ticks

 private:
  void run(SimulationModel& model, int ticks) {
    RunOptions options;
    options.simulated_time = true;
    options.stop_on_signals = false;
    options.guard.arming.ramp = options.guard.arming.short_ramp = 0.02;
    const int end = below(2, random_) == 0 ? ticks : below(ticks, random_);  // from here on, commands may end it
    int tick = 0;
    LoopSnapshot snapshot;
    (void)device_.run(
        [&](const DeviceState& reading) {
          if (left_-- <= 0) begin_action(snapshot);
          if (below(20, random_) == 0) tell(model, below(tick >= end ? 16 + test::kCommandsWithoutACase : 11, random_));
          DeviceCommand command;
          command.wrench = model.step(reading, 1e-3, snapshot);
          command.contact = model.contact();
          command.stop = ++tick >= ticks;
          felt_ = snapshot.tool.force.norm();
          if (simulation_.spindle().is_held() && snapshot.tool.contact_voxels > 0) ++held_in_contact_;
          return command;
        },
        options);
  }

  void begin_action(const LoopSnapshot& snapshot) {
    left_ = int(random_.between(10, 200));
    pressed_ = below(2, random_) == 0;
    hand_.begin(snapshot.tool.status == StepStatus::ok ? Motion(below(9, random_)) : Motion::lift, random_);
  }

  /// The readings are those of the hand, sometimes with a fault.
  void read(DeviceState& state) noexcept {
    hand_.move(felt_, 1e-3);
    state.X_BS = hand_.X_WD();
    state.velocity = hand_.velocity();
    state.buttons = pressed_ ? 1 : 0;
    const int fault = below(300, random_);
    if (fault == 0) state.X_BS.translation.y() = std::numeric_limits<double>::quiet_NaN();
    if (fault == 1) state.X_BS.rotation.col(0) *= -1;
    if (fault == 2) state.X_BS.translation += random_.vector(40 * mm);
    if (fault == 3) state.valid = false;
  }

  /// @param what  from 11 on, the command ends the recording
  void tell(SimulationModel& model, int what) {
    LoopCommand command = command_of(model, what);
    model.check(command);
    (void)model.apply(command);
  }

  LoopCommand command_of(const SimulationModel& model, int what) {
    using namespace commands;
    const double own = simulation_.tool().spindle().speed;
    switch (what) {
      case 0:
        return OpenClutch{};
      case 1:
      case 2:
        return CloseClutch{};
      case 3:
        return SetSpindleSpeed{-own * units::rad_per_s};
      case 4:
        return SetSpindleSpeed{};
      case 5:
        return SetSpindleSpeed{simulation_.spindle().setting()};
      case 6:
        return SetScale{random_.between(0.8, 1.2)};
      case 7:
        return SetUndoMark{};
      case 8:
        return HoldForce{below(3, random_) == 0};
      case 9:
        return SetForceMask{{{below(4, random_) != 0, true, true}, {true, true, true}}};
      case 10:
        return SetEffects{};
      case 11:
        return Undo{};
      case 12:
        return SetFriction{DryFriction{0.4, 0.3, 1000}};
      case 13:
        return SetRemoval{RemovalLaw::none};
      case 14:
        return model.prepare_materials(some_materials(random_));
      case 15:
        return exchange(model);
      default:
        return test::random_command(test::kFirstWithoutACase + std::size_t(what - 16),
                                    [this](double low, double high) { return random_.between(low, high); });
    }
  }

  LoopCommand exchange(const SimulationModel& model) {
    const Tool tool = some_tool(random_);
    hand_.grip(tool);
    if (below(2, random_) == 0) return model.prepare_tool(tool);
    return model.prepare_workpiece(some_piece(voxel_, random_), tool);
  }

  RandomPoses random_;
  double voxel_;
  Simulation simulation_;
  ComposedHand hand_;
  FollowedMock device_;
  int left_ = 0;
  bool pressed_ = false;
  double felt_ = 0;  // [N]
  std::uint64_t steps_ = 0, held_in_contact_ = 0;
};

TEST(ComposedLoopRecording, ReplaysWithTheSameBits) {
  constexpr std::uint64_t kRuns = kWithAddressSanitizer ? 3 : 8;
  const TemporaryFolder folder;
  const std::uint64_t first = number_from("HAPTICUT_COMPOSED_SEED", 1);
  const std::uint64_t runs = number_from("HAPTICUT_COMPOSED_RUNS", kRuns);
  std::uint64_t steps = 0, held_in_contact = 0;
  for (std::uint64_t seed = first; seed < first + runs; ++seed) {
    RecordedLoop loop(seed);
    for (int n = 0; n < 3 && !HasFailure(); ++n) loop.record(folder / "a.h5", 1200);
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
    steps += loop.steps();
    held_in_contact += loop.held_in_contact();
  }
  std::cout << steps << " recorded steps, " << held_in_contact << " ticks with a held spindle in material\n";
  EXPECT_GT(steps, 5000U);
  EXPECT_GT(held_in_contact, 100U);
}

}  // namespace
}  // namespace hapticut::composed_loop_recording_test
