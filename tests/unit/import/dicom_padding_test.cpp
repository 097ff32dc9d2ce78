// SPDX-License-Identifier: Apache-2.0
// Padding: the value of samples without a measurement, treated as air.
#include <gtest/gtest.h>

#include "hapticut/core/errors.hpp"
#include "hapticut/import/volume/volumes.hpp"
#include "support/dicom_files.hpp"
#include "support/temporary_folder.hpp"

namespace hapticut::dicom_padding_test {
namespace {

using test::DicomElements;
using test::little;

constexpr std::uint32_t kIntercept = 0x00281052, kPadding = 0x00280120, kLimit = 0x00280121, kPixels = 0x7fe00010;
constexpr float kAir = -1000;

/// Two slices with the values 1 to 4, modified by `change`.
template <class Change>
GreyVolume two_slices(const Change& change, const std::string& syntax = "1.2.840.10008.1.2.1") {
  const test::TemporaryFolder folder;
  for (int k = 0; k < 2; ++k) {
    DicomElements e = test::dicom_slice(2, 2, 0.5 * k, {1, 2, 3, 4});
    change(e);
    test::write_bytes(folder / test::slice_name(k), test::dicom_file(e, syntax));
  }
  return read_grey_volume(folder / "");
}

/// Two slices with given values and padding.
GreyVolume with_padding(const std::vector<std::int16_t>& values, bool has_sign, const std::string& kind,
                        const std::string& padding, const std::string& limit = "", int stored = 16) {
  return two_slices([&](DicomElements& e) {
    e.set(kPixels, "OW", little(values)).set_word(0x00280103, has_sign ? 1 : 0).set(kPadding, kind, padding);
    e.set_word(0x00280101, std::uint16_t(stored)).set_word(0x00280102, std::uint16_t(stored - 1));
    if (!limit.empty()) e.set(kLimit, kind, limit);
  });
}

void expect_slices(const GreyVolume& volume, const std::vector<float>& slice, std::size_t padding) {
  ASSERT_EQ(volume.values.size(), 2 * slice.size());
  for (std::size_t n = 0; n < volume.values.size(); ++n) EXPECT_EQ(volume.values[n], slice[n % slice.size()]) << n;
  EXPECT_EQ(volume.padding, padding);
}

TEST(DicomPadding, OfTheHighestValueIsAirAtAnyScale) {
  expect_slices(with_padding({-1, 2, 3, -1}, false, "US", little(std::uint16_t(65535))), {kAir, -998, -997, kAir}, 4);
}

TEST(DicomPadding, IsNothingWhereTheFileNamesNone) {
  expect_slices(two_slices([](DicomElements&) {}), {-999, -998, -997, -996}, 0);
  expect_slices(with_padding({1, 2, 3, 4}, true, "SS", ""), {-999, -998, -997, -996}, 0);
}

TEST(DicomPadding, HasTheSignOfThePictureForAnyKindOfElement) {
  const std::string bytes = little(std::int16_t(-2000));
  for (const char* kind : {"SS", "US"})
    expect_slices(with_padding({-2000, 2, -1999, 4}, true, kind, bytes), {-2999, -998, -2999, -996}, 2);
  expect_slices(with_padding({-2000, 2, 3, 4}, false, "SS", bytes), {kAir, -998, -997, -996}, 2);
}

TEST(DicomPadding, IsARangeWithALimitOnEitherSide) {
  const std::string low = little(std::int16_t(-2000)), high = little(std::int16_t(-1990));
  const std::vector<std::int16_t> values = {-2000, -1990, -1989, 500};
  const std::vector<float> read = {-2989, -2989, -2989, -500};
  expect_slices(with_padding(values, true, "SS", low, high), read, 4);
  expect_slices(with_padding(values, true, "SS", high, low), read, 4);
}

TEST(DicomPadding, BeyondTheBitsStoredIsComparedWithWholeWords) {
  // The lowest 12 bits of 63536 are 2096, which is a value of the scan.
  const std::string padding = little(std::uint16_t(63536));
  expect_slices(with_padding({-2000, 2096, 3, 4}, false, "US", padding, "", 12), {kAir, 1096, -997, -996}, 2);
  // As a signed word 63536 is -2000, which 12 bits can hold.
  expect_slices(with_padding({-2000, 2097, 3, 4}, true, "US", padding, "", 12), {-2999, -2999, -997, -996}, 2);
}

TEST(DicomPadding, IsFoundInPicturesOf8BitsAndInInvertedOnes) {
  const auto bytes = [](DicomElements& e) {
    e.set(kPixels, "OB", "\x01\xff\x03\xff").set_word(0x00280103, 0);
    e.set_word(0x00280100, 8).set_word(0x00280101, 8).set_word(0x00280102, 7).set_word(kPadding, 255);
  };
  expect_slices(two_slices(bytes), {-999, kAir, -997, kAir}, 4);
  const auto inverted = [](DicomElements& e) {
    e.set(0x00280004, "CS", "MONOCHROME1").set_word(kPadding, 0);
    e.set(kPixels, "OW", little(std::vector<std::int16_t>{0, 7, 0, 9})).set(kIntercept, "DS", "0");
  };
  expect_slices(two_slices(inverted), {kAir, 7, kAir, 9}, 4);
}

TEST(DicomPadding, IsFoundInCompressedPictures) {
  // Run lengths: the higher bytes, then the lower ones.
  const std::string segment("\x03\1\2\3\4", 5), highest("\x03\xff\xff\0\0", 5);
  std::string packed = little(std::uint32_t(2)) + little(std::uint32_t(64)) + little(std::uint32_t(69));
  packed.resize(64, '\0');
  packed += highest + segment;
  const auto change = [&](DicomElements& e) { e.set_fragments({packed}).set_word(kPadding, 0xff01); };
  expect_slices(two_slices(change, "1.2.840.10008.1.2.5"), {-1254, -1254, -997, -996}, 2);
}

TEST(DicomPadding, IsReadFromTheFileOrFromAnyFunctionalGroup) {
  const auto read = [](int where) {
    DicomElements e = test::dicom_picture(2, 1, {7, 1, 7, 1}), converted, other, shared;
    e.set(0x00280008, "IS", "2").set(0x00180088, "DS", "0.5");
    converted.set_word(kPadding, 7);
    other.set_word(kPadding, 1);
    std::vector<DicomElements> frames(2);
    if (where == 0) e.set_word(kPadding, 7);
    if (where == 1) shared.set_items(0x00209170, {converted});  // from a converter, shared by all slices
    if (where == 2) shared.set_items(0x00289145, {converted});  // the group of the scale
    if (where == 3) frames[0].set_items(0x00209171, {converted}), frames[1].set_items(0x00209171, {other});
    e.set_items(0x52009229, {shared}).set_items(0x52009230, frames);
    const test::TemporaryFolder folder;
    test::write_bytes(folder / "a.dcm", test::dicom_file(e));
    return read_grey_volume(folder / "a.dcm");
  };
  for (const int where : {0, 1, 2}) expect_slices(read(where), {kAir, -999}, 2);
  const GreyVolume each = read(3);
  EXPECT_EQ(each.values, (std::vector<float>{kAir, -999, -993, kAir}));
  EXPECT_EQ(each.padding, 2U);
}

TEST(DicomPadding, IsTheLabelOfNothing) {
  const test::TemporaryFolder folder;
  for (int k = 0; k < 2; ++k) {
    DicomElements e = test::dicom_slice(2, 2, 0.5 * k, {-2000, 2, 3, 4});
    e.set(kPadding, "SS", little(std::int16_t(-2000))).set(kIntercept, "DS", "0");
    test::write_bytes(folder / test::slice_name(k), test::dicom_file(e));
  }
  const LabelVolume labels = read_label_volume(folder / "");
  EXPECT_EQ(labels.values, (std::vector<std::uint16_t>{0, 2, 3, 4, 0, 2, 3, 4}));
  EXPECT_EQ(labels.padding, 2U);
}

TEST(DicomPadding, ThatIsNotOneNumberIsRefused) {
  EXPECT_THROW((void)with_padding({1, 2, 3, 4}, true, "SS", std::string(6, '\1')), Error);
}

}  // namespace
}  // namespace hapticut::dicom_padding_test
