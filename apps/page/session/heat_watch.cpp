// SPDX-License-Identifier: Apache-2.0
#include "page/session/heat_watch.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace hapticut::apps {
namespace {

constexpr auto kPeriod = std::chrono::milliseconds(60);  // of a step of the field
constexpr int kPeriodsOfAPicture = 4;
constexpr int kMaxCells = 200'000;  // [cells] sent in one message
constexpr double kStep = 0.5;       // [K] between two bytes
// [K] From the temperature of byte 1 to the threshold: it lies between two bytes, so that no even area is on the line.
constexpr double kBelowThreshold = 36.75;

double rounded(double number) { return std::round(10 * number) / 10; }

/// The mean temperature of up to n^3 cells [deg C]; NaN: none of them contains material.
double mean_of(const HeatField& field, const std::array<int, 3>& first, int n) {
  const std::array<int, 3> dims = field.dims();
  double sum = 0;
  int count = 0;
  for (int x = first[0]; x < std::min(dims[0], first[0] + n); ++x)
    for (int y = first[1]; y < std::min(dims[1], first[1] + n); ++y)
      for (int z = first[2]; z < std::min(dims[2], first[2] + n); ++z)
        if (const double here = field.temperature({x, y, z}); !std::isnan(here)) sum += here, ++count;
  return count > 0 ? sum / count : std::nan("");
}

bool look_alike(const view::Heat& a, const view::Heat& b) {
  const auto same = [](const view::Heat::Structure& one, const view::Heat::Structure& other) {
    return one.now == other.now && one.peak == other.peak && one.time_above == other.time_above;
  };
  return a.cells == b.cells && std::ranges::equal(a.structures, b.structures, same);
}

}  // namespace

view::Heat shown_heat(const HeatField& field) {
  view::Heat heat;
  const std::array<int, 3> dims = field.dims();
  int n = 1;  // cells along an edge of a shown one
  const auto across = [&](std::size_t axis) { return (dims[axis] + n - 1) / n; };
  while (double(across(0)) * across(1) * across(2) > kMaxCells) ++n;
  for (std::size_t axis = 0; axis < 3; ++axis) heat.dims[axis] = std::uint32_t(across(axis));
  const Vec3 first = field.center({0, 0, 0});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::array<int, 3> next = {0, 0, 0};
    next[axis] = 1;
    heat.X_WC.rotation.col(Eigen::Index(axis)) = (field.center(next) - first) / field.cell_size();
  }
  heat.X_WC.translation = first + heat.X_WC.rotation * Vec3::Constant(0.5 * (n - 1) * field.cell_size());
  heat.cell_size = n * field.cell_size();
  heat.body = field.config().body_temperature;
  heat.threshold = field.config().threshold;
  heat.first = heat.threshold - kBelowThreshold;
  heat.step = kStep;
  for (const StructureHeat& one : field.structures())
    heat.structures.push_back({rounded(one.temperature), rounded(one.peak), rounded(one.time_above)});
  heat.cells.reserve(std::size_t(across(0)) * std::size_t(across(1)) * std::size_t(across(2)));
  for (int z = 0; z < dims[2]; z += n)
    for (int y = 0; y < dims[1]; y += n)
      for (int x = 0; x < dims[0]; x += n) {
        const double here = mean_of(field, {x, y, z}, n);
        const double byte = std::isnan(here) ? 0 : std::clamp(std::round((here - heat.first) / kStep) + 1, 1.0, 255.0);
        heat.cells.push_back(std::uint8_t(byte));
      }
  return heat;
}

HeatWatch::HeatWatch(Simulation& simulation, const HeatConfig& config)
    : collector_(simulation), field_(simulation.workpiece(), config), newest_(shown_heat(field_)) {
  last_ = *newest_;
  thread_ = std::thread([this] { run(); });
}

HeatWatch::~HeatWatch() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void HeatWatch::set_irrigation(double coefficient) {
  const std::lock_guard lock(mutex_);
  irrigation_ = coefficient;
}

std::optional<view::Heat> HeatWatch::take() {
  const std::lock_guard lock(mutex_);
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  return std::exchange(newest_, std::nullopt);
}

void HeatWatch::run() {
  try {
    advance();
  } catch (...) {
    const std::lock_guard lock(mutex_);
    failure_ = std::current_exception();
  }
}

/// Advances the field until the end. A step that takes long delays the next one.
void HeatWatch::advance() {
  std::unique_lock lock(mutex_);
  for (int n = 1; !wake_.wait_for(lock, kPeriod, [this] { return stopping_; }); ++n) {
    const std::optional<double> irrigation = std::exchange(irrigation_, std::nullopt);
    lock.unlock();
    if (irrigation) field_.set_irrigation(*irrigation);
    field_.advance(field_.drain(collector_));
    std::optional<view::Heat> shown;
    if (n % kPeriodsOfAPicture == 0)
      if (view::Heat now = shown_heat(field_); !look_alike(now, last_)) shown = last_ = std::move(now);
    lock.lock();
    if (shown) newest_ = std::move(shown);
  }
}

}  // namespace hapticut::apps
