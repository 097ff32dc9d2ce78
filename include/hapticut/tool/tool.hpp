// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "hapticut/tool/handle.hpp"
#include "hapticut/tool/head.hpp"

namespace hapticut {

/// The motor that turns the head.
struct Spindle {
  double speed = 0;  ///< [rad/s] signed about +z of T; 0: the spindle stands and nothing is cut
  double power_limit = std::numeric_limits<double>::infinity();  ///< [W] > 0; above it the spindle slows down
};

/// What the hand holds: a head on a handle, turned by a spindle. An immutable description, checked when it is made.
class Tool {
 public:
  /// @throws Error when a dimension of the head or handle, the speed or the power limit is out of range
  explicit Tool(ToolHead head, Handle handle = RayHandle{}, Spindle spindle = {});

  [[nodiscard]] const ToolHead& head() const { return head_; }
  [[nodiscard]] const Handle& handle() const { return handle_; }
  [[nodiscard]] const Spindle& spindle() const { return spindle_; }
  [[nodiscard]] const Pose& X_HT() const { return X_HT_; }  ///< pose of the head in the handle frame

 private:
  ToolHead head_;
  Handle handle_;
  Spindle spindle_;
  Pose X_HT_;
};

}  // namespace hapticut
