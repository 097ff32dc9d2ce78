// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "workpiece/volume_sampling.hpp"

/// @file
/// What the samples of a volume mean: labels, or ranges of grey values. See VolumeFiller for what a field is asked.
namespace hapticut {

/// How much of a voxel belongs to each material.
struct MaterialShares {
  std::array<float, 256> share{};

  [[nodiscard]] MaterialId largest() const {
    return MaterialId(std::max_element(share.begin() + 1, share.end()) - share.begin());
  }
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
  float count(const Cell<Sample>& cell, Tally& tally) const {
    float variation = 0;
    const float membership =
        cell.interpolate([&](Sample label) { return material_of_[label] != kEmpty ? 1.0F : 0.0F; }, variation);
    const float share = covered_share(membership - 0.5F, variation, membership >= 0.5F);
    if (share == 0) return 0;
    const auto [x, y, z] = cell.weight;
    for (unsigned n = 0; n < 8; ++n)
      tally.share[material_of_[cell.corner[n]]] +=
          share * ((n & 1U) != 0 ? x : 1 - x) * ((n & 2U) != 0 ? y : 1 - y) * ((n & 4U) != 0 ? z : 1 - z);
    return share;
  }
  [[nodiscard]] MaterialId material(const Tally& tally) const { return tally.largest(); }

 private:
  const std::vector<MaterialId>& material_of_;  // [65536]
};

/// Grey values cut into zones: each is a material, or empty.
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
  /// @param graded  the material of a voxel is that of its mean grey value instead of the most frequent one
  GreyField(const std::vector<Bounds>& ranges, bool graded) : graded_(graded) {
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
    // A surface is where solid meets empty: neighbouring solid zones share their outer bounds.
    for (std::size_t n = 1; n < zones_.size(); ++n)
      if (zones_[n].material != kEmpty && zones_[n - 1].material != kEmpty) zones_[n].low = zones_[n - 1].low;
    for (std::size_t n = zones_.size() - 1; n-- > 0;)
      if (zones_[n].material != kEmpty && zones_[n + 1].material != kEmpty) zones_[n].high = zones_[n + 1].high;
  }

  void extend(Extent& extent, Sample value) const {
    extent.low = std::min(extent.low, value);
    extent.high = std::max(extent.high, value);
  }
  [[nodiscard]] std::optional<MaterialId> uniform(const Extent& extent) const {
    const std::size_t zone = zone_of(extent.low);
    if (zone != zone_of(extent.high)) return std::nullopt;
    return zones_[zone].material;
  }
  float count(const Cell<Sample>& cell, Tally& tally) const {
    float variation = 0;
    const float value = cell.interpolate([](Sample v) { return v; }, variation);
    std::size_t at = zone_of(value);
    const Zone& zone = zones_[at];
    const bool inside = zone.material != kEmpty;
    const float depth = std::min(value - zone.low, zone.high - value);
    const float share = covered_share(inside ? depth : -depth, variation, inside);
    if (share == 0) return 0;
    if (!inside) at = nearest_solid(at, value);
    tally.materials.share[zones_[at].material] += share;
    tally.covered += double(share);
    tally.value += double(share) * double(value);
    return share;
  }
  [[nodiscard]] MaterialId material(const Tally& tally) const {
    if (!graded_) return tally.materials.largest();
    const float mean = float(tally.value / tally.covered);
    const std::size_t at = zone_of(mean);
    return zones_[zones_[at].material != kEmpty ? at : nearest_solid(at, mean)].material;
  }

 private:
  struct Zone {
    MaterialId material;
    float low, high;  ///< of the run of solid zones, or of the gap, that it is part of
  };

  [[nodiscard]] std::size_t zone_of(float value) const {
    const auto end = std::upper_bound(ends_.begin(), ends_.end(), value);
    return std::min(std::size_t(end - ends_.begin()), zones_.size() - 1);
  }
  [[nodiscard]] std::size_t nearest_solid(std::size_t gap, float value) const {
    if (gap == 0) return 1;
    if (gap + 1 == zones_.size()) return gap - 1;
    return value - zones_[gap].low < zones_[gap].high - value ? gap - 1 : gap + 1;
  }

  std::vector<Zone> zones_;  // every grey value is in one
  std::vector<float> ends_;  // upper bounds of the zones
  bool graded_;
};

}  // namespace hapticut
