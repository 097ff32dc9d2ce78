// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "hapticut/core/volume.hpp"
#include "hapticut/workpiece/workpiece.hpp"

namespace hapticut {

/// A sentence about the materials that fill over 5 % more or less than wanted, because a layer or a wire is thinner
/// than the voxels, each of which has one material; empty if there is none.
/// @param wanted  [m^3]
/// @param of      what the workpiece was built from, e.g. "labels"
[[nodiscard]] std::string differences_of(const Workpiece& workpiece, const ByMaterial<double>& wanted,
                                         const std::string& of);

/// Compares the volume of each material of a workpiece with that of its labels. They differ where a layer or a wire is
/// thinner than the voxels: a voxel has one material, and the surface between samples rounds corners.
/// @param material_of  [65536] material of each label
/// @param samples      samples in use
/// @param voxels       [samples] lower and upper corner of the box of the voxels
/// @param warn         receives a sentence about all materials that differ by more than 5 %
/// @throws Error with this sentence when `warn` is empty
void compare_with_labels(const Workpiece& workpiece, const LabelVolume& volume,
                         const std::vector<MaterialId>& material_of, const IndexBox& samples,
                         const std::array<Vec3, 2>& voxels, const std::function<void(const std::string&)>& warn);

}  // namespace hapticut
