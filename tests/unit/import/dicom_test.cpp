// SPDX-License-Identifier: Apache-2.0
// DICOM files written by the test: ignored files of a folder, run lengths, and the decoder program.
#include <gtest/gtest.h>

#include <cstdlib>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/import/volume/volumes.hpp"
#include "import/dicom/codec_process.hpp"
#include "import/dicom/dicom_picture.hpp"
#include "io/child_process.hpp"
#include "support/dicom_files.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace hapticut::dicom_test {
namespace {

using test::slice_name;
using test::TemporaryFolder;
using test::write_bytes;

const std::string kPixelElement = std::string("\xe0\x7f\x10\0OW\0\0", 8);

test::DicomElements elements(int number) {
  return test::dicom_slice(4, 3, 0.7 * number, std::vector<std::int16_t>(12, std::int16_t(number)));
}

std::string slice(int number) { return test::dicom_file(elements(number)); }

/// A slice with its values in one compressed part.
std::string compressed(int number, const std::string& syntax, const std::string& packed) {
  return test::dicom_file(elements(number).set_fragments({packed}), syntax);
}

std::string error_of(const std::filesystem::path& path, const VolumeReadOptions& options = {}) {
  return test::refusal([&] { return read_grey_volume(path, options); });
}

/// Three slices of the series 1.2.3.6.
void write_slices(const TemporaryFolder& folder) {
  for (int n = 1; n <= 3; ++n) write_bytes(folder / slice_name(n), slice(n));
}

TEST(Dicom, FilesWithoutAPictureInAFolderAreLeftOut) {
  const TemporaryFolder folder;
  write_slices(folder);
  std::string report = slice(9);
  report.resize(report.rfind(kPixelElement));
  write_bytes(folder / "DICOMDIR", report);
  EXPECT_EQ(read_grey_volume(folder / "").dims, (std::array<int, 3>{4, 3, 3}));
}

// An export folder has such files: a report in colour, a mask, a damaged file.
TEST(Dicom, PicturesOfOtherSeriesThatAreNoneOfAVolumeAreLeftOut) {
  const TemporaryFolder folder;
  write_slices(folder);
  test::DicomElements colour = elements(9);
  colour.set(0x00280004, "CS", "RGB").set_word(0x00280002, 3);
  const auto of_series = [&](const char* uid) {
    write_bytes(folder / "other", test::dicom_file(colour.set(0x0020000e, "UI", uid)));
  };
  of_series("1.2.3.4");
  for (const char* chosen : {"", "1.2.3.6"})
    EXPECT_EQ(read_grey_volume(folder / "", {.dicom_series = chosen}).dims, (std::array<int, 3>{4, 3, 3}));
  EXPECT_THROW((void)read_grey_volume(folder / "", {.dicom_series = "1.2.3.4"}), Error);
  for (const char* name : {"more", "still more"}) write_bytes(folder / name, test::dicom_file(colour));
  test::expect_part(error_of(folder / ""), "; choose it with");
  EXPECT_EQ(read_grey_volume(folder / "", {.dicom_series = "1.2.3.6"}).dims, (std::array<int, 3>{4, 3, 3}));
  for (const char* name : {"more", "still more"}) std::filesystem::remove(folder / name);
  of_series("1.2.3.6");
  test::expect_part(error_of(folder / ""), "other': it has several values per sample");
  write_bytes(folder / "other", slice(4).substr(0, 300));
  const std::string refusal = error_of(folder / "");
  test::expect_part(refusal, "If it is not of the series, remove it from the folder.");
  for (int n = 1; n <= 3; ++n) std::filesystem::remove(folder / slice_name(n));
  test::expect_part(error_of(folder / ""), "other': ");
}

// The damaged name of a series contains a line break.
TEST(Dicom, SeveralSeriesAreListedInOneLine) {
  const TemporaryFolder folder;
  write_bytes(folder / slice_name(1), slice(1));
  std::string other = slice(2);
  other.replace(other.find("1.2.3.6"), 4, "1.\n2");
  write_bytes(folder / slice_name(2), other);
  const std::string refusal = error_of(folder / "");
  test::expect_part(refusal, "several DICOM series");
  EXPECT_EQ(refusal.find('\n'), std::string::npos) << refusal;
}

TEST(Dicom, PicturesBesideSlicesAreLeftOut) {
  const TemporaryFolder folder;
  write_slices(folder);
  const std::string png = test::png_slice(4, 3, std::vector<std::uint8_t>(12));
  for (const char* name : {"preview1.png", "preview2.png"}) write_bytes(folder / name, png);
  for (const char* series : {"", "1.2.3.6"}) {
    const GreyVolume scan =
        read_grey_volume(folder / "", {.spacing = Vec3(1, 1, 1) * units::mm, .dicom_series = series});
    EXPECT_EQ(scan.dims, (std::array<int, 3>{4, 3, 3}));
  }
}

TEST(Dicom, ASeriesOfFilesThatAreNotDicomIsRefused) {
  const TemporaryFolder folder;
  const std::string png = test::png_slice(4, 3, std::vector<std::uint8_t>(12));
  for (const char* name : {"1.png", "2.png"}) write_bytes(folder / name, png);
  test::expect_part(error_of(folder / "", {.spacing = Vec3(1, 1, 1) * units::mm, .dicom_series = "1.2.3.6"}),
                    "leave VolumeReadOptions::dicom_series out");
}

TEST(Dicom, AScoutOfTheSameSeriesIsReportedAndLeftOutIfTheSeriesIsNamed) {
  const TemporaryFolder folder;
  write_slices(folder);
  test::DicomElements scout = test::dicom_slice(2, 2, 0, {1, 2, 3, 4});
  write_bytes(folder / "a_scout", test::dicom_file(scout.set(0x00200037, "DS", "0\\1\\0\\0\\0\\-1")));
  const std::string refusal = error_of(folder / "");
  for (const char* part : {"'1.2.3.6' (3 files of 4 x 3 samples of 16 bits, 0.1 x 0.2 mm, facing 0, 0, 1)",
                           "'1.2.3.6#2' (1 file of 2 x 2 samples of 16 bits, 0.1 x 0.2 mm, facing -1, 0, 0)"})
    test::expect_part(refusal, part);
  EXPECT_EQ(read_grey_volume(folder / "", {.dicom_series = "1.2.3.6"}).dims, (std::array<int, 3>{4, 3, 3}));
}

TEST(Dicom, TwoKindsOfAsManySlicesMustBothBeNamedByNumber) {
  const TemporaryFolder folder;
  for (int n = 1; n <= 2; ++n) {
    write_bytes(folder / slice_name(n), slice(n));
    write_bytes(folder / slice_name(9 - n), test::dicom_file(test::dicom_slice(2, 1, 0.5 * n, {7, 7})));
  }
  EXPECT_THROW((void)read_grey_volume(folder / "", {.dicom_series = "1.2.3.6"}), Error);
  EXPECT_EQ(read_grey_volume(folder / "", {.dicom_series = "1.2.3.6#1"}).dims, (std::array<int, 3>{4, 3, 2}));
  EXPECT_EQ(read_grey_volume(folder / "", {.dicom_series = "1.2.3.6#2"}).dims, (std::array<int, 3>{2, 1, 2}));
}

/// Two frames of one sample, each a byte, as a file.
test::DicomElements two_frames() {
  test::DicomElements e = test::dicom_picture(1, 1, {});
  e.set(0x00280008, "IS", "2").set(0x00180088, "DS", "0.5").set(0x7fe00010, "OB", "\3\4").set_word(0x00280103, 0);
  return e.set_word(0x00280100, 8).set_word(0x00280101, 8).set_word(0x00280102, 7);
}

TEST(Dicom, AFileIsRecognizedByItsFirstBytesWithAnyExtension) {
  const TemporaryFolder folder;
  for (const char* name : {"IM000001", "a.IMA"}) {
    write_bytes(folder / name, test::dicom_file(two_frames()));
    EXPECT_EQ(read_grey_volume(folder / name).values, (std::vector<float>{-997, -996})) << name;
  }
  const TemporaryFolder one;
  write_bytes(one / "IM000001", test::dicom_file(two_frames()).substr(132));  // without the preamble
  for (const char* path : {"", "IM000001"})
    EXPECT_EQ(read_grey_volume(one / path).values, (std::vector<float>{-997, -996})) << path;
  const TemporaryFolder old;  // nor a meta header, as files of the nineties
  write_bytes(old / "explicit", two_frames().bytes());
  write_bytes(old / "implicit", two_frames().bytes(true));
  for (const char* name : {"explicit", "implicit"})
    EXPECT_EQ(read_grey_volume(old / name).values, (std::vector<float>{-997, -996})) << name;
}

TEST(Dicom, AWrongTransferSyntaxIsReported) {
  const TemporaryFolder folder;
  const std::string implicit = two_frames().bytes(true), said_explicit = test::dicom_file({});
  write_bytes(folder / "a.dcm", said_explicit + implicit);
  test::expect_part(error_of(folder / "a.dcm"), "transfer syntax that it names (1.2.840.10008.1.2.1)");
}

TEST(Dicom, ATableOfGreyValuesIsAppliedInPlaceOfTheScale) {
  const auto read = [](const std::string& layout) {
    test::DicomElements table;
    table.set(0x00283002, "US", layout).set(0x00283006, "US", test::little(std::vector<std::int16_t>{50, 60, 70}));
    test::DicomElements e = test::dicom_picture(3, 1, {9, 11, 12, 13, 10, -5});
    e.set(0x00280008, "IS", "2").set(0x00180088, "DS", "0.5").set_items(0x00283000, {table});
    const TemporaryFolder folder;
    write_bytes(folder / "a.dcm", test::dicom_file(e));
    return read_grey_volume(folder / "a.dcm").values;
  };
  const auto layout = [](std::int16_t count) { return test::little(std::vector<std::int16_t>{count, 10, 16}); };
  EXPECT_EQ(read(layout(3)), (std::vector<float>{50, 60, 70, 70, 50, 50}));
  EXPECT_THROW((void)read(layout(4)), Error);
  EXPECT_THROW((void)read("12"), Error);
}

TEST(Dicom, FloatPixelDataAreRefusedBySayingSo) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.dcm", test::dicom_file(two_frames().set(0x7fe00008, "OW", "1234")));
  test::expect_part(error_of(folder / "a.dcm"), "Float Pixel Data");
}

TEST(Dicom, FragmentsOfAFrameAreJoinedAndEndMarkersSeparateFrames) {
  const std::string end("\xff\xd9", 2);
  const auto frames_of = [&](const std::vector<std::string>& fragments) {
    const std::string bytes = test::dicom_file(two_frames().set_fragments(fragments), "1.2.840.10008.1.2.4.50");
    const DicomFile file = parse_dicom(bytes);
    std::vector<std::string> frames;
    (void)picture_values(file, describe_picture(file), [&](const auto&, const auto&, std::string_view packed) {
      frames.emplace_back(packed);
      return std::string(1, '\0');
    });
    return frames;
  };
  EXPECT_EQ(frames_of({"ab", "cd" + end, "ef", "gh", "i" + end + std::string(1, '\0')}),
            (std::vector<std::string>{"abcd" + end, "efghi" + end + std::string(1, '\0')}));
  EXPECT_EQ(frames_of({"ab", "cd"}), (std::vector<std::string>{"ab", "cd"}));
  EXPECT_THROW((void)frames_of({"ab", "cd" + end, "ef"}), Error);
}

TEST(Dicom, RunLengthsAreUnpacked) {
  // Two bytes of each value, the higher ones first: 12 zeros; then 3 times 7 and 9 different ones.
  const std::string high = std::string("\xf5\0", 2),
                    low = std::string("\xfe\x07\x08\x01\x02\x03\x04\x05\x06\x07\x08\x09");
  std::string header =
      test::little(std::uint32_t(2)) + test::little(std::uint32_t(64)) + test::little(std::uint32_t(66));
  header.resize(64, '\0');
  const std::string packed = header + high + low;
  const std::string values = unpack_rle(packed, 12, 2);
  EXPECT_EQ(values, test::little(std::vector<std::int16_t>{7, 7, 7, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  for (std::size_t length = 0; length < packed.size(); ++length)
    EXPECT_THROW((void)unpack_rle(std::string_view(packed).substr(0, length), 12, 2), Error) << length;
  const TemporaryFolder folder;
  for (int n = 1; n <= 2; ++n) write_bytes(folder / slice_name(n), compressed(n, "1.2.840.10008.1.2.5", packed));
  EXPECT_EQ(read_grey_volume(folder / "").values[3], 1 - 1000);  // Hounsfield units
}

TEST(Dicom, ADecoderThatDiesOrIsAbsentIsOneSentence) {
  const TemporaryFolder folder;
  for (int n = 1; n <= 2; ++n)
    write_bytes(folder / slice_name(n), compressed(n, "1.2.840.10008.1.2.4.80", "no picture"));
#ifdef HAPTICUT_HAS_ITK
  test::expect_part(error_of(folder / ""), "JPEG-LS, cannot be unpacked");
#else
  test::expect_part(error_of(folder / ""), "HAPTICUT_WITH_ITK=ON");
#endif
  ::setenv("HAPTICUT_DECODER", "/bin/false", 1);
  test::expect_part(error_of(folder / ""), "JPEG-LS, cannot be unpacked");
  ::setenv("HAPTICUT_DECODER", "/no/such/program", 1);
  test::expect_part(error_of(folder / ""), "cannot be started");
  ::unsetenv("HAPTICUT_DECODER");
}

TEST(Dicom, TheMessageForAMissingDecoderNamesItk) {
  ChildProgram unbuilt = kDecoder;
  unbuilt.name = "no-such-program";
  unbuilt.variable = "HAPTICUT_NO_SUCH_PROGRAM";
  unbuilt.installed = "";
  unbuilt.built = "";
  EXPECT_EQ(test::refusal([&] { ChildProcess(unbuilt).start(); }),
            "its values are compressed and must be unpacked, which needs ITK; this build of hapticut lacks it. "
            "Install libinsighttoolkit5-dev and build it with HAPTICUT_WITH_ITK=ON, or save the file uncompressed.");
}

}  // namespace
}  // namespace hapticut::dicom_test
