// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "hapticut/core/errors.hpp"

namespace hapticut::apps {

/// Folder of the built page, relative to the program in a build tree or an installation.
/// @param given  if not empty, this folder
/// @throws Error when there is no page, with the command that builds it
[[nodiscard]] inline std::filesystem::path find_page(const std::filesystem::path& given) {
  if (!given.empty()) return given;
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  for (const char* place : {"../../web/page", "../share/hapticut/web"})
    if (std::filesystem::exists(program / place / "index.html", error))
      return std::filesystem::weakly_canonical(program / place);
  const std::filesystem::path build = std::filesystem::weakly_canonical(program / "../..");
  if (std::filesystem::exists(build / "CMakeCache.txt", error))
    throw Error("the page is not built: run `cmake --build " + build.string() +
                " -t hapticut_page`, which needs npm (sudo apt-get install nodejs npm).");
  throw Error(
      "the page is not installed: build the target hapticut_page, which needs npm, in the build folder of hapticut, "
      "and install again; or set --page to the folder of a built page.");
}

}  // namespace hapticut::apps
