// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "stand_in.hpp"

namespace hdsim {
namespace {

/// The value of a parameter that hdGetIntegerv or hdGetDoublev reads.
struct Parameter {
  int count = 0;  // 0: unknown
  bool whole = false;
  std::array<double, 16> values{};
};

Parameter several(const double* values, int count) {
  Parameter parameter{count};
  std::copy_n(values, count, parameter.values.begin());
  return parameter;
}

Parameter read(const Device& device, HDenum name) {
  const hdsim_device& spec = device.spec;
  switch (name) {
    case HD_CURRENT_TRANSFORM:
      return {16, false, device.current.transform};
    case HD_CURRENT_VELOCITY:
      return several(device.current.velocity.data(), 3);
    case HD_CURRENT_BUTTONS:
      return {1, true, {double(device.current.buttons)}};
    case HD_INPUT_DOF:
      return {1, true, {double(spec.input_dof)}};
    case HD_OUTPUT_DOF:
      return {1, true, {double(spec.output_dof)}};
    case HD_CALIBRATION_STYLE:
      return {1, true, {double(spec.calibration_style)}};
    case HD_UPDATE_RATE:
      return {1, true, {simulation().rate}};
    case HD_NOMINAL_MAX_STIFFNESS:
      return {1, false, {spec.stiffness}};
    case HD_NOMINAL_MAX_DAMPING:
      return {1, false, {0.004}};
    case HD_NOMINAL_MAX_FORCE:
      return {1, false, {spec.force}};
    case HD_NOMINAL_MAX_CONTINUOUS_FORCE:
      return {1, false, {spec.continuous}};
    case HD_NOMINAL_MAX_TORQUE_FORCE:
      return {1, false, {spec.torque_force}};
    case HD_NOMINAL_MAX_TORQUE_CONTINUOUS_FORCE:
      return {1, false, {spec.torque_continuous}};
    case HD_NOMINAL_MAX_TORQUE_STIFFNESS:
      return {1, false, {spec.torque_stiffness}};
    case HD_MOTOR_TEMPERATURE: {
      Parameter parameter{spec.output_dof};
      parameter.values.fill(device.temperature);
      return parameter;
    }
    case HD_MAX_WORKSPACE_DIMENSIONS:
      return several(spec.workspace, 6);
    case HD_SOFTWARE_FORCE_IMPULSE_LIMIT:
      return {1, false, {device.impulse_limit}};
    default:
      return {};
  }
}

template <typename T>
void get(HDenum name, T* out, bool whole) {
  const std::lock_guard lock(simulation().mutex);
  Device* device = needed();
  if (device == nullptr) return;
  const Parameter parameter = read(*device, name);
  if (parameter.count == 0) return push(HD_INVALID_ENUM);
  if (parameter.whole != whole) return push(HD_INVALID_INPUT_TYPE);
  if (simulation().running && device->frame_depth == 0) ++device->counters.gets_outside_frame;
  for (int n = 0; n < parameter.count; ++n) out[n] = T(parameter.values[std::size_t(n)]);
}

}  // namespace
}  // namespace hdsim

using hdsim::Device;
using hdsim::simulation;

extern "C" {

void hdGetIntegerv(HDenum name, HDint* out) { hdsim::get(name, out, true); }
void hdGetDoublev(HDenum name, HDdouble* out) { hdsim::get(name, out, false); }

HDstring hdGetString(HDenum name) {
  const std::lock_guard lock(simulation().mutex);
  const Device* device = hdsim::needed();
  if (device == nullptr) return "";
  switch (name) {
    case HD_DEVICE_MODEL_TYPE:
      return device->model.c_str();
    case HD_DEVICE_VENDOR:
      return "stand-in";
    case HD_DEVICE_SERIAL_NUMBER:
      return "0000";
    case HD_DEVICE_DRIVER_VERSION:
      return "3.0 stand-in";
    default:
      hdsim::push(HD_INVALID_ENUM);
      return "";
  }
}

void hdSetDoublev(HDenum name, const HDdouble* values) {
  const std::lock_guard lock(simulation().mutex);
  Device* device = hdsim::needed();
  if (device == nullptr) return;
  if (name == HD_SOFTWARE_FORCE_IMPULSE_LIMIT) {
    device->impulse_limit = values[0];
    return;
  }
  if (name != HD_CURRENT_FORCE && name != HD_CURRENT_TORQUE) return hdsim::push(HD_INVALID_ENUM);
  if (device->frame_depth == 0) {
    ++device->counters.sets_outside_frame;
    return hdsim::push(HD_FRAME_ERROR, 0, simulation().current);
  }
  if (name == HD_CURRENT_TORQUE && device->spec.output_dof < 6) {
    ++device->counters.torque_sets_on_3dof;
    return;
  }
  std::copy_n(values, 3, (name == HD_CURRENT_FORCE ? device->set.force : device->set.torque).begin());
}
}
