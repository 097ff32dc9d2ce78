// SPDX-License-Identifier: Apache-2.0
#include "reports/loop_report.hpp"

#include <algorithm>
#include <cmath>

#include "hapticut/core/units.hpp"
#include "reports/flag_words.hpp"
#include "reports/shared_warnings.hpp"
#include "reports/table.hpp"
#include "simulation/status_limits.hpp"

namespace hapticut::apps {
namespace {

constexpr double kMicrosecond = 1e-6;
constexpr double kHardlyAnyCut = 0.1;  // [1] cutting's part of the work of edges in a run, whose beginning may cut more

Json to_json(const LatencyHistogram& h) {
  Json buckets = Json::array();  // [lower edge in us, count], without empty buckets
  for (std::size_t n = 0; n < LatencyHistogram::kBuckets; ++n)
    if (h.buckets()[n] > 0) buckets.push_back({n, h.buckets()[n]});
  const auto us = [](double seconds) { return seconds / kMicrosecond; };
  return {{"count", h.count()},          {"min", us(h.min())},
          {"mean", us(h.mean())},        {"p50", us(h.quantile(0.5))},
          {"p99", us(h.quantile(0.99))}, {"p999", us(h.quantile(0.999))},
          {"max", us(h.max())},          {"longer_than_2_ms", h.longer()},
          {"buckets", buckets}};
}

std::string text_of(const LatencyHistogram& h) {
  const auto us = [](double seconds) { return rounded(seconds / kMicrosecond, 3) + " us"; };
  return "p50 " + us(h.quantile(0.5)) + ", p99 " + us(h.quantile(0.99)) + ", p99.9 " + us(h.quantile(0.999)) +
         ", max " + us(h.max());
}

}  // namespace

std::vector<std::string> warnings_of(const LoopReport& r) {
  const ToolSnapshot& tool = r.seen.last.tool;
  const auto saw = [&](StepStatus bit) { return has_any(tool.status_seen, bit); };
  const auto happened = [&](SafetyEvent event) { return r.run.events[std::size_t(event)] > 0; };
  const bool cuts = r.simulation.config().removal != RemovalLaw::none;
  const bool stays_inside = happened(SafetyEvent::start_inside) && !happened(SafetyEvent::fading_in);
  std::vector<std::string> warnings;
  const auto warn = [&](const Sentence& warning) { warnings.push_back(in_words_of_flags(warning)); };
  if (!cuts && r.simulation.last_result().energy.turnover > 0) warn(removal_is_off());
  for (const Sentence& unsuited : warnings_of_cutter(r.simulation)) warn(unsuited);
  if (const auto strong = warning_of_force(r.seen.last.max_commanded)) warn(*strong);
  warnings.insert(warnings.end(), r.run.warnings.begin(), r.run.warnings.end());
  if (r.device.name() == "mouse")
    warn("this program has no window, so the mouse moved nothing; MouseDevice needs a program with a window.");
  if (stays_inside)
    warn("the tool was in the material from the start, so the guard gave no force; move " + "loop.origin_mm"_name +
         " above it.");
  else if (has_any(tool.status, StepStatus::tool_waits))
    warn(
        "at the end the hand was inside material that the tool had not cut, so there was no force; move the hand out "
        "of the material.");
  else if (tool.steps > 0 && tool.touched.empty())
    warn("the tool never touched the workpiece; move " + "loop.origin_mm"_name + ", or give a longer path.");
  if (saw(StepStatus::spindle_stands))
    warn("the spindle stood in contact, so the head pressed, rubbed and crushed, but did not cut; set " +
         "tool.spindle_rpm"_name + ".");
  else if (saw(StepStatus::engaged_layer_thick))
    warn(
        "the engaged layer was thicker than a tenth of the head, so forces are too low: the material is too soft for "
        "the feed; " +
        "simulation.reference_stiffness_N_per_m4"_name + " is " +
        rounded(r.simulation.config().reference_stiffness, 2) + " N/m^4.");
  const EnergyLedger& energy = r.simulation.last_result().energy;
  const MotorAdvice motor = advice_on_motor(r.simulation.tool().spindle());
  if (cuts && saw(StepStatus::spindle_stalled))
    warn("the load stalled the spindle, and the head did not cut until it ran again; " + motor.limits + ". Press less" +
         motor.cure + ".");
  if (cuts && saw(StepStatus::edges_carry_load) && energy.cutting < kHardlyAnyCut * energy.rubbing) {
    const BluntEdges edges = blunt_edges(r.simulation);
    const double peak = r.device.capabilities().peak_force;
    const bool too_much = peak > 0 && peak < edges.load;
    warn("the edges of the drill carried the load, so it cut hardly anything; press harder than " +
         rounded(edges.load, 3) + " N" +
         (too_much ? ", of which the device gives " + rounded(peak, 3) + " N, or take a thinner drill" : "") +
         sharper_drill(edges) + ".");
  }
  if (saw(StepStatus::material_crushed) && !saw(StepStatus::spindle_stands | StepStatus::spindle_stalled) &&
      energy.crushed > kMuchCrushed * (energy.crushed + std::max(0.0, energy.cutting)))
    warn(std::string("the head crushed material where it did not cut it; ") + kCureOfCrushing);
  const std::uint64_t slow = r.run.compute.at_least(r.run.period);
  if (double(slow) > kOftenSlow * double(r.run.ticks))
    warn(std::to_string(slow) + " of " + std::to_string(r.run.ticks) +
         " ticks took longer than their period, so that a hand would feel the force late; choose larger "
         "voxels, a smaller head or " +
         "simulation.voxel_budget"_name + ".");
  if (saw(StepStatus::blocks_exhausted))
    warn("some material was not cut because free blocks were missing; raise " + "simulation.reserved_blocks"_name +
         ".");
  if (r.steps_lost > 0)
    warn((r.recording_failure.empty() ? "the disk was too slow: " : "the recording failed early: ") +
         std::to_string(r.steps_lost) + " steps are missing in the recording." +
         (r.recording_failure.empty() ? "" : " The reason: " + r.recording_failure));
  for (std::string& warning : warnings_of(r.beside, r.simulation.workpiece().materials()))
    warnings.push_back(std::move(warning));
  return warnings;
}

Json to_json(const LoopReport& r) {
  Json events = Json::object(), log = Json::array(), status = Json::array(), touched = Json::array();
  r.seen.last.tool.touched.for_each(
      [&](MaterialId id) { touched.push_back(r.simulation.workpiece().materials()[id].name); });
  for_each_bit<StepStatus>([&](StepStatus bit, const char* name) {
    if (has_any(r.seen.last.tool.status_seen, bit)) status.push_back(name);
  });
  for (std::size_t n = 0; n < kSafetyEvents; ++n)
    if (r.run.events[n] > 0) events[std::string(name_of(SafetyEvent(n)))] = r.run.events[n];
  for (const SafetyLogEntry& entry : r.run.log)
    log.push_back({{"time_s", entry.time}, {"event", std::string(name_of(entry.event))}, {"value", entry.value}});
  const DeviceCapabilities& device = r.device.capabilities();
  Json json = {
      {"device",
       {{"name", r.device.name()},
        {"model", device.model},
        {"peak_force_N", device.peak_force},
        {"stiffness_N_per_m", device.stiffness}}},
      {"coupling", r.coupled ? "virtual" : "none"},
      {"rate_Hz", 1 / r.run.period},
      {"ticks", r.run.ticks},
      {"missed_ticks", r.run.missed},
      {"end", r.run.end},
      {"arming", name_of(r.run.arming)},
      {"wake_up_us", to_json(r.run.wake_up)},
      {"compute_us", to_json(r.run.compute)},
      {"deadline_misses", r.run.compute.at_least(r.run.period)},
      {"safety_events", events},
      {"safety_log", log},
      {"steps", r.seen.last.tool.steps},
      {"status_seen", status},
      {"touched", touched},
      {"max_per_tick",
       {{"sub_ticks", r.seen.last.tool.max_effort.sub_ticks},
        {"newton_steps", r.seen.last.tool.max_effort.newton_steps},
        {"level_of_detail", r.seen.last.tool.max_effort.level_of_detail}}},
      {"removed_volume_mm3", r.seen.last.tool.removed_volume / units::mm3},
      {"force_N",
       {{"max_commanded", r.seen.last.max_commanded},
        {"max_applied", r.seen.last.max_applied},
        {"applied_at_end", r.seen.last.output.applied.force.norm()}}},
      {"energy_closure", std::abs(r.simulation.last_result().energy.closure())},
      {"energy_entered_J", r.simulation.last_result().energy.entered},
      {"graphics",
       {{"frames", r.seen.frames}, {"blocks", r.seen.blocks}, {"max_blocks_waiting", r.seen.max_blocks_waiting}}},
      {"steps_lost_by_recorder", r.steps_lost},
      {"workpiece", to_json(r.workpiece, r.simulation.workpiece().materials())},
      {"build", build_json()},
      {"warnings", warnings_of(r)},
  };
  add_to(json, r.beside, r.simulation.workpiece().materials());
  return json;
}

std::string to_table(const LoopReport& r) {
  Table table("hapticut loop: " + r.device.name());
  const DeviceCapabilities& device = r.device.capabilities();
  table.add("device", (device.model.empty() ? "unknown" : device.model) + ", " + rounded(device.peak_force) + " N, " +
                          rounded(device.stiffness) + " N/m, " +
                          (r.coupled ? "behind a virtual coupling" : "driven directly"));
  table.add("workpiece", r.workpiece.source + ", voxels of " + rounded(r.workpiece.voxel_size / units::mm) + " mm");
  table.add("ticks", std::to_string(r.run.ticks) + " at " + rounded(1 / r.run.period, 6) + " Hz, " +
                         std::to_string(r.run.missed) + " missed; " + r.run.end);
  if (r.run.wake_up.count() > 0) table.add("wake-up", text_of(r.run.wake_up) + " late");
  table.add("compute",
            text_of(r.run.compute) + ", " + std::to_string(r.run.compute.at_least(r.run.period)) + " over the period");
  const TickEffort& effort = r.seen.last.tool.max_effort;
  table.add("maximum per tick", std::to_string(effort.sub_ticks) +
                                    (effort.sub_ticks == 1 ? " sub-tick, " : " sub-ticks, ") +
                                    std::to_string(effort.newton_steps) + " Newton steps, level of detail " +
                                    std::to_string(effort.level_of_detail));
  table.add("removed", rounded(r.seen.last.tool.removed_volume / units::mm3) + " mm^3 in " +
                           std::to_string(r.seen.last.tool.steps) + " steps");
  const EnergyLedger& energy = r.simulation.last_result().energy;
  table.add("energy", "unexplained fraction of the work " + rounded(std::abs(energy.closure()), 2) + ", entered " +
                          rounded(energy.entered, 2) + " J");
  add_to(table, r.beside, r.simulation.workpiece().materials());
  table.add("force", "maximum: " + rounded(r.seen.last.max_commanded) + " N commanded, " +
                         rounded(r.seen.last.max_applied) + " N applied");
  table.add("graphics", std::to_string(r.seen.frames) + " frames, " + std::to_string(r.seen.blocks) +
                            " changed blocks, at most " + std::to_string(r.seen.max_blocks_waiting) + " waiting");
  for_each_bit<StepStatus>([&](StepStatus bit, const std::string& name) {
    if (has_any(r.seen.last.tool.status_seen, bit)) table.add("status", name + " in one or more steps");
  });
  table.add("arming", std::string(name_of(r.run.arming)) + " at the end");
  for (std::size_t n = 0; n < kSafetyEvents; ++n)
    if (r.run.events[n] > 0)
      table.add("safety", std::string(name_of(SafetyEvent(n))) + " in " + std::to_string(r.run.events[n]) + " ticks");
  for (const std::string& warning : warnings_of(r)) table.add("warning", warning);
  return table.text();
}

}  // namespace hapticut::apps
