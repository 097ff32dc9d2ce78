// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gestures/pieces.hpp"
#include "gestures/story.hpp"
#include "hapticut/device/simulated/mock.hpp"
#include "hapticut/loop/simulation_model.hpp"
#include "support/touch_gains.hpp"

/// @file
/// The ways in which a gesture meets the library: a loop of one's own, or the whole chain of a device.
namespace hapticut::gestures {

using test::touch_gains;

/// How the hand holds the tool in a loop of one's own.
enum class Held { directly, by_coupling };

/// A loop of one's own: a scripted hand moves the tool by `Simulation::step`, or by `VirtualCoupling::step` with what a
/// Touch renders. Several scripts after one another, with anything in between.
class Rig {
 public:
  Rig(Report& report, Workpiece workpiece, Tool tool, Held held, SimulationConfig config = {},
      const std::optional<CouplingGains>& gains = {});
  ~Rig();
  Rig(const Rig&) = delete;
  Rig& operator=(const Rig&) = delete;

  /// From here on the hand holds it by a coupling, and the tool is where the hand is.
  void couple(const CouplingGains& gains);

  /// @param spoil  what becomes of a reading on its way to the library, and of the time [s] since the last; empty:
  /// nothing
  Span play(const Hand& hand, const std::function<void(Pose&, double& dt)>& spoil = {});

  /// The hand, where the last script left it.
  [[nodiscard]] Hand from_here() const { return Hand(end_); }

  /// Tells the report of the invariants.
  void judge() { story.judge(report_, simulation); }

  [[nodiscard]] VirtualCoupling& coupling() { return *coupling_; }

  Simulation simulation;
  Story story;

 private:
  Report& report_;
  std::optional<VirtualCoupling> coupling_;
  std::optional<Pose> last_;
  Pose end_;  // of the last script
  double time_ = 0;
};

/// What the simulation says of its last step. @param turn  of the scene
[[nodiscard]] Tick tick_of(const Simulation& simulation, double time, const Mat3& turn);

struct ChainOptions {
  std::string device = "touch";
  std::string hand = {};  // empty: the stylus is where the script says, whatever the force
  SimulationConfig config = {};
  std::optional<CouplingGains> gains = {};  // empty: coupling_gains of the device
  bool coupled = true;
  WorkspaceMapOptions map = {};
  std::size_t undo_blocks = 0;
};

/// Device -> map -> guard -> coupling -> step: a simulated device runs SimulationModel as RealtimeLoop does.
class Chain {
 public:
  /// @throws Error when the model refuses to be driven by the device
  Chain(Report& report, Workpiece workpiece, Tool tool, ChainOptions options = {});
  ~Chain();
  Chain(const Chain&) = delete;
  Chain& operator=(const Chain&) = delete;

  /// Runs the device with this script, after the arming in the air where it begins.
  Span play(const Hand& hand);

  /// Tells the loop something between two ticks.
  bool tell(LoopCommand command);

  /// Tells the report of the invariants.
  void judge() { story.judge(report_, simulation); }

  /// Once, before the tick of this time [s] of the script.
  void at(double time, std::function<void()> happens) { moments_.push_back({time, std::move(happens)}); }

  std::function<void(double time)> before;                       // each tick
  std::function<void(DeviceState& reading, double time)> spoil;  // on its way from the device

  Simulation simulation;
  Story story;
  RunReport report;
  [[nodiscard]] Device& device();
  [[nodiscard]] SimulationModel& model() { return *model_; }
  [[nodiscard]] const LoopSnapshot& snapshot() const { return snapshot_; }

 private:
  class WatchedMock;
  DeviceCommand tick(const DeviceState& reading);
  void applied(const Wrench& wrench);

  Report& report_;
  ChainOptions options_;
  std::unique_ptr<WatchedMock> device_;
  std::unique_ptr<SimulationModel> model_;
  LoopSnapshot snapshot_;
  ScriptedPath path_;
  struct Moment {
    double time;
    std::function<void()> happens;
  };
  std::vector<Moment> moments_;
  double last_time_ = 0, last_removed_ = 0, seconds_ = 0;
  long count_ = 0;
  std::optional<Tick> under_way_;  // computed, not yet given to the motors
};

}  // namespace hapticut::gestures
