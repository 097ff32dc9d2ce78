// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "hapticut/core/mesh.hpp"
#include "hapticut/surface/extract_surface.hpp"

/// @file
/// Pictures of surfaces without a window or a graphics card.
namespace hapticut {

/// Options of a picture. The camera is orthographic and shows all meshes.
struct PictureOptions {
  int width = 1200;                         ///< [pixels] 16 ... 8192
  int height = 900;                         ///< [pixels] 16 ... 8192
  Vec3 view_direction = {-0.6, 0.9, -0.8};  ///< direction from the camera into the scene; any length > 0
  Vec3 up = {0, 0, 1};                      ///< upwards in the picture; not parallel to view_direction
  Color background = {243, 244, 246};
  bool scale_bar = true;  ///< draws a bar of 1, 2 or 5 times a power of ten millimetres, with its length
};

/// The colour of a material by its name (enamel, dentin, pulp, bone ...); other names get a colour of a fixed palette.
[[nodiscard]] Color material_color(std::string_view name);

/// The surface with the colours of its materials.
/// @throws Error when the table lacks a material of the surface
[[nodiscard]] ColoredMesh colored(const WorkpieceSurface& surface, const MaterialTable& materials);

/// Writes a PNG picture: smooth shading, light from the upper left of the camera, 4x antialiasing. An existing file is
/// replaced only when the new file is complete.
/// @throws Error when an option is out of range, there is no triangle, a vertex is not finite, colours are missing or
///         the file cannot be written completely
void write_picture(const std::vector<ColoredMesh>& meshes, const PictureOptions& options,
                   const std::filesystem::path& path);

}  // namespace hapticut
