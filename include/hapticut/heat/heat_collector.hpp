// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "hapticut/core/description.hpp"
#include "hapticut/loop/change_feed.hpp"
#include "hapticut/simulation/energy.hpp"
#include "hapticut/simulation/observer.hpp"
#include "hapticut/tool/cutter.hpp"

namespace hapticut {

/// Heat that steps have produced, and where.
struct HeatPulse {
  double dt = 0;  ///< [s] duration of the steps
  /// [J] heat of cutting, and of springs of cut material; it arises where material was removed
  double cut = 0;
  /// [J] heat of rubbing and damping, in steps that cut; it also arises where material was removed
  double rubbed_in_cut = 0;
  double share = 0;   ///< [1] part of `cut` and `rubbed_in_cut` that heats the wall, by the cutter of the last step
  double rubbed = 0;  ///< [J] heat of rubbing, damping and dry friction, in steps that cut nothing
  /// [m] where the head rubs without cutting: the point of its surface opposite to the force, in the last step
  Vec3 p_WQ = Vec3::Zero();
  double radius = 0;  ///< [m] radius of the contact there
};

constexpr auto fields_of(Of<HeatPulse>) {
  return std::tuple{
      field("dt", &HeatPulse::dt, "s", "duration of the steps"),
      field("cut", &HeatPulse::cut, "J",
            "heat of cutting, and of springs of cut material; it arises where material was removed"),
      field("rubbed_in_cut", &HeatPulse::rubbed_in_cut, "J",
            "heat of rubbing and damping, in steps that cut; it also arises where material was removed"),
      field("share", &HeatPulse::share, "1",
            "part of `cut` and `rubbed_in_cut` that heats the wall, by the cutter of the last step"),
      field("rubbed", &HeatPulse::rubbed, "J", "heat of rubbing, damping and dry friction, in steps that cut nothing"),
      field("p_WQ", &HeatPulse::p_WQ, "m",
            "where the head rubs without cutting: the point of its surface opposite to the force, in the last step"),
      field("radius", &HeatPulse::radius, "m", "radius of the contact there"),
  };
}

/// How heat is collected.
struct HeatCollectorOptions {
  /// [1] steps in the queue, 80 bytes each; beyond that several become one, and nothing is lost
  std::size_t pulses = 4096;
  ChangeFeedOptions blocks;  ///< queue of changed blocks
};

constexpr auto fields_of(Of<HeatCollectorOptions>) {
  using O = HeatCollectorOptions;
  return std::tuple{
      field("pulses", &O::pulses, "1", Range::between(1, 1e6),
            "steps in the queue, 80 bytes each; beyond that several become one, and nothing is lost"),
      field("blocks", &O::blocks, "queue of changed blocks"),
  };
}

/// Passes heat from a loop to another thread. It is an observer of the simulation for its whole life. It passes on the
/// energy that each step has dissipated, and the blocks that the step has changed. One other thread receives both with
/// `HeatField::drain`; neither thread waits for the other.
class HeatCollector final : public StepObserver {
 public:
  /// @param simulation  must outlive it and must not be moved
  /// @throws Error as ChangeFeed, or when an option is out of range
  explicit HeatCollector(Simulation& simulation, const HeatCollectorOptions& options = {});
  ~HeatCollector() override;
  HeatCollector(const HeatCollector&) = delete;
  HeatCollector& operator=(const HeatCollector&) = delete;

  /// Receives one pulse. For the receiving thread.  @return false when there is none
  bool receive(HeatPulse& pulse);

  /// Receives one changed block. For the receiving thread.  @return false when there is none
  bool receive(ChangedBlock& block) { return feed_.receive(block); }

  /// @realtime no allocation, no lock; O(1)
  void on_step(const ObservedStep& step) noexcept override;
  void on_exchange() noexcept override;

 private:
  struct Queue;

  Simulation& simulation_;
  std::unique_ptr<Queue> queue_;
  const std::vector<double> shares_;  // [1] by CutterKind
  EnergyLedger before_;               // ledger of the last step
  HeatPulse pending_;                 // heat of steps that did not fit the queue, and of the present step
  ChangeFeed feed_;                   // a second observer
};

/// [1] Part of the work of a cut that heats the wall; the rest leaves with chips and tool. preset_constants has its
/// range and source.
[[nodiscard]] double heat_share_of(CutterKind cutter);

/// The point at which a head touches material, from its force: the point of its surface opposite to the force, as seen
/// from where the line of the force passes the axis.
/// @param wrench_T  about To, on the tool, in T; without a force the point is To
/// @return p_TQ [m]
/// @realtime no allocation, no lock; O(1)
[[nodiscard]] Vec3 touching_point(const ToolHead& head, const Wrench& wrench_T) noexcept;

}  // namespace hapticut
