// SPDX-License-Identifier: Apache-2.0
// include/hapticut/simulation: input and result of a step
#include "bindings.hpp"
#include "hapticut/simulation/status_sentences.hpp"
#include "simulation.hpp"
#include "steps.hpp"
#include "structs.hpp"

namespace hapticut::python {

namespace {

void bind_result_of_step(py::module_& m) {
  bind_bits<StepStatus>(m, "StepStatus");
  m.attr("kRejected") = std::uint32_t(kRejected);
  m.def(
      "has_any", [](std::uint32_t bits, StepStatus wanted) { return has_any(StepStatus(bits), wanted); },
      py::arg("status"), py::arg("bits"), doc("has_any(StepStatus, StepStatus)"));
  m.def(
      "describe_status", [](std::uint32_t status) { return describe(StepStatus(status)); }, py::arg("status"),
      "The names of all bits that are set: \"ok\", \"blocks_low | engaged_layer_thick\".");
  m.def(
      "sentences_of", [](std::uint32_t status) { return sentences_of(StepStatus(status)); }, py::arg("status"),
      doc("sentences_of"));
  bind_described_result<Contact>(m, "Contact");
  bind_described_result<SpindleState>(m, "SpindleState");
  using E = EnergyLedger;
  bind_described_result<E>(m, "EnergyLedger")
      .def("stored", &E::stored, doc("EnergyLedger::stored"))
      .def("losses", &E::losses, doc("EnergyLedger::losses"))
      .def("imbalance", &E::imbalance, doc("EnergyLedger::imbalance"))
      .def("closure", &E::closure, doc("EnergyLedger::closure"));

  using R = PythonStepResult;
  py::class_<R> result(m, "StepResult",
                       "Result of one step. It owns its data and does not change when further steps are made.");
  for_each_field<StepResult>([&](const auto& field) {
    using T = typename std::remove_cvref_t<decltype(field)>::Type;
    if constexpr (std::is_same_v<T, std::span<const RemovedVoxel>>) {
      result.def_property_readonly(
          field.name, [](const py::object& self) { return voxel_indices(self.cast<const R&>().voxels, self); },
          "(n, 3) int32: indices of the voxels that this step emptied; read-only.");
    } else {
      const std::string text = detail::doc_of_described(field, "StepResult");
      result.def_property_readonly(
          field.name,
          [member = field.member](const R& r) {
            if constexpr (Bits<T>)
              return std::uint32_t(r.result.*member);
            else
              return r.result.*member;
          },
          text.c_str());
    }
  });
  result
      .def_property_readonly(
          "removed_materials",
          [](const py::object& self) { return voxel_materials(self.cast<const R&>().voxels, self); },
          "(n,) uint8: material ids of the removed voxels; read-only.")
      .def("__repr__", [](const py::object& self) {
        const auto text = [&](const char* name) { return std::string(py::repr(self.attr(name))); };
        return "StepResult(force=" + text("force") + ", torque=" + text("torque") +
               ", removed_volume=" + text("removed_volume") +
               ", status=" + describe(self.cast<const R&>().result.status) + ")";
      });

  bind_described_result<ContactProbe>(m, "ContactProbe")
      .def_property_readonly(
          "stiffness", [](const ContactProbe& probe) { return probe.stiffness; },
          "[N/m], [N], [N m] (6, 6) about Ho, in W: translations, then rotations; positive semidefinite.");
}

}  // namespace

void bind_results(py::module_& m) {
  PYBIND11_NUMPY_DTYPE(RemovedInRun, step, index, material);
  bind_described<StepInput>(m, "StepInput");
  bind_result_of_step(m);
}

}  // namespace hapticut::python
