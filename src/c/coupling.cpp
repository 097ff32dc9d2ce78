// SPDX-License-Identifier: Apache-2.0
// A virtual coupling in a custom loop.
#include "hapticut/simulation/coupling.hpp"
#include "c/simulation_object.hpp"
#include "c/structs.hpp"
#include "hapticut/core/errors.hpp"

namespace hapticut::c {
namespace {

class CouplingObject final : public Object {
 public:
  static constexpr Kind kKind = Kind::coupling;
  CouplingObject(std::shared_ptr<SimulationObject> a_simulation, const CouplingGains& gains)
      : simulation(std::move(a_simulation)),
        tool_exchanges(simulation->tool_exchanges),
        coupling(simulation->simulation, gains) {}

  const std::shared_ptr<SimulationObject> simulation;
  const std::uint32_t tool_exchanges;  // exchanges of the simulation when the coupling was made
  VirtualCoupling coupling;
};

CouplingGains gains_of(const hapticut_coupling_gains& given) noexcept {
  CouplingGains gains;
  set_if_given(given.stiffness, gains.stiffness);
  set_if_given(given.damping, gains.damping);
  set_if_given(given.mass, gains.mass);
  set_if_given(given.max_force, gains.max_force);
  set_if_given(given.angular_stiffness, gains.angular_stiffness);
  set_if_given(given.angular_damping, gains.angular_damping);
  set_if_given(given.inertia, gains.inertia);
  set_if_given(given.max_torque, gains.max_torque);
  return gains;
}

}  // namespace
}  // namespace hapticut::c

using namespace hapticut;
using namespace hapticut::c;

extern "C" {

int hapticut_coupling_open(hapticut_simulation simulation, const hapticut_coupling_gains* gains,
                           hapticut_coupling* coupling) {
  return guarded([&]() -> int {
    require_argument(coupling, "coupling");
    hapticut_coupling_gains own;
    if (const int code = read_struct_if_given(gains, "gains", own); code != HAPTICUT_OK) return code;
    const IdleSimulation use(simulation);
    if (!use) return use.code();
    *coupling = add_object(Kind::coupling, std::make_shared<CouplingObject>(use.pointer(), gains_of(own)));
    return HAPTICUT_OK;
  });
}

int hapticut_coupling_step(hapticut_coupling coupling, const hapticut_step_input* input, hapticut_step_result* result) {
  hapticut_step_input in;
  if (const int code = read_struct(input, "input", in); code != HAPTICUT_OK) return code;
  if (const int code = check_size(result, "result"); code != HAPTICUT_OK) return code;
  return within(Use<CouplingObject>(coupling), [&](const auto& use) -> int {
    SimulationObject& object = *use->simulation;
    const IdleStay stay(object);
    if (!stay) return stay.code();
    if (object.tool_exchanges.load() != use->tool_exchanges)
      return fail(HAPTICUT_ERROR_REFUSED,
                  "The tool of the simulation was exchanged after this coupling was made; open another coupling.");
    const Twist velocity{vector_of(in.linear_velocity), vector_of(in.angular_velocity)};
    const CoupledResult& tick = use->coupling.step(pose_of(in.X_WH), velocity, in.dt);
    hapticut_step_result own{};
    put_step(object.simulation.last_result(), own);
    own.status = std::uint32_t(tick.status);
    put(tick.hand.force, own.force);
    put(tick.hand.torque, own.torque);
    own.removed_volume = tick.removed_volume;
    own.removed_voxels = tick.removed_voxels.size();
    own.sub_steps = std::uint32_t(tick.sub_ticks);
    put(tick.X_WH, own.X_WH);
    put(tick.first_touched, own.first_touched);
    write_struct(own, result);
    object.remove_loose_pieces();
    return HAPTICUT_OK;
  });
}

int hapticut_coupling_reset(hapticut_coupling coupling) {
  return within(Use<CouplingObject>(coupling), [](const auto& use) {
    return within(IdleStay(*use->simulation), [&](const auto&) { use->coupling.reset(); });
  });
}

}  // extern "C"
