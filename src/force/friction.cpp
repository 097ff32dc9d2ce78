// SPDX-License-Identifier: Apache-2.0
#include "hapticut/force/friction.hpp"

#include "hapticut/core/errors.hpp"

namespace hapticut {

void validate(const DryFriction& friction) {
  require_not_negative(friction.static_friction, "DryFriction::static_friction [1]");
  require_not_negative(friction.dynamic_friction, "DryFriction::dynamic_friction [1]");
  require_positive(friction.tangential_stiffness, "DryFriction::tangential_stiffness [N/m]");
  if (friction.dynamic_friction > friction.static_friction)
    throw Error("DryFriction::dynamic_friction = " + format_number(friction.dynamic_friction) +
                "; must not exceed static_friction = " + format_number(friction.static_friction) +
                ". Lower it, or raise static_friction.");
}

}  // namespace hapticut
