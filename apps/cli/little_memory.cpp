// SPDX-License-Identifier: Apache-2.0
#include "cli/little_memory.hpp"

#include <signal.h>  // NOLINT(modernize-deprecated-headers): <csignal> need not have sigaction
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

#include "core/lack_of_memory.hpp"

namespace hapticut::apps {
namespace {

constexpr std::size_t kReserve = std::size_t(16) << 20U;  // [bytes] address space alone: its pages are never touched
std::atomic<void*> reserve{nullptr};
std::terminate_handler usual_end = nullptr;

void on_no_memory() {
  std::free(reserve.exchange(nullptr));
  throw std::bad_alloc();
}

bool is_no_memory(const std::exception_ptr& exception) {
  try {
    if (exception) std::rethrow_exception(exception);
  } catch (const std::exception& error) {
    return is_lack_of_memory(error);
  } catch (...) {
  }
  return false;
}

/// Whether crash handlers stop a device, see device/running_loops.cpp.
bool a_device_runs() {
  struct sigaction on_abort {};
  return sigaction(SIGABRT, nullptr, &on_abort) == 0 && on_abort.sa_handler != SIG_DFL;
}

[[noreturn]] void on_terminate() {
  if (is_no_memory(std::current_exception()) && !a_device_runs()) {
    for (const char* part : {"hapticut: ", kNoMemory, "\n"})
      if (::write(STDERR_FILENO, part, std::strlen(part)) < 0) break;
    ::_exit(1);
  }
  usual_end();
  std::abort();
}

}  // namespace

void prepare_for_little_memory() {
  reserve = std::malloc(kReserve);  // without it, only the handlers help
  std::set_new_handler(on_no_memory);
  usual_end = std::set_terminate(on_terminate);
}

}  // namespace hapticut::apps
