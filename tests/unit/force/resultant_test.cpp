// SPDX-License-Identifier: Apache-2.0
#include "hapticut/force/resultant.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "experiments/setup/random_pose.hpp"

namespace hapticut::resultant_test {
namespace {

/// A block of random samples; every third lane is outside the head and has no force.
std::unique_ptr<ContactBlock> random_block(int rows, test::RandomPoses& random) {
  auto block = std::make_unique<ContactBlock>();
  block->rows = rows;
  block->samples = 0;
  for (int n = 0; n < block->lanes(); ++n) {
    const bool outside = n % 3 == 0;
    block->samples += !outside;
    const auto value = [&](double low, double high) { return outside ? 0.0F : float(random.between(low, high)); };
    block->x[std::size_t(n)] = float(random.between(-1e-3, 1e-3));
    block->y[std::size_t(n)] = float(random.between(-1e-3, 1e-3));
    block->z[std::size_t(n)] = float(random.between(-1e-3, 1e-3));
    block->force_x[std::size_t(n)] = value(-1, 1);
    block->force_y[std::size_t(n)] = value(-1, 1);
    block->force_z[std::size_t(n)] = value(0, 1);
    block->fill[std::size_t(n)] = value(0, 1);
    block->depth[std::size_t(n)] = value(0, 1e-3);
  }
  return block;
}

/// The sums of sum_resultant, lane by lane in double precision.
Resultant exact_sum(const ContactBlock& b) {
  Resultant sum;
  sum.voxels = b.samples;
  for (int i = 0; i < b.lanes(); ++i) {
    const auto n = std::size_t(i);
    const Vec3 r(b.x[n], b.y[n], b.z[n]), f(b.force_x[n], b.force_y[n], b.force_z[n]);
    sum.wrench_T.force += f;
    sum.wrench_T.torque += r.cross(f);
    sum.volume += double(b.fill[n]);
    sum.depth = std::max(sum.depth, double(b.depth[n]));
  }
  return sum;
}

// 64 additions per lane of numbers up to 1: single precision leaves less than 1e-4 of a sum of up to 512.
constexpr double kRounding = 1e-4;

TEST(SumResultant, D3AddsForcesAndTheirTorquesAboutTheOrigin) {
  test::RandomPoses random(1);
  for (const int rows : {1, 7, kBlockRows}) {
    const auto block = random_block(rows, random);
    const Resultant exact = exact_sum(*block);
    Resultant total;
    sum_resultant(*block, total);
    EXPECT_LT((total.wrench_T.force - exact.wrench_T.force).norm(), kRounding);
    EXPECT_LT((total.wrench_T.torque - exact.wrench_T.torque).norm(), kRounding * 1e-3);
    EXPECT_NEAR(total.volume, exact.volume, kRounding);
    EXPECT_EQ(total.voxels, exact.voxels);
    EXPECT_EQ(total.depth, exact.depth);
  }
}

TEST(SumResultant, AddsToWhatOtherBlocksGave) {
  test::RandomPoses random(2);
  const auto first = random_block(5, random), second = random_block(9, random);
  Resultant one, other, both;
  sum_resultant(*first, one);
  sum_resultant(*second, other);
  sum_resultant(*first, both);
  sum_resultant(*second, both);
  EXPECT_EQ(both.wrench_T.force, Vec3(one.wrench_T.force + other.wrench_T.force));
  EXPECT_EQ(both.wrench_T.torque, Vec3(one.wrench_T.torque + other.wrench_T.torque));
  EXPECT_EQ(both.voxels, one.voxels + other.voxels);
  EXPECT_EQ(both.depth, std::max(one.depth, other.depth));
}

}  // namespace
}  // namespace hapticut::resultant_test
