// SPDX-License-Identifier: Apache-2.0
#include <itkBinShrinkImageFilter.h>
#include <itkLabelImageGaussianInterpolateImageFunction.h>
#include <itkLinearInterpolateImageFunction.h>
#include <itkNearestNeighborExtrapolateImageFunction.h>
#include <itkNearestNeighborInterpolateImageFunction.h>
#include <itkResampleImageFilter.h>

#include <cmath>

#include "hapticut/import/volume/volume_filters.hpp"
#include "hapticut/import/volume/volumes.hpp"
#include "import/volume/itk_volume.hpp"

namespace hapticut {
namespace {

using GreyImage = itk::Image<float, 3>;
using LabelImage = itk::Image<std::uint16_t, 3>;

/// The grid of cubic samples with the same lower corner, without values.
template <class Value>
Volume<Value> cubic_grid(const Volume<Value>& volume, double size) {
  require_valid(volume);
  require_positive(size, "voxel size [m]");
  Volume<Value> cubic;
  double samples = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double count = std::ceil(volume.dims[axis] * volume.spacing[axis] / size - 1e-6);
    samples *= count;
    if (!(samples <= double(kMaxVolumeSamples)))
      throw Error("a volume resampled to " + format_number(size) + " m would have more than " +
                  format_number(double(kMaxVolumeSamples)) + " samples; choose a larger voxel size or crop it first.");
    cubic.dims[axis] = int(count);
  }
  cubic.spacing.setConstant(size);
  const Vec3 p_GC = (cubic.spacing - volume.spacing) / 2;
  cubic.X_WG = volume.X_WG * Pose::from_translation(p_GC);
  return cubic;
}

/// Fills the values of `target` from an image in the frame of `source`.
template <class Value>
void fill_from(const itk::Image<Value, 3>* image, itk::InterpolateImageFunction<itk::Image<Value, 3>>* interpolator,
               const Vec3& source_spacing, Volume<Value>& target) {
  using Image = itk::Image<Value, 3>;
  const auto filter = itk::ResampleImageFilter<Image, Image>::New();
  typename Image::SizeType size;
  typename Image::SpacingType spacing;
  typename Image::PointType origin;
  for (unsigned axis = 0; axis < 3; ++axis) {
    size[axis] = itk::SizeValueType(target.dims[axis]);
    spacing[axis] = target.spacing[axis];
    origin[axis] = (target.spacing[axis] - source_spacing[axis]) / 2;
  }
  filter->SetInput(image);
  filter->SetSize(size);
  filter->SetOutputSpacing(spacing);
  filter->SetOutputOrigin(origin);
  filter->SetInterpolator(interpolator);
  // The last samples may extend beyond the volume; they continue its border values.
  filter->SetExtrapolator(itk::NearestNeighborExtrapolateImageFunction<Image, double>::New());
  filter->Update();
  const Value* values = filter->GetOutput()->GetBufferPointer();
  target.values.assign(values, values + target.size());
}

}  // namespace

GreyVolume resample(const GreyVolume& volume, double voxel_size) {
  GreyVolume target = cubic_grid(volume, voxel_size);
  return with_filters("resampling a volume", [&] {
    GreyImage::Pointer image = image_view(volume);
    // If several samples fall into a new one, average them before interpolating.
    itk::BinShrinkImageFilter<GreyImage, GreyImage>::ShrinkFactorsType factors;
    bool shrink = false;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const double ratio = std::floor(voxel_size / volume.spacing[axis] + 1e-6);
      factors[axis] = unsigned(std::clamp(ratio, 1.0, double(volume.dims[axis])));
      shrink |= factors[axis] > 1;
    }
    if (shrink) {
      const auto filter = itk::BinShrinkImageFilter<GreyImage, GreyImage>::New();
      filter->SetInput(image);
      filter->SetShrinkFactors(factors);
      filter->Update();
      image = filter->GetOutput();
      image->DisconnectPipeline();
    }
    fill_from<float>(image, itk::LinearInterpolateImageFunction<GreyImage>::New(), volume.spacing, target);
    return target;
  });
}

LabelVolume resample(const LabelVolume& volume, double voxel_size, LabelInterpolation interpolation) {
  LabelVolume target = cubic_grid(volume, voxel_size);
  return with_filters("resampling a volume", [&] {
    const LabelImage::Pointer image = image_view(volume);
    if (interpolation == LabelInterpolation::nearest) {
      fill_from<std::uint16_t>(image, itk::NearestNeighborInterpolateImageFunction<LabelImage>::New(), volume.spacing,
                               target);
      return target;
    }
    const auto smooth = itk::LabelImageGaussianInterpolateImageFunction<LabelImage>::New();
    decltype(smooth->GetSigma()) sigma;
    for (unsigned axis = 0; axis < 3; ++axis) sigma[axis] = std::max(volume.spacing[axis], voxel_size) / 2;
    smooth->SetSigma(sigma);
    smooth->SetAlpha(3);  // the Gaussian ends at three sigma
    fill_from<std::uint16_t>(image, smooth, volume.spacing, target);
    return target;
  });
}

}  // namespace hapticut
