// SPDX-License-Identifier: Apache-2.0
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <assimp/Exporter.hpp>
#include <cstring>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/import/mesh/meshes.hpp"
#include "support/mesh_measures.hpp"
#include "support/meshes.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace hapticut::assimp_test {
namespace {

using units::mm;

/// A scene with one node that has a mesh and a translation.
std::unique_ptr<aiScene> scene_of(const TriangleMesh& mesh, const Vec3& shift) {
  auto scene = std::make_unique<aiScene>();
  auto* const shape = new aiMesh;  // owned by the scene, like everything below
  shape->mName = "ball";
  shape->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  shape->mNumVertices = unsigned(mesh.vertices.size());
  shape->mVertices = new aiVector3D[mesh.vertices.size()];
  shape->mNormals = new aiVector3D[mesh.vertices.size()];
  for (std::size_t n = 0; n < mesh.vertices.size(); ++n) {
    const Vec3 p = mesh.vertices[n];  // a unit of glTF is a metre
    shape->mVertices[n] = aiVector3D(float(p.x()), float(p.y()), float(p.z()));
    shape->mNormals[n] = aiVector3D(0, 0, 1);
  }
  shape->mNumFaces = unsigned(mesh.triangles.size());
  shape->mFaces = new aiFace[mesh.triangles.size()];
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
    shape->mFaces[n].mNumIndices = 3;
    shape->mFaces[n].mIndices = new unsigned[3]{mesh.triangles[n][0], mesh.triangles[n][1], mesh.triangles[n][2]};
  }
  scene->mNumMeshes = scene->mNumMaterials = 1;
  scene->mMeshes = new aiMesh* [1] { shape };
  scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
  auto* const node = new aiNode("ball");
  node->mNumMeshes = 1;
  node->mMeshes = new unsigned[1]{0};
  aiMatrix4x4::Translation(aiVector3D(float(shift.x()), float(shift.y()), float(shift.z())), node->mTransformation);
  scene->mRootNode = new aiNode("root");
  scene->mRootNode->addChildren(1, const_cast<aiNode**>(&node));
  return scene;
}

/// Writes the scene in a format of Assimp: gltf2, glb2.
void export_scene(const aiScene& scene, const char* format, const std::filesystem::path& path) {
  Assimp::Exporter exporter;
  ASSERT_EQ(exporter.Export(&scene, format, path.string()), aiReturn_SUCCESS);
}

/// Writes a ball.  @return the bytes of the file
std::string export_ball(const char* format, const std::filesystem::path& path) {
  export_scene(*scene_of(test::ball_mesh(Vec3::Zero(), 2 * mm, 4), Vec3::Zero()), format, path);
  return test::read_bytes(path);
}

TEST(Assimp, ReadsGltfWithTheTransformsOfItsNodes) {
  const test::TemporaryFolder folder;
  const TriangleMesh ball = test::ball_mesh(Vec3::Zero(), 2 * mm, 8);
  const Vec3 shift(50 * mm, 0, 0);  // Assimp treats 5 mm as no translation and does not write it
  const auto scene = scene_of(ball, shift);
  for (const auto& [format, name] : {std::pair{"gltf2", "ball.gltf"}, {"glb2", "ball.GLB"}}) {
    export_scene(*scene, format, folder / name);
    const std::vector<NamedMesh> meshes = read_mesh(folder / name);
    ASSERT_EQ(meshes.size(), 1U) << format;
    const TriangleMesh& mesh = meshes[0].mesh;
    EXPECT_EQ(mesh.vertices.size(), ball.vertices.size()) << format;
    EXPECT_EQ(mesh.triangles.size(), ball.triangles.size()) << format;
    EXPECT_TRUE(test::is_closed(mesh)) << format;
    constexpr double kSingle = 1e-6;  // the file holds single precision
    EXPECT_NEAR(test::signed_volume(mesh), test::signed_volume(ball), kSingle * test::signed_volume(ball)) << format;
    Vec3 center = Vec3::Zero();
    for (const Vec3& v : mesh.vertices) center += v / double(mesh.vertices.size());
    EXPECT_LT((center - shift).norm(), kSingle * shift.norm()) << format;
    const TriangleMesh in_mm = read_mesh(folder / name, 1).at(0).mesh;  // as written by a program without units
    EXPECT_NEAR(test::signed_volume(in_mm) * 1e9, test::signed_volume(mesh), kSingle * test::signed_volume(mesh));
  }
}

// A mirrored node reverses its faces, so they still point outwards (glTF 2.0, 3.7.4).
TEST(Assimp, AMirroredNodeEnclosesWhatItDid) {
  const test::TemporaryFolder folder;
  const TriangleMesh ball = test::ball_mesh(Vec3::Zero(), 2 * mm, 8);
  const auto scene = scene_of(ball, Vec3::Zero());
  aiMatrix4x4& transform = scene->mRootNode->mChildren[0]->mTransformation;
  transform = aiMatrix4x4::Scaling(aiVector3D(-1, 1, 1), transform);
  export_scene(*scene, "gltf2", folder / "ball.gltf");
  const double volume = test::signed_volume(read_mesh(folder / "ball.gltf").at(0).mesh);
  EXPECT_NEAR(volume, test::signed_volume(ball), 1e-6 * volume);
}

std::string refusal(const std::filesystem::path& path) {
  return test::refusal([&] { return read_mesh(path); });
}

TEST(Assimp, RefusalsAreOfOurOwnWords) {
  const test::TemporaryFolder folder;
  (void)export_ball("gltf2", folder / "ball.gltf");
  std::filesystem::remove(folder / "ball.bin");
  test::expect_part(refusal(folder / "ball.gltf"),
                    "the file 'ball.bin' that it refers to cannot be read; keep the files together");
  for (const char* text :
       {"{", "no gltf", "{\"asset\":{\"version\":\"2.0\"}}", "{\"asset\":{\"version\":\"2.0\"},\"meshes\":3}"}) {
    test::write_bytes(folder / "bad.gltf", text);
    SCOPED_TRACE(text);
    test::expect_part(refusal(folder / "bad.gltf"), "export it again as glTF 2.0 without compression");
  }
}

/// A .gltf or .glb with an additional last member in its JSON.
std::string with_member(const std::string& file, const std::string& member) {
  constexpr std::size_t kHeader = 20;
  const auto extended = [&](const std::string& json) { return json.substr(0, json.rfind('}')) + "," + member + "}"; };
  if (!file.starts_with("glTF")) return extended(file);
  std::uint32_t length = 0;
  std::memcpy(&length, file.data() + 12, sizeof length);
  std::string json = extended(file.substr(kHeader, length));
  json.append((4 - json.size() % 4) % 4, ' ');
  std::string whole = file.substr(0, kHeader) + json + file.substr(kHeader + length);
  for (const auto& [place, size] : {std::pair{8, whole.size()}, {12, json.size()}}) {
    const auto number = std::uint32_t(size);
    std::memcpy(whole.data() + place, &number, sizeof number);
  }
  return whole;
}

TEST(Assimp, ExtensionsThatChangeTheShapeAreRefusedByName) {
  const test::TemporaryFolder folder;
  for (const auto& [format, file_name] : {std::pair{"gltf2", "ball.gltf"}, {"glb2", "ball.glb"}}) {
    const char* name = file_name;  // copy for the lambda capture
    const std::string file = export_ball(format, folder / name);
    const auto refusal_with = [&](const std::string& member) {
      test::write_bytes(folder / name, with_member(file, member));
      return refusal(folder / name);
    };
    for (const char* extension : {"KHR_mesh_quantization", "EXT_mesh_gpu_instancing", "VENDOR_shape"}) {
      test::expect_part(
          refusal_with(std::string(R"("extensionsRequired" : ["KHR_materials_unlit", ")") + extension + "\"]"),
          std::string("it needs the glTF extension '") + extension + "', which is not supported; export");
    }
    test::expect_part(refusal_with(R"("extensionsUsed":["EXT_mesh_gpu_instancing"])"), "_gpu_");
    // The refusal also names the extension when the JSON contains bytes that are not UTF-8.
    test::expect_part(refusal_with("\"extras\":\"\xe4\",\"extensionsRequired\":[\"VENDOR_shape\"]"), "VENDOR_shape");
    EXPECT_EQ(refusal_with(R"("extensionsRequired":["KHR_materials_unlit","KHR_texture_transform"])"), "");
    EXPECT_EQ(refusal_with(R"("extras":{"a":"\"[","extensionsRequired":["VENDOR_shape"]})"), "");
  }
}

TEST(Assimp, AShapeThatIsPosedIsRefused) {
  const test::TemporaryFolder folder;
  const std::string file = export_ball("gltf2", folder / "ball.gltf");
  for (const auto& [before, member, posed] : {std::tuple{"\"mesh\":", "\"skin\":0,", true},
                                              {"\"primitives\":", "\"weights\":[0,1],", true},
                                              {"\"primitives\":", "\"weights\":[0,0],", false}}) {
    std::string changed = file;
    ASSERT_NE(file.find(before), std::string::npos) << file;
    test::write_bytes(folder / "ball.gltf", changed.insert(file.find(before), member));
    EXPECT_EQ(refusal(folder / "ball.gltf").find("posed by bones") != std::string::npos, posed) << member;
  }
}

TEST(Assimp, FilesBesideAreFoundByTheirUris) {
  const test::TemporaryFolder whole;
  const std::filesystem::path folder = whole / "a%20b";
  std::filesystem::create_directory(folder);
  std::string text = export_ball("gltf2", folder / "ball.gltf");
  ASSERT_NE(text.find("\"ball.bin\""), std::string::npos);
  text.replace(text.find("\"ball.bin\""), 10, "\"my%20ball%2.bin\"");
  std::filesystem::rename(folder / "ball.bin", folder / "my ball%2.bin");
  for (const char* mark : {"", "\xef\xbb\xbf"}) {
    test::write_bytes(folder / "ball.gltf", mark + text);
    EXPECT_EQ(refusal(folder / "ball.gltf"), "");
  }
}

TEST(Assimp, DamagedFilesAreRefusedByName) {
  const test::TemporaryFolder folder;
  const std::string whole = export_ball("glb2", folder / "whole.glb");
  for (std::size_t length = 0; length < whole.size() - 100; length += 97) {
    test::write_bytes(folder / "cut.glb", whole.substr(0, length));
    EXPECT_THROW((void)read_mesh(folder / "cut.glb"), Error) << length;
  }
}

}  // namespace
}  // namespace hapticut::assimp_test
