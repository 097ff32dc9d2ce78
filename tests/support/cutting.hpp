// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/fixtures.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/builders.hpp"

/// @file
/// Steady cuts with a straight handle of length 0 (handle frame = head frame, axes along W), and their means.
namespace hapticut::test {

using fixtures::feed;
using fixtures::plain_material;
using fixtures::SteadyState;

}  // namespace hapticut::test
