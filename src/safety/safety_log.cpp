// SPDX-License-Identifier: Apache-2.0
#include "hapticut/safety/safety_log.hpp"

#include <algorithm>
#include <boost/lockfree/spsc_queue.hpp>

#include "hapticut/core/errors.hpp"
#include "hapticut/safety/device_state.hpp"

namespace hapticut {
namespace {

constexpr std::size_t kCapacity = 1024;

}  // namespace

struct SafetyLog::Ring {
  boost::lockfree::spsc_queue<Dated, boost::lockfree::capacity<kCapacity>> entries;
};

std::string_view name_of(SafetyEvent event) {
  const char* known = name_or_null(event);
  return known != nullptr ? known : "unknown";
}

SafetyLog::SafetyLog() : ring_(std::make_unique<Ring>()) {}
SafetyLog::~SafetyLog() = default;

void SafetyLog::begin_tick(double time, std::uint64_t sequence) noexcept {
  tick_.fetch_add(1, std::memory_order_relaxed);
  time_.store(time, std::memory_order_relaxed);
  sequence_.store(sequence, std::memory_order_relaxed);
}

void SafetyLog::report(SafetyEvent event, double value) noexcept {
  const auto n = std::size_t(event);
  const std::uint64_t before = counts_[n].fetch_add(1, std::memory_order_relaxed);
  const std::uint64_t tick = tick_.load(std::memory_order_relaxed);
  constexpr std::uint64_t kQuiet = 100;  // ticks
  const bool goes_on = event == SafetyEvent::reading_stale && before > 0 && last_tick_[n] + kQuiet >= tick;
  const bool began = last_tick_[n] + 1 < tick && !goes_on;
  last_tick_[n] = tick;
  if (began && !ring_->entries.push(dated(event, value))) dropped_.fetch_add(1, std::memory_order_relaxed);
}

void SafetyLog::note(SafetyEvent event, double value) {
  counts_[std::size_t(event)].fetch_add(1, std::memory_order_relaxed);
  const std::lock_guard lock(readers_);
  if (noted_.size() < kCapacity)
    noted_.push_back(dated(event, value));
  else
    dropped_.fetch_add(1, std::memory_order_relaxed);
}

SafetyLog::Dated SafetyLog::dated(SafetyEvent event, double value) const noexcept {
  constexpr auto kOrder = std::memory_order_relaxed;
  return {tick_.load(kOrder), {time_.load(kOrder), sequence_.load(kOrder), event, value}};
}

std::uint64_t SafetyLog::count(SafetyEvent event) const noexcept {
  return counts_[std::size_t(event)].load(std::memory_order_relaxed);
}

std::vector<SafetyLogEntry> SafetyLog::drain() {
  const std::lock_guard lock(readers_);
  std::vector<Dated> all;
  ring_->entries.consume_all([&](const Dated& entry) { all.push_back(entry); });
  all.insert(all.end(), noted_.begin(), noted_.end());
  noted_.clear();
  // Not by the device's sequence numbers: a stale reading repeats them, and a new connection restarts them.
  std::stable_sort(all.begin(), all.end(), [](const Dated& a, const Dated& b) { return a.tick < b.tick; });
  std::vector<SafetyLogEntry> entries;
  entries.reserve(all.size());
  for (const Dated& dated : all) entries.push_back(dated.entry);
  return entries;
}

std::string sentence_of(const SafetyLogEntry& entry) {
  std::string sentence;
  for (const Named<SafetyEvent>& one : names_of(Of<SafetyEvent>{}))
    if (one.value == entry.event) sentence = one.words;
  if (entry.event == SafetyEvent::device_fault) sentence += ": " + describe(DeviceFault(int(entry.value))) + ".";
  if (entry.event == SafetyEvent::other_period) sentence += " Now: " + format_number(entry.value) + " s.";
  if (entry.event == SafetyEvent::slow_readings) sentence += " Now: " + format_number(entry.value) + " Hz.";
  return sentence;
}

std::string describe(const SafetyLogEntry& entry) {
  return format_number(entry.time) + " s: " + std::string(name_of(entry.event)) + " (" + format_number(entry.value) +
         "). " + sentence_of(entry);
}

}  // namespace hapticut
