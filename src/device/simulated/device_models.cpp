// SPDX-License-Identifier: Apache-2.0
#include "hapticut/device/simulated/device_models.hpp"

#include <array>
#include <string>

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

constexpr double kServoRate = 1000;  // [Hz]

// name, mass, damping, friction, encoder, peak force, continuous force, rendered stiffness and damping, gimbal:
// inertia, damping, peak torque, half width of the workspace, gimbal: continuous torque, peak torque about the stylus.
constexpr std::array<DeviceModel, 4> kDevices = {{
    {"touch", 0.045, 0.20, 0.13, 55e-6, 3.3, 0.88, 700, 4, 2e-5, 2e-4, 0, 0.08},
    {"premium15", 0.085, 0.05, 0.04, 30e-6, 8.5, 1.4, 800, 5, 2e-5, 2e-4, 0, 0.12},
    {"premium6dof", 0.136, 0.10, 0.04, 30e-6, 8.5, 1.4, 800, 5, 4e-5, 2e-4, 0.515, 0.12, 0.188, 0.170},
    {"omega", 0.25, 0.50, 0.10, 10e-6, 12, 12, 5000, 30, 2e-5, 2e-4, 0, 0.075},
}};

// name, mass, damping, stiffness, pad stiffness, pad damping, then inertia, damping and stiffness of the fingers about
// the gimbal.
constexpr std::array<HandModel, 7> kHands = {{
    {"released", 0, 0, 0, 0, 0, 0, 0, 0},
    {"light", 0.02, 1.5, 80, 0, 0, 2e-5, 2e-3, 0.1},
    {"nominal", 0.10, 4, 300, 0, 0, 4e-5, 3.8e-3, 0.3},
    {"firm", 0.20, 10, 800, 0, 0, 1e-4, 9.8e-3, 1.0},
    {"light-pad", 0.08, 2, 80, 600, 1.5, 2e-5, 2e-3, 0.1},
    {"nominal-pad", 0.15, 4, 200, 1500, 3, 4e-5, 3.8e-3, 0.3},
    {"firm-pad", 0.30, 10, 600, 4000, 8, 1e-4, 9.8e-3, 1.0},
}};

template <typename Models>
const auto& find(const Models& models, std::string_view name, const char* kind) {
  std::string names;
  for (const auto& model : models) {
    if (model.name == name) return model;
    names += (names.empty() ? "" : ", ") + std::string(model.name);
  }
  throw Error("There is no " + std::string(kind) + " model \"" + std::string(name) + "\"; choose one of " + names +
              ".");
}

}  // namespace

std::span<const DeviceModel> device_models() { return kDevices; }
const DeviceModel& device_model(std::string_view name) { return find(kDevices, name, "device"); }

std::span<const HandModel> hand_models() { return kHands; }
const HandModel& hand_model(std::string_view name) { return find(kHands, name, "hand"); }

DeviceCapabilities capabilities(const DeviceModel& model) {
  DeviceCapabilities c;
  c.model = std::string(model.name);
  c.vendor = "simulated";
  c.input_degrees_of_freedom = 6;
  c.output_degrees_of_freedom = model.peak_torque > 0 ? 6 : 3;
  c.peak_force = model.peak_force;
  c.continuous_force = model.continuous_force;
  c.peak_torque = model.peak_torque;
  c.continuous_torque = model.continuous_torque;
  c.stiffness = model.rendered_stiffness;
  c.rotational_stiffness = model.peak_torque > 0 ? 2 * model.rotational_damping * kServoRate : 0;
  c.damping = model.rendered_damping;
  c.position_resolution = model.encoder_step;
  c.workspace_low = Vec3::Constant(-model.workspace_half_width);
  c.workspace_high = Vec3::Constant(model.workspace_half_width);
  c.rate = kServoRate;
  c.simulated = true;
  return c;
}

}  // namespace hapticut
