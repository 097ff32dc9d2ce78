// SPDX-License-Identifier: Apache-2.0
// A loop on a mock device for bindings/csharp/tests/LivesOn.cs.
#include <memory>

#include "hapticut/device/device.hpp"
#include "hapticut/loop/realtime_loop.hpp"

namespace {

using namespace hapticut;

/// Alternates between no force and a push, so that the guard allows the force.
class PushingModel final : public LoopModel {
  Wrench step(const DeviceState& /*state*/, double /*dt*/, LoopSnapshot& /*snapshot*/) noexcept override {
    Wrench wrench;
    if (++ticks_ % 100 >= 20) wrench.force.x() = 1;
    return wrench;
  }
  int ticks_ = 0;
};

struct Running {
  explicit Running(bool stop_on_crash)
      : device(open_device("mock:rest")), loop(*device, model, options(stop_on_crash)) {
    loop.start();
  }
  static RealtimeLoopOptions options(bool stop_on_crash) {
    RealtimeLoopOptions options;
    options.run.stop_on_crash = stop_on_crash;
    options.run.realtime.priority = 0;
    options.run.realtime.lock_memory = false;
    options.run.guard.arming.ramp = options.run.guard.arming.short_ramp = 0.02;
    return options;
  }
  std::unique_ptr<Device> device;
  PushingModel model;
  RealtimeLoop loop;
};

std::unique_ptr<Running> running;

}  // namespace

extern "C" {

int loop_start(int stop_on_crash) {
  try {
    running = std::make_unique<Running>(stop_on_crash != 0);
    return 1;
  } catch (...) {
    return 0;
  }
}
unsigned long long loop_ticks() { return running->loop.latest().tick; }
int loop_has_force() { return running->device->output().applied.force.norm() > 0.5 ? 1 : 0; }
int loop_has_fault() { return running->loop.latest().arming == ArmingState::fault ? 1 : 0; }
void loop_reset_fault() { running->loop.requests().reset_fault(); }
void loop_stop() { running.reset(); }
}
