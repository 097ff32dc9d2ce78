// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

/// @file
/// Ends long set-up calls early, such as the builders of workpieces, for a front end that has a Ctrl-C of its own.
namespace hapticut {

/// Ends a call that is not wanted any more. It is no std::exception, so nothing on the way turns it into an Error.
struct Interrupted {};

/// While it lives, long calls in its thread ask from time to time whether they are still wanted.
///
/// Loops over blocks, slices, triangles or ticks call `look_for_interruption`. In a parallel loop only the thread that
/// began it asks. Other threads, and threads without a scope, pay for a comparison.
class InterruptionScope {
 public:
  /// @param wanted  returns true when the present call is to end; asked at most every kPeriod
  explicit InterruptionScope(std::function<bool()> wanted);
  ~InterruptionScope();
  InterruptionScope(const InterruptionScope&) = delete;
  InterruptionScope& operator=(const InterruptionScope&) = delete;

  static constexpr double kPeriod = 0.1;  ///< [s]

 private:
  friend void look_for_interruption();
  std::function<bool()> wanted_;
  double next_;               // [s] next time to look, by the monotonic clock
  InterruptionScope* outer_;  // outer scope of the same thread
};

/// @throws Interrupted when the scope of this thread wants it
void look_for_interruption();

}  // namespace hapticut
