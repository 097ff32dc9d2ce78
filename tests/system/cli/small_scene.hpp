// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "page/session/view_scenes.hpp"

/// @file
/// A scene for tests of `hapticut view` without a browser.
namespace hapticut::test {

/// A block of bone below z = 0, and a ball of 1 mm.
inline apps::ViewScene small_scene(const std::string& name) {
  using units::mm;
  SimulationConfig config;
  config.contact_time = ContactTime::end;
  const Box box{Vec3(-2, -2, -2) * mm, Vec3(2, 2, 0) * mm};
  return {name, build_block(box, 0.1 * mm, presets::cortical_bone()),
          Tool(SphereHead{0.5 * mm}, RayHandle{20 * mm}, Spindle{1000 * units::rad_per_s}), config, box};
}

}  // namespace hapticut::test
