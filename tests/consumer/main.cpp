// SPDX-License-Identifier: Apache-2.0
// An outside program: presses a sphere that does not rotate into a block, and prints the force in hexadecimal, without
// rounding.
#include <cmath>
#include <cstdio>
#include <hapticut/hapticut.hpp>
#include <hapticut/version.hpp>

#ifdef COMPONENT
bool COMPONENT();  // defined in another file; returns whether the component works
#endif

int main() {
  using namespace hapticut;
#ifdef COMPONENT
  if (!COMPONENT()) return 3;
#endif
  constexpr double kRadius = 1e-3, kDepth = 0.6e-3;  // [m]
  Material bone;
  bone.name = "bone";
  SimulationConfig config;
  config.reference_stiffness = 1e12;
  Simulation simulation(build_block({Vec3(-2e-3, -2e-3, -2e-3), Vec3(2e-3, 2e-3, 0)}, 5e-5, bone),
                        Tool(SphereHead{kRadius}), config);
  const Vec3 force = simulation.step(Pose::from_translation(Vec3(0, 0, kRadius - kDepth)), Twist{}, 1e-3).force;

  // Closed form of a sphere pressed into a half space: k_v (pi/12) d^3 (4 R - 3 d).
  const double exact =
      config.reference_stiffness * units::kPi / 12 * kDepth * kDepth * kDepth * (4 * kRadius - 3 * kDepth);
  std::printf("%a %a %a\n", force.x(), force.y(), force.z());
  if (build_info().version != HAPTICUT_VERSION) return 2;
  return std::abs(force.z() / exact - 1) < 0.01 ? 0 : 1;  // 1 %: the voxel is a twelfth of the depth
}
