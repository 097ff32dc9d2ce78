// SPDX-License-Identifier: Apache-2.0
#include "interruption.hpp"

namespace hapticut::python {

namespace py = pybind11;

namespace {

bool in_main_thread() {
  const py::object main = py::module_::import("threading").attr("main_thread")();
  return main.attr("ident").cast<unsigned long>() == PyThread_get_thread_ident();
}

}  // namespace

SignalChecks::SignalChecks() {
  if (!in_main_thread()) return;  // it would compete for the lock without need
  scope_.emplace([this] {
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() == 0) return false;
    raised_.emplace();
    return true;
  });
}

SignalChecks::~SignalChecks() {
  if (raised_) raised_->restore();
}

void translate_interruptions() {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Interrupted&) {
      // ~SignalChecks has set the error.
    }
  });
}

}  // namespace hapticut::python
