// SPDX-License-Identifier: Apache-2.0
// Writes and reads through every library that hapticut::io uses: a missing dependency of the package would not link.
#include <hapticut/hapticut.hpp>
#include <hapticut/io/picture/picture.hpp>
#include <hapticut/io/recording/recorder.hpp>
#include <hapticut/io/recording/replay.hpp>
#include <hapticut/io/vdb/vdb.hpp>
#include <hapticut/surface/extract_surface.hpp>

using namespace hapticut;

bool use_io() {
  Material bone;
  bone.name = "bone";
  const Workpiece ball = build_sphere(Vec3::Zero(), 1e-3, 1e-4, bone);
  write_picture({colored(extract_surface(ball), ball.materials())}, PictureOptions{}, "consumer_ball.png");
  save_vdb(ball, "consumer_ball.vdb");
  if (load_vdb("consumer_ball.vdb").hash() != ball.hash()) return false;
  Simulation simulation(ball.clone(), Tool(SphereHead{1e-3}));
  Recorder recorder("consumer_ball.h5", simulation);
  recorder.step({Pose::from_translation(Vec3(0, 0, 1.5e-3)), {}, 1e-3});
  recorder.close();
  return replay(read_recording("consumer_ball.h5")).identical;
}
