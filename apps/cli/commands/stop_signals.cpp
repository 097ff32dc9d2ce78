// SPDX-License-Identifier: Apache-2.0
#include "cli/commands/stop_signals.hpp"

#include <atomic>

namespace hapticut::apps {
namespace {

std::atomic<int> last_signal{0};
static_assert(std::atomic<int>::is_always_lock_free);  // required in a signal handler

extern "C" void hapticut_remember_signal(int signal) { last_signal.store(signal); }

}  // namespace

StopSignals::StopSignals() {
  last_signal.store(0);
  struct sigaction action {};
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  action.sa_handler = hapticut_remember_signal;
  for (std::size_t n = 0; n < kSignals.size(); ++n) {
    sigaction(kSignals[n], nullptr, &before_[n]);
    // Signals that the shell ignores, e.g. through nohup, stay ignored.
    if (before_[n].sa_handler != SIG_IGN) sigaction(kSignals[n], &action, nullptr);
  }
}

StopSignals::~StopSignals() {
  for (std::size_t n = 0; n < kSignals.size(); ++n) sigaction(kSignals[n], &before_[n], nullptr);
}

int StopSignals::came() noexcept { return last_signal.load(); }

}  // namespace hapticut::apps
