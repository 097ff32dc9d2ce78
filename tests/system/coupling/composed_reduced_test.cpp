// SPDX-License-Identifier: Apache-2.0
// Faults that random ticks found, reduced to the shortest sequence.
#include <gtest/gtest.h>

#include <utility>

#include "support/coupling.hpp"
#include "support/scripted_loop.hpp"

namespace hapticut::composed_reduced_test {
namespace {

using namespace test;

// Near the axis a voxel slips with the mean slip of its section. A couple about the axis does the work of this slip,
// against the spin and against a hand that rotates the handpiece about the axis.
TEST(TwistedSpindle, LeavesTheLedgerClosed) {
  for (const double spin : {50.0, 500.0, 5000.0})
    for (const double twist : {0.0, 5.0, -5.0}) {
      Simulation simulation(half_space(), ball(spin), implicit(1e14));
      for (int n = 0; n < 200; ++n) {
        const Pose pose{rotation_from_vector({0, 0, twist * n * kTick}), kAside + Vec3(0, 0, kRadius - 1e-6 * n)};
        simulation.step(pose, {Vec3(0, 0, -1e-3), Vec3(0, 0, twist)}, kTick);
      }
      EXPECT_LT(test::unbooked(simulation.last_result().energy), 1e-5) << spin << ", twisted by " << twist;
    }
}

// The command to close the clutch comes in the middle of a cut, while the clutch is already closed.
TEST(ClosedClutch, CutsNothingInTheTickThatIsNotFelt) {
  scripted_loop::ScriptedLoop scripted(3000, true);
  double before = 0, unfelt = 0;
  scripted.run(
      900, scripted_loop::press(0.5e-3),
      [&](int n) {
        if (n == 600) {
          EXPECT_TRUE(scripted.tell(commands::CloseClutch{}));
        }
      },
      [&](int n) {
        const double removed = scripted.snapshot.tool.removed_volume;
        const double in_tick = removed - std::exchange(before, removed);
        if (n == 599) {
          EXPECT_GT(in_tick, 0);
        }
        if (n >= 600 && scripted.commanded.isZero(0)) unfelt += in_tick;
      });
  EXPECT_EQ(unfelt, 0);
}

}  // namespace
}  // namespace hapticut::composed_reduced_test
