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

/// What the user changes of a material: `[material.NAME]` in a settings file, in SI units like Material itself.
struct MaterialChange {
  std::string based_on;                                             ///< a preset; empty: the preset of the same name
  std::array<std::optional<double>, kNumbersOf<Material>> numbers;  ///< in their order
};

/// The materials of a run: the presets, changed by the user, and the user's own.
class MaterialChanges {
 public:
  CutterKind cutter = CutterKind::carbide_bur;  ///< that presets are to be cut with

  /// The one setting that reads all tables of `[material]`.
  [[nodiscard]] Setting setting();

  /// A preset or a material of the user's, with its changes.
  /// @throws Error when there is no such material, or its numbers are not allowed
  [[nodiscard]] Material find(const std::string& name) const;

  /// The material with the changes that were made to its name, if any.
  [[nodiscard]] Material changed(Material material) const;

  /// @throws Error naming a table whose material is no preset, is made of none and is not one of the workpiece's
  void require_known(const MaterialTable& of_workpiece) const;

  [[nodiscard]] bool empty() const { return changes_.empty(); }

 private:
  std::map<std::string, MaterialChange> changes_;
};

}  // namespace hapticut::settings
