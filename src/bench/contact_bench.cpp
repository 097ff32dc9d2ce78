// SPDX-License-Identifier: Apache-2.0
#include "hapticut/bench/contact_bench.hpp"

#include <memory>
#include <utility>

#include "hapticut/workpiece/builders.hpp"

namespace hapticut {
namespace {

constexpr double kPressed = 5e-3;               // [m] that the hand wants to be below the surface
constexpr double kAside[2] = {1.1e-5, 2.3e-5};  // [m] off the symmetry of the grid

/// The model and its coupling, which keeps its address.
struct PressedBall {
  PressedBall(const ContactBench& bench, double k_v)
      : simulation(material_below(bench), Tool(SphereHead{bench.radius}, RayHandle{0}), config_of(bench, k_v)) {
    if (bench.coupling) coupling.emplace(simulation, *bench.coupling);
  }

  static Workpiece material_below(const ContactBench& bench) {
    Material material;
    material.name = "bench";
    const double half = 3 * bench.radius;
    return build_block({{-half, -half, -kPressed - 2 * bench.radius}, {half, half, 0}}, bench.voxel_size, material);
  }
  static SimulationConfig config_of(const ContactBench& bench, double k_v) {
    SimulationConfig config;
    config.reference_stiffness = k_v;
    if (bench.coupling) config.contact_time = ContactTime::end;
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

ModelFactory contact_models(const ContactBench& bench) {
  return [bench](double k_v) -> ForceModel {
    const auto ball = std::make_shared<PressedBall>(bench, k_v);
    return [ball, last = -1e-3](const DeviceState& state) mutable {
      const double dt = state.time - std::exchange(last, state.time);
      return ball->feel(state, dt > 0 ? dt : 1e-3);
    };
  };
}

StabilitySearch pressed_search(const ContactBench& bench) {
  StabilitySearch search;
  search.start = Pose::from_translation({kAside[0], kAside[1], 1.2 * bench.radius});
  search.target = Pose::from_translation({kAside[0], kAside[1], bench.radius - kPressed});
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
