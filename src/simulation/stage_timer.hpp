// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace hapticut {

/// Adds the time from its construction to its destruction to a sum. Without a sum it does nothing and reads no clock.
class StageTimer {
 public:
  /// @param sum  [s] or null
  explicit StageTimer(double* sum) noexcept : sum_(sum) {
    if (sum_ != nullptr) begin_ = std::chrono::steady_clock::now();
  }
  ~StageTimer() {
    if (sum_ != nullptr) *sum_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  double* sum_;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace hapticut
