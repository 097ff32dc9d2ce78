// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hapticut/build/work_estimate.hpp"
#include "hapticut/core/description.hpp"
#include "hapticut/core/volume.hpp"
#include "hapticut/workpiece/builders.hpp"

/// @file
/// Workpieces from dense volumes: a CT whose grey values say what is where, or a segmentation whose labels do.
///
/// The workpiece keeps the pose of the volume: its grid has the volume's axes, and the lower corner of voxel (0,0,0) is
/// the lower corner of sample (0,0,0). The voxel size is free and cubic, also where the spacing is not: values between
/// samples are interpolated trilinearly, and a voxel that the surface cuts gets the fraction of it that is filled and
/// the centroid of that part.
namespace hapticut {

/// What of a volume becomes voxels, and of what size.
struct VolumeBuildOptions {
  double voxel_size = 0;  ///< [m] 0: the smallest spacing of the volume
  /// Samples to use, both ends included; nothing: all. Voxels keep the indices they would have without the crop.
  std::optional<IndexBox> crop_samples = std::nullopt;
  /// Keep only voxels that the smallest grid-aligned box around this box of W touches.
  std::optional<Box> crop = std::nullopt;
  bool antialias = true;  ///< false: a voxel is full or empty, as its centre says
  int subsamples = 4;     ///< 1 ... 16 points per edge of a voxel that the surface cuts; more where samples are finer
  /// Grey values: voxels at the border of the body are of the material behind them; false: of their own values alone.
  bool partial_volume = true;
  bool large = false;      ///< lifts the limits of work_estimate.hpp
  WorkObserver tell = {};  ///< is told of the work before it begins
};

/// Labels that are one material.
struct LabelMaterial {
  std::vector<std::uint16_t> labels;
  Material material;
};

/// What to do with a label that no material claims. Label 0 is always empty unless claimed.
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
/// With isotropic spacing and a voxel of that size, voxel (i, j, k) is sample (i, j, k) and full: volumes are exact.
/// Otherwise each label's membership is interpolated, the body reaches to where the memberships of its labels sum to
/// one half, and a point inside is of the material with the largest membership.
/// @throws Error when the volume is not consistent, a label is claimed twice or not at all, or there would be too many
///         voxels
[[nodiscard]] Workpiece build_from_labels(const LabelVolume& volume, const std::vector<LabelMaterial>& materials,
                                          const VolumeBuildOptions& options = {},
                                          UnclaimedLabels unclaimed = UnclaimedLabels::refuse);

/// Grey values `from <= value < to` are this material.
struct GreyRange {
  double from;  ///< grey value; may be -infinity
  double to;    ///< grey value; may be +infinity
  Material material;
};

/// Builds a workpiece from grey values; what no range covers is empty. Material ids follow the order of the list.
///
/// A scanner blurs: between air and a dense material the values pass through every range in between, so by ranges alone
/// it would have a shell of the softer ones. With `VolumeBuildOptions::partial_volume` a voxel there is of the material
/// that the rise of the values from what is empty below leads to, within two samples to each side; how full it is
/// stays. What is softer all along keeps its own: bone at a cut, and a layer of three samples or more.
/// @throws Error when the volume is not consistent or has values that are not finite, a range is empty or overlaps
///         another, or there would be too many voxels
[[nodiscard]] Workpiece build_from_grey(const GreyVolume& volume, const std::vector<GreyRange>& ranges,
                                        const VolumeBuildOptions& options = {});

/// A material whose constants change linearly with the grey value, e.g. bone over Hounsfield units; of the lengths of
/// chips, u h_e and u sqrt(h_s) do. Where one end's constants are for a cutter and the other's for all, they are for
/// that.
///
/// A voxel names one of 255 materials, so the grade is cut into `steps` equal pieces and each piece gets the constants
/// of its middle: nothing linear is further from the exact one than |at_high - at_low| / (2 * steps). With the default
/// that is 0.4 % of the difference between the ends, below what is known of any of these constants.
struct Grade {
  double low;        ///< grey value where the body begins; below is empty
  double high;       ///< grey value of `at_high`; above it nothing changes any more
  Material at_low;   ///< constants at `low`; its name begins the names of the pieces
  Material at_high;  ///< constants at `high`
  int steps = 128;   ///< 1 ... 200
};

/// The materials of a grade, from low to high, named "<name of at_low> 1/<steps>" and so on.
/// @throws Error when the grade is not valid
[[nodiscard]] std::vector<Material> materials_of(const Grade& grade);

/// Builds a workpiece of one graded material.
/// @throws Error as above
[[nodiscard]] Workpiece build_from_grey(const GreyVolume& volume, const Grade& grade,
                                        const VolumeBuildOptions& options = {});

}  // namespace hapticut
