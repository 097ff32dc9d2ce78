// SPDX-License-Identifier: Apache-2.0
#include "simulation/simulation_memory.hpp"

#include <cstring>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "hapticut/core/errors.hpp"
#include "simulation/simulation_state.hpp"
#include "workpiece/reserved_nodes.hpp"

namespace hapticut {
namespace {

template <class T>
concept Matrix = requires(T& matrix) {
  matrix.data();
  matrix.rows();
  T::RowsAtCompileTime;
};

/// Calls `archive(member)` for each member of a value. Single numbers are left to the archive.
template <class Archive, class T>
void visit_members(Archive& archive, T& value) {
  if constexpr (std::is_same_v<T, Pose>) {
    archive(value.rotation, value.translation);
  } else if constexpr (std::is_same_v<T, Twist>) {
    archive(value.linear, value.angular);
  } else if constexpr (std::is_same_v<T, Wrench>) {
    archive(value.force, value.torque);
  } else if constexpr (std::is_same_v<T, RemovedVoxel>) {
    archive(value.index, value.material);
  } else if constexpr (std::is_same_v<T, HandOutput>) {
    archive(value.X_WD, value.wrench, value.dt);
  } else if constexpr (std::is_same_v<T, BlockIds>) {
    archive(value.origin, value.ids);
  } else if constexpr (std::is_same_v<T, IndexBox>) {
    archive(value.min, value.max);
  } else if constexpr (std::is_same_v<T, MaterialSet>) {
    archive(value.words);
  } else if constexpr (Matrix<T>) {
    for (Eigen::Index n = 0; n < value.size(); ++n) archive(value.data()[n]);
  } else if constexpr (Described<T>) {
    for_each_field<T>([&](const auto& field) {
      if constexpr (!std::is_same_v<typename std::remove_cvref_t<decltype(field)>::Type, std::span<const RemovedVoxel>>)
        archive(value.*field.member);
    });
  } else {
    for (auto& member : value) archive(member);  // an array
  }
}

class Writer {
 public:
  template <class... T>
  void operator()(T&... values) {
    (write(values), ...);
  }
  std::string bytes;

 private:
  template <class T>
  void write(T& value) {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>)
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    else
      visit_members(*this, value);
  }
  template <class T>
  void write(std::optional<T>& value) {
    bool known = value.has_value();
    (*this)(known);
    if (known) (*this)(*value);
  }
  template <class T>
  void write(std::vector<T>& values) {
    std::size_t count = values.size();
    (*this)(count);
    for (T& value : values) (*this)(value);
  }
};

class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(bytes) {}
  template <class... T>
  void operator()(T&... values) {
    (read(values), ...);
  }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }

 private:
  template <class T>
  void read(T& value) {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
      require(sizeof value);
      std::memcpy(&value, bytes_.data() + at_, sizeof value);
      at_ += sizeof value;
    } else {
      visit_members(*this, value);
    }
  }
  template <class T>
  void read(std::optional<T>& value) {
    bool known = false;
    (*this)(known);
    value.reset();
    if (known) (*this)(value.emplace());
  }
  template <class T>
  void read(std::vector<T>& values) {
    std::size_t count = 0;
    (*this)(count);
    require(count);  // at least a byte each
    values.resize(count);
    for (T& value : values) (*this)(value);
  }
  void require(std::size_t count) const {
    if (count > left()) throw Error("it ends too early.");
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
};

}  // namespace

/// Every member of Simulation::State that a step may change, except the workpiece. Members that follow from workpiece,
/// tool and configuration are made by the constructor.
template <class Archive>
void SimulationMemory::visit(Archive& archive, Simulation::State& s) {
  ToolMotion& tool = s.motion;
  archive(s.chooses_stiffness, tool.placed_, tool.separated_, tool.X_WH_, tool.mean_velocity_, tool.after_rejection_,
          tool.jumped_to_);
  LoadedSpindle& spindle = s.spindle;
  SpindleMotor& motor = spindle.motor_;
  archive(motor.setting_, motor.start_, motor.ramped_, motor.speed_, motor.loaded_, motor.stalled_);
  LoadedSpindle::Load& load = spindle.load_;
  archive(load.torque, load.hand_speed, load.first_torque, load.first_speed, load.settled);
  archive(spindle.held_, spindle.held_setting_, spindle.halted_, spindle.was_halted_, spindle.set_, spindle.was_set_);
  DeepContact& deep = s.springs.deep;
  archive(deep.touched_, deep.tethered_, deep.normal_, deep.place_, deep.full_stiffness_, deep.stiffness_,
          deep.stored_);
  archive(s.crushing_depth);
  LimitSurface& anchor = s.springs.anchor;
  archive(anchor.position_, anchor.rotation_, anchor.stored_, anchor.stiffness_, anchor.anchored_, anchor.sliding_);
  Output& output = s.hand.output;
  archive(output.vibration_.phase_, output.cutter_.angle_, output.unlimited_force_, output.full_, output.given_,
          output.running_);
  archive(s.hand.released, s.hand.was_released, s.hand.path, s.hand.coupled);
  RunningTotals& totals = s.totals;
  archive(s.input, s.free_blocks, totals.steps, totals.exchanges, totals.replacements, totals.altered);
  archive(totals.touched, totals.first_touched, totals.first_touch_step);
  RemovalRecord& removal = s.removal;
  archive(removal.voxels_, removal.volume_, removal.overflowed_, removal.total_by_material_, totals.detached_volume);
  bool lists_removed = !s.result.removed_voxels.empty();
  archive(s.result, lists_removed, s.times);
  s.result.removed_voxels = lists_removed ? removal.voxels() : std::span<const RemovedVoxel>();
  ContactStages& stages = s.contact_stages;
  archive(stages.subset_, stages.pressed_, stages.bounds_, stages.changed_, stages.changed_blocks_.complete);
  stages.changed_blocks_.origins = stages.changed_;
}

std::string SimulationMemory::bytes_of(const Simulation& simulation) {
  const Workpiece& workpiece = simulation.workpiece();
  if (const std::size_t marks = workpiece.marks() + workpiece.redo_marks(); marks > 0)
    throw Error("the simulation has " + std::to_string(marks) + (marks == 1 ? " mark" : " marks") +
                " for undo and redo, which a copy cannot have; delete all with reserve_undo before you copy.");
  Writer writer;
  ReservedNodes nodes = reserved_nodes(workpiece);
  std::size_t undo_blocks = workpiece.undo_blocks();
  std::vector<BlockIds> cut = ids_of_cut_blocks(workpiece);
  writer(cut, undo_blocks, nodes.material_leaves, nodes.fill_leaves, nodes.fill_branches, nodes.target);
  visit(writer, *simulation.state_);  // a writer changes nothing
  return std::move(writer.bytes);
}

Simulation SimulationMemory::restored(Workpiece workpiece, Tool tool, SimulationConfig config,
                                      const std::string& bytes) {
  // Not by the public constructor, which refuses a workpiece of which nothing is left.
  Simulation simulation(std::make_unique<Simulation::State>(std::move(workpiece), std::move(tool), std::move(config)));
  Simulation::State& s = *simulation.state_;
  Reader reader(bytes);
  std::size_t undo_blocks = 0;
  ReservedNodes nodes;
  std::vector<BlockIds> cut;
  reader(cut, undo_blocks, nodes.material_leaves, nodes.fill_leaves, nodes.fill_branches, nodes.target);
  set_ids_of_cut_blocks(s.workpiece, cut);
  if (undo_blocks > 0) s.workpiece.reserve_undo(undo_blocks);
  set_reserved_nodes(s.workpiece, nodes);
  visit(reader, s);
  if (reader.left() > 0) throw Error("it is longer than expected.");
  return simulation;
}

Simulation copy_of(const Simulation& simulation) {
  return SimulationMemory::restored(simulation.workpiece().clone(), simulation.tool(), simulation.config(),
                                    SimulationMemory::bytes_of(simulation));
}

}  // namespace hapticut
