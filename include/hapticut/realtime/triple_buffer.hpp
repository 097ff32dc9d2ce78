// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace hapticut {

/// The latest value of one writer for one reader, without a lock: neither ever waits, and the reader never sees half a
/// value. Values in between are lost, which is what a picture on a screen wants.
///
/// Three copies: one being written, one being read, one in between. The byte `middle_` says which is in between, and
/// whether it is newer than what the reader has.
/// @realtime no allocation after construction, no lock, when assigning a T is so
template <typename T>
class TripleBuffer {
 public:
  explicit TripleBuffer(const T& initial = {}) { copies_.fill(initial); }
  TripleBuffer(const TripleBuffer&) = delete;
  TripleBuffer& operator=(const TripleBuffer&) = delete;

  /// The writer's copy, to be filled and published. It holds an old value.
  [[nodiscard]] T& writing() noexcept { return copies_[writing_]; }

  /// Makes the writer's copy the latest.
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
