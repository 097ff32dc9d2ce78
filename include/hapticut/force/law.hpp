// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>

#include "hapticut/contact/contact.hpp"
#include "hapticut/contact/cut_voxel.hpp"
#include "hapticut/core/description.hpp"
#include "hapticut/core/spatial.hpp"
#include "hapticut/force/whole_contact.hpp"

/// `ForceLaw::evaluate`: input and output of a force law. Each law has a file in `force/laws/`.
namespace hapticut {

class Grain;  // grain.hpp

/// Whether the spinning head removes material, and by which energy balance.
enum class RemovalLaw {
  none,             ///< nothing is cut: probing, or pure force rendering
  constant_energy,  ///< law A (default): every removed volume costs its specific cutting energy
  elastic_release   ///< law G: the elastic energy of removed material pays a part of this energy
};

constexpr auto names_of(Of<RemovalLaw>) {
  using enum RemovalLaw;
  return std::array{
      Named{none, "none"},
      Named{constant_energy, "constant_energy"},
      Named{elastic_release, "elastic_release"},
  };
}

/// Constants of one material as the hot loop needs them.
struct ContactMaterial {
  float stiffness;                         ///< [N/m^4] k_v
  float damping;                           ///< [s/m] chi
  float cutting_ratio;                     ///< [1] kappa
  float cutting_energy;                    ///< [J/m^3] u
  float cutting_depth;                     ///< [m] w0 = sqrt(2 p_e / k_v); shallower material is not cut
  float edge_length = 0, size_length = 0;  ///< [m] h_e and h_s of chips (force/chip.hpp)
  float viscosity = 0;                     ///< [Pa s/m] eta
  float crushing_depth = kNeverCrushed;    ///< [m] sqrt(2 sigma / k_v); deeper material is crushed
  float static_friction = 0;               ///< [1] mu_s
  float dynamic_friction = 0;              ///< [1] mu_d
  float tangential_stiffness = 0;          ///< [N/m] k_t
  float sliding_ratio = 0;                 ///< [1] kappa of smooth surfaces: mu_d
  float land = 0;                          ///< [m] distance from a cutting edge within which smooth surfaces cut
  float grain = 0;                         ///< [1] variation of the cutting energy from place to place
  float grain_length = 0;                  ///< [m] edge of the cells of the grain
  static constexpr float kNeverCrushed = 1e3F;

  /// [m^2] MeridianSpring::smooth up to which a surface cuts: that of the land, at least two voxels.
  [[nodiscard]] float square_of_land(float voxel_size) const {
    const float distance = std::max(land, 2 * voxel_size);
    return distance * distance;
  }
};
using ContactMaterials = ByMaterial<ContactMaterial>;  ///< kEmpty has no stiffness and a cutting energy of 1 J/m^3

/// How the head moves during one sub-step, in T where the contact is evaluated.
struct HeadMotion {
  Eigen::Vector3f velocity;               ///< [m/s] velocity of To along the path, V
  Eigen::Vector3f angular_velocity;       ///< [rad/s] angular velocity of the handpiece along the path, Omega
  Eigen::Vector3f felt_velocity;          ///< [m/s] velocity of To as the device measures it; drives damping only
  Eigen::Vector3f felt_angular_velocity;  ///< [rad/s]
  float spin;                             ///< [rad/s] omega about +z; 0: the spindle stands
  float duration;                         ///< [s]
  float voxel_size;                       ///< [m] l
  RemovalLaw removal;
  float head_radius = 0;  ///< [m] maximum cutting radius of the head
  float lead = 0;         ///< [1] time of the evaluation after the middle, in sub-steps; 0.5: at its end
  /// n: one n-th of the samples is evaluated in a sub-step, in turn, with the slip of n sub-steps.
  float level_of_detail = 1;
  const WholeContact* whole = nullptr;  ///< only for laws that need moments
  float tooth_rate = 0;  ///< [1/s] f_z, passing rate of the lips; 0 when no material's energy depends on chips
  float elapsed = 0;     ///< [s] since the step began, where the contact is evaluated; 0: as `duration`
  /// [m/s] Velocity less its mean over the last 20 ms; it does not affect the energy of chips.
  Eigen::Vector3f ripple = Eigen::Vector3f::Zero();
  float fastest_chips = 0;  ///< [m/s] speed into a surface up to which lips take their chips without crowding; 0: any
  bool floors = false;      ///< some material has an edge pressure or a viscosity
  bool crushes = false;     ///< material deeper than its crushing_depth is removed, whether the head turns or not
  const Grain* grain = nullptr;  ///< the grain of the materials; null: they have none
  /// [1] Of VoxelSection: kMinStandingWidth while the spindle is off.
  float min_width = VoxelSection<float>::kMinWidth;

  /// [rad/s] Angular velocity of the head's surface about +z: spin plus rotation of the handpiece.
  [[nodiscard]] float turning() const noexcept { return spin + angular_velocity.z(); }

  /// Whether a spinning head removes material.
  [[nodiscard]] bool cuts() const noexcept { return spin != 0 && removal != RemovalLaw::none; }
  /// Whether the constants of a cut depend on the motion (`formulas::CutResistance`).
  [[nodiscard]] bool resists() const noexcept { return floors || fastest_chips > 0; }
  /// [s] Time in which a small motion to the pose of the evaluation changes the velocity.
  [[nodiscard]] float time_to_move() const noexcept { return elapsed > 0 ? elapsed : duration; }
  /// Whether the contact is evaluated at the end of the sub-step.
  [[nodiscard]] bool at_end() const noexcept { return lead > 0; }
};

/// Contribution of one block to the energy ledger in one sub-step; [J], as defined in EnergyLedger.
struct LawEnergies {
  double elastic_before = 0;  ///< stored in the samples at the beginning of the sub-step
  double elastic = 0;         ///< stored in the samples at the end of the sub-step
  double cutting = 0, released = 0, damping = 0, rubbing = 0, credited = 0, crushed = 0;

  LawEnergies& operator+=(const LawEnergies& other) {
    elastic_before += other.elastic_before;
    elastic += other.elastic;
    cutting += other.cutting;
    released += other.released;
    damping += other.damping;
    rubbing += other.rubbing;
    credited += other.credited;
    crushed += other.crushed;
    return *this;
  }

  /// Sum of all terms; finite only when each of them is.
  [[nodiscard]] double sum() const {
    return elastic_before + elastic + cutting + released + damping + rubbing + credited + crushed;
  }
};

/// Result of a law for a block, beside the arrays it writes.
struct LawTotals {
  LawEnergies energies;
  double spin_couple = 0;  ///< [N·m] about +z on the tool, in addition to the torque of the samples' forces
  bool may_remove = true;  ///< false: no `fill_after` differs from `fill`, so nothing is removed
  double helped = 0;       ///< [J] paid for cutting by energy lost with the material (law G), in no other term
};

/// A filled fraction below this is removed at once, and its energy is credited.
inline constexpr float kMinFill = 1e-3F;

/// A force law: computes, from the samples of one block, the force on the tool at each and the remaining fill of each.
///
/// The step calls `evaluate` once per block and sums what it writes. A custom law derives from this class and is passed
/// to the simulation in its configuration. A law that knows only the whole contact returns true from `needs_moments`
/// and gives its force in `lump`; force/laws/lumped.hpp then distributes the cut.
class ForceLaw {
 public:
  virtual ~ForceLaw() = default;

  /// Called once, at set-up.
  /// @throws Error when the law has no formula for this head; the message names those that it has
  virtual void require_head(const ToolHead&) const {}

  /// Whether the law needs a first pass over all blocks, which computes the whole contact for `lump` and
  /// `HeadMotion::whole`.
  [[nodiscard]] virtual bool needs_moments() const noexcept { return false; }

  /// Force, torque and energies of the whole contact, added once per sub-step to those of the blocks. Called only when
  /// the law needs moments and the head touches something.
  /// @realtime no allocation, no lock, no exception
  [[nodiscard]] virtual LumpedForce lump(const ToolHead&, const HeadMotion&, const ContactMoments&) const noexcept {
    return {};
  }

  /// Whether DeepContact tethers a ball that is pushed beyond its radius. True only for a law whose own force of a ball
  /// falls with depth beyond the radius, as that of springs that push from the centre, and that claims to be right
  /// there.
  [[nodiscard]] virtual bool tethers_deep_ball() const noexcept { return false; }

  /// Whether this is FoundationLaw. The library computes it with vector instructions, with its stiffness, level of
  /// detail and crushing.
  [[nodiscard]] virtual bool is_foundation() const noexcept { return false; }

  /// Whether `evaluate` accepts blocks with `sub_voxel`, whose entries are parts of voxels instead of points. They have
  /// the depth of the voxel's centre and that of the part's `top`, both as distances (ContactBlock::scale_of converts
  /// them to w), and `max_component` for VoxelSection, which integrates over the part. If false,
  /// SimulationConfig::quadrature must be one of points.
  [[nodiscard]] virtual bool integrates_parts() const noexcept { return false; }

  /// Writes `force_x/y/z` and `fill_after` of all `lanes()` entries. An entry without fill must get no force and stay
  /// empty. If the sum of forces or energies is not finite, the force is dropped and StepStatus::force_not_finite is
  /// set.
  /// @realtime no allocation, no lock, no exception
  virtual LawTotals evaluate(const HeadMotion& motion, const ContactMaterials& materials,
                             ContactBlock& block) const noexcept = 0;
};

}  // namespace hapticut
