// SPDX-License-Identifier: Apache-2.0
#include "hapticut/build/volume_operations.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <limits>
#include <string>

#include "build/boxes.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/block_grid.hpp"

namespace hapticut {
namespace {

constexpr int kMaxLabels = 65536;

template <class Value>
Volume<Value> respaced(Volume<Value> volume, const Vec3& spacing) {
  for (int axis = 0; axis < 3; ++axis) require_positive(spacing[axis], "spacing [m]");
  volume.spacing = spacing;
  require_valid(volume);
  return volume;
}

template <class Value>
Volume<Value> cropped(const Volume<Value>& volume, const IndexBox& samples) {
  require_valid(volume);
  const IndexBox box = overlap(samples, samples_of(volume));
  if (box.empty()) throw Error("the box to crop to has no sample of the volume; check that it has sample indices.");
  Volume<Value> part;
  for (int axis = 0; axis < 3; ++axis) part.dims[axis] = box.max[axis] - box.min[axis] + 1;
  part.spacing = volume.spacing;
  part.X_WG = {volume.X_WG.rotation, volume.position(box.min[0], box.min[1], box.min[2])};
  part.values.reserve(part.size());
  for (int k = box.min[2]; k <= box.max[2]; ++k)
    for (int j = box.min[1]; j <= box.max[1]; ++j) {
      const Value* row = &volume.at(box.min[0], j, k);
      part.values.insert(part.values.end(), row, row + part.dims[0]);
    }
  return part;
}

template <class Value>
Box around_samples(const Volume<Value>& volume) {
  require_valid(volume);
  const Vec3 half = Vec3::Constant(0.5), dims(volume.dims[0], volume.dims[1], volume.dims[2]);
  const Eigen::AlignedBox3d around = box_of_moved(
      {-half, dims - half}, [&](const Vec3& sample) { return volume.X_WG * sample.cwiseProduct(volume.spacing); });
  return {around.min(), around.max()};
}

template <class Value>
Volume<Value> cropped_to(const Volume<Value>& volume, const Box& box) {
  require_valid(volume);
  constexpr double kForInterpolation = 2;  // samples
  const Pose X_GW = volume.X_WG.inverse();
  const Eigen::AlignedBox3d wanted =
      box_of_moved(box, [&](const Vec3& p) { return Vec3((X_GW * p).cwiseQuotient(volume.spacing)); });
  IndexBox samples;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = wanted.min()[axis], high = wanted.max()[axis], last = volume.dims[axis] - 1;
    if (!(high >= 0 && low <= last)) {
      const Box all = around_samples(volume);
      const auto text = [](const Vec3& place) {
        const Vec3 p = place / units::mm;
        return "(" + format_number(p.x()) + ", " + format_number(p.y()) + ", " + format_number(p.z()) + ")";
      };
      throw Error("the box to crop to lies outside the volume, which reaches from " + text(all.min) + " mm to " +
                  text(all.max) + " mm.");
    }
    samples.min[axis] = int(std::max(0.0, std::floor(low) - kForInterpolation));
    samples.max[axis] = int(std::min(last, std::ceil(high) + kForInterpolation));
  }
  return cropped(volume, samples);
}

template <class Value, class Wanted>
IndexBox samples_with(const Volume<Value>& volume, const Wanted& wanted, double margin) {
  require_valid(volume);
  require_not_negative(margin, "margin of a crop [m]");
  constexpr int kFar = std::numeric_limits<int>::max();
  IndexBox box = {{kFar, kFar, kFar}, {-1, -1, -1}};
  for (int k = 0; k < volume.dims[2]; ++k)
    for (int j = 0; j < volume.dims[1]; ++j) {
      const Value* begin = &volume.at(0, j, k);
      const Value* end = begin + volume.dims[0];
      const Value* first = std::find_if(begin, end, wanted);
      if (first == end) continue;
      const Value* last =
          std::find_if(std::make_reverse_iterator(end), std::make_reverse_iterator(first), wanted).base();
      box.min = {std::min(box.min[0], int(first - begin)), std::min(box.min[1], j), std::min(box.min[2], k)};
      box.max = {std::max(box.max[0], int(last - begin) - 1), std::max(box.max[1], j), k};
    }
  if (box.empty()) throw Error("no sample of the volume has the wanted values; there is nothing to crop to.");
  for (int axis = 0; axis < 3; ++axis) {
    const int more = int(std::min(std::ceil(margin / volume.spacing[axis] - 1e-9), double(volume.dims[axis])));
    box.min[axis] = std::max(box.min[axis] - more, 0);
    box.max[axis] = std::min(box.max[axis] + more, volume.dims[axis] - 1);
  }
  return box;
}

}  // namespace

GreyVolume with_spacing(GreyVolume volume, const Vec3& spacing) { return respaced(std::move(volume), spacing); }
LabelVolume with_spacing(LabelVolume volume, const Vec3& spacing) { return respaced(std::move(volume), spacing); }

GreyVolume crop_to_samples(const GreyVolume& volume, const IndexBox& samples) { return cropped(volume, samples); }
LabelVolume crop_to_samples(const LabelVolume& volume, const IndexBox& samples) { return cropped(volume, samples); }

GreyVolume crop_to_box(const GreyVolume& volume, const Box& box) { return cropped_to(volume, box); }
LabelVolume crop_to_box(const LabelVolume& volume, const Box& box) { return cropped_to(volume, box); }

Box box_of_volume(const GreyVolume& volume) { return around_samples(volume); }
Box box_of_volume(const LabelVolume& volume) { return around_samples(volume); }

IndexBox box_around(const LabelVolume& volume, const std::vector<std::uint16_t>& labels, double margin) {
  std::bitset<65536> wanted;
  for (const std::uint16_t label : labels) wanted.set(label);
  if (labels.empty()) wanted.set().reset(0);
  return samples_with(
      volume, [&](std::uint16_t label) { return wanted[label]; }, margin);
}

IndexBox box_around(const GreyVolume& volume, double threshold, double margin) {
  return samples_with(
      volume, [&](float value) { return double(value) >= threshold; }, margin);
}

LabelVolume label_range(const GreyVolume& volume, double from, double to, std::uint16_t label) {
  require_valid(volume);
  LabelVolume labels;
  labels.dims = volume.dims;
  labels.spacing = volume.spacing;
  labels.X_WG = volume.X_WG;
  labels.values.resize(volume.size());
  std::transform(volume.values.begin(), volume.values.end(), labels.values.begin(),
                 [&](float value) { return double(value) >= from && double(value) < to ? label : std::uint16_t(0); });
  return labels;
}

std::array<double, 2> grey_range(const GreyVolume& volume) {
  require_valid(volume);
  std::array<double, 2> range = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  bool found = false;
  for (const float value : volume.values) {
    if (std::isnan(value)) continue;
    found = true;
    range = {std::min(range[0], double(value)), std::max(range[1], double(value))};
  }
  if (!found) throw Error("no sample of the volume is a number; check the type of its values.");
  return range;
}

std::size_t count_from(const GreyVolume& volume, double threshold) {
  require_valid(volume);
  return std::size_t(std::count_if(volume.values.begin(), volume.values.end(),
                                   [&](float value) { return double(value) >= threshold; }));
}

std::map<int, std::size_t> count_labels(const LabelVolume& volume) {
  require_valid(volume);
  std::vector<std::size_t> counts(kMaxLabels, 0);
  for (const std::uint16_t label : volume.values) ++counts[label];
  std::map<int, std::size_t> used;
  for (int label = 0; label < kMaxLabels; ++label)
    if (counts[std::size_t(label)] > 0) used[label] = counts[std::size_t(label)];
  return used;
}

std::map<int, std::size_t> count_labels(const GreyVolume& volume, std::size_t max_labels) {
  require_valid(volume);
  std::map<int, std::size_t> counts;
  for (const float value : volume.values) {
    const float label = std::round(value);
    if (!(label >= 0 && label < kMaxLabels && double(std::abs(value - label)) <= kLabelRounding)) return {};
    ++counts[int(label)];
    if (counts.size() > max_labels) return {};
  }
  return counts;
}

std::uint16_t unused_label(const LabelVolume& volume) {
  require_valid(volume);
  const int label = *std::max_element(volume.values.begin(), volume.values.end()) + 1;
  if (label == kMaxLabels) throw Error("the volume uses label 65535, the last possible one; renumber its labels.");
  return std::uint16_t(label);
}

}  // namespace hapticut
