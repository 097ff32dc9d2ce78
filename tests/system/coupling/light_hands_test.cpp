// SPDX-License-Identifier: Apache-2.0
// A turning head in its own hole drags the tool round. The lightest hand for which the default gains are calm is that
// of docs/devices.md: device and hand together weigh 2 b_T T.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "hapticut/analysis/closed_loop.hpp"
#include "hapticut/loop/coupling_gains.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/tool/motors.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/coupling.hpp"

namespace hapticut::light_hands_test {
namespace {

using namespace test;
using namespace units;

/// [N] Mean change per tick of the force on a hand that has pressed a bur into its hole at 200 000 rpm. A hand does not
/// feel 0.02 N.
double unsteadiness(DeviceModel device, const ToolHead& head, const Material& material, double period) {
  const CouplingGains gains = coupling_gains(capabilities(device));
  ClosedLoopConfig config;
  config.hand = hand_model("light");
  config.hand.stiffness = 300;
  device.mass = std::max(device.mass, 2 * gains.damping * period) - config.hand.mass;
  config.device = device;
  config.period = period;
  config.saturation = true;
  config.velocity_filter = 100;
  const Tool tool(head, RayHandle{20 * mm}, common_spindle(200000 * rpm));
  Simulation simulation(build_block({Vec3(-2, -2, -7) * mm, Vec3(2, 2, 0) * mm}, 0.1 * mm, material), tool,
                        implicit(0, std::nullopt));
  VirtualCoupling coupling(simulation, gains);
  Pose hand = Pose::from_translation(Vec3(0.01, 0.02, 1.1) * mm) * tool.X_HT().inverse();
  ClosedLoop loop(config);
  loop.reset(hand);
  constexpr double kPress = 1, kRest = 1.2, kEnd = 1.8, kDepth = 6 * mm;  // [s], [m] times, depth of the set point
  std::vector<Vec3> forces;
  const double start = hand.translation.z();
  for (double t = 0; t < kEnd; t += period) {
    hand.translation.z() = start - std::min(1.0, t / kPress) * kDepth;
    loop.plant().set_target(hand);
    const DeviceState reading = loop.read();
    const CoupledResult& result = coupling.step(reading.X_BS, reading.velocity, period);
    loop.write({result.hand.force, Vec3::Zero()});
    if (t > kRest) forces.push_back(result.hand.force);
  }
  double changes = 0;
  for (std::size_t n = 1; n < forces.size(); ++n) changes += (forces[n] - forces[n - 1]).squaredNorm();
  EXPECT_GT(forces.back().norm(), 0.1);
  return std::sqrt(changes / double(forces.size() - 1));
}

TEST(LightHands, AreCalmWithTheDefaultGainsInAClosedHole) {
  struct Loop {
    const char* device;
    double period;  // [s]
  };
  for (const Loop& loop : {Loop{"touch", 1e-3}, Loop{"premium15", 1e-3}, Loop{"omega", 2e-3}, Loop{"omega", 0.5e-3}})
    for (const Material& material : {presets::trabecular_bone(), presets::enamel()})
      for (const ToolHead& head : {round_head(1.2 * mm), cylinder_head(1.2 * mm, 4 * mm)})
        EXPECT_LT(unsteadiness(device_model(loop.device), head, material, loop.period), 0.02)
            << loop.device << ", " << loop.period << " s, " << material.name;
}

}  // namespace
}  // namespace hapticut::light_hands_test
