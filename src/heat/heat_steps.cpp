// SPDX-License-Identifier: Apache-2.0
// Time steps of a heat field, and their effect on the material.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/interruption.hpp"
#include "hapticut/heat/heat_field.hpp"

namespace hapticut {
namespace {

constexpr double kReference = 43;  // [deg C]

}  // namespace

double cem43(double temperature, double time) {
  const double below = kReference - temperature;
  return time / 60 * std::exp2(below > 0 ? -2 * below : -below);
}

/// [1/s] Maximum rate at which a cell loses its heat to its surroundings. In time steps of at most its inverse no cell
/// becomes warmer than its warmest neighbour, or colder than its coldest.
double HeatField::max_rate() const {
  double maximum = 0;
  for (std::size_t cell = stride_[0]; cell + stride_[0] < cells_.heat.size(); ++cell) {
    if (!(cells_.capacity[cell] > 0)) continue;
    double losses = cells_.cooling[cell];
    for (std::size_t axis = 0; axis < 3; ++axis)
      losses += cells_.conductance[axis][cell] + cells_.conductance[axis][cell - stride_[axis]];
    maximum = std::max(maximum, losses / cells_.capacity[cell]);
  }
  return maximum;
}

void HeatField::advance(double dt) {
  require_within(dt, Range::not_negative(), "HeatField::advance: dt [s]");
  refresh_changed();
  if (!(waiting_ > 0))
    for (const std::size_t cell : removed_)  // that no cut has claimed
      balance_.chips += std::exchange(cells_.held[cell], 0), cells_.held_capacity[cell] = 0;
  if (rate_ == 0) rate_ = max_rate();
  const auto sub_steps = std::uint64_t(std::max(1.0, std::ceil(dt * rate_)));
  for (std::uint64_t n = 0; n < sub_steps; ++n) {
    look_for_interruption();
    step(dt / double(sub_steps));
    count_dose(dt / double(sub_steps));
  }
}

void HeatField::step(double dt) {
  const std::size_t last = cells_.heat.size() - stride_[0];
  for (std::size_t cell = stride_[0]; cell < last; ++cell)
    cells_.rise[cell] = cells_.capacity[cell] > 0 ? cells_.heat[cell] / cells_.capacity[cell] : 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double* conductance = cells_.conductance[axis].data();
    for (std::size_t cell = stride_[0]; cell < last; ++cell) {
      const std::size_t next = cell + stride_[axis];
      const double flow = dt * conductance[cell] * (cells_.rise[cell] - cells_.rise[next]);
      cells_.heat[cell] -= flow;
      cells_.heat[next] += flow;
    }
  }
  if (!(config_.irrigation > 0)) return;
  const double water = config_.water_temperature - config_.body_temperature;
  double to_water = 0;
  for (std::size_t cell = stride_[0]; cell < last; ++cell) {
    const double flow = dt * cells_.cooling[cell] * (cells_.rise[cell] - water);
    cells_.heat[cell] -= flow;
    to_water += flow;
  }
  balance_.irrigation += to_water;
}

/// Counts the dose with the mean temperature of a time step.
void HeatField::count_dose(double dt) {
  const double threshold = config_.threshold - config_.body_temperature;
  for (std::size_t cell = stride_[0]; cell + stride_[0] < cells_.heat.size(); ++cell) {
    if (!(cells_.capacity[cell] > 0)) continue;
    const double now = cells_.heat[cell] / cells_.capacity[cell], middle = 0.5 * (cells_.rise[cell] + now);
    cells_.rise[cell] = now;
    cells_.peak[cell] = std::max({cells_.peak[cell], middle, now});
    if (cells_.peak[cell] > warmest_rise_) warmest_ = cell, warmest_rise_ = cells_.peak[cell];
    if (middle > threshold) cells_.above[cell] += dt;
    cells_.dose[cell] += cem43(config_.body_temperature + middle, dt);
    const float* volumes = volumes_.data() + cell * materials_;
    for (std::size_t m = 0; m < materials_; ++m)
      if (volumes[m] > 0) peaks_[m] = std::max(peaks_[m], cells_.peak[cell]);
  }
}

std::vector<StructureHeat> HeatField::structures() const {
  std::vector<StructureHeat> all(materials_);
  const double body = config_.body_temperature;
  std::vector<double> warmest(materials_, -std::numeric_limits<double>::infinity());
  for (std::size_t cell = 0; cell < cells_.heat.size(); ++cell) {
    if (!(cells_.capacity[cell] > 0)) continue;
    const float* volumes = volumes_.data() + cell * materials_;
    for (std::size_t m = 0; m < materials_; ++m) {
      if (!(volumes[m] > 0)) continue;
      warmest[m] = std::max(warmest[m], cells_.heat[cell] / cells_.capacity[cell]);
      all[m].time_above = std::max(all[m].time_above, cells_.above[cell]);
      all[m].cem43 = std::max(all[m].cem43, cells_.dose[cell]);
      if (body + cells_.peak[cell] > config_.threshold) all[m].volume_above += double(volumes[m]) * cell_volume_;
    }
  }
  for (std::size_t m = 0; m < materials_; ++m) {
    all[m].material = MaterialId(m + 1);
    all[m].temperature = body + (std::isfinite(warmest[m]) ? warmest[m] : 0);
    all[m].peak = body + peaks_[m];
  }
  return all;
}

std::optional<WarmestPlace> HeatField::warmest() const {
  if (!(warmest_rise_ > 0)) return std::nullopt;
  return WarmestPlace{config_.body_temperature + warmest_rise_, center(cell_of(warmest_))};
}

HeatBalance HeatField::balance() const {
  HeatBalance balance = balance_;
  balance.stored = 0;
  for (const double heat : cells_.heat) balance.stored += heat;
  for (const std::size_t cell : removed_) balance.stored += cells_.held[cell];  // until the heat of the cut comes
  return balance;
}

double HeatField::temperature_at(const Vec3& p_WQ) const {
  double weights = 0, rise = 0;
  const Around around = cells_around(p_WQ);
  for (std::size_t n = 0; n < std::size_t(around.count); ++n) {
    const std::size_t cell = around.cell[n];
    if (!(cells_.capacity[cell] > 0)) continue;
    weights += around.weight[n];
    rise += around.weight[n] * cells_.heat[cell] / cells_.capacity[cell];
  }
  return weights > 0 ? config_.body_temperature + rise / weights : std::numeric_limits<double>::quiet_NaN();
}

double HeatField::temperature(const std::array<int, 3>& cell) const {
  const std::size_t n = number_of(cell);
  return cells_.capacity[n] > 0 ? config_.body_temperature + cells_.heat[n] / cells_.capacity[n]
                                : std::numeric_limits<double>::quiet_NaN();
}

double HeatField::peak(const std::array<int, 3>& cell) const {
  return config_.body_temperature + cells_.peak[number_of(cell)];
}

double HeatField::dose(const std::array<int, 3>& cell) const { return cells_.dose[number_of(cell)]; }

}  // namespace hapticut
