// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "hapticut/tool/handle.hpp"
#include "hapticut/tool/head.hpp"
#include "hapticut/tool/spindle.hpp"

namespace hapticut {

/// What the hand holds: a head on a handle, turned by a spindle. An immutable description, checked when it is made.
class Tool {
 public:
  /// @throws Error when a dimension of the head or handle, the speed or the power limit is out of range
  explicit Tool(ToolHead head, Handle handle = RayHandle{}, Spindle spindle = {})
      : head_(std::move(head)), handle_(handle), spindle_(spindle), X_HT_(head_in_handle(handle)) {
    validate(spindle_);
  }

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
