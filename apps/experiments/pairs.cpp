// SPDX-License-Identifier: Apache-2.0
#include "experiments/pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "experiments/report.hpp"
#include "experiments/vocabulary.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/simulation/coupling.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/tool/head_outline.hpp"
#include "hapticut/tool/motors.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut::experiments {
namespace {

constexpr double kRise = 0.05, kCounted = 0.05;  // [s] in which the load rises, and least time that counts
constexpr double kSettling = 0.06;               // [1] way over the radius in which the layer forms
constexpr double kDeep = 16;                     // [1] depth of the block over the radius
constexpr double kVoxels = 10;                   // [1] in a radius

/// A block whose top has a hole of the shape of the head, which is engaged over its whole section at once.
/// @param rim  [m] height of the widest section of the head, in T
Workpiece block_around(const ToolHead& head, double rim, const Material& material) {
  const double radius = head.cutting_radius(), side = 1.4 * radius, voxel = radius / kVoxels;
  const HeadOutline outline(head);
  const Vec3 off_grid(0.29 * voxel, 0.11 * voxel, 0);
  const auto distance = [&](const Vec3& p) {
    return std::max(p.z(), -outline.distance((p - off_grid).head<2>().norm(), p.z() + rim));
  };
  const Box box = {Vec3(-side, -side, -kDeep * radius), Vec3(side, side, 0)};
  return build_body({box, distance, [](const Vec3&) { return MaterialId(1); }}, voxel, MaterialTable({material}));
}

/// [m] Height of the widest section, from where a drill is smooth.
double rim_of(const Tool& tool) {
  if (tool.head().ball() != nullptr) return 0;
  return tool.head().profile().edges.front().z;
}

/// A rate in mm^3/s with two digits, and what the step says of it.
std::string cell_of(const PushedCut& cut, double load) {
  const double rate = cut.rate / 1e-9, step = std::pow(10, std::floor(std::log10(std::max(rate, 1e-3))) - 1);
  std::string cell = rate < 1e-3 ? "0" : format_number(std::round(rate / step) * step);
  if (has_any(cut.status, StepStatus::material_crushed)) return cell + " crushed";
  if (load < cut.load_to_cut) return cell + " edges";
  if (has_any(cut.status, StepStatus::spindle_stalled)) return cell + " stalls";
  return cell + (has_any(cut.status, StepStatus::power_limited) ? " limit" : "");
}

}  // namespace

Tool usual_tool(CutterKind kind, double radius, AngularSpeed speed, std::optional<MotorKind> motor) {
  const bool drills = kind == CutterKind::twist_drill;
  const bool otological = kind == CutterKind::mastoid_cutting_bur || kind == CutterKind::mastoid_diamond_bur;
  if (speed == 0) speed = (drills ? 1500 : otological ? 80e3 : 300e3) * units::rpm;
  const MotorKind usual = otological ? MotorKind::surgical_drill : common_motor(speed);
  ToolHead head = drills ? twist_drill_head(2 * radius, 12 * radius) : ToolHead(SphereHead{radius});
  return Tool(std::move(head), RayHandle{0}, common_spindle(motor.value_or(usual), speed), Cutter{kind});
}

PushedCut push(const Tool& tool, const Material& material, double load, double longest) {
  const double radius = tool.head().cutting_radius(), voxel = radius / kVoxels, rim = rim_of(tool);
  SimulationConfig config;
  config.contact_time = ContactTime::end;
  Simulation simulation(block_around(tool.head(), rim, material), tool, config);
  const CouplingGains gains;
  VirtualCoupling coupling(simulation, gains);
  const Vec3 start(0.29 * voxel, 0.11 * voxel, -rim + 0.02 * mm), below(0, 0, load / gains.stiffness);
  PushedCut cut;
  Vec3 place = start, first = start;
  double time = 0, counted = 0, removed = 0, cutting = 0, impulse = 0;
  bool settled = false;
  // [s] in which a turbine finds its speed under the load
  const double spun_down = 3 * tool.spindle().rotor_inertia * tool.spindle().droop;
  longest += spun_down;
  const auto depth = [&] { return start.z() - place.z(); };
  coupling.step(Pose::from_translation(place), {}, kTick);
  // Counts the way of a voxel or more, so that every material is cut at the same places.
  while (time < longest && !(settled && counted >= kCounted && first.z() - place.z() >= voxel) &&
         depth() < (kDeep - 1.5) * radius) {
    const Vec3 hand = place - std::min(1.0, time / kRise) * below;
    const CoupledResult& result = coupling.step(Pose::from_translation(hand), coupling.last_result().V_WH, kTick);
    time += kTick;
    const bool loaded = time >= kRise || depth() > 0.5 * kDeep * radius;  // some fall through before
    if (!settled && loaded &&
        ((depth() >= kSettling * radius && time >= spun_down) || time >= 0.5 * (longest + spun_down) ||
         depth() > 0.5 * kDeep * radius)) {
      settled = true;
      first = place, cutting = simulation.last_result().energy.cutting;
      counted = removed = impulse = 0;
      cut.status = StepStatus::ok;
    }
    place = result.X_WH.translation;
    counted += kTick;
    removed += result.removed_volume;
    impulse += result.hand.force.z() * kTick;
    cut.status |= result.status;
  }
  cut.load_to_cut = simulation.last_result().contact.load_to_cut;
  cut.time = counted;
  cut.rate = removed / counted;
  cut.speed = (first.z() - place.z()) / counted;
  cut.force = impulse / counted;
  cut.power = (simulation.last_result().energy.cutting - cutting) / counted;
  return cut;
}

std::string pairs_report() {
  constexpr std::array kShown = {"enamel",  "amalgam",         "dentin",  "caries", "bone_d2",
                                 "bone_d3", "trabecular_bone", "bone_d4", "pulp",   "clay"};
  std::ostringstream report;
  report
      << "## Every cutter in every material\n\n"
         "Rates [mm^3/s] of usual tools, pushed along their axis with a constant force, behind the default coupling:\n"
         "a ball of 2 mm at 300000 rpm on `air_turbine` (dental) or at 80000 rpm on `surgical_drill` (mastoid), and\n"
         "a drill of 2 mm at 1500 rpm on `electric`. Cortical bone and `bone_d1` are as dentin. Where nothing limits "
         "a\n"
         "bur, it is 2.5 times as fast in `bone_d5` as in `bone_d4`.\n\n"
         "* \"edges\": the edges of the drill carry the load. Just above, the rate begins from 0.\n"
         "* A ball that removes more than 60 mm^3/s sinks faster than 20 mm/s: it plunges, which a hand would "
         "prevent.\n"
         "* \"limit\", \"stalls\": the motor was at its limit at some moment, or the spindle stalled. Then the order "
         "of\n"
         "  the materials ends: in a softer one the ball sinks in deeper and stalls the turbine more.\n"
         "* \"crushed\": the head is pressed in faster than it cuts.\n"
         "* Rates of two materials are as 1/share while the head is equally deep. Mastoid burs at 5 N and more sink\n"
         "  into soft bone beyond their equator, and cut more.\n"
         "* **Do not compare carbide with diamond**: each is fitted to another laboratory. Above 1 N carbide is\n"
         "  probably too fast, because no measurement supports its square of the load, and coarse diamonds are too\n"
         "  slow by 1.8 in the row above.\n\n| cutter | load [N] |";
  for (const char* material : kShown) report << " " << material << " |";
  report << "\n|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const auto& kind : names_of(Of<CutterKind>{})) {
    const Tool tool = usual_tool(kind.value);
    const bool is_dental = common_motor(tool.spindle().speed) == MotorKind::air_turbine;
    for (const double load : is_dental ? std::array{0.5, 1.0, 2.0, 4.0} : std::array{1.0, 2.0, 5.0, 10.0}) {
      report << "| " << kind.name << " | " << digits(load) << " |";
      for (const char* material : kShown)
        report << " " << cell_of(push(tool, find_preset(material, kind.value), load), load) << " |";
      report << "\n";
    }
  }
  return report.str();
}

}  // namespace hapticut::experiments
