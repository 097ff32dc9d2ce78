// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <HD/hd.h>

#include <array>
#include <string>

#include "hapticut/safety/device_state.hpp"

namespace hapticut::open_haptics {

/// The fault that an error of the driver means for a run.
[[nodiscard]] DeviceFault fault_of(HDerror code) noexcept;

/// An error as text, with its numbers.
[[nodiscard]] std::string describe(const HDErrorInfo& error);

/// The drained errors, newest first. A fixed number is kept; all are removed from the driver's stack.
struct Errors {
  std::array<HDErrorInfo, 16> kept{};
  int count = 0;  ///< number of kept errors

  [[nodiscard]] bool any() const { return count > 0; }
  [[nodiscard]] bool has(HDerror code) const;
  [[nodiscard]] std::string describe() const;
};

/// Empties the driver's error stack, which is one for the whole process.  @realtime no allocation
Errors drain() noexcept;

}  // namespace hapticut::open_haptics
