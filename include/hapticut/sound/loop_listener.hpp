// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

#include "hapticut/core/errors.hpp"
#include "hapticut/loop/snapshot.hpp"
#include "hapticut/sound/drill_sound.hpp"

namespace hapticut {

/// Converts the snapshots of a loop to the input of DrillSound, in a thread beside the loop. Power and removal rate are
/// means between two snapshots.
class LoopListener {
 public:
  /// @param rate  [Hz] ticks a second of the loop, > 0
  /// @throws Error when it is not positive
  explicit LoopListener(double rate = 1000) : rate_(rate) {
    require_within(rate, Range::positive(), "the rate of a LoopListener [Hz]");
  }

  /// @param snapshot  the latest; a repeated snapshot gives the same input
  /// @realtime no allocation, no lock; O(1)
  const SoundInput& listen(const LoopSnapshot& snapshot) noexcept {
    const ToolSnapshot& tool = snapshot.tool;
    if (snapshot.tick == tick_) return input_;
    const double elapsed = snapshot.tick > tick_ ? double(snapshot.tick - tick_) / rate_ : 0.0;
    input_.spindle_speed = tool.spindle_speed;
    input_.touching = tool.contact_voxels > 0;
    input_.power = elapsed > 0 ? std::max(0.0, tool.dissipated - dissipated_) / elapsed : 0.0;
    input_.removal_rate = elapsed > 0 ? std::max(0.0, tool.removed_volume - removed_) / elapsed : 0.0;
    tick_ = snapshot.tick, dissipated_ = tool.dissipated, removed_ = tool.removed_volume;
    return input_;
  }

 private:
  double rate_;
  std::uint64_t tick_ = 0;
  double dissipated_ = 0, removed_ = 0;  // [J], [m^3] values of the last snapshot
  SoundInput input_;
};

}  // namespace hapticut
