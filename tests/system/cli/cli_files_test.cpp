// SPDX-License-Identifier: Apache-2.0
// Files of other programs: volumes, meshes, pictures.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "hapticut/core/units.hpp"
#include "support/dicom_files.hpp"
#include "support/program.hpp"
#include "support/test_data.hpp"

namespace hapticut::cli_files_test {
namespace {

using namespace test;
using Drill = Program;
using Inspect = Program;
using Convert = Program;

/// A volume of 12 x 10 x 8 samples, 0.5 mm apart: 0 except 500 in the box 2 ... 9, 2 ... 7, 2 ... 5, and one loose
/// sample of 900.
void write_test_volume(const std::filesystem::path& path) {
  std::string header =
      "NRRD0004\ntype: short\ndimension: 3\nsizes: 12 10 8\nspacings: 0.5 0.5 0.5\n"
      "encoding: raw\nendian: little\n\n";
  for (int k = 0; k < 8; ++k)
    for (int j = 0; j < 10; ++j)
      for (int i = 0; i < 12; ++i) {
        const bool inside = i >= 2 && i <= 9 && j >= 2 && j <= 7 && k >= 2 && k <= 5;
        const int value = inside ? 500 : i == 11 && j == 9 && k == 7 ? 900 : 0;
        header += char(value & 255);
        header += char(value >> 8);
      }
  write_bytes(path, header);
}

TEST_F(Drill, LeavesASurfaceAndAPicture) {
  const nlohmann::json drilled = drill(kBlock + kBall + kGroove + "--save " + path("b.nrrd") + " --surface " +
                                       path("b.stl") + " --picture " + path("b.png") + " --picture_view 0,1,-1");
  EXPECT_TRUE(read_bytes(folder / "b.nrrd").starts_with("NRRD"));
  EXPECT_TRUE(read_bytes(folder / "b.png").starts_with("\x89PNG"));
  // The surface encloses the remaining workpiece: a block of 108 mm^3 without the groove.
  const double left = 108 - drilled["removed_volume_mm3"]["total"].get<double>();
  const nlohmann::json report = inspect(path("b.stl") + " --material dentin --voxel_mm 0.2");
  EXPECT_NEAR(report["volume_mm3"]["dentin"].get<double>() / left, 1, 0.02);  // edges are rounded over half a voxel
}

TEST_F(Convert, WritesExtensionsInCapitals) {
  for (const char* name : {"m.STL", "m.Ply", "m.VDB", "m.NRRD"}) {
    const ProgramOutcome outcome = run("convert molar " + path(name) + " --voxel_mm 0.5");
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
  }
  EXPECT_TRUE(read_bytes(folder / "m.Ply").starts_with("ply"));
  EXPECT_EQ(run("inspect " + path("m.VDB")).code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "m_density.NRRD"));
}

TEST_F(Convert, WritesSurfacesInColorOrNot) {
  for (const char* name : {"m.stl", "m.ply"}) {
    const ProgramOutcome outcome = run("convert molar " + path(name) + " --voxel_mm 0.5");
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_GT(std::filesystem::file_size(folder / name), 10000U);
  }
}

TEST_F(Inspect, CountsTheGreyValuesOfAVolume) {
  write_test_volume(folder / "v.nrrd");
  const nlohmann::json report = inspect(path("v.nrrd") + " --threshold 500");
  EXPECT_EQ(report["dims"], nlohmann::json({12, 10, 8}));
  EXPECT_NEAR(report["spacing_mm"][2].get<double>(), 0.5, 1e-9);
  EXPECT_EQ(report["voxels_at_or_above"], 8 * 6 * 4 + 1);
  EXPECT_EQ(report["voxels"]["label 500"], 8 * 6 * 4);
  EXPECT_EQ(report["memory_bytes"], 12 * 10 * 8 * 4);
}

TEST_F(Inspect, RefusesWhatAVolumeWithoutMaterialsDoesNotUse) {
  write_test_volume(folder / "v.nrrd");
  for (const char* flag : {"--material dentin", "--unit-mm 2", "--shell dentin=a", "--grid-kind fog_volume",
                           "--voxel-mm 0.1", "--large", "--largest-component", "--partial-volume=true"})
    expect_refused("inspect " + path("v.nrrd") + " " + flag,
                   {"is set; must be left out, because", "v.nrrd is a volume without materials"});
  EXPECT_EQ(inspect(path("v.nrrd") + " --spacing-mm 1,1,1 --crop-mm 0,0,0,5,5,5")["spacing_mm"][0], 1);
  EXPECT_EQ(read_bytes(folder / "stdout").find("compare the size"), std::string::npos) << "it was given";
}

TEST_F(Inspect, DoubtsASpacingThatFilesHaveByDefault) {
  const auto write = [this](const std::string& spacings) {
    write_bytes(folder / "v.nrrd", "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 3 4\nspacings: " + spacings +
                                       "\nencoding: raw\n\n" + std::string(24, '\x05'));
  };
  write("1 1 1");
  EXPECT_EQ(inspect(path("v.nrrd"))["size_mm"], nlohmann::json({2, 3, 4}));
  const std::string table = read_bytes(folder / "stdout");
  EXPECT_EQ(table.find("  size "), table.find('\n') + 1) << table;
  EXPECT_NE(table.find("set --spacing_mm if it is wrong"), std::string::npos) << table;
  write("0.5 1 1");
  EXPECT_NEAR(inspect(path("v.nrrd"))["size_mm"][0].get<double>(), 1, 1e-9);
  EXPECT_EQ(read_bytes(folder / "stdout").find("set --spacing_mm"), std::string::npos);
}

TEST_F(Convert, RefusesAVolumeOfWhichNothingIsLeft) {
  write_test_volume(folder / "v.nrrd");
  expect_refused("convert " + path("v.nrrd") + " " + path("e.vdb") + " --grey dentin=5000:",
                 {"v.nrrd", "no voxel is left"});
  EXPECT_FALSE(std::filesystem::exists(folder / "e.vdb"));
}

TEST_F(Drill, CutsAVolumeOfGreyValues) {
  write_test_volume(folder / "v.nrrd");
  const std::string volume = "--workpiece " + path("v.nrrd") + " --voxel_mm 0.25 ";
  const std::string plunge = "--path line --from_mm 2.75,2.25,4 --to_mm 2.75,2.25,2 --feed_mm_per_s 5 ";
  const nlohmann::json all = drill(volume + "--grey cortical_bone=250: " + kBall + plunge);
  const nlohmann::json largest = drill(volume + "--grey cortical_bone=250: --largest_component " + kBall + plunge);
  const nlohmann::json cropped =
      drill(volume + "--grey cortical_bone=250: --crop_mm 1.75,-1,-1,9,9,9 " + kBall + plunge);
  const nlohmann::json graded = drill(volume + "--grade_low 250 --grade_high 900 --grade_at_low trabecular_bone " +
                                      "--grade_at_high cortical_bone " + kBall + plunge);
  const auto bone = [](const nlohmann::json& report) {
    return report["workpiece"]["volume_mm3"]["cortical_bone"].get<double>();
  };
  EXPECT_GT(all["removed_volume_mm3"]["total"], 0);
  EXPECT_GT(graded["removed_volume_mm3"]["total"], 0);
  EXPECT_NEAR(bone(all) / 24, 1, 0.1);  // 8 x 6 x 4 samples of 0.125 mm^3; edges are rounded by interpolation
  EXPECT_LT(bone(largest), bone(all));
  EXPECT_LT(bone(cropped), 0.85 * bone(all));  // at x = 1.75 mm a quarter is cropped
}

TEST_F(Inspect, TellsTheBorderOfAVolumeFromWhatIsSoft) {
  write_test_volume(folder / "v.nrrd");
  const auto trabecular = [&](const std::string& flag) {
    return inspect(path("v.nrrd") + " --grey trabecular_bone=250:400 --grey cortical_bone=400: --voxel-mm 0.1" +
                   flag)["volume_mm3"]["trabecular_bone"]
        .get<double>();
  };
  EXPECT_GT(trabecular(" --partial-volume=false"), 3);
  EXPECT_EQ(trabecular(""), 0);
}

TEST_F(Drill, CutsAVolumeOfLabels) {
  write_test_volume(folder / "v.nrrd");
  const nlohmann::json report =
      drill("--workpiece " + path("v.nrrd") + " --label dentin=500 --label amalgam=900 " + kBall +
            "--path line --from_mm 2.75,2.25,4 --to_mm 2.75,2.25,2 --feed_mm_per_s 5");
  EXPECT_NEAR(report["workpiece"]["volume_mm3"]["dentin"].get<double>(), 24, 1e-9);
  EXPECT_EQ(report["workpiece"]["voxels"]["amalgam"], 1);
  EXPECT_GT(report["removed_volume_mm3"]["by_material"]["dentin"], 0);
  EXPECT_EQ(inspect(path("v.nrrd") + " --label amalgam=900 --unclaimed_labels leave_out")["voxels"]["amalgam"], 1);
}

constexpr std::array<const char*, 6> kSides = {"0264", "1573", "0451", "2376", "0132", "4675"};  // corners of a cube

/// A cube of 4 mm around the origin and one of 2 mm inside it, as two objects in millimetres.
void write_nested_cubes(const std::filesystem::path& path) {
  std::string text;
  int first = 1;
  for (const auto& [name, half] : {std::pair("Outer", 2), std::pair("Inner", 1)}) {
    text += std::string("o ") + name + "\n";
    for (int corner = 0; corner < 8; ++corner) {
      text += "v";
      for (int axis = 0; axis < 3; ++axis) text += ' ' + std::to_string((corner >> axis & 1) != 0 ? half : -half);
      text += '\n';
    }
    for (const char* face : kSides) {
      text += "f";
      for (int n = 0; n < 4; ++n) text += ' ' + std::to_string(first + face[n] - '0');
      text += '\n';
    }
    first += 8;
  }
  write_bytes(path, text);
}

TEST_F(Inspect, FillsNestedShellsOfAMesh) {
  write_nested_cubes(folder / "cubes.obj");
  const std::string cubes = path("cubes.obj") + " --voxel_mm 0.25";
  const double kRounding = 0.02;  // edges within half a voxel
  nlohmann::json volumes = inspect(cubes + " --shell dentin=Outer --shell pulp=Inner")["volume_mm3"];
  EXPECT_NEAR(volumes["dentin"].get<double>() / 56, 1, kRounding);
  EXPECT_NEAR(volumes["pulp"].get<double>() / 8, 1, kRounding);
  volumes = inspect(cubes + " --shell dentin=Outer --shell empty=Inner")["volume_mm3"];
  EXPECT_NEAR(volumes["dentin"].get<double>() / 56, 1, kRounding);
  EXPECT_EQ(volumes.size(), 1U);
  expect_refused("inspect " + cubes + " --shell dentin=Middle", {"there are Outer, Inner"});
  expect_refused("inspect " + cubes + " --material dentin", {"several objects (Outer, Inner)"});
}

/// Two solids of one name: the cubes of 2 mm that begin at the origin and at x = `second` [mm].
/// @param shared  omits their common sides
std::string solids_of_one_name(int second, bool shared) {
  std::string text;
  for (const int x : {0, second}) {
    text += "solid cube\n";
    for (std::size_t side = 0; side < kSides.size(); ++side) {
      if (shared && side == (x == 0 ? 1U : 0U)) continue;
      for (const auto& triangle : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const int n : triangle) {
          const int corner = kSides[side][n] - '0';
          text += "vertex " + std::to_string(x + 2 * (corner & 1)) + ' ' + std::to_string(corner & 2) + ' ' +
                  std::to_string((corner & 4) / 2) + '\n';
        }
        text += "endloop\nendfacet\n";
      }
    }
    text += "endsolid cube\n";
  }
  return text;
}

// Exporters give every solid the same name, and a surface may consist of open parts.
TEST_F(Inspect, FillsAllObjectsOfAName) {
  for (const auto& [second, shared] : {std::pair(4, false), std::pair(2, true)}) {
    write_bytes(folder / "cubes.stl", solids_of_one_name(second, shared));
    const nlohmann::json report = inspect(path("cubes.stl") + " --voxel_mm 0.25 --shell dentin=cube");
    EXPECT_NEAR(report["volume_mm3"]["dentin"].get<double>(), 16, 0.1) << second;
  }
}

/// A box of label 1 with a hole in its middle (label 0) that a canal, one sample wide, connects with the outside.
void write_hollow_volume(const std::filesystem::path& path, bool with_canal) {
  std::string bytes = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 14 14 14\nspacings: 0.5 0.5 0.5\nencoding: raw\n\n";
  for (int k = 0; k < 14; ++k)
    for (int j = 0; j < 14; ++j)
      for (int i = 0; i < 14; ++i) {
        const auto within = [&](int low, int high) {
          return std::min({i, j, k}) >= low && std::max({i, j, k}) <= high;
        };
        const bool canal = with_canal && i == 6 && j == 6 && k > 6;
        bytes += char(within(2, 11) && !within(5, 8) && !canal ? 1 : 0);
      }
  write_bytes(path, bytes);
}

TEST_F(Inspect, FillsTheCavitiesOfLabels) {
  write_hollow_volume(folder / "closed.nrrd", false);
  write_hollow_volume(folder / "open.nrrd", true);
  const std::string closed = path("closed.nrrd") + " --label dentin=1 ",
                    open = path("open.nrrd") + " --label dentin=1 ";
  nlohmann::json voxels = inspect(closed + "--fill_cavities pulp")["voxels"];
  EXPECT_EQ(voxels["pulp"], 4 * 4 * 4);
  EXPECT_EQ(voxels["dentin"], 1000 - 64);
  EXPECT_EQ(inspect(closed + "--fill_cavities dentin")["voxels"]["dentin"], 1000);
  voxels = inspect(open + "--fill_cavities pulp --close_gaps_mm 0.8")["voxels"];
  EXPECT_GE(voxels["pulp"], 64);
  EXPECT_EQ(voxels["dentin"], 1000 - 64 - 3);
  expect_refused("inspect " + open + "--fill_cavities pulp", {"Set --close_gaps_mm"});
  expect_refused("inspect " + open + "--close_gaps_mm 0.8", {"needs --fill_cavities"});
}

TEST_F(Inspect, ReadsAFileWithoutAHeader) {
  std::string bytes = "head";
  for (int n = 0; n < 4 * 3 * 2; ++n) bytes += {char(1), char(n)};  // 256 + n, highest byte first
  write_bytes(folder / "v.raw", bytes);
  const nlohmann::json report =
      inspect(path("v.raw") + " --raw_dims 4,3,2 --raw_type uint16 --raw_big_endian --raw_skip_bytes 4" +
              " --spacing_mm 0.5,0.6,0.7 --threshold 270");
  EXPECT_EQ(report["dims"], nlohmann::json({4, 3, 2}));
  EXPECT_EQ(report["lowest"], 256);
  EXPECT_EQ(report["highest"], 256 + 23);
  EXPECT_EQ(report["voxels_at_or_above"], 10);
  EXPECT_NEAR(report["spacing_mm"][2].get<double>(), 0.7, 1e-9);
  for (const auto& [arguments, part] :
       {std::pair("", "set all of --raw_dims, --raw_type and --spacing_mm"),
        std::pair("--raw_dims 4,3,2 --raw_type uint16", "spacing_mm"),
        std::pair("--raw_dims 4,3,2 --raw_type short --spacing_mm 1,1,1", "must be one of uint8"),
        std::pair("--raw_dims 4,3,2.5 --raw_type int8 --spacing_mm 1,1,1", "whole numbers"),
        std::pair("--raw_dims 4,3,2 --raw_type int8 --spacing_mm 1,1,1 --dicom-series 1.2", "has no series"),
        std::pair("--raw_dims 40,30,20 --raw_type int8 --spacing_mm 1,1,1", "v.raw")})
    expect_refused("inspect " + path("v.raw") + " " + arguments, {part});
}

TEST_F(Inspect, PicksASeriesOfADicomFolder) {
  HAPTICUT_NEEDS_DATA("formats/example_ct_dicom");
  const std::string slices = data_path("formats/example_ct_dicom").string();
  EXPECT_EQ(inspect(slices)["dims"][2], 20);
  expect_refused("inspect " + slices + " --dicom_series 1.2.3", {"1.2.3"});
}

/// Three slices of air with a sample of 1500 in the middle and padding of 65535 in the corners.
void write_padded_slices(const std::filesystem::path& folder) {
  std::filesystem::create_directory(folder);
  for (int k = 0; k < 3; ++k) {
    std::vector<std::int16_t> values(25, 0);
    for (const std::size_t corner : {0U, 4U, 20U, 24U}) values[corner] = -1;
    if (k == 1) values[12] = 2500;
    DicomElements slice = dicom_slice(5, 5, 0.2 * k, values).set_word(0x00280103, 0).set_word(0x00280120, 65535);
    write_bytes(folder / slice_name(k), dicom_file(slice));
  }
}

TEST_F(Program, SaysHowManySamplesArePaddingAndTakesThemForAir) {
  write_padded_slices(folder / "scan");
  EXPECT_EQ(inspect(path("scan") + " --crop-mm 10.1,20.1,0,10.3,20.3,0.3")["padding"], 12);
  EXPECT_NE(read_bytes(folder / "stdout").find("12 samples"), std::string::npos);
  const nlohmann::json whole = inspect(path("scan"));
  EXPECT_EQ(whole["highest"], 1500);
  EXPECT_EQ(whole["lowest"], -1000);

  const std::string warning = "12 of the 75 samples of " + path("scan") + " are padding", bone = " --grey dentin=250:";
  for (const std::string& command : {"inspect " + path("scan") + bone + " --voxel-mm 0.1 --json " + path("i.json"),
                                     "convert " + path("scan") + " " + path("a.vdb") + bone}) {
    const ProgramOutcome outcome = run(command);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_NE(outcome.errors.find(warning), std::string::npos) << outcome.errors;
  }
  EXPECT_LT(read_json(folder / "i.json")["volume_mm3"]["dentin"].get<double>(), 0.01);  // one sample is 0.004 mm^3
  const nlohmann::json report = drill("--workpiece " + path("scan") + bone + " " + kBall +
                                      "--path line --from_mm 10,20,3 --to_mm 10,20,2.9 --feed_mm_per_s 5");
  EXPECT_NE(report["warnings"][0].get<std::string>().find(warning), std::string::npos) << report["warnings"];
}

TEST_F(Inspect, NamesTheFlagThatPicksASeriesOrGivesASpacing) {
  std::filesystem::create_directory(folder / "scan");
  for (int n = 0; n < 4; ++n) {
    DicomElements slice = dicom_slice(1, 1, 0.5 * n, {1});
    slice.set(0x0020000e, "UI", n < 2 ? "1.2.3" : "1.2.4");
    write_bytes(folder / "scan" / slice_name(n), dicom_file(slice));
  }
  expect_refused("inspect " + path("scan"), {"Choose one with --dicom_series."});
  EXPECT_EQ(run("inspect " + path("scan") + " --dicom-series 1.2.4").code, 0);
  write_bytes(folder / "v.mha",
              "NDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n12345678");
  expect_refused("inspect " + path("v.mha"), {"; set --spacing_mm."});
  EXPECT_EQ(run("inspect " + path("v.mha") + " --spacing-mm 1,1,1").code, 0);
}

TEST_F(Inspect, SaysWhereAVolumeIs) {
  write_bytes(folder / "v.nrrd",
              "NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 3 4\n"
              "space directions: (0,1,0) (-2,0,0) (0,0,3)\nspace origin: (10,20,30)\nencoding: raw\n\n" +
                  std::string(24, '\x05'));
  const nlohmann::json report = inspect(path("v.nrrd"));
  EXPECT_EQ(report["pose"]["position_mm"], nlohmann::json({10, 20, 30}));
  EXPECT_EQ(report["pose"]["rotation"], nlohmann::json({{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}));
  // Along W's x lie three samples of 2 mm, backwards from 10; along y two of 1 mm, from 20.
  EXPECT_NEAR(report["box"]["min_mm"][0].get<double>(), 10 - 5, 1e-9);
  EXPECT_NEAR(report["box"]["max_mm"][0].get<double>(), 10 + 1, 1e-9);
  EXPECT_NEAR(report["box"]["min_mm"][1].get<double>(), 20 - 0.5, 1e-9);
  EXPECT_NEAR(report["box"]["max_mm"][1].get<double>(), 20 + 1.5, 1e-9);
  EXPECT_NEAR(report["box"]["max_mm"][2].get<double>(), 30 + 10.5, 1e-9);
  EXPECT_NE(read_bytes(folder / "stdout").find("axes rotated"), std::string::npos);
}

TEST_F(Convert, KeepsItsSourceWhenTheSecondFileOfANrrdWouldReplaceIt) {
  write_test_volume(folder / "v_density.nrrd");
  const std::string before = read_bytes(folder / "v_density.nrrd");
  expect_refused("convert " + path("v_density.nrrd") + " " + path("v.nrrd") + " --grey dentin=250:",
                 {"TARGET would overwrite", "v_density.nrrd', the file of SOURCE"});
  EXPECT_EQ(read_bytes(folder / "v_density.nrrd"), before);
  EXPECT_FALSE(std::filesystem::exists(folder / "v.nrrd"));
  expect_refused("drill " + kBlock + kBall + kGroove + "--save " + path("b.nrrd") + " --json " + path("b_density.nrrd"),
                 {"--save would overwrite", "the file of --json"});
}

TEST_F(Convert, TurnsAGridOfAnotherProgramIntoAWorkpiece) {
  HAPTICUT_NEEDS_DATA("vdb/sphere.vdb");
  const std::string sphere = data_path("vdb/sphere.vdb").string();
  const ProgramOutcome outcome = run("convert " + sphere + " " + path("ball.vdb") + " --material dentin --unit_mm 0.5");
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const double ball = 4.0 / 3 * units::kPi * 1.5 * 1.5 * 1.5;  // a radius of 3 units
  EXPECT_NEAR(inspect(path("ball.vdb"))["volume_mm3"]["dentin"].get<double>() / ball, 1, 1e-3);
  const std::string other = "convert " + sphere + " " + path("other.vdb");
  expect_refused(other + " --material dentin --grid density", {"'ls_sphere' (float)"});
  expect_refused(other, {});
  EXPECT_FALSE(std::filesystem::exists(folder / "other.vdb"));
}

}  // namespace
}  // namespace hapticut::cli_files_test
