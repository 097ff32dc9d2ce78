// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hapticut/core/errors.hpp"

namespace hapticut::c {

/// The message of an error for callers of C: names of hapticut/c/hapticut.h and keys of a scene stand for the names of
/// C++.
[[nodiscard]] std::string in_words_of_c(const Error& error);

}  // namespace hapticut::c
