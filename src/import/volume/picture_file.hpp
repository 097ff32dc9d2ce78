// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "import/volume/raw_image.hpp"

/// @file
/// Reads pictures through the libraries of their formats. ITK's readers are not used: a damaged PNG file makes them end
/// the program, a damaged TIFF file makes them allocate any claimed size.
namespace hapticut {

struct PictureFile {
  std::array<int, 2> dims;  ///< width, height
  unsigned channels;        ///< 1 grey, 2 with alpha, 3 colour, 4 with alpha
  ValueType type;           ///< type of a channel
  std::string bytes;        ///< row by row from the top, interleaved channels, machine byte order
};

/// Reads a PNG file. Palettes and depths below 8 bits are expanded; values are not scaled.
/// @throws Error when the file is not PNG, damaged, truncated, or claims more pixels than it can contain
[[nodiscard]] PictureFile read_png(const std::filesystem::path& path);

/// Reads a TIFF file: grey values or colours of 8 or 16 bits, or grey values in single precision, in strips or tiles.
/// @throws Error when the file is not TIFF, damaged, truncated, claims more pixels than fit in it, has several pages
///         or is of another kind
[[nodiscard]] PictureFile read_tiff(const std::filesystem::path& path);

}  // namespace hapticut
