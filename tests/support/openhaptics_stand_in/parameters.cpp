// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "stand_in.hpp"

namespace hdsim {
namespace {

enum class Type { boolean, integer, real, longer, text };

struct Parameter {
  int count;
  Type type;
};

/// Width and type of everything that can be read; count 0: unknown.
Parameter describe(HDenum name) {
  switch (name) {
    case HD_CURRENT_BUTTONS:
    case HD_LAST_BUTTONS:
    case HD_INPUT_DOF:
    case HD_OUTPUT_DOF:
    case HD_CALIBRATION_STYLE:
    case HD_UPDATE_RATE:
    case HD_INSTANTANEOUS_UPDATE_RATE:
    case HD_USER_STATUS_LIGHT:
      return {1, Type::integer};
    case HD_CURRENT_SAFETY_SWITCH:
    case HD_LAST_SAFETY_SWITCH:
    case HD_CURRENT_INKWELL_SWITCH:
    case HD_LAST_INKWELL_SWITCH:
      return {1, Type::boolean};
    case HD_CURRENT_ENCODER_VALUES:
    case HD_LAST_ENCODER_VALUES:
      return {6, Type::longer};
    case HD_CURRENT_TRANSFORM:
    case HD_LAST_TRANSFORM:
      return {16, Type::real};
    case HD_MAX_WORKSPACE_DIMENSIONS:
    case HD_USABLE_WORKSPACE_DIMENSIONS:
    case HD_MOTOR_TEMPERATURE:
      return {6, Type::real};
    case HD_CURRENT_POSITION:
    case HD_LAST_POSITION:
    case HD_CURRENT_VELOCITY:
    case HD_LAST_VELOCITY:
    case HD_CURRENT_ANGULAR_VELOCITY:
    case HD_LAST_ANGULAR_VELOCITY:
    case HD_CURRENT_JOINT_ANGLES:
    case HD_LAST_JOINT_ANGLES:
    case HD_CURRENT_GIMBAL_ANGLES:
    case HD_LAST_GIMBAL_ANGLES:
    case HD_CURRENT_FORCE:
    case HD_LAST_FORCE:
    case HD_CURRENT_TORQUE:
    case HD_LAST_TORQUE:
    case HD_CURRENT_JOINT_TORQUE:
    case HD_CURRENT_GIMBAL_TORQUE:
      return {3, Type::real};
    case HD_NOMINAL_MAX_STIFFNESS:
    case HD_NOMINAL_MAX_DAMPING:
    case HD_NOMINAL_MAX_FORCE:
    case HD_NOMINAL_MAX_CONTINUOUS_FORCE:
    case HD_NOMINAL_MAX_TORQUE_STIFFNESS:
    case HD_NOMINAL_MAX_TORQUE_DAMPING:
    case HD_NOMINAL_MAX_TORQUE_FORCE:
    case HD_NOMINAL_MAX_TORQUE_CONTINUOUS_FORCE:
    case HD_SOFTWARE_VELOCITY_LIMIT:
    case HD_SOFTWARE_FORCE_IMPULSE_LIMIT:
    case HD_FORCE_RAMPING_RATE:
    case HD_TABLETOP_OFFSET:
      return {1, Type::real};
    case HD_VERSION:
    case HD_DEVICE_MODEL_TYPE:
    case HD_DEVICE_DRIVER_VERSION:
    case HD_DEVICE_VENDOR:
    case HD_DEVICE_SERIAL_NUMBER:
    case HD_DEVICE_FIRMWARE_VERSION:
      return {1, Type::text};
    default:
      return {0, Type::text};
  }
}

std::array<double, 16> value_of(Device& device, HDenum name) {
  std::array<double, 16> v{};
  const auto put = [&](const auto& source) { std::copy(source.begin(), source.end(), v.begin()); };
  const auto position = [&](const Reading& r) {
    std::copy(r.transform.begin() + 12, r.transform.begin() + 15, v.begin());
  };
  switch (name) {
    case HD_CURRENT_TRANSFORM:
      put(device.current.transform);
      break;
    case HD_LAST_TRANSFORM:
      put(device.last.transform);
      break;
    case HD_CURRENT_POSITION:
      position(device.current);
      break;
    case HD_LAST_POSITION:
      position(device.last);
      break;
    case HD_CURRENT_VELOCITY:
      put(device.current.velocity);
      break;
    case HD_LAST_VELOCITY:
      put(device.last.velocity);
      break;
    case HD_CURRENT_BUTTONS:
      v[0] = device.current.buttons;
      break;
    case HD_LAST_BUTTONS:
      v[0] = device.last.buttons;
      break;
    case HD_CURRENT_FORCE:
      put(device.frame_depth > 0 ? device.set.force : device.committed.force);
      break;
    case HD_CURRENT_TORQUE:
      put(device.frame_depth > 0 ? device.set.torque : device.committed.torque);
      break;
    case HD_LAST_FORCE:
      put(device.frame_depth > 0 ? device.committed.force : device.previous.force);
      break;
    case HD_LAST_TORQUE:
      put(device.frame_depth > 0 ? device.committed.torque : device.previous.torque);
      break;
    case HD_INPUT_DOF:
      v[0] = device.spec.input_dof;
      break;
    case HD_OUTPUT_DOF:
      v[0] = device.spec.output_dof;
      break;
    case HD_CALIBRATION_STYLE:
      v[0] = device.spec.calibration_style;
      break;
    case HD_UPDATE_RATE:
    case HD_INSTANTANEOUS_UPDATE_RATE:
      v[0] = simulation().rate;
      break;
    case HD_NOMINAL_MAX_STIFFNESS:
      v[0] = device.spec.stiffness;
      break;
    case HD_NOMINAL_MAX_DAMPING:
      v[0] = 0.004;
      break;
    case HD_NOMINAL_MAX_FORCE:
      v[0] = device.spec.force;
      break;
    case HD_NOMINAL_MAX_CONTINUOUS_FORCE:
      v[0] = device.spec.continuous;
      break;
    case HD_NOMINAL_MAX_TORQUE_FORCE:
      v[0] = device.spec.torque_force;
      break;
    case HD_NOMINAL_MAX_TORQUE_CONTINUOUS_FORCE:
      v[0] = device.spec.torque_continuous;
      break;
    case HD_NOMINAL_MAX_TORQUE_STIFFNESS:
      v[0] = device.spec.torque_stiffness;
      break;
    case HD_MOTOR_TEMPERATURE:
      std::fill_n(v.begin(), device.spec.output_dof, device.temperature);
      break;
    case HD_MAX_WORKSPACE_DIMENSIONS:
    case HD_USABLE_WORKSPACE_DIMENSIONS:
      std::copy_n(device.spec.workspace, 6, v.begin());
      break;
    case HD_SOFTWARE_VELOCITY_LIMIT:
      v[0] = device.velocity_limit;
      break;
    case HD_SOFTWARE_FORCE_IMPULSE_LIMIT:
      v[0] = device.impulse_limit;
      break;
    case HD_FORCE_RAMPING_RATE:
      v[0] = device.ramping_rate;
      break;
    default:
      break;
  }
  return v;
}

template <typename T>
void get(HDenum name, T* out, std::initializer_list<Type> allowed) {
  const std::lock_guard lock(simulation().mutex);
  const Parameter parameter = describe(name);
  if (parameter.count == 0) return push(HD_INVALID_ENUM);
  if (std::find(allowed.begin(), allowed.end(), parameter.type) == allowed.end()) return push(HD_INVALID_INPUT_TYPE);
  Device* device = needed();
  if (device == nullptr) return;
  if (simulation().running && device->frame_depth == 0) ++device->counters.gets_outside_frame;
  const auto values = value_of(*device, name);
  const int count = name == HD_MOTOR_TEMPERATURE ? device->spec.output_dof : parameter.count;
  for (int n = 0; n < count; ++n) out[n] = T(values[std::size_t(n)]);
}

/// A motor command or a limit.
template <typename T>
void set(HDenum name, const T* values) {
  const std::lock_guard lock(simulation().mutex);
  Device* device = needed();
  if (device == nullptr) return;
  const auto limit = [&](double& value) { value = double(values[0]); };
  switch (name) {
    case HD_SOFTWARE_VELOCITY_LIMIT:
      return limit(device->velocity_limit);
    case HD_SOFTWARE_FORCE_IMPULSE_LIMIT:
      return limit(device->impulse_limit);
    case HD_FORCE_RAMPING_RATE:
      return limit(device->ramping_rate);
    case HD_CURRENT_FORCE:
    case HD_CURRENT_TORQUE:
    case HD_CURRENT_JOINT_TORQUE:
    case HD_CURRENT_GIMBAL_TORQUE:
      break;
    default:
      return push(describe(name).count == 0 ? HD_INVALID_ENUM : HD_INVALID_OPERATION);
  }
  if (device->frame_depth == 0) {
    ++device->counters.sets_outside_frame;
    return push(HD_FRAME_ERROR, 0, simulation().current);
  }
  if (name == HD_CURRENT_JOINT_TORQUE || name == HD_CURRENT_GIMBAL_TORQUE) {
    ++device->counters.joint_space_sets;
    return;
  }
  if (name == HD_CURRENT_TORQUE && device->spec.output_dof < 6) {
    ++device->counters.torque_sets_on_3dof;
    return;
  }
  Vec& target = name == HD_CURRENT_FORCE ? device->set.force : device->set.torque;
  for (std::size_t n = 0; n < 3; ++n) target[n] = double(values[n]);
}

}  // namespace
}  // namespace hdsim

using hdsim::Device;
using hdsim::simulation;

extern "C" {

void hdGetBooleanv(HDenum name, HDboolean* out) { hdsim::get(name, out, {hdsim::Type::boolean}); }
void hdGetIntegerv(HDenum name, HDint* out) { hdsim::get(name, out, {hdsim::Type::integer}); }
void hdGetFloatv(HDenum name, HDfloat* out) { hdsim::get(name, out, {hdsim::Type::real}); }
void hdGetDoublev(HDenum name, HDdouble* out) { hdsim::get(name, out, {hdsim::Type::real}); }
void hdGetLongv(HDenum name, HDlong* out) { hdsim::get(name, out, {hdsim::Type::longer}); }

HDstring hdGetString(HDenum name) {
  const std::lock_guard lock(simulation().mutex);
  const Device* device = hdsim::needed();
  if (hdsim::describe(name).type != hdsim::Type::text || hdsim::describe(name).count == 0) {
    hdsim::push(HD_INVALID_ENUM);
    return "";
  }
  if (device == nullptr) return "";
  switch (name) {
    case HD_DEVICE_MODEL_TYPE:
      return device->model.c_str();
    case HD_DEVICE_VENDOR:
      return "stand-in";
    case HD_DEVICE_SERIAL_NUMBER:
      return "0000";
    default:
      return "3.0 stand-in";
  }
}

void hdSetBooleanv(HDenum name, const HDboolean* values) { hdsim::set(name, values); }
void hdSetIntegerv(HDenum name, const HDint* values) { hdsim::set(name, values); }
void hdSetFloatv(HDenum name, const HDfloat* values) { hdsim::set(name, values); }
void hdSetDoublev(HDenum name, const HDdouble* values) { hdsim::set(name, values); }
void hdSetLongv(HDenum name, const HDlong* values) { hdsim::set(name, values); }
}
