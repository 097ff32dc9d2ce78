// SPDX-License-Identifier: Apache-2.0
// The voxels that the stages work on, and the sums that they add to; included once per instruction set.
#if defined(HAPTICUT_KERNELS_COLUMNS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_COLUMNS_INL_HPP
#undef HAPTICUT_KERNELS_COLUMNS_INL_HPP
#else
#define HAPTICUT_KERNELS_COLUMNS_INL_HPP
#endif

#include "kernels/strips-inl.hpp"
#include "kernels/wide-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace strips {

using Where = formulas::WhereOf<Floats>;
using Wide = formulas::WideOf<Floats>;
using Place = formulas::Triple<Wide>;
using Section = formulas::VoxelSection<Wide>;
using Part = formulas::FilledPart<Wide>;
using Material = formulas::SurfaceMaterial<Wide>;

/// Voxels in contact without gaps, in the order of their blocks: a column of numbers for each quantity. Together the
/// columns fit into the first cache. The lanes after the last voxel contain one without fill, so that each lane of a
/// vector can be computed and adds nothing to the sums.
struct Columns {
  enum Name {
    // Collected (FilledPart):
    kX,  // [m] the centre
    kY,
    kZ,
    kNormalX,
    kNormalY,
    kNormalZ,
    kSmooth,  // [m^2] MeridianSpring::smooth, of heads that are kSmooth
    kP,       // VoxelSection
    kQ,
    kPerArea,
    kFar,
    kTop,
    kHeight,
    kFill,
    kCollected,
    // Of the material (SurfaceMaterial):
    kStiffness = kCollected,
    kDamping,
    kRatio,
    kEnergy,
    kPerEnergy,
    kThreshold,
    kEdge,
    kSize,
    kViscosity,
    kCrushing,
    kSliding,       // ContactMaterial::sliding_ratio
    kSquareOfLand,  // [m^2]
    kMaterial,      // its number, only where the materials differ
    // Motion:
    kMoved,        // [1] advance in the sub-step
    kApproach,     // [1] advance in the time, not negative
    kInverseSlip,  // [s/m] SurfaceMotion
    kWork,         // [J/m^3] see PartRecession
    kFactor,       // [1] g_d
    // PartCrushing, only where something was crushed:
    kKeptTop,
    kKeptHeight,
    kKeptFill,
    kYielding,
    // PartSprings; the spring is what rubs and what is cut:
    kDepth,
    kVolume,
    kRubbing,
    kSpring,
    // PartRecession and PartDecay:
    kReceded,
    kRate,
    kPrice,
    kCutEnergy,
    kCutFrom = kReceded,  // CutDepth with chips, until the layer has receded
    kExcess = kRate,
    kLeft = kCutEnergy + 1,
    kColumns
  };
  static constexpr int kChunk = 112, kCapacity = kChunk + 2 * kStripLanes;

  alignas(64) float of[kColumns][kCapacity];
  std::int32_t index[kCapacity];  // 512 times the number of the block, plus the offset in the block
  int count = 0;
  MaterialId one_material = kEmpty;  // material of all voxels; kEmpty: their materials may differ
  bool smooth = false;               // some of them are at a smooth surface

  [[nodiscard]] HWY_INLINE Wide get(Name name, int first) const { return Wide::load(of[name] + first); }
  HWY_INLINE void put(Name name, int first, Wide value) { value.store(of[name] + first); }
  [[nodiscard]] HWY_INLINE Place place(int first) const { return {get(kX, first), get(kY, first), get(kZ, first)}; }
  [[nodiscard]] HWY_INLINE Place normal(int first) const {
    return {get(kNormalX, first), get(kNormalY, first), get(kNormalZ, first)};
  }
  [[nodiscard]] HWY_INLINE Section section(int first) const {
    return {get(kP, first), get(kQ, first), get(kPerArea, first)};
  }
  [[nodiscard]] HWY_INLINE Material material(int first) const {
    return {get(kStiffness, first), get(kDamping, first),   get(kRatio, first), get(kEnergy, first),
            get(kPerEnergy, first), get(kThreshold, first), get(kEdge, first),  get(kSize, first),
            get(kViscosity, first), get(kCrushing, first)};
  }

  HWY_INLINE void clear() {
    count = 0;
    smooth = false;
  }
  /// Removes a chunk; at most a vector of others is left.
  HWY_INLINE void remove_chunk() {
    count -= kChunk;
    for (int name = 0; name < kCollected; ++name) put(Name(name), 0, get(Name(name), kChunk));
    std::copy_n(index + kChunk, count, index);
  }
  /// Ends the collected columns with a voxel without fill, outside the head.
  HWY_INLINE void pad() {
    if (count % int(kWidth) == 0) return;
    for (int name = 0; name < kCollected; ++name) hn::StoreU(hn::Zero(Floats()), Floats(), of[name] + count);
    hn::StoreU(broadcast(-2.0F), Floats(), of[kFar] + count);
  }
};

/// ContactSums of one vector of lanes.
struct ContactVectors {
  Vec of[ContactSums::kTerms];
  Vec depth;  // [m] maximum
  int voxels = 0;
  int whole = 0;  // whole ones among them, not counted in kFill

  HWY_INLINE ContactVectors() : depth(broadcast(0.0F)) {
    for (Vec& sum : of) sum = broadcast(0.0F);
  }
  HWY_INLINE void add(int term, Wide value) { of[term] = of[term] + value.v; }
  HWY_INLINE void add(int term, const Place& value) {
    add(term, value.x), add(term + 1, value.y), add(term + 2, value.z);
  }
  HWY_INLINE void note_depth(Wide value) { depth = hn::Max(depth, value.v); }

  /// Adds the lanes to those of the sub-step, in double precision.
  HWY_INLINE void flush(ContactSums& totals) const {
    for (int term = 0; term < ContactSums::kTerms; ++term) add_lanes(of[term], totals.lanes[std::size_t(term)].data());
    totals.lanes[ContactSums::kFill][0] += double(whole);
    totals.voxels += voxels;
    totals.depth = std::max(totals.depth, hn::GetLane(hn::MaxOfLanes(Floats(), depth)));
  }
};

/// Sums that only some callers ask for, begun with `clear`.
template <class Totals>
struct TermVectors {
  Vec of[Totals::kTerms];

  HWY_INLINE void clear() {
    for (Vec& sum : of) sum = broadcast(0.0F);
  }
  HWY_INLINE void add_to(std::size_t term, Wide value) { of[term] = of[term] + value.v; }
  HWY_INLINE void flush(Totals& totals) const {
    for (std::size_t term = 0; term < Totals::kTerms; ++term) add_lanes(of[term], totals.lanes[term].data());
  }
};

struct StiffnessVectors : TermVectors<StiffnessSums> {
  /// @param r  [m] the voxels
  HWY_NOINLINE void add(const formulas::StiffnessDyad<Wide>& dyad, const Place& r) {
    const Place arm = cross(r, dyad.force), way = cross(r, dyad.motion);
    const Wide row[6] = {dyad.force.x, dyad.force.y, dyad.force.z, arm.x, arm.y, arm.z};
    const Wide column[6] = {dyad.motion.x, dyad.motion.y, dyad.motion.z, way.x, way.y, way.z};
    for (std::size_t i = 0; i < 6; ++i) {
      const Wide along = dyad.strength * row[i];
      for (std::size_t j = 0; j < 6; ++j) add_to(6 * i + j, along * column[j]);
    }
  }
};

struct FrictionVectors : TermVectors<FrictionSums> {
  /// @param number  gives one of ContactMaterial for each lane
  /// @param push    [N/m^3] normal force
  /// @param spring  [N/m^4] k_v times the volume in contact
  template <class Of>
  HWY_INLINE void add(const Of& number, Wide push, Wide spring, const Place& r, const Place& normal) {
    const auto point = formulas::PointFriction<Wide>::of(number(&ContactMaterial::static_friction),
                                                         number(&ContactMaterial::dynamic_friction),
                                                         number(&ContactMaterial::tangential_stiffness), push, spring);
    add_to(Sum::kDynamic, point.dynamic), add_to(Sum::kAnchor, point.anchor), add_to(Sum::kSpring, point.spring);
    add_limits(point.limit, r, normal);
  }

 private:
  using Sum = FrictionSums;
  HWY_NOINLINE void add_limits(Wide limit, const Place& r, const Place& normal) {
    add_to(Sum::kStatic, limit);
    const Place arm = cross(r, normal);
    const Wide place[3] = {r.x, r.y, r.z}, along[5] = {normal.x, normal.y, normal.z, arm.x, arm.y};
    for (std::size_t i = 0, term = Sum::kSecond; i < 3; ++i) {
      add_to(Sum::kFirst + i, limit * place[i]);
      for (std::size_t j = i; j < 3; ++j, ++term) add_to(term, limit * place[i] * place[j]);
    }
    for (std::size_t i = 0, term = Sum::kNormals; i < 5; ++i)
      for (std::size_t j = i; j < 5; ++j, ++term) add_to(term, limit * along[i] * along[j]);
  }
};

/// Those sums that a caller asks for.
class AskedVectors {
 public:
  // The implicit one is not compiled for the instruction set. NOLINTNEXTLINE(modernize-use-equals-default)
  HWY_INLINE AskedVectors() {}
  HWY_INLINE void ask(StiffnessSums* stiffness, FrictionSums* friction) {
    stiffness_totals_ = stiffness, friction_totals_ = friction;
    if (stiffness != nullptr) stiffness_.clear();
    if (friction != nullptr) friction_.clear();
  }
  [[nodiscard]] HWY_INLINE StiffnessVectors* stiffness() {
    return stiffness_totals_ == nullptr ? nullptr : &stiffness_;
  }
  [[nodiscard]] HWY_INLINE FrictionVectors* friction() { return friction_totals_ == nullptr ? nullptr : &friction_; }
  HWY_INLINE void flush() const {
    if (stiffness_totals_ != nullptr) stiffness_.flush(*stiffness_totals_);
    if (friction_totals_ != nullptr) friction_.flush(*friction_totals_);
  }

 private:
  StiffnessSums* stiffness_totals_ = nullptr;
  FrictionSums* friction_totals_ = nullptr;
  StiffnessVectors stiffness_;
  FrictionVectors friction_;
};

}  // namespace strips

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
