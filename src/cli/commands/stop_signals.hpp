// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <csignal>

namespace hapticut::cli {

/// While it lives, SIGINT (Ctrl-C), SIGTERM and SIGHUP do not end the program but are remembered, so that it can end a
/// run and still write its report. A device that runs takes them first, and passes them on when it has no force any
/// more. One at a time.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// The last signal that came; 0: no signal yet.
  [[nodiscard]] static int came() noexcept;

 private:
  static constexpr std::array<int, 3> kSignals = {SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, kSignals.size()> before_{};
};

}  // namespace hapticut::cli
