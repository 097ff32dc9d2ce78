// SPDX-License-Identifier: Apache-2.0
// Bodies and cavities of a volume: samples that are connected over faces.
#include <algorithm>
#include <numeric>
#include <string>

#include "core/interruption.hpp"
#include "hapticut/build/volume_operations.hpp"

namespace hapticut {
namespace {

/// Adjacent samples of one row (along x) that belong to a body.
struct Run {
  int begin, end;  // `end` is not included
};

/// The bodies of a volume, found from runs. There are far fewer runs than samples, and each is visited once.
class Bodies {
 public:
  /// @param inside  whether a value belongs to a body
  template <class Value, class Inside>
  Bodies(const Volume<Value>& volume, const Inside& inside) : dims_(volume.dims) {
    const auto [nx, ny, nz] = dims_;
    first_run_.push_back(0);
    for (int k = 0; k < nz; ++k)
      for (int j = 0; j < ny; ++j) {
        look_for_interruption();
        add_row(&volume.at(0, j, k), nx, inside);
        const std::size_t row = first_run_.size() - 2;
        if (j > 0) join(row - 1, row);
        if (k > 0) join(row - std::size_t(ny), row);
      }
  }

  [[nodiscard]] std::size_t runs() const { return runs_.size(); }

  /// The body of a run: the number of its first run, in the order of the volume.
  [[nodiscard]] std::uint32_t body_of(std::size_t run) {
    auto n = std::uint32_t(run);
    while (parent_[n] != n) n = parent_[n] = parent_[parent_[n]];
    return n;
  }

  /// Calls `use(run, row, samples of the run)` for each run.
  template <class Use>
  void for_each_run(const Use& use) const {
    for (std::size_t row = 0; row + 1 < first_run_.size(); ++row)
      for (std::size_t n = first_run_[row]; n < first_run_[row + 1]; ++n) use(n, row, runs_[n]);
  }

 private:
  template <class Value, class Inside>
  void add_row(const Value* values, int count, const Inside& inside) {
    for (int i = 0; i < count;) {
      while (i < count && !inside(values[i])) ++i;
      const int begin = i;
      while (i < count && inside(values[i])) ++i;
      if (i == begin) continue;
      parent_.push_back(std::uint32_t(runs_.size()));
      runs_.push_back({begin, i});
    }
    first_run_.push_back(runs_.size());
  }

  /// Joins the runs of two adjacent rows that touch.
  void join(std::size_t a_row, std::size_t b_row) {
    std::size_t a = first_run_[a_row], b = first_run_[b_row];
    while (a < first_run_[a_row + 1] && b < first_run_[b_row + 1]) {
      if (runs_[a].begin < runs_[b].end && runs_[b].begin < runs_[a].end) {
        const std::uint32_t of_a = body_of(a), of_b = body_of(b);
        parent_[std::max(of_a, of_b)] = std::min(of_a, of_b);
      }
      ++(runs_[a].end < runs_[b].end ? a : b);
    }
  }

  std::array<int, 3> dims_;
  std::vector<Run> runs_;
  std::vector<std::uint32_t> parent_;   // for each run an earlier run of the same body, or itself
  std::vector<std::size_t> first_run_;  // first run of each row, and the end of the last row
};

/// Gives a value to all samples that belong to a body but not to the largest one.
/// @return whether there is a body
template <class Value, class Inside>
bool clear_all_but_largest(Volume<Value>& volume, const Inside& inside, Value outside) {
  Bodies bodies(volume, inside);
  if (bodies.runs() == 0) return false;
  std::vector<std::uint64_t> size(bodies.runs(), 0);
  bodies.for_each_run([&](std::size_t n, std::size_t, const Run& run) {
    size[bodies.body_of(n)] += std::uint64_t(run.end - run.begin);
  });
  const auto largest = std::uint32_t(std::max_element(size.begin(), size.end()) - size.begin());
  bodies.for_each_run([&](std::size_t n, std::size_t row, const Run& run) {
    if (bodies.body_of(n) == largest) return;
    const auto begin = volume.values.begin() + std::ptrdiff_t(row) * volume.dims[0];
    std::fill(begin + run.begin, begin + run.end, outside);
  });
  return true;
}

}  // namespace

LabelVolume keep_largest_component(LabelVolume volume) {
  require_valid(volume);
  if (!clear_all_but_largest(
          volume, [](std::uint16_t label) { return label != 0; }, std::uint16_t(0)))
    throw Error("all labels of the volume are 0; there is no component to keep.");
  return volume;
}

GreyVolume keep_largest_component(GreyVolume volume, double threshold) {
  const auto lowest = float(grey_range(volume)[0]);
  if (!clear_all_but_largest(
          volume, [&](float value) { return double(value) >= threshold; }, lowest))
    throw Error("no grey value of the volume is " + format_number(threshold) +
                " or more; there is no component to keep.");
  return volume;
}

LabelVolume fill_cavities(LabelVolume volume, std::uint16_t label) {
  require_valid(volume);
  Bodies empty(volume, [](std::uint16_t value) { return value == 0; });
  const auto nx = volume.dims[0];
  const auto ny = std::size_t(volume.dims[1]), nz = std::size_t(volume.dims[2]);
  std::vector<bool> open(empty.runs(), false);
  empty.for_each_run([&](std::size_t n, std::size_t row, const Run& run) {
    const std::size_t j = row % ny, k = row / ny;
    if (run.begin == 0 || run.end == nx || j == 0 || j == ny - 1 || k == 0 || k == nz - 1)
      open[empty.body_of(n)] = true;
  });
  empty.for_each_run([&](std::size_t n, std::size_t row, const Run& run) {
    if (open[empty.body_of(n)]) return;
    const auto begin = volume.values.begin() + std::ptrdiff_t(row) * nx;
    std::fill(begin + run.begin, begin + run.end, label);
  });
  return volume;
}

}  // namespace hapticut
