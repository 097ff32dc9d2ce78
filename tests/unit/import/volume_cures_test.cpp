// SPDX-License-Identifier: Apache-2.0
// What a refusal of a reader of NRRD, MetaImage, NIfTI or InVesalius files tells the user to do makes the file
// readable.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <tuple>

#include "hapticut/core/units.hpp"
#include "support/cures.hpp"
#include "support/volume_files.hpp"

namespace hapticut::volume_cures_test {
namespace {

using test::Cure;
using test::expect_cured;
using test::NiftiFile;
using units::mm;

const VolumeReadOptions kSpaced = {.spacing = Vec3(0.1, 0.2, 0.7) * mm};

std::string bytes_of(int count) {
  std::string bytes(std::size_t(count), '\0');
  std::iota(bytes.begin(), bytes.end(), 1);
  return bytes;
}

/// A text with one part replaced.
std::string with(std::string text, const std::string& part, const std::string& other) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return at == std::string::npos ? text : text.replace(at, part.size(), other);
}

const std::string kNrrdHeader =
    "NRRD0005\ntype: uchar\nencoding: raw\ndimension: 3\nspace: LPS\nsizes: 4 3 5\n"
    "space directions: (0.1,0,0) (0,0.2,0) (0,0,0.7)\nspace origin: (1,2,3)\n";
const std::string kMetaHeader =
    "ObjectType = Image\nNDims = 3\nDimSize = 4 3 5\nElementSpacing = 0.1 0.2 0.7\nOffset = 1 2 3\n"
    "TransformMatrix = 1 0 0 0 1 0 0 0 1\nElementType = MET_UCHAR\n";

std::string nrrd(const std::string& header = kNrrdHeader, const std::string& data = bytes_of(60)) {
  return header + "\n" + data;
}
std::string nrrd(const std::string& part, const std::string& other, const std::string& data) {
  return nrrd(with(kNrrdHeader, part, other), data);
}
std::string meta(const std::string& header = kMetaHeader, const std::string& data = bytes_of(60)) {
  return header + "ElementDataFile = LOCAL\n" + data;
}
std::string meta(const std::string& part, const std::string& other, const std::string& data) {
  return meta(with(kMetaHeader, part, other), data);
}

/// @param sentence  of the file with `other` instead of `part`
Cure of_nrrd(const std::string& sentence, const std::string& part, const std::string& other) {
  return {sentence, "v.nrrd", {{"v.nrrd", nrrd(part, other, bytes_of(60))}}, {{"v.nrrd", nrrd()}}};
}
Cure of_meta(const std::string& sentence, const std::string& part, const std::string& other) {
  return {sentence, "v.mha", {{"v.mha", meta(part, other, bytes_of(60))}}, {{"v.mha", meta()}}};
}

TEST(CuresOfVolumes, AnEmptyFileIsCalledEmptyAndACompleteCopyIsRead) {
  NiftiFile nifti;
  nifti.values.resize(60);
  const std::pair<const char*, std::string> files[] = {
      {"v.nrrd", nrrd()},
      {"v.nhdr", nrrd()},
      {"v.mha", meta()},
      {"v.mhd", meta()},
      {"v.nii", nifti.bytes()},
      {"v.nii.gz", test::gzipped(nifti.bytes())},
      {"v.inv3", test::invesalius_project({4, 3, 5}, std::vector<std::int16_t>(60))}};
  for (const auto& [name, whole] : files)
    expect_cured({"it is empty. Get a complete copy.", name, {{name, ""}}, {{name, whole}}});
  const std::string header = kMetaHeader + "ElementDataFile = v.raw\n";
  expect_cured({"v.raw': it is empty", "v.mhd", {{"v.mhd", header}, {"v.raw", ""}}, {{"v.raw", bytes_of(60)}}});
}

TEST(CuresOfVolumes, ACutFileIsCalledSoAndACompleteCopyIsRead) {
  NiftiFile nifti;
  nifti.values.resize(60);
  const std::string packed = test::gzipped(nifti.bytes()),
                    archive = test::invesalius_project({4, 3, 5}, std::vector<std::int16_t>(60));
  const std::tuple<const char*, const char*, std::string> files[] = {{"v.nrrd", "Is it truncated?", nrrd()},
                                                                     {"v.mha", "Is it truncated?", meta()},
                                                                     {"v.nii", "Is it truncated?", nifti.bytes()},
                                                                     {"v.nii.gz", "damaged or truncated", packed},
                                                                     {"v.inv3", "damaged", archive}};
  for (const auto& [name, part, whole] : files)
    expect_cured({part, name, {{name, whole.substr(0, whole.size() - (whole == packed ? 8 : 20))}}, {{name, whole}}});
}

TEST(CuresOfVolumes, AGeometryThatIsMissingOrWrongIsReadOnceItIsWritten) {
  const std::string none = with(kMetaHeader, "ElementSpacing = 0.1 0.2 0.7\n", "");
  for (const Cure& cure : {
           Cure{"; set VolumeReadOptions::spacing.", "v.mha", {{"v.mha", meta(none)}}, {}, kSpaced},
           Cure{"set another one", "v.mha", {{"v.mha", meta("0.1 0.2 0.7", "9e9 9e9 9e9", bytes_of(60))}}, {}, kSpaced},
           Cure{"or set VolumeReadOptions::spacing.",
                "v.nrrd",
                {{"v.nrrd", nrrd(kNrrdHeader + "space units: \"inch\" \"inch\" \"inch\"\n")}},
                {},
                kSpaced},
           of_nrrd("Write the directions of three axes into its header", "(0,0.2,0)", "(0,0,0)"),
           of_nrrd("its origin is not finite. Check its header", "(1,2,3)", "(1,nan,3)"),
           of_meta("its origin is more than", "Offset = 1 2 3", "Offset = 1e12 2 3"),
           of_meta("the directions of its axes are not of length 1", "1 0 0 0 1 0", "2 0 0 0 2 0"),
           of_meta("resample it to a regular grid", "1 0 0 0 1 0", "1 0 0 0.2 0.98 0"),
           of_nrrd("write the matching one of", "LPS", "scanner-xyz"),
           of_nrrd("so it is not an axis of a volume", "space: LPS\n", "space: LPS\nkinds: RGB-color space space\n"),
           of_nrrd("save all in mm", "sizes:", "space units: \"mm\" \"mm\" \"um\"\nsizes:"),
           of_meta("it must be mm, um, cm or m", "NDims", "DistanceUnits = inch\nNDims"),
       })
    expect_cured(cure);
}

TEST(CuresOfVolumes, AHeaderWithAFieldThatIsNotAllowedIsReadOnceItHasAnAllowedOne) {
  for (const Cure& cure : {
           of_nrrd("it must be raw, gzip, bzip2, ascii or hex", "raw", "lzma"),
           of_nrrd("it must be a type of numbers", "uchar", "block"),
           of_nrrd("it must be 3 numbers", "sizes: 4 3 5", "sizes: 4 3"),
           of_nrrd("whole number of them along every axis", "sizes: 4 3 5", "sizes: 4 3 5.00000001"),
           of_nrrd("appears twice", "sizes: 4 3 5", "sizes: 4 3 5\nsizes: 4 3 5"),
           of_nrrd("has no field 'type'", "type: uchar\n", ""),
           of_nrrd("it must be little or big", "type: uchar", "type: short\nendian: middle"),
           of_nrrd("it must be 0 or more", "sizes:", "line skip: -1\nsizes:"),
           of_nrrd("it has fewer lines than its header says to skip", "sizes:", "line skip: 9\nsizes:"),
           of_meta("save them as MET_SHORT, MET_INT or MET_FLOAT", "MET_UCHAR", "MET_LONG"),
           of_meta("save the scaled values", "NDims", "ElementToIntensityFunctionSlope = 2\nNDims"),
           of_meta("save them as binary data", "NDims", "BinaryData = False\nNDims"),
           of_meta("it must be 3 numbers", "4 3 5", "4 3"),
           of_meta("a volume has one", "NDims", "ElementNumberOfChannels = 3\nNDims"),
           of_meta("and 0 where the values follow", "NDims", "HeaderSize = 7\nNDims"),
           of_meta("with compressed data it must be 0", "NDims", "CompressedData = True\nHeaderSize = -1\nNDims"),
           of_meta("or its header is damaged at", "NDims", "abc\nNDims"),
       })
    expect_cured(cure);
}

TEST(CuresOfVolumes, SeveralFilesOrVolumesAreReadOnceTheyAreOne) {
  const std::string one = kMetaHeader + "ElementDataFile = v.raw\n";
  for (const char* several : {"LIST\nv.raw\n", "v%02d.raw 1 5 1\n"})
    expect_cured({"save them as one",
                  "v.mhd",
                  {{"v.mhd", kMetaHeader + "ElementDataFile = " + several}, {"v.raw", bytes_of(60)}},
                  {{"v.mhd", one}}});
  NiftiFile nifti, timed;
  nifti.values.resize(60);
  timed.values.resize(120);
  timed.dims = {4, 3, 5, 2};
  expect_cured({"extract one volume first", "v.nii", {{"v.nii", timed.bytes()}}, {{"v.nii", nifti.bytes()}}});
}

TEST(CuresOfVolumes, ANiftiFileIsReadOnceItIsSavedAsItsRefusalSays) {
  NiftiFile file;
  file.values.resize(60);
  const std::string right = file.bytes();
  const auto changed = [&](std::size_t at, const std::string& bytes) {
    return std::string(right).replace(at, bytes.size(), bytes);
  };
  const std::pair<const char*, std::string> broken[] = {
      {"save both as one .nii", changed(344, "ni1")},
      {"save it as NIfTI", changed(344, std::string(4, '\0'))},
      {"save it as grey values or labels", changed(70, test::little(std::int16_t(128)))},
      {"Get a complete copy", changed(108, test::little(352.5F))},
      {"the offset of its values is not a finite number", changed(112, test::little(2.0F) + test::little(NAN))},
      {"it is too short for a NIfTI header", right.substr(0, 200)},
      {"it is not a NIfTI file", changed(0, "abcd")}};
  for (const auto& [sentence, bytes] : broken)
    expect_cured({sentence, "v.nii", {{"v.nii", bytes}}, {{"v.nii", right}}});

  NiftiFile negative = file;
  negative.spacing = {0.1F, -0.2F, 0.7F};
  NiftiFile mapped = negative;  // an affine map tells
  mapped.rows = {0.1F, 0, 0, 0, 0, -0.2F, 0, 0, 0, 0, 0.7F, 0};
  const char* const sentence = "its spacing (pixdim) is 0.1 x -0.2 x 0.7; a spacing must be positive";
  expect_cured({sentence, "v.nii", {{"v.nii", negative.bytes()}}, {{"v.nii", right}}});
  expect_cured({sentence, "v.nii", {{"v.nii", negative.bytes()}}, {{"v.nii", mapped.bytes()}}});
  negative.quaternion = {0, 0, 0, 1, 2, 3};
  expect_cured({sentence, "v.nii", {{"v.nii", negative.bytes()}}, {{"v.nii", mapped.bytes()}}});
}

TEST(CuresOfVolumes, ASpacingOfZeroIsReplacedByTheCallersAlsoWhereAQuaternionPlacesTheGrid) {
  NiftiFile file;
  file.values.resize(60);
  file.quaternion = {0, 0, 0, 1, 2, 3};
  file.spacing = {0, 0, 0};
  expect_cured({"; set VolumeReadOptions::spacing.", "v.nii", {{"v.nii", file.bytes()}}, {}, kSpaced});
}

TEST(CuresOfVolumes, ValuesThatAreNotOfTheirTypeAreReadOnceTheyAre) {
  const std::string ascii = with(kNrrdHeader, "raw", "ascii");
  const auto text = [](int count, const std::string& last) {
    std::string all;
    for (int n = 1; n < count; ++n) all += std::to_string(n) + " ";
    return all + last;
  };
  const auto refused = [&](const char* sentence, const std::string& values) {
    expect_cured({sentence, "v.nrrd", {{"v.nrrd", nrrd(ascii, values)}}, {{"v.nrrd", nrrd(ascii, text(60, "60\n"))}}});
  };
  refused("it has the value 1.00000001, which does not fit its type", text(60, "1.00000001"));
  refused("'x' among its values is not a number", text(60, "x"));
  refused("it has 59 values instead of 60", text(59, "7"));
  refused("it has more than 60 values: '61' follows them. Check the sizes", text(60, "60 61"));
  const std::string halves = with(with(kNrrdHeader, "uchar", "float"), "raw", "ascii");
  expect_cured(
      {.sentence = "it has the value 1.5, but labels are whole numbers from 0 to 65535. Read it as a grey volume",
       .path = "v.nrrd",
       .broken = {{"v.nrrd", nrrd(halves, text(60, "1.5"))}},
       .labels = true});
  const std::string big = with(kNrrdHeader, "uchar", "double\nendian: little");
  std::string values;
  for (int n = 0; n < 60; ++n) values += test::big(6e-154 * n);
  expect_cured({"too large for a grey value. Check its type and byte order",
                "v.nrrd",
                {{"v.nrrd", nrrd(big, values.replace(0, 8, test::little(1e300)))}},
                {{"v.nrrd", nrrd(with(big, "little", "big"), values.replace(0, 8, std::string(8, '\0')))}}});
}

TEST(CuresOfVolumes, MoreValuesThanAnnouncedAreReadOnceTheHeaderHasTheirSize) {
  const char* const sentence = "Check the type and the sizes that it names";
  const std::string more = bytes_of(240);  // 20 slices of 12 bytes
  const auto longer = [](const std::string& header) { return with(header, "4 3 5", "4 3 20"); };
  NiftiFile nifti, whole;
  nifti.values.resize(240, 7);
  whole = nifti;
  whole.dims = {4, 3, 20};
  for (const auto& [name, broken, cured] :
       {std::tuple("v.nrrd", nrrd(kNrrdHeader, more), nrrd(longer(kNrrdHeader), more)),
        std::tuple("v.mha", meta(kMetaHeader, more), meta(longer(kMetaHeader), more)),
        std::tuple("v.nii", nifti.bytes(), whole.bytes()),
        std::tuple("v.nii.gz", test::gzipped(nifti.bytes()), test::gzipped(whole.bytes()))})
    expect_cured({sentence, name, {{name, broken}}, {{name, cured}}});
  const std::string packed = with(kNrrdHeader, "raw", "gzip");
  expect_cured({sentence,
                "v.nrrd",
                {{"v.nrrd", nrrd(packed, test::gzipped(bytes_of(190)))}},
                {{"v.nrrd", nrrd(packed, test::gzipped(bytes_of(60)))}}});
}

TEST(CuresOfVolumes, BytesBehindTheValuesThatAreNoZerosAreNotReadHoweverFew) {
  NiftiFile nifti;
  nifti.values.resize(60, 7);
  const std::pair<const char*, std::string> files[] = {{"v.nrrd", nrrd()}, {"v.mha", meta()}, {"v.nii", nifti.bytes()}};
  for (const auto& [name, whole] : files)
    for (const std::size_t count : {1U, 5U, 30U})
      expect_cured({"Check the type and the sizes that it names",
                    name,
                    {{name, whole + std::string(count, '\1')}},
                    {{name, whole + std::string(count, '\0')}}});
}

// A transfer as a text has put a CR before each LF; the last bytes, which are too many, are the background.
TEST(CuresOfVolumes, ACopyAsATextIsReadOnceItIsCopiedAsBinaryData) {
  std::string values(60, '\0'), copied;
  for (const std::size_t at : {5U, 20U, 21U}) values[at] = '\n';
  for (const char c : values) copied += c == '\n' ? "\r\n" : std::string(1, c);
  expect_cured({"it was copied as a text, which has put 3 bytes (CR) among its values. Copy it as binary data.",
                "v.nrrd",
                {{"v.nrrd", nrrd(kNrrdHeader, copied)}},
                {{"v.nrrd", nrrd(kNrrdHeader, values)}}});
}

TEST(CuresOfVolumes, ExtensionsOfANiftiFileAreReadOnceItSaysWhereItsValuesBegin) {
  NiftiFile nifti;
  nifti.values.resize(60, 7);
  std::string plain = nifti.bytes(), flagged = plain;
  flagged[348] = 1;
  std::string extended = flagged.substr(0, 352) + test::little(std::int32_t(16)) + test::little(std::int32_t(6)) +
                         std::string(8, 'x') + plain.substr(352);
  extended.replace(108, 4, test::little(368.0F));
  const char* const sentence = "its values begin at byte 352, too. Write the position of the values into its header";
  for (const std::string& cured : {plain, extended})
    expect_cured({sentence, "v.nii", {{"v.nii", flagged}}, {{"v.nii", cured}}});
}

TEST(CuresOfVolumes, AWebPageInPlaceOfAFileIsCalledSoAndTheFileIsRead) {
  const std::string page = "\n<!DOCTYPE html>\n<html><head><title>404</title></head></html>\n";
  NiftiFile nifti;
  nifti.values.resize(60, 7);
  const std::pair<const char*, std::string> files[] = {
      {"v.nrrd", nrrd()}, {"v.mha", meta()}, {"v.nii", nifti.bytes()}, {"v.nii.gz", test::gzipped(nifti.bytes())}};
  for (const auto& [name, whole] : files)
    expect_cured({"it is a web page in place of the file: a download went wrong, so download the file itself.",
                  name,
                  {{name, page}},
                  {{name, whole}}});
}

TEST(CuresOfVolumes, AnArchiveIsReadOnceItIsUnpacked) {
  const std::pair<const char*, std::string> files[] = {{"v.nrrd", nrrd()}, {"v.mha", meta()}};
  for (const auto& [name, whole] : files)
    for (const std::string& packed_as : {std::string(name), std::string(name) + ".gz", std::string("v.dcm")})
      expect_cured({packed_as + "': it is a gzip archive; unpack it, and name the volume in it.",
                    packed_as,
                    {{packed_as, test::gzipped(whole)}},
                    {{name, whole}},
                    {},
                    false,
                    name});
}

TEST(VolumeFiles, MayHaveZerosBehindTheirValues) {
  const std::string zeros(512, '\0'), few(7, '\0');
  NiftiFile nifti;
  nifti.values.resize(60, 7);
  const std::string detached = kMetaHeader + "ElementDataFile = v.raw\n";
  const test::Files files[] = {{{"v.nrrd", nrrd() + zeros}},
                               {{"v.mha", meta() + zeros}},
                               {{"v.nii", nifti.bytes() + zeros}},
                               {{"v.nii.gz", test::gzipped(nifti.bytes() + zeros)}},
                               {{"v.mhd", detached}, {"v.raw", bytes_of(60) + few}}};
  for (const test::Files& content : files) {
    const test::TemporaryFolder folder;
    write_files(folder, content);
    const GreyVolume volume = read_grey_volume(folder / content.begin()->first);
    EXPECT_EQ(volume.dims, (std::array<int, 3>{4, 3, 5})) << content.begin()->first;
  }
}

TEST(VolumeFiles, MayHaveAPercentSignInTheNamesOfTheirData) {
  for (const char* name : {"DS 0.75 77 %.zraw", "50%.raw", "a%d.raw", "LISTER.raw", "5%03d x 1 2.raw"}) {
    const test::TemporaryFolder folder;
    test::write_bytes(folder / name, bytes_of(60));
    test::write_bytes(folder / "v.mhd", kMetaHeader + "ElementDataFile = " + name + "\n");
    test::write_bytes(folder / "v.nhdr", kNrrdHeader + "data file: " + name + "\n");
    for (const char* header : {"v.mhd", "v.nhdr"})
      EXPECT_EQ(test::refusal([&] { EXPECT_EQ(read_grey_volume(folder / header).values[59], 60); }), "")
          << header << ", " << name;
  }
}

}  // namespace
}  // namespace hapticut::volume_cures_test
