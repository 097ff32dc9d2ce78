// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace hapticut {

/// How often a duration was seen, in buckets of 1 us up to 2 ms, and what was longer.
/// @realtime adding allocates nothing, takes no lock
class LatencyHistogram {
 public:
  static constexpr std::size_t kBuckets = 2000;
  static constexpr double kBucketWidth = 1e-6;  // [s]

  /// @param seconds [s] >= 0; what is not a number counts as longer than all buckets
  void add(double seconds) noexcept {
    const double bucket = seconds / kBucketWidth;
    if (bucket < double(kBuckets))
      ++buckets_[std::size_t(std::max(0.0, bucket))];
    else
      ++longer_;
    ++count_;
    sum_ += seconds;
    min_ = std::min(min_, seconds);
    max_ = std::max(max_, seconds);
  }

  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] double min() const { return count_ > 0 ? min_ : 0; }                    ///< [s]
  [[nodiscard]] double max() const { return max_; }                                     ///< [s]
  [[nodiscard]] double mean() const { return count_ > 0 ? sum_ / double(count_) : 0; }  ///< [s]
  [[nodiscard]] std::uint64_t longer() const { return longer_; }                        ///< than all buckets
  [[nodiscard]] const std::array<std::uint64_t, kBuckets>& buckets() const { return buckets_; }

  /// [s] the upper edge of the bucket below which a share of all durations lies; the maximum where that is among the
  /// longer ones.  @param share [1] 0 ... 1
  [[nodiscard]] double quantile(double share) const {
    const auto wanted = std::uint64_t(std::ceil(std::clamp(share, 0.0, 1.0) * double(count_)));
    std::uint64_t seen = 0;
    for (std::size_t n = 0; n < kBuckets; ++n) {
      seen += buckets_[n];
      if (seen >= wanted && seen > 0) return std::min(max_, kBucketWidth * double(n + 1));
    }
    return max_;
  }

 private:
  std::array<std::uint64_t, kBuckets> buckets_{};
  std::uint64_t longer_ = 0, count_ = 0;
  double sum_ = 0, min_ = HUGE_VAL, max_ = 0;
};

}  // namespace hapticut
