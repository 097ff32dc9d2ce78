// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Component `import`, target hapticut::import: meshes and volumes of other programs, and the profile of a head from
/// its mesh. `build/` makes workpieces of them; component `io` has the library's own files.

#include "hapticut/import/mesh/meshes.hpp"
#include "hapticut/import/mesh/profile_from_mesh.hpp"
#include "hapticut/import/volume/volume_filters.hpp"
#include "hapticut/import/volume/volumes.hpp"
