// SPDX-License-Identifier: Apache-2.0
// include/hapticut/simulation: what goes into a step and what comes out
#include "bindings.hpp"
#include "simulation.hpp"
#include "steps.hpp"
#include "structs.hpp"

namespace hapticut::python {

namespace {

void bind_result_of_step(py::module_& m) {
  bind_bits<StepStatus>(m, "StepStatus",
                        {{"ok", StepStatus::ok},
                         {"pose_rejected", StepStatus::pose_rejected},
                         {"velocity_rejected", StepStatus::velocity_rejected},
                         {"dt_rejected", StepStatus::dt_rejected},
                         {"jump_rejected", StepStatus::jump_rejected},
                         {"blocks_low", StepStatus::blocks_low},
                         {"blocks_exhausted", StepStatus::blocks_exhausted},
                         {"removed_list_full", StepStatus::removed_list_full},
                         {"power_limited", StepStatus::power_limited},
                         {"engaged_layer_thick", StepStatus::engaged_layer_thick},
                         {"vibration_left_out", StepStatus::vibration_left_out},
                         {"detail_reduced", StepStatus::detail_reduced},
                         {"force_not_finite", StepStatus::force_not_finite}});
  m.attr("kRejected") = std::uint32_t(kRejected);
  m.def(
      "has", [](std::uint32_t bits, StepStatus wanted) { return has(StepStatus(bits), wanted); }, py::arg("status"),
      py::arg("bits"), doc("has"));
  bind_result<Contact>(m, "Contact", member("voxels", &Contact::voxels), member("volume", &Contact::volume),
                       member("depth", &Contact::depth), member("turns", &Contact::turns));
  bind_result<SpindleState>(m, "SpindleState", member("speed", &SpindleState::speed),
                            member("torque", &SpindleState::torque));
  using E = EnergyLedger;
  bind_result<E>(m, "EnergyLedger", member("hand_work", &E::hand_work), member("motor_work", &E::motor_work),
                 member("elastic", &E::elastic), member("cutting", &E::cutting), member("released", &E::released),
                 member("damping", &E::damping), member("rubbing", &E::rubbing), member("anchored", &E::anchored),
                 member("sliding", &E::sliding), member("credited", &E::credited), member("entered", &E::entered))
      .def("imbalance", &E::imbalance, doc("EnergyLedger::imbalance"))
      .def("closure", &E::closure, doc("EnergyLedger::closure"));

  using R = PythonStepResult;
  py::class_<R>(m, "StepResult",
                "What one step returns. It owns what it holds and stays as it is when further steps are made.")
      .def_property_readonly(
          "force", [](const R& r) { return r.result.force; }, doc("StepResult::force"))
      .def_property_readonly(
          "torque", [](const R& r) { return r.result.torque; }, doc("StepResult::torque"))
      .def_property_readonly(
          "removed_voxels", [](const py::object& self) { return voxel_indices(self.cast<const R&>().voxels, self); },
          "(n, 3) int32: indices of the voxels that this step emptied; read-only.")
      .def_property_readonly(
          "removed_materials",
          [](const py::object& self) { return voxel_materials(self.cast<const R&>().voxels, self); },
          "(n,) uint8: what each of the removed voxels was made of; read-only.")
      .def_property_readonly(
          "removed_volume", [](const R& r) { return r.result.removed_volume; }, doc("StepResult::removed_volume"))
      .def_property_readonly(
          "contact", [](const R& r) { return r.result.contact; }, doc("StepResult::contact"))
      .def_property_readonly(
          "model", [](const R& r) { return r.result.model; }, doc("StepResult::model"))
      .def_property_readonly(
          "energy", [](const R& r) { return r.result.energy; }, doc("StepResult::energy"))
      .def_property_readonly(
          "spindle", [](const R& r) { return r.result.spindle; }, doc("StepResult::spindle"))
      .def_property_readonly(
          "sub_steps", [](const R& r) { return r.result.sub_steps; }, doc("StepResult::sub_steps"))
      .def_property_readonly(
          "status", [](const R& r) { return std::uint32_t(r.result.status); },
          "Bits of StepStatus; 0 = nothing to report.")
      .def("__repr__", [](const py::object& self) {
        const auto text = [&](const char* name) { return std::string(py::repr(self.attr(name))); };
        return "StepResult(force=" + text("force") + ", torque=" + text("torque") +
               ", removed_volume=" + text("removed_volume") + ", status=" + text("status") + ")";
      });

  bind_result<ContactProbe>(m, "ContactProbe", member("wrench", &ContactProbe::wrench),
                            member("stiffness", &ContactProbe::stiffness), member("contact", &ContactProbe::contact),
                            member("sliding", &ContactProbe::sliding));
}

}  // namespace

void bind_results(py::module_& m) {
  PYBIND11_NUMPY_DTYPE(ContactRow, voxels, volume, depth, turns);
  PYBIND11_NUMPY_DTYPE(WrenchRow, force, torque);
  PYBIND11_NUMPY_DTYPE(SpindleRow, speed, torque);
  PYBIND11_NUMPY_DTYPE(EnergyRow, hand_work, motor_work, elastic, cutting, released, damping, rubbing, anchored,
                       sliding, credited, entered);
  PYBIND11_NUMPY_DTYPE(TraceRow, time, force, torque, removed_voxels, removed_volume, contact, model, energy, spindle,
                       sub_steps, status);
  PYBIND11_NUMPY_DTYPE(RemovedInRun, step, index, material);
  bind_struct<StepInput>(m, "StepInput", field("pose", &StepInput::pose), field("velocity", &StepInput::velocity),
                         field("dt", &StepInput::dt));
  bind_result_of_step(m);
}

}  // namespace hapticut::python
