// SPDX-License-Identifier: Apache-2.0
// Files of users: in another unit, from another program, next to their settings file; and the errors about unsuitable
// files, in terms of flags.
#include <gtest/gtest.h>

#include <regex>

#include "hapticut/import/mesh/meshes.hpp"
#include "support/meshes.hpp"
#include "support/program.hpp"

namespace hapticut::cli_inputs_test {
namespace {

using test::kBlock;
using test::ProgramOutcome;
using test::write_bytes;
using units::mm;

const std::string kBone = " --material cortical_bone --voxel_mm 0.2";
const std::string kScene = R"([workpiece]
source = "shapes/cube.stl"
voxel_mm = 0.2
material = "cortical_bone"

[tool]
head = "profile"
profile = "shapes/head.csv"
spindle_rpm = 30000

[path]
kind = "poses"
file = "poses.csv"

[output]
json = "results/report.json"
)";

class Inputs : public test::Program {
 protected:
  /// [mm^3] Volume of cortical bone.
  double volume(const std::string& arguments) {
    return inspect(arguments)["volume_mm3"]["cortical_bone"].get<double>();
  }
  /// A scene with its files in the folder `case`, outside the folder where the program runs.
  void write_scene() {
    std::filesystem::create_directories(folder / "case/shapes");
    write_stl(test::cube_mesh(Vec3::Zero(), 4 * mm, 1), folder / "case/shapes/cube.stl");
    write_bytes(folder / "case/shapes/head.csv", "rho_mm,z_mm\n0,0\n0.5,0\n0.5,1\n0,1\n");
    write_bytes(folder / "case/poses.csv", "t_s;x_mm;y_mm;z_mm\n0;2;2;4\n0,1;2;2;3,9\n");
    write_bytes(folder / "case/scene.toml", kScene);
  }
};

TEST_F(Inputs, OfAnotherUnitAreRefusedWithTheFlagThatSaysIt) {
  const TriangleMesh cube = test::cube_mesh(Vec3::Zero(), 4 * mm, 1);
  write_stl(cube, folder / "m.stl", 1000);
  expect_refused("inspect " + path("m.stl") + kBone, {"m.stl", "0.004 mm long", "voxels of 0.2 mm",
                                                      "--unit_mm to 1000 if its unit is a metre", "--voxel_mm"});
  EXPECT_NEAR(volume(path("m.stl") + kBone + " --unit-mm 1000"), 64, 0.01);
  write_ply(cube, folder / "inch.ply", 25.4);
  expect_refused("inspect " + path("inch.ply") + kBone, {"0.15748 mm long", "--unit_mm to 25.4 if its unit is an inch",
                                                         "--unit_mm to 1000 if its unit is a metre"});
  write_stl(cube, folder / "um.stl", 0.001);
  expect_refused("inspect " + path("um.stl") + kBone,
                 {"4000 mm long", "--unit_mm to 0.001 if its unit is a micrometre"});
  write_stl(cube, folder / "nm.stl", 1e-6);
  expect_refused("inspect " + path("nm.stl") + kBone, {"with a unit of 1 mm it is 4e+06 mm long", "100000 mm"});
  write_obj(cube, folder / "whole.obj");
  expect_refused("inspect " + path("whole.obj") + kBone + " --unit-mm 100000",
                 {"with a unit of 100000 mm it is 400000 mm long", "--unit_mm to 1 if its unit is a millimetre"});
}

TEST_F(Inputs, ThatAreThinAreNoMatterOfUnits) {
  TriangleMesh plate = test::cube_mesh(Vec3::Zero(), 4 * mm, 1);
  for (Vec3& v : plate.vertices) v.z() *= 1e-6;
  write_stl(plate, folder / "plate.stl");
  const std::string message = refusal("inspect " + path("plate.stl") + kBone);
  EXPECT_NE(message.find("encloses nothing that voxels of 0.2 mm can show, and the model is 4 mm long; close it"),
            std::string::npos)
      << message;
  EXPECT_EQ(message.find("unit"), std::string::npos) << message;
}

TEST_F(Inputs, WithoutAMeaningOfTheirValuesNeedAFlag) {
  ASSERT_EQ(run("convert block " + path("a.vdb") + " --size_mm 2,2,2 --voxel_mm 0.2 --material cortical_bone").code, 0);
  std::string bytes = test::read_bytes(folder / "a.vdb");
  expect_refused("inspect " + path("a.vdb") + " --material clay", {"a.vdb", "leave --material out"});
  const std::string own = "hapticut_format";  // without this text, the file counts as foreign
  for (std::size_t at = 0; (at = bytes.find(own, at)) != std::string::npos;) bytes[at] = 'H';
  const std::string fog = "fog volume";
  int classes = 0;
  for (std::size_t at = 0; (at = bytes.find(fog, at)) != std::string::npos; ++classes) bytes.replace(at, 3, "wet");
  ASSERT_GT(classes, 0);
  write_bytes(folder / "b.vdb", bytes);
  const std::string source = path("b.vdb") + " --material cortical_bone";
  expect_refused("inspect " + source, {"b.vdb", "'density' does not say what its values mean; set --grid_kind: fog"});
  EXPECT_NEAR(volume(source + " --grid-kind fog_volume"), 8, 1e-3);
  expect_refused("inspect " + source + " --grid other", {"'density' (float)", "with --grid"});
  expect_refused("inspect " + path("b.vdb") + " --grid-kind fog_volume", {"--material is missing"});
  expect_refused("inspect block --size_mm 2,2,2 --material dentin --grid-kind level_set",
                 {"--grid_kind is set; must be left out"});
}

TEST_F(Inputs, OfASettingsFileAreBesideIt) {
  write_scene();
  const ProgramOutcome outcome = run("drill --settings " + path("case/scene.toml"));
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_EQ(test::read_json(folder / "case/results/report.json")["steps"], 100);
  // The same holds for any form of the path, and with other files in the working folder.
  const std::string in_folder = "cd " + path("case") + " && " + test::kProgram;
  EXPECT_EQ(test::run_program(folder, "drill --settings scene.toml", in_folder).code, 0);
  EXPECT_EQ(test::run_program(folder, "drill --settings ../case/scene.toml", in_folder).code, 0);
  // A flag is relative to the working folder.
  const std::string in_shapes = "cd " + path("case/shapes") + " && " + test::kProgram;
  EXPECT_EQ(
      test::run_program(folder, "drill --settings ../scene.toml --workpiece cube.stl --json here.json", in_shapes).code,
      0);
  EXPECT_TRUE(std::filesystem::exists(folder / "case/shapes/here.json"));
}

TEST_F(Inputs, OfASettingsFileThatAreNotThereAreNamedWithTheirPlace) {
  const auto expect_missing = [&](const char* file, const std::string& place) {
    write_scene();
    std::filesystem::remove(folder / "case" / file);
    const std::string in_folder = "cd " + path("case") + " && " + test::kProgram;
    const std::string message = refusal("drill --settings scene.toml", test::kFailed, in_folder);
    EXPECT_NE(message.find(place), std::string::npos) << place << '\n' << message;
  };
  expect_missing("shapes/cube.stl", "there is no file '" + path("case/shapes/cube.stl") + "'");
  expect_missing("shapes/head.csv", path("case/shapes/head.csv"));
  expect_missing("poses.csv", path("case/poses.csv"));
  write_bytes(folder / "case/scene.toml", "[workpiece]\nsource = \"blokc\"\n[loop]\ndevice = \"replay:a.h5\"\n");
  expect_refused("loop --settings " + path("case/scene.toml"), {path("case/a.h5")});
}

TEST_F(Inputs, ThatAreDamagedAreRefusedInOwnWords) {
  ASSERT_EQ(run("drill " + kBlock + test::kBall +
                "--path line --from_mm 0,1,3 --to_mm 1,1,3 --feed_mm_per_s 20 --record " + path("a.h5"))
                .code,
            0);
  const std::string whole = test::read_bytes(folder / "a.h5");
  const std::regex own(
      "hapticut: cannot read '.*cut.h5': it is [^(]*(\\(HDF5: [^()]*\\))?(\\. Get|; get) a complete copy.*\\.\n");
  for (std::size_t length = 12; length < whole.size(); length += whole.size() / 5) {
    write_bytes(folder / "cut.h5", whole.substr(0, length));
    const std::string message = refusal("replay " + path("cut.h5"));
    EXPECT_TRUE(std::regex_match(message, own)) << message;
  }
}

TEST_F(Inputs, ThatDoNotFitAreRefusedByFlags) {
  expect_refused("drill " + kBlock + test::kBall + test::kGroove + "--voxel_budget 5", {"--voxel_budget = 5"});
  expect_refused("drill " + kBlock + test::kBall + test::kGroove + "--shank friction_grip --shank_neck_mm 9",
                 {"--shank_neck_mm = 9 mm"});
  expect_refused("inspect block --size_mm 9000,9000,9000 --voxel_mm 0.01 --material dentin", {"voxel"});
}

}  // namespace
}  // namespace hapticut::cli_inputs_test
