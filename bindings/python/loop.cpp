// SPDX-License-Identifier: Apache-2.0
// include/hapticut/device: a simulation driven by a device in a thread of its own
#include <memory>
#include <optional>
#include <utility>

#include "bindings.hpp"
#include "hapticut/loop/realtime_loop.hpp"
#include "hapticut/loop/simulation_model.hpp"
#include "simulation.hpp"
#include "structs.hpp"

namespace hapticut::python {

namespace {

/// A model, and what it works on.
struct PythonModel {
  std::shared_ptr<PythonSimulation> simulation;
  py::object device;
  std::unique_ptr<SimulationModel> model;
};

PythonModel model_of(const std::shared_ptr<PythonSimulation>& simulation, const py::object& device,
                     const SimulationModelOptions& options) {
  simulation->occupancy.require_writable("The simulation");
  auto model = std::make_unique<SimulationModel>(simulation->simulation, device.cast<Device&>(), options);
  return {simulation, device, std::move(model)};
}

}  // namespace

/// A loop; while it runs, nobody else can touch its simulation.
class PythonLoop {
 public:
  PythonLoop(py::object model, const RealtimeLoopOptions& options)
      : model_(std::move(model)),
        simulation_(model_.cast<const PythonModel&>().simulation),
        loop_(std::make_unique<RealtimeLoop>(model_.cast<const PythonModel&>().device.cast<Device&>(),
                                             *model_.cast<const PythonModel&>().model, options)) {}
  PythonLoop(PythonLoop&&) = default;
  PythonLoop& operator=(PythonLoop&&) = delete;
  PythonLoop(const PythonLoop&) = delete;
  PythonLoop& operator=(const PythonLoop&) = delete;
  ~PythonLoop() {
    if (loop_ == nullptr) return;
    {
      const py::gil_scoped_release released;  // the device may wait for the interpreter
      loop_.reset();
    }
    let_go();
  }

  void start() {
    if (!holds_) simulation_->occupancy.require_writable("The simulation");
    loop_->start();
    recorder_ = simulation_->recorder.lock();
    holds_ = simulation_->occupancy.writing_ = true;
  }

  RunReport end(RunReport (RealtimeLoop::*how)()) {
    struct LetGo {
      PythonLoop& loop;
      ~LetGo() { loop.let_go(); }
    };
    const LetGo afterwards{*this};
    const py::gil_scoped_release released;
    return ((*loop_).*how)();
  }

  [[nodiscard]] RealtimeLoop& loop() const { return *loop_; }

 private:
  void let_go() {
    if (std::exchange(holds_, false)) simulation_->occupancy.writing_ = false;
    recorder_.reset();
  }

  py::object model_;
  std::shared_ptr<PythonSimulation> simulation_;
  std::unique_ptr<RealtimeLoop> loop_;
  std::shared_ptr<void> recorder_;  // that observes the simulation must live as long as the loop runs
  bool holds_ = false;
};

namespace {

void bind_messages(py::module_& m) {
  using C = LoopCommand;
  py::class_<C> command(m, "LoopCommand", doc("LoopCommand"));
  bind_enum<C::Kind>(command, "Kind",
                     {{"stop", C::Kind::stop},
                      {"emergency_stop", C::Kind::emergency_stop},
                      {"reset_fault", C::Kind::reset_fault},
                      {"model", C::Kind::model}},
                     "LoopCommand::Kind");
  command
      .def(py::init([](C::Kind kind, std::int32_t code, const std::array<double, 8>& values) {
             return C{kind, code, values};
           }),
           py::arg_v("kind", C::Kind::model, "LoopCommand.Kind.model"), py::arg("code") = 0,
           py::arg("values") = std::array<double, 8>{})
      .def_readwrite("kind", &C::kind, "Who is meant.")
      .def_readwrite("code", &C::code, doc("LoopCommand::code"))
      .def_readwrite("values", &C::values, doc("LoopCommand::values"));

  struct ModelCommands {};
  py::class_<ModelCommands>(m, "model_commands", doc("model_commands"))
      .def_static("set_spindle_speed", &model_commands::set_spindle_speed, py::arg("speed"),
                  doc("model_commands::set_spindle_speed"))
      .def_static("open_clutch", &model_commands::open_clutch, doc("model_commands::open_clutch"))
      .def_static("close_clutch", &model_commands::close_clutch, doc("model_commands::close_clutch"))
      .def_static("set_scale", &model_commands::set_scale, py::arg("scale"), doc("model_commands::set_scale"))
      .def_static("set_undo_mark", &model_commands::set_undo_mark, doc("model_commands::set_undo_mark"))
      .def_static("undo", &model_commands::undo, doc("model_commands::undo"));

  using S = LoopSnapshot;
  bind_result<S>(m, "LoopSnapshot", member("tick", &S::tick), member("device", &S::device),
                 member("output", &S::output), member("arming", &S::arming),
                 member("commands_dropped", &S::commands_dropped), member("blocks_waiting", &S::blocks_waiting),
                 member("X_WT", &S::X_WT), member("values", &S::values));
  using T = ToolSnapshot;
  const auto bits = [](StepStatus T::*status) {
    return [status](const T& snapshot) { return std::uint32_t(snapshot.*status); };
  };
  bind_result<T>(m, "ToolSnapshot", member("force", &T::force), member("torque", &T::torque),
                 member("removed_volume", &T::removed_volume), member("contact_depth", &T::contact_depth),
                 member("contact_voxels", &T::contact_voxels), member("spindle_speed", &T::spindle_speed),
                 member("steps", &T::steps), member("undo_marks", &T::undo_marks), member("undoing", &T::undoing))
      .def_property_readonly("status", bits(&T::status), doc("ToolSnapshot::status"))
      .def_property_readonly("seen", bits(&T::seen), doc("ToolSnapshot::seen"));
  m.def("tool_of", &tool_of, py::arg("snapshot"), "What a SimulationModel has put into a snapshot.");

  using B = ChangedBlock;
  py::class_<B>(m, "ChangedBlock", doc("ChangedBlock"))
      .def_readonly("origin", &B::origin, doc("ChangedBlock::origin"))
      .def_readonly("version", &B::version, doc("ChangedBlock::version"))
      .def_property_readonly(
          "material",
          [](const py::object& self) {
            return view(py::dtype::of<std::uint8_t>(), {kBlockEdge, kBlockEdge, kBlockEdge},
                        {kBlockEdge * kBlockEdge, kBlockEdge, 1}, self.cast<const B&>().material.data(), self);
          },
          "(8, 8, 8) uint8 material ids; read-only.")
      .def_property_readonly(
          "fill",
          [](const py::object& self) {
            return view(py::dtype::of<float>(), {kBlockEdge, kBlockEdge, kBlockEdge},
                        {4 * kBlockEdge * kBlockEdge, 4 * kBlockEdge, 4}, self.cast<const B&>().fill.data(), self);
          },
          "[1] (8, 8, 8) float32 filled shares; read-only.");
}

void bind_model(py::module_& m) {
  using O = SimulationModelOptions;
  bind_struct<O>(m, "SimulationModelOptions", field("map", &O::map), field("coupling", &O::coupling),
                 field("spindle_needs_force", &O::spindle_needs_force), field("undo_blocks", &O::undo_blocks),
                 field("undo_blocks_per_tick", &O::undo_blocks_per_tick));
  using M = PythonModel;
  py::class_<M>(m, "SimulationModel", doc("SimulationModel"))
      .def(py::init([](const std::shared_ptr<PythonSimulation>& simulation, Device& device, const O& options) {
             return model_of(simulation, py::cast(&device), options);
           }),
           py::arg("simulation"), py::arg("device"), py::arg("options") = O{}, doc("SimulationModel::SimulationModel"))
      .def_property_readonly(
          "region", [](const M& self) { return self.model->region(); }, doc("SimulationModel::region"));
}

}  // namespace

void bind_loop(py::module_& m) {
  bind_messages(m);
  bind_model(m);
  using O = RealtimeLoopOptions;
  bind_struct<O>(m, "RealtimeLoopOptions", field("run", &O::run), field("region", &O::region),
                 field("block_capacity", &O::block_capacity), field("blocks_per_tick", &O::blocks_per_tick));
  using L = PythonLoop;
  py::class_<L>(
      m, "RealtimeLoop",
      (std::string(doc("RealtimeLoop")) +
       "\n\nIts thread runs without the interpreter. While it runs, calls that touch the simulation raise Error.")
          .c_str())
      .def(py::init([](const py::object& model, const O& options) { return L(model, options); }), py::arg("model"),
           py::arg("options") = O{}, "Of a SimulationModel and its device.")
      .def("start", &L::start, doc("RealtimeLoop::start"))
      .def(
          "wait", [](L& self) { return self.end(&RealtimeLoop::wait); }, doc("RealtimeLoop::wait"))
      .def(
          "stop", [](L& self) { return self.end(&RealtimeLoop::stop); }, doc("RealtimeLoop::stop"))
      .def_property_readonly(
          "is_running", [](const L& self) { return self.loop().is_running(); }, "Whether a run is under way.")
      .def(
          "emergency_stop", [](const L& self) { self.loop().emergency_stop(); }, doc("RealtimeLoop::emergency_stop"))
      .def(
          "send", [](const L& self, const LoopCommand& command) { return self.loop().send(command); },
          py::arg("command"), doc("RealtimeLoop::send"))
      .def(
          "latest", [](const L& self) { return LoopSnapshot(self.loop().latest()); }, "The latest snapshot.")
      .def(
          "receive",
          [](const L& self) {
            std::optional<ChangedBlock> block(std::in_place);
            if (!self.loop().receive(*block)) block.reset();
            return block;
          },
          "Takes one changed block; None when there is none.")
      .def_property_readonly_static(
          "kCommands", [](const py::object&) { return RealtimeLoop::kCommands; }, doc("RealtimeLoop::kCommands"));
}

}  // namespace hapticut::python
