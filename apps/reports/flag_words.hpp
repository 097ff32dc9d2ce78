// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <string>

#include "hapticut/core/sentence.hpp"

namespace hapticut::apps {

/// A sentence in which the flags of the program stand for the names of C++ and for the keys of settings: `--spacing_mm`
/// for `VolumeReadOptions::spacing`, `--rate` for `simulation.rate_Hz`. A setting has the name of its flag also if a
/// file sets it; the file's key differs from it by its table, and some by their unit.
[[nodiscard]] std::string in_words_of_flags(const Sentence& sentence);

/// The message of an exception. An Error of the library has the words of the flags.
[[nodiscard]] std::string in_words_of_flags(const std::exception& error);

}  // namespace hapticut::apps
