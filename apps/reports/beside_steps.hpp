// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <exception>
#include <future>
#include <optional>
#include <string>
#include <thread>

#include "hapticut/heat/heat_collector.hpp"
#include "hapticut/heat/heat_field.hpp"
#include "hapticut/islands/island_watch.hpp"
#include "hapticut/islands/islands.hpp"
#include "hapticut/loop/change_feed.hpp"
#include "hapticut/loop/realtime_loop.hpp"
#include "reports/beside_report.hpp"

/// @file
/// What the subcommands compute beside the steps: temperatures, and the removal of loose pieces.
namespace hapticut::apps {

/// The temperatures of a run: a collector and its field.
class HeatRun {
 public:
  static constexpr double kPeriod = 0.04;  ///< [s] time of steps after which to advance

  /// @param simulation  must outlive it and must not be moved
  /// @throws Error as HeatField and HeatCollector
  HeatRun(Simulation& simulation, const HeatConfig& config)
      : collector_(simulation), field_(simulation.workpiece(), config) {}

  /// Advances the temperatures by the time of the steps since the last call.
  void advance();

  [[nodiscard]] HeatReport report() const {
    return {field_.config(), field_.structures(), field_.balance(), field_.warmest(), longest_};
  }

 private:
  HeatCollector collector_;
  HeatField field_;
  double longest_ = 0;  // [s]
};

/// The temperatures of a run in real time, advanced in their own thread.
class HeatThread {
 public:
  /// @param simulation  must outlive it and must not be moved; no loop drives it yet
  /// @throws Error as HeatField and HeatCollector
  HeatThread(Simulation& simulation, const HeatConfig& config);
  ~HeatThread() { stop(); }
  HeatThread(const HeatThread&) = delete;
  HeatThread& operator=(const HeatThread&) = delete;

  /// Ends the thread, after the last step.
  /// @throws Error when the temperatures could not be computed
  [[nodiscard]] HeatReport finish();

 private:
  void run();
  void stop();

  HeatRun heat_;
  std::exception_ptr failure_;  // of the thread; read after its end
  std::promise<void> end_;
  bool stopped_ = false;
  std::thread thread_;
};

/// The pieces that were removed from a workpiece.
/// @param count  their number
[[nodiscard]] LoosePieces loose_pieces(std::uint64_t count, const Simulation& simulation);

/// Finds and removes loose pieces between two steps, in the thread that makes the steps.
class PieceRemoval {
 public:
  static constexpr double kPeriod = 0.01;  ///< [s] time of steps between two searches

  /// @param simulation  must outlive it and must not be moved
  /// @throws Error as IslandFinder and ChangeFeed
  explicit PieceRemoval(Simulation& simulation)
      : simulation_(simulation), feed_(simulation), finder_(simulation.workpiece()) {}

  /// Searches, and removes what it finds.
  void search();

  [[nodiscard]] std::uint64_t count() const { return count_; }

 private:
  Simulation& simulation_;
  ChangeFeed feed_;
  IslandFinder finder_;
  std::uint64_t count_ = 0;
};

/// Temperatures and removal of loose pieces in simulated time. Two runs of the same steps give the same bits.
class BesideSteps {
 public:
  /// @param simulation  must outlive it and must not be moved
  /// @param heat        nullopt: no temperatures
  /// @throws Error as HeatRun and PieceRemoval
  BesideSteps(Simulation& simulation, const std::optional<HeatConfig>& heat, bool removes_loose_pieces);

  /// To be called after each step, or tick of a loop, of this duration [s].
  void after_step(double dt);

  /// To be called after the last step.
  [[nodiscard]] BesideReport finish();

 private:
  /// Counts the time until something is due.
  struct Clock {
    double period, since = 0;  // [s]
    [[nodiscard]] bool is_due(double dt);
  };

  const Simulation& simulation_;
  std::optional<HeatRun> heat_;
  std::optional<PieceRemoval> removal_;
  Clock heat_clock_{HeatRun::kPeriod}, removal_clock_{PieceRemoval::kPeriod};
};

/// Temperatures and removal of loose pieces beside a loop. In real time each has its own thread; in simulated time both
/// are computed between two ticks, so that two runs give the same bits.
class BesideLoop {
 public:
  /// @param model  drives a simulation; must outlive it. No loop drives the model yet
  /// @throws Error as BesideSteps, or as HeatThread and IslandModel
  BesideLoop(LoopModel& model, const std::optional<HeatConfig>& heat, bool removes_loose_pieces, bool simulated_time);

  /// The model that the loop drives.
  [[nodiscard]] LoopModel& model();

  /// To be called after the end of the loop.
  /// @throws Error when the temperatures could not be computed
  [[nodiscard]] BesideReport finish();

 private:
  /// A model with what is computed between two ticks.
  class SteppedModel final : public LoopModel {
   public:
    SteppedModel(LoopModel& model, const std::optional<HeatConfig>& heat, bool removes_loose_pieces)
        : beside(*model.simulation(), heat, removes_loose_pieces), model_(model) {}

    Wrench step(const DeviceState& state, double dt, LoopSnapshot& snapshot) noexcept override {
      const Wrench wrench = model_.step(state, dt, snapshot);
      beside.after_step(dt);
      return wrench;
    }
    [[nodiscard]] ModelContact contact() const noexcept override { return model_.contact(); }
    void check(const LoopCommand& command) const override { model_.check(command); }
    bool apply(LoopCommand& command) noexcept override { return model_.apply(command); }
    [[nodiscard]] Simulation* simulation() noexcept override { return model_.simulation(); }

    BesideSteps beside;

   private:
    LoopModel& model_;
  };

  LoopModel& model_;
  std::optional<SteppedModel> stepped_;  // in simulated time
  std::optional<HeatThread> heat_;       // in real time
  std::optional<IslandModel> islands_;   // in real time
};

/// @throws Error when a recording is wanted of a run that removes loose pieces: no replay could repeat it
void require_replayable(const std::string& recording, bool removes_loose_pieces);

}  // namespace hapticut::apps
