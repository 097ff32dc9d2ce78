// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "hapticut/core/errors.hpp"
#include "reports/flag_words.hpp"
#include "reports/report.hpp"
#include "reports/table.hpp"

namespace hapticut::apps {
namespace {

constexpr double kMaxClosure = 0.01;  // [1] above it, energies and forces are inconsistent
constexpr double kOftenThick = 0.5;   // [1] fraction of the cutting steps
constexpr double kOftenBlunt = 0.5;   // [1] fraction of the steps in contact

std::string steps(std::size_t count) { return std::to_string(count) + (count == 1 ? " step" : " steps"); }

}  // namespace

std::vector<std::string> warnings_of(const DrillResult& r, const Simulation& simulation) {
  std::vector<std::string> warnings;
  const auto warn = [&](const Sentence& warning) { warnings.push_back(in_words_of_flags(warning)); };
  const bool cuts = simulation.config().removal != RemovalLaw::none;
  const std::size_t stood = r.count(StepStatus::spindle_stands), stalled = r.count(StepStatus::spindle_stalled);
  if (!cuts && r.steps_in_contact > 0) warn(removal_is_off());
  if (r.steps_in_contact == 0 && r.steps_rejected == 0)
    warn("the path never touches the workpiece; check the positions and " + "path.point"_name + " against its box.");
  else if (cuts && r.steps_in_contact > 0 && r.removed_volume == 0 && stood == 0 && stalled == 0)
    warn(simulation.config().law->is_foundation()
             ? "the tool touches the workpiece but cuts nothing; check the edge pressure of the materials and " +
                   "simulation.reference_stiffness_N_per_m4"_name + "."
             : "the tool touches the workpiece but cuts nothing; raise " + "tool.spindle_rpm"_name +
                   ", go deeper, or lower the constant of the law that says when it cuts, such as " +
                   "force.thesis_cutting_force_N"_name + ".");
  if (r.starts_in_contact)
    warn("the path starts inside the workpiece; start outside, e.g. with " + "path.approach_mm"_name + ".");
  if (r.steps_rejected > 0)
    warn(steps(r.steps_rejected) + " of " + std::to_string(r.steps) + " were rejected, the first is step " +
         std::to_string(r.first_rejected) +
         (r.count(StepStatus::jump_rejected) > 0
              ? "; the tool moved too far for one step, so lower the feed, raise the rate, or check the "
                "poses there."
              : "; see the status bits."));
  if (const std::size_t exhausted = r.count(StepStatus::blocks_exhausted); exhausted > 0)
    warn("in " + steps(exhausted) + " some material was not cut because free blocks were missing; raise " +
         "simulation.reserved_blocks"_name + ".");
  if (const std::size_t full = r.count(StepStatus::removed_list_full); full > 0)
    warn("in " + steps(full) + " the list of removed voxels was full; removed_voxels is too low.");
  if (stood > 0)
    warn("the spindle stood in " + steps(stood) +
         " of contact, so the head pressed, rubbed and crushed, but did not cut; set " + "tool.spindle_rpm"_name + ".");
  if (cuts && stalled > 0)
    warn("the load stalled the spindle in " + steps(stalled) + " of " + std::to_string(r.steps_in_contact) +
         " in contact, so the head did not cut; lower the feed, or raise " + "tool.power_limit_W"_name + " or " +
         "tool.torque_limit_Nmm"_name + ".");
  if (const std::size_t blunt = r.count(StepStatus::edges_carry_load);
      double(blunt) > kOftenBlunt * double(r.steps_in_contact))
    warn("in " + steps(blunt) + " of " + std::to_string(r.steps_in_contact) +
         " in contact the edges of the drill carried the load, so it cut hardly anything; press harder than " +
         rounded(r.load_to_cut, 3) + " N, feed faster, or set " + "tool.sharpness"_name + " new.");
  if (double(r.steps_too_soft) > kOftenThick * double(r.steps_cutting))
    warn("in " + steps(r.steps_too_soft) + " of " + std::to_string(r.steps_cutting) +
         " that cut, the engaged layer was thicker than a tenth of the head, so forces are too low; "
         "raise " +
         "simulation.reference_stiffness_N_per_m4"_name + " or lower the feed.");
  if (double(r.times.deadline_misses) > kOftenSlow * double(r.steps))
    warn(steps(r.times.deadline_misses) + " of " + std::to_string(r.steps) +
         " took longer than 1 ms; for a haptic loop choose larger voxels, a smaller head or " +
         "simulation.voxel_budget"_name + ".");
  if (std::abs(r.energy.closure()) > kMaxClosure)
    warn("the energy ledger leaves " + rounded(100 * r.energy.closure(), 3) + " % of the work unexplained, " +
         rounded(r.energy.entered, 2) + " J entered without contact work; raise the rate.");
  return warnings;
}

}  // namespace hapticut::apps
