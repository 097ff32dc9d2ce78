// SPDX-License-Identifier: Apache-2.0
#include "hapticut/sound/loop_listener.hpp"

#include <gtest/gtest.h>

#include "hapticut/core/errors.hpp"
#include "support/scripted_loop.hpp"

namespace hapticut::loop_listener_test {
namespace {

TEST(LoopListener, HearsThePowerBetweenTwoSnapshots) {
  LoopListener listener(1000);
  LoopSnapshot snapshot;
  snapshot.tick = 100;
  snapshot.tool.spindle_speed = 3000;
  SoundInput input = listener.listen(snapshot);
  EXPECT_EQ(input.spindle_speed, 3000);
  EXPECT_EQ(input.power, 0);
  EXPECT_FALSE(input.touching);
  snapshot.tick = 116;
  snapshot.tool.dissipated = 0.032;
  snapshot.tool.removed_volume = 1.6e-11;
  snapshot.tool.contact_voxels = 3;
  for (int again = 0; again < 2; ++again) {
    input = listener.listen(snapshot);
    EXPECT_NEAR(input.power, 2, 1e-12);
    EXPECT_NEAR(input.removal_rate, 1e-9, 1e-20);
    EXPECT_TRUE(input.touching);
  }
  snapshot.tick = 10;  // another loop
  snapshot.tool = {};
  EXPECT_EQ(listener.listen(snapshot).power, 0);
  EXPECT_THROW(LoopListener(0), Error);
}

// The snapshot contains all values that the sound needs, also in a real cut.
TEST(LoopListener, HearsTheLedgerOfACutThroughSnapshotsAlone) {
  test::scripted_loop::ScriptedLoop scripted;
  LoopListener listener;
  double heard = 0, removed = 0;
  int touching = 0;
  constexpr int kTicks = 1600, kFrame = 16;  // a screen has 60 frames a second
  scripted.run(
      kTicks, test::scripted_loop::press(1e-3), [](int) {},
      [&](int n) {
        scripted.snapshot.tick = std::uint64_t(n + 1);
        if ((n + 1) % kFrame != 0) return;
        const SoundInput& input = listener.listen(scripted.snapshot);
        heard += input.power * kFrame / 1000;
        removed += input.removal_rate * kFrame / 1000;
        touching += input.touching ? 1 : 0;
      });
  const double spent = scripted.simulation.last_result().energy.losses();
  EXPECT_GT(spent, 1e-3);
  EXPECT_NEAR(heard / spent, 1, 1e-6);
  EXPECT_NEAR(removed / scripted.snapshot.tool.removed_volume, 1, 1e-6);
  EXPECT_GT(touching, 20);
}

}  // namespace
}  // namespace hapticut::loop_listener_test
