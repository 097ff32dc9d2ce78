// SPDX-License-Identifier: Apache-2.0
// Headers of NRRD, MetaImage and NIfTI with missing, rounded or additional information.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numeric>

#include "hapticut/core/units.hpp"
#include "hapticut/import/volume/volumes.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"
#include "support/volume_files.hpp"
#include "support/volumes.hpp"

namespace hapticut::volume_headers_test {
namespace {

using units::mm;

const std::string kNrrd = "NRRD0005\ntype: uchar\nencoding: raw\n";
const std::string kMeta = "ObjectType = Image\nElementType = MET_UCHAR\n";
const std::string kMeta3 = kMeta + "NDims = 3\nDimSize = 4 3 5\n";
const std::string kLocal = "ElementDataFile = LOCAL\n";

std::string ramp() {
  std::string bytes(60, '\0');
  std::iota(bytes.begin(), bytes.end(), 1);
  return bytes;
}

GreyVolume read(const std::string& name, const std::string& bytes, const VolumeReadOptions& options = {}) {
  const test::TemporaryFolder folder;
  test::write_bytes(folder / name, bytes);
  test::write_bytes(folder / "v.raw", ramp());
  return read_grey_volume(folder / name, options);
}
GreyVolume read_nrrd(const std::string& fields) { return read("v.nrrd", kNrrd + fields + "\n" + ramp()); }
GreyVolume read_meta(const std::string& fields) { return read("v.mha", fields + kLocal + ramp()); }

void expect_refused(const std::string& name, const std::string& bytes, const std::string& part) {
  SCOPED_TRACE(bytes.substr(0, 300));
  test::expect_refused([&] { return read(name, bytes); }, part);
}
void expect_meta_refusal(const std::string& fields, const std::string& part) {
  expect_refused("v.mha", fields + kLocal + ramp(), part);
}
void expect_nrrd_refusal(const std::string& fields, const std::string& part) {
  expect_refused("v.nrrd", kNrrd + fields + "\n" + ramp(), part);
}

void expect_ramp(const GreyVolume& volume) {
  ASSERT_EQ(volume.dims, (std::array<int, 3>{4, 3, 5}));
  EXPECT_TRUE(volume.spacing.isApprox(Vec3(0.1, 0.2, 0.7) * mm, 1e-9)) << volume.spacing.transpose();
  EXPECT_EQ(volume.at(1, 2, 3), 1 + 1 + 4 * (2 + 3 * 3));
}

TEST(VolumeHeader, WithoutASpacingIsRefusedUnlessTheCallerGivesOne) {
  const std::string none = "dimension: 3\nsizes: 4 3 5\n";
  const std::pair<const char*, std::string> files[] = {
      {"v.nrrd", kNrrd + none + "\n" + ramp()},
      {"v.nrrd", kNrrd + none + "spacings: nan nan nan\naxis mins: 1 2 3\n\n" + ramp()},
      {"v.nrrd", kNrrd + none + "spacings: 0.1 nan 0.7\n\n" + ramp()},
      {"v.nrrd", kNrrd + none + "spacings: 0 0 0\n\n" + ramp()},
      {"v.nrrd", kNrrd + none + "thicknesses: 1 1 1\nunits: \"mm\" \"mm\" \"mm\"\n\n" + ramp()},
      {"v.mha", kMeta3 + kLocal + ramp()},
      {"v.mha", kMeta3 + "ElementSpacing = 0 0 0\n" + kLocal + ramp()},
      {"v.mha", kMeta3 + "ElementSpacing = 1 nan 1\n" + kLocal + ramp()},
      {"v.mhd", kMeta3 + "ElementDataFile = v.raw\n"}};
  for (const auto& [name, bytes] : files) {
    expect_refused(name, bytes, "lacks the spacing of its samples");
    expect_refused(name, bytes, "; set VolumeReadOptions::spacing.");
    expect_ramp(read(name, bytes, {.spacing = Vec3(0.1, 0.2, 0.7) * mm}));
  }
  test::NiftiFile nifti;
  nifti.spacing = {0, 0, 0};
  nifti.values.resize(60);
  expect_refused("v.nii", nifti.bytes(), "; set VolumeReadOptions::spacing.");
}

// The first sample stays where it is, and the axis runs the other way.
TEST(VolumeHeader, WithANegativeSpacingHasAnAxisThatRunsTheOtherWay) {
  const std::string meta = kMeta3 + "ElementSpacing = 0.1 -0.2 0.7\nOffset = 1 2 3\n" + kLocal + ramp();
  const std::string nrrd =
      kNrrd + "dimension: 3\nsizes: 4 3 5\nspacings: 0.1 -0.2 0.7\naxis mins: 0.95 2.1 2.65\n\n" + ramp();
  const VolumeReadOptions spaced = {.spacing = Vec3(0.1, 0.2, 0.7) * mm};
  for (const auto& file : {std::pair("v.mha", meta), std::pair("v.nrrd", nrrd)})
    for (const VolumeReadOptions& options : {VolumeReadOptions{}, spaced}) {
      const std::string name = file.first;
      const GreyVolume volume = read(name, file.second, options);
      EXPECT_TRUE(volume.spacing.isApprox(Vec3(0.1, 0.2, 0.7) * mm, 1e-9));
      EXPECT_TRUE(is_rotation(volume.X_WG.rotation, 1e-9)) << name;
      test::for_each_sample(volume, [&](int i, int j, int k) {  // sample n of the file has the value n + 1
        const int n = int(volume.at(i, j, k)) - 1;
        const Vec3 place(1 + 0.1 * (n % 4), 2 - 0.2 * (n / 4 % 3), 3 + 0.7 * (n / 12));
        EXPECT_LT((volume.position(i, j, k) - place * mm).norm(), 1e-9) << name << ", sample " << n;
      });
    }
}

TEST(VolumeHeader, WithoutTheDirectionsOfThePatientIsRemarked) {
  test::NiftiFile nifti;
  nifti.values.resize(60);
  const GreyVolume volume = read("v.nii", nifti.bytes());
  ASSERT_EQ(volume.remarks.size(), 1U);
  test::expect_part(volume.remarks[0], "does not say how its axes lie in the patient");
  nifti.rows = {0.1F, 0, 0, 0, 0, 0.2F, 0, 0, 0, 0, 0.7F, 0};
  EXPECT_TRUE(read("v.nii", nifti.bytes()).remarks.empty());
}

TEST(LabelVolumes, OfValuesNearAWholeNumberAreRead) {
  const auto label = [](float value) {
    const test::TemporaryFolder folder;
    std::string bytes;
    for (int n = 0; n < 60; ++n) bytes += test::little(n == 0 ? value : 3.0F);
    test::write_bytes(folder / "v.nrrd",
                      "NRRD0005\ntype: float\nendian: little\nencoding: raw\ndimension: 3\nsizes: 4 3 5\n"
                      "spacings: 1 1 1\n\n" +
                          bytes);
    return read_label_volume(folder / "v.nrrd").values[0];
  };
  EXPECT_EQ(label(2.0000002F), 2);
  EXPECT_EQ(label(1.9999999F), 2);
  EXPECT_EQ(label(0.988F + 0.003F), 1);  // from labels that were scaled to 8 bits
  EXPECT_EQ(label(65534.996F), 65535);
  EXPECT_EQ(label(-1e-7F), 0);
  test::expect_refused([&] { return label(2.0118F); }, "it has the value 2.0118, but labels");
  test::expect_refused([&] { return label(-0.5F); }, "it has the value -0.5, but labels");
  test::expect_refused([&] { return label(65536); }, "it has the value 65536, but labels");
}

TEST(Nrrd, KnowsUnitsByTheirUsualNames) {
  const std::pair<const char*, double> names[] = {
      {"um", 1e-3},        {"micron", 1e-3},    {"Microns", 1e-3},  {"micrometer", 1e-3}, {"Micrometres", 1e-3},
      {"\xc2\xb5m", 1e-3}, {"\xce\xbcm", 1e-3}, {"\xb5m", 1e-3},    {"nanometers", 1e-6}, {"", 1},
      {"MM", 1},           {"millimetre", 1},   {"Millimeters", 1}, {"cm", 10},           {"centimetres", 10},
      {"Meter", 1e3},      {"metres", 1e3}};
  for (const auto& [name, mm_long] : names) {
    const std::string x = std::to_string(0.1 / mm_long), y = std::to_string(0.2 / mm_long),
                      z = std::to_string(0.7 / mm_long), quoted = std::string(" \"") + name + "\"";
    SCOPED_TRACE(name);
    expect_ramp(read_nrrd("dimension: 3\nsizes: 4 3 5\nspacings: " + x + " " + y + " " + z + "\nunits:" + quoted +
                          quoted + quoted + "\n"));
    expect_ramp(read_nrrd("dimension: 3\nspace: LPS\nsizes: 4 3 5\nspace directions: (" + x + ",0,0) (0," + y +
                          ",0) (0,0," + z + ")\nspace units:" + quoted + quoted + quoted + "\n"));
  }
  expect_ramp(read_nrrd("dimension: 3\nsizes: 4 3 5\nspacings: 100 200 700\nunits: um um um\n"));
}

TEST(Nrrd, OfAUnitThatIsNotKnownIsRefusedUnlessTheCallerGivesASpacing) {
  const std::string file = kNrrd +
                           "dimension: 3\nspace: LPS\nsizes: 4 3 5\nspace directions: (1,0,0) (0,2,0) (0,0,7)\n"
                           "space origin: (10,20,30)\nspace units: \"parsec\" \"parsec\" \"parsec\"\n\n" +
                           ramp();
  expect_refused("v.nrrd", file,
                 "its unit 'parsec' is not known; write m, cm, mm, um or nm into its header, or set "
                 "VolumeReadOptions::spacing.");
  const GreyVolume volume = read("v.nrrd", file, {.spacing = Vec3(0.1, 0.2, 0.7) * mm});
  expect_ramp(volume);
  EXPECT_LT((volume.position(0, 0, 0) - Vec3(1, 2, 3) * mm).norm(), 1e-12);
}

TEST(Nrrd, OfASpaceThatDoesNotSayWhereThePatientIsIsRefused) {
  for (const char* space : {"3D-left-handed", "3D-right-handed", "scanner-xyz"})
    expect_nrrd_refusal(
        std::string("dimension: 3\nspace: ") + space + "\nsizes: 4 3 5\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n",
        "left-anterior-superior into its header");
}

TEST(Nrrd, WithAnAxisThatIsNoneOfSpaceIsRefused) {
  for (const char* kinds : {"RGB-color domain domain", "3-vector space space", "domain domain list"})
    expect_nrrd_refusal("dimension: 3\nsizes: 4 3 5\nspacings: 1 1 1\nkinds: " + std::string(kinds) + "\n",
                        "so it is not an axis of a volume");
  expect_ramp(read_nrrd("dimension: 3\nsizes: 4 3 5\nspacings: 0.1 0.2 0.7\nkinds: domain space ???\n"));
}

// A hand-written header for values in a separate file: 16-bit type, or one slice missing.
TEST(VolumeHeader, WithFewerSamplesThanTheFileIsRefused) {
  const std::string detached = "dimension: 3\nspacings: 1 1 1\ndata file: v.raw\n";
  expect_refused("v.nhdr", kNrrd + detached + "sizes: 4 3 4\n",
                 "its header claims 48 bytes of data, but there are 60. Check the type and the sizes");
  expect_ramp(read("v.nrrd", kNrrd + "dimension: 3\nsizes: 4 3 5\nspacings: 0.1 0.2 0.7\n\n" + ramp() + "\n"));
  expect_refused("v.mhd", kMeta + "NDims = 3\nDimSize = 4 3 4\nElementSpacing = 1 1 1\nElementDataFile = v.raw\n",
                 "but there are 60");
  EXPECT_EQ(read("v.mhd", kMeta + "NDims = 3\nDimSize = 4 3 4\nElementSpacing = 1 1 1\nHeaderSize = -1\n"
                                  "ElementDataFile = v.raw\n")
                .at(0, 0, 0),
            13)
      << "HeaderSize = -1 asks for the last values of the file";
}

TEST(Nifti, AnOffsetWithinTheHeaderMeansThatTheValuesFollowIt) {
  test::NiftiFile file;
  file.values.resize(60);
  file.values[0] = 7;
  const GreyVolume right = read("v.nii", file.bytes());
  for (const float offset : {0.0F, 348.0F}) {
    std::string bytes = file.bytes();
    std::memcpy(bytes.data() + 108, &offset, sizeof offset);
    EXPECT_EQ(read("v.nii", bytes).values, right.values) << offset;
  }
}

TEST(Nifti, WithAMapOfZerosIsPlacedByItsQuaternion) {
  test::NiftiFile file;
  file.values.resize(60);
  file.rows.resize(12);
  file.quaternion = {0, 0, 0, 1, 2, 3};
  const GreyVolume volume = read("v.nii", file.bytes());
  EXPECT_TRUE(volume.spacing.isApprox(Vec3(0.1, 0.2, 0.7) * mm, 1e-6)) << volume.spacing.transpose();
  EXPECT_LT((volume.position(0, 0, 0) - Vec3(-1, -2, 3) * mm).norm(), 1e-9);
}

TEST(MetaImage, OfATypeThatIsNotReadSaysWhichAre) {
  expect_meta_refusal(kMeta3 + "ElementType = MET_LONG\n", "save them as MET_SHORT");
}

TEST(MetaImage, TakesTheSizeOfItsElementsWhereItNamesNoSpacing) {
  expect_ramp(read_meta(kMeta3 + "ElementSize = 0.1 0.2 0.7\n"));
  expect_ramp(read_meta(kMeta3 + "ElementSize = 9 9 9\nElementSpacing = 0.1 0.2 0.7\n"));
}

TEST(MetaImage, HasTheUnitThatItNamesAndNoScaleOfItsValues) {
  expect_ramp(read_meta(kMeta3 + "DistanceUnits = um\nElementSpacing = 100 200 700\n"));
  expect_ramp(read_meta(kMeta3 + "DistanceUnits = cm\nElementSpacing = 0.01 0.02 0.07\n"));
  const std::string spaced = kMeta3 + "ElementSpacing = 0.1 0.2 0.7\n";
  expect_ramp(read_meta(spaced + "ElementToIntensityFunctionSlope = 1\nElementToIntensityFunctionOffset = 0\n"));
  expect_meta_refusal(spaced + "DistanceUnits = inch\n", "must be mm, um, cm or m");
  expect_meta_refusal(spaced + "ElementToIntensityFunctionSlope = 2\n", "have a scale");
}

TEST(VolumeHeader, WithOtherAxesOfOneSampleIsAVolume) {
  expect_ramp(read_meta(kMeta + "NDims = 4\nDimSize = 4 3 5 1\nElementSpacing = 0.1 0.2 0.7 1\nOffset = 0 0 0 7\n"
                                "TransformMatrix = 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n"));
  expect_ramp(
      read_nrrd("dimension: 4\nsizes: 4 3 5 1\nspacings: 0.1 0.2 0.7 nan\nunits: \"mm\" \"mm\" \"mm\" \"um\"\n"));
  expect_ramp(read_nrrd("dimension: 4\nsizes: 1 4 3 5\nspacings: nan 0.1 0.2 0.7\n"));
  expect_ramp(read_nrrd("dimension: 5\nsizes: 1 4 3 5 1\nspacings: 1 0.1 0.2 0.7 1\n"));
  expect_ramp(
      read_nrrd("dimension: 4\nspace: LPS\nsizes: 1 4 3 5\n"
                "space directions: none (0.1,0,0) (0,0.2,0) (0,0,0.7)\nspace origin: (1,2,3)\n"));
  const GreyVolume timed = read_nrrd(
      "dimension: 4\nspace: right-anterior-superior-time\nsizes: 4 3 5 1\n"
      "space directions: (0.1,0,0,0) (0,0.2,0,0) (0,0,0.7,0) (0,0,0,1)\nspace origin: (1,2,3,9)\n");
  expect_ramp(timed);
  EXPECT_LT((timed.position(0, 0, 0) - Vec3(-1, -2, 3) * mm).norm(), 1e-12);
}

TEST(VolumeHeader, WithALongerFourthAxisIsRefused) {
  expect_meta_refusal(kMeta + "NDims = 4\nDimSize = 4 3 1 5\nElementSpacing = 1 1 1 1\n", "extract one volume");
  expect_nrrd_refusal("dimension: 4\nsizes: 2 3 2 5\nspacings: 1 1 1 1\n", "Extract one volume");
  expect_nrrd_refusal("dimension: 2\nsizes: 12 5\nspacings: 1 1\n", "a volume has three");
}

TEST(MetaImage, SkipsUnknownKeysOfAnyNumberAndLength) {
  std::string keys = "\nComment = " + std::string(5000, 'x') + "\nPatient = M\xc3\xbcller\nNote: none\n";
  for (int n = 0; n < 5000; ++n) keys.append("Seq_Frame").append(std::to_string(n)).append("_ImageStatus = OK\n");
  expect_ramp(read_meta(kMeta3 + "ElementSpacing = 0.1 0.2 0.7\n" + keys));
  while (keys.size() < 1U << 20U) keys += keys;
  expect_meta_refusal(kMeta3 + keys, "its header is longer than");
}

TEST(MetaImage, ReadsFieldsAfterTheNameOfItsDataFile) {
  const std::string header = kMeta3 + "ElementDataFile = v.raw\n";
  expect_ramp(read("v.mhd", header + "ElementSpacing = 0.1 0.2 0.7\n\n"));
  expect_refused("v.mhd", header + "ElementSpacing = 0.1 0.2 0.7\nabc\n", "damaged at 'abc'");
}

/// Rounded directions of a rotated grid, times a length, with or without brackets.
std::string rounded_directions(const Mat3& turn, const Vec3& lengths, const char* between, const char* open,
                               const char* close) {
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    text += open;
    for (int row = 0; row < 3; ++row) {
      char number[32];
      std::snprintf(number, sizeof number, "%s%.3f", row > 0 ? between : "", turn(row, axis) * lengths[axis]);
      text += number;
    }
    text += close;
  }
  return text;
}

TEST(VolumeHeader, WithDirectionsOfThreeDigitsIsRead) {
  for (int n = 0; n < 50; ++n) {
    const Mat3 turn = rotation_from_vector({std::sin(n * 1.0), std::sin(n * 2.3), std::sin(n * 3.1)});
    const GreyVolume meta = read_meta(kMeta3 + "ElementSpacing = 0.3 0.3 0.5\nTransformMatrix = " +
                                      rounded_directions(turn, Vec3::Ones(), " ", " ", "") + "\n");
    const GreyVolume nrrd = read_nrrd("dimension: 3\nspace: LPS\nsizes: 4 3 5\nspace directions: " +
                                      rounded_directions(turn, Vec3(0.3, 0.3, 0.5), ",", "(", ") ") + "\n");
    EXPECT_LT((meta.X_WG.rotation - turn).cwiseAbs().maxCoeff(), 2e-3) << n;
    EXPECT_LT((nrrd.X_WG.rotation - turn).cwiseAbs().maxCoeff(), 6e-3) << n;
    EXPECT_TRUE(is_rotation(nrrd.X_WG.rotation, 1e-9)) << n;
    test::NiftiFile nifti;
    nifti.values.resize(60);
    for (int row = 0; row < 3; ++row) {
      for (int axis = 0; axis < 3; ++axis) nifti.rows.push_back(float(std::round(turn(row, axis) * 300) / 1000));
      nifti.rows.push_back(0);
    }
    EXPECT_TRUE(is_rotation(read("v.nii", nifti.bytes()).X_WG.rotation, 1e-9)) << n;
  }
}

TEST(VolumeHeader, WithShearedDirectionsIsRefused) {
  for (const char* sheared : {"1 0 0 0.0175 1 0 0 0 1", "1 0 0 0 1 0 0 0.01 1"})
    expect_meta_refusal(kMeta3 + "ElementSpacing = 1 1 1\nTransformMatrix = " + sheared + "\n", "not perpendicular");
  expect_meta_refusal(kMeta3 + "ElementSpacing = 1 1 1\nTransformMatrix = 2 0 0 0 2 0 0 0 2\n", "not of length 1");
}

}  // namespace
}  // namespace hapticut::volume_headers_test
