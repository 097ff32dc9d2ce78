// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "hapticut/tool/cutter.hpp"
#include "hapticut/workpiece/material.hpp"
#include "settings/setting.hpp"

namespace hapticut::settings {

/// Changes to one material: `[material.NAME]` in a settings file, in SI units like Material.
struct MaterialChange {
  std::string based_on;              ///< name of a preset; empty: the preset of the same name
  std::optional<CutterKind> cutter;  ///< that the constants are for; empty: the tool's, or that of the .vdb file
  std::array<std::optional<double>, kNumbersOf<Material>> numbers;  ///< ordered like Material's fields
};

/// The materials of a run: presets with the user's changes, and custom materials.
class MaterialChanges {
 public:
  CutterKind cutter = CutterKind::carbide_bur;  ///< cutter that selects the constants of the presets
  std::optional<Sharpness> sharpness;           ///< of this cutter, if it was given

  /// The setting that reads all tables of `[material]`.
  [[nodiscard]] Setting setting();

  /// A preset or a custom material, with the user's changes.
  /// @throws Error when there is no such material, or a number is out of range
  [[nodiscard]] Material find(const std::string& name) const;

  /// The preset that a material is based on; its own name if it is based on none.
  [[nodiscard]] const std::string& base_of(const std::string& name) const;

  /// The material with the changes set for its name.
  [[nodiscard]] Material changed(Material material) const;

  /// @throws Error that names a table whose material is not a preset, not based on a preset and not part of the
  ///         workpiece
  void require_known(const MaterialTable& of_workpiece) const;

  [[nodiscard]] bool empty() const { return changes_.empty(); }

 private:
  std::map<std::string, MaterialChange> changes_;
};

}  // namespace hapticut::settings
