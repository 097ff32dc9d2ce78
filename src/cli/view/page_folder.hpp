// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "hapticut/core/errors.hpp"

namespace hapticut::cli {

/// The built page: beside the program in a build tree and in an installed one.
/// @param given  where not empty: that one
/// @throws Error when there is none
[[nodiscard]] inline std::filesystem::path find_page(const std::filesystem::path& given) {
  if (!given.empty()) return given;
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  for (const char* place : {"../../web/page", "../share/hapticut/web"})
    if (std::filesystem::exists(program / place / "index.html", error))
      return std::filesystem::weakly_canonical(program / place);
  throw Error(
      "the page is not beside this program, for it was built without npm. Install npm, configure and build "
      "again, or name the folder of a built page by --page.");
}

}  // namespace hapticut::cli
