// SPDX-License-Identifier: Apache-2.0
#include "hapticut/safety/passivity.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

constexpr double kFaster = 1.25;  // [1] times as fast as now the hand may go on

}  // namespace

PassivityController::PassivityController(const PassivityOptions& options, double greatest)
    : options_(options), greatest_(options.greatest > 0 ? options.greatest : greatest) {
  require_fields_within(options, "PassivityOptions::");
  if (options_.credit == 0) options_.credit = std::numeric_limits<double>::infinity();
  if (options_.greatest_damping == 0) options_.greatest_damping = std::numeric_limits<double>::infinity();
  restart();
}

void PassivityController::restart() noexcept {
  stored_ = taken_ = asked_ = 0;
  effects_.setZero();
  next_ = 0;
  under_way_.fill(Vec3::Zero());
}

Vec3 PassivityController::control(const Tick& tick) noexcept {
  taken_ = 0;
  if (!options_.enabled) return tick.force;
  const double applied = tick.applied.norm();
  Vec3 acted = tick.applied - (applied < asked_ ? applied / asked_ : 1.0) * effects_;
  asked_ = tick.force.norm();
  effects_ = tick.effects;
  if (options_.delay > 0) {
    std::swap(acted, under_way_[std::size_t(next_)]);
    next_ = (next_ + 1) % options_.delay;
  }
  if ((tick.force - tick.effects).norm() < options_.free) {
    stored_ = 0;
    return tick.force;
  }
  const double moved = tick.motion.norm(), speed = moved / tick.dt;
  const double held = (0.5 + options_.delay) * options_.stiffness * moved * moved;
  const double most = std::min(options_.credit, tick.stored.value_or(options_.credit));
  stored_ = std::min(stored_ - acted.dot(tick.motion) + held + tick.motor.value_or(0), most);

  if (speed < options_.slowest) return tick.force;
  const double left = stored_ + options_.allowance;
  if (left < 0) taken_ = std::min({-left / moved, greatest_, options_.greatest_damping * speed});
  if (tick.motor) {
    const double pushes = kFaster * (tick.force - tick.effects).dot(tick.motion);  // [J] in the next tick
    taken_ += std::max(0.0, (pushes - std::max(0.0, left) - held) / (kFaster * moved));
  }
  return tick.force - taken_ / moved * tick.motion;
}

}  // namespace hapticut
