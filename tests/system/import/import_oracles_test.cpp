// SPDX-License-Identifier: Apache-2.0
// Real files from other sources, compared with known facts about them.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "hapticut/build/volume_builders.hpp"
#include "hapticut/build/volume_operations.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/import/volume/volume_filters.hpp"
#include "hapticut/import/volume/volumes.hpp"
#include "support/named_material.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"
#include "support/test_data.hpp"

namespace hapticut::import_oracles_test {
namespace {

using test::data_path;
using test::named;
using units::mm;
using units::mm3;

TEST(ImportOracle, TwelveEncodingsOfTheBallGiveOneBall) {
  HAPTICUT_NEEDS_DATA("formats/BallBinary30x30x30.nrrd");
  const std::string stem = "formats/BallBinary30x30x30";
  const GreyVolume ball = read_grey_volume(data_path(stem + ".nrrd"));
  ASSERT_EQ(ball.dims, (std::array<int, 3>{30, 30, 30}));
  EXPECT_GT(std::count_if(ball.values.begin(), ball.values.end(), [](float v) { return v != 0; }), 1000);
  int same = 1;
  for (const char* extension :
       {".nhdr", ".nii.gz", "_byteskip_minus_five.nhdr", "_byteskip_minus_one.nhdr", "_byteskip_minus_one_nifti.nhdr",
        "_bz2.nrrd", "_gz.nrrd", "_gz_byteskip_minus_one.nrrd", "_gz_lineskip.nrrd", "_nifti.nhdr"}) {
    const GreyVolume other = read_grey_volume(data_path(stem + extension));
    EXPECT_EQ(other.values, ball.values) << extension;
    EXPECT_TRUE(other.spacing.isApprox(ball.spacing)) << extension;
    EXPECT_TRUE(other.X_WG.rotation.isApprox(ball.X_WG.rotation)) << extension;
    EXPECT_LT((other.X_WG.translation - ball.X_WG.translation).norm(), 1e-12) << extension;
    ++same;
  }
  const GreyVolume raw = read_raw_grey_volume(data_path(stem + ".raw"), {.dims = {30, 30, 30},
                                                                         .spacing = Vec3::Constant(1 * mm),
                                                                         .type = ValueType::int16,
                                                                         .big_endian = false,
                                                                         .skip = 0});
  EXPECT_EQ(raw.values, ball.values);
  EXPECT_EQ(same + 1, 12);
}

struct LabelledTooth {
  const char* file;
  double decay, enamel, dentin, pulp;  // [mm^3] as printed, rounded to the last digit
};

void PrintTo(const LabelledTooth& tooth, std::ostream* out) { *out << tooth.file; }

class LabelledToothVolumes : public testing::TestWithParam<LabelledTooth> {};

TEST_P(LabelledToothVolumes, AgreeWithItsDescription) {
  HAPTICUT_NEEDS_DATA(GetParam().file);
  const LabelVolume volume =
      read_label_volume(data_path(GetParam().file), {.spacing = Vec3::Constant(0.034 * mm), .dicom_series = {}});
  const Workpiece tooth =
      build_from_labels(volume, {{{1}, named("decay")}, {{2}, named("enamel")}, {{3}, named("dentin")}});
  const auto amounts = tooth.amounts();
  // Samples are counted exactly, so only the printed digits are uncertain: half of the last digit is at most 0.3 % of
  // the enamel, 0.1 % of the dentin, and 1.4 % of the small decay.
  EXPECT_NEAR(amounts[0].volume / mm3, GetParam().decay, 0.05);
  EXPECT_NEAR(amounts[1].volume / mm3, GetParam().enamel, 0.5);
  EXPECT_NEAR(amounts[2].volume / mm3, GetParam().dentin, 0.5);

  // The pulp is not labelled: closing by a ball of 0.8 mm diameter and filling cavities add it. The border between
  // chamber and root canals depends on the procedure, so the volume is known only to 20 %.
  constexpr double kProcedure = 0.2;
  LabelVolume solid = keep_largest_component(resample(crop_to_samples(volume, box_around(volume)), 0.068 * mm));
  constexpr std::uint16_t kPulp = 4;
  LabelVolume pulp = fill_cavities(close_gaps(std::move(solid), 0.4 * mm, kPulp), kPulp);
  for (std::uint16_t& label : pulp.values) label = label == kPulp ? kPulp : 0;
  pulp = keep_largest_component(std::move(pulp));
  const auto samples = std::count(pulp.values.begin(), pulp.values.end(), kPulp);
  EXPECT_NEAR(double(samples) * pulp.spacing.prod() / mm3 / GetParam().pulp, 1, kProcedure);
}

INSTANTIATE_TEST_SUITE_P(ImportOracle, LabelledToothVolumes,
                         testing::Values(LabelledTooth{"teeth/tooth_2.nii.gz", 6.4, 188, 512, 22},
                                         LabelledTooth{"teeth/tooth_3.nii.gz", 3.6, 113, 539, 26}));

TEST(ImportOracle, TheSkullHas475759VoxelsOfBone) {
  const std::filesystem::path project = "/usr/share/doc/invesalius-examples/examples/Cranium.inv3";
  if (!std::filesystem::exists(project)) GTEST_SKIP() << "needs the Debian package invesalius-examples";
  const GreyVolume skull = read_grey_volume(project);
  EXPECT_EQ(skull.dims, (std::array<int, 3>{256, 256, 108}));
  EXPECT_TRUE(skull.spacing.isApprox(Vec3(0.9570312, 0.9570312, 1.5) * mm, 1e-9));
  EXPECT_EQ(std::count_if(skull.values.begin(), skull.values.end(), [](float v) { return v >= 226; }), 475759);

  // Antialiased voxels of another size contain the same bone; interpolation changes thin walls by a few per cent.
  constexpr double kThinWalls = 0.03;
  const double threshold_volume = 475759 * skull.spacing.prod();
  const Workpiece bone = build_from_grey(skull, {{226, 1e9, named("bone")}}, {.voxel_size = 1 * mm});
  EXPECT_NEAR(bone.amounts()[0].volume / threshold_volume, 1, kThinWalls);
}

TEST(ImportOracle, DicomSpacingComesFromThePositionsOfTheSlices) {
  HAPTICUT_NEEDS_DATA("formats/example_ct_dicom");
  const GreyVolume ct = read_grey_volume(data_path("formats/example_ct_dicom"));
  EXPECT_EQ(ct.dims, (std::array<int, 3>{512, 512, 20}));
  EXPECT_NEAR(ct.spacing.z(), 2 * mm, 1e-9);  // SliceThickness says 3
  EXPECT_NEAR(ct.spacing.x(), 0.9765625 * mm, 1e-9);
  EXPECT_LT((ct.X_WG.translation - Vec3(-249.51171875, -437.51171875, -804.5) * mm).norm(), 1e-9);
  const auto [low, high] = std::minmax_element(ct.values.begin(), ct.values.end());
  EXPECT_LE(*low, -1000);  // air, which shows Hounsfield units
  EXPECT_GT(*high, 300);
}

TEST(ImportOracle, NiftiWithNegativeDirectionsKeepsItsPlace) {
  HAPTICUT_NEEDS_DATA("formats/example_ct_sm.nii.gz");
  const GreyVolume ct = read_grey_volume(data_path("formats/example_ct_sm.nii.gz"));
  const LabelVolume labels = read_label_volume(data_path("formats/example_seg.nii.gz"));
  EXPECT_EQ(ct.dims, (std::array<int, 3>{122, 101, 30}));
  EXPECT_EQ(labels.dims, ct.dims);
  EXPECT_TRUE(labels.X_WG.rotation.isApprox(ct.X_WG.rotation, 1e-9));
  EXPECT_LT((labels.X_WG.translation - ct.X_WG.translation).norm(), 1e-9);
  EXPECT_GT(ct.X_WG.rotation.determinant(), 0.999);
  // A rotation by 180 degrees about z: x and y decrease with the index.
  EXPECT_LT((ct.position(10, 20, 5) - (ct.position(0, 0, 0) + Vec3(-30, -60, 15) * mm)).norm(), 1e-9);
}

TEST(ImportOracle, ARotatedOrientationIsHonoured) {
  HAPTICUT_NEEDS_DATA("formats/tooth_closed.mhd");
  const GreyVolume tooth = read_grey_volume(data_path("formats/tooth_closed.mhd"));
  EXPECT_EQ(tooth.dims, (std::array<int, 3>{37, 50, 51}));
  // Position and rows of Orientation from the header: row n is the direction of axis n.
  const Vec3 position(-0.877558, -0.189605, -1.49145);
  const Vec3 axis[] = {
      {0.00284916, -0.222521, 0.974924}, {0.999388, -0.0333628, -0.0105355}, {0.0348705, 0.974357, 0.222289}};
  const VoxelIndex points[] = {{0, 0, 0}, {36, 0, 0}, {0, 49, 0}, {0, 0, 50}, {12, 33, 7}};
  for (const VoxelIndex& p : points) {
    const Vec3 expected = (position + 0.05 * (p[0] * axis[0] + p[1] * axis[1] + p[2] * axis[2])) * mm;
    // The header has six digits; the grid is 3 mm long.
    EXPECT_LT((tooth.position(p[0], p[1], p[2]) - expected).norm(), 1e-5 * mm);
  }
  // A signed distance, negative inside. The workpiece has the place of the samples.
  const Workpiece workpiece = build_from_grey(tooth, {{-1e9, 0, named("tooth")}}, {.antialias = false});
  ASSERT_FALSE(workpiece.empty());
  for (const VoxelIndex& p : points) {
    EXPECT_LT((workpiece.frame().center(p) - tooth.position(p[0], p[1], p[2])).norm(), 1e-12);
    EXPECT_EQ(workpiece.material_at(p) != kEmpty, tooth.at(p[0], p[1], p[2]) < 0);
  }
}

TEST(ImportOracle, FrogTissueHasItsLabels) {
  HAPTICUT_NEEDS_DATA("formats/frogtissue.mhd");
  const LabelVolume frog = read_label_volume(data_path("formats/frogtissue.mhd"));
  EXPECT_EQ(frog.dims, (std::array<int, 3>{500, 470, 136}));
  EXPECT_TRUE(frog.spacing.isApprox(Vec3(1, 1, 1.5) * mm));
  EXPECT_EQ(std::set<std::uint16_t>(frog.values.begin(), frog.values.end()).size(), 26U);
}

TEST(ImportOracle, TheHeaderlessToothScanHasItsPeaks) {
  HAPTICUT_NEEDS_DATA("teeth/tooth_103x94x161_uint8.raw");
  const LabelVolume scan = read_raw_label_volume(data_path("teeth/tooth_103x94x161_uint8.raw"),
                                                 {.dims = {103, 94, 161}, .spacing = Vec3::Constant(0.124 * mm)});
  std::array<int, 256> count{};
  for (const std::uint16_t grey : scan.values) ++count[grey];
  const auto peak = [&](int from, int to) {
    return int(std::max_element(count.begin() + from, count.begin() + to) - count.begin());
  };
  constexpr int kBin = 1;                  // precision of a peak in a histogram
  EXPECT_NEAR(peak(0, 54), 17, kBin);      // void
  EXPECT_NEAR(peak(54, 119), 78, kBin);    // mount
  EXPECT_NEAR(peak(119, 192), 162, kBin);  // dentin
  EXPECT_NEAR(peak(192, 256), 235, kBin);  // enamel
}

TEST(ImportOracle, HandSlicesAreInNumericOrder) {
  HAPTICUT_NEEDS_DATA("bone/hand_lowres");
  EXPECT_THROW((void)read_grey_volume(data_path("bone/hand_lowres")), Error);  // no spacing
  const GreyVolume hand =
      read_grey_volume(data_path("bone/hand_lowres"), {.spacing = Vec3::Constant(1 * mm), .dicom_series = {}});
  EXPECT_EQ(hand.dims, (std::array<int, 3>{256, 256, 320}));
  const auto cortical = std::count_if(hand.values.begin(), hand.values.end(), [](float v) { return v >= 150; });
  EXPECT_GT(cortical, 10000);
}

/// Mean number of pixels that change from slice to slice.
double change_between_slices(const LabelVolume& volume) {
  const std::size_t slice = std::size_t(volume.dims[0]) * std::size_t(volume.dims[1]);
  std::int64_t changes = 0;
  for (std::size_t n = slice; n < volume.values.size(); ++n) changes += volume.values[n] != volume.values[n - slice];
  return double(changes) / (volume.dims[2] - 1);
}

TEST(ImportOracle, MastoidSlicesAreInNumericOrderAndNoiseIsLeftOut) {
  HAPTICUT_NEEDS_DATA("bone/mastoid_RT143_256");
  const Vec3 spacing = Vec3::Constant(0.192 * mm);
  const LabelVolume bone = read_color_slices(data_path("bone/mastoid_RT143_256"), {{{255, 249, 219}, 1}}, spacing);
  EXPECT_EQ(bone.dims, (std::array<int, 3>{256, 256, 253}));
  EXPECT_EQ(std::count(bone.values.begin(), bone.values.end(), 1), 2777917);
  // In the right order neighbouring slices are similar; lexical order gives several times this number.
  EXPECT_LT(change_between_slices(bone), 1500);
  // (90, 116, 55) occurs only in pixels that are not fully opaque.
  EXPECT_THROW((void)read_color_slices(data_path("bone/mastoid_RT143_256"), {{{90, 116, 55}, 1}}, spacing), Error);
}

/// The error of reading a folder of links to some of the files of another folder.
template <class Keep>
std::string error_of_reading_part(const std::string& name, const Keep& keep) {
  const test::TemporaryFolder folder;
  for (const auto& entry : std::filesystem::directory_iterator(data_path(name)))
    if (const auto file = entry.path().filename(); keep(file.string()))
      std::filesystem::create_symlink(std::filesystem::absolute(entry.path()), folder / file.string());
  return test::refusal([&] { return read_grey_volume(folder / "", {.spacing = Vec3::Constant(1 * mm)}); });
}

TEST(ImportOracle, AMissingSliceIsNoticed) {
  HAPTICUT_NEEDS_DATA("bone/hand_lowres");
  const auto few = [](const std::string& name) { return name < "hand0009.png"; };
  EXPECT_EQ(error_of_reading_part("bone/hand_lowres", few), "");
  const auto gap = [&](const std::string& name) { return few(name) && name != "hand0005.png"; };
  test::expect_part(error_of_reading_part("bone/hand_lowres", gap), "hand0006.png");
  const auto missing = [](const std::string& name) { return !name.ends_with("16580"); };
  test::expect_part(error_of_reading_part("formats/example_ct_dicom", missing), "evenly spaced");
}

TEST(ImportOracle, AFourthAxisOfOneSampleIsRead) {
  HAPTICUT_NEEDS_DATA("formats/test_simple4d_raw.nrrd");
  const GreyVolume volume = read_grey_volume(data_path("formats/test_simple4d_raw.nrrd"));
  EXPECT_EQ(volume.dims, (std::array<int, 3>{1, 1, 1}));
  EXPECT_TRUE(volume.spacing.isApprox(Vec3(1.5, 1.5, 1) * mm));
}

class HostileVolume : public testing::TestWithParam<const char*> {};

TEST_P(HostileVolume, IsRefusedWithAReasonThatNamesIt) {
  HAPTICUT_NEEDS_DATA(GetParam());
  const std::string refusal = test::refusal([&] { return read_grey_volume(data_path(GetParam())); });
  for (const char* part : {GetParam(), "dimensions"}) test::expect_part(refusal, part);
}

INSTANTIATE_TEST_SUITE_P(ImportOracle, HostileVolume,
                         testing::Values("formats/test1d_ascii.nrrd", "formats/test2d_ascii.nrrd",
                                         "formats/test_customFields.nrrd"));

}  // namespace
}  // namespace hapticut::import_oracles_test
