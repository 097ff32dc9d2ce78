// SPDX-License-Identifier: Apache-2.0
// Whatever a hand does one thing after another: what holds of the whole chain always, and how often the invariants that
// do not hold yet are broken.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <sstream>

#include "gestures/rigs.hpp"
#include "hapticut/safety/guard.hpp"
#include "support/generators.hpp"

namespace hapticut::random_gestures_test {

using gestures::Chain;
using gestures::ChainOptions;
using gestures::Hand;
using gestures::Report;
using gestures::Span;
using gestures::Tick;
using test::number_between;
using units::mm;

enum class Doing { press, lift, drag, tilt, twist, stall, stop, reverse, clutch, change_tool, undo, count };

/// One thing that a hand does, in a tenth of a second.
struct Part {
  Doing doing;
  double amount, direction;  // [1] 0 ... 1, [rad]
};

std::ostream& operator<<(std::ostream& out, const Part& part) {
  constexpr const char* kNames[] = {"press", "lift",    "drag",   "tilt",        "twist", "stall",
                                    "stop",  "reverse", "clutch", "change tool", "undo"};
  return out << kNames[int(part.doing)] << " " << part.amount << " towards " << part.direction;
}

namespace {

constexpr double kVoxel = 2e-4, kPart = 0.1, kSpin = 40000 * units::rpm;  // [m], [s], [rad/s]
constexpr int kParts = 10;                                                // 10^3 ticks
constexpr double kRadius = 1 * mm;                                        // [m] of the ball
constexpr double kClosure = 1e-2, kGrazing = 1e-5;  // [1], [J] a bur that only grazes is off by more than elsewhere

rc::Gen<Part> arbitrary_part() {
  return rc::gen::apply(
      [](int doing, double amount, double direction) {
        return Part{Doing(doing), amount, direction};
      },
      rc::gen::inRange(0, int(Doing::count)), number_between(0.1, 1), number_between(0, 2 * units::kPi));
}

Tool ball(double radius) {
  Spindle spindle{kSpin * units::rad_per_s};
  spindle.power_limit = 3;
  return gestures::tool_of(SphereHead{radius}, spindle);
}

/// The chain that has done all of it.
struct Done {
  Done(const std::vector<Part>& parts, bool probing) : report("random", kVoxel) {
    report.probing = probing;
    ChainOptions options;
    options.guard.arming.ramp = options.guard.arming.short_ramp = 0.02;
    options.arming = 0.1;
    options.undo_blocks = 3000;
    chain.emplace(report, gestures::slab(4 * mm, 4 * mm, kVoxel, presets::cortical_bone()), ball(kRadius), options);
    chain->tell(commands::SetUndoMark{});
    Hand hand(ball(kRadius), Vec3(0, 0, 0.3 * mm));
    for (const Part& part : parts) go(hand, part);
    chain->before = [&, next = std::size_t(0), closes = false](double time) mutable {
      if (closes && time >= kPart * (double(next) - 0.5)) {
        chain->tell(commands::CloseClutch{});
        closes = false;
      }
      if (next >= parts.size() || time < kPart * double(next)) return;
      closes = parts[next].doing == Doing::clutch;
      tell(parts[next++]);
    };
    chain->play(hand);
    chain->judge();
  }

  static void go(Hand& hand, const Part& part) {
    const Vec3 aside(std::cos(part.direction), std::sin(part.direction), 0);
    switch (part.doing) {
      case Doing::press:
      case Doing::stall:
        hand.move(Vec3(0, 0, -4 * mm * part.amount), 0.6 * kPart).hold(0.4 * kPart);
        break;
      case Doing::lift:
        hand.move(Vec3(0, 0, 5 * mm * part.amount), 0.6 * kPart).hold(0.4 * kPart);
        break;
      case Doing::drag:
        hand.move(2 * mm * part.amount * aside, kPart);
        break;
      case Doing::tilt:
        hand.turn(0.35 * part.amount * aside, hand.end().translation, kPart);
        break;
      case Doing::twist:
        hand.turn(Vec3(0, 0, 0.7 * part.amount), hand.end().translation, kPart);
        break;
      default:
        hand.move(0.5 * mm * part.amount * aside, kPart);
    }
  }

  void tell(const Part& part) {
    switch (part.doing) {
      case Doing::stop:
        chain->tell(commands::SetSpindleSpeed{0});
        break;
      case Doing::stall:
        chain->tell(commands::SetSpindleSpeed{kSpin * part.amount * units::rad_per_s});
        break;
      case Doing::reverse:
        chain->tell(commands::SetSpindleSpeed{-kSpin * units::rad_per_s});
        break;
      case Doing::clutch:
        chain->tell(commands::OpenClutch{});
        break;
      case Doing::change_tool: {
        LoopCommand other = chain->model().prepare_tool(ball(kRadius * (0.6 + 0.6 * part.amount)));
        (void)chain->model().obey(other);
        break;
      }
      case Doing::undo:
        chain->tell(commands::Undo{});
        chain->tell(commands::SetUndoMark{});
        break;
      default:
        break;
    }
  }

  Report report;
  std::optional<Chain> chain;
};

const DeviceModel& device() { return device_model("touch"); }

RC_GTEST_PROP(RandomGestures, KeepToTheDeviceAndCloseTheLedgerAndGiveTheSameBitsAgain, ()) {
  const auto parts = *rc::gen::container<std::vector<Part>>(kParts, arbitrary_part());
  Done done(parts, false);
  const auto& ticks = done.chain->story.ticks;
  RC_ASSERT(ticks.size() >= std::size_t(1000));
  const double slew = SafetyGuard(capabilities(device()), {}).slew();
  double turnover = 0;
  for (std::size_t n = 1; n < ticks.size(); ++n) {
    const Tick &last = ticks[n - 1], &tick = ticks[n];
    RC_ASSERT(tick.felt.force.allFinite() && tick.X_WH.translation.allFinite());
    RC_ASSERT(tick.applied.force.norm() <= 1.001 * device().peak_force);
    const Vec3 grown = tick.applied.force - growth_limited(last.applied.force, tick.applied.force, 0);
    RC_ASSERT(grown.norm() <= 1.001 * slew * 1e-3);
    if (tick.arming == ArmingState::wait_free || tick.arming == ArmingState::fault)
      RC_ASSERT(tick.applied.force.isZero(0));
    turnover += std::abs(tick.energy.hand_work - last.energy.hand_work) +
                std::abs(tick.energy.motor_work - last.energy.motor_work);
  }
  const EnergyLedger& energy = ticks.back().energy;
  RC_ASSERT(std::abs(energy.imbalance()) <= kClosure * turnover + kGrazing);
  RC_ASSERT(energy.cutting >= 0 && energy.damping >= 0 && energy.rubbing >= 0 && energy.sliding >= 0);
  RC_ASSERT(Done(parts, true).report.bits() == done.report.bits());
  RC_CLASSIFY(std::abs(energy.imbalance()) > 1e-3 * turnover, "ledger off by more than 1e-3");
  for (const gestures::Row& row : done.report.rows()) RC_CLASSIFY(!row.is_met, row.demand + " broken");
}

}  // namespace
}  // namespace hapticut::random_gestures_test
