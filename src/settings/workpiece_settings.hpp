// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hapticut/build/volume_builders.hpp"
#include "hapticut/build/work_estimate.hpp"
#include "hapticut/io/vdb/vdb.hpp"
#include "hapticut/workpiece/workpiece.hpp"
#include "settings/material_settings.hpp"
#include "settings/setting.hpp"

namespace hapticut::settings {

/// Where a workpiece comes from, as the user writes it: `[workpiece]` in a settings file.
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
  std::optional<double> voxel_mm;  ///< default: 0.1 for what is built, the smallest spacing for volumes
  std::optional<Vec3> size_mm;     ///< block, slab
  std::string material;            ///< block, mesh, .vdb of another program
  struct Shell {
    std::string material;  ///< of what the object encloses; "empty" makes a cavity of it
    std::string object;    ///< its name in the file
  };
  std::deque<Shell> shells;   ///< mesh with several objects
  std::deque<Layer> layers;   ///< slab, from the top down
  std::deque<Labels> labels;  ///< volume of labels
  std::optional<UnclaimedLabels> unclaimed_labels;
  std::deque<GreyRange> grey;  ///< volume of grey values
  std::optional<double> grade_low, grade_high;
  std::string grade_at_low, grade_at_high;
  std::optional<Vec3> spacing_mm;       ///< volume: replaces what the file says
  std::vector<double> crop_mm;          ///< x, y, z of the lower corner, then of the upper one
  bool largest_component = false;       ///< volume: leave loose pieces out
  std::string fill_cavities;            ///< labels: material of what they enclose
  std::optional<double> close_gaps_mm;  ///< labels: holes that a ball of this radius does not enter count as enclosed
  bool partial_volume = true;           ///< grey values: what lies at the border is the material behind it
  std::string dicom_series;             ///< which series of a folder
  struct Raw {
    std::vector<double> dims;
    std::string type;
    bool big_endian = false;
    std::size_t skip_bytes = 0;
  } raw;                                              ///< file of samples without a header
  std::optional<double> unit_mm;                      ///< mesh, .vdb of another program: length of one unit of the file
  std::string grid;                                   ///< .vdb of another program
  std::optional<VdbImport::Kind> grid_kind;           ///< the same
  bool large = false;                                 ///< lifts the limits of how much work is begun
  WorkObserver tell = {};                             ///< is told of the work; no setting
  std::function<void(const std::string&)> warn = {};  ///< is told what a user must know of the file; no setting
  MaterialChanges materials;
};

[[nodiscard]] std::vector<Setting> settings_of(WorkpieceSettings& workpiece);

/// What a source may be beside a file.
[[nodiscard]] std::vector<std::string> built_in_workpieces();

/// Whether the source is a file or folder of samples, rather than something built in, a .vdb file or a mesh.
[[nodiscard]] bool is_volume(const WorkpieceSettings& settings);

/// Builds or reads the workpiece.
/// @param cutter  that its presets are to be cut with; materials of a .vdb file stay what they are
/// @throws Error when it cannot be read, something is missing, or something was set that this source does not use
[[nodiscard]] Workpiece make_workpiece(WorkpieceSettings settings, CutterKind cutter = CutterKind::carbide_bur);

}  // namespace hapticut::settings
