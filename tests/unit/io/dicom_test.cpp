// SPDX-License-Identifier: Apache-2.0
// DICOM files that the test writes itself: what is left out of a folder, run lengths, and the program that unpacks the
// rest.
#include <gtest/gtest.h>

#include <cstdlib>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/io/volume/volumes.hpp"
#include "io/child_process.hpp"
#include "io/dicom/dicom_picture.hpp"
#include "support/dicom_files.hpp"
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

/// The same slice with its values in one compressed part.
std::string compressed(int number, const std::string& syntax, const std::string& packed) {
  return test::dicom_file(elements(number).set_fragments({packed}), syntax);
}

std::string error_of(const std::filesystem::path& path) {
  try {
    (void)read_grey_volume(path);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Dicom, FilesWithoutAPictureInAFolderAreLeftOut) {
  const TemporaryFolder folder;
  for (int n = 1; n <= 3; ++n) write_bytes(folder / slice_name(n), slice(n));
  std::string report = slice(9);
  report.resize(report.rfind(kPixelElement));
  write_bytes(folder / "DICOMDIR", report);
  EXPECT_EQ(read_grey_volume(folder / "").dims, (std::array<int, 3>{4, 3, 3}));
}

// A damaged name of a series has a line break in it.
TEST(Dicom, SeveralSeriesAreListedInOneLine) {
  const TemporaryFolder folder;
  write_bytes(folder / slice_name(1), slice(1));
  std::string other = slice(2);
  other.replace(other.find("1.2.3.6"), 4, "1.\n2");
  write_bytes(folder / slice_name(2), other);
  const std::string refusal = error_of(folder / "");
  EXPECT_NE(refusal.find("several DICOM series"), std::string::npos) << refusal;
  EXPECT_EQ(refusal.find('\n'), std::string::npos) << refusal;
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
  EXPECT_NE(error_of(folder / "").find("JPEG-LS, cannot be unpacked"), std::string::npos) << error_of(folder / "");
#else
  EXPECT_NE(error_of(folder / "").find("HAPTICUT_WITH_ITK=ON"), std::string::npos) << error_of(folder / "");
#endif
  ::setenv("HAPTICUT_DECODER", "/bin/false", 1);
  EXPECT_NE(error_of(folder / "").find("JPEG-LS, cannot be unpacked"), std::string::npos) << error_of(folder / "");
  ::setenv("HAPTICUT_DECODER", "/no/such/program", 1);
  EXPECT_NE(error_of(folder / "").find("cannot be started"), std::string::npos) << error_of(folder / "");
  ::unsetenv("HAPTICUT_DECODER");
}

TEST(Dicom, ADecoderThatWasNotBuiltIsSaidToNeedItk) {
  ChildProgram unbuilt = kDecoder;
  unbuilt.name = "no-such-program";
  unbuilt.variable = "HAPTICUT_NO_SUCH_PROGRAM";
  unbuilt.installed = "";
  unbuilt.built = "";
  try {
    ChildProcess(unbuilt).start();
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.what(),
              std::string("its values are compressed and must be unpacked, which needs ITK; this build of hapticut is "
                          "without it. Install libinsighttoolkit5-dev and build it with HAPTICUT_WITH_ITK=ON, or save "
                          "the file uncompressed."));
  }
}

}  // namespace
}  // namespace hapticut::dicom_test
