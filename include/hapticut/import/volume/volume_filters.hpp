// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "hapticut/core/description.hpp"
#include "hapticut/core/volume.hpp"

/// @file
/// Volume filters that need ITK (HAPTICUT_WITH_ITK); `build/volume_operations.hpp` has the others. Every result keeps
/// its place in the world. Every function throws Error when the volume is not consistent or the library was built
/// without ITK.
namespace hapticut {

/// Resamples a grey volume to cubic samples: linear interpolation, or the mean when the new samples are larger. The
/// lower corner of the volume stays in place.
/// @param voxel_size  [m]
[[nodiscard]] GreyVolume resample(const GreyVolume& volume, double voxel_size);

/// Interpolation of labels between samples.
enum class LabelInterpolation : std::uint8_t {
  nearest,  ///< label of the nearest sample; keeps steps
  smooth    ///< label with the largest weight in a Gaussian of half a spacing; rounds steps
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

/// Sets a label on every sample of 0 that a ball of this radius cannot reach without touching the body (a morphological
/// closing). This closes holes and slits narrower than the ball, e.g. the root canals between a pulp chamber and the
/// outside.
/// @param radius  [m]
/// @throws Error when all samples are 0
[[nodiscard]] LabelVolume close_gaps(LabelVolume volume, double radius, std::uint16_t label);

}  // namespace hapticut
