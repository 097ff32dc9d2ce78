// SPDX-License-Identifier: Apache-2.0
#include "hapticut/tool/tool.hpp"

#include <cmath>

#include "hapticut/core/errors.hpp"

namespace hapticut {

Tool::Tool(ToolHead head, Handle handle, Spindle spindle)
    : head_(std::move(head)), handle_(handle), spindle_(spindle), X_HT_(head_in_handle(handle)) {
  if (!std::isfinite(spindle_.speed))
    throw Error("Spindle::speed = " + format_number(spindle_.speed) +
                " rad/s; must be finite. Give 0 for a standing spindle.");
  if (!(spindle_.power_limit > 0))
    throw Error("Spindle::power_limit = " + format_number(spindle_.power_limit) +
                " W; must be > 0. Leave it at infinity for a motor without a limit.");
}

}  // namespace hapticut
