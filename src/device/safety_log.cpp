// SPDX-License-Identifier: Apache-2.0
#include "hapticut/device/safety_log.hpp"

#include <algorithm>
#include <boost/lockfree/spsc_queue.hpp>

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

constexpr std::size_t kCapacity = 1024;

constexpr std::array<std::string_view, kSafetyEvents> kNames = {"pose_not_finite",
                                                                "pose_not_a_rotation",
                                                                "pose_outside_workspace",
                                                                "pose_jump",
                                                                "pose_turn_jump",
                                                                "pose_frozen",
                                                                "pose_units",
                                                                "reading_invalid",
                                                                "reading_stale",
                                                                "armed",
                                                                "waiting_free",
                                                                "start_inside",
                                                                "fading_in",
                                                                "engaged",
                                                                "fault",
                                                                "fault_reset",
                                                                "recalibrated",
                                                                "reclutched",
                                                                "model_swapped",
                                                                "late_wake_up",
                                                                "paused",
                                                                "force_not_finite",
                                                                "passivity",
                                                                "saturated",
                                                                "slew_limited",
                                                                "continuous_limited",
                                                                "motors_warm",
                                                                "device_fault",
                                                                "watchdog_late",
                                                                "watchdog_fading",
                                                                "watchdog_fault",
                                                                "exception",
                                                                "emergency_stop"};

}  // namespace

struct SafetyLog::Ring {
  boost::lockfree::spsc_queue<SafetyLogEntry, boost::lockfree::capacity<kCapacity>> entries;
};

std::string_view name(SafetyEvent event) {
  return event < SafetyEvent::count ? kNames[std::size_t(event)] : std::string_view("unknown");
}

SafetyLog::SafetyLog() : ring_(std::make_unique<Ring>()) {}
SafetyLog::~SafetyLog() = default;

void SafetyLog::begin_tick(double time, std::uint64_t sequence) noexcept {
  ++tick_;
  time_.store(time, std::memory_order_relaxed);
  sequence_.store(sequence, std::memory_order_relaxed);
}

void SafetyLog::report(SafetyEvent event, double value) noexcept {
  const auto n = std::size_t(event);
  counts_[n].fetch_add(1, std::memory_order_relaxed);
  const bool began = last_tick_[n] + 1 < tick_;
  last_tick_[n] = tick_;
  if (!began) return;
  const SafetyLogEntry entry = {time_.load(std::memory_order_relaxed), sequence_.load(std::memory_order_relaxed), event,
                                value};
  if (!ring_->entries.push(entry)) dropped_.fetch_add(1, std::memory_order_relaxed);
}

void SafetyLog::note(SafetyEvent event, double value) {
  counts_[std::size_t(event)].fetch_add(1, std::memory_order_relaxed);
  const std::lock_guard lock(readers_);
  if (noted_.size() < kCapacity)
    noted_.push_back({time_.load(std::memory_order_relaxed), sequence_.load(std::memory_order_relaxed), event, value});
  else
    dropped_.fetch_add(1, std::memory_order_relaxed);
}

std::uint64_t SafetyLog::count(SafetyEvent event) const noexcept {
  return counts_[std::size_t(event)].load(std::memory_order_relaxed);
}

std::vector<SafetyLogEntry> SafetyLog::drain() {
  const std::lock_guard lock(readers_);
  std::vector<SafetyLogEntry> entries;
  ring_->entries.consume_all([&](const SafetyLogEntry& entry) { entries.push_back(entry); });
  entries.insert(entries.end(), noted_.begin(), noted_.end());
  noted_.clear();
  std::stable_sort(entries.begin(), entries.end(),
                   [](const SafetyLogEntry& a, const SafetyLogEntry& b) { return a.sequence < b.sequence; });
  return entries;
}

std::string describe(const SafetyLogEntry& entry) {
  return format_number(entry.time) + " s: " + std::string(name(entry.event)) + " (" + format_number(entry.value) + ")";
}

}  // namespace hapticut
