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
#include "hapticut/io/volume/value_type.hpp"
#include "hapticut/workpiece/workpiece.hpp"

/// @file
/// Dense volumes from and to files. Files hold millimetres, volumes hold metres: the conversion happens here.
///
/// World axes are those of the medical formats: x to the patient's left, y to the back, z to the head (LPS), whatever
/// convention the file uses. Origin and direction of the file become `Volume::X_WG`; a left-handed grid is turned round
/// along its last axis, so that the pose is right-handed and every sample stays where it was.
///
/// Every function throws one Error that names the file: when it cannot be opened, is not what it claims to be, is cut
/// short, has not three dimensions or not one value per sample, has sheared axes, or claims more samples than its size
/// can hold or than kMaxVolumeSamples.
namespace hapticut {

/// More samples than this are not read: as grey values they would take 8 GiB.
inline constexpr std::int64_t kMaxVolumeSamples = std::int64_t(1) << 31;

/// What a reader is told that a file does not say.
struct VolumeReadOptions {
  /// [m] replaces the spacing of the file; needed where the file names no spacing (PNG and TIFF slices).
  std::optional<Vec3> spacing = std::nullopt;
  /// Series Instance UID, needed where a DICOM folder holds several series, or one whose slices are not alike: there it
  /// means the kind of which there are the most.
  std::string dicom_series = {};
};

/// Reads grey values.
/// @param path  a file: NRRD, NIfTI, MetaImage or InVesalius (which has no pose: the first sample is at the origin), by
///              the ending of its name (docs/files.md), or multi-frame DICOM, whatever its ending; or a folder: one
///              DICOM series, or PNG or TIFF slices, ordered by the number that changes along their names. The spacing
///              of a DICOM series is the distance of its slices, not their thickness.
[[nodiscard]] GreyVolume read_grey_volume(const std::filesystem::path& path, const VolumeReadOptions& options = {});

/// Reads labels: the same formats; every value must be a whole number, 0 ... 65535.
[[nodiscard]] LabelVolume read_label_volume(const std::filesystem::path& path, const VolumeReadOptions& options = {});

/// Reads labels from a folder of colour slices: each listed colour is a label, every other one is 0. Pixels that are
/// not wholly opaque are 0 too: partly transparent ones are noise of a drawing program.
/// @param spacing  [m] of the pixels and the slices
/// @throws Error also when the slices have no pixel of these colours
[[nodiscard]] LabelVolume read_color_slices(const std::filesystem::path& folder,
                                            const std::map<Color, std::uint16_t>& label_of, const Vec3& spacing);

/// What a headerless file does not say itself.
struct RawLayout {
  std::array<int, 3> dims = {0, 0, 0};  ///< number of samples along x (fastest), y, z
  Vec3 spacing = Vec3::Zero();          ///< [m]
  ValueType type = ValueType::uint8;
  bool big_endian = false;
  std::uint64_t skip = 0;  ///< bytes before the first value
};

/// @throws Error also when the file is not exactly as long as the layout says
[[nodiscard]] GreyVolume read_raw_grey_volume(const std::filesystem::path& path, const RawLayout& layout);
[[nodiscard]] LabelVolume read_raw_label_volume(const std::filesystem::path& path, const RawLayout& layout);

/// Writes a compressed NRRD file in millimetres. The file appears under its name only when it is complete.
/// @throws Error when the volume is not consistent or the file cannot be written; what was there before remains
void write_nrrd(const std::filesystem::path& path, const GreyVolume& volume);
void write_nrrd(const std::filesystem::path& path, const LabelVolume& volume);

/// Writes a workpiece as two NRRD files: material ids under `path` and filled fractions under the name with `_density`
/// before the extension.
/// @throws Error as above, and when the workpiece is empty
void write_nrrd(const std::filesystem::path& path, const Workpiece& workpiece);

}  // namespace hapticut
