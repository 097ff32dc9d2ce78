// SPDX-License-Identifier: Apache-2.0
// Writes and reads through every library that hapticut::io uses: a missing dependency of the package would not link.
// With WITHOUT_ITK or WITHOUT_ASSIMP hapticut::io lacks that part: everything else works, and functions that need it
// throw.
#include <fstream>
#include <hapticut/hapticut.hpp>
#include <hapticut/io/mesh/meshes.hpp>
#include <hapticut/io/picture/picture.hpp>
#include <hapticut/io/recording/recorder.hpp>
#include <hapticut/io/recording/replay.hpp>
#include <hapticut/io/vdb/vdb.hpp>
#include <hapticut/io/volume/volume_filters.hpp>
#include <hapticut/io/volume/volumes.hpp>
#include <hapticut/surface/extract_surface.hpp>
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

bool use_io() {
  Material bone;
  bone.name = "bone";
  const Workpiece ball = build_sphere(Vec3::Zero(), 1e-3, 1e-4, bone);
  const WorkpieceSurface surface = extract_surface(ball);
  write_stl(surface.mesh, "consumer_ball.stl");
  write_ply(surface.mesh, "consumer_ball.ply");
  write_obj(surface.mesh, "consumer_ball.obj");
  for (const char* mesh : {"consumer_ball.stl", "consumer_ball.ply", "consumer_ball.obj"})
    if (read_mesh(mesh).at(0).mesh.triangles.size() != surface.mesh.triangles.size()) return false;
  write_picture({colored(surface, ball.materials())}, PictureOptions{}, "consumer_ball.png");
  write_nrrd(ball, "consumer_ball.nrrd");
  save_vdb(ball, "consumer_ball.vdb");
  if (load_vdb("consumer_ball.vdb").hash() != ball.hash()) return false;
  Simulation simulation(ball.clone(), Tool(SphereHead{1e-3}));
  Recorder recorder("consumer_ball.h5", simulation);
  recorder.step({Pose::from_translation(Vec3(0, 0, 1.5e-3)), {}, 1e-3});
  recorder.close();
  if (!replay(read_recording("consumer_ball.h5")).identical) return false;
  return reads_meta_image() && read_label_volume("consumer_ball.nrrd").dims[0] >= 20 && itk_works() && assimp_works();
}
