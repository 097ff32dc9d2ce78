// SPDX-License-Identifier: Apache-2.0
// The step against what a competent user would write instead: `step/<workload>/h<voxel mm>/R<radius mm>/<contestant>`.
// One iteration is one whole path; times are thread CPU time per tick. Run with
// --benchmark_enable_random_interleaving=true and several repetitions, and compare contestants of the same run only.
#include <benchmark/benchmark.h>
#include <ctime>

#include <cstdio>

#include "contestants.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/workpiece/builders.hpp"

namespace hapticut::bench {
namespace {

double thread_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

/// hapticut itself, as a contestant: `cutting` with the full model, or static with the same voxels as the others.
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
    config.reference_stiffness = cutting ? 1e13 : 1e3 / std::pow(w.voxel_size, 3);  // static: 1 N/mm per voxel
    config.removal = cutting ? RemovalLaw::constant_energy : RemovalLaw::none;
    config.quadrature = cutting ? Quadrature::centroid : Quadrature::voxel_center;
    config.deep_contact = cutting;  // static: the springs alone, as the others compute them
    config.reserved_blocks = 16384;
    config.friction = DryFriction{0, 0, 1};  // the other contestants have none
    return Simulation(build_block({Vec3::Zero(), Vec3(kBlockX, kBlockY, kBlockZ)}, w.voxel_size, bone),
                      Tool(SphereHead{w.radius}, RayHandle{}, Spindle{cutting ? 3000.0 : 0.0}), config);
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
  std::vector<double> times(std::size_t(workload.ticks()));
  double force_z = 0, contact = 0;
  long most = 0, removed = 0;
  for (auto _ : state) {
    const auto contestant = make_any(name, workload);
    force_z = contact = 0;
    most = removed = 0;
    double total = 0;
    for (int t = 0; t < workload.ticks(); ++t) {
      const Vec3 center = workload.center(t);
      const double before = thread_seconds();
      const TickResult r = contestant->tick(center);
      times[std::size_t(t)] = thread_seconds() - before;
      total += times[std::size_t(t)];
      force_z += r.force_z;
      contact += double(r.contact);
      most = std::max(most, r.contact);
      removed += r.removed;
    }
    state.SetIterationTime(total);
  }
  const double ticks = double(times.size());
  double mean = 0;
  for (const double t : times) mean += t * 1e6 / ticks;
  state.counters["mean_us"] = mean;
  state.counters["misses"] = double(std::count_if(times.begin(), times.end(), [](double t) { return t > 1e-3; }));
  std::sort(times.begin(), times.end());
  const auto percentile = [&](double p) { return 1e6 * times[std::min(times.size() - 1, std::size_t(p * ticks))]; };
  state.counters["p50_us"] = percentile(0.5);
  state.counters["p99_us"] = percentile(0.99);
  state.counters["p999_us"] = percentile(0.999);
  state.counters["max_us"] = 1e6 * times.back();
  state.counters["contact_voxels"] = contact / ticks;
  state.counters["ns_per_contact_voxel"] = contact > 0 ? mean * 1e3 * ticks / contact : 0;
  state.counters["most_in_contact"] = double(most);
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
  hapticut::bench::register_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
