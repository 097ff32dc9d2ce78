// SPDX-License-Identifier: Apache-2.0
// Set-up and queries of a simulation.
#include "hapticut/simulation/simulation.hpp"

#include <algorithm>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/force/stiffness.hpp"
#include "simulation/removed_list.hpp"
#include "simulation/simulation_state.hpp"

namespace hapticut {
namespace {

// Memory for all voxels that a head may reach is reserved at set-up; a larger head is a mistake in the unit.
constexpr double kMaxVoxels = 1e9, kMaxDiagonal = 4000;  // [voxels]
constexpr double kMinThickness = 1.5;  // [voxels] thickness of a head: there its forces are wrong by a fifth

void validate_pair(const Workpiece& workpiece, const Tool& tool) {
  if (workpiece.empty())
    throw Error(
        "the workpiece is empty: nothing is left of it to cut. If it was built from a volume, check the threshold, "
        "crop box "
        "or labels.");
  validate_head(tool.head(), workpiece.voxel_size());
}

}  // namespace

void validate_head(const ToolHead& head, double voxel_size) {
  const HeadBox box = head.bounding_box();
  const double thickness = (box.max - box.min).minCoeff();
  if (thickness < kMinThickness * voxel_size)
    throw Error("the head is " + format_number(thickness * 1e3) + " mm thin, less than " +
                format_number(kMinThickness) + " voxels of " + format_number(voxel_size * 1e3) +
                " mm; it would slip between voxels. Choose smaller voxels.");
  const Vec3 spans = (box.max - box.min) / voxel_size;
  if (!(spans.prod() <= kMaxVoxels && spans.norm() <= kMaxDiagonal))
    throw Error("the head spans " + format_number(spans.x()) + " x " + format_number(spans.y()) + " x " +
                format_number(spans.z()) + " voxels; must be at most " + format_number(kMaxVoxels) + " in all and " +
                format_number(kMaxDiagonal) +
                " along its diagonal. Give its dimensions in metres, or choose larger voxels.");
}

Simulation::State::State(Workpiece given_workpiece, Tool given_tool, SimulationConfig given_config)
    : workpiece(std::move(given_workpiece)),
      tool(std::move(given_tool)),
      chooses_stiffness(given_config.reference_stiffness == 0),
      config(complete(std::move(given_config), tool.head(), workpiece.materials())),
      contact_stages(workpiece, tool.head(), config),
      spindle(tool.spindle()),
      removal(removed_list_size(config, max_voxels(tool.head(), workpiece.voxel_size()))) {
  workpiece.reserve_blocks(config.reserved_blocks);
  X_VW = workpiece.frame().X_WV.inverse();
  head_stiffness = stiffness_of(tool.head(), config);
  set_material_friction();
  other_cutter = any_for_other_cutter(workpiece.materials(), tool.cutter().kind);
  thickest_chip = crowded_chip(tool);
}

Simulation::Simulation(Workpiece workpiece, Tool tool, SimulationConfig config) {
  validate(config);
  validate_pair(workpiece, tool);
  config.law->require_head(tool.head());
  state_ = std::make_unique<State>(std::move(workpiece), std::move(tool), std::move(config));
}

Simulation::Simulation(std::unique_ptr<State> state) noexcept : state_(std::move(state)) {}
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

const Workpiece& Simulation::workpiece() const { return state_->workpiece; }
const Tool& Simulation::tool() const { return state_->tool; }
const SimulationConfig& Simulation::config() const { return state_->config; }
const StepResult& Simulation::last_result() const { return state_->result; }

ChangedBlocks Simulation::changed_blocks() const noexcept { return state_->contact_stages.changed(); }
SpindleDrive& Simulation::spindle() noexcept { return state_->spindle; }
const SpindleDrive& Simulation::spindle() const noexcept { return state_->spindle; }
const StepInput& Simulation::last_input() const noexcept { return state_->input; }
std::uint64_t Simulation::steps() const noexcept { return state_->totals.steps; }
bool Simulation::next_step_is_first() const noexcept { return !state_->motion.is_placed(); }
bool Simulation::is_fresh() const noexcept {
  return state_->totals.steps == 0 && !state_->totals.altered && !state_->motion.is_separated();
}
IndexBox Simulation::first_bounds() const noexcept { return state_->contact_stages.bounds(); }

StepObservers& Simulation::observers() noexcept { return state_->observers; }
const StepObservers& Simulation::observers() const noexcept { return state_->observers; }

void StepObservers::add(StepObserver& observer) {
  if (std::ranges::find(all(), &observer) != all().end())
    throw Error("the simulation has this observer already; add it once.");
  if (count_ == kMax)
    throw Error("the simulation has " + std::to_string(kMax) + " observers, which is the maximum; remove one first.");
  observers_[count_++] = &observer;
}

void StepObservers::remove(StepObserver& observer) noexcept {
  const auto end = std::remove(observers_.begin(), observers_.begin() + std::ptrdiff_t(count_), &observer);
  count_ = std::size_t(end - observers_.begin());
}

const ByMaterial<double>& Simulation::normal_forces() const noexcept { return state_->contact_stages.pressed(); }
const MaterialSet& Simulation::first_touched() const noexcept { return state_->totals.first_touched; }
SimulationTotals Simulation::totals() const noexcept {
  const RunningTotals& t = state_->totals;
  return {state_->removal.total_by_material(),
          t.detached_volume,
          t.touched,
          t.first_touch_step,
          t.exchanges,
          t.replacements};
}

WorstCase Simulation::worst_case() const { return state_->contact_stages.worst_case(state_->config); }

const StageTimes& Simulation::stage_times() const { return state_->times; }

void Simulation::set(const Effects& effects) {
  validate(effects, state_->config.update_rate);
  state_->config.effects = effects;
}

void Simulation::reserve_blocks(std::size_t count) {
  state_->workpiece.reserve_blocks(count);
  state_->config.reserved_blocks = count;
}

void Simulation::reset(Workpiece workpiece) {
  validate_pair(workpiece, state_->tool);
  auto fresh = std::make_unique<State>(std::move(workpiece), state_->tool, state_->config);
  if (const std::size_t blocks = state_->workpiece.undo_blocks(); blocks > 0) fresh->workpiece.reserve_undo(blocks);
  fresh->observers = state_->observers;
  fresh->totals.replace(state_->totals);
  fresh->contact_stages.change_all();
  const bool spindle_held = state_->spindle.is_held();
  state_ = std::move(fresh);
  state_->spindle.hold(spindle_held);
  state_->tell_of_exchange();
}

}  // namespace hapticut
