// SPDX-License-Identifier: Apache-2.0
#include "support/allocation_count.hpp"

#include <pthread.h>

#include <cerrno>
#include <cstddef>

// glibc's own allocators, which the replacements below forward to.
extern "C" {
void* __libc_malloc(std::size_t size);
void __libc_free(void* p);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* p, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
int __pthread_mutex_lock(pthread_mutex_t* mutex) __attribute__((weak));
}

namespace hapticut::test {
namespace {

// The TLS model is initial-exec, because reading the counters must not allocate.
__attribute__((tls_model("initial-exec"))) thread_local bool armed = false;
__attribute__((tls_model("initial-exec"))) thread_local CallCounts counts;

void count_allocation() {
  if (armed) ++counts.allocations;
}

}  // namespace

void arm_call_counts() {
  counts = {};
  armed = true;
}

CallCounts disarm_call_counts() {
  armed = false;
  return counts;
}

}  // namespace hapticut::test

using hapticut::test::armed;
using hapticut::test::count_allocation;
using hapticut::test::counts;

extern "C" {

void* malloc(std::size_t size) {
  count_allocation();
  return __libc_malloc(size);
}
void free(void* p) {
  if (armed && p != nullptr) ++counts.deallocations;
  __libc_free(p);
}
void* calloc(std::size_t count, std::size_t size) {
  count_allocation();
  return __libc_calloc(count, size);
}
void* realloc(void* p, std::size_t size) {
  count_allocation();
  return __libc_realloc(p, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
  count_allocation();
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  count_allocation();
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** out, std::size_t alignment, std::size_t size) {
  count_allocation();
  *out = __libc_memalign(alignment, size);
  return *out == nullptr ? ENOMEM : 0;
}
int pthread_mutex_lock(pthread_mutex_t* mutex) {
  if (armed) ++counts.locks;
  return __pthread_mutex_lock != nullptr ? __pthread_mutex_lock(mutex) : pthread_mutex_trylock(mutex);
}
}
