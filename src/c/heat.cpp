// SPDX-License-Identifier: Apache-2.0
// Temperatures of the workpiece, for a thread that looks at them.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "c/simulation_object.hpp"
#include "c/structs.hpp"
#include "hapticut/heat/heat_collector.hpp"
#include "hapticut/heat/heat_field.hpp"
#include "hapticut/heat/thermal_properties.hpp"

namespace hapticut {

constexpr auto fields_of(Of<hapticut_heat_structure_info>) {
  using S = hapticut_heat_structure_info;
  return std::tuple{HAPTICUT_C_FIELD(S, material), HAPTICUT_C_FIELD(S, temperature),
                    HAPTICUT_C_FIELD(S, peak),     HAPTICUT_C_FIELD(S, time_above),
                    HAPTICUT_C_FIELD(S, cem43),    HAPTICUT_C_FIELD(S, volume_above)};
}

constexpr auto fields_of(Of<hapticut_heat_balance_info>) {
  using B = hapticut_heat_balance_info;
  return std::tuple{HAPTICUT_C_FIELD(B, brought_in), HAPTICUT_C_FIELD(B, stored), HAPTICUT_C_FIELD(B, chips),
                    HAPTICUT_C_FIELD(B, irrigation)};
}

}  // namespace hapticut

namespace hapticut::c {
namespace {

static_assert(kHasEachField<StructureHeat, hapticut_heat_structure_info>, "C needs the new field, at the end");
static_assert(kHasEachField<HeatBalance, hapticut_heat_balance_info>, "C needs the new field, at the end");

class HeatObject final : public Object {
 public:
  static constexpr Kind kKind = Kind::heat;

  /// @pre the simulation is idle
  HeatObject(std::shared_ptr<SimulationObject> a_simulation, HeatConfig config)
      : simulation(std::move(a_simulation)),
        field(simulation->simulation.workpiece(), std::move(config)),
        collector(std::make_shared<HeatCollector>(simulation->simulation)) {}
  ~HeatObject() override {
    SimulationObject& owner = *simulation;
    owner.retire(std::move(collector));
  }

  void advance(double dt) {
    structures.clear();
    field.advance(dt);
  }

  const std::shared_ptr<SimulationObject> simulation;
  HeatField field;
  std::shared_ptr<HeatCollector> collector;
  std::vector<StructureHeat> structures;  // of the present temperatures; empty: not known
};

/// @param config  of the scene
HeatConfig config_of(HeatConfig config, const hapticut_heat_config& given) {
  set_if_given(std::min(given.voxels_per_cell, kTooMany), config.voxels_per_cell);
  set_if_given(given.cutting_share, config.cutting_share);
  set_if_given(given.rubbing_share, config.rubbing_share);
  set_if_given(given.body_temperature, config.body_temperature);
  set_if_given(given.irrigation, config.irrigation);
  set_if_given(given.water_temperature, config.water_temperature);
  set_if_given(given.threshold, config.threshold);
  return config;
}

/// The properties of all materials: those that the caller gives, else those of the scene, else those of their names.
/// @param properties  of the scene, for each material, or empty
std::vector<ThermalProperties> properties_of(const MaterialTable& materials, std::vector<ThermalProperties> properties,
                                             const hapticut_thermal_properties* given, std::size_t count) {
  for (std::size_t n = properties.size(); n < std::size_t(materials.size()); ++n)
    properties.push_back(thermal_properties_of(materials[MaterialId(n + 1)].name));
  if (count > properties.size())
    throw Refusal(HAPTICUT_ERROR_ARGUMENT, "count = " + std::to_string(count) + "; this scene has " +
                                               std::to_string(properties.size()) + " materials.");
  for (std::size_t n = 0; n < count; ++n) {
    set_if_given(given[n].conductivity, properties[n].conductivity);
    set_if_given(given[n].heat_capacity, properties[n].heat_capacity);
  }
  return properties;
}

/// The temperature [deg C], peak [deg C] or dose [min] of a cell; NaN without material.
double value_of(const HeatField& field, hapticut_heat_quantity quantity, const std::array<int, 3>& cell) {
  const double temperature = field.temperature(cell);
  if (quantity == HAPTICUT_HEAT_TEMPERATURE || std::isnan(temperature)) return temperature;
  return quantity == HAPTICUT_HEAT_PEAK ? field.peak(cell) : field.dose(cell);
}

}  // namespace
}  // namespace hapticut::c

using namespace hapticut;
using namespace hapticut::c;

extern "C" {

int hapticut_heat_open(hapticut_simulation simulation, const hapticut_heat_config* config,
                       const hapticut_thermal_properties* by_material, size_t count, hapticut_heat* heat) {
  return within(IdleSimulation(simulation), [&](const auto& use) -> int {
    require_argument(heat, "heat");
    if (count > 0) require_argument(by_material, "by_material");
    hapticut_heat_config given;
    if (const int code = read_struct_if_given(config, "config", given); code != HAPTICUT_OK) return code;
    HeatConfig own = config_of(use->heat.value_or(HeatConfig{}), given);
    own.by_material =
        properties_of(use->simulation.workpiece().materials(), std::move(own.by_material), by_material, count);
    use.pointer()->sweep();
    *heat = add_object(Kind::heat, std::make_shared<HeatObject>(use.pointer(), std::move(own)));
    return HAPTICUT_OK;
  });
}

int hapticut_heat_update(hapticut_heat heat, double* time) {
  return within(Use<HeatObject>(heat), [&](const auto& use) {
    const double drained = use->field.drain(*use->collector);
    use->advance(drained);
    if (time != nullptr) *time = drained;
  });
}

int hapticut_heat_advance(hapticut_heat heat, double dt) {
  return within(Use<HeatObject>(heat), [&](const auto& use) { use->advance(dt); });
}

int hapticut_heat_set_irrigation(hapticut_heat heat, double coefficient) {
  return within(Use<HeatObject>(heat), [&](const auto& use) { use->field.set_irrigation(coefficient); });
}

int hapticut_heat_temperature_at(hapticut_heat heat, const double* p_WQ, double* temperature) {
  return within(Use<HeatObject>(heat), [&](const auto& use) -> int {
    require_argument(p_WQ, "p_WQ");
    require_argument(temperature, "temperature");
    const Vec3 point = vector_of(p_WQ);
    if (!is_finite(point))
      throw Refusal(HAPTICUT_ERROR_ARGUMENT, "p_WQ is not finite; it must have three finite numbers [m].");
    const double found = use->field.temperature_at(point);
    if (std::isnan(found)) return HAPTICUT_NOTHING;
    *temperature = found;
    return HAPTICUT_OK;
  });
}

int hapticut_heat_structure(hapticut_heat heat, uint32_t id, hapticut_heat_structure_info* info) {
  if (const int code = check_size(info, "info"); code != HAPTICUT_OK) return code;
  return within(Use<HeatObject>(heat), [&](const auto& use) {
    require_material(use->simulation->simulation.workpiece(), id);
    if (use->structures.empty()) use->structures = use->field.structures();
    hapticut_heat_structure_info own{};
    put_fields(use->structures[id - 1], own);
    write_struct(own, info);
  });
}

int hapticut_heat_balance(hapticut_heat heat, hapticut_heat_balance_info* info) {
  if (const int code = check_size(info, "info"); code != HAPTICUT_OK) return code;
  return within(Use<HeatObject>(heat), [&](const auto& use) {
    const HeatBalance balance = use->field.balance();
    hapticut_heat_balance_info own{};
    put_fields(balance, own);
    own.imbalance = balance.imbalance();
    write_struct(own, info);
  });
}

int hapticut_heat_grid(hapticut_heat heat, hapticut_heat_grid_info* info) {
  if (const int code = check_size(info, "info"); code != HAPTICUT_OK) return code;
  return within(Use<HeatObject>(heat), [&](const auto& use) {
    const HeatField& field = use->field;
    const GridFrame& frame = use->simulation->simulation.workpiece().frame();  // never changes
    hapticut_heat_grid_info own{};
    std::ranges::copy(field.dims(), own.dims);
    own.cell_size = field.cell_size();
    put(Pose{frame.X_WV.rotation, field.center({0, 0, 0})}, own.X_WC);
    write_struct(own, info);
  });
}

int hapticut_heat_cells(hapticut_heat heat, uint32_t quantity, float* values, size_t count) {
  return within(Use<HeatObject>(heat), [&](const auto& use) {
    require_argument(values, "values");
    if (quantity > HAPTICUT_HEAT_DOSE)
      throw Refusal(HAPTICUT_ERROR_ARGUMENT,
                    "quantity = " + std::to_string(quantity) + "; it must be one of hapticut_heat_quantity.");
    const HeatField& field = use->field;
    const auto [across, deep, high] = field.dims();
    const std::size_t cells = std::size_t(across) * std::size_t(deep) * std::size_t(high);
    if (count != cells)
      throw Refusal(HAPTICUT_ERROR_ARGUMENT, "count = " + std::to_string(count) + "; the heat field has " +
                                                 std::to_string(cells) + " cells, see hapticut_heat_grid.");
    for (int k = 0; k < high; ++k)
      for (int j = 0; j < deep; ++j)
        for (int i = 0; i < across; ++i)
          *values++ = float(value_of(field, hapticut_heat_quantity(quantity), {i, j, k}));
  });
}

}  // extern "C"
