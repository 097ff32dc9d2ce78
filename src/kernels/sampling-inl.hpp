// SPDX-License-Identifier: Apache-2.0
// Stage sample_contact in vectors; included once per instruction set.
#if defined(HAPTICUT_KERNELS_SAMPLING_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_SAMPLING_INL_HPP
#undef HAPTICUT_KERNELS_SAMPLING_INL_HPP
#else
#define HAPTICUT_KERNELS_SAMPLING_INL_HPP
#endif

#include "kernels/rows-inl.hpp"
#include "kernels/springs-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

template <class Springs>
HWY_INLINE void SampleRows(const Springs& springs, const BlockView& block, const GridInHead& grid, bool at_centroid,
                           ContactBlock& out) {
  const Floats d;
  const Eigen::Vector3f base = grid.position(block.origin).cast<float>();
  const Eigen::Matrix3f steps = grid.voxel_steps.cast<float>();
  const float size = steps.col(0).norm();

  out.sub_voxel = false;
  out.rows = out.samples = 0;
  out.uniform = true;
  out.one_material = block.uniform_material;
  for (int row = 0; row < kBlockRows; ++row) {
    const auto solid = block.solid == nullptr ? 0xffU : unsigned(block.solid[row >> 3] >> (8 * (row & 7)) & 0xff);
    if (solid == 0) continue;
    const Eigen::Vector3f start = base + steps.col(0) * float(row >> 3) + steps.col(1) * float(row & 7);
    unsigned inside = 0;
    for (std::size_t part = 0; part < kParts; ++part) {
      const int voxel = row * kLanes + int(part * kWidth);
      const std::size_t n = std::size_t(out.rows) * kLanes + part * kWidth;
      const Vec k = hn::Iota(d, float(part * kWidth));
      Vec x = hn::MulAdd(k, broadcast(steps(0, 2)), broadcast(start.x()));
      Vec y = hn::MulAdd(k, broadcast(steps(1, 2)), broadcast(start.y()));
      Vec z = hn::MulAdd(k, broadcast(steps(2, 2)), broadcast(start.z()));
      if (at_centroid) {
        const auto packed = hn::LoadU(hn::RebindToSigned<Floats>(), block.centroid + voxel);
        const Vec di = centroid_component<0>(packed);
        const Vec dj = centroid_component<10>(packed);
        const Vec dk = centroid_component<20>(packed);
        const auto shifted = [&](Vec p, int axis) {
          return hn::MulAdd(di, broadcast(steps(axis, 0)),
                            hn::MulAdd(dj, broadcast(steps(axis, 1)), hn::MulAdd(dk, broadcast(steps(axis, 2)), p)));
        };
        x = shifted(x, 0);
        y = shifted(y, 1);
        z = shifted(z, 2);
      }
      const SpringVectors<Vec> spring = springs.at(x, y, z);
      // Springs mean something only where `hits` says so.
      const Mask may_be_inside = hn::And(springs.hits(x, y, z, 0.0F), mask_of(solid, part));
      const Mask is_inside = hn::And(spring.depth > hn::Zero(d), may_be_inside);
      inside |= bits_of(is_inside, part);
      const Vec fill = block.fill == nullptr ? broadcast(1.0F) : hn::LoadU(d, block.fill + voxel);
      hn::Store(x, d, &out.x[n]);
      hn::Store(y, d, &out.y[n]);
      hn::Store(z, d, &out.z[n]);
      hn::Store(hn::IfThenElseZero(is_inside, spring.depth), d, &out.depth[n]);
      hn::Store(x * spring.radial, d, &out.normal_x[n]);
      hn::Store(y * spring.radial, d, &out.normal_y[n]);
      hn::Store(spring.axial, d, &out.normal_z[n]);
      hn::Store(spring.smooth, d, &out.smooth[n]);
      hn::Store(hn::IfThenElseZero(is_inside, fill), d, &out.fill[n]);
      const Mask is_near = hn::And(is_inside, spring.depth < broadcast(size));
      hn::Store(hn::IfThenElseZero(is_near, broadcast(1.0F)), d, &out.exposed[n]);
    }
    if (inside != 0) keep_row(block, row, inside, out);
  }
}

HWY_ATTR void SampleContact(const ToolHead& head, const BlockView& block, const GridInHead& grid, Quadrature quadrature,
                            ContactBlock& out) {
  const bool at_centroid = block.centroid != nullptr && quadrature == Quadrature::centroid;
  visit_springs(head, [&](const auto& springs) HWY_ATTR { SampleRows(springs, block, grid, at_centroid, out); });
}

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
