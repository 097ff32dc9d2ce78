// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>

#include "experiments/setup/random_pose.hpp"
#include "hapticut/core/description.hpp"
#include "hapticut/tool/tool.hpp"

/// A hand with a sequence of actions drawn from a seed. Each action has a motion, a duration and a path of the tip. The
/// hand sets the position of the tool, and controls how hard it presses by the force that it feels.
namespace hapticut::test {

/// What the hand does with the tool.
enum class Motion { press, press_hard, drag, tilt, twist, lift, rest, strike, wander };

constexpr auto names_of(Of<Motion>) {
  using enum Motion;
  return std::array{
      Named{press, "press"}, Named{press_hard, "press_hard"}, Named{drag, "drag"},
      Named{tilt, "tilt"},   Named{twist, "twist"},           Named{lift, "lift"},
      Named{rest, "rest"},   Named{strike, "strike"},         Named{wander, "wander"},
  };
}

class ComposedHand {
 public:
  /// @param tool  begins upright, with its tip in the air
  explicit ComposedHand(const Tool& tool) { grip(tool); }

  /// Grips another tool; the handle stays where it is.
  void grip(const Tool& tool) {
    const Vec3 tip_T(0, 0, tool.head().bounding_box().min.z());
    tip_H_ = tool.X_HT() * tip_T;
    if (!begun_) X_WD_.translation = Vec3(0, 0, 0.5 * kAir) - tip_H_;
    begun_ = true;
  }

  /// Draws the next action.
  void begin(Motion motion, RandomPoses& random) {
    motion_ = motion;
    press_ = random.between(0.2, 2.5);
    if (motion == Motion::press_hard) press_ = random.between(3, 40);
    const Vec3 aside = random.direction();
    drag_ = random.between(0.5e-3, 30e-3) * Vec3(aside.x(), aside.y(), 0);
    turn_ = random.between(0.05, 1.5) * Vec3(aside.y(), -aside.x(), 0);
    if (motion == Motion::twist) turn_ = Vec3(0, 0, random.between(-6, 6));
    if (motion == Motion::rest || motion == Motion::press || motion == Motion::press_hard || motion == Motion::strike)
      drag_.setZero();
    if (motion == Motion::wander) drag_ = random.between(1e-3, 60e-3) * aside;
    if (motion != Motion::tilt && motion != Motion::twist && random.between(0, 1) < 0.7) turn_.setZero();
    if (motion == Motion::rest) turn_.setZero();
  }

  /// Advances by a tick.
  /// @param felt  [N] force that the hand felt last
  void move(double felt, double dt) {
    const Vec3 tip = X_WD_ * tip_H_;
    Vec3 linear = drag_;
    Vec3 angular = turn_;
    const bool presses = motion_ != Motion::lift && motion_ != Motion::rest && motion_ != Motion::wander;
    if (presses) linear.z() = -std::clamp(kYield * (press_ - felt), -kFast, tip.z() > 0.3e-3 ? kFast : kSlow);
    if (motion_ == Motion::strike) linear.z() = tip.z() > -1e-3 ? -kStrike : kStrike;
    if (motion_ == Motion::lift) {
      linear = Vec3(0, 0, kFast);
      angular = -2 * vector_from_rotation(X_WD_.rotation);  // upright again
    }
    for (int axis = 0; axis < 3; ++axis) {  // the tip stays in the piece or near it
      const double low = axis == 2 ? -kBelow : -kAside, high = axis == 2 ? kAir : kAside;
      if (tip[axis] < low) linear[axis] = std::max(linear[axis], kFast);
      if (tip[axis] > high) linear[axis] = std::min(linear[axis], -kSlow);
    }
    if (X_WD_.rotation(2, 2) < std::cos(kMaxTilt)) angular = -2 * vector_from_rotation(X_WD_.rotation);
    const double follows = std::min(1.0, dt / kInert);
    speed_.linear += follows * (linear - speed_.linear);
    speed_.angular += follows * (angular - speed_.angular);
    const Mat3 rotation = orthonormalized(rotation_from_vector(dt * speed_.angular) * X_WD_.rotation);
    const Pose before = X_WD_;
    X_WD_ = {rotation, tip + dt * speed_.linear - rotation * tip_H_};
    path_ = twist_between(before, X_WD_, dt);
  }

  [[nodiscard]] const Pose& X_WD() const { return X_WD_; }
  [[nodiscard]] const Twist& velocity() const { return path_; }  ///< velocity of Ho, from the poses
  [[nodiscard]] Motion motion() const { return motion_; }

 private:
  static constexpr double kAir = 1.5e-3, kBelow = 5e-3, kAside = 4.5e-3;  // [m] where the tip may be
  static constexpr double kFast = 60e-3, kSlow = 8e-3, kStrike = 120e-3;  // [m/s]
  static constexpr double kYield = 10e-3;                                 // [m/s/N] gain of its force control
  static constexpr double kInert = 8e-3;                                  // [s]
  static constexpr double kMaxTilt = 0.7;                                 // [rad]

  Pose X_WD_;  // pose of the handle
  Vec3 tip_H_ = Vec3::Zero();
  Twist speed_, path_;  // velocity of the tip; of Ho
  Motion motion_ = Motion::rest;
  double press_ = 0;                                // [N]
  Vec3 drag_ = Vec3::Zero(), turn_ = Vec3::Zero();  // [m/s], [rad/s]
  bool begun_ = false;
};

}  // namespace hapticut::test
