// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "io/volume/raw_image.hpp"

/// @file
/// One reader per format. Each checks what the header claims against the size of the file before it allocates.
namespace hapticut {

[[nodiscard]] RawImage read_nrrd(const std::filesystem::path& path);
[[nodiscard]] RawImage read_nifti(const std::filesystem::path& path);
[[nodiscard]] RawImage read_meta_image(const std::filesystem::path& path);
[[nodiscard]] RawImage read_invesalius(const std::filesystem::path& path);

/// A file with several frames.
[[nodiscard]] RawImage read_dicom_file(const std::filesystem::path& path);

/// A folder with one file per slice.
/// @param series  its Series Instance UID, or empty: the only one
[[nodiscard]] RawImage read_dicom_series(const std::filesystem::path& folder, const std::string& series);

/// A folder of PNG or TIFF slices of one channel; the spacing is left at zero.
[[nodiscard]] RawImage read_slices(const std::filesystem::path& folder);

/// Whether a folder has PNG or TIFF files.
[[nodiscard]] bool has_slices(const std::filesystem::path& folder);

/// How many times smaller a compression can make data at best.
inline constexpr double kNotCompressed = 1;
inline constexpr double kDeflate = 1032;
inline constexpr double kAnyCompression = 1e5;  ///< of runs of one value by Zstandard: 2^15; JPEG 2000 stays below

/// @param best_ratio  [1] of needed to available bytes
/// @throws Error when a file is too small to hold what its header claims, even at the best ratio of its compression
void require_bytes(const std::filesystem::path& path, double needed, double available, double best_ratio);

}  // namespace hapticut
