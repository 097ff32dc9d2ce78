// SPDX-License-Identifier: Apache-2.0
// Writes and reads through every library that hapticut::import uses: a missing dependency of the package would not
// link. With WITHOUT_ITK or WITHOUT_ASSIMP hapticut::import lacks that part: everything else works, and functions that
// need it throw.
#include <fstream>
#include <hapticut/hapticut.hpp>
#include <hapticut/import.hpp>
#include <hapticut/tool/mesh_of_revolution.hpp>
#include <string>

namespace {

using namespace hapticut;

[[maybe_unused]] bool fails_with(const std::string& part, void (*use)()) {
  try {
    use();
  } catch (const Error& error) {
    return std::string(error.what()).find(part) != std::string::npos;
  }
  return false;
}

/// A volume in a format that does not need ITK.
bool reads_meta_image() {
  std::ofstream("consumer.mhd") << "NDims = 3\nDimSize = 2 2 2\nElementSpacing = 1 1 1\nElementType = "
                                   "MET_UCHAR\nElementDataFile = consumer.raw\n";
  std::ofstream("consumer.raw") << "01234567";
  return read_grey_volume("consumer.mhd").values.back() == '7';
}

bool itk_works() {
#ifdef WITHOUT_ITK
  return fails_with("HAPTICUT_WITH_ITK=ON", [] { (void)resample(read_grey_volume("consumer.mhd"), 1e-3); }) &&
         fails_with("libinsighttoolkit5-dev", [] { (void)resample(read_grey_volume("consumer.mhd"), 1e-3); });
#else
  return resample(read_grey_volume("consumer.mhd"), 0.5e-3).dims[0] > 2;
#endif
}

bool assimp_works() {
  std::ofstream("consumer.glb") << "glTF";
#ifdef WITHOUT_ASSIMP
  return fails_with("HAPTICUT_WITH_ASSIMP=ON", [] { (void)read_mesh("consumer.glb"); });
#else
  return fails_with("consumer.glb", [] { (void)read_mesh("consumer.glb"); });  // it is no glTF
#endif
}

}  // namespace

bool use_import() {
  const Profile cylinder = round_end_cylinder_head(1e-3, 4e-3).profile();
  const TriangleMesh mesh = mesh_of_revolution(cylinder, 60);
  write_stl(mesh, "consumer_bur.stl");
  write_ply(mesh, "consumer_bur.ply");
  write_obj(mesh, "consumer_bur.obj");
  for (const char* file : {"consumer_bur.stl", "consumer_bur.ply", "consumer_bur.obj"})
    if (read_mesh(file).at(0).mesh.triangles.size() != mesh.triangles.size()) return false;
  if (profile_from_mesh(mesh).deviation > 1e-4) return false;
  Material bone;
  bone.name = "bone";
  write_nrrd(build_sphere(Vec3::Zero(), 1e-3, 1e-4, bone), "consumer_ball.nrrd");
  return reads_meta_image() && read_label_volume("consumer_ball.nrrd").dims[0] >= 20 && itk_works() && assimp_works();
}
