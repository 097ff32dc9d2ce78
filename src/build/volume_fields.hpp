// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "build/volume_sampling.hpp"

/// @file
/// Meaning of the samples of a volume: labels, or ranges of grey values. VolumeFiller defines the interface of a field.
namespace hapticut {

/// The shares of a voxel that belong to each material.
class MaterialShares {
 public:
  void add(MaterialId material, float share) {
    shares_[material] += share;
    low_ = std::min(low_, material);
    high_ = std::max(high_, material);
  }
  /// The material with the largest share, not kEmpty; the first of several equal shares.
  [[nodiscard]] MaterialId largest() const {
    const auto begin = shares_.begin() + std::max(low_, MaterialId(1)), end = shares_.begin() + high_ + 1;
    return MaterialId(std::max_element(begin, end) - shares_.begin());
  }

 private:
  ByMaterial<float> shares_{};
  MaterialId low_ = 255, high_ = 1;  // the range in use
};

/// Labels, each of which is a material or empty.
class LabelField {
 public:
  using Sample = std::uint16_t;
  using Tally = MaterialShares;
  struct Extent {
    MaterialId low = 255, high = 0;
  };

  explicit LabelField(const std::vector<MaterialId>& material_of) : material_of_(material_of) {}

  [[nodiscard]] MaterialId material_of(Sample label) const { return material_of_[label]; }
  void extend(Extent& extent, Sample label) const {
    extent.low = std::min(extent.low, material_of_[label]);
    extent.high = std::max(extent.high, material_of_[label]);
  }
  [[nodiscard]] std::optional<MaterialId> uniform(const Extent& extent) const {
    if (extent.low != extent.high) return std::nullopt;
    return extent.low;
  }
  [[nodiscard]] bool all_solid(const Extent& extent) const { return extent.low != kEmpty; }
  [[nodiscard]] bool surely_cut(const Extent& extent) const { return extent.low == kEmpty && extent.high != kEmpty; }
  float count(const Cell<Sample>& cell, Tally& tally) const {
    float variation = 0;
    const float membership =
        cell.interpolate([&](Sample label) { return material_of_[label] != kEmpty ? 1.0F : 0.0F; }, variation);
    const float share = covered_fraction(membership - 0.5F, variation, membership >= 0.5F);
    if (share == 0) return 0;
    const auto [x, y, z] = cell.weight;
    for (unsigned n = 0; n < 8; ++n)
      tally.add(material_of_[cell.corner[n]],
                share * ((n & 1U) != 0 ? x : 1 - x) * ((n & 2U) != 0 ? y : 1 - y) * ((n & 4U) != 0 ? z : 1 - z));
    return share;
  }
  template <class CellAt>
  [[nodiscard]] MaterialId material(const Tally& tally, const Vec3&, const CellAt&) const {
    return tally.largest();
  }
  [[nodiscard]] static int reach(MaterialId) { return 0; }

 private:
  const std::vector<MaterialId>& material_of_;  // [65536]
};

/// Grey values divided into zones: each zone is a material, or empty.
///
/// At the border of a body a scan mixes both sides, and values that rise to a dense material pass through the zones of
/// softer materials. A voxel there gets the material behind it: the rise is followed along the gradient until it has
/// flattened to a quarter of its steepest slope. A real layer of soft material makes a step in the rise, where the rise
/// ends.
class GreyField {
 public:
  using Sample = float;
  struct Tally {
    MaterialShares materials;
    double covered = 0, value = 0;  ///< sums of the shares, and of share times grey value
  };
  struct Extent {
    float low = std::numeric_limits<float>::infinity(), high = -std::numeric_limits<float>::infinity();
  };
  struct Bounds {
    float from, to;
    MaterialId material;
  };

  /// @param ranges  sorted, not overlapping
  /// @param graded   a voxel has the material of its mean grey value instead of the most frequent material
  /// @param spacing  [m] of the samples; nothing: the own values of voxels at a border decide
  GreyField(const std::vector<Bounds>& ranges, bool graded, const std::optional<Vec3>& spacing)
      : graded_(graded), spacing_(spacing) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    float reached = -kInfinity;
    const auto add_zone = [&](float to, MaterialId material) {
      if (to == reached) return;
      zones_.push_back({material, reached, to});
      ends_.push_back(to);
      reached = to;
    };
    for (const Bounds& range : ranges) {
      add_zone(range.from, kEmpty);
      add_zone(range.to, range.material);
    }
    add_zone(kInfinity, kEmpty);
    // A surface lies between solid and empty, so neighbouring solid zones are one run.
    for (const auto& zone : zones_) {
      const bool solid = zone.material != kEmpty;
      if (!runs_.empty() && solid && runs_.back().solid) {
        runs_.back().high = zone.high;
      } else {
        runs_.push_back({solid, zone.low, zone.high});
      }
    }
    empty_below_.fill(-kInfinity);
    if (!spacing) return;
    for (const Zone& zone : zones_) {
      const Run& run = run_of(zone.low);
      if (zone.high < run.high) empty_below_[zone.material] = run.low;
    }
  }

  [[nodiscard]] int reach(MaterialId material) const { return std::isinf(empty_below_[material]) ? 0 : kReach + 1; }

  void extend(Extent& extent, Sample value) const {
    extent.low = std::min(extent.low, value);
    extent.high = std::max(extent.high, value);
  }
  [[nodiscard]] std::optional<MaterialId> uniform(const Extent& extent) const {
    const Run& run = run_of(extent.low);
    if (!(extent.high < run.high)) return std::nullopt;
    if (!run.solid) return kEmpty;
    const Zone& zone = zone_of(extent.low);
    if (!(extent.high < zone.high)) return std::nullopt;
    return zone.material;
  }
  [[nodiscard]] bool all_solid(const Extent& extent) const {
    const Run& run = run_of(extent.low);
    return run.solid && extent.high < run.high;
  }
  [[nodiscard]] bool surely_cut(const Extent& extent) const { return !(extent.high < run_of(extent.low).high); }

  float count(const Cell<Sample>& cell, Tally& tally) const {
    float variation = 0;
    const float value = cell.interpolate([](Sample v) { return v; }, variation);
    const Run& run = run_of(value);
    const float depth = std::min(value - run.low, run.high - value);
    const float share = covered_fraction(run.solid ? depth : -depth, variation, run.solid);
    if (share == 0) return 0;
    if (!graded_) tally.materials.add(nearest_material(run, value), share);
    tally.covered += double(share);
    tally.value += double(share) * double(value);
    return share;
  }
  template <class CellAt>
  [[nodiscard]] MaterialId material(const Tally& tally, const Vec3& place, const CellAt& cell_at) const {
    const float mean = float(tally.value / tally.covered);
    const MaterialId own = graded_ ? nearest_material(run_of(mean), mean) : tally.materials.largest();
    if (reach(own) == 0) return own;
    const float behind = value_behind(place, empty_below_[own], cell_at);
    return behind > mean ? nearest_material(run_of(behind), behind) : own;
  }

 private:
  static constexpr int kReach = 2;  // [samples] width of a border in a scan, to each side of a place

  /// The grey value at the upper end of the rise that starts below `empty` and passes through a place. If no value
  /// within reach is below `empty`, the place is not at such a border, and the result is the value at the end of the
  /// search.
  template <class CellAt>
  [[nodiscard]] float value_behind(const Vec3& place, float empty, const CellAt& cell_at) const {
    constexpr double kStep = 0.5;  // [samples]
    constexpr int kSteps = int(kReach / kStep);
    constexpr float kFlat = 0.25F;  // [1] flat rise over the steepest rise
    float unused = 0;
    const auto value_at = [&](const Vec3& p) { return cell_at(p).interpolate([](Sample v) { return v; }, unused); };
    Vec3 step;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 half = kStep * Vec3::Unit(axis);
      step[axis] = double(value_at(place + half) - value_at(place - half)) / std::pow((*spacing_)[axis], 2);
    }
    step *= kStep / std::max(step.norm(), std::numeric_limits<double>::min());

    int first = 0;
    float value = value_at(place), steepest = 0;
    while (value >= empty) {
      if (--first < -kSteps) return value;
      value = value_at(place + first * step);
    }
    for (int n = first; n < kSteps; ++n) {
      const float above = value_at(place + (n + 1) * step), rise = above - value;
      if (rise <= 0 || rise < kFlat * steepest) break;
      steepest = std::max(steepest, rise);
      value = above;
    }
    return value;
  }

  struct Zone {
    MaterialId material;
    float low, high;
  };
  /// Adjacent solid zones, or a gap.
  struct Run {
    bool solid;
    float low, high;
  };

  /// The run of a value. There are few runs, so a linear search is fastest.
  [[nodiscard]] const Run& run_of(float value) const {
    const Run* run = runs_.data();
    for (const Run* last = run + runs_.size() - 1; run != last && !(value < run->high);) ++run;
    return *run;
  }
  [[nodiscard]] const Zone& zone_of(float value) const {
    const auto end = std::upper_bound(ends_.begin(), ends_.end(), value);
    return zones_[std::min(std::size_t(end - ends_.begin()), zones_.size() - 1)];
  }
  /// The material at a value; in a gap, the material at the nearer end.
  [[nodiscard]] MaterialId nearest_material(const Run& run, float value) const {
    const Zone* zone = &zone_of(value);
    if (run.solid) return zone->material;
    if (zone == &zones_.front()) return zone[1].material;
    if (zone == &zones_.back()) return zone[-1].material;
    return value - run.low < run.high - value ? zone[-1].material : zone[1].material;
  }

  std::vector<Zone> zones_;  // every grey value is in one zone
  std::vector<float> ends_;  // upper bounds of the zones
  std::vector<Run> runs_;    // every grey value is in one run
  bool graded_;
  std::optional<Vec3> spacing_;
  ByMaterial<float> empty_below_{};  // [material] value below which a border begins; -infinity if nothing is denser
};

}  // namespace hapticut
