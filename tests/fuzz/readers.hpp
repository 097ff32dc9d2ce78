// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "hapticut/core/errors.hpp"
#include "hapticut/import/mesh/meshes.hpp"
#include "hapticut/import/volume/volumes.hpp"
#include "hapticut/io/recording/recording.hpp"
#include "hapticut/io/vdb/vdb.hpp"
#include "import/mesh/mesh_extensions.hpp"
#include "settings/pose_file.hpp"
#include "settings/profile_file.hpp"
#include "settings/scene_settings.hpp"
#include "settings/settings_file.hpp"

/// @file
/// Reads a file by the format of its seed folder, and a mesh by its extension.
namespace hapticut::test {

/// @throws Error when the file is refused; any other exception is a finding
inline void read_as(const std::string& format, const std::filesystem::path& path) {
  // A slice belongs to a series of two.
  const bool series = std::filesystem::exists(path.parent_path() / "companion2.dcm");
  if (is_mesh_file(path))
    (void)read_mesh(path);
  else if (format == "dicom" && series)
    (void)read_grey_volume(path.parent_path());
  else if (format == "slices")
    (void)read_grey_volume(path.parent_path(), {.spacing = Vec3::Constant(1e-3)});
  else if (format == "vdb")
    (void)load_vdb(path);
  else if (format == "recording") {
    const Recording recording = read_recording(path);
    (void)recording.read(0, 100);
    (void)recording.workpiece();
  } else if (format == "settings") {
    settings::SceneSettings scene;
    settings::read_settings_file(path, settings_of(scene), {"output", "loop"});
  } else if (format == "poses")
    (void)settings::read_poses(path, Mat3::Identity());
  else if (format == "profile")
    (void)settings::read_profile(path);
  else
    (void)read_grey_volume(path);
}

}  // namespace hapticut::test
