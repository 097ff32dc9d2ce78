// SPDX-License-Identifier: Apache-2.0
#include "io/volume/itk_image.hpp"

#include <itkObject.h>
#include <nifti1_io.h>

#include <algorithm>

namespace hapticut {
namespace {

ValueType value_type(const itk::ImageIOBase& io, const std::filesystem::path& path) {
  using Component = itk::IOComponentEnum;
  switch (io.GetComponentType()) {
    case Component::UCHAR:
      return ValueType::uint8;
    case Component::CHAR:
      return ValueType::int8;
    case Component::USHORT:
      return ValueType::uint16;
    case Component::SHORT:
      return ValueType::int16;
    case Component::UINT:
      return ValueType::uint32;
    case Component::INT:
      return ValueType::int32;
    case Component::ULONG:
      return sizeof(unsigned long) == 8 ? ValueType::uint64 : ValueType::uint32;
    case Component::LONG:
      return sizeof(long) == 8 ? ValueType::int64 : ValueType::int32;
    case Component::ULONGLONG:
      return ValueType::uint64;
    case Component::LONGLONG:
      return ValueType::int64;
    case Component::FLOAT:
      return ValueType::float32;
    case Component::DOUBLE:
      return ValueType::float64;
    default:
      cannot_read(path, "its values are of a type that is not read.");
  }
}

void require_scalar_volume(const itk::ImageIOBase& io, const std::filesystem::path& path) {
  const unsigned dimensions = io.GetNumberOfDimensions();
  bool three = dimensions >= 3;
  for (unsigned d = 3; d < dimensions; ++d) three &= io.GetDimensions(d) == 1;
  if (!three)
    cannot_read(path, "it has " + std::to_string(dimensions) +
                          " dimensions; a volume has three. Take one volume out of it, or put its slices together.");
  if (io.GetNumberOfComponents() != 1)
    cannot_read(path, "it has " + std::to_string(io.GetNumberOfComponents()) +
                          " values per sample; a volume has one. Convert it to grey values or labels.");
  require_sane_dims(path, {double(io.GetDimensions(0)), double(io.GetDimensions(1)), double(io.GetDimensions(2))});
}

}  // namespace

QuietItk::QuietItk() : warned_(itk::Object::GetGlobalWarningDisplay()) {
  itk::Object::SetGlobalWarningDisplay(false);
  nifti_set_debug_level(0);
}
QuietItk::~QuietItk() { itk::Object::SetGlobalWarningDisplay(warned_); }

std::string reason_of(const itk::ExceptionObject& exception) {
  // Descriptions run over several lines, from the general to the particular: the last one says most.
  std::string text = exception.GetDescription();
  text.erase(text.find_last_not_of(" \n\r\t.") + 1);
  const auto line = text.find_last_of('\n');
  if (line != std::string::npos) text.erase(0, line + 1);
  // "ITK ERROR: PNGImageIO(0x55d5738a9f00): ..." names an object that means nothing to a reader.
  const auto object = text.find("): ");
  if (text.find("ERROR: ") != std::string::npos && object != std::string::npos) text.erase(0, object + 3);
  return text.empty() ? "the file is damaged." : text + ".";
}

RawImage read_itk_header(itk::ImageIOBase& io, const std::filesystem::path& path) {
  return with_itk(path, [&] {
    io.SetFileName(path.string());
    io.ReadImageInformation();
    require_scalar_volume(io, path);
    RawImage image;
    image.type = value_type(io, path);
    for (unsigned axis = 0; axis < 3; ++axis) {
      image.geometry.dims[axis] = int(io.GetDimensions(axis));
      image.geometry.spacing_mm[axis] = io.GetSpacing(axis);
      image.geometry.origin_mm[axis] = io.GetOrigin(axis);
      const std::vector<double> direction = io.GetDirection(axis);
      for (unsigned row = 0; row < 3; ++row) image.geometry.direction(row, axis) = direction[row];
    }
    return image;
  });
}

RawImage read_itk_image(itk::ImageIOBase& io, const std::filesystem::path& path) {
  RawImage image = read_itk_header(io, path);
  image.bytes = with_itk(path, [&] { return read_itk_values(io); });
  return image;
}

std::vector<std::byte> read_itk_values(itk::ImageIOBase& io) {
  itk::ImageIORegion region(io.GetNumberOfDimensions());
  for (unsigned d = 0; d < io.GetNumberOfDimensions(); ++d) region.SetSize(d, io.GetDimensions(d));
  io.SetIORegion(region);
  std::vector<std::byte> bytes(std::size_t(io.GetImageSizeInBytes()));
  io.Read(bytes.data());
  return bytes;
}

}  // namespace hapticut
