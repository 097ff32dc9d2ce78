// SPDX-License-Identifier: Apache-2.0
// Voxels that were found for a place of the head nearby.
#include <gtest/gtest.h>

#include "kernels/kernels.hpp"
#include "random_blocks.hpp"

namespace hapticut::kernels_test {
namespace {

// The list of voxels is kept while the head moves a little; its age must not matter.
using ReachedVoxelsOnTarget = KernelTarget;

TEST_P(ReachedVoxelsOnTarget, ArePressedToTheSameBits) {
  std::mt19937 random(19);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] { return Vec3{unit(random), unit(random), unit(random)}; };
  const ContactMaterials materials = three_materials(0);
  int touched = 0;
  for (const ToolHead& head : all_heads())
    for (int trial = 0; trial < 20; ++trial) {
      const RandomBlock block(random, trial % 2 == 0, trial % 4 == 0, trial % 3 == 0);
      const Vec3 middle = 0.5 * (head.bounding_box().min + head.bounding_box().max);
      const Mat3 rotation = rotation_from_vector(3 * vector());
      const Pose pose = {rotation, middle - rotation * Vec3::Constant(3.5 * kVoxel) + 0.4 * mm * vector()};
      const double moved = 0.4 * kVoxel;
      const GridInHead here(pose, kVoxel), there({rotation, pose.translation + moved * vector().normalized()}, kVoxel);
      HeadMotion motion{(2e-2 * vector()).cast<float>(),
                        Eigen::Vector3f::Zero(),
                        Eigen::Vector3f::Zero(),
                        Eigen::Vector3f::Zero(),
                        trial % 5 == 0 ? 0.0F : 2000.0F,
                        5e-3F,
                        float(kVoxel),
                        trial % 7 == 0 ? RemovalLaw::elastic_release : RemovalLaw::constant_energy};
      motion.crushes = trial % 3 == 1;
      const auto press = [&](const kernels::ReachedVoxels& reached) {
        std::array<float, kBlockVoxels> fill_after = {};
        kernels::BlockTask task{block.view, fill_after.data(), true, reached, {}};
        kernels::ContactSums sums;
        kernels::evaluate_blocks({head, here, motion, materials, false}, std::span(&task, 1), sums);
        return std::tuple(sums.lanes, sums.removed, sums.voxels, sums.depth, fill_after);
      };
      std::array<std::uint16_t, kernels::ReachedVoxels::kCapacity> voxels;
      const kernels::ContactJob then = {head, there, motion, materials, false};
      const auto found_there = kernels::find_voxels(then, block.view, float(moved), voxels.data());
      const auto pressed = press({});
      ASSERT_EQ(press(found_there), pressed) << "head " << head.shape().index() << ", trial " << trial;
      touched += std::get<2>(pressed) > 0 ? 1 : 0;
    }
  EXPECT_GT(touched, 100);
}

/// Leaves numbers where the next function has its local variables.
HWY_NOINLINE float leave_numbers(float number) {
  volatile float local[32 * 1024];
  for (volatile float& f : local) f = number;
  return local[std::size(local) / 2];
}

TEST_P(ReachedVoxelsOnTarget, ArePressedToTheSameBitsWhateverIsInMemory) {
  std::mt19937 random(23);
  const ContactMaterials materials = three_materials(0);
  int voxels = 0;
  for (const ToolHead& head : all_heads())
    for (int trial = 0; trial < 8; ++trial) {
      const RandomBlock block(random, trial % 4 != 3, trial % 2 == 0, false);
      const Vec3 middle = 0.5 * (head.bounding_box().min + head.bounding_box().max);
      const GridInHead grid(Pose::from_translation(middle - Vec3::Constant((1.5 + 0.5 * trial) * kVoxel)), kVoxel);
      HeadMotion motion{Eigen::Vector3f(0, 0, -1e-3F),
                        Eigen::Vector3f::Zero(),
                        Eigen::Vector3f::Zero(),
                        Eigen::Vector3f::Zero(),
                        0.0F,
                        1e-3F,
                        float(kVoxel),
                        RemovalLaw::none};
      const auto press = [&](float number) {
        std::array<float, kBlockVoxels> fill_after = {};
        kernels::BlockTask task{block.view, fill_after.data(), true, {}, {}};
        kernels::ContactSums sums;
        kernels::StiffnessSums stiffness;
        kernels::FrictionSums friction;
        EXPECT_EQ(leave_numbers(number), number);
        kernels::evaluate_blocks({head, grid, motion, materials, false}, std::span(&task, 1), sums, &stiffness,
                                 &friction);
        return std::tuple(sums.lanes, stiffness.lanes, friction.lanes, sums.voxels, fill_after);
      };
      for (const bool turns : {false, true}) {
        motion.spin = turns ? 2000 : 0, motion.tooth_rate = turns ? 2000 : 0, motion.crushes = turns;
        motion.removal = turns ? RemovalLaw::constant_energy : RemovalLaw::none;
        const auto pressed = press(0);
        ASSERT_EQ(press(3e38F), pressed) << "head " << head.shape().index() << ", trial " << trial << ", " << turns;
        voxels += std::get<3>(pressed);
      }
    }
  EXPECT_GT(voxels, 1000);
}

INSTANTIATE_TEST_SUITE_P(Machine, ReachedVoxelsOnTarget, testing::ValuesIn(targets_of_this_machine()),
                         [](const auto& target) { return std::string(hwy::TargetName(target.param)); });

}  // namespace
}  // namespace hapticut::kernels_test
