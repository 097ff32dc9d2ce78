// SPDX-License-Identifier: Apache-2.0
#include "reports/report.hpp"

#include <cmath>

#include "hapticut/core/units.hpp"
#include "loop/hand_map.hpp"
#include "reports/table.hpp"

namespace hapticut::apps {
namespace {

Json by_material(const MaterialTable& materials, const ByMaterial<double>& volumes) {
  Json json = Json::object();
  for (int id = 1; id <= materials.size(); ++id) {
    const double volume = volumes[std::size_t(id)] / units::mm3;
    if (volume > 0 || materials.size() <= kFewMaterials) json[materials[MaterialId(id)].name] = volume;
  }
  return json;
}

/// [s] When a material was first touched, by its name, in the order of the ids; without materials that were not.
std::vector<std::pair<std::string, double>> first_touches(const Simulation& simulation, double rate) {
  std::vector<std::pair<std::string, double>> touches;
  simulation.totals().touched.for_each([&](MaterialId id) {
    touches.emplace_back(simulation.workpiece().materials()[id].name,
                         double(simulation.totals().first_touch[id]) / rate);
  });
  return touches;
}

Json first_touch_json(const Simulation& simulation, double rate) {
  Json json = Json::object();
  for (const auto& [name, time] : first_touches(simulation, rate)) json[name] = time;
  return json;
}

std::string first_touch_text(const Simulation& simulation, double rate) {
  std::string text;
  for (const auto& [name, time] : first_touches(simulation, rate))
    text += (text.empty() ? "" : ", ") + name + " at " + rounded(time, 6) + " s";
  return text.empty() ? "nothing" : text;
}

Json to_json(const EnergyLedger& e) {
  Json json = Json::object();
  for_each_field<EnergyLedger>([&](const auto& field) { json[field.name] = e.*field.member; });
  return json;
}

Json status_json(const DrillResult& result) {
  Json json = Json::object();
  for_each_bit<StepStatus>([&](StepStatus bit, const char* name) { json[name] = result.count(bit); });
  return json;
}

/// Whether a bit was set in so few steps of the contact as on the way into ordinary material, so that a table need not
/// list it.
bool is_of_entry(StepStatus bit, const DrillResult& result) {
  constexpr double kEntry = 0.05;  // [1] of the steps in contact
  constexpr StepStatus kOfEntry = StepStatus::engaged_layer_thick | StepStatus::edges_carry_load |
                                  StepStatus::material_crushed | StepStatus::point_thin;
  return has_any(kOfEntry, bit) && double(result.count(bit)) < kEntry * double(result.steps_in_contact);
}

/// [1] Shares of the materials in a sum, of those that have one.
Json shares_json(const MaterialTable& materials, const ByMaterial<double>& sums) {
  double all = 0;
  for (const double sum : sums) all += sum;
  Json shares = Json::object();
  for (int id = 1; id <= materials.size(); ++id)
    if (const double sum = sums[std::size_t(id)]; sum > 0) shares[materials[MaterialId(id)].name] = sum / all;
  return shares;
}

}  // namespace

WorkpieceSummary summarize(const std::string& source, const Workpiece& workpiece) {
  const IndexBox box = workpiece.bounds();
  WorkpieceSummary summary;
  summary.source = source;
  for (std::size_t axis = 0; axis < 3; ++axis) summary.dims[axis] = box.empty() ? 0 : box.max[axis] - box.min[axis] + 1;
  summary.voxel_size = workpiece.voxel_size();
  summary.size = summary.voxel_size * Vec3(summary.dims[0], summary.dims[1], summary.dims[2]);
  summary.X_WV = workpiece.frame().X_WV;
  summary.box = box_of_workpiece(workpiece);
  summary.memory_bytes = workpiece.memory_bytes();
  summary.amounts = workpiece.amounts();
  return summary;
}

Json in_mm(const Vec3& position) {
  const Vec3 p = position / units::mm;
  return {p.x(), p.y(), p.z()};
}

Json to_json(const Pose& pose) {
  Json rotation = Json::array();
  for (int row = 0; row < 3; ++row)
    rotation.push_back({pose.rotation(row, 0), pose.rotation(row, 1), pose.rotation(row, 2)});
  return {{"position_mm", in_mm(pose.translation)}, {"rotation", rotation}};
}

Json to_json(const Box& box) { return {{"min_mm", in_mm(box.min)}, {"max_mm", in_mm(box.max)}}; }

std::string dims_text(const std::array<int, 3>& dims) {
  return std::to_string(dims[0]) + " x " + std::to_string(dims[1]) + " x " + std::to_string(dims[2]);
}

std::string size_text(const Vec3& size) {
  const Vec3 mm = size / units::mm;
  return rounded(mm.x()) + " x " + rounded(mm.y()) + " x " + rounded(mm.z()) + " mm";
}

std::string position_text(const Vec3& position) {
  const auto text = [](double length) {
    const double mm = length / units::mm;
    return rounded(std::abs(mm) < 1e-9 ? 0 : mm);
  };
  return text(position.x()) + " " + text(position.y()) + " " + text(position.z());
}

std::string box_text(const Box& box) { return position_text(box.min) + " to " + position_text(box.max) + " mm"; }

Json to_json(const WorkpieceSummary& s, const MaterialTable& materials) {
  Json voxels = Json::object(), volumes = Json::object(), centers = Json::object();
  for (const MaterialAmount& amount : s.amounts) {
    if (amount.voxels == 0 && materials.size() > kFewMaterials) continue;
    voxels[materials[amount.material].name] = amount.voxels;
    volumes[materials[amount.material].name] = amount.volume / units::mm3;
    if (amount.voxels > 0) centers[materials[amount.material].name] = in_mm(amount.center);
  }
  return {{"source", s.source},
          {"size_mm", in_mm(s.size)},
          {"dims", s.dims},
          {"voxel_size_mm", s.voxel_size / units::mm},
          {"pose", to_json(s.X_WV)},
          {"box", to_json(s.box)},
          {"memory_bytes", s.memory_bytes},
          {"voxels", voxels},
          {"volume_mm3", volumes},
          {"center_mm", centers}};
}

Json to_json(const DrillReport& report, const DrillResult& r, const Simulation& simulation) {
  const MaterialTable& materials = simulation.workpiece().materials();
  Json json = {
      {"steps", r.steps},
      {"rate_Hz", report.rate},
      {"steps_in_contact", r.steps_in_contact},
      {"steps_cutting", r.steps_cutting},
      {"first_touch_s", first_touch_json(simulation, report.rate)},
      {"removed_volume_mm3",
       {{"total", r.removed_volume / units::mm3},
        {"by_material", by_material(materials, simulation.totals().removed_volume)}}},
      {"removed_voxels", r.removed_voxels},
      {"force_N", {{"max", r.max_force}, {"mean", r.mean_force}}},
      {"normal_force_share", shares_json(materials, r.pressed)},
      {"torque_Nmm", {{"max", r.max_torque / units::N_mm}, {"mean", r.mean_torque / units::N_mm}}},
      {"energy_closure", std::abs(r.energy.closure())},
      {"energy_J", to_json(r.energy)},
      {"step_time_us", {{"p50", r.times.p50}, {"p99", r.times.p99}, {"p999", r.times.p999}, {"max", r.times.max}}},
      {"deadline_misses", r.times.deadline_misses},
      {"workpiece", to_json(report.workpiece, materials)},
      {"build", build_json()},
      {"status", status_json(r)},
      {"warnings", report.warnings},
  };
  add_to(json, report.beside, materials);
  return json;
}

std::string to_table(const DrillReport& report, const DrillResult& r, const Simulation& simulation) {
  const MaterialTable& materials = simulation.workpiece().materials();
  const auto percent = [&](std::size_t count) { return rounded(100.0 * double(count) / double(r.steps), 3) + " %"; };
  Table table("hapticut drill: " + report.workpiece.source);
  table.add("workpiece", size_text(report.workpiece.size) + ", " + dims_text(report.workpiece.dims) + " voxels of " +
                             rounded(report.workpiece.voxel_size / units::mm) + " mm, " +
                             bytes(report.workpiece.memory_bytes));
  table.add("steps", std::to_string(r.steps) + " at " + rounded(report.rate, 6) + " Hz, " +
                         percent(r.steps_in_contact) + " in contact, " + percent(r.steps_cutting) +
                         " removing material");
  table.add("removed",
            rounded(r.removed_volume / units::mm3) + " mm^3, " + std::to_string(r.removed_voxels) + " voxels");
  const auto& volumes = simulation.totals().removed_volume;
  for (int id = 1; id <= materials.size() && materials.size() <= kFewMaterials; ++id)
    table.add("  " + materials[MaterialId(id)].name, rounded(volumes[std::size_t(id)] / units::mm3) + " mm^3");
  table.add("first touched", first_touch_text(simulation, report.rate));
  table.add("force", "max " + rounded(r.max_force) + " N, mean " + rounded(r.mean_force) + " N in contact");
  table.add("torque", "max " + rounded(r.max_torque / units::N_mm) + " Nmm, mean " +
                          rounded(r.mean_torque / units::N_mm) + " Nmm about the hand");
  const std::string crushed = r.energy.crushed > 0 ? ", crushed " + rounded(r.energy.crushed) + " J" : "";
  table.add("energy", "hand " + rounded(r.energy.hand_work) + " J, motor " + rounded(r.energy.motor_work) +
                          " J, cutting " + rounded(r.energy.cutting) + " J, rubbing " + rounded(r.energy.rubbing) +
                          " J" + crushed + ", unexplained fraction of the work " +
                          rounded(std::abs(r.energy.closure()), 2) + ", entered " + rounded(r.energy.entered, 2) +
                          " J");
  add_to(table, report.beside, materials);
  table.add("step time", "p50 " + rounded(r.times.p50, 3) + " us, p99 " + rounded(r.times.p99, 3) + " us, p99.9 " +
                             rounded(r.times.p999, 3) + " us, max " + rounded(r.times.max, 3) + " us, " +
                             std::to_string(r.times.deadline_misses) + " over 1 ms (processor time)");
  for_each_bit<StepStatus>([&](StepStatus bit, const std::string& name) {
    if (r.count(bit) > 0 && !is_of_entry(bit, r))
      table.add("status", name + " in " + std::to_string(r.count(bit)) + " steps");
  });
  for (const std::string& warning : report.warnings) table.add("warning", warning);
  return table.text();
}

}  // namespace hapticut::apps
