// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "hapticut/core/units.hpp"
#include "support/mesh_parsers.hpp"
#include "support/meshes.hpp"
#include "support/temporary_folder.hpp"
#include "support/test_data.hpp"

namespace hapticut::mesh_formats_test {
namespace {

using namespace test;

TEST(MeshFormats, ABoxThatIsNotConvexKeepsItsVolume) {
  // A cube with a notch. Its top and bottom are polygons with eight corners, whose fans overlap.
  const std::string text =
      "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\nv 0 0 1\nv 3 0 1\nv 3 3 1\nv 2 3 1\n"
      "v 2 1 1\nv 1 1 1\nv 1 3 1\nv 0 3 1\nf 8 7 6 5 4 3 2 1\nf 9 10 11 12 13 14 15 16\nf 1 2 10 9\nf 2 3 11 10\n"
      "f 3 4 12 11\nf 4 5 13 12\nf 5 6 14 13\nf 6 7 15 14\nf 7 8 16 15\nf 8 1 9 16\n";
  const TriangleMesh mesh = only_mesh_in(parse_obj, text);
  EXPECT_TRUE(test::is_closed(mesh));
  EXPECT_DOUBLE_EQ(test::signed_volume(mesh), 7);
}

TEST(MeshFormats, VerticesAtTheSamePlaceAreOneAndTrianglesWithoutAreaAreDropped) {
  const TriangleMesh mesh =
      only_mesh_in(parse_obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv -0 -0 0\nv 0 0 1\nf 1 2 3\nf 4 2 5\nf 1 4 2\nf 1 1 2\n");
  EXPECT_EQ(mesh.vertices.size(), 4U);
  EXPECT_EQ(mesh.triangles.size(), 2U);
}

/// Parses cut-off copies and copies with changed bytes. Each must give valid meshes or an error of one sentence.
void try_hostile(Parser parse, const std::string& bytes, std::mt19937& random, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    std::string hostile = bytes.substr(0, round % 3 == 0 ? random() % (bytes.size() + 1) : bytes.size());
    if (round % 3 != 0)
      for (int k = 0; k < 3; ++k)
        hostile[random() % hostile.size()] = round % 3 == 1 ? char(random()) : "0123456789 -.\ne/"[random() % 16];
    try {
      for (const NamedMesh& object : meshes_in(parse, hostile)) {
        for (const auto& t : object.mesh.triangles)
          for (const std::uint32_t v : t) ASSERT_LT(v, object.mesh.vertices.size());
        for (const Vec3& v : object.mesh.vertices) ASSERT_TRUE(is_finite(v));
      }
    } catch (const Error& error) {
      const std::string text = error.what();
      ASSERT_EQ(text.find('\n'), std::string::npos) << text;
      ASSERT_EQ(text.back(), '.') << text;
    }
  }
}

TEST(MeshFormats, HostileBytesGiveAMeshOrOneSentence) {
  const test::TemporaryFolder folder;
  const TriangleMesh ball = test::ball_mesh(Vec3::Zero(), 2e-3, 6);
  write_stl(ball, folder / "ball.stl");
  write_ply(ball, folder / "ball.ply");
  write_obj(ball, folder / "ball.obj");
  std::mt19937 random(11);
  constexpr int kRounds = 3000;
  try_hostile(parse_stl, test::read_bytes(folder / "ball.stl"), random, kRounds);
  try_hostile(parse_stl,
              "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
              "endsolid\n",
              random, kRounds);
  try_hostile(parse_ply, test::read_bytes(folder / "ball.ply"), random, kRounds);
  try_hostile(parse_ply,
              "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement "
              "face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
              random, kRounds);
  try_hostile(parse_obj, test::read_bytes(folder / "ball.obj"), random, kRounds);
  try_hostile(parse_obj, "o a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1/1/1 2//2 3 -1\ng b\nf -1 \\\n-2 -3\n", random,
              kRounds);
  try_hostile(parse_off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", random, kRounds);
}

/// The corners of all triangles in order, because indices depend on the order of vertices.
std::vector<Vec3> corners_of(const TriangleMesh& mesh) {
  std::vector<Vec3> corners;
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t) corners.push_back(mesh.vertices[v]);
  return corners;
}

void expect_same(const TriangleMesh& a, const TriangleMesh& b, double tolerance) {
  const std::vector<Vec3> of_a = corners_of(a), of_b = corners_of(b);
  ASSERT_EQ(of_a.size(), of_b.size());
  for (std::size_t n = 0; n < of_a.size(); ++n) EXPECT_LE((of_a[n] - of_b[n]).norm(), tolerance);
}

TEST(MeshFormats, AnythingThatIsWrittenIsReadBack) {
  const test::TemporaryFolder folder;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-0.01, 0.01);  // [m]
  for (int round = 0; round < 20; ++round) {
    std::vector<NamedMesh> objects = {{"first one", {}}, {"second", {}}};
    for (NamedMesh& object : objects)
      for (std::uint32_t n = 0; n < 30; ++n) {
        object.mesh.vertices.emplace_back(coordinate(random), coordinate(random), coordinate(random));
        if (n > 1) object.mesh.triangles.push_back({n, std::uint32_t(random() % (n - 1)), n - 1});
      }
    const double unit_mm = round % 2 == 0 ? 1 : 25.4;
    write_obj(objects, folder / "a.obj", unit_mm);
    const std::vector<NamedMesh> again = read_mesh(folder / "a.obj", unit_mm);
    ASSERT_EQ(again.size(), 2U);
    constexpr double kTwoConversions = 1e-17, kSinglePrecision = 2e-9;  // [m]
    for (std::size_t n = 0; n < 2; ++n) {
      EXPECT_EQ(again[n].name, objects[n].name);
      expect_same(again[n].mesh, objects[n].mesh, kTwoConversions);
    }
    write_ply(objects[0].mesh, folder / "a.ply", unit_mm);
    write_stl(objects[0].mesh, folder / "a.stl", unit_mm);
    write_ply({objects[0].mesh, std::vector<Color>(30, Color{1, 2, 3})}, folder / "colored.ply", unit_mm);
    for (const char* name : {"a.ply", "a.stl", "colored.ply"})
      expect_same(read_mesh(folder / name, unit_mm).at(0).mesh, objects[0].mesh, kSinglePrecision);
    EXPECT_THROW(write_ply({objects[0].mesh, {}}, folder / "x.ply"), Error);
  }
}

TEST(MeshFormats, ObjectsWithoutANameAreWrittenApart) {
  const test::TemporaryFolder folder;
  const TriangleMesh ball = test::ball_mesh(Vec3::Zero(), 2e-3, 4);
  write_obj({{"", ball}, {"with\nbreak", ball}}, folder / "two.obj");
  const std::vector<NamedMesh> meshes = read_mesh(folder / "two.obj");
  ASSERT_EQ(meshes.size(), 2U);
  EXPECT_EQ(meshes[0].name, "object 1");
  EXPECT_EQ(meshes[1].name, "with break");
}

/// Counts, volume [mm^3] and area [mm^2] that another reader (Assimp 5.2, in single precision) finds.
struct KnownMesh {
  const char* name;
  std::size_t objects, triangles;
  double volume, area;
};

TEST(MeshFormats, MeshesOfOthersAreWhatAnotherReaderFinds) {
  const std::vector<KnownMesh> known = {{"meshes/box.STL", 1, 8954, 16.0844891, 293.796681},
                                        {"meshes/burr.stl", 1, 3120, 6.95944905, 24.9109638},
                                        {"meshes/handpiece_chai3d.obj", 1, 514, 8129.53121, 3040.76309},
                                        {"meshes/molar_chai3d.obj", 2, 8768, 15637458.6, 557810.977},
                                        {"meshes/nancolor.obj", 1, 12, 1, 6},
                                        {"meshes/negative_indices.obj", 1, 12, 8, 24},
                                        {"meshes/openscad-nonmanifold-crash.obj", 1, 1442, 451.960063, 1276.32056},
                                        {"meshes/self_intersectA.obj", 1, 17160, 0.147953423, 3.05810676},
                                        {"meshes/shared.STL", 1, 24, 2, 12},
                                        {"meshes/soup.stl", 1, 100, -0.0486174471, 14.5789128},
                                        {"meshes/two_objects_mixed_case_names.stl", 2, 24, 2, 12},
                                        {"meshes/wallhole.obj", 1, 66, 1066.66667, 761.421356},
                                        {"teeth/URI1_tooth_mesh1.ply", 1, 16403, 114.878732, 233.831862},
                                        {"teeth/URI1_tooth_mesh2.ply", 1, 31026, 549.347502, 451.744926},
                                        {"teeth/URI1_tooth_mesh3.ply", 1, 72704, 19.5911106, 65.9380392},
                                        // These values are not from Assimp. It refuses the first file, a cube of edge
                                        // 1. Of the second, a cube of edge 2, it loses two triangles; 4/3 is the
                                        // volume with mixed windings.
                                        {"hostile/ply-nl.ply", 1, 12, 1, 6},
                                        {"hostile/mesh-winding.off", 1, 12, 4.0 / 3, 24}};
  HAPTICUT_NEEDS_DATA(known[0].name);
  constexpr double kSingle = 3e-7;  // the other reader rounds coordinates to single precision
  for (const KnownMesh& expected : known) {
    const std::vector<NamedMesh> meshes = read_mesh(test::data_path(expected.name));
    EXPECT_EQ(meshes.size(), expected.objects) << expected.name;
    std::size_t triangles = 0;
    double volume = 0, area = 0;
    for (const NamedMesh& object : meshes) {
      triangles += object.mesh.triangles.size();
      volume += test::signed_volume(object.mesh) / units::mm3;
      area += test::area(object.mesh) / (units::mm * units::mm);
    }
    EXPECT_EQ(triangles, expected.triangles) << expected.name;
    EXPECT_NEAR(volume, expected.volume, kSingle * std::abs(expected.volume)) << expected.name;
    EXPECT_NEAR(area, expected.area, kSingle * expected.area) << expected.name;
  }
}

}  // namespace
}  // namespace hapticut::mesh_formats_test
