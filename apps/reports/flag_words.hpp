// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <string>

namespace hapticut::apps {

/// The message of an exception. In an Error of the library, the flags of the program stand for the names of C++:
/// `--spacing_mm` for `VolumeReadOptions::spacing`.
[[nodiscard]] std::string in_words_of_flags(const std::exception& error);

}  // namespace hapticut::apps
