// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <boost/lockfree/spsc_queue.hpp>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <new>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace hapticut {

/// A bounded queue of messages from a loop to a background thread that writes them. The loop's side takes no lock.
/// A sink decides where and how the messages are written. If the sink throws, the writing ends.
///
/// One thread pushes. The background thread calls the sink.
template <class Message>
class BackgroundWriter {
 public:
  struct Sink {
    std::function<void(const std::vector<Message>& batch)> write;  ///< `batch` is never empty
    std::function<void()> flush;                                   ///< called about once a period, and at the end
  };
  static constexpr std::size_t kBatch = 1024;  ///< largest number of messages per call of `write`

  /// @param capacity      [messages] in the queue
  /// @param example       written once into every place of the ring, so that the loop causes no page faults
  /// @param flush_period  [s]
  BackgroundWriter(std::size_t capacity, const Message& example, double flush_period, Sink sink)
      : ring_(capacity), sink_(std::move(sink)) {
    while (ring_.push(example)) {
    }
    ring_.consume_all([](const Message&) {});
    thread_ = std::thread([this, flush_period] { run(flush_period); });
  }
  ~BackgroundWriter() { stop(); }
  BackgroundWriter(const BackgroundWriter&) = delete;
  BackgroundWriter& operator=(const BackgroundWriter&) = delete;

  /// @return false when the queue is full
  /// @realtime no allocation, no lock
  bool push(const Message& message) noexcept { return ring_.push(message); }

  [[nodiscard]] bool failed() const noexcept { return failed_.load(std::memory_order_acquire); }
  [[nodiscard]] bool running() const noexcept { return thread_.joinable(); }

  /// Writes the remaining messages and ends the thread.  @return the message of what the sink threw; empty if nothing
  const std::string& stop() {
    if (thread_.joinable()) {
      {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
      }
      wake_.notify_one();
      thread_.join();
    }
    return failure_;
  }
  /// Whether the sink failed for lack of memory. Ask after `stop`.
  [[nodiscard]] bool lacked_memory() const noexcept { return lacked_memory_; }

 private:
  void run(double flush_period) {
    using Clock = std::chrono::steady_clock;
    constexpr auto kPoll = std::chrono::milliseconds(5);  // between two checks of the ring
    try {
      const auto period = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(flush_period));
      Clock::time_point next_flush = Clock::now() + period;
      std::vector<Message> batch;
      batch.reserve(kBatch);
      for (bool last = false, empty = true; !last || !empty;) {
        if (empty) {
          std::unique_lock lock(mutex_);
          if (ring_.read_available() == 0) wake_.wait_for(lock, kPoll, [this] { return stopping_; });
          last = stopping_;
        }
        batch.clear();
        while (batch.size() < kBatch && ring_.consume_one([&](const Message& m) { batch.push_back(m); })) {
        }
        empty = batch.empty();
        if (!empty) sink_.write(batch);
        if ((last && empty) || Clock::now() >= next_flush) {
          sink_.flush();
          next_flush = Clock::now() + period;
        }
      }
    } catch (const std::bad_alloc&) {
      lacked_memory_ = true;
      fail("there is not enough memory");
    } catch (const std::exception& error) {
      fail(error.what());
    } catch (...) {
      fail("an unknown exception was thrown");
    }
  }

  void fail(std::string why) {
    failure_ = std::move(why);
    failed_.store(true, std::memory_order_release);
  }

  boost::lockfree::spsc_queue<Message> ring_;
  Sink sink_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool stopping_ = false;
  std::atomic<bool> failed_{false};
  std::string failure_;
  bool lacked_memory_ = false;
  std::thread thread_;
};

}  // namespace hapticut
