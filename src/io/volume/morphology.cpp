// SPDX-License-Identifier: Apache-2.0
#include <itkConnectedComponentImageFilter.h>
#include <itkSignedMaurerDistanceMapImageFilter.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "hapticut/io/volume/volume_operations.hpp"
#include "io/volume/itk_volume.hpp"

namespace hapticut {
namespace {

using Mask = Volume<std::uint8_t>;
using MaskImage = itk::Image<std::uint8_t, 3>;
using ComponentImage = itk::Image<std::uint32_t, 3>;
using DistanceImage = itk::Image<float, 3>;

/// 1 where `inside(label)`.
template <class Inside>
Mask mask_of(const LabelVolume& volume, const Inside& inside) {
  require_valid(volume);
  Mask mask;
  mask.dims = volume.dims;
  mask.spacing = volume.spacing;
  mask.X_WG = volume.X_WG;
  mask.values.resize(volume.size());
  std::transform(volume.values.begin(), volume.values.end(), mask.values.begin(),
                 [&](std::uint16_t label) { return std::uint8_t(inside(label) ? 1 : 0); });
  return mask;
}

/// Numbers the bodies of a mask that touch by faces, from 1; 0 outside.
ComponentImage::Pointer components_of(const Mask& mask) {
  const auto filter = itk::ConnectedComponentImageFilter<MaskImage, ComponentImage>::New();
  filter->SetInput(image_view(mask));
  filter->FullyConnectedOff();
  filter->SetBackgroundValue(0);
  filter->Update();
  return filter->GetOutput();
}

/// Distance [m] of every sample from the nearest one of the mask; zero or less within.
DistanceImage::Pointer distance_from(const Mask& mask) {
  const auto filter = itk::SignedMaurerDistanceMapImageFilter<MaskImage, DistanceImage>::New();
  filter->SetInput(image_view(mask));
  filter->SetBackgroundValue(0);
  filter->SquaredDistanceOff();
  filter->UseImageSpacingOn();
  filter->InsideIsPositiveOff();
  filter->Update();
  return filter->GetOutput();
}

/// The mask closed by a ball: what a ball rolled around the outside cannot reach is added.
/// @pre the mask is further than the radius from its border
void close(Mask& mask, double radius) {
  // Distances come in single precision; a sample exactly on the ball belongs to it.
  const auto reach = float(radius * (1 + 1e-5));
  {
    const auto distance = distance_from(mask);
    const float* d = distance->GetBufferPointer();
    for (std::size_t n = 0; n < mask.values.size(); ++n)
      mask.values[n] = d[n] <= reach ? 0 : 1;  // what is left outside
  }
  const auto distance = distance_from(mask);
  const float* d = distance->GetBufferPointer();
  for (std::size_t n = 0; n < mask.values.size(); ++n) mask.values[n] = d[n] > reach ? 1 : 0;
}

}  // namespace

LabelVolume keep_largest_component(LabelVolume volume) {
  const Mask mask = mask_of(volume, [](std::uint16_t label) { return label != 0; });
  return with_filters("finding the largest component", [&] {
    const auto components = components_of(mask);
    const std::uint32_t* id = components->GetBufferPointer();
    std::vector<std::uint64_t> size(1, 0);
    for (std::size_t n = 0; n < volume.values.size(); ++n) {
      if (id[n] >= size.size()) size.resize(id[n] + 1U, 0);
      if (id[n] != 0) ++size[id[n]];
    }
    if (size.size() == 1) throw Error("the volume has no label but 0; there is no component to keep.");
    const auto largest = std::uint32_t(std::max_element(size.begin(), size.end()) - size.begin());
    for (std::size_t n = 0; n < volume.values.size(); ++n)
      if (id[n] != largest) volume.values[n] = 0;
    return std::move(volume);
  });
}

LabelVolume fill_cavities(LabelVolume volume, std::uint16_t label) {
  const Mask outside = mask_of(volume, [](std::uint16_t value) { return value == 0; });
  return with_filters("filling cavities", [&] {
    const auto components = components_of(outside);
    const std::uint32_t* id = components->GetBufferPointer();
    std::vector<bool> open(1, true);
    const auto [nx, ny, nz] = volume.dims;
    const auto visit = [&](int i, int j, int k) {
      const std::uint32_t component = id[volume.offset(i, j, k)];
      if (component >= open.size()) open.resize(component + 1U, false);
      open[component] = true;
    };
    for (int k = 0; k < nz; ++k)
      for (int j = 0; j < ny; ++j) {
        const bool face = k == 0 || k == nz - 1 || j == 0 || j == ny - 1;
        for (int i = 0; i < nx; i += face || nx == 1 ? 1 : nx - 1) visit(i, j, k);
      }
    for (std::size_t n = 0; n < volume.values.size(); ++n)
      if (id[n] >= open.size() || !open[id[n]]) volume.values[n] = label;
    return std::move(volume);
  });
}

LabelVolume close_gaps(LabelVolume volume, double radius, std::uint16_t label) {
  require_positive(radius, "radius of a closing [m]");
  const IndexBox body = box_around(volume);
  // Room for the ball on every side; the body may touch the border of the volume.
  VoxelIndex from;
  Mask mask;
  mask.spacing = volume.spacing;
  for (int axis = 0; axis < 3; ++axis) {
    const double ball = std::ceil(radius / volume.spacing[axis]);
    if (!(ball <= 4096))
      throw Error("a closing by " + format_number(radius) + " m spans " + format_number(ball) +
                  " samples; at most 4096 are allowed. Check the units.");
    from[axis] = body.min[axis] - int(ball) - 2;
    mask.dims[axis] = body.max[axis] - from[axis] + int(ball) + 3;
  }
  mask.values.assign(mask.size(), 0);
  const auto for_each_row = [&](const auto& use) {
    for (int k = body.min[2]; k <= body.max[2]; ++k)
      for (int j = body.min[1]; j <= body.max[1]; ++j)
        use(&volume.at(body.min[0], j, k), &mask.at(body.min[0] - from[0], j - from[1], k - from[2]));
  };
  const int row = body.max[0] - body.min[0] + 1;
  for_each_row([&](const std::uint16_t* value, std::uint8_t* inside) {
    for (int i = 0; i < row; ++i) inside[i] = value[i] != 0 ? 1 : 0;
  });
  with_filters("closing gaps", [&] { close(mask, radius); });
  // A closing adds nothing outside the smallest box around the body.
  for_each_row([&](std::uint16_t* value, const std::uint8_t* inside) {
    for (int i = 0; i < row; ++i)
      if (value[i] == 0 && inside[i] != 0) value[i] = label;
  });
  return volume;
}

}  // namespace hapticut
