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
/// Operations on a volume between the file and the workpiece. Every result keeps its position in the world. Every
/// function throws Error if the volume is not consistent. Operations that need ITK are in
/// `io/volume/volume_filters.hpp`.
namespace hapticut {

/// Sets the spacing of the samples, for files without spacing. The first sample keeps its position.
/// @param spacing  [m]
[[nodiscard]] GreyVolume with_spacing(GreyVolume volume, const Vec3& spacing);
[[nodiscard]] LabelVolume with_spacing(LabelVolume volume, const Vec3& spacing);

/// The box around all samples; each sample is a box with the size of the spacing.
/// @return [m] in W; the box of a rotated volume is larger than the volume
[[nodiscard]] Box box_of_volume(const GreyVolume& volume);
[[nodiscard]] Box box_of_volume(const LabelVolume& volume);

/// The samples of a box; the part of the box beyond the volume is left out.
/// @throws Error if nothing is left
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

/// Number of samples with at least this grey value.
[[nodiscard]] std::size_t count_from(const GreyVolume& volume, double threshold);

/// Number of samples with each label.
[[nodiscard]] std::map<int, std::size_t> count_labels(const LabelVolume& volume);

/// [1] Maximum distance of a label in a file from a whole number. It covers the rounding of single precision (0.004 at
/// 65535) and of labels that a program scaled to 16 bits. Interpolated labels exceed it somewhere.
inline constexpr double kLabelRounding = 0.01;

/// Number of samples with each label, for a volume that may or may not have labels. The result is empty if a value is
/// not a label, or if there are more than `max_labels` different values.
[[nodiscard]] std::map<int, std::size_t> count_labels(const GreyVolume& volume, std::size_t max_labels = 64);

/// The label after the highest label of the volume, for a new label.
/// @throws Error when the volume has label 65535
[[nodiscard]] std::uint16_t unused_label(const LabelVolume& volume);

/// Keeps the largest body of samples that are not 0 and share faces; other bodies become 0. If several bodies have the
/// largest size, the one whose first sample comes first is kept.
/// @throws Error when all samples are 0
[[nodiscard]] LabelVolume keep_largest_component(LabelVolume volume);

/// Keeps the largest body of samples with at least this grey value; samples of other bodies get the lowest grey value
/// of the volume.
/// @throws Error when there is no such sample
[[nodiscard]] GreyVolume keep_largest_component(GreyVolume volume, double threshold);

/// Gives a label to every cavity. A cavity consists of samples of 0 without a path over faces to the border of the
/// volume.
[[nodiscard]] LabelVolume fill_cavities(LabelVolume volume, std::uint16_t label);

}  // namespace hapticut
