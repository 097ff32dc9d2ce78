// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/fixtures.hpp"
#include "hapticut/bench/closed_forms.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/builders.hpp"

/// @file
/// Simple experiments: a head held still in a half space, or fed along a line through a block.
namespace hapticut::validation {

namespace forms = closed_forms;
using fixtures::feed;
using fixtures::hold;
using fixtures::kStiffness;
using fixtures::plain_material;
using fixtures::static_config;
using fixtures::SteadyState;

inline constexpr double kR = 1 * units::mm;  // [m] of the heads, where nothing else is said
inline constexpr double kTick = 1e-3;        // [s]

}  // namespace hapticut::validation
