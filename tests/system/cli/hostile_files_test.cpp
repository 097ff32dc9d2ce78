// SPDX-License-Identifier: Apache-2.0
// Files that some reader misread, each with its required outcome: the right result, or one sentence that names the file
// and the cause. Never a signal, a hang, a message of another library, or a wrong volume.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>

#include "support/program.hpp"
#include "support/test_data.hpp"

namespace hapticut::hostile_files_test {
namespace {

using nlohmann::json;
using test::ProgramOutcome;

/// The required outcome of a file.
struct Hostile {
  const char* file;                             ///< below data/hostile
  const char* before;                           ///< what stands before its name on the command line
  const char* after;                            ///< and behind it
  const char* cause;                            ///< that the refusal names; nullptr: it is read
  std::function<void(const json&)> check = {};  ///< checks what is read
};

/// Ends programs that run longer than 20 s, and limits memory to that of a small machine.
const std::string kLimited = std::string("ulimit -v 8000000; ulimit -t 20; timeout -k 1 300 ") + test::kProgram;

void expect_range(const json& report, double lowest, double highest) {
  EXPECT_NEAR(report["lowest"].get<double>(), lowest, 1e-6 * std::abs(lowest));
  EXPECT_NEAR(report["highest"].get<double>(), highest, 1e-6 * std::abs(highest));
}

void expect_samples(const json& report, int x, int y, int z) { EXPECT_EQ(report["dims"], json({x, y, z})); }

void expect_volume(const json& report, double mm3, double tolerance) {
  double sum = 0;
  for (const auto& [name, volume] : report["volume_mm3"].items()) sum += volume.get<double>();
  EXPECT_NEAR(sum, mm3, tolerance);
}

/// Removes the path of the data folder, which may be anywhere.
std::string without_folder_of_data(std::string sentence) {
  const std::string folder = test::data_path("").string();
  for (std::size_t at; (at = sentence.find(folder)) != std::string::npos;) sentence.erase(at, folder.size());
  return sentence;
}

constexpr const char* kBone = "--material cortical_bone";

const Hostile kHostile[] = {
    {"dicom-rtdose-without-number-of-frames.dcm", "inspect", "", "number of frames"},
    {"dicom-intercept-without-slope", "inspect", "", nullptr,
     [](const json& r) { EXPECT_LT(r["lowest"].get<double>(), r["highest"].get<double>()); }},
    {"dicom-rle-one-byte.dcm", "inspect", "", "RLE"},
    {"dicom-rle-fpe.dcm", "inspect", "", "RLE"},
    {"dicom-j2k-heap", "inspect", "", "JPEG 2000"},
    {"dicom-rtdose-short-offsets.dcm", "inspect", "", "offsets of its frames"},
    {"dicom-palette-without-palette", "inspect", "", "PALETTE COLOR"},
    {"dicom-rows-beyond-data.dcm", "inspect", "", "claims"},
    {"mono1", "inspect", "", nullptr, [](const json& r) { expect_range(r, -896, 1167); }},
    {"rtdose-bigendian32.dcm", "inspect", "", nullptr, [](const json& r) { expect_range(r, 795000, 1254000); }},
    {"siemens-mosaic", "inspect", "", "MOSAIC"},
    {"nrrd-las.nrrd", "inspect", "", nullptr,
     [](const json& r) {
       expect_samples(r, 8, 7, 6);
       // y of `space` points to the front: the first sample is at 1, -2, 3, and rows run against y. A left-handed grid
       // is reversed along z.
       EXPECT_NEAR(r["box"]["max_mm"][1].get<double>(), -1.75, 1e-6);
       EXPECT_NEAR(r["box"]["min_mm"][1].get<double>(), -5.25, 1e-6);
       EXPECT_NEAR(r["box"]["min_mm"][0].get<double>(), 0.75, 1e-6);
       EXPECT_NEAR(r["box"]["max_mm"][2].get<double>(), 5.75, 1e-6);
     }},
    {"nrrd-long-line.nrrd", "inspect", "", "space directions"},
    {"nrrd-bzip2-bomb.nrrd", "inspect", "", "compressed"},
    {"nrrd-error-names-our-file.nrrd", "inspect", "", "damaged"},
    {"nrrd-one-axis-1e5-mm.nrrd", "inspect", "", "long"},
    {"nrrd-one-axis-1e5-mm.nrrd", "inspect", "--label cortical_bone=257", "long"},
    {"mesh-stray-vertex.obj", "inspect", kBone, "line 11"},
    {"mesh-stray-vertex.off", "inspect", kBone, "line 7"},
    {"mesh-slow-52-faces.off", "inspect", kBone, nullptr,
     [](const json& r) { EXPECT_GT(r["dims"][0].get<int>(), 190); }},
    // The file uses the former name of `max_force_N`.
    {"settings-depth-1e5-mm.toml", "drill --settings", "", "Did you mean effects.max_force_N?"},
    {"huge.nrrd", "inspect", "", "spacing"},
    {"float_nan.nrrd", "inspect", "", nullptr,
     [](const json& r) {
       expect_range(r, 0, 4);
       EXPECT_EQ(r["not_a_number"], 58);
     }},
    {"nifti-nan.nii", "inspect", "", nullptr,
     [](const json& r) {
       expect_range(r, 0, 5);
       EXPECT_EQ(r["not_a_number"], 1);
     }},
    {"nifti-micron.nii", "inspect", "", nullptr,
     [](const json& r) { EXPECT_LT(std::abs(r["box"]["max_mm"][0].get<double>()), 100); }},
    {"nifti-meter.nii", "inspect", "", nullptr, [](const json& r) { expect_samples(r, 8, 7, 6); }},
    {"nifti-slope0.nii", "inspect", "", nullptr, [](const json& r) { expect_range(r, 0, 5); }},
    {"nifti-sform-qform.nii", "inspect", "", nullptr, [](const json& r) { expect_samples(r, 8, 7, 6); }},
    {"nifti2.nii", "inspect", "", nullptr, [](const json& r) { expect_samples(r, 8, 7, 6); }},
    {"meta-headersize-local.mha", "inspect", "", "HeaderSize"},
    {"meta-headersize-abc/headersizeabc.mhd", "inspect", "", "HeaderSize"},
    {"mesh-winding.off", "inspect", "--unit_mm 4 --material cortical_bone --voxel_mm 0.2", nullptr,
     [](const json& r) { expect_volume(r, 512, 8); }},
    {"ply-nl.ply", "inspect", kBone, nullptr, [](const json& r) { expect_volume(r, 1, 0.03); }},
    {"ply-empty-faces.ply", "inspect", kBone, "vertex_indices"},
    {"vdb-accepted-but-read-otherwise.vdb", "inspect", "", "damaged"},
    {"recording-damaged.h5", "replay", "", "format 1"},
};

class HostileFile : public testing::TestWithParam<Hostile> {};

TEST_P(HostileFile, IsReadRightOrRefusedInOneSentence) {
  const Hostile& hostile = GetParam();
  const std::string name = std::string("hostile/") + hostile.file;
  HAPTICUT_NEEDS_DATA(name);
  const test::TemporaryFolder folder;
  const std::string report = (folder / "report.json").string();
  const ProgramOutcome outcome = test::run_program(
      folder,
      std::string(hostile.before) + " " + test::data_path(name).string() + " " + hostile.after + " --json " + report,
      kLimited);
  SCOPED_TRACE(outcome.errors);
  if (hostile.cause == nullptr) {
    ASSERT_EQ(outcome.code, 0);
    EXPECT_TRUE(outcome.errors.empty() || outcome.errors.starts_with("hapticut: about ")) << "an estimate, or nothing";
    return hostile.check(test::read_json(report));
  }
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(outcome.errors.starts_with("hapticut: "));
  EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1);
  // The message names a wrong setting by its key.
  if (!name.ends_with(".toml")) {
    EXPECT_NE(outcome.errors.find(test::data_path(name).filename().string()), std::string::npos);
  }
  EXPECT_NE(outcome.errors.find(hostile.cause), std::string::npos);
  const std::string message = without_folder_of_data(outcome.errors);
  EXPECT_EQ(message.find("ITK"), std::string::npos);
  EXPECT_EQ(message.find(std::filesystem::temp_directory_path().string()), std::string::npos) << "a file of our own";
}

INSTANTIATE_TEST_SUITE_P(Readers, HostileFile, testing::ValuesIn(kHostile), [](const auto& tested) {
  std::string name = std::to_string(tested.index) + "_" + tested.param.file;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
});

}  // namespace
}  // namespace hapticut::hostile_files_test
