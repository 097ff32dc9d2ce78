// SPDX-License-Identifier: Apache-2.0
// The materials of the voxels in the columns; included once per instruction set.
#if defined(HAPTICUT_KERNELS_MATERIALS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_MATERIALS_INL_HPP
#undef HAPTICUT_KERNELS_MATERIALS_INL_HPP
#else
#define HAPTICUT_KERNELS_MATERIALS_INL_HPP
#endif

#include "hapticut/force/grain.hpp"
#include "kernels/columns-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace strips {

/// Sets the constants of the materials in the columns. Most often there is one material, whose constants stay there
/// from chunk to chunk.
class ColumnMaterials {
  using C = Columns;

 public:
  HWY_INLINE ColumnMaterials(const ContactJob& job, Columns& columns) : c_(columns), job_(job) {}

  HWY_NOINLINE void set(std::span<BlockTask> tasks) {
    count_ = 0;
    if (c_.one_material != kEmpty)
      list(c_.one_material);
    else
      list_all(tasks);
    const MaterialId one = count_ == 1 ? listed_.front() : kEmpty;
    if (one == kEmpty || one != in_columns_)
      for (std::size_t name = 0; name < kConstants; ++name)
        for (int n = 0; n < (one == kEmpty ? c_.count : C::kCapacity); n += int(kWidth))
          c_.put(C::Name(C::kStiffness + name), n, each(n, [&](MaterialId id) { return constants_[id][name]; }));
    const Grain* grain = job_.motion.grain;
    const bool changes = c_.smooth || job_.motion.resists();  // below and in `Stages::resist`
    in_columns_ = changes ? kEmpty : one;
    if (c_.smooth) set_smooth();
    if (grain != nullptr) vary(*grain, tasks);
  }

  /// The materials that occur.
  [[nodiscard]] std::span<const MaterialId> listed() const { return std::span(listed_).first(std::size_t(count_)); }

  /// A number of the material of each of a vector of voxels.
  template <class Of>
  [[nodiscard]] HWY_INLINE Wide each(int n, const Of& of) const {
    Wide value = of(listed_.front());
    for (int other = 1; other < count_; ++other) {
      const MaterialId id = listed_[std::size_t(other)];
      value = select(c_.get(C::kMaterial, n) == float(id), Wide(of(id)), value);
    }
    return value;
  }
  /// The values in voxels of a material, and 0 in others.
  [[nodiscard]] HWY_INLINE Wide only(MaterialId id, int n, Wide value) const {
    return count_ == 1 ? value : select(c_.get(C::kMaterial, n) == float(id), value, 0);
  }

 private:
  static constexpr std::size_t kConstants = C::kMaterial - C::kStiffness;

  /// Looks up the material of each voxel.
  HWY_NOINLINE void list_all(std::span<BlockTask> tasks) {
    ByMaterial<bool> seen = {};
    for (int n = 0; n < c_.count; ++n) {
      const auto at = unsigned(c_.index[n]);
      const BlockView& block = tasks[at / kBlockVoxels].block;
      const MaterialId id = block.material == nullptr ? block.uniform_material : block.material[at % kBlockVoxels];
      c_.of[C::kMaterial][n] = float(id);
      if (!std::exchange(seen[id], true)) list(id);
    }
  }
  void list(MaterialId id) {
    listed_[std::size_t(count_++)] = id;
    if (std::exchange(known_[id], true)) return;
    const ContactMaterial& material = job_.materials[id];
    const float voxel_size = job_.motion.voxel_size;
    const auto m = hapticut::formulas::SurfaceMaterial<float>::of(material, voxel_size);
    constants_[id] = {m.stiffness,  m.damping,        m.cutting_ratio,        m.energy,
                      m.per_energy, m.threshold,      m.edge_length,          m.size_length,
                      m.viscosity,  m.crushing_depth, material.sliding_ratio, material.square_of_land(voxel_size)};
  }
  HWY_NOINLINE void set_smooth() {
    for (int n = 0; n < c_.count; n += int(kWidth)) {
      const Material there =
          c_.material(n).at(c_.get(C::kSmooth, n), c_.get(C::kSliding, n), c_.get(C::kSquareOfLand, n));
      c_.put(C::kStiffness, n, there.stiffness), c_.put(C::kDamping, n, there.damping);
      c_.put(C::kRatio, n, there.cutting_ratio), c_.put(C::kThreshold, n, there.threshold);
      c_.put(C::kCrushing, n, there.crushing_depth);
    }
  }

  /// The cutting energy of each voxel, by its place.
  HWY_NOINLINE void vary(const Grain& grain, std::span<BlockTask> tasks) {
    for (int n = 0; n < c_.count; ++n) {
      const auto at = unsigned(c_.index[n]);
      const MaterialId id = count_ == 1 ? listed_.front() : MaterialId(c_.of[C::kMaterial][n]);
      if (at / kBlockVoxels != entered_ || id != entered_id_) {
        entered_ = at / kBlockVoxels, entered_id_ = id;
        in_block_.enter(grain, id, tasks[entered_].block.origin);
      }
      c_.of[C::kEnergy][n] = constants_[id][C::kEnergy - C::kStiffness] * in_block_.at(int(at % kBlockVoxels));
    }
    for (int n = 0; n < c_.count; n += int(kWidth))
      c_.put(C::kPerEnergy, n, c_.material(n).with_energy(c_.get(C::kEnergy, n)).per_energy);
  }

  Columns& c_;
  const ContactJob& job_;
  std::array<MaterialId, C::kCapacity> listed_ = {};
  int count_ = 0;
  MaterialId in_columns_ = kEmpty;  // whose constants are in all columns; kEmpty: of none
  ByMaterial<std::array<float, kConstants>> constants_;
  ByMaterial<bool> known_ = {};  // which of them are computed
  Grain::OfBlock in_block_;
  unsigned entered_ = ~0U;  // number of the block of `in_block_`
  MaterialId entered_id_ = kEmpty;
};

}  // namespace strips

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
