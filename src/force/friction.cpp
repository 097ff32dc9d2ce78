// SPDX-License-Identifier: Apache-2.0
#include "hapticut/force/friction.hpp"

#include "hapticut/core/errors.hpp"

namespace hapticut {

void validate(const DryFriction& friction) {
  require_fields_within(friction, "DryFriction::");
  if (friction.dynamic_friction > friction.static_friction)
    throw Error("DryFriction::dynamic_friction = " + format_number(friction.dynamic_friction) +
                "; must not exceed static_friction = " + format_number(friction.static_friction) +
                ". Lower it, or raise static_friction.");
}

}  // namespace hapticut
