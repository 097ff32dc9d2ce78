// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// [1] How far a case may be off its closed form, by what it is off for.
namespace hapticut::validation {

/// A formula in double precision.
inline constexpr double kDoublePrecision = 1e-9;
/// Sums of some thousand forces in single precision.
inline constexpr double kSinglePrecision = 1e-5;
/// A sum over some ten thousand short steps.
inline constexpr double kFineSteps = 1e-4;
/// What the step's length may change, and the midpoint rule in time.
inline constexpr double kInvariant = 1e-3;
/// Partly filled voxels, five or more across the depth: 0.2 (l/d)^2 where the depth vanishes on the surface.
inline constexpr double kPartialVoxels = 0.01;
/// The same where a rim ends the surface, or a slope: lattice points in a disk, 0.7 (l/R)^1.5.
inline constexpr double kRim = 0.02;
/// A cut whose engaged layer is up to a twentieth of the radius, against forms for a thin one.
inline constexpr double kThinLayer = 0.03;
/// The same for a layer of up to a tenth; and whole voxels, ten or more across the layer that is removed.
inline constexpr double kThickLayer = 0.05;
/// Whole voxels, two across the layer that is removed; and a drill whose radius is that of its outermost voxel.
inline constexpr double kWholeVoxels = 0.1;

}  // namespace hapticut::validation
