// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "hapticut/core/abi.hpp"

/// @file
/// An estimate of the work to build a workpiece, before the work begins. A wrong unit or a stray vertex can turn a
/// second into a day.
namespace hapticut {

/// A rough estimate, within a factor of three on a processor of 2020, to distinguish seconds from hours.
struct WorkEstimate {
  double voxels = 0;        ///< [1] number of voxels in the box that is processed
  double cut_voxels = 0;    ///< [1] number of those that the surface cuts; they take most of the time
  double memory_bytes = 0;  ///< [bytes] memory of the workpiece
  double seconds = 0;       ///< [s]
};

/// Limits for a workpiece that is built without `large`.
inline constexpr double kMaxBuildMemory = 4.0 * (std::uint64_t(1) << 30U);  ///< [bytes]
inline constexpr double kMaxBuildTime = 600;                                ///< [s]

/// A function that receives the estimate before the work begins.
using WorkObserver = std::function<void(const WorkEstimate&)>;

/// Checks an estimate against the limits.
/// @param large  whether the caller lifts the limits
/// @throws Error if the estimate exceeds kMaxBuildMemory or kMaxBuildTime and `large` is false
void require_allowed(const WorkEstimate& estimate, bool large);

}  // namespace hapticut
