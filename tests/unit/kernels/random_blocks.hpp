// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <random>

#include "hapticut/core/units.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "kernels/kernels.hpp"
#include "kernels/targets/which.hpp"
#include "support/profiles.hpp"
#include "support/usual_heads.hpp"

/// @file
/// Random blocks, all heads, and each instruction set of this machine.
namespace hapticut::kernels_test {

using units::deg;
using units::mm;

inline constexpr double kVoxel = 0.1 * mm;

/// The content of a block, as a workpiece gives it.
struct RandomBlock {
  std::array<MaterialId, kBlockVoxels> material;
  std::array<std::uint64_t, 8> solid;
  std::array<float, kBlockVoxels> fill;
  std::array<std::int32_t, kBlockVoxels> centroid;
  BlockView view;

  RandomBlock(std::mt19937& random, bool uniform, bool full, bool surface) {
    std::uniform_real_distribution<float> unit(0, 1);
    const auto first = MaterialId(1 + random() % 3);
    for (int n = 0; n < kBlockVoxels; ++n) {
      material[std::size_t(n)] = uniform ? first : MaterialId(1 + random() % 3);
      fill[std::size_t(n)] = unit(random) < 0.5F ? 1.0F : unit(random);
      const Vec3 offset(double(unit(random)) - 0.5, double(unit(random)) - 0.5, double(unit(random)) - 0.5);
      centroid[std::size_t(n)] = std::int32_t(CentroidOffset::from_offset(offset).packed());
    }
    for (std::uint64_t& word : solid)
      word = (std::uint64_t(random()) << 32 | random()) | (std::uint64_t(random()) << 7);
    for (int n = 0; n < kBlockVoxels; ++n)
      if (!BlockMask::has(solid.data(), n)) fill[std::size_t(n)] = 0;
    view.uniform_material = uniform && full ? first : kEmpty;
    if (!uniform || !full) {
      view.material = material.data();
      view.solid = solid.data();
      view.fill = fill.data();
    }
    if (surface) view.centroid = centroid.data();
  }
};

inline ContactMaterials three_materials(float damping) {
  ContactMaterials materials = {};
  materials[0].cutting_energy = 1;
  materials[1] = {.stiffness = 1e13F,
                  .damping = damping,
                  .cutting_ratio = 0.5F,
                  .cutting_energy = 3e8F,
                  .cutting_depth = 0.0F,
                  .crushing_depth = 1.2e-4F,
                  .static_friction = 0.3F,
                  .dynamic_friction = 0.25F};
  materials[2] = {.stiffness = 4e12F,
                  .damping = 2 * damping,
                  .cutting_ratio = 0.3F,
                  .cutting_energy = 1e8F,
                  .cutting_depth = 1e-5F,
                  .edge_length = 1e-5F,
                  .size_length = 3e-5F,
                  .viscosity = 1e8F,
                  .crushing_depth = 2e-4F,
                  .static_friction = 0.2F,
                  .dynamic_friction = 0.2F,
                  .tangential_stiffness = 500.0F,
                  .grain = 0.4F,
                  .grain_length = 3e-4F};  // chips matter only with a tooth rate
  materials[3] = {.stiffness = 2e14F,
                  .damping = 0.0F,
                  .cutting_ratio = 0.9F,
                  .cutting_energy = 5e9F,
                  .cutting_depth = 3e-6F,
                  .size_length = 1e-4F,
                  .static_friction = 0.6F,
                  .dynamic_friction = 0.1F};
  return materials;
}

/// Profiles with lines and arcs that occur in all_profiles() only in heads that need their table: two lines of which
/// the nearer counts, a hollow arc, two arcs about points off the axis, a nearly straight arc, and a nearly flat arc
/// about the axis.
inline std::vector<Profile> plain_profiles() {
  constexpr EdgeKind kSmooth = EdgeKind::smooth;
  return {test::flat_profile(0.5 * mm, 1 * mm),
          {0, {{0.6 * mm, 1.2 * mm, -2 * mm}, {0, 1.2 * mm, 0, kSmooth}}},
          flame_head(1.4 * mm, 4 * mm, 0.9 * mm, 2 * mm).profile(),
          {0, {{0.5 * mm, 1 * mm, 60 * mm}, {0, 1 * mm, 0, kSmooth}}},
          {0,
           {{0.5 * mm, (60 - std::sqrt(60 * 60 - 0.25)) * mm, 60 * mm},
            {0.5 * mm, 1 * mm, 0, kSmooth},
            {0, 1 * mm, 0, kSmooth}}}};
}

inline std::vector<ToolHead> all_heads() {
  std::vector<ToolHead> heads = {SphereHead{0.6 * mm},
                                 ConeHead{30 * deg, 1 * mm},
                                 FlatHead{0.5 * mm, 1 * mm, FlatRule::nearest},
                                 FlatHead{0.5 * mm, 1 * mm, FlatRule::bottom_only},
                                 FlatHead{0.5 * mm, 1 * mm, FlatRule::side_only},
                                 FlatHead{0.5 * mm, 1 * mm, FlatRule::both}};
  for (const ToolHead& head : test::usual_heads<SphereHead, ConeHead, FlatHead>(0.5)) heads.push_back(head);
  for (const test::NamedProfile& p : test::all_profiles()) heads.emplace_back(ProfileHead(p.profile));
  for (const Profile& profile : plain_profiles()) {
    heads.emplace_back(ProfileHead(profile));
    EXPECT_NE(std::get<ProfileHead>(heads.back().shape()).table().everywhere, 0U) << "it is not plain";
  }
  return heads;
}

class KernelTarget : public testing::TestWithParam<std::int64_t> {
 protected:
  void SetUp() override {
    hwy::SetSupportedTargetsForTest(GetParam());
    hwy::GetChosenTarget().Update(GetParam());
  }
  void TearDown() override {
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

inline std::vector<std::int64_t> targets_of_this_machine() {
  std::vector<std::int64_t> targets;
  for (std::int64_t all = hwy::SupportedTargets() & ~std::int64_t(HAPTICUT_LEFT_OUT); all != 0; all &= all - 1)
    targets.push_back(all & -all);
  return targets;
}

}  // namespace hapticut::kernels_test
