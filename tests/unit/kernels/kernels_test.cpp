// SPDX-License-Identifier: Apache-2.0
// Every instruction set of this machine against the scalar reference, on random blocks, heads, poses and motions.
#include <gtest/gtest.h>

#include "hapticut/force/grain.hpp"
#include "hapticut/force/laws/foundation.hpp"
#include "kernels/kernels.hpp"
#include "random_blocks.hpp"

namespace hapticut::kernels_test {
namespace {

/// Tolerance of the vectors against the scalar reference, relative to the maximum of the block: fused multiply-add
/// rounds once where the reference rounds twice, over some twenty operations of 6e-8 each.
constexpr double kRounding = 5e-6;

/// [1] Share of the blocks with a voxel within rounding of the head's surface. Positions are rounded to 1e-7 mm and the
/// surface passes some fifty points 0.1 mm apart, which gives 5e-5. The bound is twenty times that.
constexpr double kAtTheRim = 1e-3;
constexpr double kAtAJump = 2e-3;  // [1] share of the blocks; each block has hundreds of parts

void expect_close(const ContactBlock::Array<float>& a, const ContactBlock::Array<float>& b, int lanes, double scale) {
  for (int n = 0; n < lanes; ++n) ASSERT_NEAR(a[std::size_t(n)], b[std::size_t(n)], kRounding * scale) << "lane " << n;
}

double max_size(const ContactBlock::Array<float>& a, int lanes) {
  double maximum = 1e-30;
  for (int n = 0; n < lanes; ++n) maximum = std::max(maximum, std::abs(double(a[std::size_t(n)])));
  return maximum;
}

TEST_P(KernelTarget, AgreesWithTheScalarReferenceInSamplingAndSumming) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] { return Vec3{unit(random), unit(random), unit(random)}; };  // drawn in this order
  long samples = 0;
  int blocks = 0, at_the_rim = 0;
  for (const ToolHead& head : all_heads())
    for (int trial = 0; trial < 60; ++trial) {
      const RandomBlock block(random, trial % 2 == 0, trial % 4 == 0, trial % 3 == 0);
      const Vec3 middle = 0.5 * (head.bounding_box().min + head.bounding_box().max);
      const Mat3 rotation = rotation_from_vector(3 * vector());
      const Vec3 block_middle = rotation * Vec3::Constant(3.5 * kVoxel);
      const GridInHead grid({rotation, middle - block_middle + 0.4 * mm * vector()}, kVoxel);
      const Quadrature quadrature = trial % 7 == 0 ? Quadrature::voxel_center : Quadrature::centroid;

      ContactBlock expected, got;
      head.visit_springs<float>(
          [&](const auto& springs) { sample_contact(springs, block.view, grid, quadrature, expected); });
      kernels::sample_contact(head, block.view, grid, quadrature, got);
      ++blocks;
      // A voxel whose depth is 0 within rounding may be a sample in only one of the results; skip the rare block.
      if (got.rows != expected.rows || got.inside != expected.inside) {
        ++at_the_rim;
        continue;
      }
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

      for (std::size_t n = 0; n < std::size_t(lanes); ++n) {  // springs
        const float push = -1e3F * expected.fill[n] * expected.depth[n];
        expected.force_x[n] = push * expected.normal_x[n];
        expected.force_y[n] = push * expected.normal_y[n];
        expected.force_z[n] = push * expected.normal_z[n];
      }
      Resultant scalar, vector_sum;
      sum_resultant(expected, scalar);
      kernels::sum_resultant(expected, vector_sum);
      const double force = max_size(expected.force_x, lanes) * lanes + max_size(expected.force_z, lanes) * lanes;
      EXPECT_LT((scalar.wrench_T.force - vector_sum.wrench_T.force).norm(), kRounding * force);
      EXPECT_LT((scalar.wrench_T.torque - vector_sum.wrench_T.torque).norm(), kRounding * force * mm);
      EXPECT_EQ(scalar.voxels, vector_sum.voxels);
      EXPECT_EQ(scalar.depth, vector_sum.depth);
    }
  EXPECT_GT(samples, 10000) << "the heads must touch the blocks, else the test proves nothing";
  EXPECT_LE(at_the_rim, kAtTheRim * blocks);
}

/// The three stages of the scalar reference on one block, in the terms of the one-pass kernel.
struct Reference {
  Resultant resultant;
  LawTotals totals;
  ByMaterial<double> removed = {};
  BlockChange change;
  std::array<float, kBlockVoxels> fill_after = {};
  Stiffness stiffness = Stiffness::Zero();
  SpreadFriction friction;
  ContactBlock contact;

  Reference(const kernels::ContactJob& job, const BlockView& block) {
    std::array<std::uint64_t, kBlockEdge> of_subset = {};
    for (int row = 0; row < kBlockRows; ++row) {
      const int slab = row / kBlockEdge, in_slab = row % kBlockEdge;
      const std::uint64_t bits = std::uint64_t(0xff) << (8 * in_slab);
      const std::uint64_t solid = block.solid == nullptr ? ~std::uint64_t(0) : block.solid[slab];
      if (job.in_subset(block.origin, slab, in_slab / 2)) of_subset[std::size_t(slab)] |= solid & bits;
    }
    BlockView evaluated = block;
    evaluated.solid = of_subset.data(), contact.min_width = job.motion.min_width;
    job.head.visit_springs<float>(
        [&](const auto& springs) { sample_contact(springs, evaluated, job.grid, Quadrature::sub_voxel, contact); });
    totals = FoundationLaw().evaluate(job.motion, job.materials, contact, &stiffness);
    sum_resultant(contact, resultant);
    friction.add(contact, job.motion, job.materials);
    if (totals.may_remove) change = find_changes(contact, block, fill_after.data(), removed);
  }
};

/// @param subsets  number of subsets of the level of detail for which `found` stands
void expect_same(const Resultant& found, const Resultant& wanted, double subsets, double scale, double couple_error) {
  EXPECT_LT((found.wrench_T.force / subsets - wanted.wrench_T.force).norm(), kRounding * scale);
  EXPECT_LT((found.wrench_T.torque / subsets - wanted.wrench_T.torque).norm(), kRounding * scale * mm + couple_error);
  EXPECT_LT((found.push_T / subsets - wanted.push_T).norm(), kRounding * scale);
  EXPECT_LT((found.moment_T / subsets - wanted.moment_T).norm(), kRounding * scale * mm);
  EXPECT_NEAR(found.normal_force / subsets, wanted.normal_force, kRounding * scale);
  EXPECT_NEAR(found.area / subsets, wanted.area, kRounding * kBlockVoxels);
  EXPECT_NEAR(found.volume / subsets, wanted.volume, kRounding * kBlockVoxels);
  EXPECT_NEAR(found.depth, wanted.depth, kRounding * mm);
}

TEST_P(KernelTarget, EvaluatesABlockAsTheScalarStagesDoOneByOne) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] { return Vec3{unit(random), unit(random), unit(random)}; };  // drawn in this order
  long samples = 0, emptied = 0, stiff = 0, rubbed = 0, crushed = 0, blocks = 0, at_the_rim = 0, at_a_jump = 0;
  for (const ToolHead& head : all_heads())
    for (int trial = 0; trial < 100; ++trial) {
      const RandomBlock block(random, trial % 2 == 0, trial % 4 == 0, trial % 3 == 0);
      const Vec3 middle = 0.5 * (head.bounding_box().min + head.bounding_box().max);
      const Mat3 rotation = rotation_from_vector(3 * vector());
      const GridInHead grid({rotation, middle - rotation * Vec3::Constant(3.5 * kVoxel) + 0.4 * mm * vector()}, kVoxel);
      HeadMotion motion{(2e-2 * vector()).cast<float>(),
                        (2.0 * vector()).cast<float>(),
                        (2e-2 * vector()).cast<float>(),
                        (2.0 * vector()).cast<float>(),
                        trial % 5 == 0 ? 0.0F : 2000.0F,
                        5e-3F,
                        float(kVoxel),
                        RemovalLaw(trial % 3),
                        0,
                        trial % 8 < 4 ? 0.0F : 0.5F,
                        float(1 + trial % 11 % 3)};
      if (trial % 13 < 5) motion.tooth_rate = 600, motion.ripple = 0.25F * motion.felt_velocity;
      motion.floors = trial % 19 < 9, motion.fastest_chips = trial % 23 < 8 ? 0.01F : 0.0F;
      motion.crushes = trial % 17 < 9, motion.min_width = trial % 7 < 3 ? VoxelSection<float>::kMinStandingWidth : 0.3F;
      const bool damped = trial % 2 != 0;
      const ContactMaterials materials = three_materials(damped ? 20.0F : 0.0F);
      Grain places;
      places.set(materials, {kVoxel, {}}, std::uint32_t(trial));
      if (trial % 29 < 14) motion.grain = &places;
      const kernels::ContactJob job = {
          head, grid, motion, materials, damped, unsigned(motion.level_of_detail), unsigned(trial)};
      const Reference expected(job, block.view);
      SCOPED_TRACE("head " + std::to_string(head.shape().index()) + ", trial " + std::to_string(trial));

      std::array<float, kBlockVoxels> fill_after = {};
      kernels::BlockTask task{block.view, fill_after.data(), true, {}, {}};
      kernels::ContactSums sums;
      kernels::StiffnessSums stiffness;
      kernels::FrictionSums friction;
      const bool asks = trial % 4 == 3;
      kernels::evaluate_blocks(job, std::span(&task, 1), sums, asks ? &stiffness : nullptr,
                               asks && motion.spin == 0 ? &friction : nullptr);
      ++blocks;
      // Skip the rare block with a voxel that touches in only one result, or that takes another surface at a crease.
      const double volume = kVoxel * kVoxel * kVoxel, weight = job.level_of_detail;
      const kernels::ContactTotals totals = kernels::totals_of(job, sums, volume);
      const double more = std::abs(totals.resultant.volume / weight - expected.resultant.volume);
      if (totals.resultant.voxels != int(weight) * expected.resultant.voxels || more > kRounding * kBlockVoxels) {
        ++at_the_rim;
        continue;
      }
      samples += expected.resultant.voxels;

      // Upper bound on the sum of the samples' forces.
      const double scale = 1e-3 + 2e14 * volume * expected.resultant.depth * expected.resultant.volume;
      Resultant wanted = expected.resultant;
      const double couple = expected.totals.spin_couple;  // fades as 1 - (rho / zone)^2, which loses digits
      wanted.wrench_T.torque.z() += couple;
      expect_same(totals.resultant, wanted, weight, scale, 1e-3 * std::abs(couple) + 1e-15);
      const LawEnergies &energies = expected.totals.energies, &found = totals.energies;
      const double energy = std::abs(energies.elastic_before) + energies.cutting + energies.released +
                            energies.rubbing + energies.crushed + std::abs(energies.damping) + 1e-30;
      // A section is at least 0.3 voxels wide; a voxel without a section stores up to 0.3^2/24 k l^5 less.
      double elastic_error = 2 * kRounding * energy;
      for (std::size_t n = 0; n < std::size_t(expected.contact.lanes()) && motion.spin == 0; ++n)
        if (expected.contact.top[n] > 0)
          elastic_error +=
              0.3 * 0.3 / 24 * materials[expected.contact.material_of(int(n))].stiffness * std::pow(kVoxel, 5);
      EXPECT_NEAR(found.elastic_before / weight, energies.elastic_before, elastic_error);
      // Stored energy counts for all voxels, removed volume once.
      const double lost = energies.released + energies.crushed + expected.totals.helped;
      EXPECT_NEAR(found.elastic, weight * energies.elastic + (weight - 1) * lost, weight * elastic_error);
      EXPECT_NEAR(found.released, energies.released, 10 * kRounding * energy);
      EXPECT_NEAR(found.damping / weight, energies.damping, kRounding * energy);
      // Cutting, rubbing and credited contain the rounding of fills, up or down; the work of the drag does not.
      const double rounded = 10 * kRounding * energy;
      const double drag = energies.cutting + energies.rubbing - energies.credited;
      // Law G pays u less what is stored, a difference that magnifies rounding; so does ChippingLips near the feed.
      const double magnified = motion.removal == RemovalLaw::elastic_release ? 2 : motion.tooth_rate > 0 ? 0.5 : 0.2;
      EXPECT_NEAR(found.cutting + found.rubbing - found.credited, drag, magnified * rounded);
      EXPECT_NEAR(found.rubbing, energies.rubbing, rounded);
      EXPECT_NEAR(found.credited, energies.credited, rounded);
      EXPECT_NEAR(found.crushed, energies.crushed, 10 * kRounding * energy);
      crushed += found.crushed > 0 ? 1 : 0;
      const Stiffness k = stiffness.total(volume, 1), &k_expected = expected.stiffness;
      // Unlike the force, the stiffness jumps where a cut or crushed part of a voxel begins; rounding decides the side.
      const double off = (k - k_expected).norm(), size = k_expected.norm() + 1e-9;
      EXPECT_LT(asks ? off : 0, 0.01 * size);
      at_a_jump += !asks || off < 40 * kRounding * size ? 0 : 1;
      stiff += k.norm() > 0 ? 1 : 0;
      if (asks && motion.spin == 0) {
        const SpreadFriction all = friction.total(volume, 1), &exact = expected.friction;
        EXPECT_LE((all.directions - exact.directions).norm(), 20 * kRounding * exact.static_limit);
        EXPECT_NEAR(all.static_limit, exact.static_limit, kRounding * scale);
        EXPECT_NEAR(all.dynamic_limit, exact.dynamic_limit, kRounding * scale);
        EXPECT_NEAR(all.stiffness(), exact.stiffness(), 1e-3 * exact.stiffness() + 1e-9);
        rubbed += all.static_limit > 0 ? 1 : 0;
      }
      for (std::size_t id = 1; id <= 3; ++id) EXPECT_NEAR(sums.removed[id], expected.removed[id], kRounding * 512);
      // A voxel may be removed in one result and keep its last thousandth in the other; count those, compare the rest.
      int differently_finished = 0;
      for (int n = 0; n < kBlockVoxels; ++n) {
        const bool removed = task.change.emptied.has(n), expected_removed = expected.change.emptied.has(n);
        differently_finished += removed != expected_removed ? 1 : 0;
        emptied += removed ? 1 : 0;
        if ((expected.change.strips >> (n / BlockChange::kStrip) & 1) == 0) continue;
        const bool kept = !removed && !expected_removed;
        const double apart = std::abs(double(fill_after[std::size_t(n)]) - double(expected.fill_after[std::size_t(n)]));
        // Where the feed grazes a surface, ChippingLips magnifies the rounding of speeds.
        ASSERT_LE(apart, kept ? (motion.tooth_rate > 0 ? 100 : 1) * kRounding : 2 * double(kMinFill)) << n;
        differently_finished += kept && apart > kRounding ? 1 : 0;
      }
      EXPECT_LE(differently_finished, motion.tooth_rate > 0 ? 3 : 1);
    }
  EXPECT_GT(samples, 10000) << "the heads must touch the blocks, else the test proves nothing";
  EXPECT_LE(at_the_rim, 2 * kAtTheRim * blocks);
  EXPECT_LE(at_a_jump, kAtAJump * blocks);
  EXPECT_GT(std::min({stiff / 5, rubbed, crushed, emptied}), 20)
      << "each case must occur, else the test proves nothing";
}

TEST_P(KernelTarget, FeelsButLeavesABlockThatMayNotBeCut) {
  std::mt19937 random(13);
  const RandomBlock block(random, false, false, false);
  const ToolHead head = SphereHead{0.6 * mm};
  const GridInHead grid(Pose::from_translation(Vec3::Constant(-3.5 * kVoxel)), kVoxel);
  const Eigen::Vector3f none = Eigen::Vector3f::Zero();
  const HeadMotion motion{none, none, none, none, 2000.0F, 1e-3F, float(kVoxel), RemovalLaw::constant_energy};
  const ContactMaterials materials = three_materials(0);
  const kernels::ContactJob job = {head, grid, motion, materials, false};
  std::array<float, kBlockVoxels> fill_after = {};
  kernels::BlockTask task{block.view, fill_after.data(), false, {}, {}};
  kernels::ContactSums sums;
  kernels::evaluate_blocks(job, std::span(&task, 1), sums);
  const kernels::ContactTotals totals = kernels::totals_of(job, sums, kVoxel * kVoxel * kVoxel);
  EXPECT_GT(totals.resultant.voxels, 100);
  EXPECT_EQ(task.change.strips, 0U);
  EXPECT_FALSE(task.change.any_changed);
  EXPECT_EQ(sums.removed, (ByMaterial<double>{}));
  EXPECT_GT(totals.energies.rubbing, 0);
}

TEST_P(KernelTarget, EvaluatesStripsInsideABallAsTheScalarStagesDo) {  // without friction and dampers
  std::mt19937 random(17);
  const RandomBlock block(random, true, true, false);
  const ToolHead head = SphereHead{1.2 * mm};
  const ContactMaterials materials = three_materials(0);
  const Eigen::Vector3f none = Eigen::Vector3f::Zero();
  const HeadMotion motion{{0.02F, -0.01F, 0.03F}, none, none, none, 0, 1e-3F, float(kVoxel), RemovalLaw::none};
  for (const double first : {-3.4, -1.1, 2.3}) {  // [voxels] start of the block: first wholly, then partly inside
    const GridInHead grid({rotation_from_vector(Vec3(0.3, 0.2, 0.1)), Vec3::Constant(first * kVoxel)}, kVoxel);
    const kernels::ContactJob job = {head, grid, motion, materials, false};
    const Reference expected(job, block.view);
    std::array<float, kBlockVoxels> fill_after = {};
    kernels::BlockTask task{block.view, fill_after.data(), false, {}, {}};
    kernels::ContactSums sums;
    kernels::evaluate_blocks(job, std::span(&task, 1), sums);
    const kernels::ContactTotals found = kernels::totals_of(job, sums, std::pow(kVoxel, 3));
    const LawEnergies &a = found.energies, &b = expected.totals.energies;
    const Resultant& wanted = expected.resultant;
    const double scale = wanted.normal_force, path = double(motion.velocity.norm() * motion.duration);
    EXPECT_EQ(found.resultant.voxels, wanted.voxels);
    expect_same(found.resultant, wanted, 1, scale, 0);
    EXPECT_NEAR(a.elastic - a.elastic_before, b.elastic - b.elastic_before, kRounding * scale * path);
  }
}

INSTANTIATE_TEST_SUITE_P(Machine, KernelTarget, testing::ValuesIn(targets_of_this_machine()),
                         [](const auto& target) { return std::string(hwy::TargetName(target.param)); });

}  // namespace
}  // namespace hapticut::kernels_test
