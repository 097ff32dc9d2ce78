// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>

#include "hapticut/force/friction.hpp"
#include "hapticut/force/law.hpp"

namespace hapticut {

/// The constants of the materials as a step reads them, and what follows from them for all materials. A slow spindle
/// cuts and rubs with a share of the ratios of a fast one: see `HeadPlacement::cutting_share`.
class StepMaterials {
 public:
  /// @param may_crush  whether the law crushes material
  void set(const ContactMaterials& materials, bool may_crush) noexcept {
    materials_ = materials;
    max_damping_ = 0;
    min_crushing_depth_ = ContactMaterial::kNeverCrushed;
    frictional_ = 0;
    any_chips_ = any_floor_ = false;
    for (std::size_t id = 0; id < materials_.size(); ++id) {
      const ContactMaterial& m = materials_[id];
      fast_ratios_[id] = {m.cutting_ratio, m.sliding_ratio};
      max_damping_ = std::max(max_damping_, m.damping);
      if (may_crush) min_crushing_depth_ = std::min(min_crushing_depth_, m.crushing_depth);
      frictional_ += int(m.static_friction > 0);
      any_floor_ = any_floor_ || m.viscosity > 0 || m.cutting_depth > 0;
      any_chips_ = any_chips_ || m.edge_length > 0 || m.size_length > 0;
    }
    scale_all();
  }

  void set_friction(MaterialId id, const DryFriction& friction) noexcept {
    ContactMaterial& material = materials_[id];
    frictional_ += int(friction.static_friction > 0) - int(material.static_friction > 0);
    material.static_friction = float(friction.static_friction);
    material.dynamic_friction = float(friction.dynamic_friction);
    material.tangential_stiffness = float(friction.tangential_stiffness);
    fast_ratios_[id].sliding = material.dynamic_friction;
    scale(id);
  }

  /// The constants while a share [1] of the ratios acts. O(materials) when the share has changed.
  [[nodiscard]] const ContactMaterials& with(double share) noexcept {
    if (std::exchange(share_, share) != share) scale_all();
    return materials_;
  }

  [[nodiscard]] float max_damping() const noexcept { return max_damping_; }                ///< [s/m]
  [[nodiscard]] float min_crushing_depth() const noexcept { return min_crushing_depth_; }  ///< [m]
  [[nodiscard]] bool any_friction() const noexcept { return frictional_ > 0; }  ///< some material has dry friction
  [[nodiscard]] bool any_chips() const noexcept { return any_chips_; }  ///< some cutting energy depends on the chip
  [[nodiscard]] bool any_floor() const noexcept { return any_floor_; }  ///< some has an edge pressure or a viscosity

  /// Whether some material can be crushed, which only the default law does.
  [[nodiscard]] bool any_crushing() const noexcept { return min_crushing_depth_ < ContactMaterial::kNeverCrushed; }

 private:
  struct Ratios {
    float cutting, sliding;  // [1] friction of a material at a fast spin
  };
  void scale(std::size_t id) noexcept {
    materials_[id].cutting_ratio = float(share_) * fast_ratios_[id].cutting;
    materials_[id].sliding_ratio = float(share_) * fast_ratios_[id].sliding;
  }
  void scale_all() noexcept {
    for (std::size_t id = 1; id < materials_.size(); ++id) scale(id);
  }

  ContactMaterials materials_ = {};
  ByMaterial<Ratios> fast_ratios_ = {};
  double share_ = 1;  // that acts in materials_
  float max_damping_ = 0, min_crushing_depth_ = ContactMaterial::kNeverCrushed;
  int frictional_ = 0;  // number of materials with dry friction
  bool any_chips_ = false, any_floor_ = false;
};

}  // namespace hapticut
