// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace hapticut::cli {

/// Replaces C++ names in a message of the library by flags of the program (`VolumeReadOptions::spacing` ->
/// `--spacing_mm`). The table of this function needs every name of the library that a flag sets.
[[nodiscard]] std::string in_words_of_flags(std::string message);

}  // namespace hapticut::cli
