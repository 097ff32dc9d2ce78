// SPDX-License-Identifier: Apache-2.0
#include "hapticut/workpiece/builders.hpp"

#include <gtest/gtest.h>

#include "hapticut/core/units.hpp"

namespace hapticut {
namespace {

using units::kPi;
using units::mm;

Material named(const char* name) {
  Material material;
  material.name = name;
  return material;
}

TEST(BuildBlock, FillsAPartlyCoveredLastRowByItsFraction) {
  const Workpiece workpiece = build_block({Vec3::Zero(), Vec3(1, 1, 0.96) * mm}, 0.1 * mm, named("clay"));
  EXPECT_NEAR(workpiece.amounts()[0].volume, 0.96e-9, 1e-16);
  EXPECT_NEAR(workpiece.fill_at({3, 3, 9}), 0.6, 1e-6);
  EXPECT_EQ(workpiece.centroid_at({3, 3, 9}), CentroidOffset::from_offset({0, 0, -0.2}));
}

TEST(BuildLayeredSlab, GivesEachLayerItsVolume) {
  const Workpiece workpiece = build_layered_slab({Vec3::Zero(), Vec3(2, 2, 3) * mm}, 0.1 * mm,
                                                 {{named("enamel"), 1 * mm}, {named("dentin"), 1.5 * mm}});
  const auto amounts = workpiece.amounts();
  EXPECT_NEAR(amounts[0].volume, 4e-9, 1e-15);
  EXPECT_NEAR(amounts[1].volume, 6e-9, 1e-15);
}

TEST(BuildSphere, ConvergesToItsVolume) {
  const double exact = 4 * kPi / 3 * 8e-9;
  const double coarse = build_sphere(Vec3(1, 2, 3) * mm, 2 * mm, 0.2 * mm, named("clay")).amounts()[0].volume;
  const double fine = build_sphere(Vec3(1, 2, 3) * mm, 2 * mm, 0.1 * mm, named("clay")).amounts()[0].volume;
  EXPECT_NEAR(coarse / exact, 1, 1e-3);
  EXPECT_NEAR(fine / exact, 1, 3e-4);
}

TEST(CentroidOffset, SurvivesPacking) {
  for (const Vec3& v : {Vec3(0, 0, 0), Vec3(-0.5, 0.25, 0.49), Vec3(0.1, -0.37, -0.001)}) {
    const CentroidOffset offset = CentroidOffset::from_offset(v);
    EXPECT_EQ(CentroidOffset::unpacked(offset.packed()), offset);
  }
}

}  // namespace
}  // namespace hapticut
