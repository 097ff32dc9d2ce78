// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "hapticut/tool/profile.hpp"

namespace hapticut::settings {

/// Reads the meridian of a head and moves it so that its tip is at z = 0.
///
/// A CSV file has a line of column names, then one point per line, from the tip to the shank. The columns may have any
/// order:
/// - `rho_mm` and `z_mm`: the point.
/// - `radius_mm`: radius of the arc from the previous point (0 or no column: straight, > 0: convex, < 0: hollow).
/// - `kind`: kind of the edge from the previous point, `cutting` (or no column) or `smooth`.
///
/// The first point is the tip; its radius and kind are ignored. Empty lines and lines that begin with # are skipped.
///
/// Any other file is read by read_mesh, if the program was built with the component import. The mesh must be one
/// object, a body of revolution, with its shank towards +z; its unit is the default of read_mesh.
/// @throws Error `file:line: ...`, or what profile_from_mesh throws
[[nodiscard]] Profile read_profile(const std::filesystem::path& path);

/// Reads a meridian from the text of a CSV file.
/// @param name  stands for the file name in messages
[[nodiscard]] Profile profile_of_text(std::string text, std::string name);

}  // namespace hapticut::settings
