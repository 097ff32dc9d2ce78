// SPDX-License-Identifier: Apache-2.0
// Start and end of a loop.
#include <string>
#include <string_view>
#include <utility>

#include "c/loop_object.hpp"
#include "c/structs.hpp"
#include "c/words_of_c.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/loop/coupling_gains.hpp"
#include "loop/hand_map.hpp"

namespace hapticut::c {
namespace {

void require_choice(const char* name, std::uint32_t value, std::uint32_t max) {
  if (value > max)
    throw Refusal(HAPTICUT_ERROR_ARGUMENT,
                  std::string(name) + " = " + std::to_string(value) + "; it must be 0 to " + std::to_string(max) + ".");
}

void require_choices(const hapticut_loop_options& o) {
  require_choice("coupling", o.coupling, HAPTICUT_COUPLING_NEVER);
  require_choice("up", o.up, HAPTICUT_UP_Z);
  require_choice("has_X_WB", o.has_X_WB, 1);
  require_choice("simulated_time", o.simulated_time, 1);
  require_choice("ordinary_priority", o.ordinary_priority, 1);
  require_choice("lock_memory", o.lock_memory, 1);
  require_choice("stop_on_signals", o.stop_on_signals, 1);
  require_choice("stop_on_crash", o.stop_on_crash, 1);
}

/// The gains at the device.
CouplingGains gains_of(const hapticut_loop_options& o, const DeviceCapabilities& device) {
  if (o.stiffness == 0) return coupling_gains(device);
  DeviceCapabilities as_told = device;
  as_told.stiffness = o.stiffness;
  return coupling_gains(as_told);
}

SimulationModelOptions model_of(const hapticut_loop_options& o, const SimulationObject& simulation,
                                const DeviceCapabilities& device) {
  const bool coupled =
      o.coupling == HAPTICUT_COUPLING_ALWAYS || (o.coupling == HAPTICUT_COUPLING_BY_DEVICE && device.stiffness > 0);
  if (coupled && simulation.simulation.config().contact_time != ContactTime::end)
    throw Error(
        "The loop needs a coupling, but the simulation was made without one; make it with "
        "hapticut_simulation_options.for_coupling = 1.");
  SimulationModelOptions options;
  options.map = map_above(device, simulation.box, simulation.simulation.tool(), o.up == HAPTICUT_UP_Z ? Up::z : Up::y,
                          o.scale != 0 ? o.scale : 1.0);
  if (o.has_X_WB == 1) {
    options.map.X_WB = pose_of(o.X_WB);
    if (!options.map.orientation) options.map.X_SH.rotation = options.map.X_WB.rotation.transpose();
  }
  if (coupled) options.coupling = gains_of(o, device);
  return options;
}

RealtimeLoopOptions loop_of(const hapticut_loop_options& o, double rate) {
  RealtimeLoopOptions options;
  options.run.seconds = o.seconds;
  options.run.simulated_time = o.simulated_time == 1;
  options.run.stop_on_signals = o.stop_on_signals == 1;
  options.run.stop_on_crash = o.stop_on_crash == 1;
  if (o.ordinary_priority == 1) options.run.realtime.priority = 0;
  options.run.realtime.lock_memory = o.lock_memory == 1;
  options.run.guard.period = 1 / rate;
  require_fields_within(options.run, "RunOptions::");
  return options;
}

/// Claims simulation and device for a loop. Releases them again if the loop cannot start.
class Claim {
 public:
  Claim(std::atomic<bool>& simulation, std::atomic<bool>& device) : simulation_(simulation), device_(device) {
    simulation_.store(true);
    device_.store(true);
  }
  ~Claim() {
    if (kept_) return;
    simulation_.store(false);
    device_.store(false);
  }
  Claim(const Claim&) = delete;
  Claim& operator=(const Claim&) = delete;
  void keep() noexcept { kept_ = true; }

 private:
  std::atomic<bool>&simulation_, &device_;
  bool kept_ = false;
};

void put_report(const RunReport& report, hapticut_loop_report& own) {
  own.fault = std::uint32_t(report.fault);
  own.ticks = report.ticks;
  own.missed = report.missed;
  own.compute_p99 = report.compute.quantile(0.99);
  own.compute_max = report.compute.max();
  own.wake_up_p99 = report.wake_up.quantile(0.99);
  own.wake_up_max = report.wake_up.max();
  own.arming = std::uint32_t(report.arming);
  copy_text(report.end, own.end, sizeof own.end);
  std::string warnings;
  for (const std::string& one : report.warnings) {
    if (!warnings.empty()) warnings += '\n';
    warnings += one;
  }
  copy_text(warnings, own.warnings, sizeof own.warnings);
}

}  // namespace

LoopObject::LoopObject(std::shared_ptr<SimulationObject> a_simulation, std::shared_ptr<DeviceObject> a_device,
                       const SimulationModelOptions& model_options, const RealtimeLoopOptions& options)
    : simulation(std::move(a_simulation)),
      device(std::move(a_device)),
      model(simulation->simulation, *device->device, model_options),
      removing(model, *simulation),
      loop(*device->device, removing, options),
      listener(simulation->rate) {
  loop.start();
}

LoopObject::~LoopObject() {
  try {
    stop();
  } catch (...) {  // a destructor cannot report it
  }
}

void LoopObject::stop() {
  if (!running.load()) return;
  try {
    report = loop.stop();
  } catch (...) {
    running.store(false);
    release_objects();
    throw;
  }
  running.store(false);
  release_objects();
}

void LoopObject::release_objects() noexcept {
  simulation->sweep();  // no other thread works while `driven` is set
  device->driven.store(false, std::memory_order_release);
  simulation->driven.store(false, std::memory_order_release);
}

}  // namespace hapticut::c

using namespace hapticut;
using namespace hapticut::c;

extern "C" {

int hapticut_loop_start(hapticut_simulation simulation, hapticut_device device, const hapticut_loop_options* options,
                        hapticut_loop* loop) {
  return guarded([&]() -> int {
    require_argument(loop, "loop");
    hapticut_loop_options own;
    if (const int code = read_struct_if_given(options, "options", own); code != HAPTICUT_OK) return code;
    require_choices(own);
    const IdleSimulation idle(simulation);
    if (!idle) return idle.code();
    const Use<DeviceObject> hand(device);
    if (!hand) return hand.code();
    if (hand->driven.load())
      return fail(HAPTICUT_ERROR_BUSY, "Another loop drives this device; call hapticut_loop_stop first.");
    idle.pointer()->sweep();
    Claim claim(idle->driven, hand->driven);
    const std::shared_ptr<LoopObject> object = std::make_shared<LoopObject>(
        idle.pointer(), hand.pointer(), model_of(own, *idle.pointer(), hand->device->capabilities()),
        loop_of(own, idle->rate));
    claim.keep();
    *loop = add_object(Kind::loop, object);
    return HAPTICUT_OK;
  });
}

int hapticut_loop_is_running(hapticut_loop loop, int* running) {
  if (running == nullptr) return fail(HAPTICUT_ERROR_ARGUMENT, "running is a null pointer; it must not be null.");
  int code = HAPTICUT_OK;
  const std::shared_ptr<Object>* pinned = pin_slot(loop, Kind::loop, code);
  if (pinned == nullptr) return code;
  *running = static_cast<LoopObject*>(pinned->get())->loop.is_running() ? 1 : 0;
  unpin_slot(loop);
  return HAPTICUT_OK;
}

int hapticut_loop_stop(hapticut_loop loop, hapticut_loop_report* report) {
  return guarded([&]() -> int {
    if (const int code = check_size_if_given(report, "report"); code != HAPTICUT_OK) return code;
    const Use<LoopObject> use(loop);
    if (!use) return use.code();
    const bool was_stopped = !use->running.load();
    use->stop();
    if (report != nullptr) {
      hapticut_loop_report own{};
      put_report(use->report, own);
      write_struct(own, report);
    }
    return was_stopped ? HAPTICUT_NOTHING : HAPTICUT_OK;
  });
}

}  // extern "C"
