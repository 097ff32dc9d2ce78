// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hapticut/build/work_estimate.hpp"
#include "hapticut/core/description.hpp"
#include "hapticut/core/volume.hpp"
#include "hapticut/workpiece/builders.hpp"

/// @file
/// Workpieces from dense volumes: from the grey values of a CT, or from the labels of a segmentation.
///
/// The workpiece keeps the pose of the volume: its grid has the volume's axes, and the lower corner of voxel (0,0,0) is
/// the lower corner of sample (0,0,0). Voxels are cubes of any size, even if the spacing differs between axes: values
/// between samples are interpolated trilinearly. A voxel that the surface cuts gets its filled fraction and the
/// centroid of the filled part.
namespace hapticut {

/// Options for the conversion of a volume to voxels.
struct VolumeBuildOptions {
  double voxel_size = 0;  ///< [m] 0: the smallest spacing of the volume
  /// Samples to use, both ends included; nothing: all samples. Voxel indices are those without the crop.
  std::optional<IndexBox> crop_samples = std::nullopt;
  /// Box in W [m]: only voxels that touch the smallest grid-aligned box around it are kept.
  std::optional<Box> crop = std::nullopt;
  bool antialias = true;  ///< false: a voxel is full or empty, depending on its centre
  int subsamples = 4;     ///< 1 ... 16 points per edge of a voxel that the surface cuts; raised if samples are finer
  /// For grey values: voxels at the border of the body get the material behind them; false: their own values decide.
  bool partial_volume = true;
  bool large = false;          ///< lifts the limits of work_estimate.hpp
  WorkObserver observer = {};  ///< called with the estimate before the work begins
  /// Called with a sentence about materials that fill over 5 % less or more than their labels, e.g. a
  /// layer thinner than the voxels, and about materials without labels or grey values. Nothing: build_from_labels
  /// refuses the first.
  std::function<void(const std::string&)> warn = {};
};

/// A material and its labels.
struct LabelMaterial {
  std::vector<std::uint16_t> labels;
  Material material;
};

/// Treatment of labels that no material claims. Label 0 is empty unless claimed.
enum class UnclaimedLabels : std::uint8_t {
  refuse,    ///< throw an Error that names them
  leave_out  ///< leave them empty
};

constexpr auto names_of(Of<UnclaimedLabels>) {
  using enum UnclaimedLabels;
  return std::array{
      Named{refuse, "refuse"},
      Named{leave_out, "leave_out"},
  };
}

/// Builds a workpiece from a segmentation. Material ids follow the order of the list.
///
/// With isotropic spacing and a voxel of that size, voxel (i, j, k) is sample (i, j, k) and full, so that volumes are
/// exact. Otherwise the membership of each label is interpolated. The surface of the body is where the memberships of
/// its labels sum to one half, and a point inside has the material with the largest membership. A layer or a wire that
/// is thinner than the voxels then becomes smaller or vanishes, see `VolumeBuildOptions::warn`.
/// @throws Error when the volume is not consistent, a label is claimed twice or not at all, there would be too many
///         voxels, or nobody listens to `warn`
[[nodiscard]] Workpiece build_from_labels(const LabelVolume& volume, const std::vector<LabelMaterial>& materials,
                                          const VolumeBuildOptions& options = {},
                                          UnclaimedLabels unclaimed = UnclaimedLabels::refuse);

/// A material and its grey values `from <= value < to`.
struct GreyRange {
  double from;  ///< grey value; may be -infinity
  double to;    ///< grey value; may be +infinity
  Material material;
};

/// Builds a workpiece from grey values. Values that no range covers are empty. Material ids follow the order of the
/// list.
///
/// A scanner blurs: between air and a dense material the values pass through every range in between. By ranges alone, a
/// dense body would get a shell of softer materials. With `VolumeBuildOptions::partial_volume` the builder follows the
/// rise of the values from the empty range, within two samples to each side, and gives the voxel the material at its
/// end. Filled fractions do not change. Regions of softer material keep it: bone at a cut, and layers of three samples
/// or more.
/// @throws Error when the volume is not consistent or has values that are not finite, a range is empty or overlaps
///         another, or there would be too many voxels
[[nodiscard]] Workpiece build_from_grey(const GreyVolume& volume, const std::vector<GreyRange>& ranges,
                                        const VolumeBuildOptions& options = {});

/// A material whose constants change linearly with the grey value, e.g. bone over Hounsfield units. For the chip
/// lengths h_e and h_s, the products u h_e and u sqrt(h_s) change linearly. If only one end names a cutter, all pieces
/// are for that cutter.
///
/// A voxel has one of 255 materials, so the grade is divided into `steps` equal pieces, and each piece gets the
/// constants of its middle. The error of a linear constant is at most |at_high - at_low| / (2 * steps). With the
/// default this is 0.4 % of the difference between the ends, less than the uncertainty of these constants.
struct Grade {
  double low;        ///< grey value where the body begins; lower values are empty
  double high;       ///< grey value of `at_high`; higher values have the same constants
  Material at_low;   ///< constants at `low`; the names of the pieces begin with its name
  Material at_high;  ///< constants at `high`
  int steps = 128;   ///< 1 ... 200
};

/// The materials of a grade, from low to high, named "<name of at_low> 1/<steps>" and so on.
/// @throws Error if the grade is not valid
[[nodiscard]] std::vector<Material> materials_of(const Grade& grade);

/// Builds a workpiece of one graded material.
/// @throws Error if the grade or the volume is not valid, or if there would be too many voxels
[[nodiscard]] Workpiece build_from_grey(const GreyVolume& volume, const Grade& grade,
                                        const VolumeBuildOptions& options = {});

}  // namespace hapticut
