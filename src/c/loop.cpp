// SPDX-License-Identifier: Apache-2.0
// Calls of other threads to a running loop.
#include <cmath>
#include <string>
#include <utility>

#include "c/loop_object.hpp"
#include "c/structs.hpp"
#include "hapticut/core/description.hpp"
#include "hapticut/core/errors.hpp"

namespace hapticut {

/// The fields that C has from LoopSnapshot, ToolSnapshot and DeviceState.
constexpr auto fields_of(Of<hapticut_loop_state>) {
  using L = hapticut_loop_state;
  return std::tuple{HAPTICUT_C_FIELD(L, status),
                    HAPTICUT_C_FIELD(L, tick),
                    HAPTICUT_C_FIELD(L, arming),
                    HAPTICUT_C_FIELD(L, fault),
                    HAPTICUT_C_FIELD(L, buttons),
                    HAPTICUT_C_FIELD(L, status_seen),
                    HAPTICUT_C_FIELD(L, time),
                    HAPTICUT_C_FIELD(L, X_BS),
                    HAPTICUT_C_FIELD(L, X_WT),
                    HAPTICUT_C_FIELD(L, force),
                    HAPTICUT_C_FIELD(L, torque),
                    HAPTICUT_C_FIELD(L, spindle_speed),
                    HAPTICUT_C_FIELD(L, removed_volume),
                    HAPTICUT_C_FIELD(L, dissipated),
                    HAPTICUT_C_FIELD(L, contact_depth),
                    HAPTICUT_C_FIELD(L, contact_voxels),
                    HAPTICUT_C_FIELD(L, undo_marks),
                    HAPTICUT_C_FIELD(L, redo_marks),
                    HAPTICUT_C_FIELD(L, commands_dropped),
                    HAPTICUT_C_FIELD(L, commands_refused),
                    HAPTICUT_C_FIELD(L, contact_point_W),
                    HAPTICUT_C_FIELD(L, touched)};
}

}  // namespace hapticut

namespace hapticut::c {
namespace {

/// Puts the number of a command into its field. `put` returns false if the field cannot be set by a number.
struct Number {
  double value;
  RemovalLaw of_scene;

  bool put(auto& /*field*/) const { return false; }
  bool put(double& field) const { return field = value, true; }
  bool put(AngularSpeed& field) const { return field = value * units::rad_per_s, true; }
  bool put(bool& field) const {
    require(value == 0 || value == 1, "0 or 1");
    return field = value == 1, true;
  }
  bool put(RemovalLaw& field) const {
    bool cuts = false;
    put(cuts);
    return field = cuts ? of_scene : RemovalLaw::none, true;
  }
  bool put(AxisMask& field) const {
    require(value >= 0 && value <= 63 && value == std::floor(value), "a whole number from 0 to 63");
    const auto bits = unsigned(value);
    for (unsigned axis = 0; axis < 3; ++axis) {
      field.force[axis] = (bits >> axis & 1U) != 0;
      field.torque[axis] = (bits >> (axis + 3) & 1U) != 0;
    }
    return true;
  }
  void require(bool good, const std::string& allowed) const {
    if (!good)
      throw Refusal(HAPTICUT_ERROR_ARGUMENT, "value = " + format_number(value) + "; it must be " + allowed + ".");
  }
};

/// Whether a number may be enough for a command: it has at most one field.
template <class Command>
constexpr bool is_of_a_number() {
  if constexpr (Described<Command>) return kFieldsOf<Command> < 2;
  return false;
}

LoopCommand command_of(const hapticut_command& given, RemovalLaw removal) {
  LoopCommand command;
  const Number number{given.value, removal};
  bool known = false;
  find_alternative<LoopCommand>([&]<class Command>(std::size_t n, Of<Command>) {
    if constexpr (is_of_a_number<Command>())
      if (known = n == given.kind; known) {
        Command& own = command.emplace<Command>();
        for_each_field<Command>([&](const auto& field) { known = number.put(own.*field.member); });
      }
    return known;
  });
  if (known) return command;
  throw Refusal(HAPTICUT_ERROR_ARGUMENT,
                "kind = " + std::to_string(given.kind) + "; it must be one of hapticut_command_kind.");
}

int send(LoopObject& object, LoopCommand&& command) {
  if (!object.running.load())
    return fail(HAPTICUT_ERROR_REFUSED, "The loop was stopped; change the simulation directly.");
  if (object.loop.send(std::move(command))) return HAPTICUT_OK;
  return fail(HAPTICUT_ERROR_FULL, "256 commands are in the queue; send the command again after some ticks.");
}

/// Makes a request. It uses no lane, because it must succeed independent of other calls.
template <class Ask>
int request(hapticut_loop loop, Ask&& ask) noexcept {
  int code = HAPTICUT_OK;
  const std::shared_ptr<Object>* pinned = pin_slot(loop, Kind::loop, code);
  if (pinned == nullptr) return code;
  ask(static_cast<LoopObject*>(pinned->get())->loop.requests());
  unpin_slot(loop);
  return HAPTICUT_OK;
}

std::uint32_t flag(bool on, hapticut_loop_flag bit) noexcept { return on ? std::uint32_t(bit) : 0; }

void put_snapshot(const LoopSnapshot& seen, hapticut_loop_state& own) noexcept {
  const ToolSnapshot& tool = seen.tool;
  put_fields(seen, own);
  put_fields(seen.device, own);
  put_fields(tool, own);
  own.flags = flag(seen.device.valid, HAPTICUT_LOOP_READING_VALID) |
              flag(tool.contact_voxels > 0, HAPTICUT_LOOP_TOUCHING) | flag(tool.undoing, HAPTICUT_LOOP_UNDOING) |
              flag(tool.redoing, HAPTICUT_LOOP_REDOING) | flag(tool.force_held, HAPTICUT_LOOP_FORCE_HELD);
  own.output_changes = std::uint32_t(seen.output.changes);
  put(seen.output.applied.force, own.applied_force);
  put(seen.output.applied.torque, own.applied_torque);
}

}  // namespace
}  // namespace hapticut::c

using namespace hapticut;
using namespace hapticut::c;

extern "C" {

int hapticut_loop_latest(hapticut_loop loop, hapticut_loop_state* state) {
  if (const int code = check_size(state, "state"); code != HAPTICUT_OK) return code;
  const Use<LoopObject> use(loop, Lane::reading);
  if (!use) return use.code();
  const LoopSnapshot& seen = use->loop.latest();
  const SoundInput& heard = use->listener.listen(seen);
  hapticut_loop_state own{};
  put_snapshot(seen, own);
  own.power = heard.power;
  own.removal_rate = heard.removal_rate;
  write_struct(own, state);
  return HAPTICUT_OK;
}

int hapticut_loop_send(hapticut_loop loop, const hapticut_command* command) {
  hapticut_command own;
  if (const int code = read_struct(command, "command", own); code != HAPTICUT_OK) return code;
  const Use<LoopObject> use(loop, Lane::sending);
  if (!use) return use.code();
  return guarded([&] { return send(*use.operator->(), command_of(own, use->simulation->removal)); });
}

int hapticut_loop_set_tool(hapticut_loop loop, const char* text) {
  return guarded([&]() -> int {
    require_argument(text, "text");
    const Use<LoopObject> use(loop, Lane::sending);
    if (!use) return use.code();
    const int code =
        send(*use.operator->(), use->model.prepare_tool(tool_from_toml(text, use->simulation->first_tool)));
    if (code == HAPTICUT_OK) use->simulation->tool_exchanges.fetch_add(1);
    return code;
  });
}

int hapticut_loop_emergency_stop(hapticut_loop loop) {
  return request(loop, [](Requests& requests) { requests.emergency_stop(); });
}

int hapticut_loop_reset_fault(hapticut_loop loop) {
  return request(loop, [](Requests& requests) { requests.reset_fault(); });
}

}  // extern "C"
