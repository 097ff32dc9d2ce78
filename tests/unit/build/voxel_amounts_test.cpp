// SPDX-License-Identifier: Apache-2.0
// Layers of labels, and between surfaces, that are thinner than the voxels are not lost without a word.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "hapticut/build/mesh_builder.hpp"
#include "hapticut/build/volume_builders.hpp"
#include "support/meshes.hpp"
#include "support/named_material.hpp"
#include "support/refusal.hpp"
#include "support/volumes.hpp"

namespace hapticut::voxel_amounts_test {
namespace {

using test::named;
using units::mm;

/// A block of dentin under a layer of enamel, one sample thick.
LabelVolume crowned_block(const Vec3& spacing) {
  auto volume = test::volume_of<std::uint16_t>({40, 40, 20}, spacing);
  test::for_each_sample(volume, [&](int i, int j, int k) {
    if (i >= 4 && i < 36 && j >= 4 && j < 36 && k >= 4 && k < 13) volume.at(i, j, k) = k < 12 ? 1 : 2;
  });
  return volume;
}

const std::vector<LabelMaterial> kMaterials = {{{1}, named("dentin")}, {{2}, named("enamel")}};

struct Built {
  Workpiece workpiece;
  std::vector<std::string> said;
};

Built built(const LabelVolume& volume, VolumeBuildOptions options) {
  std::vector<std::string> said;
  options.warn = [&](const std::string& sentence) { said.push_back(sentence); };
  Workpiece workpiece = build_from_labels(volume, kMaterials, options);
  return {std::move(workpiece), std::move(said)};
}

TEST(BuildFromLabels, SaysWhichMaterialsAreTooThinForItsVoxels) {
  const LabelVolume volume = crowned_block(Vec3::Constant(0.1 * mm));  // the enamel is 3.2 x 3.2 x 0.1 mm: 1.024 mm^3
  const Built coarse = built(volume, {.voxel_size = 0.35 * mm});
  ASSERT_EQ(coarse.said.size(), 1U);
  test::expect_part(coarse.said[0], "voxels of 0.35 mm are too coarse for the labels: ");
  test::expect_part(coarse.said[0], "'enamel' fills ");
  test::expect_part(coarse.said[0], ", its labels 1.024 mm^3");
  test::expect_part(coarse.said[0], "Choose voxels of 0.1 mm, the spacing of the labels.");
  const Built cured = built(volume, {.voxel_size = 0.1 * mm});
  EXPECT_TRUE(cured.said.empty());
  EXPECT_NEAR(cured.workpiece.amounts()[1].volume, 1.024e-9, 1e-15);
}

TEST(BuildFromLabels, RefusesWhatItWouldHaveToSayIfNobodyListens) {
  const LabelVolume volume = crowned_block(Vec3::Constant(0.1 * mm));
  test::expect_refused([&] { return build_from_labels(volume, kMaterials, {.voxel_size = 0.35 * mm}); },
                       {"'enamel' fills ", "or set VolumeBuildOptions::warn to go on."});
  EXPECT_NO_THROW((void)build_from_labels(volume, kMaterials));
}

TEST(BuildFromLabels, SaysThatSamplesThatAreNoCubesShouldBeResampled) {
  auto volume = test::volume_of<std::uint16_t>({20, 20, 20}, Vec3(0.1, 0.1, 0.3) * mm);
  for (int i = 2; i < 18; ++i) volume.at(i, 10, 10) = 2;  // a wire: its corners are rounded
  const Built wire = built(volume, {});
  ASSERT_EQ(wire.said.size(), 2U) << "there is no dentin, too";
  test::expect_part(wire.said[1], "Resample the labels to cubes first");
}

TEST(BuildFromLabels, SaysNothingOfBodiesThatAreThickEnoughAlsoWhereItCrops) {
  auto volume = test::volume_of<std::uint16_t>({60, 60, 60}, Vec3(0.1, 0.1, 0.15) * mm, {});
  test::add_ball(volume, Vec3(3, 3, 4.5), 2.5, 1);
  test::add_ball(volume, Vec3(3, 3, 4.5), 1.5, 2);
  for (const double voxel : {0.07, 0.1, 0.2, 0.3}) {
    EXPECT_TRUE(built(volume, {.voxel_size = voxel * mm}).said.empty()) << voxel;
    const Box half{Vec3(0, 0, 0), Vec3(3.01, 6, 9) * mm};
    EXPECT_TRUE(built(volume, {.voxel_size = voxel * mm, .crop = half}).said.empty()) << voxel;
  }
}

TEST(BuildFromLabels, SaysWhichMaterialHasNoLabels) {
  auto volume = test::volume_of<std::uint16_t>({20, 20, 20}, Vec3::Constant(0.1 * mm), {});
  test::add_ball(volume, Vec3(1, 1, 1), 0.7, 1);
  EXPECT_EQ(built(volume, {}).said, std::vector<std::string>{"no sample in use has a label of 'enamel'."});
}

TEST(BuildFromGrey, SaysWhichRangeNoVoxelHas) {
  auto volume = test::volume_of<float>({20, 20, 20}, Vec3::Constant(0.1 * mm), {});
  for (int i = 5; i < 15; ++i)
    for (int j = 5; j < 15; ++j)
      for (int k = 5; k < 15; ++k) volume.at(i, j, k) = 900;
  std::vector<std::string> said;
  VolumeBuildOptions options;
  options.warn = [&](const std::string& sentence) { said.push_back(sentence); };
  const auto build = [&](double dense) {
    const double infinity = std::numeric_limits<double>::infinity();
    (void)build_from_grey(volume, {{300, dense, named("dentin")}, {dense, infinity, named("enamel")}}, options);
  };
  build(2000);
  ASSERT_EQ(said.size(), 1U);
  test::expect_part(said[0],
                    "no voxel is 'enamel', grey values 2000 ... inf; those of the volume are 0 ... 900. Correct");
  said.clear();
  build(800);
  ASSERT_EQ(said.size(), 1U);
  test::expect_part(said[0], "no voxel is 'dentin', grey values 300 ... 800;");
}

TEST(BuildFromShells, SaysWhichLayerBetweenSurfacesIsTooThinForItsVoxels) {
  const auto said_of = [](double thickness) {
    std::vector<std::string> said;
    MeshImport options{.voxel_size = 0.1 * mm};
    options.warn = [&](const std::string& sentence) { said.push_back(sentence); };
    const std::vector<MeshShell> shells = {{test::ball_mesh(Vec3::Zero(), 3 * mm, 24), 2},
                                           {test::ball_mesh(Vec3::Zero(), 3 * mm - thickness, 24), 1}};
    (void)build_from_shells(shells, MaterialTable({named("dentin"), named("enamel")}), options);
    return said;
  };
  EXPECT_TRUE(said_of(0.5 * mm).empty());
  const std::vector<std::string> said = said_of(0.02 * mm);
  ASSERT_EQ(said.size(), 1U);
  test::expect_part(said[0], "voxels of 0.1 mm are too coarse for the surfaces: 'enamel' fills ");
  test::expect_part(said[0], "Choose smaller voxels.");
}

}  // namespace
}  // namespace hapticut::voxel_amounts_test
