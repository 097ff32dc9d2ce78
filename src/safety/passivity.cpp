// SPDX-License-Identifier: Apache-2.0
#include "hapticut/safety/passivity.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "hapticut/core/errors.hpp"

namespace hapticut {

namespace {

constexpr double kSoftest = 100;  // [N/m] or [N·m/rad]; a softer spring stores more than is remembered

}  // namespace

PassivityController::PassivityController(const PassivityOptions& options, double greatest)
    : options_(options), greatest_(options.greatest > 0 ? options.greatest : greatest) {
  require_not_negative(options.credit, "PassivityOptions::credit [J]");
  require_not_negative(options.allowance, "PassivityOptions::allowance [J]");
  require_not_negative(options.greatest, "PassivityOptions::greatest [N]");
  require_positive(options.slowest, "PassivityOptions::slowest [m/s]");
  require_between(options.delay, 0, kLongestDelay, "PassivityOptions::delay [ticks]");
  require_between(options.free_ticks, 1, 100000, "PassivityOptions::free_ticks");
  require_not_negative(options.greatest_damping, "PassivityOptions::greatest_damping [N·s/m]");
  if (options_.credit == 0) options_.credit = greatest_ * greatest_ / (2 * kSoftest);
  if (options_.greatest_damping == 0) options_.greatest_damping = std::numeric_limits<double>::infinity();
  restart();
}

void PassivityController::restart() noexcept {
  stored_ = taken_ = 0;
  free_ = next_ = 0;
  under_way_.fill(Vec3::Zero());
}

Vec3 PassivityController::control(const Vec3& force, const Vec3& applied, const Vec3& motion, double dt) noexcept {
  taken_ = 0;
  if (!options_.enabled) return force;
  Vec3 acted = applied;
  if (options_.delay > 0) {
    std::swap(acted, under_way_[std::size_t(next_)]);
    next_ = (next_ + 1) % options_.delay;
  }
  stored_ = std::min(stored_ - acted.dot(motion), options_.credit);
  free_ = force.norm() < options_.free && applied.norm() < options_.free ? free_ + 1 : 0;
  if (free_ >= options_.free_ticks) stored_ = 0;

  const double owed = -stored_ - options_.allowance;
  const double speed = motion.norm() / dt;
  if (owed <= 0 || speed < options_.slowest) return force;
  taken_ = std::min({owed / (speed * dt), greatest_, options_.greatest_damping * speed});
  return force - taken_ / motion.norm() * motion;
}

}  // namespace hapticut
