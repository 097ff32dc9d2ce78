// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <vector>

#include "hapticut/core/volume.hpp"
#include "hapticut/io/volume/volumes.hpp"

/// @file
/// An image as a file stores it, and what becomes of it.
namespace hapticut {

/// How a grid lies in space, in the units of files.
struct FileGeometry {
  std::array<int, 3> dims = {0, 0, 0};
  Vec3 spacing_mm = Vec3::Ones();
  Vec3 origin_mm = Vec3::Zero();      ///< of sample (0,0,0)
  Mat3 direction = Mat3::Identity();  ///< columns: directions of the grid's axes
};

/// Values as stored, x fastest, in the machine's byte order.
struct RawImage {
  FileGeometry geometry;
  ValueType type = ValueType::uint8;
  std::vector<std::byte> bytes;
};

[[nodiscard]] std::size_t size_of(ValueType type);

/// Checks that there are between 1 and kMaxVolumeSamples samples.
/// @param dims  any numbers that a header may claim
/// @throws Error
void require_sane_dims(const std::filesystem::path& path, const std::array<double, 3>& dims);

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
