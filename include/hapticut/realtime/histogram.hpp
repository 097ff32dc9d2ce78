// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace hapticut {

/// Counts durations in buckets of 1 us up to 2 ms, and above in sixteen buckets per doubling, up to two minutes.
/// @realtime adding allocates nothing, takes no lock
class LatencyHistogram {
 public:
  static constexpr std::size_t kBuckets = 2000;
  static constexpr double kBucketWidth = 1e-6;  // [s]

  /// @param seconds [s] >= 0; NaN counts as longer than all buckets
  void add(double seconds) noexcept {
    const double bucket = seconds / kBucketWidth;
    if (bucket < double(kBuckets)) {
      ++buckets_[std::size_t(std::max(0.0, bucket))];
    } else {
      const double step = long_step(bucket);
      ++long_buckets_[step < double(kLongBuckets - 1) ? std::size_t(step) : kLongBuckets - 1];
      ++longer_;
    }
    ++count_;
    sum_ += seconds;
    min_ = std::min(min_, seconds);
    max_ = std::max(max_, seconds);
  }

  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] double min() const { return count_ > 0 ? min_ : 0; }                             ///< [s]
  [[nodiscard]] double max() const { return max_; }                                              ///< [s]
  [[nodiscard]] double mean() const { return count_ > 0 ? sum_ / double(count_) : 0; }           ///< [s]
  [[nodiscard]] std::uint64_t longer() const { return longer_; }                                 ///< number above 2 ms
  [[nodiscard]] const std::array<std::uint64_t, kBuckets>& buckets() const { return buckets_; }  ///< 1 us wide each

  /// The number of durations of at least `seconds`, without those in the bucket of `seconds` itself.
  /// @param seconds [s] > 0
  [[nodiscard]] std::uint64_t at_least(double seconds) const {
    constexpr double kRounding = 1e-9;  // [buckets]
    const auto first = [](double n) {
      return std::size_t(std::ceil(std::clamp(n - kRounding, 0.0, double(kBuckets))));
    };
    const double bucket = seconds / kBucketWidth;
    std::uint64_t sum = 0;
    for (std::size_t n = first(bucket); n < kBuckets; ++n) sum += buckets_[n];
    for (std::size_t n = first(long_step(bucket)); n < kLongBuckets; ++n) sum += long_buckets_[n];
    return sum;
  }

  /// [s] The upper edge of the bucket below which a fraction of all durations lies. It is at most 1 us too large up to
  /// 2 ms, at most 4.5 % too large above, and never more than the maximum.  @param fraction [1] 0 ... 1
  [[nodiscard]] double quantile(double fraction) const {
    const auto wanted = std::uint64_t(std::ceil(std::clamp(fraction, 0.0, 1.0) * double(count_)));
    std::uint64_t seen = 0;
    for (std::size_t n = 0; n < kBuckets; ++n) {
      seen += buckets_[n];
      if (seen >= wanted && seen > 0) return std::min(max_, kBucketWidth * double(n + 1));
    }
    for (std::size_t n = 0; n + 1 < kLongBuckets; ++n) {
      seen += long_buckets_[n];
      if (seen >= wanted && seen > 0)
        return std::min(max_, kBucketWidth * double(kBuckets) * std::exp2(double(n + 1) / kStepsOfOctave));
    }
    return max_;
  }

 private:
  static constexpr std::size_t kLongBuckets = 257;  // the last bucket is unbounded
  static constexpr double kStepsOfOctave = 16;      // [1] 2^(1/16) = 1.044

  static double long_step(double bucket) noexcept { return kStepsOfOctave * std::log2(bucket / double(kBuckets)); }

  std::array<std::uint64_t, kBuckets> buckets_{};
  std::array<std::uint64_t, kLongBuckets> long_buckets_{};
  std::uint64_t longer_ = 0, count_ = 0;
  double sum_ = 0, min_ = HUGE_VAL, max_ = 0;
};

}  // namespace hapticut
