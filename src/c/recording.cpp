// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "c/device_object.hpp"
#include "c/simulation_object.hpp"
#include "c/structs.hpp"
#include "hapticut/core/errors.hpp"
#ifdef HAPTICUT_HAS_IO
#include "hapticut/io/recording/recorder.hpp"
#endif

namespace hapticut::c {
namespace {

#ifdef HAPTICUT_HAS_IO
/// A recorder with the device that it records.
struct RecorderWithDevice {
  RecorderWithDevice(std::shared_ptr<DeviceObject> a_device, SimulationObject& simulation, const std::string& path,
                     const RecorderOptions& options)
      : device(std::move(a_device)), recorder(path, simulation.simulation, options) {}
  std::shared_ptr<DeviceObject> device;  // or null
  Recorder recorder;
};

class RecordingObject final : public Object {
 public:
  static constexpr Kind kKind = Kind::recording;
  RecordingObject(std::shared_ptr<SimulationObject> a_simulation, std::shared_ptr<RecorderWithDevice> a_recorder)
      : simulation(std::move(a_simulation)), active(std::move(a_recorder)) {}
  ~RecordingObject() override {
    SimulationObject& owner = *simulation;
    if (active) owner.retire(std::move(active));
  }

  const std::shared_ptr<SimulationObject> simulation;
  std::shared_ptr<RecorderWithDevice> active;  // until the recording is stopped
  hapticut_recording_report report{};
};
#else
class RecordingObject final : public Object {
 public:
  static constexpr Kind kKind = Kind::recording;
};
#endif

}  // namespace
}  // namespace hapticut::c

using namespace hapticut;
using namespace hapticut::c;

extern "C" {

int hapticut_recording_start(hapticut_simulation simulation, hapticut_device device, const char* path,
                             hapticut_recording* recording) {
  return within(IdleSimulation(simulation), [&]([[maybe_unused]] const auto& use) -> int {
    require_argument(path, "path");
    require_argument(recording, "recording");
    std::shared_ptr<DeviceObject> hand;
    if (device != 0) {
      const Use<DeviceObject> held(device);
      if (!held) return held.code();
      hand = held.pointer();
    }
#ifdef HAPTICUT_HAS_IO
    use.pointer()->sweep();
    RecorderOptions options;
    options.driven_by = hand ? hand->device.get() : nullptr;
    options.wait_when_full = hand == nullptr;
    auto active = std::make_shared<RecorderWithDevice>(hand, *use.pointer(), path, options);
    *recording = add_object(Kind::recording, std::make_shared<RecordingObject>(use.pointer(), std::move(active)));
    return HAPTICUT_OK;
#else
    throw Error(
        "cannot write the recording '" + std::string(path) +
        "', because this library was built without hapticut's component io. Build it with HAPTICUT_WITH_IO=ON.");
#endif
  });
}

int hapticut_recording_stop(hapticut_recording recording, hapticut_recording_report* report) {
  return guarded([&]() -> int {
    if (const int code = check_size_if_given(report, "report"); code != HAPTICUT_OK) return code;
    const Use<RecordingObject> use(recording);
    if (!use) return use.code();
#ifdef HAPTICUT_HAS_IO
    if (!use->active) {
      if (report != nullptr) write_struct(use->report, report);
      return HAPTICUT_NOTHING;
    }
    const IdleStay stay(*use->simulation);
    if (!stay) return stay.code();
    const std::shared_ptr<RecorderWithDevice> ended = std::move(use->active);
    use->active = nullptr;
    const int code = guarded([&] {
      ended->recorder.close();
      return int(HAPTICUT_OK);
    });
    use->report.recorded = ended->recorder.recorded();
    use->report.lost = ended->recorder.lost();
    if (report != nullptr) write_struct(use->report, report);
    return code;
#else
    return HAPTICUT_OK;
#endif
  });
}

}  // extern "C"
