// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace hapticut::cli {

/// A message of the library in the words of the program: flags in place of members of C++ (`--spacing_mm`, not
/// `VolumeReadOptions::spacing`). What the library names and a flag sets belongs into the table of this function.
[[nodiscard]] std::string in_words_of_flags(std::string message);

}  // namespace hapticut::cli
