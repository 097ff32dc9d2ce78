// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "hapticut/formulas/numbers.hpp"

/// @file
/// Integrals over a voxel that the interface between head and material crosses.
///
/// The remaining material of a voxel lies on the side away from the head: it is the part of the cube beyond a plane
/// across the head's normal n. Neighbouring voxels are not needed. Along n the cube is modelled as the convolution of
/// two boxes (a trapezoid):
///
///     widths   p = max |n_i|,  q = sqrt(1 - p^2)      [voxel edges], n in the grid's axes
///
///     section  A(v)        ____________
///                         /            \           v: distance from the corner farthest from the head, towards it
///                        /              \          h = p + q: the corner nearest to the head
///                       /                \         V(v) = integral of A: filled fraction
///                      0   q          p   h
///
/// The exact section of a cube is the convolution of three boxes of width |n_i|. The sections of all voxels that a
/// plane crosses add up to the plane, at any position of the plane, because one box is as wide as a step of the grid
/// along n: the largest, p. The other two boxes matter only through their variance, and q has the same variance. The
/// force of a thin layer, pressure times section, therefore does not ripple as grid points enter and leave, in any
/// direction of the grid (docs/decisions/0009-cut-voxels.md).
namespace hapticut {

/// [voxel edges] A voxel whose centre is this far outside the head cannot reach into it: half of its largest p + q.
inline constexpr float kVoxelReach = 0.70710678F;

/// [1] 1/sqrt(3): the smallest possible value of the largest component of a unit vector.
inline constexpr float kMinMaxNorm = 0.57735027F;

namespace formulas {
#include "hapticut/formulas/vectors.inl"
//
#include "hapticut/formulas/section.inl"
//
#include "hapticut/formulas/recession.inl"
}  // namespace formulas

using formulas::CutDepth;
using formulas::LayerRecession;
using formulas::VoxelSection;

}  // namespace hapticut
