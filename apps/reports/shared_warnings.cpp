// SPDX-License-Identifier: Apache-2.0
#include "reports/shared_warnings.hpp"

#include <algorithm>
#include <cmath>

#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/preset_constants.hpp"
#include "reports/report.hpp"
#include "reports/table.hpp"
#include "settings/setting.hpp"
#include "simulation/status_limits.hpp"

namespace hapticut::apps {
namespace {

/// [N] Hands press a drill with 4 ... 19 N (20 operators with 9 N in docs/measurements.md); more than twice that.
constexpr double kMaxHandForce = 50;

std::string word_of(CutterKind kind) { return name_or_null(kind); }

/// The cutter that the shape of the head tells, if the tool has another one.
std::optional<Sentence> warning_of_head(const Tool& tool) {
  const CutterKind usual = usual_cutter(tool.head()).kind, kind = tool.cutter().kind;
  if (usual == kind || (usual != CutterKind::twist_drill && kind != CutterKind::twist_drill)) return std::nullopt;
  if (usual == CutterKind::twist_drill)
    return "this head is usually a twist_drill, and with the constants of " + word_of(kind) +
           " its forces are wrong by a factor of ten and more; leave out " + "tool.cutter"_name +
           ", or choose another " + "tool.head"_name + ".";
  return "this head is usually a bur, and with the constants of twist_drill its forces are wrong by up to a factor of "
         "ten; set " +
         "tool.cutter"_name + " to that of a bur, e.g. carbide_bur, or choose another " + "tool.head"_name + ".";
}

/// The touched materials of a workpiece.
std::vector<Material> touched_materials(const Simulation& simulation) {
  std::vector<Material> touched;
  simulation.totals().touched.for_each(
      [&](MaterialId id) { touched.push_back(simulation.workpiece().materials()[id]); });
  return touched;
}

NamesByCutter grouped_names(const std::vector<Material>& materials) {
  NamesByCutter names;
  for (const Material& material : materials)
    if (material.cutter) names[*material.cutter].push_back(material.name);
  return names;
}

}  // namespace

NamesByCutter names_by_cutter(const MaterialTable& materials) { return grouped_names(materials.all()); }

std::string text_of_names(const std::vector<std::string>& names) {
  return names.size() > std::size_t(kFewMaterials) ? std::to_string(names.size()) + " materials"
                                                   : settings::joined(names);
}

std::vector<Sentence> warnings_of_cutter(const Simulation& simulation) {
  std::vector<Sentence> warnings;
  const Tool& tool = simulation.tool();
  const SimulationConfig& config = simulation.config();
  if (config.removal == RemovalLaw::none || !config.law->is_foundation() || tool.spindle().speed == 0) return warnings;
  if (const std::optional<Sentence> unusual = warning_of_head(tool)) warnings.push_back(*unusual);
  const CutterKind own = tool.cutter().kind;
  for (const auto& [kind, names] : grouped_names(touched_materials(simulation))) {
    if (kind == own) continue;
    const std::string table = "[material." + names.front() + "]";
    warnings.push_back("the constants of " + text_of_names(names) + " are for " + word_of(kind) +
                       ", and the tool cuts with " + word_of(own) +
                       ", so forces and removal are wrong by up to a factor of ten; convert the source of the "
                       "workpiece again with " +
                       "tool.cutter"_name + " " + word_of(own) + ", choose a tool with " + "tool.cutter"_name + " " +
                       word_of(kind) + ", or write into " + table + " of a settings file based_on = \"a preset\", or " +
                       "constants and cutter = \"" + word_of(own) + "\".");
  }
  return warnings;
}

std::optional<Sentence> warning_of_force(double force) {
  if (force <= kMaxHandForce) return std::nullopt;
  return "the force reached " + rounded(force, 3) + " N, more than the " + rounded(kMaxHandForce) +
         " N that a hand can give; in drilling it presses with some 10 N. Feed slower, turn faster, or check head, " +
         "cutter and material.";
}

BluntEdges blunt_edges(const Simulation& simulation) {
  const Tool& tool = simulation.tool();
  const PresetConstant* edge = find_constant(word_of(CutterKind::twist_drill), "edge_length");
  BluntEdges edges;
  for (const Material& m : touched_materials(simulation)) {
    edges.load = std::max(edges.load, load_of_edges(m, tool));
    edges.feed = std::max(edges.feed, 2 * kHardlyCut * m.edge_length * tooth_rate(tool.cutter(), tool.spindle().speed));
    if (edge != nullptr && (m.edge_length == edge->typical || m.edge_length == edge->high)) edges.can_be_sharper = true;
  }
  return edges;
}

Sentence sharper_drill(const BluntEdges& edges) {
  if (!edges.can_be_sharper) return "";
  return ", or take a sharper drill with " + "tool.sharpness"_name + " new";
}

MotorAdvice advice_on_motor(const Spindle& spindle) {
  std::vector<std::string> limits;
  std::vector<Sentence> cures;
  const double torque = SpindleMotor(spindle).stall_torque(), speed = std::abs(spindle.speed);
  if (std::isfinite(torque)) limits.push_back(rounded(torque / units::N_mm, 3) + " Nmm");
  if (std::isfinite(spindle.power_limit))
    limits.push_back(rounded(spindle.power_limit, 3) + " W, which are " +
                     rounded(spindle.power_limit / speed / units::N_mm, 3) + " Nmm at " +
                     rounded(speed / units::rpm, 6) + " rpm");
  if (std::isfinite(spindle.torque_limit)) cures.push_back("raise " + "tool.torque_limit_Nmm"_name);
  if (std::isfinite(spindle.power_limit)) cures.push_back("raise " + "tool.power_limit_W"_name);
  if (spindle.droop > 0) cures.push_back("lower " + "tool.droop_rpm_per_Nmm"_name);
  MotorAdvice advice{"the motor gives at most " + settings::joined(limits, " and "), ""};
  for (const Sentence& cure : cures) advice.cure += ", or " + cure;
  return advice;
}

}  // namespace hapticut::apps
