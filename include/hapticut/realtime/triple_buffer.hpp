// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace hapticut {

/// Passes the latest value of one writer to one reader without a lock. Neither side ever waits, and the reader never
/// sees a partly written value. Intermediate values are lost, which suits a picture on a screen.
///
/// There are three copies: one for the writer, one for the reader, and one in the middle. The byte `middle_` stores the
/// index of the middle copy, and whether that copy is newer than the reader's.
/// @realtime no allocation after construction and no lock, if the assignment of T does neither
template <typename T>
class TripleBuffer {
 public:
  explicit TripleBuffer(const T& initial = {}) { copies_.fill(initial); }
  TripleBuffer(const TripleBuffer&) = delete;
  TripleBuffer& operator=(const TripleBuffer&) = delete;

  /// The writer's copy, to be filled in and published. It has an old value.
  [[nodiscard]] T& writing() noexcept { return copies_[writing_]; }

  /// Makes the writer's copy the latest value.
  void publish() noexcept { writing_ = middle_.exchange(writing_ | kFresh, std::memory_order_acq_rel) & kIndex; }

  void write(const T& value) noexcept {
    writing() = value;
    publish();
  }

  /// The latest published value, valid until the next call. For one reader thread.
  [[nodiscard]] const T& latest() noexcept {
    if ((middle_.load(std::memory_order_relaxed) & kFresh) != 0)
      reading_ = middle_.exchange(reading_, std::memory_order_acq_rel) & kIndex;
    return copies_[reading_];
  }

 private:
  static constexpr std::uint8_t kIndex = 3, kFresh = 4;
  std::array<T, 3> copies_;
  std::uint8_t writing_ = 0;
  std::atomic<std::uint8_t> middle_{1};
  std::uint8_t reading_ = 2;
};

}  // namespace hapticut
