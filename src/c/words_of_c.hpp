// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace hapticut::c {

/// Translates a sentence of the library for callers of C: C++ names become names of hapticut/c/hapticut.h, and flags of
/// the program become keys of a scene.
[[nodiscard]] std::string in_words_of_c(std::string sentence);

}  // namespace hapticut::c
