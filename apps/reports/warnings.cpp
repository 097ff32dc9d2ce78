// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/force/stiffness.hpp"
#include "reports/flag_words.hpp"
#include "reports/report.hpp"
#include "reports/shared_warnings.hpp"
#include "reports/table.hpp"

namespace hapticut::apps {
namespace {

constexpr double kMaxClosure = 0.01;   // [1] above it, energies and forces are inconsistent
constexpr double kOftenThick = 0.5;    // [1] fraction of the cutting steps
constexpr double kOftenBlunt = 0.5;    // [1] fraction of the steps in contact
constexpr double kAllOfTheHead = 4;    // [1] stiffness for the slow middle of the head over that for its rim
constexpr double kOftenCrushed = 0.2;  // [1] fraction of the steps in contact; on entry it is less

std::string steps(std::size_t count) { return std::to_string(count) + (count == 1 ? " step" : " steps"); }

/// "raise --reference_stiffness, which is 1e+12 N/m^4, to 3e+13": what the feed demands of the touched materials.
Sentence stiffer(const DrillResult& r, const Simulation& simulation) {
  const Tool& tool = simulation.tool();
  const double in_use = simulation.config().reference_stiffness;
  double enough = std::max(2 * in_use, stiffness_for_head(tool.head()));
  simulation.totals().touched.for_each([&](MaterialId id) {
    const Material& m = simulation.workpiece().materials()[id];
    if (m.cutting_ratio > 0 && r.max_feed > 0 && tool.spindle().speed != 0)
      enough = std::max(enough, kAllOfTheHead * stiffness_for_accuracy(tool.head(), m, tool.spindle().speed,
                                                                       std::min(r.max_feed, kMaxFeed), tool.cutter()));
  });
  return "raise " + "simulation.reference_stiffness_N_per_m4"_name + ", which is " + rounded(in_use, 2) +
         " N/m^4, to " + rounded(enough, 2);
}

}  // namespace

std::vector<std::string> warnings_of(const DrillResult& r, const Simulation& simulation) {
  std::vector<std::string> warnings;
  const auto warn = [&](const Sentence& warning) { warnings.push_back(in_words_of_flags(warning)); };
  const bool cuts = simulation.config().removal != RemovalLaw::none;
  const std::size_t stood = r.count(StepStatus::spindle_stands), stalled = r.count(StepStatus::spindle_stalled);
  const double in_contact = double(r.steps_in_contact);
  if (!cuts && r.steps_in_contact > 0) warn(removal_is_off());
  for (const Sentence& unsuited : warnings_of_cutter(simulation)) warn(unsuited);
  if (const auto strong = warning_of_force(r.max_force); strong && cuts && stood == 0 && stalled == 0) warn(*strong);
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
  const MotorAdvice motor = advice_on_motor(simulation.tool().spindle());
  if (cuts && stalled > 0)
    warn("the load stalled the spindle in " + steps(stalled) + " of " + std::to_string(r.steps_in_contact) +
         " in contact, so the head did not cut; " + motor.limits + ". Lower the feed" + motor.cure + ".");
  const BluntEdges edges = blunt_edges(simulation);
  if (const std::size_t blunt = r.count(StepStatus::edges_carry_load);
      double(blunt) > kOftenBlunt * in_contact &&
      r.blunt_feed <= edges.feed * double(blunt))  // a faster drill has another trouble
    warn("in " + steps(blunt) + " of " + std::to_string(r.steps_in_contact) +
         " in contact the edges of the drill carried the load, so it cut hardly anything; they carry " +
         rounded(edges.load, 3) + " N. Feed faster than " + rounded(edges.feed / units::mm, 2) + " mm/s" +
         sharper_drill(edges) + ".");
  if (const std::size_t crushed = r.count(StepStatus::material_crushed);
      stood == 0 && stalled == 0 && double(crushed) > kOftenCrushed * in_contact)
    warn("in " + steps(crushed) + " of " + std::to_string(r.steps_in_contact) +
         " in contact the head crushed material where it did not cut it; " + kCureOfCrushing);
  if (double(r.steps_too_soft) > kOftenThick * double(r.steps_cutting))
    warn("in " + steps(r.steps_too_soft) + " of " + std::to_string(r.steps_cutting) +
         " that cut, the engaged layer was thicker than a tenth of the head, so forces are too low; " +
         stiffer(r, simulation) + ", or lower the feed.");
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
