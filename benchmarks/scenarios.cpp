// SPDX-License-Identifier: Apache-2.0
// Influences on the cost of a step: the head, the size of the workpiece, its materials, the number of simulations; and
// a minute of cutting with its deadline misses. Names: heads/..., sizes/..., materials/..., batch/..., deadline/...,
// load/...; surfaces.cpp has surface/...
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <string>

#include "hapticut/build/volume_builders.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/tool/profile.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "kernel_choice.hpp"
#include "surfaces.hpp"
#include "tick_times.hpp"

namespace hapticut::bench {
namespace {

using units::deg;
using units::mm;

constexpr double kTick = 1e-3;  // [s]
constexpr double kFeed = 2e-3;  // [m/s]

Material bone() {
  Material bone;
  bone.name = "bone";
  bone.specific_cutting_energy = 1e8;
  bone.cutting_ratio = 0.5;
  return bone;
}

SimulationConfig config(bool cutting) {
  SimulationConfig config;
  config.removal = cutting ? RemovalLaw::constant_energy : RemovalLaw::none;
  config.reserved_blocks = 16384;
  config.friction = DryFriction{0, 0, 1};
  config.deep_contact = false;
  return config;
}

Tool spinning(const ToolHead& head) { return Tool(head, RayHandle{0}, Spindle{3000 * units::rad_per_s}); }

/// Feeds a simulation from a start in a straight line along +x.
class Feed {
 public:
  Feed(Simulation simulation, const Vec3& start) : simulation_(std::move(simulation)), position_(start) {}

  int tick() {
    position_.x() += kFeed * kTick;
    return simulation_.step(Pose::from_translation(position_), {Vec3(kFeed, 0, 0), Vec3::Zero()}, kTick).contact.voxels;
  }
  [[nodiscard]] const Simulation& simulation() const { return simulation_; }

 private:
  Simulation simulation_;
  Vec3 position_;
};

void run_feeds(benchmark::State& state, int ticks, int count, const std::function<Feed()>& make) {
  for (auto _ : state) {
    std::vector<Feed> feeds;
    for (int i = 0; i < count; ++i) feeds.push_back(make());
    TickTimes times(ticks * count);
    for (int t = 0; t < ticks; ++t)
      for (Feed& feed : feeds) times.time([&] { return feed.tick(); });
    state.SetIterationTime(times.total());
    times.report(state);
  }
}

void add(const std::string& name, int ticks, const std::function<Feed()>& make, int count = 1) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { run_feeds(state, ticks, count, make); })
      ->UseManualTime()
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
}

/// Heads buried to their full height in a block; the tip of the head is at (10, 10, 7) mm.
void add_heads() {
  const auto ball_profile = [](double radius) {
    return Profile{-radius, {{radius, 0, radius, EdgeKind::cutting}, {0, radius, radius, EdgeKind::cutting}}};
  };
  const std::vector<std::pair<std::string, ToolHead>> heads = {
      {"sphere", SphereHead{2 * mm}},
      {"cone", ConeHead{30 * deg, 4 * mm}},
      {"flat", FlatHead{1.6 * mm, 4 * mm}},
      {"profile_sphere", ProfileHead(ball_profile(2 * mm))},
      {"profile_pear", pear_head(3.2 * mm, 4 * mm, 1.2 * mm)},
      {"profile_tree", christmas_tree_head(4 * mm, 4 * mm, 3)}};
  for (const auto& [name, head] : heads)
    for (const bool cutting : {false, true})
      add("heads/" + name + (cutting ? "/cutting" : "/static"), 500, [head = head, cutting] {
        const Vec3 start(10.013 * mm, 10.007 * mm, 7.003 * mm - head.bounding_box().min.z());
        return Feed(Simulation(build_block({Vec3::Zero(), Vec3(20, 20, 16) * mm}, 0.1 * mm, bone()),
                               cutting ? spinning(head) : Tool(head), config(cutting)),
                    start);
      });
}

/// A groove in a workpiece, and in a workpiece of ten times its volume.
void add_sizes() {
  for (const double scale : {1.0, 10.0})
    add("sizes/x" + std::to_string(int(scale)), 1000, [scale] {
      const double side = 40 * mm * std::sqrt(scale);
      return Feed(
          Simulation(build_block({Vec3(-side / 2, -side / 2, 0), Vec3(side / 2, side / 2, 20 * mm)}, 0.1 * mm, bone()),
                     spinning(SphereHead{2 * mm}), config(true)),
          Vec3(0.013 * mm, 0.007 * mm, 20.5 * mm));
    });
}

/// Labels of one material, of layers of three materials, or of three materials chosen at random per voxel.
LabelVolume labels_of(const std::string& kind, const std::array<int, 3>& dims, double spacing) {
  LabelVolume labels;
  labels.dims = dims;
  labels.spacing = Vec3::Constant(spacing);
  labels.values.resize(labels.size());
  std::uint32_t random = 1;
  std::size_t n = 0;
  for (int k = 0; k < dims[2]; ++k)
    for (int ij = 0; ij < dims[0] * dims[1]; ++ij, ++n) {
      random = random * 1664525U + 1013904223U;
      const unsigned label = kind == "one" ? 0U : kind == "layers" ? unsigned(k / 10) % 3 : (random >> 16U) % 3;
      labels.values[n] = std::uint16_t(1 + label);
    }
  return labels;
}

std::vector<LabelMaterial> materials_of(const LabelVolume& labels) {
  std::vector<LabelMaterial> materials;
  const int max_label = *std::max_element(labels.values.begin(), labels.values.end());
  for (int label = 1; label <= max_label; ++label) {
    Material material = bone();
    material.name = "bone " + std::to_string(label);
    materials.push_back({{std::uint16_t(label)}, material});
  }
  return materials;
}

void add_materials() {
  for (const std::string kind : {"one", "layers", "mixed"})
    add("materials/" + kind, 500, [kind] {
      const LabelVolume labels = labels_of(kind, {160, 120, 80}, 0.1 * mm);
      return Feed(
          Simulation(build_from_labels(labels, materials_of(labels)), spinning(SphereHead{2 * mm}), config(true)),
          Vec3(5.013 * mm, 6.007 * mm, 8.5 * mm));
    });
}

void add_batches() {
  for (const int count : {1, 2, 4, 8, 16})
    add(
        "batch/" + std::to_string(count), 250,
        [] {
          return Feed(Simulation(build_block({Vec3::Zero(), Vec3(16, 12, 8) * mm}, 0.1 * mm, bone()),
                                 spinning(SphereHead{1 * mm}), config(true)),
                      Vec3(5.013 * mm, 6.007 * mm, 8.2 * mm));
        },
        count);
}

/// A minute at 1 kHz: grooves back and forth, each beside the previous one.
void run_minute(benchmark::State& state, double voxel_size, double radius) {
  constexpr int kTicks = 60000;
  for (auto _ : state) {
    Simulation simulation(build_block({Vec3::Zero(), Vec3(40, 40, 20) * mm}, voxel_size, bone()),
                          spinning(SphereHead{radius}), config(true));
    TickTimes times(kTicks);
    const Vec3 first(10.013 * mm, 14.007 * mm, 20 * mm);
    const auto at = [&](int t) {
      const double along = std::fmod(t * kTick * kFeed, 2 * 10 * mm), passes = t * kTick * kFeed / (10 * mm);
      return Vec3(first + Vec3(along < 10 * mm ? along : 20 * mm - along, 0.5 * radius * passes, 0));
    };
    Vec3 last = at(0);
    rusage before{}, after{};
    (void)simulation.step(Pose::from_translation(last), {}, kTick);
    getrusage(RUSAGE_THREAD, &before);
    for (int t = 1; t <= kTicks; ++t) {
      const Vec3 position = at(t);
      const Twist velocity{(position - last) / kTick, Vec3::Zero()};
      last = position;
      times.time([&] { return simulation.step(Pose::from_translation(position), velocity, kTick).contact.voxels; });
    }
    getrusage(RUSAGE_THREAD, &after);
    state.SetIterationTime(times.total());
    times.report(state);
    state.counters["page_faults"] = double(after.ru_minflt + after.ru_majflt - before.ru_minflt - before.ru_majflt);
  }
}

/// The same number of ticks of arithmetic in registers, without memory accesses, locks and system calls. The machine
/// causes the late ticks.
void run_arithmetic(benchmark::State& state) {
  constexpr int kTicks = 60000, kOperations = 50000;
  for (auto _ : state) {
    TickTimes times(kTicks);
    for (int t = 0; t < kTicks; ++t)
      times.time([&] {
        double x = t;
        for (int n = 0; n < kOperations; ++n) x = 0.999 * x + 1;
        benchmark::DoNotOptimize(x);
        return 0;
      });
    state.SetIterationTime(times.total());
    times.report(state);
  }
}

void add_minutes() {
  benchmark::RegisterBenchmark("deadline/arithmetic", run_arithmetic)
      ->UseManualTime()
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
  for (const auto& [name, voxel, radius] :
       {std::tuple("deadline/h0.05/R2", 0.05 * mm, 2 * mm), std::tuple("deadline/h0.1/R3", 0.1 * mm, 3 * mm)})
    benchmark::RegisterBenchmark(
        name, [=, voxel = voxel, radius = radius](benchmark::State& state) { run_minute(state, voxel, radius); })
        ->UseManualTime()
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
}

/// Builds a workpiece from an array of labels: 800 x 800 x 400 voxels, wall time on all cores.
void run_load(benchmark::State& state, const std::string& kind) {
  const LabelVolume labels = labels_of(kind, {800, 800, 400}, 0.05 * mm);
  const std::vector<LabelMaterial> materials = materials_of(labels);
  for (auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    const Workpiece workpiece = build_from_labels(labels, materials);
    state.SetIterationTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    state.counters["bytes_per_voxel"] = double(workpiece.memory_bytes()) / double(workpiece.solid_voxels());
    state.counters["voxels"] = double(workpiece.solid_voxels());
  }
}

}  // namespace
}  // namespace hapticut::bench

int main(int argc, char** argv) {
  using namespace hapticut::bench;
  const char* kernels = choose_kernels();
  if (kernels == nullptr) return 2;
  benchmark::AddCustomContext("kernels", kernels);
  add_heads();
  add_sizes();
  add_materials();
  add_batches();
  add_minutes();
  add_surfaces();
  for (const std::string kind : {"layers", "mixed"})
    benchmark::RegisterBenchmark(("load/" + kind).c_str(), [kind](benchmark::State& state) { run_load(state, kind); })
        ->UseManualTime()
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
