// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "hapticut/core/abi.hpp"

/// @file
/// How much work it is to make a workpiece, before it is begun: a wrong unit or a stray vertex turns a second into a
/// day.
namespace hapticut {

/// Rough, within a factor of three on a processor of 2020; what it is for is to tell seconds from hours.
struct WorkEstimate {
  double voxels = 0;        ///< [1] of the box that is gone through
  double cut_voxels = 0;    ///< [1] of them: those that the surface cuts, which take most of the time
  double memory_bytes = 0;  ///< [bytes] of the workpiece
  double seconds = 0;       ///< [s]
};

inline constexpr double kMaxMemoryUnasked = 4.0 * (std::uint64_t(1) << 30U);  ///< [bytes]
inline constexpr double kMaxSecondsUnasked = 600;                             ///< [s]

/// What is told of the work before it begins.
using WorkObserver = std::function<void(const WorkEstimate&)>;

/// @param large  the caller has asked for so much
/// @throws Error when it is more than kMaxMemoryUnasked or kMaxSecondsUnasked and nobody has asked for it
void require_allowed(const WorkEstimate& estimate, bool large);

}  // namespace hapticut
