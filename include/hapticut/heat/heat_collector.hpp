// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>

#include "hapticut/core/description.hpp"
#include "hapticut/loop/change_feed.hpp"
#include "hapticut/simulation/energy.hpp"
#include "hapticut/simulation/observer.hpp"

namespace hapticut {

/// What steps have turned into heat, and where.
struct HeatPulse {
  double dt = 0;
  double cut = 0;
  double rubbed_in_cut = 0;
  double rubbed = 0;
  Vec3 p_WQ = Vec3::Zero();
  double radius = 0;
};

constexpr auto fields_of(Of<HeatPulse>) {
  return std::tuple{
      field("dt", &HeatPulse::dt, "s", "that the steps lasted"),
      field("cut", &HeatPulse::cut, "J", "by cutting, and the springs of what was cut: it is where material went"),
      field("rubbed_in_cut", &HeatPulse::rubbed_in_cut, "J",
            "by rubbing and damping, in steps that cut: it is where material went, too"),
      field("rubbed", &HeatPulse::rubbed, "J", "by rubbing, damping and dry friction, in steps that cut nothing"),
      field("p_WQ", &HeatPulse::p_WQ, "m",
            "where the head rubs without cutting: its surface, against the force; in the last of those steps"),
      field("radius", &HeatPulse::radius, "m", "of what touches there"),
  };
}

/// How heat is collected.
struct HeatCollectorOptions {
  std::size_t pulses = 4096;
  ChangeFeedOptions blocks;
};

constexpr auto fields_of(Of<HeatCollectorOptions>) {
  using O = HeatCollectorOptions;
  return std::tuple{
      field("pulses", &O::pulses, "1", Range::between(1, 1e6),
            "steps under way at once, 72 bytes each; beyond that several become one, and nothing is lost"),
      field("blocks", &O::blocks, "the blocks that change"),
  };
}

/// Takes the heat out of a loop: an observer of the simulation, from its construction to its end, that hands on what
/// each step has dissipated, and the blocks that it has changed. One other thread receives both, `HeatField::take`
/// does; neither waits for the other.
class HeatCollector final : public StepObserver {
 public:
  /// @param simulation  must outlive it, and stay where it is
  /// @throws Error as ChangeFeed, or when an option is out of range
  explicit HeatCollector(Simulation& simulation, const HeatCollectorOptions& options = {});
  ~HeatCollector() override;
  HeatCollector(const HeatCollector&) = delete;
  HeatCollector& operator=(const HeatCollector&) = delete;

  /// Takes one pulse. For the receiving thread.  @return false when there is none
  bool receive(HeatPulse& pulse);

  /// Takes one changed block. For the receiving thread.  @return false when there is none
  bool receive(ChangedBlock& block) { return feed_.receive(block); }

  /// @realtime no allocation, no lock; O(1)
  void on_step(const ObservedStep& step) noexcept override;
  void on_exchange() noexcept override;

 private:
  struct Queue;

  Simulation& simulation_;
  std::unique_ptr<Queue> queue_;
  EnergyLedger before_;  // the last step
  HeatPulse pending_;    // what found no room, and the present step
  ChangeFeed feed_;      // an observer of its own
};

/// Where a head touches what it is pressed against, as its force tells: the point of its surface against the force,
/// seen from where the line of force passes its axis.
/// @param wrench_T  about To, on the tool, in T; without a force the point is To
/// @return p_TQ [m]
/// @realtime no allocation, no lock; O(1)
[[nodiscard]] Vec3 touching_point(const ToolHead& head, const Wrench& wrench_T) noexcept;

}  // namespace hapticut
