// SPDX-License-Identifier: Apache-2.0
// Costs of the drawn surface of the workpiece, in a second thread while the loop runs. surface/dirty64: meshing of the
// blocks that a ball of 2 mm changes in a groove; surface/latency: time from a cut to its pages; surface/first: pages
// of a large workpiece; surface/extract: a workpiece as one mesh.
#include "surfaces.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>
#include <vector>

#include "hapticut/build/volume_builders.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/loop/change_feed.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/surface/extract_surface.hpp"
#include "hapticut/surface/surface_stream.hpp"
#include "support/ball_cuts.hpp"
#include "tick_times.hpp"

namespace hapticut::bench {
namespace {

using units::mm;

Material shown_bone() {
  Material bone;
  bone.name = "bone";
  return bone;
}

/// A groove: meshes the changed blocks of each part, at least 40 together, and reads their pages.
void run_dirty(benchmark::State& state) {
  constexpr double kVoxel = 0.1 * mm, kRadius = 20;  // [m], [voxels]
  for (auto _ : state) {
    Workpiece block = build_block({Vec3::Zero(), Vec3(40, 40, 20) * mm}, kVoxel, shown_bone());
    block.reserve_blocks(20'000);
    SurfaceStream stream(block);
    SurfacePage page;
    while (stream.next_page(page)) {
    }
    double total = 0, blocks = 0, bytes = 0;
    std::vector<double> of_64;  // [s]
    std::vector<VoxelIndex> changed;
    for (double x = 60; x < 340; x += 0.8) {
      const auto more = test::cut_ball(block, {x, 200.3, 195.2}, kRadius);
      changed.insert(changed.end(), more.begin(), more.end());
      if (changed.size() < 40) continue;
      std::sort(changed.begin(), changed.end());
      changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
      const std::uint64_t before = stream.blocks_meshed();
      const double begin = thread_seconds();
      (void)stream.update(block, changed);
      while (stream.next_page(page)) bytes += 12.0 * double(page.vertices.size()) + 2.0 * double(page.indices.size());
      const double elapsed = thread_seconds() - begin;
      const double meshed = double(stream.blocks_meshed() - before);
      total += elapsed, blocks += meshed;
      of_64.push_back(64 * elapsed / meshed);
      changed.clear();
    }
    std::sort(of_64.begin(), of_64.end());
    state.SetIterationTime(total);
    state.counters["us_per_block"] = 1e6 * total / blocks;
    state.counters["ms_of_64_blocks"] = 1e3 * of_64[of_64.size() / 2];
    state.counters["p99_ms_of_64_blocks"] = 1e3 * of_64[std::size_t(0.99 * double(of_64.size()))];
    state.counters["blocks_at_once"] = blocks / double(of_64.size());
    state.counters["kB_at_once"] = 1e-3 * bytes / double(of_64.size());
  }
}

/// 256 M labels, half of them filled: a gyroid with a period of 100 voxels.
Workpiece gyroid() {
  LabelVolume labels;
  labels.dims = {800, 800, 400};
  labels.spacing = Vec3::Constant(0.05 * mm);
  labels.values.resize(labels.size());
  std::vector<double> sine(800), cosine(800);
  for (std::size_t n = 0; n < 800; ++n) {
    sine[n] = std::sin(2 * units::kPi * double(n) / 100);
    cosine[n] = std::cos(2 * units::kPi * double(n) / 100);
  }
  std::size_t at = 0;
  for (std::size_t k = 0; k < 400; ++k)
    for (std::size_t j = 0; j < 800; ++j)
      for (std::size_t i = 0; i < 800; ++i, ++at)
        labels.values[at] = sine[i] * cosine[j] + sine[j] * cosine[k] + sine[k] * cosine[i] > 0 ? 1 : 0;
  return build_from_labels(labels, {{{1}, shown_bone()}});
}

void run_first(benchmark::State& state) {
  const Workpiece workpiece = gyroid();
  for (auto _ : state) {
    const double begin = thread_seconds();
    SurfaceStream stream(workpiece);
    stream.look_at(Vec3(10, 12, 9) * mm);
    SurfacePage page;
    (void)stream.next_page(page);
    const double first = thread_seconds();
    double pages = 1, triangles = double(page.indices.size()) / 3, nearest = first;
    while (stream.next_page(page)) {
      pages += 1, triangles += double(page.indices.size()) / 3;
      if (pages == 64) nearest = thread_seconds();
    }
    const double all = thread_seconds();
    state.SetIterationTime(all - begin);
    state.counters["first_page_ms"] = 1e3 * (first - begin);
    state.counters["nearest_64_pages_ms"] = 1e3 * (nearest - begin);
    state.counters["us_per_block"] = 1e6 * (all - first) / double(stream.blocks_meshed());
    state.counters["pages"] = pages;
    state.counters["triangles"] = triangles;
    state.counters["MB"] = 1e-6 * double(stream.memory_bytes());
  }
}

void run_extract(benchmark::State& state) {
  const Workpiece ball = build_sphere(Vec3::Zero(), 12 * mm, 0.1 * mm, shown_bone());
  for (auto _ : state) {
    const WorkpieceSurface surface = extract_surface(ball);
    state.counters["triangles"] = double(surface.mesh.triangles.size());
  }
}

/// Cutting for some seconds in one thread, and meshing every 4 ms in another. Measures the age of the oldest cut when
/// all its pages are ready. Wall time, so other programs on the machine lengthen it.
void run_latency(benchmark::State& state) {
  using Clock = std::chrono::steady_clock;
  // The workload W2: a ball of 2 mm moves 3 mm down and 1 mm sideways at 2 mm/s.
  constexpr double kRadiusOfBall = 2 * mm, kPerTick = 2e-3 * mm, kDown = 3 * mm, kSideways = 1 * mm;
  constexpr int kTicksOfPath = int((kDown + kSideways) / kPerTick);
  const auto center = [&](int tick) {
    const double s = kPerTick * (tick + 1), down = std::min(s, kDown);
    return Vec3(20.013 * mm + (s - down), 20.007 * mm, 20 * mm + kRadiusOfBall - down);
  };
  for (auto _ : state) {
    SimulationConfig config;
    config.reserved_blocks = 16'384;
    Simulation simulation(build_block({Vec3::Zero(), Vec3(40, 40, 20) * mm}, 0.1 * mm, shown_bone()),
                          Tool(SphereHead{kRadiusOfBall}, RayHandle{0}, Spindle{3000 * units::rad_per_s}), config);
    ChangeFeed feed(simulation);
    SurfaceStream stream(simulation.workpiece());
    SurfacePage page;
    while (stream.next_page(page)) {
    }
    std::atomic<std::int64_t> oldest = 0;  // [ns] time of the oldest cut that is not meshed yet; 0: no such cut
    std::atomic<bool> over = false;
    std::vector<double> ages;  // [ms]
    std::thread mesher([&] {
      ChangedBlock block;
      while (!over) {
        std::this_thread::sleep_for(std::chrono::milliseconds(4));
        const std::int64_t cut = oldest.exchange(0);
        while (feed.receive(block)) (void)stream.update(block.origin, block.material.data(), block.fill.data());
        while (stream.next_page(page)) benchmark::DoNotOptimize(page.vertices.data());
        if (cut != 0) ages.push_back(1e-6 * double(Clock::now().time_since_epoch().count() - cut));
      }
    });
    const auto begin = Clock::now();
    double busy = 0;
    for (int tick = 0; tick < kTicksOfPath; ++tick) {
      std::this_thread::sleep_until(begin + std::chrono::milliseconds(tick));
      const double before = thread_seconds();
      const StepResult& result = simulation.step(Pose::from_translation(center(tick)), {}, 1e-3);
      busy += thread_seconds() - before;
      std::int64_t no_cut = 0;
      if (result.removed_volume > 0)
        oldest.compare_exchange_strong(no_cut, std::int64_t(Clock::now().time_since_epoch().count()));
    }
    over = true;
    mesher.join();
    std::sort(ages.begin(), ages.end());
    state.SetIterationTime(busy);
    state.counters["looks"] = double(ages.size());
    state.counters["age_p50_ms"] = ages.empty() ? 0 : ages[ages.size() / 2];
    state.counters["age_p99_ms"] = ages.empty() ? 0 : ages[std::size_t(0.99 * double(ages.size()))];
  }
}

}  // namespace

void add_surfaces() {
  benchmark::RegisterBenchmark("surface/dirty64", run_dirty)
      ->UseManualTime()
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("surface/latency", run_latency)
      ->UseManualTime()
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("surface/first", run_first)
      ->UseManualTime()
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("surface/extract", run_extract)
      ->UseRealTime()
      ->Iterations(3)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace hapticut::bench
