// SPDX-License-Identifier: Apache-2.0
#include "core/interruption.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "hapticut/workpiece/builders.hpp"
#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut {
namespace {

/// It would take a quarter of an hour.
Workpiece large_sphere() { return build_sphere(Vec3::Zero(), 10e-3, 10e-6, presets::enamel()); }

TEST(Interruption, EndsABuilderWhenItIsNotWantedAnyMore) {
  int asked = 0;
  const InterruptionScope scope([&] { return ++asked == 2; });
  EXPECT_THROW((void)large_sphere(), Interrupted);
  EXPECT_EQ(asked, 2);
}

TEST(Interruption, IsNotAskedForInOtherThreadsOrWithoutAScope) {
  {
    const InterruptionScope over([] { return true; });
  }
  const auto build = [] { return build_sphere(Vec3::Zero(), 2e-3, 20e-6, presets::enamel()).solid_voxels(); };
  const auto expected = build();
  const InterruptionScope scope([] { return true; });
  std::int64_t there = 0;
  std::thread([&] { there = build(); }).join();
  EXPECT_EQ(there, expected);
}

TEST(Interruption, OfAnInnerScopeEndsWithIt) {
  const InterruptionScope outer([] { return true; });
  {
    const InterruptionScope inner([] { return false; });
    EXPECT_GT(build_sphere(Vec3::Zero(), 2e-3, 20e-6, presets::enamel()).solid_voxels(), 0);
  }
  EXPECT_THROW((void)large_sphere(), Interrupted);
}

}  // namespace
}  // namespace hapticut
