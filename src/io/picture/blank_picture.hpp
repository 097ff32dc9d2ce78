// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "hapticut/io/picture/picture.hpp"

namespace hapticut {

/// Writes a PNG picture of the background alone, in the size of the options: of a workpiece of which nothing is left.
/// @throws Error when width or height are out of range, or the file cannot be written completely
void write_blank_picture(const PictureOptions& options, const std::filesystem::path& path);

}  // namespace hapticut
