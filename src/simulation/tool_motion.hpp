// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "hapticut/core/spatial.hpp"

namespace hapticut {

/// Where the tool is from step to step, and how it moves. Before its first step, and after an exchange, it has no
/// place.
class ToolMotion {
 public:
  [[nodiscard]] bool is_placed() const noexcept { return placed_; }
  [[nodiscard]] bool is_separated() const noexcept { return separated_; }  ///< from its hand, by an exchange
  [[nodiscard]] const Pose& X_WH() const noexcept { return X_WH_; }        ///< at the end of the last accepted step

  void place_at(const Pose& X_WH) noexcept {
    X_WH_ = X_WH;
    placed_ = true;
    separated_ = false;
  }

  /// Forgets the place, after an exchange. The hand must not feel the material that the tool is in now.
  void forget_place() noexcept {
    separated_ = separated_ || placed_;
    placed_ = false;
    mean_velocity_.reset();
    jumped_to_.reset();
  }
  /// Separates a tool from the hand of the tool that it replaces.
  void separate_as(const ToolMotion& replaced) noexcept { separated_ = replaced.separated_ || replaced.placed_; }

  /// Ends a step.
  /// @param velocity  [m/s] of To, in W
  /// @param dt        [s]
  void arrive_at(const Pose& X_WH, const Vec3& velocity, double dt) noexcept {
    X_WH_ = X_WH;
    mean_velocity_ = mean_with(velocity, dt);
  }

  /// [m/s] The mean of a velocity of To over about kMemory, `dt` later. kMemory is shorter than a change of direction
  /// of a hand, and longer than a tool needs to pass a voxel or to calm down
  /// (docs/decisions/0021-hand-to-the-end.md).
  [[nodiscard]] Vec3 mean_with(const Vec3& velocity, double dt) const noexcept {
    constexpr double kMemory = 0.02;  // [s]
    return mean_velocity_ ? Vec3(*mean_velocity_ + std::min(1.0, dt / kMemory) * (velocity - *mean_velocity_))
                          : velocity;
  }

  // Inputs that are not followed.
  void reject_input() noexcept { after_rejection_ = true; }
  void reject_jump(const Pose& X_WH) noexcept { jumped_to_ = X_WH; }
  void accept_input() noexcept {
    jumped_to_.reset();
    after_rejection_ = false;
  }
  [[nodiscard]] bool is_after_rejection() const noexcept { return after_rejection_; }
  /// Place of the jump that the last step rejected.
  [[nodiscard]] const std::optional<Pose>& rejected_jump() const noexcept { return jumped_to_; }

 private:
  friend struct SimulationMemory;
  bool placed_ = false, separated_ = false;
  Pose X_WH_;
  std::optional<Vec3> mean_velocity_;  // [m/s] velocity of To, in W, over the last steps
  bool after_rejection_ = false;       // the last step's input was rejected
  std::optional<Pose> jumped_to_;
};

}  // namespace hapticut
