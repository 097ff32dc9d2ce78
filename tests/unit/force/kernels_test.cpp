// SPDX-License-Identifier: Apache-2.0
// Every instruction set of this machine against the scalar reference, on random blocks, heads, poses and motions.
#include "kernels/kernels.hpp"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <random>

#include "hapticut/core/units.hpp"
#include "hapticut/force/laws/foundation.hpp"
#include "support/profiles.hpp"

namespace hapticut {
namespace {

using units::deg;
using units::mm;

constexpr double kVoxel = 0.1 * mm;

/// What the vectors may differ by from the scalar reference, relative to the largest value of the block: fused
/// multiply-add rounds once where the reference rounds twice, over some twenty operations of 6e-8 each.
constexpr double kRounding = 5e-6;

/// One block's content, as a workpiece would hand it out.
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
    view.uniform_material = uniform && full ? first : kEmpty;
    if (!uniform || !full) {
      view.material = material.data();
      view.solid = solid.data();
      view.fill = fill.data();
    }
    if (surface) view.centroid = centroid.data();
  }
};

ContactMaterials three_materials(float damping) {
  ContactMaterials materials = {};
  materials[0].cutting_energy = 1;
  materials[1] = {1e13F, damping, 0.5F, 3e8F, 0.0F};
  materials[2] = {4e12F, 2 * damping, 0.3F, 1e8F, 1e-5F};
  materials[3] = {2e14F, 0.0F, 0.9F, 5e9F, 3e-6F};
  return materials;
}

std::vector<ToolHead> all_heads() {
  std::vector<ToolHead> heads = {SphereHead{0.6 * mm},
                                 ConeHead{30 * deg, 1 * mm},
                                 FlatHead{0.5 * mm, 1 * mm, FlatRule::nearest},
                                 FlatHead{0.5 * mm, 1 * mm, FlatRule::bottom_only},
                                 FlatHead{0.5 * mm, 1 * mm, FlatRule::side_only},
                                 FlatHead{0.5 * mm, 1 * mm, FlatRule::both}};
  for (const test::NamedProfile& p : test::all_profiles()) heads.emplace_back(ProfileHead(p.profile));
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

void expect_close(const ContactBlock::Array<float>& a, const ContactBlock::Array<float>& b, int lanes, double scale) {
  for (int n = 0; n < lanes; ++n) ASSERT_NEAR(a[std::size_t(n)], b[std::size_t(n)], kRounding * scale) << "lane " << n;
}

double largest(const ContactBlock::Array<float>& a, int lanes) {
  double most = 1e-30;
  for (int n = 0; n < lanes; ++n) most = std::max(most, std::abs(double(a[std::size_t(n)])));
  return most;
}

TEST_P(KernelTarget, AgreesWithTheScalarReferenceInEveryStage) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] { return Vec3(unit(random), unit(random), unit(random)); };
  long samples = 0;
  for (const ToolHead& head : all_heads())
    for (int trial = 0; trial < 60; ++trial) {
      const RandomBlock block(random, trial % 2 == 0, trial % 4 == 0, trial % 3 == 0);
      const Vec3 middle = 0.5 * (head.bounding_box().min + head.bounding_box().max);
      const Mat3 rotation = rotation_from_vector(3 * vector());
      const Vec3 block_middle = rotation * Vec3::Constant(3.5 * kVoxel);
      const GridInHead grid({rotation, middle - block_middle + 0.4 * mm * vector()}, kVoxel);
      const HeadMotion motion{(2e-2 * vector()).cast<float>(),
                              (2.0 * vector()).cast<float>(),
                              (2e-2 * vector()).cast<float>(),
                              (2.0 * vector()).cast<float>(),
                              trial % 5 == 0 ? 0.0F : 2000.0F,
                              1e-3F,
                              float(kVoxel),
                              RemovalLaw(trial % 3)};
      const ContactMaterials materials = three_materials(trial % 2 == 0 ? 0.0F : 20.0F);
      const Quadrature quadrature = trial % 7 == 0 ? Quadrature::voxel_center : Quadrature::centroid;

      ContactBlock expected, got;
      head.visit_springs<float>(
          [&](const auto& springs) { sample_contact(springs, block.view, grid, quadrature, expected); });
      kernels::sample_contact(head, block.view, grid, quadrature, got);
      // A voxel whose depth is 0 within rounding may be a sample in one and not in the other; skip the rare block.
      if (got.rows != expected.rows || got.inside != expected.inside) continue;
      ASSERT_EQ(got.samples, expected.samples);
      ASSERT_EQ(got.uniform, expected.uniform);
      const int lanes = expected.lanes();
      samples += expected.samples;
      for (const auto array : {&ContactBlock::x, &ContactBlock::y, &ContactBlock::z, &ContactBlock::depth})
        expect_close(got.*array, expected.*array, lanes, 1 * mm);
      for (const auto array :
           {&ContactBlock::normal_x, &ContactBlock::normal_y, &ContactBlock::normal_z, &ContactBlock::fill})
        for (int n = 0; n < lanes; ++n)
          if (expected.inside[std::size_t(n / kLanes)] >> (n % kLanes) & 1) {
            ASSERT_NEAR((got.*array)[std::size_t(n)], (expected.*array)[std::size_t(n)], 1e-4);
          }

      ContactBlock vectors = expected;
      const LawTotals a = FoundationLaw::evaluate_scalar(motion, materials, expected);
      const LawTotals b = kernels::evaluate_foundation(motion, materials, vectors);
      for (const auto array : {&ContactBlock::force_x, &ContactBlock::force_y, &ContactBlock::force_z})
        expect_close(vectors.*array, expected.*array, lanes,
                     largest(expected.*array, lanes) + largest(expected.force_z, lanes));
      expect_close(vectors.fill_after, expected.fill_after, lanes, 1.0);
      const double total = a.energies.elastic + a.energies.cutting + a.energies.released + a.energies.rubbing + 1e-30;
      EXPECT_NEAR(a.energies.elastic, b.energies.elastic, kRounding * total);
      EXPECT_NEAR(a.energies.cutting, b.energies.cutting, 10 * kRounding * total);
      EXPECT_NEAR(a.energies.released, b.energies.released, 10 * kRounding * total);
      EXPECT_NEAR(a.energies.rubbing, b.energies.rubbing, kRounding * total);
      // The couple fades out as 1 - (rho / zone)^2, where single precision cancels.
      EXPECT_NEAR(a.spin_couple, b.spin_couple, 1e-3 * std::abs(a.spin_couple) + 1e-15);

      Resultant scalar, vector_sum;
      sum_resultant(expected, scalar);
      kernels::sum_resultant(expected, vector_sum);
      const double force = largest(expected.force_x, lanes) * lanes + largest(expected.force_z, lanes) * lanes;
      EXPECT_LT((scalar.wrench_T.force - vector_sum.wrench_T.force).norm(), kRounding * force);
      EXPECT_LT((scalar.wrench_T.torque - vector_sum.wrench_T.torque).norm(), kRounding * force * mm);
      EXPECT_EQ(scalar.voxels, vector_sum.voxels);
      EXPECT_EQ(scalar.depth, vector_sum.depth);
    }
  EXPECT_GT(samples, 10000) << "the heads must meet the blocks, or the test says nothing";
}

std::vector<std::int64_t> targets_of_this_machine() {
  std::vector<std::int64_t> targets;
  for (std::int64_t all = hwy::SupportedTargets(); all != 0; all &= all - 1) targets.push_back(all & -all);
  return targets;
}

INSTANTIATE_TEST_SUITE_P(Machine, KernelTarget, testing::ValuesIn(targets_of_this_machine()),
                         [](const auto& target) { return std::string(hwy::TargetName(target.param)); });

}  // namespace
}  // namespace hapticut
