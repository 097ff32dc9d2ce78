// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticut {

// How devices of separate components are named. The core uses these texts before a component is registered; then the
// component uses them.
inline constexpr const char* kReplayUsage = "replay:FILE, FILE a recording";
inline constexpr const char* kOpenHapticsUsage = "openhaptics[:NAME], NAME as in the maker's setup program";
inline constexpr const char* kForceDimensionUsage =
    "forcedimension[:NAME], NAME a serial number or a model, e.g. omega.7 or sigma.7-left";

}  // namespace hapticut
