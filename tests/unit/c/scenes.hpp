// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "hapticut/c/hapticut.h"

namespace hapticut::c_test {

inline const std::string kScene = R"([workpiece]
source = "block"
size_mm = [6, 6, 3]
voxel_mm = 0.2
material = "cortical_bone"

[tool]
head = "sphere"
radius_mm = 1
handle = "ray"
handle_length_mm = 20
spindle_rpm = 40000
)";

inline const std::string kOtherTool = R"([tool]
head = "sphere"
radius_mm = 0.6
handle = "ray"
handle_length_mm = 20
spindle_rpm = 40000
)";

/// A struct of the interface with its `struct_size` set.
template <class S>
S sized() {
  S made{};
  made.struct_size = sizeof(S);
  return made;
}

/// Releases its handle in the destructor.
class Owned {
 public:
  explicit Owned(hapticut_handle handle = 0) : handle_(handle) {}
  ~Owned() {
    if (handle_ != 0) hapticut_release(handle_);
  }
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  [[nodiscard]] hapticut_handle get() const { return handle_; }
  hapticut_handle* to() { return &handle_; }
  int release() {
    const int code = hapticut_release(handle_);
    if (code == HAPTICUT_OK) handle_ = 0;
    return code;
  }

 private:
  hapticut_handle handle_;
};

/// Makes a simulation.  @return 0, and the test fails, if it cannot be made
inline hapticut_simulation simulation_of(const std::string& text = kScene, std::uint32_t for_coupling = 0,
                                         std::uint64_t undo_blocks = 0) {
  auto options = sized<hapticut_simulation_options>();
  options.for_coupling = for_coupling;
  options.undo_blocks = undo_blocks;
  hapticut_simulation simulation = 0;
  EXPECT_EQ(hapticut_simulation_from_toml(text.c_str(), &options, &simulation), HAPTICUT_OK) << hapticut_last_error();
  return simulation;
}

inline hapticut_device device_of(const char* name = "mock:spiral,hand=nominal") {
  hapticut_device device = 0;
  EXPECT_EQ(hapticut_device_open(name, &device), HAPTICUT_OK) << hapticut_last_error();
  return device;
}

/// A step input with the handle above the middle of the block's top, and the ball below the handle.
/// @param depth  [m] of the ball's lowest point below the top
inline hapticut_step_input above(double depth) {
  auto input = sized<hapticut_step_input>();
  for (const int n : {0, 4, 8}) input.X_WH.rotation[n] = 1;
  input.X_WH.position[0] = input.X_WH.position[1] = 3e-3;
  input.X_WH.position[2] = 3e-3 + 1e-3 + 20e-3 - depth;
  input.linear_velocity[2] = -2e-3;
  input.dt = 1e-3;
  return input;
}

/// Cuts for some steps at 2 mm/s, from the first contact on.
inline void cut(hapticut_simulation simulation, int steps) {
  auto result = sized<hapticut_step_result>();
  for (int n = 1; n <= steps; ++n) {
    const hapticut_step_input input = above(2e-6 * n);
    ASSERT_EQ(hapticut_step(simulation, &input, &result), HAPTICUT_OK) << hapticut_last_error();
  }
}

/// [m^3] The remaining volume of the first material.
inline double volume_of(hapticut_simulation simulation) {
  auto info = sized<hapticut_material_info>();
  EXPECT_EQ(hapticut_material(simulation, 1, &info), HAPTICUT_OK) << hapticut_last_error();
  return info.volume;
}

}  // namespace hapticut::c_test
