// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "hapticut/core/volume.hpp"
#include "hapticut/io/volume/volumes.hpp"

/// @file
/// An image as a file stores it, and what becomes of it.
namespace hapticut {

/// How a grid lies in space, in the units of files.
struct FileGeometry {
  std::array<int, 3> dims = {0, 0, 0};
  Vec3 spacing_mm = Vec3::Zero();     ///< zero: the file does not say
  Vec3 origin_mm = Vec3::Zero();      ///< of sample (0,0,0)
  Mat3 direction = Mat3::Identity();  ///< columns: directions of the grid's axes
  std::string unknown_unit = {};      ///< of spacing and origin, where the file names one that is not known
};

/// Values as stored, x fastest, in the machine's byte order.
struct RawImage {
  FileGeometry geometry;
  ValueType type = ValueType::uint8;
  std::vector<std::byte> bytes;
  std::vector<bool> padding;  ///< samples outside the field of view; shorter than the values: the others are within

  [[nodiscard]] bool is_padding(std::size_t sample) const { return sample < padding.size() && padding[sample]; }
  void mark_padding(std::size_t sample) {
    if (padding.size() <= sample) padding.resize(sample + 1);
    padding[sample] = true;
  }
};

/// [1] Cosine between axes that are perpendicular but for the rounding of their directions in a header: three digits,
/// and three of directions times a spacing of 0.3 mm in NRRD. A gantry is tilted by more: half a degree.
inline constexpr double kLargestRounding = 6e-3;

[[nodiscard]] std::size_t size_of(ValueType type);

/// Calls `use(Type{})` with the C++ type of the values.
template <class Use>
void with_value_type(ValueType type, const Use& use) {
  switch (type) {
    case ValueType::uint8:
      return use(std::uint8_t{});
    case ValueType::int8:
      return use(std::int8_t{});
    case ValueType::uint16:
      return use(std::uint16_t{});
    case ValueType::int16:
      return use(std::int16_t{});
    case ValueType::uint32:
      return use(std::uint32_t{});
    case ValueType::int32:
      return use(std::int32_t{});
    case ValueType::uint64:
      return use(std::uint64_t{});
    case ValueType::int64:
      return use(std::int64_t{});
    case ValueType::float32:
      return use(float{});
    case ValueType::float64:
      return use(double{});
  }
}

/// Checks that there are between 1 and kMaxVolumeSamples samples, a whole number along every axis.
/// @param dims  any numbers that a header may claim
/// @throws Error a sentence that begins with "it"
void require_sane_dims(const std::array<double, 3>& dims);

/// Reverses the bytes of every value.
void swap_bytes(RawImage& image);

/// @param path     for messages
/// @param spacing  [m] replaces that of the file
/// @throws Error when the geometry is not usable or a value does not fit
[[nodiscard]] GreyVolume to_grey_volume(const RawImage& image, const std::filesystem::path& path,
                                        const std::optional<Vec3>& spacing);
[[nodiscard]] LabelVolume to_label_volume(const RawImage& image, const std::filesystem::path& path,
                                          const std::optional<Vec3>& spacing);

}  // namespace hapticut
