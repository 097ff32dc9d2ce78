// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <utility>
#include <vector>

namespace hapticut {

/// A bounded queue of things that are moved and not copied, from one thread to one other.
/// @realtime no allocation after construction, no lock, when moving a T is so and a moved-from T owns nothing
template <class T>
class HandoverRing {
 public:
  /// @param capacity  things under way at once
  explicit HandoverRing(std::size_t capacity) : places_(capacity + 1) {}
  HandoverRing(const HandoverRing&) = delete;
  HandoverRing& operator=(const HandoverRing&) = delete;

  /// For the giving thread.  @return false when there is no room; `thing` is then as it was
  bool push(T&& thing) noexcept {
    const std::size_t last = last_.load(std::memory_order_relaxed), next = (last + 1) % places_.size();
    if (next == first_.load(std::memory_order_acquire)) return false;
    places_[last] = std::move(thing);
    last_.store(next, std::memory_order_release);
    return true;
  }

  /// For the giving thread: whether `push` will find room.
  [[nodiscard]] bool has_room() const noexcept {
    return (last_.load(std::memory_order_relaxed) + 1) % places_.size() != first_.load(std::memory_order_acquire);
  }

  /// For the taking thread.  @return false when there is nothing
  bool pop(T& thing) noexcept {
    const std::size_t first = first_.load(std::memory_order_relaxed);
    if (first == last_.load(std::memory_order_acquire)) return false;
    thing = std::move(places_[first]);
    first_.store((first + 1) % places_.size(), std::memory_order_release);
    return true;
  }

 private:
  std::vector<T> places_;  // one more than may be full
  std::atomic<std::size_t> first_{0}, last_{0};
};

}  // namespace hapticut
