// SPDX-License-Identifier: Apache-2.0
#include "hapticut/analysis/pressed_ball.hpp"

#include <memory>
#include <utility>

#include "hapticut/workpiece/builders.hpp"

namespace hapticut {
namespace {

constexpr double kPressed = 5e-3;               // [m] target of the hand below the surface
constexpr double kAside[2] = {1.1e-5, 2.3e-5};  // [m] off the symmetry of the grid

/// The model and its coupling, at a fixed address.
struct BallOnGrid {
  BallOnGrid(const PressedBall& ball, double k_v)
      : simulation(material_below(ball), Tool(SphereHead{ball.radius}, RayHandle{0}), config_of(ball, k_v)) {
    if (ball.coupling) coupling.emplace(simulation, *ball.coupling);
  }

  static Workpiece material_below(const PressedBall& ball) {
    Material material;
    material.name = "pressed";
    const double half = 3 * ball.radius;
    return build_block({{-half, -half, -kPressed - 2 * ball.radius}, {half, half, 0}}, ball.voxel_size, material);
  }
  static SimulationConfig config_of(const PressedBall& ball, double k_v) {
    SimulationConfig config;
    config.reference_stiffness = k_v;
    if (ball.coupling) config.contact_time = ContactTime::end;
    return config;
  }

  Wrench feel(const DeviceState& state, double dt) noexcept {
    if (!state.valid) return {};
    if (coupling) return coupling->step(state.X_BS, state.velocity, dt).hand;
    const StepResult& result = simulation.step(state.X_BS, state.velocity, dt);
    return {result.force, result.torque};
  }

  Simulation simulation;
  std::optional<VirtualCoupling> coupling;
};

}  // namespace

ModelFactory contact_models(const PressedBall& ball) {
  return [ball](double k_v) -> ForceModel {
    const auto on_grid = std::make_shared<BallOnGrid>(ball, k_v);
    return [on_grid, last = -1e-3](const DeviceState& state) mutable {
      const double dt = state.time - std::exchange(last, state.time);
      return on_grid->feel(state, dt > 0 ? dt : 1e-3);
    };
  };
}

StabilitySearch pressed_search(const PressedBall& ball) {
  StabilitySearch search;
  search.start = Pose::from_translation({kAside[0], kAside[1], 1.2 * ball.radius});
  search.target = Pose::from_translation({kAside[0], kAside[1], ball.radius - kPressed});
  search.settle = 0.3;
  search.window = 0.2;
  search.low = 1e10;
  search.high = 1e18;
  search.coarse_factor = 3;
  search.tolerance = 0.02;
  search.forgotten = 1e-2;  // the model computes in single precision, which moves the ball by some 0.1 nm
  return search;
}

}  // namespace hapticut
