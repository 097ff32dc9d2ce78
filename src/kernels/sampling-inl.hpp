// SPDX-License-Identifier: Apache-2.0
// Stage sample_contact in vectors; included once per instruction set.
#if defined(HAPTICUT_KERNELS_SAMPLING_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_SAMPLING_INL_HPP
#undef HAPTICUT_KERNELS_SAMPLING_INL_HPP
#else
#define HAPTICUT_KERNELS_SAMPLING_INL_HPP
#endif

#include "kernels/rows-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

/// Depth and direction at a vector of points.
struct SpringVectors {
  Vec depth, normal_x, normal_y, normal_z;
};

struct SphereVectors {
  float radius;
  explicit SphereVectors(const SphereHead& head) : radius(float(head.radius)) {}
  HWY_INLINE SpringVectors at(Vec x, Vec y, Vec z) const {
    const Vec distance = hn::Sqrt(hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z))));
    const Vec inverse = hn::Div(broadcast(1.0F), hn::Max(distance, broadcast(1e-12F)));
    return {hn::Sub(broadcast(radius), distance), hn::Mul(x, inverse), hn::Mul(y, inverse), hn::Mul(z, inverse)};
  }
};

struct ConeVectors {
  float sine, cosine, height;
  explicit ConeVectors(const ConeHead& head)
      : sine(float(std::sin(head.half_angle))), cosine(float(std::cos(head.half_angle))), height(float(head.height)) {}
  HWY_INLINE SpringVectors at(Vec x, Vec y, Vec z) const {
    const Vec rho = hn::Sqrt(hn::MulAdd(x, x, hn::Mul(y, y)));
    const Vec radial = hn::Div(broadcast(cosine), hn::Max(rho, broadcast(1e-12F)));
    const Vec depth = hn::MulSub(z, broadcast(sine), hn::Mul(rho, broadcast(cosine)));
    const Mask below_base = hn::Lt(z, broadcast(height));
    return {hn::IfThenElseZero(below_base, depth), hn::Mul(x, radial), hn::Mul(y, radial), broadcast(-sine)};
  }
};

template <FlatRule kRule>
struct FlatVectors {
  float radius, height;
  explicit FlatVectors(const FlatHead& head) : radius(float(head.radius)), height(float(head.height)) {}
  HWY_INLINE SpringVectors at(Vec x, Vec y, Vec z) const {
    const Vec zero = broadcast(0.0F);
    const Vec rho = hn::Sqrt(hn::MulAdd(x, x, hn::Mul(y, y)));
    const Vec inverse = hn::Div(broadcast(1.0F), hn::Max(rho, broadcast(1e-12F)));
    const Vec side = hn::Sub(broadcast(radius), rho);
    const Mask inside = hn::Gt(hn::Min(hn::Min(z, hn::Sub(broadcast(height), z)), side), zero);
    if constexpr (kRule == FlatRule::bottom_only) {
      return {hn::IfThenElseZero(inside, z), zero, zero, broadcast(-1.0F)};
    } else if constexpr (kRule == FlatRule::side_only) {
      return {hn::IfThenElseZero(inside, side), hn::Mul(x, inverse), hn::Mul(y, inverse), zero};
    } else if constexpr (kRule == FlatRule::both) {
      const Vec depth = hn::Sqrt(hn::MulAdd(side, side, hn::Mul(z, z)));
      const Vec share = hn::Div(broadcast(1.0F), hn::Max(depth, broadcast(1e-12F)));
      const Vec radial = hn::Mul(hn::Mul(side, share), inverse);
      return {hn::IfThenElseZero(inside, depth), hn::Mul(x, radial), hn::Mul(y, radial), hn::Neg(hn::Mul(z, share))};
    } else {
      const Mask on_side = hn::Lt(side, z);
      const Vec radial = hn::IfThenElseZero(on_side, inverse);
      return {hn::IfThenElseZero(inside, hn::Min(side, z)), hn::Mul(x, radial), hn::Mul(y, radial),
              hn::IfThenZeroElse(on_side, broadcast(-1.0F))};
    }
  }
};

/// Component `shift / 10` of eight packed centroid offsets, in voxel edges.
template <int kShift>
HWY_INLINE Vec centroid_component(const std::int32_t* packed) {
  const hn::RebindToSigned<Floats> ints;
  const auto word = hn::LoadU(ints, packed);
  const auto steps = hn::ShiftRight<22>(hn::ShiftLeft<22 - kShift>(word));
  return hn::Mul(hn::ConvertTo(Floats(), steps), broadcast(1.0F / CentroidOffset::kSteps));
}

template <class Springs>
HWY_INLINE void SampleRows(const Springs& springs, const BlockView& block, const GridInHead& grid, bool at_centroid,
                           ContactBlock& out) {
  const Floats d;
  const Eigen::Vector3f base = grid.position(block.origin).cast<float>();
  const Eigen::Matrix3f steps = grid.voxel_steps.cast<float>();

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
        const Vec di = centroid_component<0>(block.centroid + voxel);
        const Vec dj = centroid_component<10>(block.centroid + voxel);
        const Vec dk = centroid_component<20>(block.centroid + voxel);
        const auto shifted = [&](Vec p, int axis) {
          return hn::MulAdd(di, broadcast(steps(axis, 0)),
                            hn::MulAdd(dj, broadcast(steps(axis, 1)), hn::MulAdd(dk, broadcast(steps(axis, 2)), p)));
        };
        x = shifted(x, 0);
        y = shifted(y, 1);
        z = shifted(z, 2);
      }
      const SpringVectors spring = springs.at(x, y, z);
      const Mask is_inside = hn::And(hn::Gt(spring.depth, hn::Zero(d)), mask_of(solid, part));
      inside |= bits_of(is_inside, part);
      const Vec fill = block.fill == nullptr ? broadcast(1.0F) : hn::LoadU(d, block.fill + voxel);
      hn::Store(x, d, &out.x[n]);
      hn::Store(y, d, &out.y[n]);
      hn::Store(z, d, &out.z[n]);
      hn::Store(hn::IfThenElseZero(is_inside, spring.depth), d, &out.depth[n]);
      hn::Store(spring.normal_x, d, &out.normal_x[n]);
      hn::Store(spring.normal_y, d, &out.normal_y[n]);
      hn::Store(spring.normal_z, d, &out.normal_z[n]);
      hn::Store(hn::IfThenElseZero(is_inside, fill), d, &out.fill[n]);
    }
    if (inside != 0) keep_row(block, row, inside, out);
  }
}

inline HWY_ATTR void SampleContact(const ToolHead& head, const BlockView& block, const GridInHead& grid,
                                   Quadrature quadrature, ContactBlock& out) {
  const bool at_centroid = block.centroid != nullptr && quadrature == Quadrature::centroid;
  const auto sample = [&](const auto& springs) HWY_ATTR { SampleRows(springs, block, grid, at_centroid, out); };
  const ToolHead::Shape& shape = head.shape();
  if (const auto* sphere = std::get_if<SphereHead>(&shape)) return sample(SphereVectors(*sphere));
  if (const auto* cone = std::get_if<ConeHead>(&shape)) return sample(ConeVectors(*cone));
  const FlatHead& flat = *std::get_if<FlatHead>(&shape);
  switch (flat.rule) {
    case FlatRule::bottom_only:
      return sample(FlatVectors<FlatRule::bottom_only>(flat));
    case FlatRule::side_only:
      return sample(FlatVectors<FlatRule::side_only>(flat));
    case FlatRule::both:
      return sample(FlatVectors<FlatRule::both>(flat));
    case FlatRule::nearest:
      return sample(FlatVectors<FlatRule::nearest>(flat));
  }
}

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
