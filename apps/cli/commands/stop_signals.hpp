// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <csignal>

namespace hapticut::apps {

/// While it lives, SIGINT (Ctrl-C), SIGTERM and SIGHUP are stored and do not end the program, so it can end a run and
/// write its report. A running device handles them first and passes them on when its force is zero. Only one object may
/// exist at a time.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// The last signal; 0: no signal yet.
  [[nodiscard]] static int came() noexcept;

 private:
  static constexpr std::array<int, 3> kSignals = {SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, kSignals.size()> before_{};
};

}  // namespace hapticut::apps
