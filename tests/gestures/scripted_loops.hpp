// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gestures/pieces.hpp"
#include "gestures/scene_log.hpp"
#include "hapticut/loop/simulation_model.hpp"
#include "support/followed_mock.hpp"
#include "support/touch_gains.hpp"

/// @file
/// Two ways to run a gesture: a loop that calls the step directly, and the whole chain of a device.
namespace hapticut::gestures {

using test::touch_gains;

/// How the hand holds the tool in a ScriptedLoop.
enum class Grip { directly, by_coupling };

/// A scripted hand moves the tool by `Simulation::step`, or by `VirtualCoupling::step` with the gains of a Touch.
/// Several scripts may run in sequence.
class ScriptedLoop {
 public:
  ScriptedLoop(Report& report, Workpiece workpiece, Tool tool, Grip grip, SimulationConfig config = {},
               const std::optional<CouplingGains>& gains = {});
  ~ScriptedLoop();
  ScriptedLoop(const ScriptedLoop&) = delete;
  ScriptedLoop& operator=(const ScriptedLoop&) = delete;

  /// Puts a coupling between hand and tool. The tool starts at the hand.
  void couple(const CouplingGains& gains);

  /// @param spoil  changes a reading before the library gets it, and the time [s] since the last one; empty: no change
  Span play(const Hand& hand, const std::function<void(Pose&, double& dt)>& spoil = {});

  /// A hand that starts where the last script ended.
  [[nodiscard]] Hand from_here() const { return Hand(end_); }

  /// Adds the invariants to the report.
  void judge() { log.judge(report_, simulation); }

  [[nodiscard]] VirtualCoupling& coupling() { return *coupling_; }

  Simulation simulation;
  SceneLog log;

 private:
  Report& report_;
  std::optional<VirtualCoupling> coupling_;
  std::optional<Pose> last_;
  Pose end_;  // pose at the end of the last script
  double time_ = 0;
};

/// The tick of the simulation's last step. @param turn  rotation of the scene
[[nodiscard]] Tick tick_of(const Simulation& simulation, double time, const Mat3& turn);

struct ChainOptions {
  std::string device = "touch";
  std::string hand = {};  // empty: the stylus follows the script at any force
  SimulationConfig config = {};
  std::optional<CouplingGains> gains = {};  // empty: coupling_gains of the device
  bool coupled = true;
  WorkspaceMapOptions map = {};
  std::size_t undo_blocks = 0;
};

/// Device -> map -> guard -> coupling -> step: a simulated device runs a SimulationModel, as RealtimeLoop does.
class DeviceChain {
 public:
  /// @throws Error when the model refuses to be driven by the device
  DeviceChain(Report& report, Workpiece workpiece, Tool tool, ChainOptions options = {});
  ~DeviceChain();
  DeviceChain(const DeviceChain&) = delete;
  DeviceChain& operator=(const DeviceChain&) = delete;

  /// Runs the device with this script. The guard arms first, in the air where the script begins.
  Span play(const Hand& hand);

  /// Applies a command between two ticks.
  bool tell(LoopCommand command);

  /// Adds the invariants to the report.
  void judge() { log.judge(report_, simulation); }

  /// Calls a function once, before the tick at this time [s] of the script.
  void at(double time, std::function<void()> happens) { moments_.push_back({time, std::move(happens)}); }

  std::function<void(double time)> before;                       // each tick
  std::function<void(DeviceState& reading, double time)> spoil;  // changes a reading of the device

  Simulation simulation;
  SceneLog log;
  RunReport report;
  [[nodiscard]] Device& device();
  [[nodiscard]] SimulationModel& model() { return *model_; }
  [[nodiscard]] const LoopSnapshot& snapshot() const { return snapshot_; }

 private:
  DeviceCommand tick(const DeviceState& reading);
  void applied(const Wrench& wrench);

  Report& report_;
  ChainOptions options_;
  std::unique_ptr<test::FollowedMock> device_;
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
  std::optional<Tick> under_way_;  // computed, not yet sent to the motors
};

}  // namespace hapticut::gestures
