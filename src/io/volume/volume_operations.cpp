// SPDX-License-Identifier: Apache-2.0
#include "hapticut/io/volume/volume_operations.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <limits>
#include <string>

#include "hapticut/io/volume/volumes.hpp"

namespace hapticut {
namespace {

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
  IndexBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.min[axis] = std::max(samples.min[axis], 0);
    box.max[axis] = std::min(samples.max[axis], volume.dims[axis] - 1);
  }
  if (box.empty()) throw Error("the box to crop to has no sample of the volume; check that it holds sample indices.");
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

template <class Value, class Wanted>
IndexBox box_of(const Volume<Value>& volume, const Wanted& wanted, double margin) {
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

GreyVolume crop(const GreyVolume& volume, const IndexBox& samples) { return cropped(volume, samples); }
LabelVolume crop(const LabelVolume& volume, const IndexBox& samples) { return cropped(volume, samples); }

IndexBox box_around(const LabelVolume& volume, const std::vector<std::uint16_t>& labels, double margin) {
  std::bitset<65536> wanted;
  for (const std::uint16_t label : labels) wanted.set(label);
  if (labels.empty()) wanted.set().reset(0);
  return box_of(
      volume, [&](std::uint16_t label) { return wanted[label]; }, margin);
}

IndexBox box_around(const GreyVolume& volume, double threshold, double margin) {
  return box_of(
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

}  // namespace hapticut
