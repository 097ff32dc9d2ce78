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
        kernels::PressTask task{block.view, fill_after.data(), true, reached, {}};
        kernels::ContactSums sums;
        kernels::press_blocks({head, here, motion, materials, false}, std::span(&task, 1), sums);
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

INSTANTIATE_TEST_SUITE_P(Machine, ReachedVoxelsOnTarget, testing::ValuesIn(targets_of_this_machine()),
                         [](const auto& target) { return std::string(hwy::TargetName(target.param)); });

}  // namespace
}  // namespace hapticut::kernels_test
