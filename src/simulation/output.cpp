// SPDX-License-Identifier: Apache-2.0
#include "hapticut/simulation/output.hpp"

namespace hapticut {

void validate(const Effects& effects, double update_rate) {
  if (effects.gravity) validate(*effects.gravity);
  if (effects.vibration) validate(*effects.vibration, update_rate);
  if (effects.teeth) validate(*effects.teeth);
  if (effects.delta_filter) validate(*effects.delta_filter);
  validate(effects.limits);
}

}  // namespace hapticut
