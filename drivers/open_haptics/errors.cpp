// SPDX-License-Identifier: Apache-2.0
#include "open_haptics/errors.hpp"

#include <algorithm>
#include <cstdio>

namespace hapticut::open_haptics {
namespace {

constexpr int kMaxErrors = 1000;  // a driver that fails in every call must not block forever

}  // namespace

DeviceFault fault_of(HDerror code) noexcept {
  switch (code) {
    case HD_SUCCESS:
      return DeviceFault::none;
    case HD_WARM_MOTORS:
      return DeviceFault::motors_warm;
    case HD_EXCEEDED_MAX_FORCE:
    case HD_EXCEEDED_MAX_FORCE_IMPULSE:
    case HD_FORCE_ERROR:
      return DeviceFault::force_limit;
    case HD_EXCEEDED_MAX_VELOCITY:
      return DeviceFault::speed_limit;
    case HD_COMM_ERROR:
    case HD_COMM_CONFIG_ERROR:
    case HD_TIMER_ERROR:
    case HD_INVALID_PRIORITY:
    case HD_SCHEDULER_FULL:
      return DeviceFault::disconnected;
    default:
      return DeviceFault::driver_error;
  }
}

std::string describe(const HDErrorInfo& error) {
  char numbers[64];
  std::snprintf(numbers, sizeof numbers, " (0x%04x, internal %d)", error.errorCode, error.internalErrorCode);
  const char* words = hdGetErrorString(error.errorCode);
  return (words != nullptr ? words : "unknown error") + std::string(numbers);
}

bool Errors::has(HDerror code) const {
  return std::any_of(kept.begin(), kept.begin() + count, [&](const HDErrorInfo& e) { return e.errorCode == code; });
}

std::string Errors::describe() const {
  std::string text;
  for (int n = 0; n < count; ++n) text += (n > 0 ? ", " : "") + open_haptics::describe(kept[std::size_t(n)]);
  return text.empty() ? "no error" : text;
}

Errors drain() noexcept {
  Errors errors;
  for (int n = 0; n < kMaxErrors; ++n) {
    const HDErrorInfo error = hdGetError();
    if (!HD_DEVICE_ERROR(error)) break;
    if (errors.count < int(errors.kept.size())) errors.kept[std::size_t(errors.count++)] = error;
  }
  return errors;
}

}  // namespace hapticut::open_haptics
