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

namespace hapticut::cli {

/// A bar on stderr, drawn at once and wiped away when the work is done; nothing at all when stderr is not a terminal. A
/// thread of its own keeps drawing it, so that it goes on while one long call works.
class ProgressBar {
 public:
  /// @param total  of what is counted; 0: unknown, so the bar shows the seconds that have passed
  explicit ProgressBar(std::string what, std::size_t total = 0);
  ~ProgressBar();  ///< wipes the bar away
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void advance_to(std::size_t done) noexcept { done_.store(done, std::memory_order_relaxed); }

  /// Wipes the bar away and draws none while the returned lock is held: for printing lines in between.
  [[nodiscard]] std::unique_lock<std::mutex> pause();

 private:
  void run();
  void draw();
  void wipe();

  const std::string what_;
  const std::size_t total_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::atomic<std::size_t> done_{0};

  std::mutex mutex_;  // of what follows, and of stderr
  std::condition_variable wake_;
  bool finished_ = false;
  bool drawn_ = false;
  std::thread drawer_;  // on a terminal only
};

/// Says on stderr what making a workpiece has to say: how much work begins, where it takes more than some seconds, and
/// what of the file a user must know.
void tell_on_stderr(settings::WorkpieceSettings& workpiece);

/// What `make` makes of a source, with a bar while it does.
template <class Make>
auto with_bar(const std::string& source, const Make& make) {
  const ProgressBar bar("making the workpiece of " + source);
  return make();
}

}  // namespace hapticut::cli
