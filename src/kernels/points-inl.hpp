// SPDX-License-Identifier: Apache-2.0
// The stages of laws that are evaluated at points, sample_contact and sum_resultant, row by row; included once per
// instruction set.
#if defined(HAPTICUT_KERNELS_POINTS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_POINTS_INL_HPP
#undef HAPTICUT_KERNELS_POINTS_INL_HPP
#else
#define HAPTICUT_KERNELS_POINTS_INL_HPP
#endif

#include "kernels/kernels.hpp"
#include "kernels/springs-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

// Vectors of at most eight floats, so that a row is one, two or eight of them and sums have the same order everywhere.
using Floats = hn::CappedTag<float, kLanes>;
using Vec = hn::Vec<Floats>;
using Mask = hn::Mask<Floats>;
using RowWide = formulas::WideOf<Floats>;
constexpr std::size_t kWidth = hn::MaxLanes(Floats());
constexpr std::size_t kVectors = kLanes / kWidth;

HWY_INLINE Vec broadcast(float value) { return hn::Set(Floats(), value); }

/// Lanes `vector * kWidth ...` of the eight bits of a row.
HWY_INLINE Mask mask_of(unsigned bits, std::size_t vector) {
  std::uint8_t shifted[8] = {std::uint8_t(bits >> (vector * kWidth))};  // Highway may read eight bytes
  return hn::LoadMaskBits(Floats(), shifted);
}

HWY_INLINE unsigned bits_of(Mask mask, std::size_t vector) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(Floats(), mask, bits);
  return unsigned(bits[0]) << (vector * kWidth);
}

/// One running sum per lane of a row.
struct LaneSum {
  Vec vector[kVectors];
  HWY_INLINE LaneSum() {
    for (Vec& v : vector) v = hn::Zero(Floats());
  }
  /// The lanes added up in double precision, from the first to the last.
  HWY_INLINE double total() const {
    alignas(64) float lanes[kLanes];
    for (std::size_t p = 0; p < kVectors; ++p) hn::Store(vector[p], Floats(), lanes + p * kWidth);
    double sum = 0;
    for (const float lane : lanes) sum += double(lane);
    return sum;
  }
};

/// Component `kShift / 10` of packed centroid offsets, in voxel edges.
template <int kShift, class Words>
HWY_INLINE auto centroid_component(Words packed) {
  const hn::Rebind<float, hn::DFromV<Words>> floats;
  const auto steps = hn::ShiftRight<22>(hn::ShiftLeft<22 - kShift>(packed));
  return hn::ConvertTo(floats, steps) * hn::Set(floats, 1.0F / CentroidOffset::kSteps);
}

template <class Springs>
HWY_INLINE void SampleRows(const Springs& springs, const BlockView& block, const GridInHead& grid, bool at_centroid,
                           ContactBlock& out) {
  const Floats d;
  const Eigen::Vector3f base = grid.position(block.origin).cast<float>();
  const Eigen::Matrix3f steps = grid.voxel_steps.cast<float>();
  const float size = steps.col(0).norm();
  const auto bound = springs.grown(0.0F);

  out.sub_voxel = false;
  out.origin = block.origin;
  out.rows = out.samples = 0;
  out.uniform = true;
  out.one_material = block.uniform_material;
  for (int row = 0; row < kBlockRows; ++row) {
    const auto solid = block.solid == nullptr ? 0xffU : unsigned(block.solid[row >> 3] >> (8 * (row & 7)) & 0xff);
    if (solid == 0) continue;
    const Eigen::Vector3f start = base + steps.col(0) * float(row >> 3) + steps.col(1) * float(row & 7);
    unsigned inside = 0;
    for (std::size_t vector = 0; vector < kVectors; ++vector) {
      const int voxel = row * kLanes + int(vector * kWidth);
      const std::size_t n = std::size_t(out.rows) * kLanes + vector * kWidth;
      const Vec k = hn::Iota(d, float(vector * kWidth));
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
      const formulas::SpatialSpring<RowWide> spring = springs.at(x, y, z);
      const Mask may_be_inside = hn::And(bound.hits(x, y, z).m, mask_of(solid, vector));
      const Mask is_inside = hn::And((spring.depth > 0).m, may_be_inside);
      inside |= bits_of(is_inside, vector);
      const Vec fill = block.fill == nullptr ? broadcast(1.0F) : hn::LoadU(d, block.fill + voxel);
      hn::Store(x, d, &out.x[n]);
      hn::Store(y, d, &out.y[n]);
      hn::Store(z, d, &out.z[n]);
      hn::Store(hn::IfThenElseZero(is_inside, spring.depth.v), d, &out.depth[n]);
      (spring.radial * x).store(&out.normal_x[n]);
      (spring.radial * y).store(&out.normal_y[n]);
      spring.axial.store(&out.normal_z[n]);
      spring.smooth.store(&out.smooth[n]);
      hn::Store(hn::IfThenElseZero(is_inside, fill), d, &out.fill[n]);
      const Mask is_near = hn::And(is_inside, (spring.depth < size).m);
      hn::Store(hn::IfThenElseZero(is_near, broadcast(1.0F)), d, &out.exposed[n]);
    }
    if (inside != 0) keep_row(block, row, inside, out);
  }
}

HWY_ATTR void SampleContact(const ToolHead& head, const BlockView& block, const GridInHead& grid, Quadrature quadrature,
                            ContactBlock& out) {
  const bool at_centroid = block.centroid != nullptr && quadrature == Quadrature::centroid;
  visit_springs<RowWide>(head,
                         [&](const auto& springs) HWY_ATTR { SampleRows(springs, block, grid, at_centroid, out); });
}

HWY_ATTR void SumResultant(const ContactBlock& b, Resultant& total) {
  const Floats d;
  LaneSum force_x, force_y, force_z, torque_x, torque_y, torque_z, fill, deepest, normal, area;
  LaneSum push_x, push_y, push_z, moment_x, moment_y, moment_z;
  for (int row = 0; row < b.rows; ++row)
    for (std::size_t vector = 0; vector < kVectors; ++vector) {
      const std::size_t n = std::size_t(row) * kLanes + vector * kWidth;
      const Vec fx = hn::Load(d, &b.force_x[n]), fy = hn::Load(d, &b.force_y[n]), fz = hn::Load(d, &b.force_z[n]);
      const Vec x = hn::Load(d, &b.x[n]), y = hn::Load(d, &b.y[n]), z = hn::Load(d, &b.z[n]);
      force_x.vector[vector] = force_x.vector[vector] + fx;
      force_y.vector[vector] = force_y.vector[vector] + fy;
      force_z.vector[vector] = force_z.vector[vector] + fz;
      torque_x.vector[vector] = torque_x.vector[vector] + hn::MulSub(y, fz, z * fy);
      torque_y.vector[vector] = torque_y.vector[vector] + hn::MulSub(z, fx, x * fz);
      torque_z.vector[vector] = torque_z.vector[vector] + hn::MulSub(x, fy, y * fx);
      fill.vector[vector] = fill.vector[vector] + hn::Load(d, &b.fill[n]);
      const Vec nx = hn::Load(d, &b.normal_x[n]), ny = hn::Load(d, &b.normal_y[n]), nz = hn::Load(d, &b.normal_z[n]);
      const Vec along = hn::MulAdd(fx, nx, hn::MulAdd(fy, ny, fz * nz));
      normal.vector[vector] = normal.vector[vector] + along;
      push_x.vector[vector] = hn::MulAdd(along, nx, push_x.vector[vector]);
      push_y.vector[vector] = hn::MulAdd(along, ny, push_y.vector[vector]);
      push_z.vector[vector] = hn::MulAdd(along, nz, push_z.vector[vector]);
      moment_x.vector[vector] = hn::NegMulAdd(along, x, moment_x.vector[vector]);
      moment_y.vector[vector] = hn::NegMulAdd(along, y, moment_y.vector[vector]);
      moment_z.vector[vector] = hn::NegMulAdd(along, z, moment_z.vector[vector]);
      const Vec smooth = hn::Load(d, &b.smooth[n]),
                scale = hn::IfThenElse(smooth > hn::Zero(d), broadcast(float(kSmoothScale)), broadcast(1.0F));
      area.vector[vector] = hn::MulAdd(scale, hn::Load(d, &b.exposed[n]), area.vector[vector]);
      deepest.vector[vector] = hn::Max(deepest.vector[vector], hn::Load(d, &b.depth[n]));
    }
  total.wrench_T.force += Vec3(force_x.total(), force_y.total(), force_z.total());
  total.wrench_T.torque += Vec3(torque_x.total(), torque_y.total(), torque_z.total());
  total.voxels += b.samples;
  total.volume += fill.total();
  total.normal_force -= normal.total();
  total.push_T += Vec3(push_x.total(), push_y.total(), push_z.total());
  total.moment_T += Vec3(moment_x.total(), moment_y.total(), moment_z.total());
  total.area += area.total();
  for (const Vec& v : deepest.vector) total.depth = std::max(total.depth, double(hn::GetLane(hn::MaxOfLanes(d, v))));
}

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
