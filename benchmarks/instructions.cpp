// SPDX-License-Identifier: Apache-2.0
// A fixed number of steps of one workload, whose instructions are counted: `bench_instructions WORKLOAD KERNELS`.
// KERNELS: baseline, which every processor supports, so that the count is equal on all; or avx2.
#include <hwy/targets.h>

#include <cstdio>
#include <cstring>

#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "support/scenes.hpp"
#include "workloads.hpp"

namespace {

using namespace hapticut;

constexpr int kSteps = 200;

/// A ball completely inside a block. Returns the sum of the forces along x [N].
double buried_ball(RemovalLaw removal, double spin) {
  Material material;
  material.name = "bone";
  SimulationConfig config;
  config.removal = removal;
  config.friction = DryFriction{0, 0, 1};
  const bench::Workload w3{bench::Path::w3, 0.1e-3, 1e-3};
  Simulation simulation(
      build_block({Vec3(16, 16, 6) * units::mm, Vec3(24, 24, 14) * units::mm}, w3.voxel_size, material),
      Tool(SphereHead{w3.radius}, RayHandle{0}, Spindle{spin * units::rad_per_s}), config);
  double sum = 0;
  for (int t = 0; t < kSteps; ++t)
    sum += simulation.step(Pose::from_translation(w3.center(t)), {}, bench::kTick).force.x();
  return sum;
}

double scene(const char* name) {
  const test::Scene& scene = test::find_scene(name);
  Simulation simulation = scene.make();
  double sum = 0;
  for (int t = 0; t < kSteps; ++t) {
    const StepInput input = scene.input(t);
    sum += simulation.step(input.X_WH, input.V_WH, input.dt).force.z();
  }
  return sum;
}

}  // namespace

int main(int argc, char** argv) {
  const char* name = argc > 1 ? argv[1] : "";
  const bool avx2 = argc > 2 && std::strcmp(argv[2], "avx2") == 0;
  if (avx2 && (hwy::SupportedTargets() & HWY_AVX2) == 0) {
    std::puts("SKIPPED: this processor has no AVX2");
    return 0;
  }
  hwy::DisableTargets(~std::int64_t(HWY_STATIC_TARGET | (avx2 ? HWY_AVX2 : 0)));
  double sum = 0;
  if (std::strcmp(name, "static") == 0)
    sum = buried_ball(RemovalLaw::none, 0);
  else if (std::strcmp(name, "cutting") == 0)
    sum = buried_ball(RemovalLaw::constant_energy, 3000);
  else if (std::strcmp(name, "scene") == 0)
    sum = scene("deep_ball");
  else {
    std::fprintf(stderr, "usage: bench_instructions static|cutting|scene baseline|avx2\n");
    return 2;
  }
  std::printf("%.17g\n", sum);
  return 0;
}
