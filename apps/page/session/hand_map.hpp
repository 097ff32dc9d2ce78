// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "loop/hand_map.hpp"

namespace hapticut::apps {

using hapticut::map_above;
using hapticut::Up;

}  // namespace hapticut::apps
