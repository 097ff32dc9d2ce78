// SPDX-License-Identifier: Apache-2.0
#include "core/interruption.hpp"

#include <chrono>
#include <utility>

namespace hapticut {
namespace {

thread_local InterruptionScope* scope_of_thread = nullptr;

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

InterruptionScope::InterruptionScope(std::function<bool()> wanted)
    : wanted_(std::move(wanted)), next_(seconds_now() + kPeriod), outer_(std::exchange(scope_of_thread, this)) {}

InterruptionScope::~InterruptionScope() { scope_of_thread = outer_; }

void look_for_interruption() {
  InterruptionScope* scope = scope_of_thread;
  if (scope == nullptr) return;
  const double now = seconds_now();
  if (now < scope->next_) return;
  scope->next_ = now + InterruptionScope::kPeriod;
  if (scope->wanted_()) throw Interrupted{};
}

}  // namespace hapticut
