// SPDX-License-Identifier: Apache-2.0
// Stage sum_resultant in vectors; included once per instruction set.
#if defined(HAPTICUT_KERNELS_RESULTANT_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_RESULTANT_INL_HPP
#undef HAPTICUT_KERNELS_RESULTANT_INL_HPP
#else
#define HAPTICUT_KERNELS_RESULTANT_INL_HPP
#endif

#include "kernels/rows-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

HWY_ATTR void SumResultant(const ContactBlock& b, Resultant& total) {
  const Floats d;
  LaneSum force_x, force_y, force_z, torque_x, torque_y, torque_z, fill, deepest, normal, area;
  LaneSum push_x, push_y, push_z, moment_x, moment_y, moment_z;
  for (int row = 0; row < b.rows; ++row)
    for (std::size_t part = 0; part < kParts; ++part) {
      const std::size_t n = std::size_t(row) * kLanes + part * kWidth;
      const Vec fx = hn::Load(d, &b.force_x[n]), fy = hn::Load(d, &b.force_y[n]), fz = hn::Load(d, &b.force_z[n]);
      const Vec x = hn::Load(d, &b.x[n]), y = hn::Load(d, &b.y[n]), z = hn::Load(d, &b.z[n]);
      force_x.part[part] = force_x.part[part] + fx;
      force_y.part[part] = force_y.part[part] + fy;
      force_z.part[part] = force_z.part[part] + fz;
      torque_x.part[part] = torque_x.part[part] + hn::MulSub(y, fz, z * fy);
      torque_y.part[part] = torque_y.part[part] + hn::MulSub(z, fx, x * fz);
      torque_z.part[part] = torque_z.part[part] + hn::MulSub(x, fy, y * fx);
      fill.part[part] = fill.part[part] + hn::Load(d, &b.fill[n]);
      const Vec nx = hn::Load(d, &b.normal_x[n]), ny = hn::Load(d, &b.normal_y[n]), nz = hn::Load(d, &b.normal_z[n]);
      const Vec along = hn::MulAdd(fx, nx, hn::MulAdd(fy, ny, fz * nz));
      normal.part[part] = normal.part[part] + along;
      push_x.part[part] = hn::MulAdd(along, nx, push_x.part[part]);
      push_y.part[part] = hn::MulAdd(along, ny, push_y.part[part]);
      push_z.part[part] = hn::MulAdd(along, nz, push_z.part[part]);
      moment_x.part[part] = hn::NegMulAdd(along, x, moment_x.part[part]);
      moment_y.part[part] = hn::NegMulAdd(along, y, moment_y.part[part]);
      moment_z.part[part] = hn::NegMulAdd(along, z, moment_z.part[part]);
      const Vec smooth = hn::Load(d, &b.smooth[n]),
                scale = hn::IfThenElse(smooth > hn::Zero(d), broadcast(kBeta), broadcast(1.0F));
      area.part[part] = hn::MulAdd(scale, hn::Load(d, &b.exposed[n]), area.part[part]);
      deepest.part[part] = hn::Max(deepest.part[part], hn::Load(d, &b.depth[n]));
    }
  total.wrench_T.force += Vec3(force_x.total(), force_y.total(), force_z.total());
  total.wrench_T.torque += Vec3(torque_x.total(), torque_y.total(), torque_z.total());
  total.voxels += b.samples;
  total.volume += fill.total();
  total.normal_force -= normal.total();
  total.push_T += Vec3(push_x.total(), push_y.total(), push_z.total());
  total.moment_T += Vec3(moment_x.total(), moment_y.total(), moment_z.total());
  total.area += area.total();
  for (const Vec& v : deepest.part) total.depth = std::max(total.depth, double(hn::GetLane(hn::MaxOfLanes(d, v))));
}

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
