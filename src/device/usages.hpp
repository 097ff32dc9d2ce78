// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticut {

// How devices of components of their own are named: the core says so before a component is there, and then the
// component.
inline constexpr const char* kReplayUsage = "replay:FILE, FILE a recording";
inline constexpr const char* kOpenHapticsUsage = "openhaptics[:NAME], NAME as in the maker's setup program";
inline constexpr const char* kForceDimensionUsage =
    "forcedimension[:NAME], NAME a serial number or a model, e.g. omega.7 or sigma.7-left";

}  // namespace hapticut
