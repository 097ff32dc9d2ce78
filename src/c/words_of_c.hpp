// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace hapticut::c {

/// A sentence of the library in the words of a caller of C: names of hapticut/c/hapticut.h and keys of a scene in place
/// of names of C++ and flags of the program.
[[nodiscard]] std::string in_words_of_c(std::string sentence);

}  // namespace hapticut::c
