// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "hapticut/contact/cut_voxel.hpp"
#include "hapticut/force/chip.hpp"
#include "hapticut/force/contact_stiffness.hpp"
#include "hapticut/force/grain.hpp"
#include "hapticut/force/law.hpp"

namespace hapticut {

namespace formulas {
#include "hapticut/formulas/surface.inl"
//
#include "hapticut/formulas/part.inl"
//
#include "hapticut/formulas/stiffness.inl"
}  // namespace formulas

/// The default law: a volumetric elastic foundation that the spinning head cuts by the power it delivers.
///
/// In plain words: the material is a mattress of small springs, one for each bit of volume. A head that presses in
/// feels the springs that it pushes aside. Where its surface slides over them it drags on them, and the power of this
/// drag pays for the removed material: each volume costs the energy u. So a standing head sinks in a little and stops,
/// and a spinning head sinks in as fast as its power pays for. k_v sets only how thick the pressed layer is: softer
/// springs give a thicker layer and, while it is thin against the head, the same cutting force.
///
/// Material at depth w pushes back along the normal n with the pressure gradient k_v w. Hunt-Crossley damping
/// multiplies it by g_d(chi w_dot), with g_d(e) = 1 + e while the contact closes and 1/(1 - e) while it opens. Where
/// the head turns, the material also drags along the slip v_t, tangential to the cutting surface:
///
///     force = -f n - kappa f v_t / sqrt(|v_t|^2 + v_eps^2)
///
/// Each voxel is integrated over its filled part (VoxelSection). t is the depth of its top; <w> is the mean of
/// max(w, 0) over that part, and <w>_0 that of w where w > w0, and else 0. Material shallower than w0 is not cut:
///
///     f = k_v g_d phi l^3 (<w> - <w>_0 + r <w>_0 (1 - e^-x)/x)      phi <- phi e^-x      x = 2 k_d r <w>_0 dt
///
/// where k_d = kappa k_v g_d s/(2 u), and r is the recession of the layer within the sub-step over the recession at the
/// speed at the evaluation (LayerRecession). Where nothing is cut, f = k_v g_d phi l^3 <w>. Cutting removes the deepest
/// material, so material that only rubs stays. What is cut presses with the mean of phi over the sub-step, phi (1 -
/// e^-x)/x, so the tangential work of the cut is exactly u l^3 times the lost fill, for any step. Law G replaces u by
/// max(u - k_v w^2/2, 1e-6 u). w_dot = (V + Omega x r) . n is the speed along the path; only in g_d it is that of the
/// velocity that the device measures.
///
/// u is what a cut costs: of a viscous material u + kappa s eta, and more where chips crowd the flutes of a drill
/// (`formulas::CutResistance`). Grain makes it differ from place to place (`Grain`).
///
/// Before that, material that would be pressed harder than it can bear is removed, below the crushing depth w_c =
/// sqrt(2 sigma/(k_v max(1, g_d))), at which a column's pressure k_v g_d w^2/2 is sigma. A head that turns cuts while
/// it sinks in: what the pressure sigma cuts within half of a sub-step, v(w_c) dt/2 and at most what the head moves in
/// it, is left for the cut. Otherwise a head whose sub-step is not much shorter than w_c, as in a soft material, would
/// crush what it cuts in shorter steps. Crushing takes sigma times the volume.
///
/// At a smooth surface w changes by s = kSmoothScale per distance (MeridianSpring). There w is the distance, k_v is
/// multiplied by s^2, chi by s, and every depth by 1/s. kappa is mu_d, and nothing is cut except within the material's
/// land of a cutting edge (`SurfaceMaterial::at`).
///
/// From the thesis's spring model (Uener 2007, eqs. 5.5-5.8, 5.15-5.16), with its dependence on voxel size and step
/// removed; see docs/decisions/0003-removal-and-ledger.md and 0009-cut-voxels.md.
class FoundationLaw final : public ForceLaw {
 public:
  /// The formulas of hapticut/formulas, in the order of docs/model.md, voxel by voxel. A simulation runs the same
  /// formulas for vectors of voxels instead (src/kernels/stages-inl.hpp), and shorter ones for whole voxels in a head
  /// that stands and removes nothing (whole-inl.hpp). The block must be sampled with Quadrature::sub_voxel.
  LawTotals evaluate(const HeadMotion& m, const ContactMaterials& materials, ContactBlock& b) const noexcept override {
    return evaluate(m, materials, b, nullptr);
  }
  /// Also adds the block's stiffness about To, in T.
  /// @param stiffness_T  null: not needed
  LawTotals evaluate(const HeadMotion& m, const ContactMaterials& materials, ContactBlock& b,
                     Stiffness* stiffness_T) const noexcept {
    using Chord = ChipChord<float>;
    HAPTICUT_ASSERT(b.sub_voxel);
    const float l = m.voxel_size, volume = l * l * l, time = m.duration * m.level_of_detail;
    const formulas::ChippingLips<float> chipping(m);
    const formulas::AxisSlip<float> axis(m);
    Sums sums = {};
    for (int n = 0; n < b.lanes(); ++n) {
      b.force_x[n] = b.force_y[n] = b.force_z[n] = 0;
      b.fill_after[n] = b.fill[n];
      if (!(b.fill[n] > 0)) continue;
      // Motion and material at the head's surface.
      const Triple r = {b.x[n], b.y[n], b.z[n]}, normal = {b.normal_x[n], b.normal_y[n], b.normal_z[n]};
      const auto surface = formulas::SurfaceMotion<float>::of(m, axis, r, normal);
      Material material = material_at(m, materials, b, n);
      const auto damping = Damping::of(m, material.damping, r, normal);
      if (m.grain != nullptr) material = material.with_energy(material.energy * grain_at(*m.grain, b, n));
      if (m.resists()) material = formulas::CutResistance<float>::of(m, surface, damping.factor, material);
      const float kappa = m.spin != 0 ? material.cutting_ratio : 0.0F;
      const float work = surface.work(kappa, material.stiffness, damping.factor, time);
      const auto advance = formulas::HeadAdvance<float>::of(m, surface.rate);
      const float mean_rate = advance.mean_rate(m, normal), lips = chipping.at(mean_rate);
      // 1. The filled part.
      const auto part = Part::of(VoxelSection<float>(b.max_component[n], b.min_width), b.depth[n] / l, b.fill[n]);
      // 2. Crushing.
      Part kept = part;
      float approach = advance.approach, yielding = 0;
      if (m.crushes) {
        const float limit = damping.crushing_depth(material.crushing_depth);
        const float recedes = m.cuts() ? Chord::recession_at(limit, material, lips, work) : 0.0F;
        const auto crushing = formulas::PartCrushing<float>::of(part, approach, limit, recedes);
        kept = {part.section, part.far, crushing.top, crushing.height, crushing.fill};
        approach = crushing.approach, yielding = crushing.yielding;
      }
      // 3. Chips: energy and threshold of the cut.
      float energy = material.energy;
      auto cut = CutDepth<float>::of(kept.top, material.threshold);
      if (m.cuts() && m.tooth_rate > 0) {
        const auto chord = Chord::of(material, lips, work, kept.top, part.far, chipping.advance(mean_rate));
        energy = chord.energy, cut = chord.cut;
      }
      // 4. Springs of the part.
      const auto springs = formulas::PartSprings<float>::of(kept);
      // 5. Recession of the layer, and 6. decay of the fill.
      formulas::PartRecession<float> layer = {0, 0, 0, energy};
      formulas::PartDecay<float> decay = {0, kept.fill, 0};
      if (m.cuts()) {
        layer = formulas::PartRecession<float>::of(kept, cut, energy, work, approach, material.stored(l),
                                                   m.removal == RemovalLaw::elastic_release, m.at_end());
        decay = formulas::PartDecay<float>::of(kept.fill, layer);
      }
      const auto cost = formulas::PartCost<float>::of(kept.fill, decay, energy, layer.price);
      const float rubbing = layer.rubbing(springs.depth), spring = rubbing + decay.cut;
      // 7. Energies before and after.
      const auto energies = formulas::PartEnergies<float>::of(part, kept, decay.left, spring, springs.volume,
                                                              advance.moved, m.lead, material.crushing_depth);

      b.fill_after[n] = decay.left;
      const bool is_crushed = kept.top < part.top;
      if (is_crushed) b.top[n] = kept.top * l, b.immersed[n] = springs.volume;
      const auto force = formulas::PartForce<float>::of(material.stiffness, spring, damping.factor);
      const auto reaction = formulas::VoxelReaction<float>::of(surface, normal, force.push, kappa);
      b.force_x[n] = -volume * reaction.force.x;
      b.force_y[n] = -volume * reaction.force.y;
      b.force_z[n] = -volume * reaction.force.z;
      // What cutting costs beyond its price is paid by the energy that is lost with the removed material.
      const float stored = material.stored(l);
      sums.add(kElasticBefore, n, stored * energies.before);
      sums.add(kElastic, n, stored * energies.after);
      sums.add(kCutting, n, cost.cutting);
      sums.add(is_crushed ? kCrushed : kReleased, n, stored * energies.lost - cost.helped);
      sums.add(kHelped, n, cost.helped);
      sums.add(kDamping, n, force.damped(advance.moved, l));
      sums.add(kRubbing, n, force.rubbed(work, rubbing) + cost.rounded_off);
      sums.add(kCredited, n, cost.credited);
      sums.add(kCouple, n, reaction.couple(surface));

      if (stiffness_T == nullptr || !(force.push > 0)) continue;
      const float slope = PartStiffness::slope_of(m, material, damping, springs, spring, yielding, kept.top);
      const auto stiffness = PartStiffness::of(m, surface, normal, slope, force.push, kappa);
      for (const auto& dyad : {stiffness.spring, stiffness.turned, stiffness.slowed})
        add_dyad(dyad, r, double(volume), *stiffness_T);
    }
    return sums.totals(volume, m.spin != 0 ? m.turning() : 0.0F, m.cuts() || m.crushes);
  }

  [[nodiscard]] bool is_foundation() const noexcept override { return true; }
  [[nodiscard]] bool tethers_deep_ball() const noexcept override { return true; }
  [[nodiscard]] bool integrates_parts() const noexcept override { return true; }

  using Damping = formulas::Damping<float>;
  static constexpr float kSlipRegularization = formulas::SurfaceMotion<float>::kRegular;  ///< [m/s] v_eps

  /// The constants at a sample, whose depth is a distance: they differ between smooth and cutting surfaces.
  static formulas::SurfaceMaterial<float> material_at(const HeadMotion& m, const ContactMaterials& materials,
                                                      const ContactBlock& b, int n) {
    const ContactMaterial& material = materials[b.material_of(n)];
    return formulas::SurfaceMaterial<float>::of(material, m.voxel_size)
        .at(b.smooth[n], material.sliding_ratio, material.square_of_land(m.voxel_size));
  }

 private:
  [[nodiscard]] static float grain_at(const Grain& grain, const ContactBlock& b, int n) {
    return grain.at(b.material_of(n), b.voxel_of(n));
  }

  using Triple = formulas::Triple<float>;
  using Material = formulas::SurfaceMaterial<float>;
  using Part = formulas::FilledPart<float>;
  using PartStiffness = formulas::PartStiffness<float>;

  static void add_dyad(const formulas::StiffnessDyad<float>& dyad, const Triple& r, double volume, Stiffness& sum) {
    const auto with_moment = [&](const Triple& v) {
      const Triple moment = cross(r, v);
      return Eigen::Matrix<double, 6, 1>{double(v.x),      double(v.y),      double(v.z),
                                         double(moment.x), double(moment.y), double(moment.z)};
    };
    sum += volume * double(dyad.strength) * with_moment(dyad.force) * with_moment(dyad.motion).transpose();
  }

  enum Term {
    kElasticBefore,
    kElastic,
    kCutting,
    kReleased,
    kDamping,
    kRubbing,
    kCredited,
    kCrushed,
    kHelped,
    kCouple,
    kTerms
  };
  /// Partial sums per lane, in units of [N m] = l^3 times an energy density; fixed order, so the same bits every time.
  struct Sums {
    float of[kTerms][kLanes];

    void add(Term term, int n, float value) { of[term][n % kLanes] += value; }

    /// @param turning  [rad/s] of the head's surface, against which the couple does work; 0: the spindle stands
    [[nodiscard]] LawTotals totals(float voxel_volume, float turning, bool may_remove) const {
      const auto total = [&](Term term) {
        double sum = 0;
        for (const float lane : of[term]) sum += double(lane);
        return sum * double(voxel_volume);
      };
      const double couple = turning != 0 ? -total(kCouple) / double(turning) : 0.0;
      return {{total(kElasticBefore), total(kElastic), total(kCutting), total(kReleased), total(kDamping),
               total(kRubbing), total(kCredited), total(kCrushed)},
              couple,
              may_remove,
              total(kHelped)};
    }
  };
};

}  // namespace hapticut
