// SPDX-License-Identifier: Apache-2.0
// Text of hapticut/force/laws/foundation.hpp and of the kernels: the default law on the filled part of one voxel, step
// by step. Step 1, the part, is in section.inl, step 3, chips, in chip.inl. Lengths are in voxel edges, times in the
// time since the part was evaluated before: the sub-step, or several with a level of detail.

constexpr float kMinPart = 1e-6F;         ///< [1] fill below which a cut voxel is empty
constexpr float kMaxExponent = 1e18F;     ///< keeps the arithmetic finite
constexpr float kMinEnergyShare = 1e-6F;  ///< [1] fraction of u that law G always pays
constexpr float kMinLoss = 1e-5F;         ///< [1] relative loss below which the energy of removed material is neglected

/// 2. Crushing: material deeper than it can bear is removed before the force is computed.
template <class Real>
struct PartCrushing {
  Real top, height, fill;  ///< [1] what is left
  Real approach;           ///< [1] >= 0, speed of the top that is left
  Real yielding;           ///< [1] part of the volume that is at the limit, where a force does not grow with depth

  /// @param approach  [1] >= 0, speed of the head into the material
  /// @param limit     [1] Damping::crushing_depth
  /// @param recedes   [1] v(w_c): recession at the pressure of the limit, which is cut; 0 where nothing is cut
  HAPTICUT_FORMULA static PartCrushing of(const FilledPart<Real>& part, Real approach, Real limit, Real recedes) {
    const Real cut = min(approach, recedes), deepest = limit + Real(0.5) * cut;
    const auto crushed = part.top > deepest;
    const Real height = max(Real(0), deepest - part.far);
    const Real below = min(part.fill, part.section.fill_below(height));  // rounding
    return {select(crushed, deepest, part.top), select(crushed, height, part.height),
            select(crushed, select(below >= Real(kMinPart), below, Real(0)), part.fill), select(crushed, cut, approach),
            select(crushed, deepest * part.section.area_at(height), Real(0))};
  }
};

/// 4. Springs of the part, relative to k_v l and the voxel's volume.
template <class Real>
struct PartSprings {
  Real depth;   ///< [1] phi <w>
  Real volume;  ///< [1] volume of the part in contact
  Real area;    ///< [1] section at the head's surface

  HAPTICUT_FORMULA static PartSprings of(const FilledPart<Real>& part) {
    const auto& section = part.section;
    return {section.depth(part.height, part.top), section.volume(part.height, part.top),
            select(part.top > 0, section.area_at(-part.far), Real(0))};
  }
};

/// 5. Recession of the layer.
template <class Real>
struct PartRecession {
  Real cutting;  ///< [1] phi <w>_0
  Real receded;  ///< [1] r phi <w>_0
  Real rate;     ///< [1] k_d
  Real price;    ///< [J/m^3] what cutting costs: `energy`, with law G less the stored energy that helps

  /// @param energy    [J/m^3] u, with its chips
  /// @param work      [J/m^3] kappa k_v g_d s/2, in the time: k_d times the price
  /// @param approach  [1] >= 0, speed of the head into the material
  /// @param stored    [J/m^3] k_v l^2
  HAPTICUT_FORMULA static PartRecession of(const FilledPart<Real>& part, const CutDepth<Real>& cut, Real energy,
                                           Real work, Real approach, Real stored, bool release, bool at_end) {
    const auto is_cut = cut.excess > 0 && part.fill > 0;  // elsewhere the recession may be infinite
    PartRecession p;
    p.price = energy;
    p.rate = work * reciprocal(energy);
    Real recession = LayerRecession<Real>::of(part.top, cut, p.rate, approach, Real(1), at_end).relative;
    recession = select(is_cut, recession, Real(0));
    if (release) {  // helped by what is stored where the layer's top is on average
      const Real squared = cut.threshold * cut.threshold + recession * cut.excess;
      p.price = max(energy - Real(0.5) * stored * squared, Real(kMinEnergyShare) * energy);
      p.rate = work * reciprocal(p.price);
      recession = LayerRecession<Real>::of(part.top, cut, p.rate, approach, Real(1), at_end).relative;
      recession = select(is_cut, recession, Real(0));
    }
    const Real cutting = part.section.cutting(part.height, cut.threshold, cut.beyond(part.top));
    p.cutting = select(is_cut, cutting, Real(0));
    p.receded = p.cutting * recession;
    return p;
  }
  /// [1] Spring of the material that only rubs.
  /// @param depth  [1] phi <w>
  [[nodiscard]] HAPTICUT_FORMULA Real rubbing(Real depth) const { return max(Real(0), depth - cutting); }
};

/// 6. Decay of the fill.
template <class Real>
struct PartDecay {
  Real cut;     ///< [1] spring of the material that is cut, as its mean over the time
  Real left;    ///< [1] fill after it
  Real credit;  ///< [1] fill that was removed without work; negative: work that rounding let remove nothing

  HAPTICUT_FORMULA static PartDecay of(Real fill, const PartRecession<Real>& layer) {
    const Real per_fill = reciprocal(max(fill, Real(kMinPart)));
    const Real exponent = min(2 * layer.rate * layer.receded * per_fill, Real(kMaxExponent));
    const Real mean = mean_of_decay(exponent), loss = fill * exponent * mean, left = fill - loss;
    const auto finished = left < Real(kMinPart) && exponent > 0;
    return {layer.receded * mean, select(finished, Real(0), left),
            (fill - left) - loss + select(finished, max(Real(0), left), Real(0))};
  }
};

/// What the cut of a part costs, relative to the voxel's volume.
template <class Real>
struct PartCost {
  Real cutting;      ///< [J/m^3] u/sigma_c of what was cut
  Real helped;       ///< [J/m^3] paid of it by the energy that is lost with the material: law G
  Real credited;     ///< [J/m^3] price of what was removed without work
  Real rounded_off;  ///< [J/m^3] work that rounding let remove nothing

  /// @param energy  [J/m^3] u/sigma_c
  /// @param price   [J/m^3] PartRecession::price
  HAPTICUT_FORMULA static PartCost of(Real fill, const PartDecay<Real>& decay, Real energy, Real price) {
    const Real cut = fill - decay.left;
    return {energy * cut, helped_of(cut, energy, price), price * max(Real(0), decay.credit),
            -price * min(Real(0), decay.credit)};
  }
  /// @param cut  [1] fill that was cut
  HAPTICUT_FORMULA static Real helped_of(Real cut, Real energy, Real price) { return (energy - price) * cut; }
};

/// 7. Energies stored before and after, relative to k_v l^2 and the voxel's volume.
template <class Real>
struct PartEnergies {
  Real before, after;
  Real lost;  ///< with removed material; never negative

  /// @param part    before the sub-step
  /// @param kept    the part that crushing left
  /// @param left    [1] fill after the sub-step
  /// @param spring  [1] as its mean over the sub-step
  /// @param volume  [1] in contact
  /// @param moved   [1] advance of the head in the sub-step
  /// @param lead    [1] HeadMotion::lead
  /// @param depth_at_rest   [1] crushing depth at rest
  HAPTICUT_FORMULA static PartEnergies of(const FilledPart<Real>& part, const FilledPart<Real>& kept, Real left,
                                          Real spring, Real volume, Real moved, float lead, Real depth_at_rest) {
    const auto& section = part.section;
    PartEnergies e;
    Real height = kept.height;
    if (const auto cut = left < kept.fill; any(cut)) height = select(cut, section.height_of(left), height);
    e.after = section.energy(height, height + part.far + moved * Real(0.5F - lead));
    e.after = select(left > 0, e.after, Real(0));
    e.before = e.after - spring * moved;
    e.lost = Real(0);
    const auto loses = part.fill - left > Real(kMinLoss) * part.fill;
    if (any(loses)) {
      // The excess force of a contact that is evaluated at the end was not stored before.
      const Real unstored = volume * moved * moved * Real(lead);
      const Real stored_earlier = section.energy(part.height, part.height + part.far - moved * Real(0.5F + lead));
      // Nothing was deeper in the sub-step. At a corner, material may have been at another surface before.
      const Real deepest = max(Real(0), part.top + max(moved * Real(0.5F - lead), moved * Real(-0.5F - lead)));
      const Real bound = Real(0.5) * deepest * deepest * (part.fill - left);
      const Real cut = max(Real(0), min(bound, stored_earlier - e.before - unstored));
      const Real crushed = Real(0.5) * depth_at_rest * depth_at_rest * (part.fill - kept.fill);
      e.lost = select(loses, select(part.top > kept.top, crushed, cut), Real(0));
      e.before = e.before + e.lost;
    }
    return e;
  }
};

/// The normal force of a part, and the work of it that is not stored, relative to the voxel's volume.
template <class Real>
struct PartForce {
  Real elastic;  ///< [N/m^3] force of the springs
  Real push;     ///< [N/m^3] f: with damping

  /// @param stiffness  [N/m^3] k_v l
  /// @param spring     [1] its mean over the time: what rubs and what is cut
  /// @param damping    [1] g_d
  HAPTICUT_FORMULA static PartForce of(Real stiffness, Real spring, Real damping) {
    const Real elastic = stiffness * spring;
    return {elastic, elastic * damping};
  }
  /// [J/m^3] Work of the damping.
  [[nodiscard]] HAPTICUT_FORMULA Real damped(Real moved, float voxel_size) const {
    return (push - elastic) * moved * Real(voxel_size);
  }
  /// [J/m^3] Work of the drag on what only rubs.
  /// @param work     [J/m^3] as in PartRecession
  /// @param rubbing  [1] PartRecession::rubbing
  HAPTICUT_FORMULA static Real rubbed(Real work, Real rubbing) { return 2 * work * rubbing; }
};
