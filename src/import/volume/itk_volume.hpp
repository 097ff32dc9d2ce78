// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <itkImage.h>

#include <new>
#include <string>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/volume.hpp"

/// @file
/// Converts volumes to images of ITK's filters and back. Filters work on the axes of the grid, without the pose.
namespace hapticut {

/// While it lives, ITK prints nothing.
class QuietItk {
 public:
  QuietItk();
  ~QuietItk();
  QuietItk(const QuietItk&) = delete;
  QuietItk& operator=(const QuietItk&) = delete;

 private:
  bool warned_;
};

/// The sentence of an ITK exception that states the problem.
[[nodiscard]] std::string reason_of(const itk::ExceptionObject& exception);

/// An image that uses the values of a volume in place; the volume must outlive it.
template <class Value>
typename itk::Image<Value, 3>::Pointer image_view(const Volume<Value>& volume) {
  using Image = itk::Image<Value, 3>;
  const auto image = Image::New();
  typename Image::SizeType size;
  typename Image::SpacingType spacing;
  for (unsigned axis = 0; axis < 3; ++axis) {
    size[axis] = itk::SizeValueType(volume.dims[axis]);
    spacing[axis] = volume.spacing[axis];
  }
  image->SetRegions(size);
  image->SetSpacing(spacing);
  // Filters only read their input, but ITK has no const type for it.
  image->GetPixelContainer()->SetImportPointer(const_cast<Value*>(volume.values.data()), volume.values.size(), false);
  return image;
}

/// Runs filters without ITK's output. Their exceptions become an Error that names the operation.
template <class Work>
auto with_filters(const std::string& doing, const Work& work) {
  try {
    const QuietItk quiet;
    return work();
  } catch (const itk::ExceptionObject& exception) {
    throw Error(doing + " failed: " + reason_of(exception));
  } catch (const std::bad_alloc&) {
    throw Error(doing + " failed: there is not enough memory. Crop the volume first.");
  }
}

}  // namespace hapticut
