// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <utility>

#include "core/interruption.hpp"

/// @file
/// Ctrl-C in long calls of C++: Python notes the signal at once, but runs its handler only when it is asked.
namespace hapticut::python {

/// Ends a long call when a signal handler raises, usually KeyboardInterrupt. Only Python's main thread runs handlers;
/// in other threads it does nothing. A guard for pybind11::call_guard, for calls that keep the interpreter lock.
class SignalChecks {
 public:
  SignalChecks();  ///< with the interpreter lock
  ~SignalChecks();
  SignalChecks(const SignalChecks&) = delete;
  SignalChecks& operator=(const SignalChecks&) = delete;

 private:
  std::optional<pybind11::error_already_set> raised_;  // by a handler; becomes the error of the call
  std::optional<InterruptionScope> scope_;
};

/// Releases the interpreter lock, and ends the call when a signal handler raises.
class ReleasedLock {
 public:
  ReleasedLock() = default;
  ~ReleasedLock() { acquire(); }
  ReleasedLock(const ReleasedLock&) = delete;
  ReleasedLock& operator=(const ReleasedLock&) = delete;

  /// Acquires the lock again. Must be called in the thread that released it.
  void acquire() {
    if (state_ != nullptr) PyEval_RestoreThread(std::exchange(state_, nullptr));
  }

 private:
  SignalChecks checks_;  // destroyed last, with the lock
  PyThreadState* state_ = PyEval_SaveThread();
};

/// Makes Interrupted the error that a handler raised.
void translate_interruptions();

}  // namespace hapticut::python
