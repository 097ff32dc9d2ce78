// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <type_traits>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/workpiece/workpiece.hpp"
#include "interruption.hpp"

namespace hapticut::python {

/// Tracks which threads use a C++ object while the interpreter lock is released. Access it only with the lock held.
class Occupancy {
 public:
  void require_readable(const char* what) const {
    if (writing_)
      throw Error(std::string(what) +
                  " is in use by another thread; wait until that thread has finished, or stop its loop.");
  }
  void require_writable(const char* what) const {
    require_readable(what);
    if (readers_ > 0)
      throw Error(std::string(what) +
                  " is being read by another thread; wait until that thread has finished, or stop its loop.");
  }

 private:
  friend class ReleasedReading;
  friend class ReleasedWriting;
  friend class PythonLoop;
  Occupancy& begin_reading() {
    ++readers_;
    return *this;
  }
  Occupancy& begin_writing() {
    writing_ = true;
    return *this;
  }
  int readers_ = 0;
  bool writing_ = false;
};

/// Releases the interpreter lock while an object is read; ReleasedLock says how Ctrl-C ends the call.
class ReleasedReading {
 public:
  explicit ReleasedReading(Occupancy& occupancy) : occupancy_(occupancy.begin_reading()) {}
  ~ReleasedReading() {
    lock_.acquire();
    --occupancy_.readers_;
  }
  ReleasedReading(const ReleasedReading&) = delete;
  ReleasedReading& operator=(const ReleasedReading&) = delete;

 private:
  Occupancy& occupancy_;
  ReleasedLock lock_;  // released after the occupancy has changed
};

/// Releases the interpreter lock while an object is changed; ReleasedLock says how Ctrl-C ends the call.
class ReleasedWriting {
 public:
  explicit ReleasedWriting(Occupancy& occupancy) : occupancy_(occupancy.begin_writing()) {}
  ~ReleasedWriting() {
    lock_.acquire();
    occupancy_.writing_ = false;
  }
  ReleasedWriting(const ReleasedWriting&) = delete;
  ReleasedWriting& operator=(const ReleasedWriting&) = delete;

 private:
  Occupancy& occupancy_;
  ReleasedLock lock_;
};

class PythonSimulation;

/// A workpiece in Python: owned, or a read-only view of a simulation's workpiece. A view keeps the simulation alive and
/// always shows its present workpiece, also after a reset.
class PythonWorkpiece {
 public:
  explicit PythonWorkpiece(Workpiece workpiece)
      : own_(std::make_unique<Workpiece>(std::move(workpiece))), own_occupancy_(std::make_unique<Occupancy>()) {}
  explicit PythonWorkpiece(std::shared_ptr<PythonSimulation> simulation) : simulation_(std::move(simulation)) {}

  /// @throws Error while another thread changes it
  [[nodiscard]] const Workpiece& read() const;

  /// @throws Error when it belongs to a simulation, or another thread uses it
  [[nodiscard]] Workpiece& write();

  [[nodiscard]] Occupancy& occupancy() const;

  /// Calls `function(workpiece)` without the interpreter lock.
  template <class Function>
  auto read_released(const Function& function) const {
    const Workpiece& workpiece = read();
    const ReleasedReading released(occupancy());
    return function(workpiece);
  }

 private:
  std::unique_ptr<Workpiece> own_;
  std::unique_ptr<Occupancy> own_occupancy_;
  std::shared_ptr<PythonSimulation> simulation_;
};

/// Calls a function that makes a workpiece, without the interpreter lock.
template <class Function>
PythonWorkpiece make_released(const Function& function) {
  const ReleasedLock released;
  return PythonWorkpiece(function());
}

/// A function of C++ that makes a workpiece, as Python calls it.
template <class... Given>
auto making(Workpiece (*make)(Given...)) {
  return [make](const std::remove_cvref_t<Given>&... given) { return make_released([&] { return make(given...); }); };
}

/// Wraps a const C++ method for the Python holder, through `Holder::read`.
template <class Holder, class Object, class Result, class... Given>
auto reading(Result (Object::*method)(Given...) const) {
  return [method](const Holder& self, Given... given) { return (self.read().*method)(std::forward<Given>(given)...); };
}

/// Wraps a mutating C++ method for the Python holder, through `Holder::write`.
template <class Holder, class Object, class Result, class... Given>
auto writing(Result (Object::*method)(Given...)) {
  return [method](Holder& self, Given... given) { return (self.write().*method)(std::forward<Given>(given)...); };
}

}  // namespace hapticut::python
