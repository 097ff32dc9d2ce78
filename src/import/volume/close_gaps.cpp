// SPDX-License-Identifier: Apache-2.0
#include <itkSignedMaurerDistanceMapImageFilter.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "hapticut/build/volume_operations.hpp"
#include "hapticut/import/volume/volume_filters.hpp"
#include "import/volume/itk_volume.hpp"

namespace hapticut {
namespace {

using Mask = Volume<std::uint8_t>;
using MaskImage = itk::Image<std::uint8_t, 3>;
using DistanceImage = itk::Image<float, 3>;

/// [m] Distance of every sample from the nearest sample of the mask; 0 or negative inside.
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

/// Closes the mask: adds the samples that a ball rolled around the outside cannot reach.
/// @pre the distance of the mask from its border exceeds the radius
void close(Mask& mask, double radius) {
  // Distances have single precision; a sample exactly on the ball belongs to it.
  const auto reach = float(radius * (1 + 1e-5));
  {
    const auto distance = distance_from(mask);
    const float* d = distance->GetBufferPointer();
    for (std::size_t n = 0; n < mask.values.size(); ++n) mask.values[n] = d[n] <= reach ? 0 : 1;  // 1: outside
  }
  const auto distance = distance_from(mask);
  const float* d = distance->GetBufferPointer();
  for (std::size_t n = 0; n < mask.values.size(); ++n) mask.values[n] = d[n] > reach ? 1 : 0;
}

}  // namespace

LabelVolume close_gaps(LabelVolume volume, double radius, std::uint16_t label) {
  require_positive(radius, "radius of a closing [m]");
  const IndexBox body = box_around(volume);
  // Adds a margin for the ball on every side, because the body may touch the border of the volume.
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
