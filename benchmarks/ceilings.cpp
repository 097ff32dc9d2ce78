// SPDX-License-Identifier: Apache-2.0
// The maximum of one core of this machine: single-precision operations per second, and bytes per second from arrays of
// several sizes. docs/performance.md compares with it. Compiled for the machine that it runs on.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <vector>

namespace {

constexpr int kLanes = 16;
using Lanes = std::array<float, kLanes>;

/// Sixteen chains of fused multiply-adds, enough to use all units.
void multiply_add(benchmark::State& state) {
  constexpr int kChains = 16;
  alignas(64) std::array<Lanes, kChains> chains{};
  for (auto _ : state) {
    for (int repeat = 0; repeat < 64; ++repeat)
      for (Lanes& chain : chains)
        for (float& v : chain) v = std::fma(v, 0.999F, 1e-3F);
    benchmark::ClobberMemory();
  }
  benchmark::DoNotOptimize(chains);
  state.counters["GFlop/s"] =
      benchmark::Counter(double(state.iterations()) * 64 * kChains * kLanes * 2 / 1e9, benchmark::Counter::kIsRate);
}

/// Square root and division, the two slow operations per sample.
void root_and_divide(benchmark::State& state) {
  constexpr int kVectors = 64;
  alignas(64) std::array<Lanes, kVectors> data;
  for (Lanes& lanes : data) lanes.fill(2.0F);
  for (auto _ : state) {
    for (Lanes& lanes : data)
      for (float& v : lanes) v = 3.0F / std::sqrt(v);
    benchmark::ClobberMemory();
  }
  benchmark::DoNotOptimize(data);
  state.counters["G/s"] =
      benchmark::Counter(double(state.iterations()) * kVectors * kLanes / 1e9, benchmark::Counter::kIsRate);
}

/// Reads and writes an array; the argument is its size in kilobytes.
void stream(benchmark::State& state) {
  std::vector<float> data(std::size_t(state.range(0)) * 256, 1.0F);
  for (auto _ : state) {
    for (float& v : data) v *= 0.999F;
    benchmark::ClobberMemory();
  }
  state.counters["GB/s"] =
      benchmark::Counter(double(state.iterations()) * double(data.size()) * 8 / 1e9, benchmark::Counter::kIsRate);
}

BENCHMARK(multiply_add);
BENCHMARK(root_and_divide);
BENCHMARK(stream)->Arg(16)->Arg(256)->Arg(4096)->Arg(262144);

}  // namespace

BENCHMARK_MAIN();
