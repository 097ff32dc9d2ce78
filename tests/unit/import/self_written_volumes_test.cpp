// SPDX-License-Identifier: Apache-2.0
// PNG and TIFF slices, NRRD, MetaImage and NIfTI files, DICOM series and InVesalius projects written by the test: valid
// files are read back exactly, and damaged ones give a clear error or a valid volume.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <tuple>

#include "hapticut/core/units.hpp"
#include "hapticut/import/volume/volumes.hpp"
#include "support/dicom_files.hpp"
#include "support/memory_growth.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"
#include "support/volume_files.hpp"

namespace hapticut::self_written_volumes_test {
namespace {

using test::NiftiFile;
using test::TemporaryFolder;
using test::write_bytes;
using units::mm;

constexpr std::array<int, 3> kDims = {4, 3, 5};
const Vec3 kSpacing = Vec3(0.1, 0.2, 0.7) * mm;
constexpr int kSlice = kDims[0] * kDims[1];

/// The values of all volumes here. They differ from each other, so a test detects swapped axes.
template <class Value>
std::vector<Value> ramp(int first = 0, int count = kSlice * kDims[2]) {
  std::vector<Value> values(static_cast<std::size_t>(count));
  for (int n = 0; n < count; ++n) values[std::size_t(n)] = Value((first + n) * 3 + 1);
  return values;
}

void expect_ramp(const GreyVolume& volume) {
  ASSERT_EQ(volume.dims, kDims);
  const auto expected = ramp<float>();
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), volume.values.begin()));
  EXPECT_TRUE(volume.spacing.isApprox(kSpacing, 1e-6)) << volume.spacing.transpose();
}

GreyVolume read(const std::filesystem::path& path) { return read_grey_volume(path, {.spacing = kSpacing}); }

// --- slices

/// Slices 9, 10, 11 ... 13: lexical order would put the first one last.
void write_slices(const TemporaryFolder& folder, const std::string& extension,
                  const std::function<std::string(int)>& slice) {
  for (int k = 0; k < kDims[2]; ++k) write_bytes(folder / ("slice" + std::to_string(9 + k) + extension), slice(k));
}

template <class Grey>
std::string png(int k) {
  return test::png_slice(kDims[0], kDims[1], ramp<Grey>(k * kSlice, kSlice));
}
template <class Grey>
std::string tiff(int k) {
  return test::tiff_slice(kDims[0], kDims[1], ramp<Grey>(k * kSlice, kSlice));
}

TEST(Slices, With8Or16BitsAreInTheOrderOfTheirNumbers) {
  const std::pair<const char*, std::string (*)(int)> kinds[] = {{".png", png<std::uint8_t>},
                                                                {".PNG", png<std::uint16_t>},
                                                                {".tif", tiff<std::uint8_t>},
                                                                {".tiff", tiff<std::uint16_t>}};
  for (const auto& [extension, slice] : kinds) {
    SCOPED_TRACE(extension);
    const TemporaryFolder folder;
    write_slices(folder, extension, slice);
    expect_ramp(read(folder / ""));
  }
}

void expect_refused(const std::filesystem::path& path, const std::string& part) {
  test::expect_refused([&] { return read(path); }, part);
}

TEST(Slices, WithTransparencyAreRefused) {
  constexpr char kGreyAndAlpha = 4;
  const TemporaryFolder folder;
  write_slices(folder, ".png",
               [](int) { return test::png_slice(8, 3, ramp<std::uint8_t>(0, 24), 4, 3, kGreyAndAlpha); });
  expect_refused(folder / "", "grey values and transparency");
}

TEST(Slices, OfTiffThatAreTurnedAreRefused) {
  constexpr std::uint16_t kSamples = 277, kOrientation = 274, kLong = 4;
  const auto entry = [](std::uint16_t tag, std::uint32_t value) {
    return test::little(tag) + test::little(kLong) + test::little(std::uint32_t(1)) + test::little(value);
  };
  std::string turned = tiff<std::uint8_t>(0);
  turned.replace(turned.find(entry(kSamples, 1)), 12, entry(kOrientation, 3));
  const TemporaryFolder folder;
  write_slices(folder, ".tif", [&](int) { return turned; });
  expect_refused(folder / "", "rotated or mirrored");
}

TEST(Slices, ThatDoNotBelongTogetherAreRefusedByName) {
  const std::string alike = png<std::uint8_t>(0);
  const std::tuple<const char*, std::string, const char*> others[] = {
      {"slice15.png", alike, "one is missing"},
      {"slice009.png", alike, "duplicated"},
      {"other14.png", alike, "of another series"},
      {"cover.png", alike, "this name has none"},
      {"slice14.png", test::png_slice(3, 4, ramp<std::uint8_t>(0, kSlice)), "differs from the first slice"},
      {"slice14.png", png<std::uint16_t>(0), "differs from the first slice"},
      {"slice14.png", tiff<std::uint8_t>(0), "its format differs from its extension"}};
  for (const auto& [name, bytes, part] : others) {
    SCOPED_TRACE(name);
    const TemporaryFolder folder;
    write_slices(folder, ".png", png<std::uint8_t>);
    write_bytes(folder / name, bytes);
    expect_refused(folder / "", part);
  }
  const TemporaryFolder folder;
  write_slices(folder, ".png", png<std::uint8_t>);
  test::expect_refused([&] { return read_grey_volume(folder / ""); }, "have no spacing");
}

TEST(Slices, AreInTheOrderOfTheNumberThatChanges) {
  const TemporaryFolder folder;
  for (int k = 0; k < kDims[2]; ++k)
    write_bytes(folder / ("scan2_z" + std::to_string(9 + k) + "_300um.png"), png<std::uint8_t>(k));
  write_bytes(folder / "._scan2_z9_300um.png", "of macOS");
  expect_ramp(read(folder / ""));
  write_bytes(folder / "scan2_z14_200um.png", png<std::uint8_t>(5));
  expect_refused(folder / "", "of another series");
}

TEST(Slices, InOneFileOfSeveralPagesAreRefusedAsThat) {
  const TemporaryFolder folder;
  const std::string page = tiff<std::uint8_t>(0);
  constexpr std::size_t kDirectory = 2 + 9 * 12 + 4;  // [bytes], with the offset of the next directory at its end
  const std::string next = test::little(std::uint32_t(page.size()));
  write_bytes(folder / "stack.tif", page.substr(0, page.size() - 4) + next + page.substr(page.size() - kDirectory));
  expect_refused(folder / "", "it has several pages; save one slice per file");
  expect_refused(folder / "stack.tif", "save each page as a separate file");
}

// --- NIfTI

GreyVolume read_nifti(const NiftiFile& file, const std::string& name = "a.nii", bool big_endian = false) {
  const TemporaryFolder folder;
  const std::string bytes = file.bytes(big_endian);
  write_bytes(folder / name, name.ends_with(".gz") ? test::gzipped(bytes) : bytes);
  return read_grey_volume(folder / name);
}

NiftiFile ramp_file() {
  NiftiFile file;
  file.values = ramp<std::int16_t>();
  return file;
}

TEST(Nifti, IsReadPlainCompressedAndBigEndian) {
  expect_ramp(read_nifti(ramp_file()));
  expect_ramp(read_nifti(ramp_file(), "a.nii.gz"));
  expect_ramp(read_nifti(ramp_file(), "A.NII", true));
}

TEST(Nifti, AFourthDimensionOfOneIsStillAVolumeAndALongerOneIsNot) {
  NiftiFile file = ramp_file();
  file.dims = {4, 3, 5, 1, 1};
  expect_ramp(read_nifti(file));
  file.dims = {4, 3, 5, 2};
  file.values.resize(2 * file.values.size());
  test::expect_refused([&] { return read_nifti(file); }, "extract one volume");
}

TEST(Nifti, ScaledValuesAreScaled) {
  NiftiFile file = ramp_file();
  file.slope = 0.5F, file.intercept = -10;
  const GreyVolume volume = read_nifti(file);
  ASSERT_EQ(volume.dims, kDims);
  for (std::size_t n = 0; n < volume.values.size(); ++n)
    EXPECT_FLOAT_EQ(volume.values[n], 0.5F * float(file.values[n]) - 10);
}

// In files x points right and y to the front; in the library x points left and y to the back. Both change sign.
TEST(Nifti, PoseComesFromItsAffineMap) {
  NiftiFile file = ramp_file();
  // Index i along -z, j along x, k along -y of the file: the first sample is at 10, 20, 30 mm.
  file.rows = {0, 0.2F, 0, 10, 0, 0, -0.7F, 20, -0.1F, 0, 0, 30};
  const GreyVolume volume = read_nifti(file);
  expect_ramp(volume);
  EXPECT_LT((volume.position(0, 0, 0) - Vec3(-10, -20, 30) * mm).norm(), 1e-9);
  EXPECT_LT((volume.position(3, 2, 4) - Vec3(-10.4, -17.2, 29.7) * mm).norm(), 1e-9);
}

TEST(Nifti, PoseComesFromItsQuaternionAndALeftHandedGridIsTurnedRound) {
  NiftiFile file = ramp_file();
  file.quaternion = {0, 0, float(std::sqrt(0.5)), 1, 2, 3};  // 90 degrees about z
  const GreyVolume volume = read_nifti(file);
  expect_ramp(volume);
  // In the file, i points along y and j along -x.
  EXPECT_LT((volume.position(3, 2, 4) - Vec3(-(1 - 0.4), -(2 + 0.3), 3 + 2.8) * mm).norm(), 1e-8);

  file.qfac = -1;  // k downwards
  const GreyVolume mirrored = read_nifti(file);
  EXPECT_GT(mirrored.X_WG.rotation.determinant(), 0.999);
  EXPECT_LT((mirrored.position(3, 2, 0) - Vec3(-0.6, -2.3, 3 - 2.8) * mm).norm(), 1e-8);
  EXPECT_EQ(mirrored.at(3, 2, 0), volume.at(3, 2, 4));
}

// --- DICOM and InVesalius

void write_series(const TemporaryFolder& folder) {
  for (int k = 0; k < kDims[2]; ++k)  // names in reverse order of positions
    write_bytes(folder / ("image" + std::to_string(9 - k)),
                test::dicom_file(test::dicom_slice(4, 3, 0.7 * k, ramp<std::int16_t>(k * kSlice, kSlice))));
}

TEST(Dicom, ASeriesIsOrderedByThePlacesOfItsSlices) {
  const TemporaryFolder folder;
  write_series(folder);
  const GreyVolume volume = read_grey_volume(folder / "");
  ASSERT_EQ(volume.dims, kDims);
  EXPECT_TRUE(volume.spacing.isApprox(kSpacing, 1e-9)) << volume.spacing.transpose();
  EXPECT_LT((volume.position(0, 0, 4) - Vec3(10, 20, 2.8) * mm).norm(), 1e-9);
  const auto stored = ramp<float>();
  for (std::size_t n = 0; n < stored.size(); ++n) EXPECT_EQ(volume.values[n], stored[n] - 1000);  // Hounsfield units
}

TEST(InVesalius, AProjectIsReadWithItsSpacing) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.inv3", test::invesalius_project(kDims, ramp<std::int16_t>()));
  expect_ramp(read_grey_volume(folder / "a.inv3"));
}

// --- damage

/// A format: a file to damage and a path to read.
struct Format {
  const char* name;
  std::string file;                                       // file to damage
  bool is_folder;                                         // true: read the folder
  std::function<void(const TemporaryFolder&)> write;      // writes a valid volume
  std::function<std::string(std::uint32_t)> claims = {};  // file whose header claims this many samples per side
};

void PrintTo(const Format& format, std::ostream* out) { *out << format.name; }

/// The sizes of a valid file, "4 3 5" (side 0), or claimed sizes.
std::string sizes(std::uint32_t side) {
  return side == 0 ? "4 3 5" : std::to_string(side) + " " + std::to_string(side) + " 5";
}

std::string nrrd_file(std::uint32_t side, bool packed) {
  const std::string values = test::little(ramp<std::int16_t>());
  return "NRRD0004\ntype: short\nendian: little\ndimension: 3\nsizes: " + sizes(side) +
         "\nspacings: 0.1 0.2 0.7\nencoding: " + (packed ? "gzip\n\n" + test::gzipped(values) : "raw\n\n" + values);
}

std::string meta_file(std::uint32_t side) {
  return "ObjectType = Image\nNDims = 3\nOffset = 1 2 3\nElementSpacing = 0.1 0.2 0.7\nDimSize = " + sizes(side) +
         "\nElementType = MET_SHORT\nElementDataFile = LOCAL\n" + test::little(ramp<std::int16_t>());
}

std::vector<Format> formats() {
  // A format with a single file. `bytes` makes the file for a claimed side; 0: a valid file.
  const auto one_file = [](const char* name, const char* file, const std::function<std::string(std::uint32_t)>& bytes) {
    return Format{name, file, false, [=](const TemporaryFolder& f) { write_bytes(f / file, bytes(0)); }, bytes};
  };
  const auto nifti = [](std::uint32_t side) {
    NiftiFile file = ramp_file();
    if (side != 0) file.dims = {std::int16_t(side), std::int16_t(side), 5};
    return file.bytes();
  };
  return {
      {"Png", "slice9.png", true, [](const TemporaryFolder& f) { write_slices(f, ".png", png<std::uint8_t>); },
       [](std::uint32_t side) { return test::png_slice(4, 3, ramp<std::uint8_t>(0, kSlice), side, side); }},
      {"Tiff", "slice9.tif", true, [](const TemporaryFolder& f) { write_slices(f, ".tif", tiff<std::uint16_t>); },
       [](std::uint32_t side) { return test::tiff_slice(4, 3, ramp<std::uint16_t>(0, kSlice), side, side); }},
      one_file("Nrrd", "a.nrrd", [](std::uint32_t side) { return nrrd_file(side, false); }),
      one_file("NrrdGz", "a.nrrd", [](std::uint32_t side) { return nrrd_file(side, true); }),
      one_file("MetaImage", "a.mha", meta_file),
      one_file("Nifti", "a.nii", nifti),
      one_file("NiftiGz", "a.nii.gz", [=](std::uint32_t side) { return test::gzipped(nifti(side)); }),
      {"Dicom", "image7", true, write_series,
       [](std::uint32_t side) {
         return test::dicom_file(
             test::dicom_slice(std::uint16_t(side), std::uint16_t(side), 1.4, ramp<std::int16_t>(2 * kSlice, kSlice)));
       }},
      one_file("InVesalius", "a.inv3",
               [](std::uint32_t side) {
                 const int n = int(side);
                 return test::invesalius_project(n == 0 ? kDims : std::array{n, n, 2}, ramp<std::int16_t>());
               }),
  };
}

class DamagedVolume : public testing::TestWithParam<Format> {
 protected:
  void SetUp() override {
    GetParam().write(folder_);
    whole_ = test::read_bytes(folder_ / GetParam().file);
    volume_ = read(target());
    ASSERT_EQ(volume_.dims, kDims);
  }

  [[nodiscard]] std::filesystem::path target() const {
    return GetParam().is_folder ? folder_ / "" : folder_ / GetParam().file;
  }

  /// Reads the file with changed bytes. Expects no output, and an error that names the file or its folder, or a
  /// consistent volume.
  /// @return true when reading was refused
  bool is_refused(const std::string& bytes, const std::function<void(const GreyVolume&)>& check) {
    write_bytes(folder_ / GetParam().file, bytes);
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    const std::string message = test::refusal([&] { check(read(target())); });
    const std::string errors = testing::internal::GetCapturedStderr(), out = testing::internal::GetCapturedStdout();
    EXPECT_EQ(errors + out, "");
    const bool refused = !message.empty();
    if (refused) test::expect_part(message, (folder_ / "").parent_path().filename().string());
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return refused;
  }

  TemporaryFolder folder_;
  std::string whole_;
  GreyVolume volume_;
};

TEST_P(DamagedVolume, CutShortAnywhereIsRefusedOrStillTheWholeVolume) {
  const test::MemoryGrowth growth;
  const std::size_t stride = std::max<std::size_t>(1, whole_.size() / 60);
  int refused = 0, tried = 0;
  for (std::size_t length = 0; length < whole_.size(); length += stride, ++tried)
    refused += is_refused(whole_.substr(0, length), [&](const GreyVolume& volume) {
      EXPECT_EQ(volume.dims, volume_.dims) << "cut to " << length << " of " << whole_.size();
      EXPECT_EQ(volume.values, volume_.values) << "cut to " << length << " of " << whole_.size();
    });
  EXPECT_GT(refused, 0.7 * tried);  // some formats do not need the bytes after the values
  EXPECT_LT(growth.bytes(), test::kModestMemory);
}

TEST_P(DamagedVolume, WithRandomBytesIsRefusedOrConsistent) {
  const test::MemoryGrowth growth;
  const auto check = [](const GreyVolume& volume) {
    EXPECT_EQ(volume.values.size(), volume.size());
    EXPECT_GT(volume.spacing.minCoeff(), 0);
  };
  constexpr int kTries = 300;
  std::mt19937 random(5);
  for (int n = 0; n < kTries; ++n) {
    std::string bytes = whole_;
    for (int change = 0; change <= n % 4; ++change) bytes[random() % bytes.size()] = char(random());
    (void)is_refused(bytes, check);
  }
  for (const std::size_t kept : {std::size_t(0), std::size_t(4), whole_.size() / 4, whole_.size() / 2}) {
    std::string noise = whole_.substr(0, kept);  // only noise after the beginning of the file
    while (noise.size() < 4096) noise += char(random());
    const bool refused = is_refused(noise, check);
    EXPECT_TRUE(refused || kept > 4) << kept;
  }
  EXPECT_LT(growth.bytes(), test::kModestMemory);
}

TEST_P(DamagedVolume, ThatClaimsMoreThanItHoldsIsRefusedBeforeAnythingIsAllocated) {
  const test::MemoryGrowth growth;
  for (const std::uint32_t side : {20000U, 32767U})
    EXPECT_TRUE(is_refused(GetParam().claims(side), [](const GreyVolume&) {})) << side;
  EXPECT_LT(growth.bytes(), test::kModestMemory);
}

INSTANTIATE_TEST_SUITE_P(Formats, DamagedVolume, testing::ValuesIn(formats()),
                         [](const auto& format) { return std::string(format.param.name); });

}  // namespace
}  // namespace hapticut::self_written_volumes_test
