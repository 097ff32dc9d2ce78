// SPDX-License-Identifier: Apache-2.0
#include "hapticut/import/volume/volumes.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <tuple>

#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "support/no_disk_space.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"
#include "support/volume_files.hpp"

namespace hapticut::volumes_test {
namespace {

using test::TemporaryFolder;
using units::mm;

GreyVolume rotated_ramp() {
  GreyVolume volume;
  volume.dims = {4, 3, 5};
  volume.spacing = Vec3(0.1, 0.2, 0.7) * mm;
  volume.X_WG = {rotation_from_vector({0.4, -0.3, 1.2}), Vec3(12.5, -3, 7.25) * mm};
  volume.values.resize(volume.size());
  std::iota(volume.values.begin(), volume.values.end(), -20.5F);
  return volume;
}

std::filesystem::path written(const TemporaryFolder& folder, const std::string& name, const std::string& bytes) {
  test::write_bytes(folder / name, bytes);
  return folder / name;
}

/// 16-bit values as stored in files.
std::string short_bytes(int count) {
  std::string bytes;
  for (int n = 0; n < count; ++n) bytes += test::little(std::int16_t(n * 7 - 50));
  return bytes;
}

std::string nrrd(const std::string& fields, const std::string& data) {
  return "NRRD0004\ntype: short\nendian: little\n" + fields + "\n\n" + data;
}
const char* const kSmall = "dimension: 3\nsizes: 4 3 5\nspacings: 0.1 0.2 0.7\nencoding: raw";

std::string meta(const std::string& fields) {
  return "ObjectType = Image\nNDims = 3\nDimSize = 4 3 5\nElementSpacing = 0.1 0.2 0.7\n" + fields +
         "ElementType = MET_SHORT\nElementDataFile = LOCAL\n";
}

/// Expects an error that names the file, and no output.
void expect_clear_error(const std::filesystem::path& path, const std::string& part) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const std::string refusal = test::refusal([&] { return read_grey_volume(path); });
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << path;
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "") << path;
  test::expect_part(refusal, path.filename().string());
  test::expect_part(refusal, part);
}

TEST(WriteNrrd, IsReadBackTheSame) {
  const TemporaryFolder folder;
  const GreyVolume volume = rotated_ramp();
  write_nrrd(volume, folder / "ramp.nrrd");
  const GreyVolume back = read_grey_volume(folder / "ramp.nrrd");
  EXPECT_EQ(back.dims, volume.dims);
  EXPECT_EQ(back.values, volume.values);
  EXPECT_TRUE(back.spacing.isApprox(volume.spacing, 1e-12));
  EXPECT_TRUE(back.X_WG.rotation.isApprox(volume.X_WG.rotation, 1e-12));
  EXPECT_LT((back.X_WG.translation - volume.X_WG.translation).norm(), 1e-15);
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(WriteNrrd, WritesMaterialsAndFillsOfAWorkpiece) {
  const TemporaryFolder folder;
  Material clay;
  clay.name = "clay";
  const Workpiece ball = build_sphere(Vec3(3, 4, 5) * mm, 1 * mm, 0.1 * mm, clay);
  write_nrrd(ball, folder / "ball.nrrd");
  const LabelVolume materials = read_label_volume(folder / "ball.nrrd");
  const GreyVolume fills = read_grey_volume(folder / "ball_density.nrrd");
  ASSERT_EQ(materials.dims, fills.dims);
  EXPECT_EQ(std::count(materials.values.begin(), materials.values.end(), 1), ball.solid_voxels());
  const double volume = std::accumulate(fills.values.begin(), fills.values.end(), 0.0) * 1e-12;
  EXPECT_NEAR(volume / ball.amounts()[0].volume, 1, 1e-9);
  const IndexBox box = ball.bounds();
  EXPECT_LT((materials.position(0, 0, 0) - ball.frame().center(box.min)).norm(), 1e-12);
}

TEST(WriteNrrd, LeavesWhatWasThereWhenItFails) {
  const TemporaryFolder folder;
  written(folder, "old.nrrd", "precious");
  GreyVolume volume = rotated_ramp();
  volume.dims = {1 << 7, 1 << 7, 1 << 7};
  volume.values.resize(volume.size());
  std::mt19937 random(1);
  for (float& value : volume.values) value = float(random());

  {
    const test::NoDiskSpace full(1U << 16U);
    EXPECT_THROW(write_nrrd(volume, folder / "old.nrrd"), Error);
  }
  EXPECT_EQ(test::read_bytes(folder / "old.nrrd"), "precious");
  EXPECT_EQ(folder.file_count(), 1U);
  EXPECT_THROW(write_nrrd(rotated_ramp(), folder / "no/such/folder.nrrd"), Error);
  EXPECT_THROW(write_nrrd(rotated_ramp(), "/proc/volume.nrrd"), Error);  // even root may not write there
}

TEST(ReadVolume, ReadsNrrdAndMetaImageAlike) {
  const TemporaryFolder folder;
  const auto a = read_grey_volume(written(folder, "a.nrrd", nrrd(kSmall, short_bytes(60))));
  const auto b = read_grey_volume(written(folder, "b.mha", meta("") + short_bytes(60)));
  EXPECT_EQ(a.dims, (std::array<int, 3>{4, 3, 5}));
  EXPECT_EQ(a.at(1, 2, 3), 7 * (1 + 4 * (2 + 3 * 3)) - 50);
  EXPECT_EQ(a.values, b.values);
  EXPECT_TRUE(a.spacing.isApprox(Vec3(0.1, 0.2, 0.7) * mm));
  EXPECT_TRUE(b.spacing.isApprox(a.spacing));
}

TEST(ReadVolume, TakesTheSpacingOfTheCaller) {
  const TemporaryFolder folder;
  const auto path = written(folder, "a.nrrd", nrrd(kSmall, short_bytes(60)));
  const auto volume = read_grey_volume(path, {.spacing = Vec3(1, 2, 3) * mm, .dicom_series = {}});
  EXPECT_TRUE(volume.spacing.isApprox(Vec3(1, 2, 3) * mm));
  EXPECT_THROW((void)read_grey_volume(path, {.spacing = Vec3(1, 0, 3), .dicom_series = {}}), Error);
}

TEST(ReadVolume, HonoursTheUnitsOfAnNrrdFile) {
  const TemporaryFolder folder;
  const std::string fields =
      "dimension: 3\nspace: LPS\nsizes: 4 3 5\nspace directions: (20,0,0) (0,20,0) (0,0,20)\nspace origin: (1000,0,0)\n"
      "space units: \"um\" \"um\" \"um\"\nencoding: raw";
  const auto volume = read_grey_volume(written(folder, "a.nrrd", nrrd(fields, short_bytes(60))));
  EXPECT_TRUE(volume.spacing.isApprox(Vec3::Constant(0.02 * mm)));
  EXPECT_NEAR(volume.X_WG.translation.x(), 1 * mm, 1e-12);
}

TEST(ReadVolume, TurnsALeftHandedGridRoundWithoutMovingASample) {
  const TemporaryFolder folder;
  const std::string mirrored =
      "TransformMatrix = 0 1 0 1 0 0 0 0 1\nOffset = 10 20 30\n";  // x and y axes swapped: determinant -1
  const auto volume = read_grey_volume(written(folder, "a.mha", meta(mirrored) + short_bytes(60)));
  EXPECT_GT(volume.X_WG.rotation.determinant(), 0.999);
  const auto right = read_grey_volume(written(folder, "b.mha", meta("") + short_bytes(60)));
  const Vec3 mirrored_sample = Vec3(10 + 2 * 0.2, 20 + 1 * 0.1, 30 + 4 * 0.7) * mm;  // sample (1, 2, 4)
  EXPECT_LT((volume.position(1, 2, 0) - mirrored_sample).norm(), 1e-12);
  EXPECT_EQ(volume.at(1, 2, 0), right.at(1, 2, 4));
}

TEST(ReadVolume, ReadsCompressedAndBigEndianMetaImages) {
  const TemporaryFolder folder;
  std::string swapped = short_bytes(60);
  for (std::size_t n = 0; n < swapped.size(); n += 2) std::swap(swapped[n], swapped[n + 1]);
  const auto big = read_grey_volume(written(folder, "a.mha", meta("BinaryDataByteOrderMSB = True\n") + swapped));
  EXPECT_EQ(big.at(1, 2, 3), 7 * (1 + 4 * (2 + 3 * 3)) - 50);
}

TEST(ReadVolume, RefusesLabelsThatAreNotWholeNumbers) {
  const TemporaryFolder folder;
  write_nrrd(rotated_ramp(), folder / "grey.nrrd");
  EXPECT_THROW((void)read_label_volume(folder / "grey.nrrd"), Error);                                      // -20.5
  EXPECT_THROW((void)read_label_volume(written(folder, "a.nrrd", nrrd(kSmall, short_bytes(60)))), Error);  // -50
}

TEST(ReadVolume, RefusesWhatItCannotReadAndPrintsNothing) {
  const TemporaryFolder folder;
  for (const char* absent : {"absent.nrrd", "absent.mhd", "absent.nii.gz"})
    expect_clear_error(folder / absent, "no such file");
  for (const char* empty : {"empty_folder", "a_folder.nrrd"}) {
    std::filesystem::create_directory(folder / empty);
    expect_clear_error(folder / empty, "DICOM");
  }
  const std::string values = short_bytes(60);
  const std::tuple<const char*, std::string, const char*> files[] = {
      {"a.txt", "text", "its extension is not supported"},
      {"a.fbx", "text", "meshes are .stl .ply .obj .off .gltf .glb; workpieces are .vdb"},
      {"a.raw", "text", "read_raw_grey_volume"},
      {"colour.mha", meta("ElementNumberOfChannels = 3\n") + short_bytes(180), "per sample"},
      {"shear.mha", meta("TransformMatrix = 1 0 0 0.5 1 0 0 0 1\n") + values, "perpendicular"},
      {"flat.mha", meta("ElementSpacing = 0.1 0.1 0\n") + values, "spacing"}};
  for (const auto& [name, bytes, part] : files) expect_clear_error(written(folder, name, bytes), part);
}

// Other formats: DamagedVolume in self_written_volumes_test.cpp.
TEST(ReadVolume, RefusesHeadersThatClaimMoreThanTheFileHolds) {
  const TemporaryFolder folder;
  const auto claim = [](const char* sizes, const char* encoding) {
    return nrrd(std::string("dimension: 3\nsizes: ") + sizes + "\nencoding: " + encoding, short_bytes(60));
  };
  const std::pair<const char*, std::string> files[] = {
      {"tera.nrrd", claim("10000 10000 10000", "raw")},
      {"giga.nrrd", claim("1000 1000 1000", "raw")},
      {"giga_bz2.nrrd", claim("1000 1000 1000", "bzip2")},
      {"zero.nrrd", claim("10 0 10", "raw")},
      {"negative.nrrd", claim("10 -10 10", "raw")},
      {"tera.mha", meta("DimSize = 10000 10000 10000\n")},
      {"giga_gz.mha", meta("DimSize = 1000 1000 1000\nCompressedData = True\n") + short_bytes(60)},
      {"tera.nii", test::NiftiFile{.dims = {10000, 10000, 10000}}.bytes()}};
  for (const auto& [name, bytes] : files) expect_clear_error(written(folder, name, bytes), "claims");
}

TEST(ReadVolume, RefusesFilesWithoutPermission) {
  const TemporaryFolder folder;
  const auto path = written(folder, "secret.nrrd", nrrd(kSmall, short_bytes(60)));
  std::filesystem::permissions(path, std::filesystem::perms::none);
  if (std::ifstream(path)) GTEST_SKIP() << "this user may read everything";
  expect_clear_error(path, "permissions");
}

TEST(ReadRaw, RefusesAFileOfAnotherLength) {
  const TemporaryFolder folder;
  RawLayout layout{.dims = {4, 3, 5}, .spacing = Vec3::Constant(1 * mm), .type = ValueType::int16};
  const auto path = written(folder, "a.raw", "12345" + short_bytes(60));
  EXPECT_THROW((void)read_raw_grey_volume(path, layout), Error);
  layout.skip = 5;
  EXPECT_EQ(read_raw_grey_volume(path, layout).at(1, 2, 3), 7 * (1 + 4 * (2 + 3 * 3)) - 50);
  layout.dims = {1 << 20, 1 << 20, 1};
  EXPECT_THROW((void)read_raw_grey_volume(path, layout), Error);
}

}  // namespace
}  // namespace hapticut::volumes_test
