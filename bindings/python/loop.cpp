// SPDX-License-Identifier: Apache-2.0
// include/hapticut/loop: a device drives a simulation in a separate thread
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "bindings.hpp"
#include "hapticut/islands/island_watch.hpp"
#include "hapticut/loop/realtime_loop.hpp"
#include "hapticut/loop/simulation_model.hpp"
#include "interruption.hpp"
#include "material_set.hpp"
#include "simulation.hpp"
#include "structs.hpp"

namespace hapticut::python {

namespace {

/// A model and the objects that it uses.
struct PythonModel {
  std::shared_ptr<PythonSimulation> simulation;
  py::object device;
  std::unique_ptr<SimulationModel> model;
  std::unique_ptr<IslandModel> islands;  // wraps the model if loose pieces are removed

  [[nodiscard]] LoopModel& of_loop() const {
    if (islands) return *islands;
    return *model;
  }
};

PythonModel model_of(const std::shared_ptr<PythonSimulation>& simulation, const py::object& device,
                     const SimulationModelOptions& options, const std::optional<IslandWatchOptions>& islands) {
  simulation->occupancy.require_writable("The simulation");
  auto model = std::make_unique<SimulationModel>(simulation->simulation, device.cast<Device&>(), options);
  auto around = islands ? std::make_unique<IslandModel>(*model, *islands) : nullptr;
  return {simulation, device, std::move(model), std::move(around)};
}

}  // namespace

/// A loop; while it runs, no other code can use its simulation.
class PythonLoop {
 public:
  PythonLoop(py::object model, const RealtimeLoopOptions& options)
      : model_(std::move(model)),
        simulation_(model_.cast<const PythonModel&>().simulation),
        loop_(std::make_unique<RealtimeLoop>(model_.cast<const PythonModel&>().device.cast<Device&>(),
                                             model_.cast<const PythonModel&>().of_loop(), options)) {}
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
    release_simulation();
  }

  void start() {
    if (!holds_) simulation_->occupancy.require_writable("The simulation");
    loop_->start();
    recorder_ = simulation_->recorder.lock();
    holds_ = simulation_->occupancy.writing_ = true;
  }

  /// When a signal handler raises, the loop goes on.
  RunReport wait() {
    {
      const ReleasedLock released;
      for (; loop_->is_running(); std::this_thread::sleep_for(std::chrono::milliseconds(1))) look_for_interruption();
    }
    return end(&RealtimeLoop::wait);
  }

  RunReport end(RunReport (RealtimeLoop::*how)()) {
    struct ReleaseSimulation {
      PythonLoop& loop;
      ~ReleaseSimulation() { loop.release_simulation(); }
    };
    const ReleaseSimulation afterwards{*this};
    const py::gil_scoped_release released;
    return ((*loop_).*how)();
  }

  [[nodiscard]] RealtimeLoop& loop() const { return *loop_; }

 private:
  void release_simulation() {
    if (std::exchange(holds_, false)) simulation_->occupancy.writing_ = false;
    recorder_.reset();
  }

  py::object model_;
  std::shared_ptr<PythonSimulation> simulation_;
  std::unique_ptr<RealtimeLoop> loop_;
  std::shared_ptr<void> recorder_;  // observes the simulation and must live as long as the loop runs
  bool holds_ = false;
};

namespace {

/// A Python command, converted for the loop. A command that owns data is moved, so it can be sent only once. Other
/// commands are copied.
struct GivenCommand {
  py::object object;
  LoopCommand command;

  /// Restores a command that was not sent.
  void give_back() {
    std::visit(
        [&](auto& what) {
          using Command = std::decay_t<decltype(what)>;
          if constexpr (!std::is_copy_constructible_v<Command>) object.cast<Command&>() = std::move(what);
        },
        command);
  }

  static GivenCommand of(const py::object& object) {
    std::optional<LoopCommand> command;
    find_alternative<LoopCommand>([&]<class Command>(std::size_t, Of<Command>) {
      if (!py::isinstance<Command>(object)) return false;
      if constexpr (std::is_copy_constructible_v<Command>)
        command.emplace(Command(object.cast<Command&>()));
      else
        command.emplace(std::move(object.cast<Command&>()));
      return true;
    });
    if (command) return {object, std::move(*command)};
    throw py::type_error(
        "send() takes a command: one of hapticut.loop.commands, or the result of SimulationModel.prepare_tool, "
        "prepare_materials or prepare_workpiece");
  }
};

bool send(const PythonLoop& loop, const py::object& object) {
  GivenCommand given = GivenCommand::of(object);
  try {
    if (loop.loop().send(std::move(given.command))) return true;
  } catch (...) {
    given.give_back();
    throw;
  }
  given.give_back();
  return false;
}

void bind_commands(py::module_& m) {
  struct Commands {};
  const py::class_<Commands> scope(m, "commands", doc("commands"));
  find_alternative<LoopCommand>([&]<class Command>(std::size_t, Of<Command>) {
    if constexpr (Described<Command>) {
      const std::string full = py::type_id<Command>(), in_cpp = full.substr(full.find("commands::"));
      bind_described<Command>(scope, in_cpp.substr(in_cpp.rfind(':') + 1).c_str(), in_cpp.c_str());
    }
    return false;
  });
  namespace c = commands;
  py::class_<c::SetTool>(scope, "SetTool", doc("commands::SetTool"))
      .def(py::init<const Tool&, double, const SimulationConfig&>(), py::arg("tool"), py::arg("voxel_size"),
           py::arg("config"), doc("commands::SetTool::SetTool"));
  py::class_<c::SetMaterials>(scope, "SetMaterials", doc("commands::SetMaterials"))
      .def(py::init<const MaterialTable&, const SimulationConfig&>(), py::arg("materials"), py::arg("config"),
           doc("commands::SetMaterials::SetMaterials"));
  py::class_<c::ExchangeWorkpiece>(scope, "ExchangeWorkpiece", doc("commands::ExchangeWorkpiece"))
      .def(py::init([](const PythonWorkpiece& workpiece, const Tool& tool, const SimulationConfig& config) {
             return c::ExchangeWorkpiece(Simulation(workpiece.read().clone(), tool, config));
           }),
           py::arg("workpiece"), py::arg("tool"), py::arg("config"),
           "Prepares the exchange from a copy of a workpiece, its tool and the configuration of both.")
      .def_property_readonly(
          "bounds",
          [](const c::ExchangeWorkpiece& self) {
            return self.simulation != nullptr ? self.simulation->workpiece().bounds() : IndexBox{};
          },
          "Frame of the new workpiece; empty after the command was sent.");
}

void bind_messages(py::module_& m) {
  bind_described_result<TickEffort>(m, "TickEffort");
  bind_described_result<ToolSnapshot>(m, "ToolSnapshot");
  bind_described_result<LoopSnapshot>(m, "LoopSnapshot");
}

void bind_interlock(py::module_& m) {
  using I = SpindleInterlock;
  py::class_<I>(m, "SpindleInterlock", doc("SpindleInterlock"))
      .def(py::init<>())
      .def("admits", &I::admits, py::arg("arming"), py::arg("touches"), doc("SpindleInterlock::admits"))
      .def("interrupt", &I::interrupt, doc("SpindleInterlock::interrupt"))
      .def(
          "update",
          [](I& self, PythonSimulation& simulation, ArmingState arming) {
            simulation.occupancy.require_writable("The simulation");
            self.update(simulation.simulation, arming);
          },
          py::arg("simulation"), py::arg("arming"), doc("SpindleInterlock::update"));
}

void bind_model(py::module_& m) {
  using O = SimulationModelOptions;
  bind_described<O>(m, "SimulationModelOptions");
  using M = PythonModel;
  py::class_<M>(m, "SimulationModel", doc("SimulationModel"))
      .def(py::init([](const std::shared_ptr<PythonSimulation>& simulation, Device& device, const O& options,
                       const std::optional<IslandWatchOptions>& islands) {
             return model_of(simulation, py::cast(&device), options, islands);
           }),
           py::arg("simulation"), py::arg("device"), py::arg("options") = O{}, py::arg("islands") = py::none(),
           (std::string(doc("SimulationModel::SimulationModel")) +
            "\n\nWith `islands`, loose pieces are removed between the ticks.")
               .c_str())
      .def_property_readonly(
          "region", [](const M& self) { return self.model->region(); }, doc("SimulationModel::region"))
      .def_property_readonly(
          "island_count", [](const M& self) { return self.islands ? self.islands->watch().count() : 0; },
          doc("IslandWatch::count"))
      .def_property_readonly(
          "island_fault",
          [](const M& self) { return self.islands ? self.islands->watch().fault() : std::optional<std::string>(); },
          doc("IslandWatch::fault"))
      .def(
          "removed_islands",
          [](const M& self) { return self.islands ? self.islands->watch().removed() : std::vector<Island>(); },
          doc("IslandWatch::removed"))
      .def(
          "prepare_tool", [](const M& self, const Tool& tool) { return self.model->prepare_tool(tool); },
          py::arg("tool"), doc("SimulationModel::prepare_tool"))
      .def(
          "prepare_materials",
          [](const M& self, const MaterialTable& materials) { return self.model->prepare_materials(materials); },
          py::arg("materials"), doc("SimulationModel::prepare_materials"))
      .def(
          "prepare_workpiece",
          [](const M& self, const PythonWorkpiece& workpiece, const Tool& tool) {
            return self.model->prepare_workpiece(workpiece.read().clone(), tool);
          },
          py::arg("workpiece"), py::arg("tool"), doc("SimulationModel::prepare_workpiece"));
}

}  // namespace

void bind_loop(py::module_& m) {
  bind_commands(m);
  bind_messages(m);
  bind_interlock(m);
  bind_model(m);
  using O = RealtimeLoopOptions;
  bind_described<O>(m, "RealtimeLoopOptions");
  using L = PythonLoop;
  py::class_<L>(
      m, "RealtimeLoop",
      (std::string(doc("RealtimeLoop")) +
       "\n\nIts thread runs without the interpreter lock. While it runs, calls that use the simulation raise Error.")
          .c_str())
      .def(py::init([](const py::object& model, const O& options) { return L(model, options); }), py::arg("model"),
           py::arg("options") = O{}, "Makes a loop of a SimulationModel and its device.")
      .def("start", &L::start, doc("RealtimeLoop::start"))
      .def("wait", &L::wait, doc("RealtimeLoop::wait"))
      .def(
          "stop", [](L& self) { return self.end(&RealtimeLoop::stop); }, doc("RealtimeLoop::stop"))
      .def_property_readonly(
          "is_running", [](const L& self) { return self.loop().is_running(); }, "Whether a run is in progress.")
      .def_property_readonly(
          "requests", [](const L& self) -> Requests& { return self.loop().requests(); },
          py::return_value_policy::reference_internal, doc("RealtimeLoop::requests"))
      .def("send", &send, py::arg("command"), doc("RealtimeLoop::send"))
      .def(
          "latest", [](const L& self) { return LoopSnapshot(self.loop().latest()); }, "The latest snapshot.")
      .def(
          "receive",
          [](const L& self) {
            std::optional<ChangedBlock> block(std::in_place);
            if (!self.loop().receive(*block)) block.reset();
            return block;
          },
          "Removes and returns one changed block; None when there is none.");
}

void bind_changed_block(py::module_& m) {
  using B = ChangedBlock;
  py::class_<B> block_class(m, "ChangedBlock", doc("ChangedBlock"));
  pickled_by_bytes(block_class);
  block_class.def_readonly("origin", &B::origin, doc("ChangedBlock::origin"))
      .def_readonly("version", &B::version, doc("ChangedBlock::version"))
      .def_readonly("workpiece", &B::workpiece, doc("ChangedBlock::workpiece"))
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
          "[1] (8, 8, 8) float32 filled fractions; read-only.");
}

}  // namespace hapticut::python
