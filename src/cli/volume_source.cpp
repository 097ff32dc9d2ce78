// SPDX-License-Identifier: Apache-2.0
#include "cli/volume_source.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hapticut/core/units.hpp"
#include "hapticut/io/volume_operations.hpp"
#include "hapticut/io/volumes.hpp"
#include "hapticut/workpiece/volume_builders.hpp"

namespace hapticut::cli {
namespace {

using Source = WorkpieceSettings;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostLabels = 64;  // more different values than this are grey values

VolumeReadOptions read_options(const Source& s) {
  VolumeReadOptions options;
  if (s.spacing_mm) options.spacing = *s.spacing_mm * units::mm;
  return options;
}

std::optional<Box> crop_box(const Source& s) {
  if (s.crop_mm.empty()) return std::nullopt;
  const auto& c = s.crop_mm;
  const Box box{Vec3(c[0], c[1], c[2]) * units::mm, Vec3(c[3], c[4], c[5]) * units::mm};
  if (!(box.max.array() > box.min.array()).all())
    throw Error(
        "workpiece.crop_mm must be x, y, z of the lower corner and then x, y, z of the upper one; here an "
        "upper value is not above the lower one.");
  return box;
}

/// The samples that a box of W needs, and two more to each side for interpolation.
template <class Value>
IndexBox samples_around(const Volume<Value>& volume, const Box& box) {
  IndexBox samples;
  const Pose X_GW = volume.X_WG.inverse();
  Vec3 low = Vec3::Constant(kInfinity), high = -low;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p((corner & 1) != 0 ? box.max.x() : box.min.x(), (corner & 2) != 0 ? box.max.y() : box.min.y(),
                 (corner & 4) != 0 ? box.max.z() : box.min.z());
    const Vec3 sample = (X_GW * p).cwiseQuotient(volume.spacing);
    low = low.cwiseMin(sample);
    high = high.cwiseMax(sample);
  }
  for (int axis = 0; axis < 3; ++axis) {
    const double last = volume.dims[std::size_t(axis)] - 1;
    if (!(high[axis] >= 0 && low[axis] <= last))
      throw Error("workpiece.crop_mm lies outside the volume; see hapticut inspect for where it is.");
    samples.min[std::size_t(axis)] = int(std::max(0.0, std::floor(low[axis]) - 2));
    samples.max[std::size_t(axis)] = int(std::min(last, std::ceil(high[axis]) + 2));
  }
  return samples;
}

VolumeBuildOptions build_options(const Source& s) {
  VolumeBuildOptions options;
  options.voxel_size = s.voxel_mm.value_or(0) * units::mm;
  options.crop = crop_box(s);
  return options;
}

template <class Value>
Volume<Value> cropped(Volume<Value> volume, const std::optional<Box>& box) {
  return box ? crop(volume, samples_around(volume, *box)) : volume;
}

/// Sets what is not part of the largest body of grey values from `lowest` on to what is outside.
void keep_largest_body(GreyVolume& volume, double lowest) {
  const LabelVolume body = keep_largest_component(label_range(volume, lowest, kInfinity));
  const float outside = *std::min_element(volume.values.begin(), volume.values.end());
  for (std::size_t i = 0; i < volume.values.size(); ++i)
    if (double(volume.values[i]) >= lowest && body.values[i] == 0) volume.values[i] = outside;
}

Workpiece from_labels(const Source& s) {
  LabelVolume volume = cropped(read_label_volume(s.source, read_options(s)), crop_box(s));
  if (s.largest_component) volume = keep_largest_component(std::move(volume));
  std::vector<LabelMaterial> materials;
  for (const Source::Labels& labels : s.labels)
    materials.push_back({{labels.values.begin(), labels.values.end()}, s.materials.find(labels.material)});
  return build_from_labels(volume, materials, build_options(s));
}

GreyVolume read_body(const Source& s, double lowest) {
  GreyVolume volume = cropped(read_grey_volume(s.source, read_options(s)), crop_box(s));
  if (s.largest_component) keep_largest_body(volume, lowest);
  return volume;
}

Workpiece from_ranges(const Source& s) {
  std::vector<GreyRange> ranges;
  double lowest = kInfinity;
  for (const Source::GreyRange& range : s.grey) {
    ranges.push_back({range.from.value_or(-kInfinity), range.to.value_or(kInfinity), s.materials.find(range.material)});
    lowest = std::min(lowest, ranges.back().from);
  }
  return build_from_grey(read_body(s, lowest), ranges, build_options(s));
}

Workpiece from_grade(const Source& s) {
  if (!s.grade_low || !s.grade_high || s.grade_at_low.empty() || s.grade_at_high.empty())
    throw Error(
        "a grade needs all of workpiece.grade_low, grade_high, grade_at_low and grade_at_high; set the missing "
        "ones.");
  Grade grade;
  grade.low = *s.grade_low;
  grade.high = *s.grade_high;
  grade.at_low = s.materials.find(s.grade_at_low);
  grade.at_high = s.materials.find(s.grade_at_high);
  return build_from_grey(read_body(s, grade.low), grade, build_options(s));
}

}  // namespace

Workpiece make_workpiece_from_volume(const Source& s) {
  const bool graded = s.grade_low || s.grade_high || !s.grade_at_low.empty() || !s.grade_at_high.empty();
  const int ways = int(!s.labels.empty()) + int(!s.grey.empty()) + int(graded);
  if (ways != 1)
    throw Error(
        "a volume becomes a workpiece by exactly one of workpiece.labels, workpiece.grey and "
        "workpiece.grade_low ...; " +
        std::to_string(ways) + " are set. Set --label, --grey or --grade_low.");
  if (!s.labels.empty()) return from_labels(s);
  return graded ? from_grade(s) : from_ranges(s);
}

VolumeSummary summarize_volume(const Source& s, std::optional<double> threshold) {
  const GreyVolume volume = cropped(read_grey_volume(s.source, read_options(s)), crop_box(s));
  const auto [lowest, highest] = std::minmax_element(volume.values.begin(), volume.values.end());
  VolumeSummary summary{volume.dims, volume.spacing, double(*lowest), double(*highest),
                        volume.values.size() * sizeof(float)};
  if (threshold)
    summary.voxels_at_or_above = std::size_t(std::count_if(volume.values.begin(), volume.values.end(),
                                                           [&](float value) { return double(value) >= *threshold; }));
  for (const float value : volume.values) {
    if (value < 0 || value > 65535 || value != std::floor(value)) return summary.voxels_by_label.clear(), summary;
    ++summary.voxels_by_label[int(value)];
    if (summary.voxels_by_label.size() > kMostLabels) return summary.voxels_by_label.clear(), summary;
  }
  return summary;
}

}  // namespace hapticut::cli
