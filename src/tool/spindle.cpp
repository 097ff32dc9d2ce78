// SPDX-License-Identifier: Apache-2.0
#include "hapticut/tool/spindle.hpp"

namespace hapticut {

void validate(const Spindle& spindle) { require_fields_within(spindle, "Spindle::"); }

}  // namespace hapticut
