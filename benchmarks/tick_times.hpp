// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <benchmark/benchmark.h>
#include <ctime>

#include <algorithm>
#include <vector>

#include "support/allocation_count.hpp"

/// @file
/// Thread CPU time and allocations of single ticks, and the counters that all benchmarks report.
namespace hapticut::bench {

inline double thread_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

constexpr double kDeadline = 1e-3;  // [s]

/// The ticks of one run.
class TickTimes {
 public:
  explicit TickTimes(int ticks) { times_.reserve(std::size_t(ticks)); }

  /// Times one call of `tick`, which returns the number of voxels in contact.
  template <class Tick>
  void time(const Tick& tick) {
    test::arm_call_counts();
    const double before = thread_seconds();
    const double contact = double(tick());
    const double elapsed = thread_seconds() - before;
    allocations_ += double(test::disarm_call_counts().allocations);
    times_.push_back(elapsed);
    total_ += elapsed;
    contact_ += contact;
  }

  [[nodiscard]] double total() const { return total_; }  // [s]

  void report(benchmark::State& state) {
    const double ticks = double(times_.size());
    state.counters["mean_us"] = 1e6 * total_ / ticks;
    state.counters["misses"] =
        double(std::count_if(times_.begin(), times_.end(), [](double t) { return t > kDeadline; }));
    std::sort(times_.begin(), times_.end());
    const auto percentile = [&](double p) { return 1e6 * times_[std::min(times_.size() - 1, std::size_t(p * ticks))]; };
    state.counters["p50_us"] = percentile(0.5);
    state.counters["p99_us"] = percentile(0.99);
    state.counters["p999_us"] = percentile(0.999);
    state.counters["max_us"] = 1e6 * times_.back();
    state.counters["contact_voxels"] = contact_ / ticks;
    state.counters["ns_per_contact_voxel"] = contact_ > 0 ? 1e9 * total_ / contact_ : 0;
    state.counters["allocations"] = allocations_;
  }

 private:
  std::vector<double> times_;  // [s]
  double total_ = 0, contact_ = 0, allocations_ = 0;
};

}  // namespace hapticut::bench
