// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include "hapticut/heat/heat_collector.hpp"
#include "hapticut/heat/heat_field.hpp"
#include "hapticut/view/protocol.hpp"

namespace hapticut::apps {

/// What pages show of a heat field: its cells, each in a byte; several cells in one if there are too many.
[[nodiscard]] view::Heat shown_heat(const HeatField& field);

/// The heat of a session, in a thread of its own.
class HeatWatch {
 public:
  /// Begins with the present workpiece at body temperature. Not during a run, as the destructor.
  /// @param simulation  must outlive it and must not be moved
  /// @throws Error as HeatField and HeatCollector
  HeatWatch(Simulation& simulation, const HeatConfig& config);
  ~HeatWatch();
  HeatWatch(const HeatWatch&) = delete;
  HeatWatch& operator=(const HeatWatch&) = delete;

  /// @param coefficient  [W/(m^2 K)] of the water from now on; 0: dry
  void set_irrigation(double coefficient);

  /// The newest temperatures, once, and only if a page would show them differently.
  /// @throws Error when the temperatures can no longer be computed
  [[nodiscard]] std::optional<view::Heat> take();

 private:
  void run();
  void advance();

  HeatCollector collector_;
  HeatField field_;
  view::Heat last_;  // of the thread, as `field_`

  std::mutex mutex_;  // guards the members below; the loop never locks it
  std::condition_variable wake_;
  bool stopping_ = false;
  std::optional<double> irrigation_;
  std::optional<view::Heat> newest_;
  std::exception_ptr failure_;

  std::thread thread_;
};

}  // namespace hapticut::apps
