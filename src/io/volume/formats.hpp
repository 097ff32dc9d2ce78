// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/volume/raw_image.hpp"

/// @file
/// One reader per format. Each checks what the header claims against the size of the file before it allocates.
namespace hapticut {

/// What the names of files end in that read_grey_volume and read_label_volume read, in lower case.
[[nodiscard]] std::vector<std::string_view> volume_endings();

/// Gives the content of a file that a header names.
using DataFile = std::function<std::string(const std::string& name)>;

/// @param bytes  the whole file
/// @throws Error a sentence that begins with "it" or "its"
[[nodiscard]] RawImage parse_nrrd(std::string_view bytes, const DataFile& data_file);
[[nodiscard]] RawImage parse_meta_image(std::string_view bytes, const DataFile& data_file);

/// NIfTI-1 or NIfTI-2 in one file.
/// @param bytes  the whole file, packed by gzip or not
/// @throws Error as above
[[nodiscard]] RawImage parse_nifti(std::string_view bytes);

/// @throws Error as above
[[nodiscard]] RawImage parse_invesalius(std::string_view bytes);

/// A file with several frames.
[[nodiscard]] RawImage read_dicom_file(const std::filesystem::path& path);

/// Whether it begins like one, whatever its ending.
[[nodiscard]] bool is_dicom_file(const std::filesystem::path& path);

/// A folder with one file per slice, or with a single file of several frames.
/// @param series  its Series Instance UID, or empty: the only one
/// @return nothing where no file of the folder is a DICOM picture
[[nodiscard]] std::optional<RawImage> read_dicom_series(const std::filesystem::path& folder, const std::string& series);

/// A folder of PNG or TIFF slices of one channel; the spacing is left at zero.
[[nodiscard]] RawImage read_slices(const std::filesystem::path& folder);

/// Whether a folder has PNG or TIFF files.
[[nodiscard]] bool has_slices(const std::filesystem::path& folder);

/// How many times smaller a compression can make data at best.
inline constexpr double kNotCompressed = 1;
inline constexpr double kDeflate = 1032;
inline constexpr double kAnyCompression = 1e5;  ///< of runs of one value by Zstandard: 2^15; JPEG 2000 stays below

/// @param best_ratio  [1] of needed to available bytes
/// @throws Error when there is less than a header claims, even at the best ratio of its compression: a sentence that
///         begins with "its"
void require_bytes(double needed, double available, double best_ratio);

/// @throws Error when there is more than a header claims, e.g. because it was written by hand and names another type or
///         another size: a sentence that begins with "its"
void require_no_more(std::uint64_t claimed, std::uint64_t available);

}  // namespace hapticut
