// SPDX-License-Identifier: Apache-2.0
// Positions of frames and slices: order, distance, and missing ones.
#include <gtest/gtest.h>

#include <numeric>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/import/volume/volumes.hpp"
#include "support/dicom_files.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace hapticut::dicom_stack_test {
namespace {

using test::DicomElements;
using test::expect_part;
using units::mm;

constexpr std::uint32_t kPosition = 0x00200032, kOrientation = 0x00200037;

/// A file with frames of one sample at given heights [mm]. The value of a frame is its height in hundredths, stored
/// with a different intercept per frame.
DicomElements frames_at(const std::vector<double>& heights, bool implicit = false) {
  std::vector<std::int16_t> values;
  std::vector<DicomElements> frames;
  for (std::size_t n = 0; n < heights.size(); ++n) {
    DicomElements position, scale, frame;
    position.set(kPosition, "DS", test::dicom_numbers(10, 20, heights[n]));
    scale.set(0x00281052, "DS", std::to_string(n)).set(0x00281053, "DS", "1");
    frame.set_items(0x00209113, {position}, implicit).set_items(0x00289145, {scale}, implicit);
    frames.push_back(frame);
    values.push_back(std::int16_t(std::lround(100 * heights[n]) - std::int64_t(n)));
  }
  DicomElements e = test::dicom_picture(1, 1, values);
  return e.set(0x00280008, "IS", std::to_string(heights.size())).set_items(0x52009230, frames, implicit);
}

GreyVolume read(const DicomElements& elements, const VolumeReadOptions& options = {},
                const std::string& syntax = "1.2.840.10008.1.2.1") {
  const test::TemporaryFolder folder;
  test::write_bytes(folder / "a.dcm", test::dicom_file(elements, syntax));
  return read_grey_volume(folder / "a.dcm", options);
}

std::string error_of(const DicomElements& elements) {
  return test::refusal([&] { return read(elements); });
}

TEST(DicomFrames, AreSortedByPlaceWithTheirValuesAndScales) {
  for (const std::vector<double>& heights :
       {std::vector<double>{0, 0.5, 1, 1.5}, {1.5, 1, 0.5, 0}, {1, 0, 1.5, 0.5}, {0.5, 1.5, 0, 1}}) {
    const GreyVolume volume = read(frames_at(heights));
    EXPECT_EQ(volume.values, (std::vector<float>{0, 50, 100, 150}));
    EXPECT_NEAR(volume.spacing.z(), 0.5 * mm, 1e-12);
    EXPECT_LT((volume.position(0, 0, 3) - Vec3(10, 20, 1.5) * mm).norm(), 1e-12);
  }
}

TEST(DicomFrames, OfAFileThatNamesNoKindsOfElementsArePlacedByThem) {
  DicomElements e = frames_at({1, 0, 0.5}, true);
  for (const char* syntax : {"1.2.840.10008.1.2", "1.2.840.10008.1.2.1"}) {
    const GreyVolume volume = read(e, {}, syntax);
    EXPECT_EQ(volume.values, (std::vector<float>{0, 50, 100})) << syntax;
    EXPECT_LT((volume.position(0, 0, 0) - Vec3(10, 20, 0) * mm).norm(), 1e-12);
    e.values[0x52009230].first = "UN";  // as stored by an archive that does not know the tag
  }
}

TEST(DicomFrames, OfAnEnhancedFileWithoutFunctionalGroupsGetNoPlaceByASpacing) {
  DicomElements e = test::dicom_picture(1, 1, {1, 2});
  e.set(0x00280008, "IS", "2").set(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.2.1");
  EXPECT_THROW((void)read(e, {.spacing = Vec3(1, 2, 3) * mm}), Error);
  expect_part(error_of(e), "it lacks the functional groups");
}

TEST(DicomFrames, ThatAreMissingOrThereTwiceAreNamed) {
  expect_part(error_of(frames_at({2, 0, 0.5, 1})), "frame 4 and frame 1 are 1 mm apart, the others 0.5 mm");
  expect_part(error_of(frames_at({0, 1, 0.5, 1.5, 0.5})), "frame 3 and frame 5 are at the same place");
  expect_part(error_of(frames_at({0, 0.5, 1.2, 1.7})), "frame 2 and frame 3 are 0.7 mm apart, the others 0.5 mm");
  expect_part(error_of(frames_at({3, 3})), "frame 1 and frame 2 are at the same place");
}

TEST(DicomFrames, OfWhichNotAllSayWhereTheyLieAreRefused) {
  DicomElements e = frames_at({0, 0.5, 1});
  e.set(0x00280008, "IS", "4").set(0x7fe00010, "OW", test::little(std::vector<std::int16_t>(4)));
  expect_part(error_of(e), "only 3 of its 4 frames have a position");
}

TEST(DicomFrames, InDifferentDirectionsAreRefused) {
  DicomElements e = test::dicom_picture(1, 1, {1, 2});
  std::vector<DicomElements> frames;
  for (const char* orientation : {"1\\0\\0\\0\\1\\0", "1\\0\\0\\0\\0\\1"}) {
    DicomElements plane, frame;
    plane.set(kOrientation, "DS", orientation);
    frames.push_back(frame.set_items(0x00209116, {plane}));
  }
  expect_part(error_of(e.set(0x00280008, "IS", "2").set_items(0x52009230, frames)), "different directions");
}

TEST(DicomFrames, WithoutPositionsAreNotAsFarApartAsTheyAreThick) {
  DicomElements e = test::dicom_picture(1, 1, {1, 2, 3});
  e.set(0x00280008, "IS", "3").set(0x00180050, "DS", "0.9");
  expect_part(error_of(e), "it lacks the spacing of its samples (0.1 x 0.2 x 0 mm); set Vol");
  EXPECT_NEAR(read(e, {.spacing = Vec3(1, 2, 3) * mm}).spacing.z(), 3 * mm, 1e-12);
  EXPECT_NEAR(read(e.set(0x00180088, "DS", "0.5")).spacing.z(), 0.5 * mm, 1e-12);
}

// PS3.3 0018,0088: a negative distance stacks the frames against the normal, from the position downwards.
TEST(DicomFrames, WithANegativeDistanceAreStackedDownwards) {
  DicomElements e = test::dicom_picture(1, 1, {1, 2, 3});
  e.set(0x00280008, "IS", "3").set(0x00180088, "DS", "-0.5").set(kOrientation, "DS", "1\\0\\0\\0\\1\\0");
  e.set(kPosition, "DS", "10\\20\\30");
  for (const VolumeReadOptions& options : {VolumeReadOptions{}, {.spacing = Vec3(0.1, 0.2, 0.5) * mm}}) {
    const GreyVolume volume = read(e, options);
    EXPECT_NEAR(volume.spacing.z(), 0.5 * mm, 1e-12);
    for (int k = 0; k < 3; ++k) {
      const double frame = double(volume.at(0, 0, k)) + 1000 - 1;
      EXPECT_LT((volume.position(0, 0, k) - Vec3(10, 20, 30 - 0.5 * frame) * mm).norm(), 1e-12) << k;
    }
  }
}

// PS3.3 C.8.8.3.2: offsets that begin with the height of the first frame are heights, whatever the normal.
TEST(DicomFrames, OfADoseAreAtDistancesOrHeights) {
  DicomElements e = test::dicom_picture(1, 1, {1, 2, 3});
  e.set(0x00280008, "IS", "3").set(kPosition, "DS", "10\\20\\30").set(kOrientation, "DS", "1\\0\\0\\0\\-1\\0");
  const std::pair<const char*, double> cases[] = {{"0\\1\\2", -1},  // along the normal, which points down
                                                  {"0\\-1\\-2", 1},
                                                  {"30\\31\\32", 1},
                                                  {"30\\29\\28", -1}};
  for (const auto& [offsets, upwards] : cases) {
    const GreyVolume volume = read(e.set(0x3004000c, "DS", offsets));
    for (int k = 0; k < 3; ++k) {
      const double frame = double(volume.at(0, 0, k)) + 1000 - 1;
      EXPECT_LT((volume.position(0, 0, k) - Vec3(10, 20, 30 + upwards * frame) * mm).norm(), 1e-12) << offsets;
    }
  }
}

TEST(DicomFrames, WithoutAnOrientationAreTakenForAxialAndRemarkedUnlessTheirPositionsDisagree) {
  const std::vector<std::string> remarks = read(frames_at({0, 0.5, 1})).remarks;
  ASSERT_EQ(remarks.size(), 1U);
  expect_part(remarks[0], "does not say how its axes lie in the patient; they are taken for left, back and head");
  DicomElements e = test::dicom_picture(1, 1, {1, 2});
  std::vector<DicomElements> frames;
  for (const char* place : {"0\\0\\0", "0\\0.5\\0"}) {
    DicomElements position, frame;
    frames.push_back(frame.set_items(0x00209113, {position.set(kPosition, "DS", place)}));
  }
  expect_part(error_of(e.set(0x00280008, "IS", "2").set_items(0x52009230, frames)),
              "it lacks the orientation of its frames (Image Orientation), and their positions show");
  EXPECT_TRUE(read(e.set(kOrientation, "DS", "0\\0\\1\\1\\0\\0")).remarks.empty());
}

/// Slices at given positions, named s0, s1, ...
class DicomSlices : public testing::Test {
 protected:
  void write(const std::vector<Vec3>& places, const std::string& orientation = "1\\0\\0\\0\\1\\0") {
    for (std::size_t n = 0; n < places.size(); ++n) {
      DicomElements e = test::dicom_slice(1, 1, 0, {std::int16_t(n)});
      e.set(kOrientation, "DS", orientation);
      e.set(kPosition, "DS", test::dicom_numbers(places[n].x(), places[n].y(), places[n].z()));
      test::write_bytes(folder_ / test::slice_name(n), test::dicom_file(e));
    }
  }
  void write_heights(const std::vector<double>& heights) {
    std::vector<Vec3> places;
    for (const double height : heights) places.emplace_back(0, 0, height);
    write(places);
  }
  void expect_refused(const std::string& part) {
    test::expect_refused([&] { return read_grey_volume(folder_ / ""); }, part);
  }

  test::TemporaryFolder folder_;
};

TEST_F(DicomSlices, ThatAreMissingFarAwayOrThereTwiceAreNamed) {
  const std::pair<std::vector<double>, const char*> series[] = {
      {{0, 0.5, 1, 1.5, 2.5, 3, 3.5, 4, 4.5, 5},
       "'s3' and 's4' are 1 mm apart, the others 0.5 mm; planes between them are missing"},
      {{0, 1, 1.5, 2}, "'s0' and 's1' are 1 mm apart, the others 0.5 mm"},
      {{0, 0.5, 1, 1, 1.5, 2}, "'s2' and 's3' are at the same place; one is a duplicate"},
      {{0, 0.01, 0.02, 0.04, 0.05}, "'s2' and 's3' are 0.02 mm apart, the others 0.01 mm"}};  // a micro scanner
  for (const auto& [heights, part] : series) {
    for (int n = 0; n < 10; ++n) std::filesystem::remove(folder_ / test::slice_name(n));
    write_heights(heights);
    expect_refused(part);
  }
}

TEST_F(DicomSlices, WithPositionsRoundedToHundredthsAreRead) {
  std::vector<double> heights;
  for (int n = 0; n < 40; ++n) heights.push_back(std::round(100 * 0.625 * n) / 100);
  write_heights(heights);
  EXPECT_NEAR(read_grey_volume(folder_ / "").spacing.z(), 0.625 * mm, 1e-3 * mm);
}

// Directions with three digits cause an error of a millimetre over a long series; positions do not.
TEST_F(DicomSlices, WithDirectionsRoundedToThreeDigitsLieWhereTheirPositionsSay) {
  const Mat3 turn = rotation_from_vector({0.3, -0.2, 0.5});
  const auto place = [&](int n) { return Vec3(turn * Vec3(0, 0, 0.5 * n)); };
  std::vector<Vec3> places;
  for (int n = 0; n < 100; ++n) places.push_back(place(n));
  char orientation[96];
  std::snprintf(orientation, sizeof orientation, "%.3f\\%.3f\\%.3f\\%.3f\\%.3f\\%.3f", turn(0, 0), turn(1, 0),
                turn(2, 0), turn(0, 1), turn(1, 1), turn(2, 1));
  write(places, orientation);
  const GreyVolume volume = read_grey_volume(folder_ / "");
  EXPECT_LT((volume.position(0, 0, 99) - place(99) * mm).norm(), 0.02 * mm);
  EXPECT_TRUE(volume.X_WG.rotation.isApprox(turn, 2e-3));
}

TEST_F(DicomSlices, OfATiltedGantryAreRefused) {
  std::vector<Vec3> places;
  for (int n = 0; n < 20; ++n) places.emplace_back(0, 0.5 * std::tan(1 * units::deg) * n, 0.5 * n);
  write(places);
  expect_refused("tilted gantry");
}

TEST_F(DicomSlices, OfWhichOneIsShiftedAreRefused) {
  write({{0, 0, 0}, {0, 0, 0.5}, {0, 0.2, 1}, {0, 0, 1.5}});
  expect_refused("shifted against each other at 's2'");
}

TEST_F(DicomSlices, WithDecimalCommasAreRefusedBySayingSo) {
  const DicomElements e = test::dicom_slice(1, 1, 0, {1}).set(0x00280030, "DS", "0,3\\0,3");
  test::write_bytes(folder_ / "s0", test::dicom_file(e));
  expect_refused("there must be 2 numbers, with decimal points");
}

TEST_F(DicomSlices, WithoutAPlaceAreRefused) {
  DicomElements e = test::dicom_slice(1, 1, 0, {1});
  e.values.erase(kPosition);
  test::write_bytes(folder_ / "s0", test::dicom_file(e));
  test::write_bytes(folder_ / "s1", test::dicom_file(e));
  expect_refused("it has no position");
  expect_refused("Export the series with positions, or save it in one NRRD");
}

}  // namespace
}  // namespace hapticut::dicom_stack_test
