// SPDX-License-Identifier: Apache-2.0
#include "hapticut/io/recording/replay.hpp"

#include <algorithm>
#include <cstring>

#include "core/interruption.hpp"
#include "io/recording/recording_access.hpp"
#include "io/recording/recording_file.hpp"

namespace hapticut {
namespace {

constexpr std::uint64_t kStepsPerRead = 1024;  // steps

/// Brings the motor into the state in which the recorded one began the step. Of all calls since the last step, only the
/// last halt and the last setting after it matter; a hold begins with a halt, and ends with a setting.
void prepare_spindle(Simulation& simulation, const RecordedStep& step) {
  if (!step.spindle_held) simulation.spindle().hold(false);
  if (step.halted) simulation.spindle().halt();
  simulation.spindle().hold(step.spindle_held);
  // Older recordings do not say whether the speed was set.
  if (step.spindle_set || (!step.spindle_held && simulation.spindle().setting() != step.spindle_setting))
    simulation.spindle().set_speed(step.spindle_setting * units::rad_per_s);
}

/// Fills the pool as it was. `reserve_blocks` never makes it smaller.
void prepare_blocks(Simulation& simulation, const RecordedStep& step) {
  if (simulation.workpiece().reserved_blocks() < step.free_blocks) simulation.reserve_blocks(step.free_blocks);
  if (simulation.config().reserved_blocks != step.reserved_blocks) simulation.reserve_blocks(step.reserved_blocks);
}

/// Applies the settings that changed between the recorded steps.
void prepare(Simulation& simulation, const RecordedStep& step) {
  prepare_spindle(simulation, step);
  prepare_blocks(simulation, step);
}

/// Returns the recorded outputs of the coupling.
class RecordedCoupling final : public HandCoupling {
 public:
  explicit RecordedCoupling(const RecordedStep& step) : step_(step) {}
  std::optional<HandOutput> answer(const StepResult& /*stepped*/) noexcept override {
    return step_.path == OutputPath::coupled ? std::optional(step_.hand) : std::nullopt;
  }

 private:
  const RecordedStep& step_;
};

const StepResult& step_again(Simulation& simulation, const RecordedStep& step) {
  if (step.hand_released) simulation.release_hand();
  RecordedCoupling coupling(step);
  return simulation.step(step.input.X_WH, step.input.V_WH, step.input.dt,
                         step.path == OutputPath::direct ? nullptr : &coupling);
}

/// The first number of a step's result that differs from the recorded one.
std::optional<ReplayDifference> compare(const std::vector<const Column*>& columns, const RecordedStep& recorded,
                                        const RecordedStep& replayed) {
  std::array<std::byte, 9 * sizeof(double)> before, now;
  for (const Column* each : columns) {
    const Column& column = *each;
    if (column.side != Column::Side::result && column.name != "free_blocks") continue;
    column.pack(recorded, before.data());
    column.pack(replayed, now.data());
    const std::size_t width = column.bytes / column.numbers;
    for (std::size_t element = 0; element < column.numbers; ++element)
      if (std::memcmp(before.data() + element * width, now.data() + element * width, width) != 0)
        return ReplayDifference{recorded.number, column.name, element, number_at(column, before.data(), element),
                                number_at(column, now.data(), element)};
  }
  return std::nullopt;
}

}  // namespace

Simulation simulation_of(const Recording& recording, std::shared_ptr<const ForceLaw> law) {
  if (!recording.default_law() && !law)
    throw Error("the recording '" + recording.path().string() +
                "' was made with another law than FoundationLaw, and a file cannot store a law; give the same law "
                "to " +
                "ReplayOptions::law"_name + ".");
  SimulationConfig config = recording.config();
  const bool at_parts = config.quadrature == Quadrature::automatic || config.quadrature == Quadrature::sub_voxel;
  if (!law && !at_parts)
    throw Error("the recording '" + recording.path().string() +
                "' was made by a version whose FoundationLaw evaluated forces at points of voxels; it can be read, but "
                "not replayed.");
  if (law && law->integrates_parts() && !at_parts)
    throw Error("the recording '" + recording.path().string() +
                "' was made with a law that computes the force at points of voxels, but " + "ReplayOptions::law"_name +
                " integrates "
                "over parts of voxels; choose a law of the kind of the recording.");
  // A passed law is used with the quadrature that it supports.
  if (law && !law->integrates_parts() && at_parts) config.quadrature = Quadrature::automatic;
  if (law) config.law = std::move(law);
  return Simulation(recording.workpiece(), recording.tool(), std::move(config));
}

ReplayReport replay(const Recording& recording, const ReplayOptions& options) {
  const std::uint64_t steps = RecordingAccess::state(recording).before_first_gap;
  Simulation simulation = simulation_of(recording, options.law);
  ReplayReport report;
  report.skipped = recording.size() - steps;
  auto next_effects = recording.effects().begin() + 1;
  for (std::uint64_t first = 0; first < steps; first += kStepsPerRead) {
    for (const RecordedStep& recorded : recording.read(first, std::min(kStepsPerRead, steps - first))) {
      look_for_interruption();
      if (next_effects != recording.effects().end() && next_effects->first_step == recorded.number)
        simulation.set((next_effects++)->effects);
      prepare(simulation, recorded);
      RecordedStep replayed = recorded;
      replayed.free_blocks = simulation.workpiece().reserved_blocks();
      note_result(step_again(simulation, recorded), replayed);
      if (!report.first_difference)
        report.first_difference = compare(RecordingAccess::state(recording).columns, recorded, replayed);
      report.max_force_difference = std::max(report.max_force_difference, (replayed.force - recorded.force).norm());
      ++report.steps;
      if (options.on_step) options.on_step(simulation, recorded);
    }
    if (options.progress) options.progress(report.steps);
  }
  report.workpiece_hash = simulation.workpiece().hash();
  const RecordingInfo& info = recording.info();
  if (!report.first_difference && report.skipped == 0 && info.lost == 0 && info.workpiece_hash_at_end &&
      *info.workpiece_hash_at_end != report.workpiece_hash)
    report.first_difference = ReplayDifference{report.steps, "workpiece", 0, double(*info.workpiece_hash_at_end),
                                               double(report.workpiece_hash)};
  report.identical = !report.first_difference;
  return report;
}

}  // namespace hapticut
