// SPDX-License-Identifier: Apache-2.0
#include "hapticut/realtime/realtime.hpp"

#include <malloc.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <ctime>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

constexpr std::int64_t kNanoseconds = 1'000'000'000;

static_assert(range_of(&RealtimeOptions::cpu).high == CPU_SETSIZE - 1);

std::atomic<int> memory_locks{0};

std::int64_t nanoseconds() noexcept {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return std::int64_t(t.tv_sec) * kNanoseconds + t.tv_nsec;
}

// Writes to every page of the stack that the loop will use. Not inlined, because the array needs its own stack frame.
__attribute__((noinline)) void touch_stack(std::size_t bytes) {
  constexpr std::size_t kChunk = 16 * 1024;
  volatile char chunk[kChunk];
  for (std::size_t n = 0; n < kChunk; n += 1024) chunk[n] = 0;
  if (bytes > kChunk) touch_stack(bytes - kChunk);
  chunk[0] = chunk[kChunk - 1];  // after the call, which prevents a tail call
}

#if defined(__SSE2__)
constexpr unsigned kFlushToZero = 0x8000, kDenormalsAreZero = 0x0040;
#endif

}  // namespace

RealtimeScope::RealtimeScope(const RealtimeOptions& options) {
  require_fields_within(options, "RealtimeOptions::");
  if (options.lock_memory) lock_memory();
  if (options.cpu >= 0) pin(options.cpu);
  if (options.priority > 0) set_priority(options.priority);
  if (options.stack > 0) touch_stack(options.stack);
#if defined(__SSE2__)
  if (options.flush_denormals) {
    old_control_ = _mm_getcsr();
    _mm_setcsr(old_control_ | kFlushToZero | kDenormalsAreZero);
    flushing_ = true;
  }
#else
  if (options.flush_denormals) warnings_.emplace_back("This processor cannot flush denormal numbers to zero.");
#endif
}

RealtimeScope::~RealtimeScope() {
#if defined(__SSE2__)
  if (flushing_) _mm_setcsr(old_control_);
#endif
  if (scheduled_) {
    sched_param parameters{};
    parameters.sched_priority = old_priority_;
    pthread_setschedparam(pthread_self(), old_policy_, &parameters);
  }
  if (locked_ && --memory_locks == 0) munlockall();
}

void RealtimeScope::set_priority(int priority) {
  sched_param parameters{};
  pthread_getschedparam(pthread_self(), &old_policy_, &parameters);
  old_priority_ = parameters.sched_priority;
  parameters.sched_priority = priority;
  const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
  scheduled_ = error == 0;
  if (error != 0)
    warnings_.push_back("The loop runs without real-time priority (" + std::string(std::strerror(error)) +
                        "), so some ticks will be late; allow it with `ulimit -r " + std::to_string(priority) +
                        "`, a line `@haptics - rtprio " + std::to_string(priority) +
                        "` in /etc/security/limits.conf, or the capability CAP_SYS_NICE.");
}

void RealtimeScope::pin(int cpu) {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(std::size_t(cpu), &set);
  const int error = pthread_setaffinity_np(pthread_self(), sizeof set, &set);
  if (error != 0)
    warnings_.push_back("The loop could not be pinned to processor " + std::to_string(cpu) + " (" +
                        std::strerror(error) + "); cpu = -1 allows any processor.");
}

void RealtimeScope::lock_memory() {
  // With a finite limit, MCL_FUTURE would make later allocations fail instead of being slow.
  rlimit limit{};
  getrlimit(RLIMIT_MEMLOCK, &limit);
  const bool unlimited = limit.rlim_cur == RLIM_INFINITY || geteuid() == 0;
  locked_ = mlockall(unlimited ? MCL_CURRENT | MCL_FUTURE : MCL_CURRENT) == 0;
  if (locked_) {
    ++memory_locks;
#if defined(__GLIBC__)
    mallopt(M_TRIM_THRESHOLD, -1);
    mallopt(M_MMAP_MAX, 0);
#endif
  } else {
    warnings_.push_back(
        "The memory of the process could not be locked (" + std::string(std::strerror(errno)) +
        "), so a page fault may delay a tick; allow it with `ulimit -l unlimited` or a line `@haptics - "
        "memlock unlimited` in /etc/security/limits.conf.");
  }
}

PeriodicClock::PeriodicClock(double period) : period_(0), start_(nanoseconds()), next_(start_) {
  require_between(period, 1e-5, 10, "the period of a loop [s]");
  period_ = std::llround(period * double(kNanoseconds));
}

PeriodicClock::Tick PeriodicClock::wait() noexcept {
  next_ += period_;
  timespec wake{};
  wake.tv_sec = time_t(next_ / kNanoseconds);
  wake.tv_nsec = long(next_ % kNanoseconds);
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr) == EINTR) {
  }
  const std::int64_t now = nanoseconds();
  Tick tick;
  tick.late = double(now - next_) / double(kNanoseconds);
  tick.time = double(now - start_) / double(kNanoseconds);
  if (now - next_ > period_) {
    tick.missed = std::uint64_t((now - next_) / period_);
    next_ += std::int64_t(tick.missed) * period_;
  }
  return tick;
}

double PeriodicClock::now() const noexcept { return double(nanoseconds() - start_) / double(kNanoseconds); }

double monotonic_time() noexcept { return double(nanoseconds()) / double(kNanoseconds); }

}  // namespace hapticut
