// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiments/checks.hpp"
#include "experiments/setup/cutting.hpp"
#include "experiments/setup/static_contact.hpp"
#include "experiments/tolerances.hpp"
#include "hapticut/closed_forms.hpp"
#include "hapticut/core/units.hpp"

/// @file
/// Common names of the experiments: a head at rest in a half space, or fed along a line through a block.
namespace hapticut::experiments {

namespace forms = closed_forms;
using test::feed;
using test::kStiffness;
using test::plain_material;
using test::rest_at;
using test::static_config;
using test::SteadyState;
using units::deg;
using units::kPi;
using units::mm;

inline constexpr double kR = 1 * mm;   // [m] radius of the heads, unless stated
inline constexpr double kTick = 1e-3;  // [s]

}  // namespace hapticut::experiments
