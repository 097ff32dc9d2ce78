// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiments/checks.hpp"

/// @file
/// How far a case may be off its closed form, by what it is off for.
namespace hapticut::experiments {

/// A formula in double precision.
inline constexpr Tolerance kDoublePrecision = {1e-9, "double precision"};
/// Sums of some thousand forces in single precision.
inline constexpr Tolerance kSinglePrecision = {1e-5, "single precision"};
/// A sum over some ten thousand short steps.
inline constexpr Tolerance kFineSteps = {1e-4, "short steps"};
/// What the step's length may change, and the midpoint rule in time.
inline constexpr Tolerance kInvariant = {1e-3, "length of a step"};
/// Partly filled voxels, twenty or more across the depth.
inline constexpr Tolerance kFineVoxels = {2e-3, "voxels of d/20"};
/// The same of a force that is taken to a derivative.
inline constexpr Tolerance kCutVoxels = {0.005, "voxels of d/27, a derivative"};
/// Partly filled voxels, five or more across the depth: 0.2 (l/d)^2 where the depth vanishes on the surface.
inline constexpr Tolerance kPartialVoxels = {0.01, "cut voxels"};
/// The same where a rim ends the surface, or a slope: lattice points in a disk, 0.7 (l/R)^1.5.
inline constexpr Tolerance kRim = {0.02, "voxels at a rim or slope"};
/// A cut whose engaged layer is a fortieth of the radius, fed sideways or by a hand.
inline constexpr Tolerance kOfThinLayer = {0.02, "layer of R/40"};
/// A cut whose engaged layer is up to a twentieth of the radius, against forms for a thin one.
inline constexpr Tolerance kThinLayer = {0.03, "layer of R/20"};
/// The same for a layer of up to a tenth; and whole voxels, ten or more across the layer that is removed.
inline constexpr Tolerance kThickLayer = {0.05, "layer of R/10"};
/// Whole voxels, two across the layer that is removed; and a drill whose radius is that of its outermost voxel.
inline constexpr Tolerance kWholeVoxels = {0.1, "whole voxels"};

}  // namespace hapticut::experiments
