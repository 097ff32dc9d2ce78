// SPDX-License-Identifier: Apache-2.0
// What is in the files and not in the workpiece is said.
#include <gtest/gtest.h>

#include "support/dicom_files.hpp"
#include "support/program.hpp"

namespace hapticut::cli_left_out_test {
namespace {

using namespace test;
using LeftOut = Program;

/// 20 x 20 x 10 samples of 0.1 mm: dentin (1) under one layer of enamel (2) of 1.96 mm^2.
void write_labels(const std::filesystem::path& path) {
  std::string bytes = "NRRD0005\ntype: uchar\nencoding: raw\ndimension: 3\nsizes: 20 20 10\nspacings: 0.1 0.1 0.1\n\n";
  for (int k = 0; k < 10; ++k)
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 20; ++i) {
        const bool inside = i >= 3 && i < 17 && j >= 3 && j < 17 && k >= 1 && k <= 7;
        bytes += char(!inside ? 0 : k < 7 ? 1 : 2);
      }
  write_bytes(path, bytes);
}

const std::string kLabels = " --label dentin=1 --label enamel=2 ";

TEST_F(LeftOut, ALayerThinnerThanTheVoxelsIsSaidWithItsCure) {
  write_labels(folder / "v.nrrd");
  const std::string coarse = path("v.nrrd") + kLabels + "--voxel_mm 0.3 --json " + path("i.json");
  const ProgramOutcome outcome = run("inspect " + coarse);
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.errors.find("voxels of 0.3 mm are too coarse for the labels: "), std::string::npos)
      << outcome.errors;
  EXPECT_NE(outcome.errors.find("'enamel' fills "), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("its labels 0.196 mm^3"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("Choose voxels of 0.1 mm"), std::string::npos) << outcome.errors;
  const ProgramOutcome fine = run("inspect " + path("v.nrrd") + kLabels + "--voxel_mm 0.1 --json " + path("i.json"));
  EXPECT_EQ(fine.errors, "");
  EXPECT_NEAR(read_json(folder / "i.json")["volume_mm3"]["enamel"].get<double>(), 0.196, 1e-9);
}

TEST_F(LeftOut, AnAssumedOrientationIsSaidByInspectAndByAReport) {
  const DicomElements frames = dicom_picture(4, 4, std::vector<std::int16_t>(64, 2500));
  DicomElements scan = frames;
  scan.set(0x00280008, "IS", "4").set(0x00180088, "DS", "0.2").set(0x00200032, "DS", "0\\0\\0");
  write_bytes(folder / "v.dcm", dicom_file(scan));
  const std::string part = "does not say how its axes lie in the patient";
  const nlohmann::json report = inspect(path("v.dcm"));
  ASSERT_EQ(report["remarks"].size(), 1U);
  EXPECT_NE(report["remarks"][0].get<std::string>().find(part), std::string::npos);
  EXPECT_NE(read_bytes(folder / "stdout").find(part), std::string::npos);
  const nlohmann::json of_run = drill("--workpiece " + path("v.dcm") + " --grey dentin=250: " + kBall +
                                      "--path line --from_mm 0,0,3 --to_mm 0,0,2.9 --feed_mm_per_s 5");
  EXPECT_NE(of_run["warnings"][0].get<std::string>().find(part), std::string::npos) << of_run["warnings"];
  scan.set(0x00200037, "DS", "1\\0\\0\\0\\1\\0");
  write_bytes(folder / "v.dcm", dicom_file(scan));
  EXPECT_TRUE(inspect(path("v.dcm"))["remarks"].empty());
}

TEST_F(LeftOut, SlicesThatEndEarlyAreRefusedByName) {
  std::filesystem::create_directory(folder / "scan");
  for (int n = 0; n < 4; ++n)
    write_bytes(folder / "scan" / (slice_name(n) + ".dcm"),
                n < 2 ? dicom_file(dicom_slice(2, 2, 0.5 * n, {1, 2, 3, 4})) : std::string());
  expect_refused("inspect " + path("scan"), {"s2.dcm': it is empty", "The folder has 2 such files."});
}

}  // namespace
}  // namespace hapticut::cli_left_out_test
