// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "hapticut/core/description.hpp"
#include "hapticut/core/mesh.hpp"
#include "hapticut/core/volume.hpp"
#include "hapticut/io/value_type.hpp"
#include "hapticut/workpiece/workpiece.hpp"

/// @file
/// Reads and writes dense volumes. Files are in millimetres, volumes in metres.
///
/// The world axes are x to the patient's left, y to the back, z to the head (LPS), for any convention of the file.
/// Origin and direction of the file become `Volume::X_WG`. A left-handed grid is reversed along its last axis: the pose
/// becomes right-handed, and every sample keeps its place. `Volume::remarks` says which files of a folder were left
/// out, and whether the directions of the axes were assumed.
///
/// Every function throws an Error that names the file when it cannot be opened, has another format than its name says,
/// is truncated, does not have three dimensions and one value per sample, has sheared axes, or claims more samples than
/// its size can contain or than kMaxVolumeSamples.
namespace hapticut {

/// Maximum number of samples that are read: 8 GiB as grey values.
inline constexpr std::int64_t kMaxVolumeSamples = std::int64_t(1) << 31;

/// Information that a file lacks.
struct VolumeReadOptions {
  /// [m] Replaces the spacing of the file. Required if the file has no spacing (PNG and TIFF slices).
  std::optional<Vec3> spacing = std::nullopt;
  /// Series Instance UID. Required if a DICOM folder has several series, or a series with different kinds of slices;
  /// then the most frequent kind is read.
  std::string dicom_series = {};
};

/// Reads grey values.
/// @param path  a file or a folder. File: NRRD, NIfTI, MetaImage or InVesalius (without a pose: the first sample is at
///              the origin), chosen by the extension (docs/files.md); or multi-frame DICOM with any extension. Folder:
///              one DICOM series, or PNG or TIFF slices, ordered by the number in their names. The spacing of a DICOM
///              series is the distance between its slices, not their thickness.
[[nodiscard]] GreyVolume read_grey_volume(const std::filesystem::path& path, const VolumeReadOptions& options = {});

/// Reads labels, from the formats of `read_grey_volume`. Every value must be a whole number, 0 ... 65535, or at most
/// kLabelRounding away from one.
[[nodiscard]] LabelVolume read_label_volume(const std::filesystem::path& path, const VolumeReadOptions& options = {});

/// Reads labels from a folder of colour slices: each listed colour is a label, every other colour is 0. Pixels that are
/// not fully opaque are 0 too, because drawing programs leave them as noise.
/// @param spacing  [m] distance between pixels and between slices
/// @throws Error also when no pixel has one of these colours
[[nodiscard]] LabelVolume read_color_slices(const std::filesystem::path& folder,
                                            const std::map<Color, std::uint16_t>& label_of, const Vec3& spacing);

/// Layout of a file without a header.
struct RawLayout {
  std::array<int, 3> dims = {0, 0, 0};  ///< number of samples along x (fastest), y, z
  Vec3 spacing = Vec3::Zero();          ///< [m]
  ValueType type = ValueType::uint8;
  bool big_endian = false;
  std::uint64_t skip = 0;  ///< bytes before the first value
};

/// Reads grey values from a file without a header.
/// @throws Error also when the length of the file differs from the layout
[[nodiscard]] GreyVolume read_raw_grey_volume(const std::filesystem::path& path, const RawLayout& layout);
/// Reads labels from a file without a header.
/// @throws Error also when the length of the file differs from the layout
[[nodiscard]] LabelVolume read_raw_label_volume(const std::filesystem::path& path, const RawLayout& layout);

/// Writes a compressed NRRD file in millimetres. An existing file is replaced only when the new file is complete.
/// @throws Error when the volume is not consistent or the file cannot be written
void write_nrrd(const GreyVolume& volume, const std::filesystem::path& path);
void write_nrrd(const LabelVolume& volume, const std::filesystem::path& path);

/// Writes a workpiece as two NRRD files: material ids under `path`, filled fractions under the name with `_density`
/// before the extension.
/// @throws Error when the workpiece is empty or a file cannot be written
void write_nrrd(const Workpiece& workpiece, const std::filesystem::path& path);

}  // namespace hapticut
