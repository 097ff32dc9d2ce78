// SPDX-License-Identifier: Apache-2.0
// Refusals of mesh files: each test reads a file, does what the sentence says, and then reads it.
#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <vector>

#include "hapticut/core/units.hpp"
#include "hapticut/import/mesh/meshes.hpp"
#include "support/mesh_measures.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace hapticut::mesh_cures_test {
namespace {

using test::TemporaryFolder;
using units::mm;
using units::mm3;

const std::string kOff = "OFF\n4 4 6\n0 0 0\n6 0 0\n0 6 0\n0 0 6\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
const std::string kPly =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 4\n"
    "property list uchar int vertex_indices\nend_header\n0 0 0\n6 0 0\n0 6 0\n0 0 6\n3 0 2 1\n3 0 1 3\n3 0 3 2\n"
    "3 1 2 3\n";
const std::string kObj = "v 0 0 0\nv 6 0 0\nv 0 6 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

std::string text_stl() {
  std::string text = "solid body\n";
  for (const auto& corners : {std::array{"0 0 0", "0 6 0", "6 0 0"}, std::array{"0 0 0", "6 0 0", "0 0 6"},
                              std::array{"0 0 0", "0 0 6", "0 6 0"}, std::array{"6 0 0", "0 6 0", "0 0 6"}}) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const char* corner : corners) text += "vertex " + std::string(corner) + "\n";
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid body\n";
}

/// The bytes of the tetrahedron as a binary file of one of the writers.
template <class Write>
std::string written(const TemporaryFolder& folder, const char* name, const Write& write) {
  test::write_bytes(folder / "of.off", kOff);
  write(read_mesh(folder / "of.off")[0].mesh, folder / name, 1);
  return test::read_bytes(folder / name);
}

constexpr double kVolume = 36;  // [mm^3] volume of the tetrahedron

double volume_of(const std::filesystem::path& path) {
  double volume = 0;
  for (const NamedMesh& object : read_mesh(path)) volume += test::signed_volume(object.mesh) / mm3;
  return volume;
}

/// A file that is refused, a part of the message, and the same file after its cure.
struct Cure {
  const char* name;
  std::string bytes;
  const char* said;
  const char* cured_name;
  std::string cured;
};

void expect_cured(const std::vector<Cure>& cures) {
  const TemporaryFolder folder;
  for (const Cure& cure : cures) {
    SCOPED_TRACE(std::string(cure.name) + ", " + cure.said);
    test::write_bytes(folder / cure.name, cure.bytes);
    test::expect_refused([&] { return read_mesh(folder / cure.name); }, {cure.name, cure.said});
    test::write_bytes(folder / cure.cured_name, cure.cured);
    EXPECT_NEAR(volume_of(folder / cure.cured_name), kVolume, 1e-6);
  }
}

std::string gzip(const std::string& bytes) {
  z_stream zip{};
  EXPECT_EQ(deflateInit2(&zip, 1, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string out(1000 + bytes.size(), '\0');
  zip.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  zip.avail_in = unsigned(bytes.size());
  zip.next_out = reinterpret_cast<Bytef*>(out.data());
  zip.avail_out = unsigned(out.size());
  EXPECT_EQ(deflate(&zip, Z_FINISH), Z_STREAM_END);
  out.resize(zip.total_out);
  deflateEnd(&zip);
  return out;
}

TEST(MeshCures, OfAFileWithTheEndingOfAnotherFormatIsItsOwnEnding) {
  const TemporaryFolder folder;
  const auto stl = [](const TriangleMesh& m, const std::filesystem::path& p, double unit) { write_stl(m, p, unit); };
  const auto ply = [](const TriangleMesh& m, const std::filesystem::path& p, double unit) { write_ply(m, p, unit); };
  const std::string binary_stl = written(folder, "b.stl", stl), binary_ply = written(folder, "b.ply", ply);
  const std::string solid = text_stl();
  EXPECT_NEAR(volume_of(folder / "b.stl"), kVolume, 1e-6);
  expect_cured({{"a.stl", kPly, "it is a PLY file; rename it to end in .ply.", "r.ply", kPly},
                {"b.stl", binary_ply, "it is a PLY file; rename it to end in .ply.", "r.ply", binary_ply},
                {"c.stl", kOff, "it is an OFF file; rename it to end in .off.", "r.off", kOff},
                {"d.stl", kObj, "it is an OBJ file; rename it to end in .obj.", "r.obj", kObj},
                {"e.stl", "# made by hand\n" + kObj, "it is an OBJ file; rename it to end in .obj.", "r.obj", kObj},
                {"f.ply", solid, "it is an STL file; rename it to end in .stl.", "r.stl", solid},
                {"o.ply", binary_stl, "it is an STL file; rename it to end in .stl.", "r.stl", binary_stl},
                {"p.obj", binary_stl, "it is an STL file; rename it to end in .stl.", "r.stl", binary_stl},
                {"g.ply", kOff, "it is an OFF file", "r.off", kOff},
                {"h.ply", kObj, "it is an OBJ file", "r.obj", kObj},
                {"i.obj", solid, "it is an STL file", "r.stl", solid},
                {"j.obj", kPly, "it is a PLY file", "r.ply", kPly},
                {"k.obj", kOff, "it is an OFF file", "r.off", kOff},
                {"l.off", solid, "it is an STL file", "r.stl", solid},
                {"m.off", kPly, "it is a PLY file", "r.ply", kPly},
                {"n.off", kObj, "it is an OBJ file", "r.obj", kObj}});
}

TEST(MeshCures, OfAnArchiveIsToUnpackIt) {
  const std::string packed = gzip(kPly);
  for (const char* name : {"a.stl", "a.ply", "a.obj", "a.off"})
    expect_cured({{name, packed, "it is a gzip archive; unpack it, and name the mesh in it.", "u.ply", kPly}});
  const std::string zip = std::string("PK\x03\x04\x14\0\0\0", 8) + std::string(200, '\1');
  expect_cured({{"z.stl", zip, "it is a ZIP archive; unpack it", "u.ply", kPly}});
}

TEST(MeshCures, OfWhatIsNoMeshIsTheFileItself) {
  const std::string page = "<!DOCTYPE html>\n<html><head><title>404</title></head><body>Not Found</body></html>\n";
  const std::string pointer =
      "version https://git-lfs.github.com/spec/v1\noid sha256:" + std::string(64, '4') + "\nsize 8812345\n";
  const std::string solid = text_stl();
  const std::pair<const char*, const std::string*> right[] = {
      {"a.stl", &solid}, {"a.ply", &kPly}, {"a.obj", &kObj}, {"a.off", &kOff}};
  for (const auto& [name, bytes] : right)
    expect_cured(
        {{name, page, "it is a web page in place of the file: a download went wrong", name, *bytes},
         {name, pointer, "it is a Git LFS pointer, a text in place of the file; run 'git lfs pull'", name, *bytes},
         {name, "%PDF-1.7\n", "it is a PDF document; name a mesh.", name, *bytes},
         {name, "\x89PNG\r\n\x1a\n", "it is a PNG picture; name a mesh.", name, *bytes},
         {name, "# vtk DataFile Version 4.2\n", "it is a VTK file; save the mesh as STL", name, *bytes}});
  expect_cured({{"t.stl", "Dear all,\nhere is the mesh.\n" + std::string(100, 'x'),
                 "it is not an STL file: it is a text that begins with 'Dear'", "t.stl", solid}});
  const TemporaryFolder folder;
  for (const char* name : {"a.gltf", "a.glb"}) {
    test::write_bytes(folder / name, pointer);
    test::expect_refused([&] { return read_mesh(folder / name); }, "Git LFS pointer");
  }
}

TEST(MeshCures, OfAWrongLengthIsACompleteCopy) {
  const TemporaryFolder folder;
  const auto stl = [](const TriangleMesh& m, const std::filesystem::path& p, double unit) { write_stl(m, p, unit); };
  const auto ply = [](const TriangleMesh& m, const std::filesystem::path& p, double unit) { write_ply(m, p, unit); };
  const std::string binary_stl = written(folder, "b.stl", stl), binary_ply = written(folder, "b.ply", ply);
  std::string two_announced = binary_stl, three_faces = binary_ply;
  two_announced[80] = 2;
  three_faces.replace(three_faces.find("element face 4"), 14, "element face 3");
  expect_cured(
      {{"a.stl", binary_stl.substr(0, 200), "it announces 4 triangles, but has bytes for 2; it is truncated", "a.stl",
        binary_stl},
       {"b.stl", two_announced, "it announces 2 triangles, but has bytes for 4; it is damaged", "b.stl", binary_stl},
       {"c.ply", binary_ply.substr(0, binary_ply.size() - 5), "is missing; the file is truncated", "c.ply", binary_ply},
       {"d.ply", three_faces, "13 bytes follow after the last element", "d.ply", binary_ply},
       {"e.off", kOff + "3 0 1 2\n", "'3' follows after the last face that is announced.", "e.off", kOff},
       {"f.off", kOff.substr(0, kOff.size() - 8), "it announces 4 times a face, but ends after 3", "f.off", kOff}});
  // Blanks and zeros at the end are common, and nothing is lost.
  test::write_bytes(folder / "z.stl", binary_stl + std::string(60, '\0'));
  test::write_bytes(folder / "z.ply", binary_ply + "\r\n");
  test::write_bytes(folder / "z.off", kOff + "\n# the end\n\n");
  for (const char* name : {"z.stl", "z.ply", "z.off"}) EXPECT_NEAR(volume_of(folder / name), kVolume, 1e-6) << name;
}

TEST(MeshCures, OfAUnitIsTheOneThatIsNamed) {
  const TemporaryFolder folder;
  test::write_bytes(folder / "a.obj", "v 0 0 0\nv 2e5 0 0\nv 0 2e5 0\nv 0 0 2e5\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  test::expect_refused([&] { return read_mesh(folder / "a.obj"); }, "Set unit_mm to 0.001 if its unit is a micrometre");
  EXPECT_NEAR(test::signed_volume(read_mesh(folder / "a.obj", 0.001).at(0).mesh) / mm3, 200 * 200 * 200 / 6.0, 1e-3);
}

TEST(MeshFrame, OfSlicerIsTurnedToPatientAxes) {
  const TemporaryFolder folder;
  const auto stl = [](const TriangleMesh& m, const std::filesystem::path& p, double unit) { write_stl(m, p, unit); };
  const std::string binary = written(folder, "b.stl", stl);
  const auto named = [&](const std::string& space) {
    const std::string header = "3D Slicer output. SPACE=" + space;
    std::string named_binary = binary, named_ply = kPly;
    named_binary.replace(0, 80, header + std::string(80 - header.size(), ' '));
    named_ply.insert(named_ply.find("element vertex"), "comment " + header + "\n");
    std::string named_text = text_stl();
    named_text.replace(named_text.find("body"), 4, header);
    test::write_bytes(folder / "a.stl", named_binary);
    test::write_bytes(folder / "b.stl", named_text);
    test::write_bytes(folder / "c.ply", named_ply);
    test::write_bytes(folder / "d.obj", "# " + header + "\n" + kObj);
  };
  for (const auto& [space, sign] : {std::pair("LPS", 1), std::pair("RAS", -1)}) {
    named(space);
    for (const char* name : {"a.stl", "b.stl", "c.ply", "d.obj"}) {
      const TriangleMesh mesh = read_mesh(folder / name).at(0).mesh;
      EXPECT_NEAR(test::signed_volume(mesh) / mm3, kVolume, 1e-6) << name << ": it is turned, not mirrored";
      Vec3 sum = Vec3::Zero();
      for (const Vec3& v : mesh.vertices) sum += v / mm;
      EXPECT_NEAR((sum - Vec3(6 * sign, 6 * sign, 6)).norm(), 0, 1e-6) << name << ' ' << space;
    }
  }
  named("LAS");
  for (const char* name : {"a.stl", "b.stl", "c.ply", "d.obj"})
    test::expect_refused([&] { return read_mesh(folder / name); }, "its header names the space LAS");
  named("RASTER");
  EXPECT_GT(read_mesh(folder / "a.stl").at(0).mesh.vertices[1].sum(), 0);
}

}  // namespace
}  // namespace hapticut::mesh_cures_test
