// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace hapticut {

/// The file of the filled fractions that `write_nrrd` writes next to the material ids: "a.nrrd" -> "a_density.nrrd".
[[nodiscard]] inline std::filesystem::path density_file(std::filesystem::path path) {
  const std::string name = path.stem().string() + "_density" + path.extension().string();
  return path.replace_filename(name);
}

}  // namespace hapticut
