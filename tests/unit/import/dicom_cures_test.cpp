// SPDX-License-Identifier: Apache-2.0
// What a refusal of a DICOM series or of a folder of pictures tells the user to do makes it readable.
#include <gtest/gtest.h>

#include <sys/stat.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <tuple>

#include "hapticut/core/units.hpp"
#include "support/cures.hpp"
#include "support/dicom_files.hpp"

namespace hapticut::dicom_cures_test {
namespace {

using test::Cure;
using test::DicomElements;
using test::expect_cured;
using test::Files;
using test::slice_name;
using units::mm;

constexpr std::uint32_t kSeries = 0x0020000e, kPosition = 0x00200032, kOrientation = 0x00200037;

DicomElements elements(int number) {
  return test::dicom_slice(4, 3, 0.7 * number, std::vector<std::int16_t>(12, std::int16_t(number + 1)));
}
std::string slice(int number) { return test::dicom_file(elements(number)); }

/// Four slices of a series, s0 to s3, with other files.
Files series(const Files& others = {}) {
  Files files = others;
  for (int n = 0; n < 4; ++n) files.emplace(slice_name(n) + ".dcm", slice(n));
  return files;
}

/// Four frames without positions.
DicomElements frames() {
  DicomElements e = test::dicom_picture(4, 3, std::vector<std::int16_t>(48, 7));
  return e.set(0x00280008, "IS", "4").set(0x00180088, "DS", "0.7").set(kOrientation, "DS", "1\\0\\0\\0\\1\\0");
}

/// A refusal of four frames, as changed; the cure is the file without the change.
Cure of_frames(const std::string& sentence, const std::function<void(DicomElements&)>& change) {
  DicomElements broken = frames();
  change(broken);
  return {sentence, "v.dcm", {{"v.dcm", test::dicom_file(broken)}}, {{"v.dcm", test::dicom_file(frames())}}};
}

std::string cut_before(std::uint32_t tag) {
  DicomElements e = elements(3);
  e.values.erase(e.values.lower_bound(tag), e.values.end());
  return test::dicom_file(e);
}

// A copy that ended early: the last files are empty, begin with zeros, or end somewhere.
TEST(CuresOfDicom, ASliceThatIsEmptyOrCutIsNamedAndTheSeriesIsReadWithACompleteOneOrWithoutIt) {
  const std::string whole = slice(3), packed = test::gzipped(whole);
  const std::pair<const char*, std::string> cuts[] = {
      {"it is empty. Get a complete copy of it. If it is not of the series, remove it", ""},
      {"it is no DICOM file. Get a complete copy of it. If it is not of the series, remove it", whole.substr(0, 100)},
      {"it is a web page in place of the file: a download went wrong, so download the file itself", "<html>404</html>"},
      {"it is a gzip archive. Unpack it.", packed},
      {"it ends too early", whole.substr(0, whole.size() - 10)},
      {"", whole.substr(0, 200)},
      {"it has no picture: it ends before one, or never had one. Get a complete copy of it. If it",
       cut_before(0x7fe00010)},
      {"it has no picture", cut_before(0x00280010)},
      {"it has no picture", cut_before(0x0020000e)},
      {"it has no picture", cut_before(0x00080016)}};
  for (const auto& [sentence, bytes] : cuts)
    for (const std::optional<std::string>& cure : {std::optional(whole), std::optional<std::string>()}) {
      const std::string named = std::string("s3.dcm': ") + sentence;
      expect_cured({named, "", series({{"s3.dcm", bytes}}), {{"s3.dcm", cure}}});
    }
  expect_cured({"The folder has 2 such files.",
                "",
                series({{"s2.dcm", ""}, {"s3.dcm", ""}}),
                {{"s2.dcm", slice(2)}, {"s3.dcm", whole}}});
}

TEST(CuresOfDicom, AnUnfinishedDownloadAndAnEmptyFileWithoutExtensionAreNamed) {
  expect_cured({"s4.dcm.part': it is empty", "", series({{"s4.dcm.part", ""}}), {{"s4.dcm.part", std::nullopt}}});
  Files bare;
  for (int n = 0; n < 4; ++n) bare.emplace(std::string("A").append(std::to_string(n)).append("F"), slice(n));
  bare.emplace("Q3", std::string(90, '\0'));
  expect_cured({"Q3': it is no DICOM file", "", bare, {{"Q3", std::nullopt}}});
}

// A repository or a folder in a cloud, of which not all was fetched, and what else may stand for a slice.
TEST(CuresOfDicom, WhatStandsInPlaceOfASliceIsNamedAndTheSeriesIsReadWithTheSliceOrWithoutIt) {
  namespace fs = std::filesystem;
  using Put = std::function<void(const fs::path&)>;
  const auto bytes = [](const std::string& content) {
    return Put([content](const fs::path& path) { test::write_bytes(path, content); });
  };
  const Put link = [](const fs::path& path) { fs::create_symlink(path.parent_path() / "annex" / "s3", path); };
  const std::tuple<const char*, Put, const char*> puts[] = {
      {"s3.dcm", link, "it is a link to a file that is not there. Get that file (in a repository of git-annex"},
      {"s3.dcm", [](const fs::path& path) { EXPECT_EQ(::mkfifo(path.c_str(), 0600), 0); }, "it is a pipe or a device."},
      {"s3.dcm", [](const fs::path& path) { fs::create_directory(path); }, "it is a folder. Name it without"},
      {".s3.dcm.icloud", bytes("bplist00"), "it is not downloaded yet from iCloud."},
      {"s3.jpg", bytes("\xff\xd8\xff"), "it is no DICOM file."},
      {"s3.png", bytes("\x89PNG"), "it is no DICOM file."}};
  for (const auto& [name, put, sentence] : puts) {
    SCOPED_TRACE(std::string(name) + ": " + sentence);
    const test::TemporaryFolder folder;
    write_files(folder, series({{"s3.dcm", std::nullopt}}));
    put(folder / name);
    const auto read = [&] { return read_grey_volume(folder / "").dims; };
    test::expect_refused(read, std::string(name) + "': " + sentence);
    fs::remove(folder / name);
    EXPECT_EQ(read(), (std::array<int, 3>{4, 3, 3})) << "without it";
    write_files(folder, series());
    EXPECT_EQ(read(), (std::array<int, 3>{4, 3, 4})) << "with the slice";
  }
}

TEST(CuresOfDicom, ASliceThatMayNotBeReadIsReadOnceItMay) {
  namespace fs = std::filesystem;
  const test::TemporaryFolder folder;
  write_files(folder, series());
  fs::permissions(folder / "s3.dcm", fs::perms::none);
  if (std::ifstream(folder / "s3.dcm")) GTEST_SKIP() << "this user may read everything";
  test::expect_refused([&] { return read_grey_volume(folder / ""); },
                       "s3.dcm': it cannot be opened. Check its permissions.");
  fs::permissions(folder / "s3.dcm", fs::perms::owner_read);
  EXPECT_EQ(read_grey_volume(folder / "").dims, (std::array<int, 3>{4, 3, 4}));
}

TEST(SlicesOfAFolder, LeaveOutThoseOfItsFoldersWithARemark) {
  const VolumeReadOptions spaced = {.spacing = Vec3(1, 1, 1) * mm};
  const std::string png = test::png_slice(4, 3, std::vector<std::uint8_t>(12, 7));
  for (const auto& [files, more, kind] :
       {std::tuple(series(), std::pair("s4.dcm", slice(4)), "DICOM files"),
        std::tuple(Files{{"s0.png", png}, {"s1.png", png}}, std::pair("s2.png", png), "PNG or TIFF files")}) {
    SCOPED_TRACE(kind);
    const test::TemporaryFolder folder;
    write_files(folder, files);
    for (const char* name : {"empty", "more", "notes", ".git"}) std::filesystem::create_directory(folder / name);
    test::write_bytes(folder / "notes/a.txt", "text");
    test::write_bytes(std::filesystem::path(folder / ".git") / more.first, more.second);
    EXPECT_TRUE(read_grey_volume(folder / "", spaced).remarks.empty());
    test::write_bytes(std::filesystem::path(folder / "more") / more.first, more.second);
    const std::vector<std::string> remarks = read_grey_volume(folder / "", spaced).remarks;
    ASSERT_EQ(remarks.size(), 1U);
    test::expect_part(remarks[0], std::string("has a folder with ") + kind + " that is not read, 'more'.");
  }
}

TEST(CuresOfDicom, ASeriesInTwoFilesOfFramesIsReadAsTheirPartsOrAsOneFile) {
  DicomElements whole = test::dicom_picture(4, 3, std::vector<std::int16_t>(96, 7));
  whole.set(0x00280008, "IS", "8").set(0x00180088, "DS", "0.7").set(kOrientation, "DS", "1\\0\\0\\0\\1\\0");
  expect_cured(
      {"its DICOM series is in 2 files of 4 frames, the first is 'a.dcm'. If each is a part of the volume, "
       "join them in one file",
       "",
       {{"a.dcm", test::dicom_file(frames())}, {"b.dcm", test::dicom_file(frames())}},
       {{"a.dcm", test::dicom_file(whole)}, {"b.dcm", std::nullopt}}});
}

TEST(CuresOfDicom, ASegmentationOfBitsIsReadOnceItIsSavedAsNrrd) {
  const std::string bits = test::dicom_file(frames().set_word(0x00280100, 1));
  expect_cured({"a segmentation (DICOM SEG); save it as labels in NRRD or NIfTI, e.g. by dcmqi",
                "v.dcm",
                {{"v.dcm", bits}},
                {{"v.dcm", test::dicom_file(frames())}}});
}

TEST(Dicom, NotesReportsAndPreviewsBesideSlicesAreNoLostSlices) {
  DicomElements report;
  report.set(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.88.11").set(kSeries, "UI", "1.2.3.9");
  const test::TemporaryFolder folder;
  write_files(folder, series({{"README", "text"},
                              {"s0.json", "{}"},
                              {"s0.dcm.json", "{}"},
                              {"s0.png", "preview"},
                              {".s9.dcm", ""},
                              {"._s0.dcm", "of macOS"},
                              {"DICOMDIR", cut_before(0x7fe00010)},
                              {"report.dcm", test::dicom_file(report)}}));
  const GreyVolume volume = read_grey_volume(folder / "");
  EXPECT_EQ(volume.dims, (std::array<int, 3>{4, 3, 4}));
  EXPECT_TRUE(volume.remarks.empty());
}

TEST(Dicom, FilesThatAreLeftOutAreRemarked) {
  DicomElements colour = elements(9);
  colour.set(0x00280004, "CS", "RGB").set_word(0x00280002, 3).set(kSeries, "UI", "1.2.3.4");
  const test::TemporaryFolder folder;
  write_files(folder, series({{"other", test::dicom_file(colour)}}));
  const std::vector<std::string> remarks = read_grey_volume(folder / "").remarks;
  ASSERT_EQ(remarks.size(), 1U);
  test::expect_part(remarks[0], "1 file of another series that is left out, 'other': it has several values per sample");

  test::write_bytes(folder / "scout", test::dicom_file(test::dicom_slice(2, 2, 0, {1, 2, 3, 4})));
  const std::vector<std::string> scout = read_grey_volume(folder / "", {.dicom_series = "1.2.3.6"}).remarks;
  ASSERT_EQ(scout.size(), 1U);
  test::expect_part(scout[0], "slices of another kind in the series, which are left out: '1.2.3.6#2' (1 file of 2 x 2");
}

TEST(CuresOfDicom, SeveralSeriesAreReadOneByOneAndMissingOrDoubleSlicesAreAddedOrRemoved) {
  const std::string other = test::dicom_file(elements(0).set(kSeries, "UI", "1.2.3.4"));
  expect_cured({"Choose one with VolumeReadOptions::dicom_series.",
                "",
                series({{"t0.dcm", other}}),
                {},
                {.dicom_series = "1.2.3.6"}});
  expect_cured({"planes between them are missing. Get a complete copy",
                "",
                series({{"s1.dcm", std::nullopt}, {"s4.dcm", slice(4)}, {"s5.dcm", slice(5)}}),
                {{"s1.dcm", slice(1)}}});
  expect_cured({"one is a duplicate", "", series({{"copy.dcm", slice(2)}}), {{"copy.dcm", std::nullopt}}});
  expect_cured({"has only one slice; a volume needs two", "", {{"s0.dcm", slice(0)}}, {{"s1.dcm", slice(1)}}});
}

TEST(CuresOfDicom, FramesAreReadOnceTheirHeaderIsRight) {
  expect_cured(of_frames("need only 48; its number of frames, or its size, is wrong. Get a complete copy.",
                         [](DicomElements& e) { e.set(0x00280008, "IS", "2"); }));
  expect_cured(of_frames("Is it truncated?", [](DicomElements& e) { e.set(0x00280008, "IS", "9"); }));
  expect_cured(of_frames("its number of frames is 4.00000001; it must be a whole number",
                         [](DicomElements& e) { e.set(0x00280008, "IS", "4.00000001"); }));
  expect_cured(of_frames("save it with whole numbers", [](DicomElements& e) { e.set(0x7fe00008, "OW", "1234"); }));
  expect_cured(of_frames("Convert it to grey values or labels", [](DicomElements& e) { e.set_word(0x00280002, 3); }));
  expect_cured(
      of_frames("only grey values are supported", [](DicomElements& e) { e.set(0x00280004, "CS", "YBR_FULL"); }));
  expect_cured(of_frames("supported are 8, 16 and 32 bits", [](DicomElements& e) { e.set_word(0x00280100, 12); }));
  expect_cured(of_frames("its rescale slope is 0", [](DicomElements& e) { e.set(0x00281053, "DS", "0"); }));
  expect_cured(of_frames("with decimal points", [](DicomElements& e) { e.set(0x00280030, "DS", "0,2\\0,1"); }));
  expect_cured(of_frames("Save it as separate slices first",
                         [](DicomElements& e) { e.set(0x00080008, "CS", "ORIGINAL\\MOSAIC"); }));
  DicomElements none = frames();
  none.values.erase(0x00280030);
  expect_cured({"; set VolumeReadOptions::spacing.",
                "v.dcm",
                {{"v.dcm", test::dicom_file(none)}},
                {},
                {.spacing = Vec3(0.1, 0.2, 0.7) * mm}});
  expect_cured({"it is a single slice; name the folder of its series",
                "s0.dcm",
                series(),
                {{"s0.dcm", test::dicom_file(frames())}}});
}

TEST(CuresOfDicom, MoreFunctionalGroupsThanFramesAreReadOnceTheirNumberIsRight) {
  const auto file = [](const char* count) {
    std::vector<DicomElements> groups;
    for (int n = 0; n < 4; ++n) {
      DicomElements position, group;
      position.set(kPosition, "DS", test::dicom_numbers(1, 2, 0.7 * n));
      groups.push_back(group.set_items(0x00209113, {position}));
    }
    return test::dicom_file(frames().set(0x00280008, "IS", count).set_items(0x52009230, groups));
  };
  expect_cured({"its number of frames is 3, but its functional groups describe 4",
                "v.dcm",
                {{"v.dcm", file("3")}},
                {{"v.dcm", file("4")}}});
}

TEST(Dicom, BytesBehindThePictureAreNotRead) {
  const test::TemporaryFolder folder;
  const Files others = {{"s0.dcm", slice(0) + std::string(512, '\0')}, {"s1.dcm", slice(1) + "more"}};
  write_files(folder, series(others));
  EXPECT_EQ(read_grey_volume(folder / "").dims, (std::array<int, 3>{4, 3, 4}));
  for (const std::size_t zeros : {2U, 24U, 512U}) {  // padding of the picture itself
    DicomElements e = frames();
    e.values[0x7fe00010].second += std::string(zeros, '\0');
    test::write_bytes(folder / "v.dcm", test::dicom_file(e));
    EXPECT_EQ(read_grey_volume(folder / "v.dcm").dims, (std::array<int, 3>{4, 3, 4})) << zeros;
  }
}

TEST(CuresOfPictures, FoldersOfPicturesAreReadOnceTheyAreComplete) {
  const VolumeReadOptions spaced = {.spacing = Vec3(1, 1, 1) * mm};
  const std::string png = test::png_slice(4, 3, std::vector<std::uint8_t>(12, 7)),
                    tiff = test::tiff_slice(4, 3, std::vector<std::uint8_t>(12, 7)),
                    wide = test::png_slice(5, 3, std::vector<std::uint8_t>(15, 7));
  for (const auto& kind : {std::pair(".png", png), std::pair(".tif", tiff)}) {
    const std::string extension = kind.first, &whole = kind.second;
    const auto pictures = [&](const Files& others) {
      Files files = others;
      for (int n = 0; n < 4; ++n) files.emplace(slice_name(n) + extension, whole);
      return files;
    };
    const auto refused = [&](const std::string& sentence, const std::string& name,
                             const std::optional<std::string>& bytes, const std::optional<std::string>& cure) {
      SCOPED_TRACE(sentence);
      const test::TemporaryFolder folder;
      write_files(folder, pictures({{name, bytes}}));
      test::expect_refused([&] { return read_grey_volume(folder / "", spaced); }, sentence);
      write_files(folder, {{name, cure}});
      EXPECT_EQ(test::refusal([&] { return read_grey_volume(folder / "", spaced); }), "");
    };
    refused("it is empty. Get a complete copy.", "s3" + extension, "", whole);
    refused("damaged", "s3" + extension, whole.substr(0, whole.size() - 40), whole);
    refused("one is missing", "s2" + extension, std::nullopt, whole);
    refused("'s4.bmp' has the name of a slice, but it is no PNG or TIFF file", "s4.bmp", "BM", std::nullopt);
    refused("'s4" + extension + ".part' has the name of a slice, but it is empty", "s4" + extension + ".part", "",
            std::nullopt);
    refused("Move the file elsewhere", "cover" + extension, whole, std::nullopt);
  }
  const test::TemporaryFolder folder;
  write_files(folder, {{"s0.png", png}, {"s1.png", wide}, {"s1.jpg", "preview"}, {"notes.txt", ""}});
  test::expect_refused([&] { return read_grey_volume(folder / "", spaced); },
                       "it differs from the first slice in size");
  write_files(folder, {{"s1.png", png}});
  EXPECT_EQ(read_grey_volume(folder / "", spaced).dims, (std::array<int, 3>{4, 3, 2}));
}

}  // namespace
}  // namespace hapticut::dicom_cures_test
