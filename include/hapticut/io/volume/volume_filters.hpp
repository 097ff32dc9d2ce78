// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "hapticut/core/description.hpp"
#include "hapticut/core/volume.hpp"

/// @file
/// What is done to a volume with ITK (HAPTICUT_WITH_ITK); the rest is in `build/volume_operations.hpp`. Every
/// result keeps its place in the world; every function throws Error when the volume is not consistent, and when the
/// library was built without ITK.
namespace hapticut {

/// The same volume with cubic samples of another size: linear between samples, mean over samples where the new ones are
/// larger. The lower corner of the volume stays where it is.
/// @param voxel_size  [m]
[[nodiscard]] GreyVolume resample(const GreyVolume& volume, double voxel_size);

/// How labels between samples are found.
enum class LabelInterpolation : std::uint8_t {
  nearest,  ///< the label of the nearest sample: steps stay steps
  smooth    ///< the label with the largest share in a Gaussian of half a spacing: rounds steps
};

constexpr auto names_of(Of<LabelInterpolation>) {
  using enum LabelInterpolation;
  return std::array{
      Named{nearest, "nearest"},
      Named{smooth, "smooth"},
  };
}

[[nodiscard]] LabelVolume resample(const LabelVolume& volume, double voxel_size,
                                   LabelInterpolation interpolation = LabelInterpolation::nearest);

/// Gives a label to every sample of 0 that no ball of this radius reaches without touching the body (a morphological
/// closing): holes and slits narrower than the ball, e.g. the root canals that join a pulp chamber with the outside.
/// @param radius  [m]
/// @throws Error when all samples are 0
[[nodiscard]] LabelVolume close_gaps(LabelVolume volume, double radius, std::uint16_t label);

}  // namespace hapticut
