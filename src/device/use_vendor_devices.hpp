// SPDX-License-Identifier: Apache-2.0
#pragma once

// The devices of those makers whose SDK is here, as cmake/HapticutVendorSdk.cmake tells a target.
#ifdef HAPTICUT_HAS_FORCEDIMENSION
#include "hapticut/device/force_dimension.hpp"
#endif
#ifdef HAPTICUT_HAS_OPENHAPTICS
#include "hapticut/device/open_haptics.hpp"
#endif

namespace hapticut {

/// Makes `open_device` know them. Static, for a program may have a target with an SDK beside one without.
[[maybe_unused]] static void use_vendor_devices() {
#ifdef HAPTICUT_HAS_FORCEDIMENSION
  use_force_dimension();
#endif
#ifdef HAPTICUT_HAS_OPENHAPTICS
  use_open_haptics();
#endif
}

}  // namespace hapticut
