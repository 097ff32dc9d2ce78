// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "hapticut/core/volume.hpp"
#include "hapticut/workpiece/block.hpp"
#include "hapticut/workpiece/builders.hpp"

/// @file
/// What is done to a volume between the file and the workpiece. Every result keeps its place in the world; every
/// function throws Error when the volume is not consistent. What needs ITK is in `io/volume/volume_filters.hpp`.
namespace hapticut {

/// The same samples at another distance: for files whose header does not know. The first sample stays where it is.
/// @param spacing  [m]
[[nodiscard]] GreyVolume with_spacing(GreyVolume volume, const Vec3& spacing);
[[nodiscard]] LabelVolume with_spacing(LabelVolume volume, const Vec3& spacing);

/// The box around all samples, each of them a box as large as their spacing.
/// @return [m] in W; around a turned volume it is larger than the volume
[[nodiscard]] Box box_of_volume(const GreyVolume& volume);
[[nodiscard]] Box box_of_volume(const LabelVolume& volume);

/// The samples of a box; what of it reaches beyond the volume is left out.
/// @throws Error when nothing is left
[[nodiscard]] GreyVolume crop_to_samples(const GreyVolume& volume, const IndexBox& samples);
[[nodiscard]] LabelVolume crop_to_samples(const LabelVolume& volume, const IndexBox& samples);

/// The samples that a workpiece inside a box of the world needs: those around the box, and two more to each side for
/// interpolation.
/// @param box  [m] in W
/// @throws Error when the box lies outside the volume
[[nodiscard]] GreyVolume crop_to_box(const GreyVolume& volume, const Box& box);
[[nodiscard]] LabelVolume crop_to_box(const LabelVolume& volume, const Box& box);

/// The smallest box around all samples with one of these labels (no label given: with any but 0).
/// @param margin  [m] the box grows by this much to every side, within the volume
/// @throws Error when there is no such sample
[[nodiscard]] IndexBox box_around(const LabelVolume& volume, const std::vector<std::uint16_t>& labels = {},
                                  double margin = 0);

/// The smallest box around all samples with at least this grey value.
[[nodiscard]] IndexBox box_around(const GreyVolume& volume, double threshold, double margin = 0);

/// Labels samples whose grey value is `from <= value < to`; the others are 0.
[[nodiscard]] LabelVolume label_range(const GreyVolume& volume, double from, double to, std::uint16_t label = 1);

/// The lowest and the highest grey value; samples that are not a number do not count.
/// @throws Error when no sample is a number
[[nodiscard]] std::array<double, 2> grey_range(const GreyVolume& volume);

/// How many samples have at least this grey value.
[[nodiscard]] std::size_t count_from(const GreyVolume& volume, double threshold);

/// How many samples have each label.
[[nodiscard]] std::map<int, std::size_t> count_labels(const LabelVolume& volume);

/// The same for a volume of which it is not known whether it has labels: empty where a value is not a label, or where
/// there are more different ones than `most`.
[[nodiscard]] std::map<int, std::size_t> count_labels(const GreyVolume& volume, std::size_t most = 64);

/// The label after the highest one of the volume: for what is to get a label of its own.
/// @throws Error when the volume has label 65535
[[nodiscard]] std::uint16_t unused_label(const LabelVolume& volume);

/// Keeps the largest of the bodies made of samples that are not 0 and touch by a face; the rest becomes 0. Of bodies of
/// the same size it keeps the one whose first sample comes first.
/// @throws Error when all samples are 0
[[nodiscard]] LabelVolume keep_largest_component(LabelVolume volume);

/// Keeps the largest of the bodies made of samples with at least this grey value; the others get the lowest grey value
/// of the volume.
/// @throws Error when there is no such sample
[[nodiscard]] GreyVolume keep_largest_component(GreyVolume volume, double threshold);

/// Gives a label to every cavity: samples of 0 from which no path over faces leads to the border of the volume.
[[nodiscard]] LabelVolume fill_cavities(LabelVolume volume, std::uint16_t label);

}  // namespace hapticut
