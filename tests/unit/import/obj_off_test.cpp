// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/mesh_parsers.hpp"

namespace hapticut::obj_off_test {
namespace {

using namespace test;

// --- OBJ

constexpr char kCubeCorners[] =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";  // counted from 1
constexpr char kCubeFaces[] = "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

TEST(ObjFormat, QuadsAreACubeWithAnyLineEnding) {
  const std::string cube = std::string(kCubeCorners) + kCubeFaces;
  for (const char* end : {"\n", "\r\n", "\r", " \n", " # comment\n", "\n\n# comment \\\n", "\t\n"})
    expect_unit_cube(only_mesh_in(parse_obj, replaced(cube, "\n", end)));
  expect_unit_cube(only_mesh_in(parse_obj, "\xef\xbb\xbf# a byte order mark\n" + cube));
  expect_unit_cube(only_mesh_in(parse_obj, cube.substr(0, cube.size() - 1)));
}

TEST(ObjFormat, ALineContinuesAfterABackslash) {
  std::string text = std::string(kCubeCorners) + kCubeFaces;
  text = replaced(text, "f 5 6 7 8", "f 5 6 \\\n7 8");
  text = replaced(text, "f 1 2 6 5", "f 1 2\\\r\n\\\n6 5");
  expect_unit_cube(only_mesh_in(parse_obj, replaced(text, "v 1 1 1\n", "v 1 \\ \n 1 1\nvt 0 \\\n 1\n")));
}

TEST(ObjFormat, CornersMayHaveTexturesAndNormalsAndCountBackwards) {
  for (const char* more : {"/1", "//1", "/1/1", "/", "//"}) {
    std::string text = kCubeCorners + std::string("vt 0 0\nvn 0 0 1\n") + replaced(kCubeFaces, " ", " @");
    for (int n = 1; n <= 8; ++n)
      text = replaced(text, std::string("@").append(std::to_string(n)), std::to_string(n - 9).append(more));
    expect_unit_cube(only_mesh_in(parse_obj, text));
  }
  expect_unit_cube(only_mesh_in(parse_obj, kCubeFaces + std::string(kCubeCorners)));  // vertices after the faces
}

TEST(ObjFormat, VerticesMayHaveAWeightOrAColor) {
  for (const char* more : {" 1", " 0.5 0.5 0.5", " nan nan nan", " 0.5 0.5 0.5 1"})
    expect_unit_cube(only_mesh_in(parse_obj, replaced(kCubeCorners, "\n", std::string(more) + "\n") + kCubeFaces));
  EXPECT_DOUBLE_EQ(
      test::signed_volume(only_mesh_in(parse_obj, replaced(kCubeCorners, "\n", " 0.5\n") + std::string(kCubeFaces))),
      8);
}

TEST(ObjFormat, NamesAfterOAndGAreObjectsThatMayGoOnLater) {
  const std::string text =
      kCubeCorners + std::string("f 1 2 3\ng first one \nusemtl red\nf 1 2 4\no second\nf 1 3 4\ns off\nl 1 2\n") +
      "g first one\nf 2 3 4\ng empty\n";
  const std::vector<NamedMesh> meshes = meshes_in(parse_obj, text);
  ASSERT_EQ(meshes.size(), 3U);
  EXPECT_EQ(meshes[0].name, "object 1");
  EXPECT_EQ(meshes[1].name, "first one");
  EXPECT_EQ(meshes[1].mesh.triangles.size(), 2U);
  EXPECT_EQ(meshes[2].name, "second");
  EXPECT_EQ(meshes_in(parse_obj, kCubeCorners + std::string(kCubeFaces))[0].name, "");
}

TEST(ObjFormat, WhatIsNoMeshIsRefusedWithTheLine) {
  expect_all_refused(parse_obj,
                     {{"v 0 0\n", "line 1: a coordinate is missing"},
                      {"v 0 0 0\nv 1 0,5 0\n", "line 2: '0,5'"},
                      {"v 0 0 0 1 2\n", "5 numbers"},
                      {"v 0 0 0 0\n", "weight"},
                      {"v 0 0 0 1 2 3 4 5\n", "more than three coordinates"},
                      {"v 0 0 0\nf 1 1\n", "line 2: a face has 2 corners"},
                      {"v 0 0 0\nf\n", "a face has 0 corners"},
                      {"v 0 0 0\nf 1 1 0\n", "vertices are counted from 1"},
                      {"v 0 0 0\n\nf 1 1 2\n", "line 3: a face names vertex 2, but the file has only 1"},
                      {"v 0 0 0\nf 1 1 -2\n", "names vertex -2"},
                      {"v 0 0 0\nf 1 1 99999999999\n", "names vertex 99999999999"},
                      {"v 0 0 0\nf 1 1 1e1\n", "'1e1' is not a corner"},
                      {"v 0 0 0\nf 1 1 /1\n", "'/1' is not a corner"},
                      {"v 0 0 0\nf 1 1 1/x\n", "not a corner"},
                      {"v 0 0 0\nf 1 1 1/1/1/1\n", "not a corner"},
                      {"v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "vertex 1 of a face has a coordinate that is not"},
                      {"v 0 1e999 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "not a finite number"},
                      {"v 0 0 0\ncurv2 1 2\n", "free-form"},
                      {"\n\nthis is no mesh\n", "line 3: 'this' is not a keyword"},
                      {"\x89PNG\r\n", "'?PNG'"}});
  // Vertices that no face uses may be any numbers.
  EXPECT_EQ(only_mesh_in(parse_obj, "v nan 1e999 0\nv 0 0 1e-999\nv 1 0 0\nv 0 1 0\nf 2 3 4\n").vertices[0].z(), 0);
}

// --- OFF

TEST(OffFormat, CountsMayFollowTheKeyAndLinesMayHaveColors) {
  constexpr char kBody[] = "4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  const std::string body = kBody;
  for (const std::string& text :
       {"OFF\n" + body, "OFF " + body, "OFF" + body, "NOFF" + body,
        "# text\n\nOFF # text\n" + replaced(body, "\n", "  # text\n\n"), "OFF\r\n" + replaced(body, "\n", "\r\n"),
        "COFF\n" + replaced(body, "\n", " 255 0 0 255\n")}) {
    const TriangleMesh mesh = only_mesh_in(parse_off, text);
    EXPECT_TRUE(test::is_closed(mesh)) << text;
    EXPECT_NEAR(test::signed_volume(mesh), 1.0 / 6, 1e-15);
  }
}

TEST(OffFormat, DamagedFilesAreRefusedWithTheLine) {
  expect_all_refused(parse_off, {{"", "begins with ''"},
                                 {"4OFF\n", "begins with '4OFF'"},
                                 {"OFF4x 4 6\n", "'4x' is not the number of vertices"},
                                 {"OFFER\n", "begins with 'OFFER'"},
                                 {"OFF BINARY\n", "'BINARY' is not the number of vertices"},
                                 {"OFF\n1 -1 0\n", "'-1' is not the number of"},
                                 {"OFF\n4000000000 1 0\n0 0 0\n", "but ends after 1"},
                                 {"OFF\n1 2 0\n0 0 0\n3 0 0 0\n", "ends after 1; it is truncated"},
                                 {"OFF\n1 1 0\n0 0\n", "line 3: a coordinate is missing"},
                                 {"OFF\n1 1 0\nx 0 0\n", "line 3: 'x'"},
                                 {"OFF\n1 1 0\n0 0 0\n2 0 0\n", "line 4: a face has '2' corners"},
                                 {"OFF\n1 1 0\n0 0 0\n3 0 0\n", "fewer corners"},
                                 {"OFF\n1 1 0\n0 0 0\n9000000000000000000 0 0\n", "fewer corners"},
                                 {"OFF\n1 1 0\n0 0 0\n3 0 0 1\n", "names vertex '1'; there are 0 to 0"},
                                 {"OFF\n1 1 0\n0 0 0\n3 0 0 -1e10\n", "names vertex '-1e10'"}});
}

}  // namespace
}  // namespace hapticut::obj_off_test
