// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiments/checks.hpp"

/// @file
/// Allowed errors of closed forms, by reason.
namespace hapticut::experiments {

/// Formulas in double precision.
inline constexpr Tolerance kDoublePrecision = {1e-9, "double precision"};
/// Sums of some thousand forces in single precision.
inline constexpr Tolerance kSinglePrecision = {1e-5, "single precision"};
/// Sums over some ten thousand short steps.
inline constexpr Tolerance kFineSteps = {1e-4, "short steps"};
/// Length of a step, and the midpoint rule in time.
inline constexpr Tolerance kInvariant = {1e-3, "length of a step"};
/// Partly filled voxels, twenty or more across the depth.
inline constexpr Tolerance kFineVoxels = {2e-3, "voxels of d/20"};
/// Partly filled voxels, for the derivative of a force.
inline constexpr Tolerance kCutVoxels = {0.005, "voxels of d/27, a derivative"};
/// Partly filled voxels, five or more across the depth: 0.2 (l/d)^2 where the depth vanishes on the surface.
inline constexpr Tolerance kPartialVoxels = {0.01, "cut voxels"};
/// Partly filled voxels at a rim or a slope: lattice points in a disk, 0.7 (l/R)^1.5.
inline constexpr Tolerance kRim = {0.02, "voxels at a rim or slope"};
/// Cuts with an engaged layer of R/40, fed sideways or by a hand.
inline constexpr Tolerance kOfThinLayer = {0.02, "layer of R/40"};
/// Cuts with an engaged layer of up to R/20, compared with forms for a thin layer.
inline constexpr Tolerance kThinLayer = {0.03, "layer of R/20"};
/// Cuts with an engaged layer of up to R/10; and whole voxels, ten or more across the removed layer.
inline constexpr Tolerance kThickLayer = {0.05, "layer of R/10"};
/// Whole voxels, two across the removed layer; and a drill whose radius is that of its outermost voxel.
inline constexpr Tolerance kWholeVoxels = {0.1, "whole voxels"};

}  // namespace hapticut::experiments
