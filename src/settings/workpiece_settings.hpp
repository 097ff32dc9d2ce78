// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "hapticut/build/volume_builders.hpp"
#include "hapticut/build/work_estimate.hpp"
#include "hapticut/io/vdb/vdb.hpp"
#include "hapticut/workpiece/workpiece.hpp"
#include "settings/material_settings.hpp"
#include "settings/setting.hpp"

namespace hapticut::settings {

/// `[workpiece]` of a settings file: the source of the workpiece.
struct WorkpieceSettings {
  struct Layer {
    std::string material;
    std::optional<double> thickness_mm;
  };
  struct Labels {
    std::string material;
    std::vector<double> values;
  };
  struct GreyRange {
    std::string material;
    std::optional<double> from, to;
  };

  std::string source;              ///< block, slab, molar, or a file or folder
  std::optional<double> voxel_mm;  ///< default: 0.1; for volumes their smallest spacing
  std::optional<Vec3> size_mm;     ///< block, slab
  std::string material;            ///< block, mesh, .vdb of another program
  struct Shell {
    std::string material;  ///< material inside the object; "empty" makes it a cavity
    std::string object;    ///< name of the object in the file
  };
  std::deque<Shell> shells;   ///< mesh with several objects
  std::deque<Layer> layers;   ///< slab, from the top down
  std::deque<Labels> labels;  ///< volume of labels
  std::optional<UnclaimedLabels> unclaimed_labels;
  std::deque<GreyRange> grey;  ///< volume of grey values
  std::optional<double> grade_low, grade_high;
  std::string grade_at_low, grade_at_high;
  std::optional<Vec3> spacing_mm;       ///< volume: replaces the spacing of the file
  std::vector<double> crop_mm;          ///< x, y, z of the lower corner, then of the upper one
  bool largest_component = false;       ///< volume: keep only the largest connected piece
  std::string fill_cavities;            ///< labels: material that fills enclosed cavities
  std::optional<double> close_gaps_mm;  ///< labels: also fill holes that a ball of this radius cannot enter
  std::optional<bool> partial_volume;  ///< default: true; grey values: border voxels get the material behind the border
  std::string dicom_series;            ///< Series Instance UID, for a folder
  struct Raw {
    std::vector<double> dims;
    std::string type;
    bool big_endian = false;
    std::size_t skip_bytes = 0;
  } raw;                                              ///< file of samples without a header
  std::optional<double> unit_mm;                      ///< mesh, .vdb of another program: length of one unit of the file
  std::string grid;                                   ///< .vdb of another program
  std::optional<VdbImport::Kind> grid_kind;           ///< .vdb of another program
  bool large = false;                                 ///< lifts the limits on memory and time
  WorkObserver tell = {};                             ///< receives the progress; not a setting
  std::function<void(const std::string&)> warn = {};  ///< receives remarks about the file; not a setting
  MaterialChanges materials;
};

[[nodiscard]] std::vector<Setting> settings_of(WorkpieceSettings& workpiece);

/// Sources that are not files.
[[nodiscard]] std::vector<std::string> built_in_workpieces();

/// Whether the source is a file or folder of samples, i.e. not built in, not a .vdb file and not a mesh.
[[nodiscard]] bool is_volume(const WorkpieceSettings& settings);

/// Refuses all settings but those of a list.
/// @param used     names of settings, without "workpiece."
/// @param because  completes "must be left out, because": "a.stl does not use it"
/// @throws Error that names the first other setting that is set
void refuse_all_but(const WorkpieceSettings& settings, const std::set<std::string>& used, const std::string& because);

/// Builds or reads the workpiece.
/// @param cutter     cutter that selects the constants of presets; materials of a .vdb file keep their constants
/// @param sharpness  of this cutter, if it was given: `tool.sharpness`
/// @throws Error when a file cannot be read, a setting is missing, or a setting does not apply to this source
[[nodiscard]] Workpiece make_workpiece(WorkpieceSettings settings, CutterKind cutter = CutterKind::carbide_bur,
                                       std::optional<Sharpness> sharpness = {});

}  // namespace hapticut::settings
