// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "io/volume/raw_image.hpp"

/// @file
/// Pictures as they are stored, through the libraries of their formats. ITK's readers are not used: on a damaged PNG
/// file they end the whole program, on a damaged TIFF file they allocate whatever it claims.
namespace hapticut {

struct PictureFile {
  std::array<int, 2> dims;  ///< width, height
  unsigned channels;        ///< 1 grey, 2 with alpha, 3 colour, 4 with alpha
  ValueType type;           ///< of a channel
  std::string bytes;        ///< row by row from the top, channels together, as the machine orders them
};

/// Palettes and depths below 8 bits are expanded; nothing is scaled.
/// @throws Error when it is not a PNG file, damaged, cut short, or claims more pixels than it can hold
[[nodiscard]] PictureFile read_png(const std::filesystem::path& path);

/// Grey values or colours of 8 or 16 bits, or grey values in single precision; in strips or tiles.
/// @throws Error as above for TIFF, and when it has several pages or is of another kind
[[nodiscard]] PictureFile read_tiff(const std::filesystem::path& path);

}  // namespace hapticut
