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
#include "io/value_types.hpp"

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

  /// Sets spacing and directions.
  /// @param steps  columns: from a sample to the next one along each axis
  void set_axes(const Mat3& steps) {
    spacing_mm = steps.colwise().norm();
    direction = steps * spacing_mm.cwiseInverse().asDiagonal();
  }
  void scale(double unit_mm) {
    spacing_mm *= unit_mm;
    origin_mm *= unit_mm;
  }
};

/// Values as stored, x fastest, in the machine's byte order.
struct RawImage {
  FileGeometry geometry;
  ValueType type = ValueType::uint8;
  std::string bytes;
  std::vector<bool> padding;  ///< samples outside the field of view; shorter than the values: the others are within

  /// [bytes] that the values must have.
  [[nodiscard]] std::uint64_t needed() const {
    return std::uint64_t(geometry.dims[0]) * std::uint64_t(geometry.dims[1]) * std::uint64_t(geometry.dims[2]) *
           size_of(type);
  }
  [[nodiscard]] bool is_padding(std::size_t sample) const { return sample < padding.size() && padding[sample]; }
  void mark_padding(std::size_t sample) {
    if (padding.size() <= sample) padding.resize(sample + 1);
    padding[sample] = true;
  }
};

/// [1] Cosine between axes that are perpendicular but for the rounding of their directions in a header: three digits,
/// and three of directions times a spacing of 0.3 mm in NRRD. A gantry is tilted by more: half a degree.
inline constexpr double kMaxRounding = 6e-3;

/// Checks that there are between 1 and kMaxVolumeSamples samples, a whole number along every axis.
/// @param dims  any numbers that a header may claim
/// @throws Error a sentence that begins with "it"
void require_sane_dims(const std::array<double, 3>& dims);

/// @throws Error unless there are three dimensions at least: a sentence that begins with "it"
/// @param max_dimensions  that the format can have
void require_dimensions(double dimensions, double max_dimensions);

/// @throws Error unless an axis behind the third has one sample: a sentence that begins with "it"
void require_one_volume(double samples);

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
