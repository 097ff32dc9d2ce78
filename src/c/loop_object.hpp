// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include "c/device_object.hpp"
#include "c/simulation_object.hpp"
#include "hapticut/loop/realtime_loop.hpp"
#include "hapticut/loop/simulation_model.hpp"
#include "hapticut/sound/loop_listener.hpp"

namespace hapticut::c {

/// The model of a loop, which also removes loose pieces between two ticks.
class RemovingModel final : public LoopModel {
 public:
  RemovingModel(LoopModel& model, SimulationObject& simulation) : model_(model), simulation_(simulation) {}

  Wrench step(const DeviceState& state, double dt, LoopSnapshot& snapshot) noexcept override {
    Wrench wrench = model_.step(state, dt, snapshot);
    simulation_.remove_loose_pieces();
    return wrench;
  }
  [[nodiscard]] ModelContact contact() const noexcept override { return model_.contact(); }
  void check(const LoopCommand& command) const override { model_.check(command); }
  bool apply(LoopCommand& command) noexcept override { return model_.apply(command); }
  [[nodiscard]] Simulation* simulation() noexcept override { return model_.simulation(); }

 private:
  LoopModel& model_;
  SimulationObject& simulation_;
};

/// A loop from its start to its end. It owns simulation and device meanwhile.
///
/// Lanes: `first` starts and stops, `reading` reads snapshots, `sending` sends commands.
class LoopObject final : public Object {
 public:
  static constexpr Kind kKind = Kind::loop;

  /// Starts the run.  @pre the calling thread is in the first lane of simulation and device, and no loop drives them
  LoopObject(std::shared_ptr<SimulationObject> simulation, std::shared_ptr<DeviceObject> device,
             const SimulationModelOptions& model, const RealtimeLoopOptions& options);
  ~LoopObject() override;

  /// Ends the run; later calls do nothing.  @throws what the run threw
  void stop();

  const std::shared_ptr<SimulationObject> simulation;
  const std::shared_ptr<DeviceObject> device;
  SimulationModel model;
  RemovingModel removing;
  RealtimeLoop loop;
  LoopListener listener;            // used in lane reading
  std::atomic<bool> running{true};  // until stopped
  RunReport report;                 // used in lane first, after the end

 private:
  void release_objects() noexcept;
};

}  // namespace hapticut::c
