// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hapticut/core/abi.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/spatial.hpp"

/// @file
/// A dense regular volume in memory, as read from a CT file and passed to a workpiece builder.
namespace hapticut {

/// Values on a regular grid, x fastest. Sample (i, j, k) is the centre of a voxel and lies at
/// `X_WG * (i * spacing.x, j * spacing.y, k * spacing.z)`; the voxel reaches half a spacing to each side.
template <class Value>
struct Volume {
  std::array<int, 3> dims = {0, 0, 0};    ///< number of samples along x, y, z
  Vec3 spacing = Vec3(1e-3, 1e-3, 1e-3);  ///< [m] distance of neighbouring samples along x, y, z
  Pose X_WG;                              ///< pose of the grid: position of sample (0,0,0) and directions of its axes
  std::vector<Value> values;              ///< dims[0] * dims[1] * dims[2] values
  std::size_t padding = 0;                ///< samples that the file marks as outside the field of view; they are air
  std::vector<std::string> remarks = {};  ///< sentences of its reader: what the file lacks, which files were left out

  [[nodiscard]] std::size_t size() const { return std::size_t(dims[0]) * std::size_t(dims[1]) * std::size_t(dims[2]); }
  [[nodiscard]] std::size_t offset(int i, int j, int k) const {
    return (std::size_t(k) * std::size_t(dims[1]) + std::size_t(j)) * std::size_t(dims[0]) + std::size_t(i);
  }
  [[nodiscard]] Value& at(int i, int j, int k) { return values[offset(i, j, k)]; }
  [[nodiscard]] const Value& at(int i, int j, int k) const { return values[offset(i, j, k)]; }
  [[nodiscard]] Vec3 position(int i, int j, int k) const {
    return X_WG * Vec3(i * spacing.x(), j * spacing.y(), k * spacing.z());
  }
};

/// @throws Error unless there is at least one sample along every axis, the number of values is the product of the
/// dims, the spacing is positive and finite, and X_WG is a rigid pose
template <class Value>
void require_valid(const Volume<Value>& volume) {
  for (const int n : volume.dims)
    if (n < 1)
      throw Error("Volume::dims"_name + " has " + std::to_string(n) +
                  "; must be at least 1 along every axis. Is the volume empty?");
  if (volume.values.size() != volume.size())
    throw Error("a volume has " + std::to_string(volume.values.size()) + " values, but its dims require " +
                std::to_string(volume.size()) + ".");
  for (int axis = 0; axis < 3; ++axis) require_positive(volume.spacing[axis], "Volume::spacing [m]");
  if (!is_finite(volume.X_WG) || !is_rotation(volume.X_WG.rotation, 1e-6))
    throw Error("Volume::X_WG"_name +
                " is not a pose; its rotation must be orthonormal and right-handed and all numbers finite.");
}

using GreyVolume = Volume<float>;           ///< grey values, e.g. Hounsfield units
using LabelVolume = Volume<std::uint16_t>;  ///< labels; 0 is empty by convention

}  // namespace hapticut
