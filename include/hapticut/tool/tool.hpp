// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/tool/cutter.hpp"
#include "hapticut/tool/handle.hpp"
#include "hapticut/tool/head.hpp"
#include "hapticut/tool/spindle.hpp"

namespace hapticut {

/// What the hand holds: a head on a handle, turned by a spindle. An immutable description, checked when it is made.
class Tool {
 public:
  /// `Tool(SphereHead{1 * mm}, RayHandle{20 * mm}, Spindle{40000 * rpm})`
  /// @param handle   by default none: the pose of the hand is that of the head, and no lever turns force into torque
  /// @param spindle  by default it stands: the head presses and rubs, and cuts nothing (StepStatus::spindle_stands)
  /// @throws Error when a dimension of the head or handle, a number of the spindle or the lips are out of range, or a
  /// size must have been meant in millimetres
  explicit Tool(ToolHead head, Handle handle = RayHandle{0}, Spindle spindle = {}, Cutter cutter = {})
      : head_(std::move(head)), handle_(handle), spindle_(spindle), cutter_(cutter), X_HT_(head_in_handle(handle)) {
    validate(spindle_);
    validate(cutter_);
    constexpr double kLargestHead = 0.3, kFarthestHead = 5;  // [m] whoever holds it
    require_metres(head_.reach(), kLargestHead, "reach of the head [m]");
    require_metres(X_HT_.translation.norm(), kFarthestHead, "length of the handle [m]");
  }

  [[nodiscard]] const ToolHead& head() const { return head_; }
  [[nodiscard]] const Handle& handle() const { return handle_; }
  [[nodiscard]] const Spindle& spindle() const { return spindle_; }
  [[nodiscard]] const Cutter& cutter() const { return cutter_; }
  [[nodiscard]] const Pose& X_HT() const { return X_HT_; }  ///< pose of the head in the handle frame

 private:
  ToolHead head_;
  Handle handle_;
  Spindle spindle_;
  Cutter cutter_;
  Pose X_HT_;
};

}  // namespace hapticut
