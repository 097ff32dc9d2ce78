// SPDX-License-Identifier: Apache-2.0
#pragma once

// The devices of the makers whose SDK was found; cmake/HapticutMakerSdk.cmake defines the macros.
#ifdef HAPTICUT_HAS_FORCEDIMENSION
#include "hapticut/device/force_dimension.hpp"
#endif
#ifdef HAPTICUT_HAS_OPENHAPTICS
#include "hapticut/device/open_haptics.hpp"
#endif

namespace hapticut {

/// Registers these devices for `open_device`. Static, because a program may link a target with an SDK and one without.
[[maybe_unused]] static void use_maker_devices() {
#ifdef HAPTICUT_HAS_FORCEDIMENSION
  use_force_dimension();
#endif
#ifdef HAPTICUT_HAS_OPENHAPTICS
  use_open_haptics();
#endif
}

}  // namespace hapticut
