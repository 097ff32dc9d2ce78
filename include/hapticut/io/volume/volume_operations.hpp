// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "hapticut/core/volume.hpp"
#include "hapticut/workpiece/block.hpp"

/// @file
/// What is done to a volume between the file and the workpiece. Every result keeps its place in the world; every
/// function throws Error when the volume is not consistent.
namespace hapticut {

/// The same samples at another distance: for files whose header does not know. The first sample stays where it is.
/// @param spacing  [m]
[[nodiscard]] GreyVolume with_spacing(GreyVolume volume, const Vec3& spacing);
[[nodiscard]] LabelVolume with_spacing(LabelVolume volume, const Vec3& spacing);

/// The samples of a box; what of it reaches beyond the volume is left out.
/// @throws Error when nothing is left
[[nodiscard]] GreyVolume crop(const GreyVolume& volume, const IndexBox& samples);
[[nodiscard]] LabelVolume crop(const LabelVolume& volume, const IndexBox& samples);

/// The smallest box around all samples with one of these labels (none given: with any label but 0).
/// @param margin  [m] the box grows by this much to every side, within the volume
/// @throws Error when there is no such sample
[[nodiscard]] IndexBox box_around(const LabelVolume& volume, const std::vector<std::uint16_t>& labels = {},
                                  double margin = 0);

/// The smallest box around all samples with at least this grey value.
[[nodiscard]] IndexBox box_around(const GreyVolume& volume, double threshold, double margin = 0);

/// Labels samples whose grey value is `from <= value < to`; the others are 0.
[[nodiscard]] LabelVolume label_range(const GreyVolume& volume, double from, double to, std::uint16_t label = 1);

/// The same volume with cubic samples of another size: linear between samples, mean over samples where the new ones are
/// larger. The lower corner of the volume stays where it is.
/// @param voxel_size  [m]
[[nodiscard]] GreyVolume resample(const GreyVolume& volume, double voxel_size);

enum class LabelInterpolation : std::uint8_t {
  nearest,  ///< the label of the nearest sample: steps stay steps
  smooth    ///< the label with the largest share in a Gaussian of half a spacing: rounds steps
};
[[nodiscard]] LabelVolume resample(const LabelVolume& volume, double voxel_size,
                                   LabelInterpolation interpolation = LabelInterpolation::nearest);

/// Keeps the largest of the bodies made of samples that are not 0 and touch by a face; the rest becomes 0.
/// @throws Error when all samples are 0
[[nodiscard]] LabelVolume keep_largest_component(LabelVolume volume);

/// Gives a label to every cavity: samples of 0 from which no path over faces leads to the border of the volume.
[[nodiscard]] LabelVolume fill_cavities(LabelVolume volume, std::uint16_t label);

/// Gives a label to every sample of 0 that no ball of this radius reaches without touching the body (a morphological
/// closing): holes and slits narrower than the ball, e.g. the root canals that join a pulp chamber with the outside.
/// @param radius  [m]
/// @throws Error when all samples are 0
[[nodiscard]] LabelVolume close_gaps(LabelVolume volume, double radius, std::uint16_t label);

}  // namespace hapticut
