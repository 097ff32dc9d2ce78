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

/// A loop, from its start to its end; simulation and device are its own meanwhile.
///
/// Lanes: `first` starts and stops, `looking` looks at snapshots, `sending` sends commands.
class LoopObject final : public Object {
 public:
  static constexpr Kind kKind = Kind::loop;

  /// Begins to run.  @pre the first lanes of simulation and device are the caller's, and no loop drives them
  LoopObject(std::shared_ptr<SimulationObject> simulation, std::shared_ptr<DeviceObject> device,
             const SimulationModelOptions& model, const RealtimeLoopOptions& options);
  ~LoopObject() override;

  /// Ends the run, once.  @throws what the run threw
  void stop();

  const std::shared_ptr<SimulationObject> simulation;
  const std::shared_ptr<DeviceObject> device;
  SimulationModel model;
  RealtimeLoop loop;
  LoopListener listener;            // in lane looking
  std::atomic<bool> running{true};  // not yet stopped
  RunReport report;                 // in lane first, after the end

 private:
  void give_back() noexcept;
};

}  // namespace hapticut::c
