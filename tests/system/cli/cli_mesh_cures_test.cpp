// SPDX-License-Identifier: Apache-2.0
// Refusals of meshes and tables by the program: each test meets one, does what the sentence says, and succeeds.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.hpp"

namespace hapticut::cli_mesh_cures_test {
namespace {

using namespace test;
using MeshCures = Program;
using TableCures = Program;

/// A cube of squares as OBJ, from `x` on along x.
/// @param first  number of its first vertex in the file
/// @param sides  0: towards -x, ... 5: towards +z
std::string cube(double x, double edge, int first, const std::vector<int>& sides, bool turned = false) {
  constexpr std::array<const char*, 6> kSides = {"0264", "1573", "0451", "2376", "0132", "4675"};
  std::string text;
  for (int corner = 0; corner < 8; ++corner)
    text += "v " + std::to_string(x + edge * (corner & 1)) + ' ' + std::to_string(edge * (corner >> 1 & 1)) + ' ' +
            std::to_string(edge * (corner >> 2 & 1)) + '\n';
  for (const int side : sides) {
    text += 'f';
    for (int n = 0; n < 4; ++n)
      text += ' ' + std::to_string(first + kSides[std::size_t(side)][turned ? 3 - n : n] - '0');
    text += '\n';
  }
  return text;
}

const std::vector<int> kAll = {0, 1, 2, 3, 4, 5};

/// A command that is refused, what it says, and the command that does so.
struct Cure {
  std::string mesh;
  std::string arguments, said;
  std::string cured_mesh;  // empty: the same
  std::string cured_arguments;
  double volume;  // [mm^3]
};

TEST_F(MeshCures, DoWhatTheSentenceSays) {
  const std::string closed = cube(0, 4, 1, kAll), dentin = "--material dentin --voxel_mm 0.25";
  const std::string half = cube(0, 4, 1, {0}), other = cube(6, 3, 9, kAll);
  const std::string inside_out = cube(6, 3, 9, {0, 1, 2, 3, 4}, true);
  const std::string open = cube(0, 4, 1, {0, 1, 2, 3, 4});
  const std::vector<Cure> cures = {
      {closed, "", "a mesh needs either a material or shells", "", dentin, 64},
      {"o one\n" + closed + "o two\n" + other, dentin, "Set --shell MATERIAL=OBJECT for each object", "",
       "--shell dentin=one --shell dentin=two --voxel_mm 0.25", 91},
      {"o one\n" + closed, "--shell dentin=tow --voxel_mm 0.25", "there are one. Set --shell MATERIAL=OBJECT.", "",
       "--shell dentin=one --voxel_mm 0.25", 64},
      {cube(0, 0.004, 1, kAll), dentin, "Set --unit_mm to 1000 if its unit is a metre", "", dentin + " --unit-mm 1000",
       64},
      {closed, dentin + " --unit-mm 1e-2", "or smaller voxels by --voxel_mm.", "",
       "--material dentin --unit-mm 1e-2 --voxel_mm 0.0025", 64e-6},
      {half, dentin, "encloses nothing that voxels of 0.25 mm can show, and the model is 4 mm long; close it", closed,
       dentin, 64},
      {open + inside_out, dentin, "would be lost, because it encloses nothing: its faces point the other way",
       open + cube(6, 3, 9, {0, 1, 2, 3, 4}), dentin, 91},
      {closed, "--material dentin --voxel_mm 0.001", "lift the limit (--large).", "", dentin, 64}};
  for (const Cure& cure : cures) {
    write_bytes(folder / "m.obj", cure.mesh);
    const ProgramOutcome refused = run("inspect " + path("m.obj") + " " + cure.arguments);
    EXPECT_EQ(refused.code, kFailed) << cure.said;
    EXPECT_NE(refused.errors.find(cure.said), std::string::npos) << cure.said << '\n' << refused.errors;
    if (!cure.cured_mesh.empty()) write_bytes(folder / "m.obj", cure.cured_mesh);
    const nlohmann::json report = inspect(path("m.obj") + " " + cure.cured_arguments);
    EXPECT_NEAR(report["volume_mm3"]["dentin"].get<double>() / cure.volume, 1, 0.02) << cure.said;
  }
}

TEST_F(MeshCures, AreNotNeededForFacesSeenFromBothSides) {
  const std::string dentin = " --material dentin --voxel_mm 0.25", one = cube(0, 4, 1, kAll);
  // Triangles; squares that are turned may be divided along their other diagonal.
  const auto in_triangles = [](const std::string& text) {
    std::istringstream lines(text);
    std::string all;
    for (std::string line; std::getline(lines, line); all += '\n') {
      int a = 0, b = 0, c = 0, d = 0;
      if (std::sscanf(line.c_str(), "f %d %d %d %d", &a, &b, &c, &d) != 4)
        all += line;
      else
        for (const auto& [p, q, r] : {std::array{a, b, c}, std::array{a, c, d}}) {
          const std::string p_q_r = std::to_string(p) + ' ' + std::to_string(q) + ' ' + std::to_string(r);
          all += "f " + p_q_r + "\nf " + std::to_string(r) + ' ' + std::to_string(q) + ' ' + std::to_string(p) + '\n';
        }
    }
    return all;
  };
  write_bytes(folder / "m.obj", one + in_triangles(cube(6, 3, 9, kAll)));
  EXPECT_NEAR(inspect(path("m.obj") + dentin)["volume_mm3"]["dentin"].get<double>(), 91, 1e-6);
  write_bytes(folder / "m.obj", in_triangles(one));
  EXPECT_NEAR(inspect(path("m.obj") + dentin)["volume_mm3"]["dentin"].get<double>(), 64, 1e-6);
}

TEST_F(TableCures, DoWhatTheSentenceSays) {
  const std::string drill =
      "drill --workpiece block --size_mm 6,6,3 --material dentin --voxel_mm 0.2 --head sphere "
      "--radius_mm 1 --spindle_rpm 30000 --path poses --poses " +
      path("p.csv");
  const std::string names = "t_s,x_mm,y_mm,z_mm";
  struct Table {
    std::string text, said, cured;
  };
  const std::string right = names + "\n0,-2,3,2.5\n0.3,3,3,2.5\n";
  for (const Table& table : std::vector<Table>{
           {names + ",roll_deg\n0,-2,3,2.5,0\n0.3,3,3,2.5,0\n", "there is no column roll_deg", right},
           {names + ",comments_of_mine\n0,-2,3,2.5,0\n0.3,3,3,2.5,0\n", "or name it comment",
            names + ",comment\n0,-2,3,2.5,0\n0.3,3,3,2.5,0\n"},
           {"t_s,x_mm,y_mm,z\n0,-2,3,2.5\n0.3,3,3,2.5\n", "Did you mean z_mm?", right},
           {"t_s,x_mm,y_mm\n0,-2,3\n0.3,3,3\n", "the column z_mm is missing", right},
           {"0,-2,3,2.5\n0.3,3,3,2.5\n", "the first line has numbers; it must name the columns t_s, x_mm", right},
           {names + "\n0,-2,3,2.5\n0.3,3,3\n", "3 values; there must be 4", right},
           {names + "\n0.3,-2,3,2.5\n0.3,3,3,2.5\n", "times must increase", right},
           {names + "\n0,-2,3,2.5\n", "at least two poses", right},
           {names + ",x_mm\n0,-2,3,2.5,1\n0.3,3,3,2.5,1\n", "named twice; leave one of them out", right},
           {names + ",qw,qx,qy,qz\n0,-2,3,2.5,1,0,0\n", "7 values", right},
           {names + ",qw,qx,qy\n0,-2,3,2.5,1,0,0\n", "the column qz is missing",
            names + ",qw,qx,qy,qz\n0,-2,3,2.5,1,0,0,0\n0.3,3,3,2.5,1,0,0,0\n"},
           {names + "\n0,-2,3,\"2,500\"\n1,3,3,\"2,500\"\n", "write 2,5000",
            names + "\n0,-2,3,\"2,5000\"\n1,3,3,\"2,5000\"\n"}}) {
    write_bytes(folder / "p.csv", table.text);
    expect_refused(drill, {table.said, path("p.csv") + ":"});
    write_bytes(folder / "p.csv", table.cured);
    const ProgramOutcome outcome = run(drill);
    EXPECT_EQ(outcome.code, 0) << table.said << outcome.errors;
  }
}

// The table of one run is the path of the next.
TEST_F(TableCures, AreNotNeededForTheStepsOfARun) {
  const nlohmann::json first = drill(kBlock + kStiffBall + kGroove + "--steps_csv " + path("s.csv"));
  const nlohmann::json second = drill(kBlock + kStiffBall + "--path poses --point head --poses " + path("s.csv"));
  EXPECT_NEAR(second["removed_volume_mm3"]["total"].get<double>() / first["removed_volume_mm3"]["total"].get<double>(),
              1, 1e-3);
}

}  // namespace
}  // namespace hapticut::cli_mesh_cures_test
