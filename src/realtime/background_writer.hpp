// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <boost/lockfree/spsc_queue.hpp>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace hapticut {

/// Messages from a loop to a thread of its own that writes them somewhere: bounded, without a lock on the loop's side.
/// What is written to, and how, is the sink's affair; it may throw, and then the writing is over.
///
/// One thread pushes; the sink is called in the writer's thread.
template <class Message>
class BackgroundWriter {
 public:
  struct Sink {
    std::function<void(const std::vector<Message>& batch)> write;  ///< never empty
    std::function<void()> flush;                                   ///< about once a period, and at the end
  };
  static constexpr std::size_t kBatch = 1024;  ///< messages given to the sink at once

  /// @param capacity  of messages under way
  /// @param example   written once into every place of the ring, so that the loop never touches a page first
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

  /// @return false when there is no room
  /// @realtime no allocation, no lock
  bool push(const Message& message) noexcept { return ring_.push(message); }

  [[nodiscard]] bool failed() const noexcept { return failed_.load(std::memory_order_acquire); }
  [[nodiscard]] bool running() const noexcept { return thread_.joinable(); }

  /// Writes what is left, and ends.  @return what the sink threw, in words; empty: nothing
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

 private:
  void run(double flush_period) {
    using Clock = std::chrono::steady_clock;
    constexpr auto kPoll = std::chrono::milliseconds(5);  // between looks at the ring
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
    } catch (const std::exception& error) {
      fail(error.what());
    } catch (...) {
      fail("something unknown was thrown");
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
  std::thread thread_;
};

}  // namespace hapticut
