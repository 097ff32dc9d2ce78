// SPDX-License-Identifier: Apache-2.0
// The step against alternatives that a competent user would write: `step/<workload>/h<voxel mm>/R<radius
// mm>/<contestant>`. One iteration is one whole path; times are thread CPU time per tick. Run with
// --benchmark_enable_random_interleaving=true and several repetitions, and compare contestants of the same run only.
#include <benchmark/benchmark.h>

#include "contestants.hpp"
#include "hapticut/force/stiffness.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "kernel_choice.hpp"
#include "tick_times.hpp"

namespace hapticut::bench {
namespace {

/// hapticut as a contestant. `cutting`: the full model. Otherwise only the springs act, the spindle is at rest and no
/// voxel is removed.
class Hapticut final : public Contestant {
 public:
  Hapticut(const Workload& w, bool cutting) : simulation_(make(w, cutting)) {}

  TickResult tick(const Vec3& center) override {
    if (first_) last_ = center;
    const Vec3 velocity = (center - std::exchange(last_, center)) / kTick;
    first_ = false;
    const StepResult& r = simulation_.step(Pose::from_translation(center), {velocity, Vec3::Zero()}, kTick);
    return {r.force.z(), r.force.x(), r.contact.voxels, long(r.removed_voxels.size())};
  }

 private:
  static Simulation make(const Workload& w, bool cutting) {
    Material bone;
    bone.name = "bone";
    bone.specific_cutting_energy = 1e8;
    bone.cutting_ratio = cutting ? 0.5 : 0.0;
    SimulationConfig config;
    if (!cutting) config.reference_stiffness = 1e3 / std::pow(w.voxel_size, 3);  // 1 N/mm per voxel
    config.removal = cutting ? RemovalLaw::constant_energy : RemovalLaw::none;
    config.deep_contact = cutting;  // static: only the springs, like the others
    config.reserved_blocks = 16384;
    config.friction = DryFriction{0, 0, 1};  // the other contestants have no friction
    return Simulation(build_block({Vec3::Zero(), Vec3(kBlockX, kBlockY, kBlockZ)}, w.voxel_size, bone),
                      Tool(SphereHead{w.radius}, RayHandle{0}, Spindle{(cutting ? 3000.0 : 0.0) * units::rad_per_s}),
                      config);
  }
  Simulation simulation_;
  Vec3 last_;
  bool first_ = true;
};

std::unique_ptr<Contestant> make_any(const std::string& name, const Workload& workload) {
  if (name == "hapticut") return std::make_unique<Hapticut>(workload, true);
  if (name == "hapticut_static") return std::make_unique<Hapticut>(workload, false);
  return make_contestant(name, workload);
}

void run_path(benchmark::State& state, const std::string& name, const Workload& workload) {
  double force_z = 0;
  long max_contact = 0, removed = 0;
  for (auto _ : state) {
    const auto contestant = make_any(name, workload);
    TickTimes times(workload.ticks());
    force_z = 0;
    max_contact = removed = 0;
    for (int t = 0; t < workload.ticks(); ++t) {
      const Vec3 center = workload.center(t);
      times.time([&] {
        const TickResult r = contestant->tick(center);
        force_z += r.force_z;
        max_contact = std::max(max_contact, r.contact);
        removed += r.removed;
        return r.contact;
      });
    }
    state.SetIterationTime(times.total());
    times.report(state);
  }
  state.counters["max_in_contact"] = double(max_contact);
  state.counters["removed"] = double(removed);
  state.counters["force_z_sum"] = force_z;
}

void register_all() {
  for (const Path path : {Path::w1, Path::w2, Path::w3})
    for (const double h : {0.1e-3, 0.05e-3})
      for (const double radius : {1e-3, 2e-3, 3e-3}) {
        const Workload workload{path, h, radius};
        std::vector<std::string> names = contestant_names();
        names.emplace_back("hapticut");
        if (path != Path::w2) std::erase_if(names, [](const std::string& name) { return name.starts_with("proxy"); });
        if (path == Path::w3 || (path == Path::w1 && radius > 1.5e-3)) names.emplace_back("hapticut_static");
        for (const std::string& name : names)
          benchmark::RegisterBenchmark(workload.name(name).c_str(),
                                       [=](benchmark::State& state) { run_path(state, name, workload); })
              ->UseManualTime()
              ->Iterations(1)
              ->Unit(benchmark::kMillisecond);
      }
}

}  // namespace
}  // namespace hapticut::bench

int main(int argc, char** argv) {
  const char* kernels = hapticut::bench::choose_kernels();
  if (kernels == nullptr) return 2;
  benchmark::AddCustomContext("kernels", kernels);
  hapticut::bench::register_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
