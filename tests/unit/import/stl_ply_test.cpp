// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "support/mesh_parsers.hpp"
#include "support/volume_files.hpp"

namespace hapticut::stl_ply_test {
namespace {

using namespace test;

// --- STL

constexpr char kFacet[] =
    "facet normal nan -nan 1.#IND\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\nendfacet\n";

TEST(StlFormat, TextHasASolidForEachObject) {
  const std::string one = std::string("solid one thing\n") + kFacet + "endsolid one thing\n";
  const std::string two = one + "\nSolid\n" + kFacet + kFacet + "ENDSOLID";
  for (const std::string& text : {two, replaced(two, "facet", "FACET"), replaced(two, "\n", "\r\n"), "  " + two}) {
    const std::vector<NamedMesh> meshes = meshes_in(parse_stl, text);
    ASSERT_EQ(meshes.size(), 2U);
    EXPECT_EQ(meshes[0].name, "one thing");
    EXPECT_EQ(meshes[0].mesh.vertices.size(), 3U);
    EXPECT_EQ(meshes[1].name, "object 2");
    EXPECT_EQ(meshes[1].mesh.triangles.size(), 2U);
  }
  EXPECT_EQ(only_mesh_in(parse_stl, "solid x\n" + replaced(kFacet, "\n", " ") + "endsolid").triangles.size(), 1U);
}

TEST(StlFormat, TextOfCarelessProgramsIsRead) {
  const std::string plain = std::string("solid one\n") + kFacet + kFacet + "endsolid one\n";
  for (const std::string& text :
       {replaced(plain, "endsolid one", "end solid"), replaced(plain, "endsolid one\n", "end solid another name"),
        replaced(plain, "endsolid one", "END SOLID ONE") + "\n\n", replaced(plain, "endsolid one\n", "EndSolid"),
        replaced(replaced(plain, "endfacet", "end facet"), "endloop", "End Loop"),
        replaced(plain, "normal nan -nan 1.#IND", "normal"), replaced(plain, "\n", "\n\n \t\n"),
        replaced(plain, "\n", "\r")}) {
    const std::vector<NamedMesh> meshes = meshes_in(parse_stl, text + "\n" + text);
    ASSERT_EQ(meshes.size(), 2U) << text;
    for (const NamedMesh& object : meshes) {
      EXPECT_EQ(object.name, "one");
      EXPECT_EQ(object.mesh.triangles.size(), 2U) << text;
    }
  }
}

TEST(StlFormat, DamagedTextIsRefusedWithTheLine) {
  const std::string solid = std::string("solid one\n") + kFacet + "endsolid one\n";
  expect_all_refused(
      parse_stl,
      {{solid.substr(0, solid.find("endsolid")), "ends before 'endsolid'"},
       {solid.substr(0, 40), "ends before 'endsolid'"},
       {replaced(solid, "vertex 1 0 0", "vertex 1 0"), "line 5: a coordinate is missing"},
       {replaced(solid, "vertex 1 0 0", "vertex 1 0 x"), "line 5: 'x'"},
       {replaced(solid, "vertex 1 0 0", "vertex 1 0 inf"), "line 5: a coordinate is not a finite number"},
       {replaced(solid, "  vertex 1 0 0\n", ""), "'endloop' is in the place of 'vertex'"},
       {replaced(solid, " endloop", " vertex 1 1 1\nendloop"), "line 7: 'vertex' is in the place of 'endloop'"},
       {replaced(solid, "outer loop", "outer"), "'vertex' is in the place of 'loop'"},
       {replaced(solid, "endsolid one", "end one"), "'end' is in the place of 'facet'"},
       {replaced(solid, "endloop", "end facet"), "'end' is in the place of 'endloop'"},
       {solid + "more", "line 10: 'more' is in the place of 'solid'"}});
}

std::string binary_stl(const std::string& begin, std::uint32_t announced, const std::vector<float>& coordinates) {
  std::string bytes = begin + std::string(80 - begin.size(), ' ') + test::little(announced);
  for (std::size_t at = 0; at < coordinates.size(); at += 9)
    bytes += std::string(12, '\xff') +  // a NaN normal
             test::little(std::vector<float>(coordinates.begin() + long(at), coordinates.begin() + long(at) + 9)) +
             std::string(2, '\0');
  return bytes;
}

TEST(StlFormat, ABinaryFileMayBeginWithTheWordOfATextFile) {
  const std::vector<float> triangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  EXPECT_EQ(only_mesh_in(parse_stl, binary_stl("solid facet normal", 1, triangle)).triangles.size(), 1U);
  EXPECT_EQ(only_mesh_in(parse_stl, binary_stl("", 1, triangle) + "more").triangles.size(), 1U);
}

TEST(StlFormat, ABinaryFileMustBeAsLongAsItSays) {
  const std::vector<float> triangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::string file = binary_stl("", 1, triangle);
  for (std::size_t length = 0; length < file.size(); ++length)
    EXPECT_NE(error_of(parse_stl, file.substr(0, length)), "") << length;
  EXPECT_NE(error_of(parse_stl, binary_stl("", 0xffffffff, triangle)).find("announces 4294967295 triangles"),
            std::string::npos);
  auto bad = triangle;
  bad[4] = std::numeric_limits<float>::infinity();
  EXPECT_NE(error_of(parse_stl, binary_stl("", 1, bad)).find("triangle 1 has a coordinate"), std::string::npos);
}

// --- PLY

/// Writes the values of a PLY file in any of its formats.
class PlyWriter {
 public:
  explicit PlyWriter(std::string format) : format_(std::move(format)) {}

  std::string header(const std::string& elements) const {
    return "ply\nformat " + format_ + " 1.0\n" + elements + "end_header\n";
  }

  template <class Number>
  PlyWriter& add(Number number) {
    if (format_ == "ascii")
      values += std::to_string(number) + (++count_ % 7 == 0 ? "\n" : " ");
    else
      values += format_ == "binary_big_endian" ? test::big(number) : test::little(number);
    return *this;
  }

  std::string values;

 private:
  std::string format_;
  int count_ = 0;
};

constexpr std::array<std::array<int, 3>, 8> kCorners = {
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
constexpr std::array<std::array<int, 4>, 6> kSides = {
    {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

class PlyFormats : public testing::TestWithParam<const char*> {};

TEST_P(PlyFormats, ACubeIsReadWithAnyTypesAndFurtherElements) {
  PlyWriter w(GetParam());
  for (const auto& p : kCorners) {  // properties in an unusual order, with a list between them
    w.add(std::uint8_t(2)).add(std::int16_t(-1)).add(std::int16_t(7));
    w.add(double(p[2])).add(float(p[0])).add(std::uint16_t(400)).add(std::int8_t(p[1]));
  }
  for (int n = 0; n < 3; ++n) w.add(std::int32_t(n));
  for (const auto& side : kSides) {
    w.add(0.5F);
    w.add(std::uint16_t(4));
    for (const int corner : side) w.add(std::uint32_t(corner));
  }
  const std::string header = w.header(
      "comment a cube\nelement vertex 8\nproperty list uchar short more\nproperty float64 z\nproperty float "
      "x\nproperty "
      "ushort density\nproperty char y\nobj_info nothing\nelement edge 3\nproperty int a\nelement empty 4000000000\n"
      "element face 6\nproperty float quality\nproperty list uint16 uint vertex_indices\n");
  expect_unit_cube(only_mesh_in(parse_ply, header + w.values));
  expect_unit_cube(only_mesh_in(parse_ply, "\xef\xbb\xbf" + header + w.values));
  expect_unit_cube(only_mesh_in(parse_ply, replaced(header, "\n", "\r\n") + w.values));
  expect_unit_cube(only_mesh_in(parse_ply, replaced(header, "\n", "\r") + w.values));
  for (std::size_t length = 0; length + 2 < (header + w.values).size(); ++length)
    EXPECT_NE(error_of(parse_ply, (header + w.values).substr(0, length)), "") << length;
}

TEST_P(PlyFormats, TriangleStripsAreTrianglesOfOneSide) {
  PlyWriter w(GetParam());
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}, {0, 2}, {1, 2}})
    w.add(float(x)).add(float(y)).add(0.0F);
  w.add(std::int32_t(10));
  for (const int v : {0, 1, 2, 3, -1, 3, 5, 2, 4, -1}) w.add(std::int32_t(v));
  const TriangleMesh mesh = only_mesh_in(
      parse_ply,
      w.header("element vertex 6\nproperty float x\nproperty float y\nproperty float z\nelement tristrips 1\n"
               "property list int int vertex_indices\n") +
          w.values);
  ASSERT_EQ(mesh.triangles.size(), 4U);
  for (const auto& t : mesh.triangles) {
    const Vec3 normal = (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
    EXPECT_EQ(normal.z(), 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Ply, PlyFormats, testing::Values("ascii", "binary_little_endian", "binary_big_endian"),
                         [](const auto& format) { return std::string(format.param); });

TEST(PlyFormat, FacesMayStandBeforeTheVertices) {
  EXPECT_EQ(only_mesh_in(parse_ply,
                         "ply\nformat ascii 1.0\nelement face 1\nproperty list int int vertex_index\nelement vertex 3\n"
                         "property int x\nproperty int y\nproperty int z\nend_header\n3 0 1 2\n0 0 0 1 0 0 0 1 0")
                .triangles.size(),
            1U);
}

constexpr char kPlyHeader[] =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n";

TEST(PlyFormat, DamagedFilesAreRefusedWithTheirPlace) {
  const std::string header = kPlyHeader, vertices = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(error_of(parse_ply, header + vertices + "3 0 1 2\n"), "");
  expect_all_refused(
      parse_ply,
      {{"plx\n", "does not begin like a PLY file"},
       {"ply", "does not begin like a PLY file"},
       {header.substr(0, 60), "ends before 'end_header'"},
       {replaced(header, "format ascii 1.0\n", "") + vertices + "3 0 1 2\n", "without a line 'format'"},
       {replaced(header, "ascii", "text"), "line 2 of its header: the format 'text'"},
       {replaced(header, "vertex 3", "vertex x"), "line 3 of its header: the number 'x'"},
       {replaced(header, "vertex 3", "vertex -3"), "the number '-3'"},
       {replaced(header, "element face", "element vertex"), "appears twice"},
       {replaced(header, "float x", "half x"), "line 4 of its header: 'half' is not a type"},
       {replaced(header, "list uchar", "list byte"), "'byte' is not a type"},
       {replaced(header, "float z", "float"), "has no name"},
       {replaced(header, "element face", "elemental face"), "'elemental' is not a keyword"},
       {replaced(header, "float z", "float w") + vertices, "one property x, one y and one z"},
       {replaced(header, "float z", "float x") + vertices, "one property x, one y and one z"},
       {replaced(header, "list uchar int vertex_indices", "int vertex_indices") + vertices, "one list named"},
       {header + "0 0 0\n1 0 0\n", "element 3 of 3 of 'vertex' is missing"},
       {header + "0 0 0\n1 a 0\n", "line 11: 'a' is not a number"},
       {header + "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2", "vertex 2 of a face has a coordinate that is not a finite number"},
       {header + vertices + "2 0 1\n", "element 1 of 1 of 'face' has 2 corners"},
       {header + vertices + "-1\n", "has a list 'vertex_indices' of -1 values"},
       {header + vertices + "1e300 0\n", "of 1e+300 values"},
       {header + vertices + "3 0 1 3\n", "names vertex 3; there are 3"},
       {header + vertices + "3 0 1 -1\n", "names vertex -1"},
       {header + vertices + "3 0 1 1.5\n", "names vertex 1.5"},
       {header + vertices + "3 0 1 nan\n", "names vertex"},
       {header + vertices + "3 0 1\n", "element 1 of 1 of 'face' is missing"},
       {header + vertices + "3 0 1 2 9\n", "line 13: '9' follows after the last element of the header"},
       {replaced(header, "element face 1", "element face 4000000000") + vertices + "3 0 1 2\n", "truncated"},
       {replaced(header, "vertex 3", "vertex 4000000000") + vertices, "truncated"}});
}

}  // namespace
}  // namespace hapticut::stl_ply_test
