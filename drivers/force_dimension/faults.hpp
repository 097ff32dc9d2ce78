// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "hapticut/safety/device_state.hpp"

namespace hapticut::force_dimension {

/// Errors of the library, by number because names in its header have changed between versions.
namespace error {
inline constexpr int kNone = 0, kCommunication = 2, kBusy = 3, kNoDriver = 4, kNoDevice = 5, kNotAvailable = 6,
                     kTimeout = 7, kGeometry = 8, kNotReady = 12, kNotEnabled = 19;
}

/// Why the device has switched its forces off, with the numbers of the library.
enum class ForceOff : std::uint8_t { none, button, velocity, watchdog, software, usb, deadman, count };

/// The fault that a cause means for a run.
[[nodiscard]] DeviceFault fault_of(ForceOff cause) noexcept;

/// Whether the forces may be switched on again without a user action.
[[nodiscard]] bool can_reenable(ForceOff cause) noexcept;

/// A cause as text, and what to do.
[[nodiscard]] const char* describe(ForceOff cause) noexcept;

/// The fault that an error of the library means for a run. `none`: the call may succeed the next time.
[[nodiscard]] DeviceFault fault_of(int code) noexcept;

}  // namespace hapticut::force_dimension
