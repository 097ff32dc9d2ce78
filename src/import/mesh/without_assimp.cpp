// SPDX-License-Identifier: Apache-2.0
#include "hapticut/core/errors.hpp"
#include "import/mesh/mesh_extensions.hpp"
#include "import/mesh/mesh_formats.hpp"

namespace hapticut {

Polygons read_with_assimp(const std::filesystem::path& path) {
  throw Error("reading " + extension_in_lower_case(path) +
              " files needs Assimp, which this build of hapticut lacks; install libassimp-dev and build it with "
              "HAPTICUT_WITH_ASSIMP=ON.");
}

}  // namespace hapticut
