// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "import/volume/raw_image.hpp"

/// @file
/// One parser per format. Each checks the claims of the header against the size of the file before it allocates.
namespace hapticut {

/// The extensions that read_grey_volume and read_label_volume support, in lower case.
[[nodiscard]] std::vector<std::string_view> volume_extensions();

/// Returns the content of a file that a header names.
using DataFile = std::function<std::string(const std::string& name)>;

/// @param bytes  the whole file
/// @throws Error without the name of the file
[[nodiscard]] RawImage parse_nrrd(std::string_view bytes, const DataFile& data_file);
[[nodiscard]] RawImage parse_meta_image(std::string_view bytes, const DataFile& data_file);

/// Parses NIfTI-1 or NIfTI-2 in one file.
/// @param bytes  the whole file, compressed by gzip or not
/// @throws Error without the name of the file
[[nodiscard]] RawImage parse_nifti(std::string_view bytes);

/// @throws Error without the name of the file
[[nodiscard]] RawImage parse_invesalius(std::string_view bytes);

/// Reads a DICOM file with several frames.
[[nodiscard]] RawImage read_dicom_file(const std::filesystem::path& path);

/// Whether a file begins like DICOM, independent of its extension.
[[nodiscard]] bool is_dicom_file(const std::filesystem::path& path);

/// Reads a DICOM folder: one file per slice, or a single file with several frames.
/// @param series  Series Instance UID; empty: the only series
/// @return nullopt when the folder has no DICOM picture
[[nodiscard]] std::optional<RawImage> read_dicom_series(const std::filesystem::path& folder, const std::string& series);

/// Reads a folder of PNG or TIFF slices with one channel. The spacing stays 0.
[[nodiscard]] RawImage read_slices(const std::filesystem::path& folder);

/// Whether a folder has PNG or TIFF files.
[[nodiscard]] bool has_slices(const std::filesystem::path& folder);

/// Maximum compression ratio of a format.
inline constexpr double kNotCompressed = 1;
inline constexpr double kDeflate = 1032;
inline constexpr double kAnyCompression = 1e5;  ///< Zstandard reaches 2^15 on runs of one value; JPEG 2000 is below

/// @param best_ratio  [1] maximum ratio of needed to available bytes
/// @throws Error without the name of the file, when the available bytes are fewer than the header needs at this
///         ratio
void require_bytes(double needed, double available, double best_ratio);

/// Allows what writers leave behind the values: less than a slice of zeros in a file of its own; in the file of the
/// header blanks and zeros of any number.
/// @param slice      [bytes] of a slice
/// @param same_file  the values follow their header
/// @throws Error without the name of the file, when there are more bytes than the header claims, e.g. because a
///         hand-written header has a wrong type or size
void require_no_more(std::uint64_t claimed, std::string_view data, std::uint64_t slice, bool same_file);

}  // namespace hapticut
