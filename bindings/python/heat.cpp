// SPDX-License-Identifier: Apache-2.0
// include/hapticut/heat
#include <functional>
#include <memory>

#include "bindings.hpp"
#include "hapticut/heat/heat_collector.hpp"
#include "hapticut/heat/heat_field.hpp"
#include "hapticut/workpiece/block_grid.hpp"
#include "interruption.hpp"
#include "simulation.hpp"
#include "steps.hpp"
#include "structs.hpp"
#include "tool_head.hpp"

namespace hapticut::python {

namespace {

using Cell = std::array<int, 3>;

using CellNumber = double (HeatField::*)(const Cell& cell) const;

/// (nx, ny, nz) array of one number per cell.
py::array cells_of(const HeatField& field, CellNumber number) {
  const Cell dims = field.dims();
  py::array_t<double> all({dims[0], dims[1], dims[2]});
  double* next = all.mutable_data();
  for_each_voxel({{0, 0, 0}, {dims[0] - 1, dims[1] - 1, dims[2] - 1}},
                 [&](const Cell& cell) { *next++ = std::invoke(number, field, cell); });
  return all;
}

/// @throws IndexError when there is no such cell
const Cell& inside(const HeatField& field, const Cell& cell) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (cell[axis] < 0 || cell[axis] >= field.dims()[axis]) throw py::index_error("there is no such cell");
  return cell;
}

/// Bindings for one cell and for all cells.
auto of_cell(CellNumber number) {
  return [number](const HeatField& field, const Cell& cell) { return std::invoke(number, field, inside(field, cell)); };
}
auto of_cells(CellNumber number) {
  return [number](const HeatField& field) { return cells_of(field, number); };
}

void bind_collector(py::module_& m) {
  using C = HeatCollector;
  bind_described_result<HeatPulse>(m, "HeatPulse");
  bind_described<HeatCollectorOptions>(m, "HeatCollectorOptions");
  py::class_<C, std::shared_ptr<C>>(m, "HeatCollector",
                                    (std::string(doc("HeatCollector")) + "\n\nIt keeps its simulation alive.").c_str())
      .def(py::init([](const std::shared_ptr<PythonSimulation>& simulation, const HeatCollectorOptions& options) {
             simulation->occupancy.require_writable("The simulation");
             simulation->remove_deleted_observers();
             auto collector = std::make_shared<C>(simulation->simulation, options);
             simulation->observers.push_back(collector);
             return collector;
           }),
           py::keep_alive<1, 2>(), py::arg("simulation"), py::arg("options") = HeatCollectorOptions{},
           doc("HeatCollector::HeatCollector"))
      .def(
          "receive",
          [](C& self) {
            std::optional<HeatPulse> pulse(std::in_place);
            if (!self.receive(*pulse)) pulse.reset();
            return pulse;
          },
          "Removes and returns one pulse; None when there is none. HeatField.drain handles all pulses.")
      .def(
          "receive_block",
          [](C& self) {
            std::optional<ChangedBlock> block(std::in_place);
            if (!self.receive(*block)) block.reset();
            return block;
          },
          "Removes and returns one changed block; None when there is none.");
  m.def("touching_point", &touching_point, py::arg("head"), py::arg("wrench_T"), doc("touching_point"));
}

}  // namespace

void bind_heat(py::module_& m) {
  bind_collector(m);
  bind_described<ThermalProperties>(m, "ThermalProperties");
  bind_described<HeatConfig>(m, "HeatConfig");
  bind_described_result<StructureHeat>(m, "StructureHeat");
  bind_described_result<WarmestPlace>(m, "WarmestPlace");
  bind_described_result<HeatBalance>(m, "HeatBalance")
      .def("imbalance", &HeatBalance::imbalance, doc("HeatBalance::imbalance"));
  bind_described_result<KnownThermalProperties>(m, "KnownThermalProperties");
  m.def(
      "known_thermal_properties",
      [] {
        const auto known = known_thermal_properties();
        return std::vector(known.begin(), known.end());
      },
      doc("known_thermal_properties"));
  m.def("thermal_properties_of", &thermal_properties_of, py::arg("material"), doc("thermal_properties_of"));
  m.def("cem43", &cem43, py::arg("temperature"), py::arg("time"), doc("cem43"));
  using F = HeatField;
  using Interruptible = py::call_guard<SignalChecks>;
  py::class_<F>(m, "HeatField", doc("HeatField"))
      .def(py::init(
               [](const PythonWorkpiece& workpiece, const HeatConfig& config) { return F(workpiece.read(), config); }),
           py::arg("workpiece"), py::arg("config") = HeatConfig{}, doc("HeatField::HeatField"), Interruptible())
      .def("drain", &F::drain, py::arg("collector"), doc("HeatField::drain"))
      .def("add_heat", &F::add_heat, py::arg("p_WQ"), py::arg("heat"), py::arg("radius") = 0.0,
           doc("HeatField::add_heat"))
      .def("add_cutting_heat", &F::add_cutting_heat, py::arg("heat"), doc("HeatField::add_cutting_heat"))
      .def(
          "update",
          [](F& self, const PythonWorkpiece& workpiece, const py::array_t<std::int32_t, py::array::c_style>& origins) {
            self.update(workpiece.read(), origins_from(origins));
          },
          py::arg("workpiece"), py::arg("origins"), doc("HeatField::update(Workpiece, span)"))
      .def(
          "update",
          [](F& self, const ChangedBlock& block) {
            self.update(block.origin, block.material.data(), block.fill.data());
          },
          py::arg("block"), doc("HeatField::update(VoxelIndex, MaterialId, float)"))
      .def("advance", &F::advance, py::arg("dt"), doc("HeatField::advance"), Interruptible())
      .def("set_irrigation", &F::set_irrigation, py::arg("coefficient"), doc("HeatField::set_irrigation"))
      .def_property_readonly("config", &F::config, py::return_value_policy::copy, "A copy of its configuration.")
      .def("structures", &F::structures, doc("HeatField::structures"))
      .def("balance", &F::balance, doc("HeatBalance"))
      .def("warmest", &F::warmest, doc("HeatField::warmest"))
      .def("temperature_at", &F::temperature_at, py::arg("p_WQ"), doc("HeatField::temperature_at"))
      .def_property_readonly("dims", &F::dims, "Number of cells along each axis.")
      .def_property_readonly("cell_size", &F::cell_size, "[m] edge of a cell.")
      .def("center", &F::center, py::arg("cell"), "[m] (3,) centre of a cell, in W.")
      .def("temperature", of_cell(&F::temperature), py::arg("cell"),
           "[deg C] temperature of a cell; NaN without material.")
      .def("peak", of_cell(&F::peak), py::arg("cell"), "[deg C] maximum so far of a cell.")
      .def("dose", of_cell(&F::dose), py::arg("cell"), "[min] CEM43 of a cell.")
      .def("temperatures", of_cells(&F::temperature),
           "[deg C] (nx, ny, nz) of all cells; NaN in cells without material.")
      .def("peaks", of_cells(&F::peak), "[deg C] (nx, ny, nz) maximum so far.")
      .def("doses", of_cells(&F::dose), "[min] (nx, ny, nz) CEM43.");
}

}  // namespace hapticut::python
