// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <utility>
#include <vector>

namespace hapticut {

/// A bounded queue from one thread to one other. It moves its items and does not copy them.
/// @realtime no allocation after construction and no lock, if moving a T does neither and a moved-from T owns nothing
template <class T>
class HandoverRing {
 public:
  /// @param capacity  [items]
  explicit HandoverRing(std::size_t capacity) : places_(capacity + 1) {}
  HandoverRing(const HandoverRing&) = delete;
  HandoverRing& operator=(const HandoverRing&) = delete;

  /// For the sending thread.  @return false when the queue is full; `item` is then unchanged
  bool push(T&& item) noexcept {
    const std::size_t last = last_.load(std::memory_order_relaxed), next = (last + 1) % places_.size();
    if (next == first_.load(std::memory_order_acquire)) return false;
    places_[last] = std::move(item);
    last_.store(next, std::memory_order_release);
    return true;
  }

  /// For the sending thread: whether `push` will succeed.
  [[nodiscard]] bool has_room() const noexcept {
    return (last_.load(std::memory_order_relaxed) + 1) % places_.size() != first_.load(std::memory_order_acquire);
  }

  /// For the receiving thread.  @return false when the queue is empty
  bool pop(T& item) noexcept {
    const std::size_t first = first_.load(std::memory_order_relaxed);
    if (first == last_.load(std::memory_order_acquire)) return false;
    item = std::move(places_[first]);
    first_.store((first + 1) % places_.size(), std::memory_order_release);
    return true;
  }

 private:
  std::vector<T> places_;  // one place is always empty
  std::atomic<std::size_t> first_{0}, last_{0};
};

}  // namespace hapticut
