// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "settings/workpiece_settings.hpp"

namespace hapticut::settings {

/// Reads a mesh and fills it: one object with `material`, several objects with `shells`.
/// @throws Error when the file cannot be read, or an object has no material
[[nodiscard]] Workpiece make_workpiece_from_mesh(const WorkpieceSettings& settings);

}  // namespace hapticut::settings
