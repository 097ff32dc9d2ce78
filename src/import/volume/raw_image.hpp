// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "hapticut/core/volume.hpp"
#include "hapticut/import/volume/volumes.hpp"
#include "io/value_types.hpp"

/// @file
/// An image as stored in a file, and its conversion to a volume.
namespace hapticut {

/// Geometry of a grid, in the units of files.
struct FileGeometry {
  std::array<int, 3> dims = {0, 0, 0};
  Vec3 spacing_mm = Vec3::Zero();     ///< zero: unknown; negative: the axis points against its direction
  Vec3 origin_mm = Vec3::Zero();      ///< position of sample (0,0,0)
  Mat3 direction = Mat3::Identity();  ///< columns: directions of the grid's axes
  std::string unknown_unit = {};      ///< unit of spacing and origin, if the file has an unknown one
  bool axes_assumed = false;          ///< the file should say how its axes lie in the patient, and does not

  /// Sets spacing and directions.
  /// @param steps  columns: vector from a sample to the next one along each axis
  void set_axes(const Mat3& steps) {
    spacing_mm = steps.colwise().norm();
    direction = steps * spacing_mm.cwiseInverse().asDiagonal();
  }
  void scale(double unit_mm) {
    spacing_mm *= unit_mm;
    origin_mm *= unit_mm;
  }
};

/// Values as stored, x fastest, in machine byte order.
struct RawImage {
  FileGeometry geometry;
  ValueType type = ValueType::uint8;
  std::string bytes;
  std::vector<bool> padding;              ///< true: sample outside the field of view; missing elements are false
  std::vector<std::string> remarks = {};  ///< as in Volume

  /// [bytes] Required size of the values.
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

/// [1] Maximum cosine between perpendicular axes, caused by rounding of the directions in a header: to three digits, in
/// NRRD after multiplication by a spacing of 0.3 mm. A tilted gantry exceeds it: half a degree.
inline constexpr double kMaxRounding = 6e-3;

/// Checks that there are between 1 and kMaxVolumeSamples samples, a whole number along every axis.
/// @param dims  numbers from a header, not yet checked
/// @throws Error without the name of the file
void require_sane_dims(const std::array<double, 3>& dims);

/// @throws Error without the name of the file, when there are fewer than three dimensions
/// @param max_dimensions  limit of the format
void require_dimensions(double dimensions, double max_dimensions);

/// @throws Error without the name of the file, when an axis after the third has several samples
void require_one_volume(double samples);

/// Reverses the bytes of every value.
void swap_bytes(RawImage& image);

/// @param path     for messages
/// @param spacing  [m] replaces the spacing of the file
/// @throws Error when the geometry is invalid or a value does not fit
[[nodiscard]] GreyVolume to_grey_volume(const RawImage& image, const std::filesystem::path& path,
                                        const std::optional<Vec3>& spacing);
[[nodiscard]] LabelVolume to_label_volume(const RawImage& image, const std::filesystem::path& path,
                                          const std::optional<Vec3>& spacing);

}  // namespace hapticut
