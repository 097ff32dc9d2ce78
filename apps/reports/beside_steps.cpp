// SPDX-License-Identifier: Apache-2.0
#include "reports/beside_steps.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <numeric>
#include <utility>

#include "hapticut/core/errors.hpp"

namespace hapticut::apps {
namespace {

constexpr double kRounding = 1e-9;  // [1] of a period: the sum of many durations is not exact

}  // namespace

void HeatRun::advance() {
  const double time = field_.drain(collector_);
  field_.advance(time);
  longest_ = std::max(longest_, time);
}

HeatThread::HeatThread(Simulation& simulation, const HeatConfig& config) : heat_(simulation, config) {
  thread_ = std::thread([this] { run(); });
}

void HeatThread::run() {
  constexpr std::chrono::duration<double> kPause(HeatRun::kPeriod);
  const std::future<void> end = end_.get_future();
  try {
    while (end.wait_for(kPause) == std::future_status::timeout) heat_.advance();
  } catch (...) {
    failure_ = std::current_exception();
  }
}

void HeatThread::stop() {
  if (std::exchange(stopped_, true)) return;
  end_.set_value();
  thread_.join();
}

HeatReport HeatThread::finish() {
  stop();
  if (failure_) std::rethrow_exception(failure_);
  heat_.advance();
  return heat_.report();
}

LoosePieces loose_pieces(std::uint64_t count, const Simulation& simulation) {
  const ByMaterial<double>& volumes = simulation.totals().detached_volume;
  return {count, std::accumulate(volumes.begin(), volumes.end(), 0.0)};
}

void PieceRemoval::search() {
  for (ChangedBlock block; feed_.receive(block);) finder_.update(block.origin, block.fill.data());
  for (Island& island : finder_.find()) {
    IslandRemoval removal{std::move(island)};
    while (!remove_island(simulation_, removal, std::numeric_limits<std::size_t>::max()))
      simulation_.reserve_blocks(simulation_.config().reserved_blocks);
    if (!removal.joined) ++count_;
  }
}

bool BesideSteps::Clock::is_due(double dt) {
  since += dt;
  if (since < period * (1 - kRounding)) return false;
  since = 0;
  return true;
}

BesideSteps::BesideSteps(Simulation& simulation, const std::optional<HeatConfig>& heat, bool removes_loose_pieces)
    : simulation_(simulation) {
  if (heat) heat_.emplace(simulation, *heat);
  if (removes_loose_pieces) removal_.emplace(simulation);
}

void BesideSteps::after_step(double dt) {
  if (removal_ && removal_clock_.is_due(dt)) removal_->search();
  if (heat_ && heat_clock_.is_due(dt)) heat_->advance();
}

BesideReport BesideSteps::finish() {
  BesideReport report;
  if (removal_) {
    removal_->search();
    report.loose_pieces = loose_pieces(removal_->count(), simulation_);
  }
  if (heat_) {
    heat_->advance();
    report.heat = heat_->report();
  }
  return report;
}

BesideLoop::BesideLoop(LoopModel& model, const std::optional<HeatConfig>& heat, bool removes_loose_pieces,
                       bool simulated_time)
    : model_(model) {
  if (simulated_time) {
    stepped_.emplace(model, heat, removes_loose_pieces);
    return;
  }
  if (heat) heat_.emplace(*model.simulation(), *heat);
  if (removes_loose_pieces) islands_.emplace(model);
}

LoopModel& BesideLoop::model() {
  if (stepped_) return *stepped_;
  if (islands_) return *islands_;
  return model_;
}

BesideReport BesideLoop::finish() {
  if (stepped_) return stepped_->beside.finish();
  BesideReport report;
  if (heat_) report.heat = heat_->finish();
  if (islands_) report.loose_pieces = loose_pieces(islands_->watch().count(), *model_.simulation());
  return report;
}

void require_replayable(const std::string& recording, bool removes_loose_pieces) {
  if (recording.empty() || !removes_loose_pieces) return;
  throw Error("output.record"_name + " = \"" + recording + "\"; must be left out with " +
              "simulation.remove_loose_pieces"_name +
              ", because a recording does not contain removed pieces and would end at the first one. Leave out one of "
              "the two.");
}

}  // namespace hapticut::apps
