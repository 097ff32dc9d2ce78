// SPDX-License-Identifier: Apache-2.0
// The step, its results, snapshots and undo.
#include <cmath>
#include <string>
#include <string_view>

#include "c/simulation_object.hpp"
#include "c/structs.hpp"
#include "hapticut/core/build_info.hpp"
#include "hapticut/core/errors.hpp"

namespace hapticut {

constexpr auto fields_of(Of<hapticut_energy_ledger>) {
  using L = hapticut_energy_ledger;
  return std::tuple{HAPTICUT_C_FIELD(L, hand_work), HAPTICUT_C_FIELD(L, motor_work), HAPTICUT_C_FIELD(L, elastic),
                    HAPTICUT_C_FIELD(L, cutting),   HAPTICUT_C_FIELD(L, crushed),    HAPTICUT_C_FIELD(L, released),
                    HAPTICUT_C_FIELD(L, damping),   HAPTICUT_C_FIELD(L, rubbing),    HAPTICUT_C_FIELD(L, anchored),
                    HAPTICUT_C_FIELD(L, sliding),   HAPTICUT_C_FIELD(L, credited),   HAPTICUT_C_FIELD(L, entered),
                    HAPTICUT_C_FIELD(L, turnover)};
}

}  // namespace hapticut

namespace hapticut::c {
namespace {

static_assert(kHasEachField<EnergyLedger, hapticut_energy_ledger>, "C needs the new term, at the end of its ledger");

/// Whether a struct has fields of these names, and no others.
template <Described S, std::size_t kCount>
consteval bool has_only(const std::string_view (&names)[kCount]) {
  for (const std::string_view name : names)
    if (place_of<S>(name) == kFieldsOf<S>) return false;
  return kCount == kFieldsOf<S>;
}

// hapticut_step_result has other names than StepResult and its parts, so put_step names each field. C does not have
// StepResult::model and Contact::level_of_detail; hapticut_energy returns StepResult::energy.
static_assert(has_only<StepResult>({"force", "torque", "removed_voxels", "removed_volume", "contact", "model", "energy",
                                    "spindle", "sub_steps", "status"}),
              "put_step needs the new field, or the comment above its reason");
static_assert(has_only<Contact>({"voxels", "volume", "depth", "level_of_detail", "point_W", "normal_W", "area",
                                 "pressure", "load_to_cut"}),
              "put_step needs the new field, or the comment above its reason");
static_assert(has_only<SpindleState>({"speed", "torque"}), "put_step needs the new field");

constexpr std::size_t kBlocksAtOnce = 1024;  // blocks at once in an undo or redo between steps

class SnapshotObject final : public Object {
 public:
  static constexpr Kind kKind = Kind::snapshot;
  SnapshotObject(WorkpieceSnapshot a_state, const std::shared_ptr<SimulationObject>& a_simulation)
      : state(std::move(a_state)), simulation(a_simulation) {}
  const WorkpieceSnapshot state;
  const std::weak_ptr<SimulationObject> simulation;  // source of the snapshot
};

Twist twist_of(const hapticut_step_input& input) noexcept {
  return {vector_of(input.linear_velocity), vector_of(input.angular_velocity)};
}

}  // namespace

void put_step(const StepResult& stepped, hapticut_step_result& result) noexcept {
  result.status = std::uint32_t(stepped.status);
  result.removed_volume = stepped.removed_volume;
  result.removed_voxels = stepped.removed_voxels.size();
  result.spindle_speed = stepped.spindle.speed;
  result.spindle_torque = stepped.spindle.torque;
  result.contact_depth = stepped.contact.depth;
  result.contact_volume = stepped.contact.volume;
  result.contact_voxels = std::uint32_t(stepped.contact.voxels);
  result.sub_steps = std::uint32_t(stepped.sub_steps);
  put(stepped.contact.point_W, result.contact_point_W);
  put(stepped.contact.normal_W, result.contact_normal_W);
  result.contact_area = stepped.contact.area;
  result.contact_pressure = stepped.contact.pressure;
  result.load_to_cut = stepped.contact.load_to_cut;
}

}  // namespace hapticut::c

using namespace hapticut;
using namespace hapticut::c;

extern "C" {

uint32_t hapticut_abi_version(void) { return HAPTICUT_ABI_VERSION; }

const char* hapticut_version(void) {
  static const std::string* const text = [] {
    try {
      const BuildInfo info = build_info();
      return new std::string(info.version + (info.commit.empty() ? "" : " " + info.commit));
    } catch (...) {
      return static_cast<std::string*>(nullptr);
    }
  }();
  return text != nullptr ? text->c_str() : "";
}

const char* hapticut_last_error(void) { return last_failure(); }

int hapticut_release(hapticut_handle handle) { return release_object(handle); }

int hapticut_status_text(uint32_t status, char* text, size_t capacity) {
  return guarded([&] {
    require_argument(text, "text");
    if (capacity == 0) throw Refusal(HAPTICUT_ERROR_ARGUMENT, "capacity = 0; it must be at least 1.");
    copy_text(describe(StepStatus(status)), text, capacity);
  });
}

int hapticut_step(hapticut_simulation simulation, const hapticut_step_input* input, hapticut_step_result* result) {
  hapticut_step_input in;
  if (const int code = read_struct(input, "input", in); code != HAPTICUT_OK) return code;
  if (const int code = check_size(result, "result"); code != HAPTICUT_OK) return code;
  return within(IdleSimulation(simulation), [&](const auto& use) {
    const StepResult& stepped = use->simulation.step(pose_of(in.X_WH), twist_of(in), in.dt);
    hapticut_step_result own{};
    put_step(stepped, own);
    put(stepped.force, own.force);
    put(stepped.torque, own.torque);
    put(use->simulation.first_touched(), own.first_touched);
    own.X_WH = in.X_WH;
    write_struct(own, result);
    use->remove_loose_pieces();
  });
}

int hapticut_probe(hapticut_simulation simulation, const hapticut_step_input* input, hapticut_probe_result* result) {
  hapticut_step_input in;
  if (const int code = read_struct(input, "input", in); code != HAPTICUT_OK) return code;
  if (const int code = check_size(result, "result"); code != HAPTICUT_OK) return code;
  return within(IdleSimulation(simulation), [&](const auto& use) {
    const ContactProbe probe = use->simulation.probe(pose_of(in.X_WH), twist_of(in), in.dt);
    hapticut_probe_result own{};
    own.contact_voxels = std::uint32_t(probe.contact.voxels);
    put(probe.wrench.force, own.force);
    put(probe.wrench.torque, own.torque);
    for (int row = 0; row < 6; ++row)
      for (int column = 0; column < 6; ++column) own.stiffness[6 * row + column] = probe.stiffness(row, column);
    own.contact_depth = probe.contact.depth;
    write_struct(own, result);
  });
}

int hapticut_touches(hapticut_simulation simulation, const hapticut_pose* X_WH, int* touches) {
  if (X_WH == nullptr || touches == nullptr)
    return fail(HAPTICUT_ERROR_ARGUMENT, "X_WH or touches is a null pointer; both must not be null.");
  return within(IdleSimulation(simulation),
                [&](const auto& use) { *touches = use->simulation.touches(pose_of(*X_WH)) ? 1 : 0; });
}

int hapticut_energy(hapticut_simulation simulation, hapticut_energy_ledger* ledger) {
  if (const int code = check_size(ledger, "ledger"); code != HAPTICUT_OK) return code;
  return within(IdleSimulation(simulation), [&](const auto& use) {
    const EnergyLedger& energy = use->simulation.last_result().energy;
    hapticut_energy_ledger own{};
    put_fields(energy, own);
    own.imbalance = energy.imbalance();
    write_struct(own, ledger);
  });
}

int hapticut_set_spindle_speed(hapticut_simulation simulation, double rad_per_s) {
  return within(IdleSimulation(simulation),
                [&](const auto& use) { use->simulation.spindle().set_speed(rad_per_s * units::rad_per_s); });
}

int hapticut_snapshot_take(hapticut_simulation simulation, hapticut_snapshot* snapshot) {
  return within(IdleSimulation(simulation), [&](const auto& use) {
    require_argument(snapshot, "snapshot");
    *snapshot = add_object(Kind::snapshot,
                           std::make_shared<SnapshotObject>(use->simulation.workpiece().snapshot(), use.pointer()));
  });
}

int hapticut_snapshot_restore(hapticut_simulation simulation, hapticut_snapshot snapshot) {
  return within(IdleSimulation(simulation), [&](const auto& use) {
    return within(Use<SnapshotObject>(snapshot), [&](const auto& state) {
      if (state->simulation.lock() != use.pointer())
        throw Refusal(HAPTICUT_ERROR_REFUSED,
                      "The snapshot is of another simulation; use a snapshot of this simulation.");
      use->simulation.history().restore(state->state);
    });
  });
}

int hapticut_set_undo_mark(hapticut_simulation simulation) {
  return within(IdleSimulation(simulation), [&](const auto& use) -> int {
    if (use->simulation.history().mark()) return HAPTICUT_OK;
    return fail(HAPTICUT_ERROR_REFUSED,
                "There is no memory for undo; make the simulation with hapticut_simulation_options.undo_blocks.");
  });
}

int hapticut_undo(hapticut_simulation simulation) {
  return within(IdleSimulation(simulation), [&](const auto& use) -> int {
    if (use->simulation.workpiece().marks() == 0) return HAPTICUT_NOTHING;
    while (!use->simulation.history().undo(kBlocksAtOnce)) {
    }
    return HAPTICUT_OK;
  });
}

int hapticut_redo(hapticut_simulation simulation) {
  return within(IdleSimulation(simulation), [&](const auto& use) -> int {
    if (use->simulation.workpiece().redo_marks() == 0) return HAPTICUT_NOTHING;
    while (!use->simulation.history().redo(kBlocksAtOnce)) {
    }
    return HAPTICUT_OK;
  });
}

}  // extern "C"
