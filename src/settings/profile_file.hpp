// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "hapticut/tool/profile.hpp"

namespace hapticut::settings {

/// Reads the meridian of a head and moves it so that its tip is at z = 0.
///
/// A CSV file: a line of column names, then one point a line, from the tip to the shank's side. Columns, in any order:
/// `rho_mm` and `z_mm`; `radius_mm`, of the arc from the point before (0 or no column: straight, > 0: bulges outwards,
/// < 0: hollow); `kind` of the edge from the point before, `cutting` (or no column) or `smooth`. The first point is the
/// tip, its radius and kind mean nothing. Empty lines and lines that begin with # are skipped.
///
/// Any other file is a mesh of a format that read_mesh reads, where the program was built with the component io: one
/// object that is a body of revolution, in the unit that its format has there, with its shank towards +z.
/// @throws Error `file:line: ...`, or as profile_from_mesh
[[nodiscard]] Profile read_profile(const std::filesystem::path& path);

/// The same of the text of a CSV file.
/// @param name  in messages, where that of a file would be
[[nodiscard]] Profile profile_of_text(std::string text, std::string name);

}  // namespace hapticut::settings
