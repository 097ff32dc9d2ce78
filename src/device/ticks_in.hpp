// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

namespace hapticut {

/// [ticks] The number of ticks in a time, at least 1.
inline std::uint64_t ticks_in(double seconds, double period) noexcept {
  const double ticks = std::round(seconds / period);
  return ticks > 1 ? std::uint64_t(ticks) : 1;
}

}  // namespace hapticut
