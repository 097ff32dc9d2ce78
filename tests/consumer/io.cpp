// SPDX-License-Identifier: Apache-2.0
// Writes and reads through every library that hapticut::io stands on: what its package leaves out does not link.
#include <hapticut/hapticut.hpp>
#include <hapticut/io/mesh/meshes.hpp>
#include <hapticut/io/picture/picture.hpp>
#include <hapticut/io/recording/recorder.hpp>
#include <hapticut/io/recording/replay.hpp>
#include <hapticut/io/volume/volumes.hpp>

bool use_io() {
  using namespace hapticut;
  Material bone;
  bone.name = "bone";
  const Workpiece ball = build_sphere(Vec3::Zero(), 1e-3, 1e-4, bone);
  const WorkpieceSurface surface = extract_surface(ball);
  write_stl(surface.mesh, "consumer_ball.stl");
  write_picture({colored(surface, ball.materials())}, PictureOptions{}, "consumer_ball.png");
  write_nrrd("consumer_ball.nrrd", ball);
  Simulation simulation(ball.clone(), Tool(SphereHead{1e-3}));
  Recorder recorder("consumer_ball.h5", simulation);
  recorder.step({Pose::from_translation(Vec3(0, 0, 1.5e-3)), {}, 1e-3});
  recorder.close();
  if (!replay(read_recording("consumer_ball.h5")).identical) return false;
  return !read_mesh("consumer_ball.stl").empty() && read_label_volume("consumer_ball.nrrd").dims[0] >= 20;
}
