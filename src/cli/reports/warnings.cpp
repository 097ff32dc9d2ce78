// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "cli/reports/report.hpp"
#include "cli/reports/table.hpp"
#include "hapticut/core/errors.hpp"

namespace hapticut::cli {
namespace {

constexpr double kMaxClosure = 0.01;  // [1] above it, energies and forces are inconsistent
constexpr double kOftenThick = 0.5;   // [1] fraction of the cutting steps

std::string steps(std::size_t count) { return std::to_string(count) + (count == 1 ? " step" : " steps"); }

}  // namespace

std::vector<std::string> warnings_of(const DrillResult& r, const Simulation& simulation) {
  std::vector<std::string> warnings;
  const bool cuts = simulation.tool().spindle().speed != 0 && simulation.config().removal != RemovalLaw::none;
  if (r.steps_in_contact == 0)
    warnings.emplace_back("the path never touches the workpiece; check the positions and path.point against its box.");
  else if (cuts && r.removed_volume == 0)
    warnings.emplace_back("the tool touches the workpiece but cuts nothing; check the edge pressure of the materials.");
  if (r.starts_in_contact)
    warnings.emplace_back("the path starts inside the workpiece; start outside, e.g. with path.approach_mm.");
  if (const std::size_t jumps = r.count(StepStatus::jump_rejected); jumps > 0)
    warnings.push_back(steps(jumps) +
                       " moved too far for one step and were rejected; lower the feed or raise the rate.");
  if (const std::size_t exhausted = r.count(StepStatus::blocks_exhausted); exhausted > 0)
    warnings.emplace_back(
        "in " + steps(exhausted) +
        " some material was not cut because free blocks were missing; raise simulation.reserved_blocks.");
  if (const std::size_t full = r.count(StepStatus::removed_list_full); full > 0)
    warnings.emplace_back("in " + steps(full) + " the list of removed voxels was full; removed_voxels is too low.");
  const std::size_t thick = r.count(StepStatus::engaged_layer_thick);
  if (double(thick) > kOftenThick * double(r.steps_cutting))
    warnings.emplace_back("in " + steps(thick) + " of " + std::to_string(r.steps_cutting) +
                          " that cut, the engaged layer was thicker than a tenth of the head, so forces are too low; "
                          "raise simulation.reference_stiffness_N_per_m4 or lower the feed.");
  if (std::abs(r.energy.closure()) > kMaxClosure)
    warnings.emplace_back("the energy ledger does not close: " + rounded(100 * r.energy.closure(), 3) +
                          " % of the work is unexplained, " + rounded(r.energy.entered, 2) +
                          " J entered without contact work; raise the rate.");
  return warnings;
}

}  // namespace hapticut::cli
