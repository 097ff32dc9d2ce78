// SPDX-License-Identifier: Apache-2.0
// PNG and TIFF slices, NRRD, MetaImage and NIfTI files, DICOM series and InVesalius projects that the test writes
// itself: what is in them comes back, and damaged ones give a clear error or the volume, whatever is done to them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

#include "hapticut/core/units.hpp"
#include "hapticut/io/volume/volumes.hpp"
#include "support/dicom_files.hpp"
#include "support/memory_growth.hpp"
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

/// The values of all volumes here: different everywhere, so that no mix-up of axes goes unnoticed.
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
// ------------------------------------------------------------------------------------------------------------

/// Slices 9, 10, 11 ... 13, so that lexical order would put the first one last.
void write_slices(const TemporaryFolder& folder, const std::string& ending,
                  const std::function<std::string(int)>& slice) {
  for (int k = 0; k < kDims[2]; ++k) write_bytes(folder / ("slice" + std::to_string(9 + k) + ending), slice(k));
}

TEST(Slices, OfPngWith8Or16BitsAreInTheOrderOfTheirNumbers) {
  const TemporaryFolder bytes, words;
  write_slices(bytes, ".png", [](int k) { return test::png_slice(4, 3, ramp<std::uint8_t>(k * kSlice, kSlice)); });
  write_slices(words, ".PNG", [](int k) { return test::png_slice(4, 3, ramp<std::uint16_t>(k * kSlice, kSlice)); });
  expect_ramp(read(bytes / ""));
  expect_ramp(read(words / ""));
}

TEST(Slices, OfTiffWith8Or16BitsAreInTheOrderOfTheirNumbers) {
  const TemporaryFolder bytes, words;
  write_slices(bytes, ".tif", [](int k) { return test::tiff_slice(4, 3, ramp<std::uint8_t>(k * kSlice, kSlice)); });
  write_slices(words, ".tiff", [](int k) { return test::tiff_slice(4, 3, ramp<std::uint16_t>(k * kSlice, kSlice)); });
  expect_ramp(read(bytes / ""));
  expect_ramp(read(words / ""));
}

std::string error_of(const std::filesystem::path& path, const VolumeReadOptions& options = {.spacing = kSpacing}) {
  try {
    (void)read_grey_volume(path, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Slices, WithTransparencyAreRefused) {
  constexpr char kGreyAndAlpha = 4;
  const TemporaryFolder folder;
  write_slices(folder, ".png",
               [](int) { return test::png_slice(8, 3, ramp<std::uint8_t>(0, 24), 4, 3, kGreyAndAlpha); });
  EXPECT_NE(error_of(folder / "").find("grey values and transparency"), std::string::npos) << error_of(folder / "");
}

TEST(Slices, OfTiffThatAreTurnedAreRefused) {
  constexpr std::uint16_t kSamples = 277, kOrientation = 274, kLong = 4;
  const auto entry = [](std::uint16_t tag, std::uint32_t value) {
    return test::little(tag) + test::little(kLong) + test::little(std::uint32_t(1)) + test::little(value);
  };
  std::string turned = test::tiff_slice(4, 3, ramp<std::uint8_t>(0, kSlice));
  turned.replace(turned.find(entry(kSamples, 1)), 12, entry(kOrientation, 3));
  const TemporaryFolder folder;
  write_slices(folder, ".tif", [&](int) { return turned; });
  EXPECT_NE(error_of(folder / "").find("turned or mirrored"), std::string::npos) << error_of(folder / "");
}

TEST(Slices, ThatDoNotBelongTogetherAreRefusedByName) {
  const auto png = [](int k) { return test::png_slice(4, 3, ramp<std::uint8_t>(k * kSlice, kSlice)); };
  const auto refuses = [&](const std::string& name, const std::string& bytes, const std::string& part) {
    const TemporaryFolder folder;
    write_slices(folder, ".png", png);
    write_bytes(folder / name, bytes);
    const std::string error = error_of(folder / "");
    EXPECT_NE(error.find(part), std::string::npos) << name << ": " << error;
  };
  refuses("slice15.png", png(0), "one is missing");
  refuses("slice009.png", png(0), "there twice");
  refuses("other14.png", png(0), "of another series");
  refuses("cover.png", png(0), "this one has none");
  refuses("slice14.png", test::png_slice(3, 4, ramp<std::uint8_t>(0, kSlice)), "differs from the first slice");
  refuses("slice14.png", test::png_slice(4, 3, ramp<std::uint16_t>(0, kSlice)), "differs from the first slice");
  refuses("slice14.png", test::tiff_slice(4, 3, ramp<std::uint8_t>(0, kSlice)), "not a picture of the format");
  const TemporaryFolder folder;
  write_slices(folder, ".png", png);
  EXPECT_NE(error_of(folder / "", {}).find("how far apart"), std::string::npos);
}

TEST(Slices, AreInTheOrderOfTheNumberThatChanges) {
  const auto png = [](int k) { return test::png_slice(4, 3, ramp<std::uint8_t>(k * kSlice, kSlice)); };
  const TemporaryFolder folder;
  for (int k = 0; k < kDims[2]; ++k) write_bytes(folder / ("scan2_z" + std::to_string(9 + k) + "_300um.png"), png(k));
  write_bytes(folder / "._scan2_z9_300um.png", "of macOS");
  expect_ramp(read(folder / ""));
  write_bytes(folder / "scan2_z14_200um.png", png(5));
  EXPECT_NE(error_of(folder / "").find("of another series"), std::string::npos);
}

TEST(Slices, InOneFileOfSeveralPagesAreRefusedAsThat) {
  const TemporaryFolder folder;
  const std::string page = test::tiff_slice(4, 3, ramp<std::uint8_t>(0, kSlice));
  constexpr std::size_t kDirectory = 2 + 9 * 12 + 4;  // [bytes], with the place of the next one at its end
  const std::string next = test::little(std::uint32_t(page.size()));
  write_bytes(folder / "stack.tif", page.substr(0, page.size() - 4) + next + page.substr(page.size() - kDirectory));
  EXPECT_NE(error_of(folder / "").find("it has several pages; save one slice per file"), std::string::npos)
      << error_of(folder / "");
  EXPECT_NE(error_of(folder / "stack.tif").find("save each page as a file of its own"), std::string::npos);
}

// --- NIfTI
// ------------------------------------------------------------------------------------------------------------

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
  try {
    (void)read_nifti(file);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("take one volume out of it"), std::string::npos) << error.what();
  }
}

TEST(Nifti, ScaledValuesAreScaled) {
  NiftiFile file = ramp_file();
  file.slope = 0.5F, file.intercept = -10;
  const GreyVolume volume = read_nifti(file);
  ASSERT_EQ(volume.dims, kDims);
  for (std::size_t n = 0; n < volume.values.size(); ++n)
    EXPECT_FLOAT_EQ(volume.values[n], 0.5F * float(file.values[n]) - 10);
}

// Files have x to the right and y to the front, the library x to the left and y to the back: both change their sign.
TEST(Nifti, PoseComesFromItsAffineMap) {
  NiftiFile file = ramp_file();
  // Index i along -z, j along x, k along -y of the file: 10, 20, 30 mm is the first sample's place.
  file.rows = {0, 0.2F, 0, 10, 0, 0, -0.7F, 20, -0.1F, 0, 0, 30};
  const GreyVolume volume = read_nifti(file);
  expect_ramp(volume);
  EXPECT_LT((volume.position(0, 0, 0) - Vec3(-10, -20, 30) * mm).norm(), 1e-9);
  EXPECT_LT((volume.position(3, 2, 4) - Vec3(-10.4, -17.2, 29.7) * mm).norm(), 1e-9);
}

TEST(Nifti, PoseComesFromItsQuaternionAndALeftHandedGridIsTurnedRound) {
  NiftiFile file = ramp_file();
  file.quaternion = {0, 0, float(std::sqrt(0.5)), 1, 2, 3};  // a quarter turn about z
  const GreyVolume volume = read_nifti(file);
  expect_ramp(volume);
  // Of the file: i along y, j along -x.
  EXPECT_LT((volume.position(3, 2, 4) - Vec3(-(1 - 0.4), -(2 + 0.3), 3 + 2.8) * mm).norm(), 1e-8);

  file.qfac = -1;  // k downwards
  const GreyVolume mirrored = read_nifti(file);
  EXPECT_GT(mirrored.X_WG.rotation.determinant(), 0.999);
  EXPECT_LT((mirrored.position(3, 2, 0) - Vec3(-0.6, -2.3, 3 - 2.8) * mm).norm(), 1e-8);
  EXPECT_EQ(mirrored.at(3, 2, 0), volume.at(3, 2, 4));
}

// --- DICOM and InVesalius
// ---------------------------------------------------------------------------------------------

void write_series(const TemporaryFolder& folder) {
  for (int k = 0; k < kDims[2]; ++k)  // named against the order of their places
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
// -----------------------------------------------------------------------------------------------------------

/// A format, as a file to damage within a folder to read.
struct Format {
  const char* name;
  std::string file;                                       // that is damaged
  bool is_folder;                                         // that is read
  std::function<void(const TemporaryFolder&)> write;      // a whole volume
  std::function<std::string(std::uint32_t)> claims = {};  // the file with a header that claims this many samples a side
};

void PrintTo(const Format& format, std::ostream* out) { *out << format.name; }

std::string nrrd_file(std::uint32_t side_x, std::uint32_t side_y, bool packed) {
  const std::string values = test::little(ramp<std::int16_t>());
  return "NRRD0004\ntype: short\nendian: little\ndimension: 3\nsizes: " + std::to_string(side_x) + " " +
         std::to_string(side_y) +
         " 5\nspacings: 0.1 0.2 0.7\nencoding: " + (packed ? "gzip\n\n" + test::gzipped(values) : "raw\n\n" + values);
}

std::string meta_file(std::uint32_t side_x, std::uint32_t side_y) {
  return "ObjectType = Image\nNDims = 3\nOffset = 1 2 3\nElementSpacing = 0.1 0.2 0.7\nDimSize = " +
         std::to_string(side_x) + " " + std::to_string(side_y) +
         " 5\nElementType = MET_SHORT\nElementDataFile = LOCAL\n" + test::little(ramp<std::int16_t>());
}

std::vector<Format> formats() {
  const auto png = [](int k) { return test::png_slice(4, 3, ramp<std::uint8_t>(k * kSlice, kSlice)); };
  const auto tiff = [](int k) { return test::tiff_slice(4, 3, ramp<std::uint16_t>(k * kSlice, kSlice)); };
  return {
      {"Png", "slice9.png", true, [=](const TemporaryFolder& f) { write_slices(f, ".png", png); },
       [](std::uint32_t side) { return test::png_slice(4, 3, ramp<std::uint8_t>(0, kSlice), side, side); }},
      {"Tiff", "slice9.tif", true, [=](const TemporaryFolder& f) { write_slices(f, ".tif", tiff); },
       [](std::uint32_t side) { return test::tiff_slice(4, 3, ramp<std::uint16_t>(0, kSlice), side, side); }},
      {"Nrrd", "a.nrrd", false, [](const TemporaryFolder& f) { write_bytes(f / "a.nrrd", nrrd_file(4, 3, false)); },
       [](std::uint32_t side) { return nrrd_file(side, side, false); }},
      {"NrrdGz", "a.nrrd", false, [](const TemporaryFolder& f) { write_bytes(f / "a.nrrd", nrrd_file(4, 3, true)); },
       [](std::uint32_t side) { return nrrd_file(side, side, true); }},
      {"MetaImage", "a.mha", false, [](const TemporaryFolder& f) { write_bytes(f / "a.mha", meta_file(4, 3)); },
       [](std::uint32_t side) { return meta_file(side, side); }},
      {"Nifti", "a.nii", false, [](const TemporaryFolder& f) { write_bytes(f / "a.nii", ramp_file().bytes()); },
       [](std::uint32_t side) {
         NiftiFile file = ramp_file();
         file.dims = {std::int16_t(side), std::int16_t(side), 5};
         return file.bytes();
       }},
      {"NiftiGz", "a.nii.gz", false,
       [](const TemporaryFolder& f) { write_bytes(f / "a.nii.gz", test::gzipped(ramp_file().bytes())); },
       [](std::uint32_t side) {
         NiftiFile file = ramp_file();
         file.dims = {std::int16_t(side), std::int16_t(side), 5};
         return test::gzipped(file.bytes());
       }},
      {"Dicom", "image7", true, write_series,
       [](std::uint32_t side) {
         return test::dicom_file(
             test::dicom_slice(std::uint16_t(side), std::uint16_t(side), 1.4, ramp<std::int16_t>(2 * kSlice, kSlice)));
       }},
      {"InVesalius", "a.inv3", false,
       [](const TemporaryFolder& f) {
         write_bytes(f / "a.inv3", test::invesalius_project(kDims, ramp<std::int16_t>()));
       },
       [](std::uint32_t side) {
         return test::invesalius_project({int(side), int(side), 2}, ramp<std::int16_t>());
       }},
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

  /// Reads with other bytes in the file: prints nothing, and gives an error that names the file or its folder, or a
  /// volume that is consistent.  @return whether it was refused
  bool is_refused(const std::string& bytes, const std::function<void(const GreyVolume&)>& check) {
    write_bytes(folder_ / GetParam().file, bytes);
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    bool refused = false;
    std::string message;
    try {
      check(read(target()));
    } catch (const Error& error) {
      refused = true;
      message = error.what();
    }
    const std::string errors = testing::internal::GetCapturedStderr(), out = testing::internal::GetCapturedStdout();
    EXPECT_EQ(errors, "");
    EXPECT_EQ(out, "");
    if (refused) {
      EXPECT_NE(message.find((folder_ / "").parent_path().filename().string()), std::string::npos) << message;
    }
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
  EXPECT_GT(refused, 0.7 * tried);  // what follows the values is not needed by every format
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
    std::string noise = whole_.substr(0, kept);  // nothing but noise behind the beginning of the file
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
