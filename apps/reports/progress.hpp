// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <thread>

#include "settings/workpiece_settings.hpp"

namespace hapticut::apps {

/// A progress bar on stderr, drawn immediately and erased when the work is done. Without a terminal it draws nothing. A
/// separate thread redraws it, so it continues during one long call.
class ProgressBar {
 public:
  /// @param total  number of units of work; 0: unknown, so the bar shows the elapsed seconds
  explicit ProgressBar(std::string what, std::size_t total = 0);
  ~ProgressBar();  ///< erases the bar
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void advance_to(std::size_t done) noexcept { done_.store(done, std::memory_order_relaxed); }

  /// Erases the bar and stops drawing while the returned lock is held, for printing lines.
  [[nodiscard]] std::unique_lock<std::mutex> pause();

 private:
  void run();
  void draw();
  void wipe();

  const std::string what_;
  const std::size_t total_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::atomic<std::size_t> done_{0};

  std::mutex mutex_;  // guards the following members and stderr
  std::condition_variable wake_;
  bool finished_ = false;
  bool drawn_ = false;
  std::thread drawer_;  // only on a terminal
};

/// Prints messages about making a workpiece to stderr: the amount of work if it takes more than some seconds, and
/// remarks about the file.
void tell_on_stderr(settings::WorkpieceSettings& workpiece);

/// The result of `make`, with a progress bar meanwhile.
template <class Make>
auto with_bar(const std::string& source, const Make& make) {
  const ProgressBar bar("making the workpiece of " + source);
  return make();
}

}  // namespace hapticut::apps
