// SPDX-License-Identifier: Apache-2.0
// What a simulation can be told while its loop runs: each command by itself, then all of them at random.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <thread>
#include <utility>
#include <variant>

#include "hapticut/core/errors.hpp"
#include "hapticut/device/simulated/device_models.hpp"
#include "hapticut/device/simulated/mock.hpp"
#include "hapticut/loop/simulation_model.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "support/cutting.hpp"

namespace hapticut::live_commands_test {
namespace {

constexpr double kRadius = 1.5e-3;  // [m] of the ball

Workpiece block(double voxel = 2e-4, double depth = 8e-3) {
  return build_block({Vec3(-8e-3, -8e-3, -depth), Vec3(8e-3, 8e-3, 0)}, voxel, test::plain_material());
}
Tool ball(double radius = kRadius, double speed = 3000) {
  return Tool(SphereHead{radius}, RayHandle{}, Spindle{speed});
}
double radius_of(const Tool& tool) { return std::get<SphereHead>(tool.head().shape()).radius; }

SimulationConfig config(bool coupled = false) {
  SimulationConfig config;
  config.reference_stiffness = 1e13;
  config.reserved_blocks = 4096;
  config.contact_time = coupled ? ContactTime::end : ContactTime::middle;
  return config;
}

/// Ticks of a hand that a test moves along z, and tells the model between them.
class Rig {
 public:
  explicit Rig(double speed = 3000, bool coupled = false)
      : simulation(block(), ball(kRadius, speed), config(coupled)), model(simulation, *device, options(coupled)) {}

  /// @param height  [m] of the ball's lowest point over the face, tick by tick
  /// @param at      what happens before which tick, and what is to be seen after it
  void run(int ticks, const std::function<double(int)>& height, const std::function<void(int)>& before,
           const std::function<void(int)>& after) {
    RunOptions run;
    run.simulated_time = true;
    run.stop_on_signals = false;
    run.guard.arming.ramp = run.guard.arming.short_ramp = 0.02;
    report = device->run(
        [&](const DeviceState& reading) {
          DeviceState state = reading;
          state.X_BS.translation.z() = height(n);
          before(n);
          DeviceCommand command{model.step(state, 1e-3, snapshot), false};
          commanded = command.wrench.force;
          after(n);
          command.stop = ++n >= ticks;
          return command;
        },
        run);
  }
  bool tell(LoopCommand command) {
    model.check(command);
    return model.obey(command);
  }
  [[nodiscard]] std::uint64_t events(SafetyEvent event) const { return report.events[std::size_t(event)]; }

  std::unique_ptr<Device> device = open_device("mock:rest");
  Simulation simulation;
  SimulationModel model;
  LoopSnapshot snapshot;
  RunReport report;
  Vec3 commanded = Vec3::Zero();
  int n = 0;

 private:
  SimulationModelOptions options(bool coupled) const {
    SimulationModelOptions options;
    options.map.X_WB = Pose::from_translation(Vec3(0, 0, kRadius));
    options.undo_blocks = 2000;
    if (coupled) options.coupling = coupling_gains(device->capabilities());
    return options;
  }
};

/// In the air, down to a depth from tick 300 on in 0.1 s, where it stays; up again from tick `up` on.
std::function<double(int)> press(double depth, int up = 1 << 30) {
  return [=](int n) {
    if (n >= up) return 3e-3;
    return 1e-3 - (1e-3 + depth) * std::clamp(n - 300, 0, 100) / 100;
  };
}

void nothing(int /*tick*/) {}

TEST(LiveCommands, SetToolSwapsTheToolAndGivesNoForceUntilItIsFree) {
  for (const bool coupled : {false, true}) {
    Rig rig(3000, coupled);
    // The hand rests 1 mm over the face; a ball of 4 mm whose centre is there is 1.5 mm deep.
    rig.run(
        1500, [](int n) { return n < 1000 ? 1e-3 : 8e-3; },
        [&](int n) {
          if (n == 500) {
            EXPECT_EQ(rig.device->last_arming(), ArmingState::on);
            EXPECT_TRUE(rig.tell(rig.model.prepare_tool(ball(4e-3, 2000))));
          }
        },
        [&](int n) {
          if (n < 500) return;
          EXPECT_EQ(radius_of(rig.simulation.tool()), 4e-3);
          if (n == 500) {
            EXPECT_TRUE(rig.commanded.isZero(0)) << "the guard has not heard of it yet";
          }
          if (n > 500 && n < 1000) {
            EXPECT_EQ(rig.device->last_arming(), ArmingState::wait_free) << n;
            EXPECT_TRUE(rig.device->last_output().applied.force.isZero(0)) << n;
            EXPECT_EQ(rig.snapshot.tool.spindle_speed, 0) << n;
          }
        });
    EXPECT_EQ(rig.events(SafetyEvent::model_swapped), 1U);
    EXPECT_EQ(rig.report.guard, ArmingState::on) << "it was free";
    EXPECT_EQ(rig.snapshot.tool.spindle_speed, 2000) << "of the new tool";
    EXPECT_EQ(rig.snapshot.tool.removed_volume, 0);
    EXPECT_EQ(rig.report.fault, DeviceFault::none);
  }
}

TEST(LiveCommands, ALargerToolCutsAsIfItHadBeenThereFromTheBeginning) {
  for (const bool coupled : {false, true}) {
    Rig with(3000, coupled);
    with.run(900, press(0.5e-3), nothing, nothing);
    Rig changed(3000, coupled);
    EXPECT_TRUE(changed.tell(changed.model.prepare_tool(ball(0.5e-3))));
    changed.run(
        900, press(0.5e-3),
        [&](int n) {
          if (n == 50) {
            EXPECT_TRUE(changed.tell(changed.model.prepare_tool(ball())));
          }
        },
        nothing);
    EXPECT_EQ(changed.simulation.workpiece().hash(), with.simulation.workpiece().hash());
    EXPECT_EQ(changed.snapshot.tool.removed_volume, with.snapshot.tool.removed_volume);
    EXPECT_GT(with.snapshot.tool.removed_volume, 0);
    EXPECT_FALSE(has(changed.snapshot.tool.seen, StepStatus::removed_list_full));
  }
}

TEST(LiveCommands, SetToolStandsStillUntilItMayCutWhateverItsRamp) {
  Spindle slow{3000};
  slow.acceleration_limit = 3000;  // a second to stand
  Rig rig;
  rig.run(
      900, press(0.2e-3),
      [&](int n) {
        if (n == 500) {
          EXPECT_GT(rig.snapshot.tool.removed_volume, 0);
          EXPECT_TRUE(rig.tell(rig.model.prepare_tool(Tool(SphereHead{3e-3}, RayHandle{}, slow))));
        }
      },
      [&, at = 0.0](int n) mutable {
        if (n == 499) at = rig.snapshot.tool.removed_volume;
        if (n > 500) {
          EXPECT_EQ(rig.snapshot.tool.removed_volume, at);
        }
      });
}

TEST(LiveCommands, SetMaterialsChangesWhatIsFeltAfterTheToolWasFree) {
  Rig rig(0);
  Material soft = test::plain_material();
  soft.relative_stiffness = 0.25;
  double hard_force = 0;
  const std::uint64_t whole = rig.simulation.workpiece().hash();
  rig.run(
      1600, [](int n) { return press(1e-3, n > 800 ? 0 : 700)(n > 800 ? n - 600 : n); },
      [&](int n) {
        if (n == 600) {
          hard_force = rig.snapshot.tool.force.z();
          EXPECT_TRUE(rig.tell(rig.model.prepare_materials(MaterialTable({soft}))));
        }
        if (n == 650) {
          EXPECT_EQ(rig.device->last_arming(), ArmingState::wait_free) << "it is still in the material";
        }
      },
      nothing);
  EXPECT_EQ(rig.events(SafetyEvent::model_swapped), 1U);
  EXPECT_EQ(rig.report.guard, ArmingState::on);
  EXPECT_EQ(rig.simulation.workpiece().materials()[1].relative_stiffness, 0.25);
  EXPECT_EQ(rig.simulation.workpiece().hash(), whole);
  EXPECT_GT(hard_force, 0);
}

TEST(LiveCommands, SetFrictionSetEffectsAndSetForceMaskActFromTheNextTickOn) {
  Rig rig(0);
  double free_weight = 0;
  Effects heavy;
  heavy.gravity = Gravity{0.1, Vec3::Zero()};
  rig.run(
      1200, press(1e-3),
      [&](int n) {
        if (n == 200) {
          EXPECT_TRUE(rig.tell(commands::SetEffects{heavy}));
        }
        if (n == 250) {
          free_weight = rig.snapshot.tool.force.z();
          EXPECT_TRUE(rig.tell(commands::SetEffects{}));
        }
        if (n == 600) {
          EXPECT_GT(rig.snapshot.tool.force.z(), 0.5);
          EXPECT_TRUE(rig.tell(commands::SetForceMask{{{true, true, false}, {true, true, true}}}));
        }
        if (n == 700) {
          EXPECT_TRUE(rig.tell(commands::SetForceMask{}));
        }
        if (n == 800) {
          EXPECT_TRUE(rig.tell(commands::SetFriction{DryFriction{0.7, 0.6, 500}}));
        }
      },
      [&](int n) {
        if (n >= 600 && n < 700) {
          EXPECT_EQ(rig.snapshot.tool.force.z(), 0) << n;
        }
        if (n >= 700) {
          EXPECT_GT(rig.snapshot.tool.force.z(), 0.5) << n;
        }
      });
  EXPECT_NEAR(free_weight, -0.980665, 1e-9);
  EXPECT_EQ(rig.simulation.config().friction->static_friction, 0.7);
  EXPECT_EQ(rig.events(SafetyEvent::model_swapped), 0U);
}

TEST(LiveCommands, SetRemovalSwitchesTheCuttingOffAndOn) {
  Rig rig;
  double at_off = 0, at_on = 0;
  rig.run(
      900, [](int n) { return 1e-3 - 5e-6 * std::max(0, n - 300); },
      [&](int n) {
        if (n == 600) {
          at_off = rig.snapshot.tool.removed_volume;
          EXPECT_TRUE(rig.tell(commands::SetRemoval{RemovalLaw::none}));
        }
        if (n == 700) {
          at_on = rig.snapshot.tool.removed_volume;
          EXPECT_TRUE(rig.tell(commands::SetRemoval{RemovalLaw::constant_energy}));
        }
      },
      nothing);
  EXPECT_GT(at_off, 0);
  EXPECT_EQ(at_on, at_off);
  EXPECT_GT(rig.snapshot.tool.removed_volume, at_on);
}

TEST(LiveCommands, HoldForceKeepsTheForceWhereverTheHandGoesAndCutsNothing) {
  for (const bool coupled : {false, true}) {
    Rig rig(3000, coupled);
    Vec3 held;
    double removed = 0;
    rig.run(
        1600,
        [](int n) {  // pressed, farther in while it is held, out at last
          return n < 700 ? press(0.3e-3)(n) : n < 1200 ? -0.3e-3 - 5e-6 * (n - 700) : 3e-3;
        },
        [&](int n) {
          if (n == 700) {
            held = rig.snapshot.tool.force;
            removed = rig.snapshot.tool.removed_volume;
            EXPECT_TRUE(rig.tell(commands::HoldForce{}));
          }
          if (n == 1000) {
            EXPECT_TRUE(rig.tell(commands::HoldForce{false}));
          }
        },
        [&](int n) {
          EXPECT_EQ(rig.snapshot.tool.force_held, n >= 700 && n < 1000);
          if (n >= 700 && n < 1000) {
            EXPECT_EQ(rig.commanded, held) << n;
            EXPECT_EQ(rig.snapshot.tool.force, held) << n;
            EXPECT_EQ(rig.snapshot.tool.spindle_speed, 0) << n;
          }
          if (n == 1000) {
            EXPECT_TRUE(rig.commanded.isZero(0));
          }
          if (n > 1000 && n < 1200) {
            EXPECT_EQ(rig.device->last_arming(), ArmingState::wait_free) << "it is deeper than it was";
          }
        });
    EXPECT_GT(held.norm(), 0.01);
    EXPECT_EQ(rig.snapshot.tool.removed_volume, removed);
    EXPECT_EQ(rig.report.guard, ArmingState::on);
    EXPECT_EQ(rig.events(SafetyEvent::reclutched), 1U);
  }
}

TEST(LiveCommands, ExchangeWorkpieceBringsAnotherOneWithItsTool) {
  for (const bool coupled : {false, true}) {
    Rig rig(3000, coupled);
    std::uint64_t cut = 0;
    LoopCommand exchange = rig.model.prepare_workpiece(block(3e-4, 4e-3), ball(2e-3, 1000));
    rig.run(
        1800, [](int n) { return press(0.4e-3, n > 900 ? 0 : 800)(n > 900 ? n - 700 : n); },
        [&](int n) {
          if (n == 700) {
            cut = rig.simulation.workpiece().hash();
            EXPECT_GT(rig.snapshot.tool.removed_volume, 0);
            EXPECT_TRUE(rig.model.obey(exchange));
          }
        },
        [&](int n) {
          EXPECT_EQ(rig.snapshot.tool.workpiece, n >= 700 ? 1U : 0U);
          if (n == 700) {
            EXPECT_TRUE(rig.commanded.isZero(0));
          }
        });
    EXPECT_EQ(rig.simulation.workpiece().voxel_size(), 3e-4);
    EXPECT_EQ(rig.simulation.workpiece().undo_blocks(), 2000U);
    EXPECT_EQ(radius_of(rig.simulation.tool()), 2e-3);
    EXPECT_EQ(rig.events(SafetyEvent::model_swapped), 1U);
    EXPECT_EQ(rig.report.guard, ArmingState::on);
    EXPECT_EQ(std::get<commands::ExchangeWorkpiece>(exchange).simulation->workpiece().hash(), cut)
        << "the old one came back";
    ChangedBlock changed;
    changed.origin = {0, 0, -8};
    rig.model.copy(changed);
    EXPECT_EQ(changed.workpiece, 1U);
  }
}

TEST(LiveCommands, RedoGoesForthToWhatWasUndoneUnlessSomethingElseWasCut) {
  Rig rig;
  std::uint64_t cut = 0;
  const std::uint64_t whole = rig.simulation.workpiece().hash();
  const auto down = [](int n) { return press(0.3e-3, n % 1200 > 900 ? 0 : 800)(n % 1200); };
  rig.run(
      2400, down,
      [&](int n) {
        if (n == 100) {
          EXPECT_FALSE(rig.tell(commands::Undo{})) << "there is no mark";
          EXPECT_FALSE(rig.tell(commands::Redo{}));
          EXPECT_TRUE(rig.tell(commands::SetUndoMark{}));
        }
        if (n == 850) {
          cut = rig.simulation.workpiece().hash();
          EXPECT_TRUE(rig.tell(commands::Undo{}));
          EXPECT_FALSE(rig.tell(commands::Redo{})) << "one way after the other";
          EXPECT_FALSE(rig.tell(commands::SetUndoMark{}));
        }
        if (n == 950) {
          EXPECT_EQ(rig.simulation.workpiece().hash(), whole);
          EXPECT_EQ(rig.snapshot.tool.redo_marks, 1U);
          EXPECT_TRUE(rig.tell(commands::Redo{}));
        }
        if (n == 1050) {
          EXPECT_EQ(rig.simulation.workpiece().hash(), cut);
          EXPECT_EQ(rig.snapshot.tool.undo_marks, 1U);
          EXPECT_EQ(rig.snapshot.tool.redo_marks, 0U);
          EXPECT_TRUE(rig.tell(commands::Undo{}));
        }
        if (n == 2100) {  // it has cut again
          EXPECT_NE(rig.simulation.workpiece().hash(), whole);
          EXPECT_FALSE(rig.tell(commands::Redo{}));
        }
      },
      [&](int n) {
        if (rig.snapshot.tool.redoing || rig.snapshot.tool.undoing) {
          EXPECT_TRUE(rig.commanded.isZero(0)) << n;
        }
      });
  EXPECT_GT(rig.events(SafetyEvent::model_swapped), 2U);
}

TEST(LiveCommands, RefuseInTheSendersThreadWhatIsOutOfRange) {
  Rig rig(3000, true);
  const auto refused = [&](LoopCommand command) { EXPECT_THROW(rig.model.check(command), Error); };
  refused(commands::SetSpindleSpeed{2 * kFastestSpindle});
  refused(commands::SetScale{0});
  refused(commands::SetFriction{DryFriction{0.1, 0.2, 1000}});
  Effects effects;
  effects.vibration = Vibration{};
  effects.vibration->frequency = 1e6;
  refused(commands::SetEffects{effects});
  refused(commands::ExchangeWorkpiece(Simulation(block(), ball(), config(false))));
  LoopCommand tool = rig.model.prepare_tool(ball());
  const LoopCommand taken = std::move(tool);
  refused(std::move(tool));  // NOLINT(bugprone-use-after-move): that is what is refused
  EXPECT_NO_THROW(rig.model.check(taken));
  EXPECT_THROW((void)rig.model.prepare_tool(ball(1e-5)), Error);
  EXPECT_THROW((void)rig.model.prepare_workpiece(block(4e-3), ball()), Error);
}

TEST(LiveCommands, RefuseInTheLoopWhatDoesNotSuitWhatIsInPlace) {
  Rig rig;
  EXPECT_FALSE(rig.tell(commands::SetTool(ball(), 1e-4, config())));
  Material other = test::plain_material();
  other.name = "other";
  EXPECT_FALSE(rig.tell(rig.model.prepare_materials(MaterialTable({test::plain_material(), other}))));
  EXPECT_EQ(radius_of(rig.simulation.tool()), kRadius);
  EXPECT_EQ(rig.simulation.workpiece_exchanges(), 0U);
  rig.run(
      300, [](int) { return 1e-3; }, nothing, nothing);
  EXPECT_EQ(rig.events(SafetyEvent::model_swapped), 0U) << "nothing was swapped";
}

// --- at random ------------------------------------------------------------------------------------------------------

/// Counts what a SimulationModel obeys and refuses.
class CountingModel final : public LoopModel {
 public:
  explicit CountingModel(SimulationModel& model) : model_(&model) {}
  Wrench step(const DeviceState& state, double dt, LoopSnapshot& snapshot) noexcept override {
    return model_->step(state, dt, snapshot);
  }
  void check(const LoopCommand& command) const override { model_->check(command); }
  bool obey(LoopCommand& command) noexcept override {
    const std::size_t kind = command.index();
    const bool obeyed = model_->obey(command);
    ++(obeyed ? obeyed_ : refused_)[kind];
    ++all_;
    return obeyed;
  }
  void mark_changes(BlockOutbox& outbox) noexcept override { model_->mark_changes(outbox); }
  void copy(ChangedBlock& block) noexcept override { model_->copy(block); }

  SimulationModel* model_;
  std::array<int, std::variant_size_v<LoopCommand>> obeyed_{}, refused_{};
  std::atomic<int> all_{0};
};

/// In and out of the material, on and on, at 30 mm/s and less.
Pose wandering(double t) {
  return Pose::from_translation({4e-3 * std::sin(5 * t), 4e-3 * std::cos(4 * t), 2e-3 * std::sin(3 * t)});
}

/// A hundred thousand commands of all kinds to a loop that cuts, some of which do not suit; the loop never waits, and
/// what comes out in the end is a workpiece of which every block that was sent is what is there.
void tell_a_hundred_thousand(bool simulated_time, bool coupled, unsigned seed) {
  constexpr int kCommands = 100000;
  MockOptions hand;
  hand.path = wandering;
  hand.device = device_model("touch");
  MockDevice a_device(hand);
  Device* const device = &a_device;
  const SimulationConfig with = config(coupled);
  const auto coarse = [](double depth) { return block(5e-4, depth); };
  Simulation simulation(coarse(5e-3), ball(), with);
  SimulationModelOptions options;
  options.map.X_WB = Pose::from_translation(Vec3(0, 0, kRadius));
  options.undo_blocks = 300;  // less than is cut: marks are forgotten on the way
  options.undo_blocks_per_tick = 4;
  if (coupled) options.coupling = coupling_gains(device->capabilities());
  SimulationModel model(simulation, *device, options);
  CountingModel counting(model);
  RealtimeLoopOptions loop_options;
  loop_options.run.simulated_time = simulated_time;
  loop_options.run.stop_on_signals = false;
  loop_options.run.realtime.priority = 0;
  loop_options.run.realtime.lock_memory = false;
  loop_options.run.guard.arming.ramp = loop_options.run.guard.arming.short_ramp = 0.02;
  loop_options.region = {{-40, -40, -40}, {40, 40, 40}};  // around all that will come
  loop_options.block_capacity = 64;
  RealtimeLoop loop(*device, counting, loop_options);

  std::mt19937 random(seed);
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto some_tool = [&] {
    const Spindle spindle{number(0, 5000)};
    const double radius = number(0.6e-3, 2.5e-3);
    return random() % 2 == 0 ? Tool(SphereHead{radius}, RayHandle{number(0, 1e-3)}, spindle)
                             : Tool(round_head(2 * radius), RayHandle{}, spindle);
  };
  const auto next = [&]() -> LoopCommand {
    const auto dice = random() % 1000;
    if (dice < 1) return model.prepare_workpiece(coarse(number(2e-3, 8e-3)), some_tool());
    if (dice < 2) return commands::SetTool(some_tool(), 1e-4, with);  // for other voxels
    if (dice < 10) return model.prepare_tool(some_tool());
    if (dice < 30) {
      Material material = test::plain_material();
      material.relative_stiffness = number(0.5, 2);
      material.specific_cutting_energy = number(1e8, 1e9);
      return model.prepare_materials(MaterialTable({material}));
    }
    switch (dice % 12) {
      case 0:
        return commands::SetSpindleSpeed{number(-5000, 5000)};
      case 1:
        return commands::OpenClutch{};
      case 2:
      case 3:
        return commands::CloseClutch{};
      case 4:
        return commands::SetScale{number(0.5, 1.5)};
      case 5:
        return commands::SetUndoMark{};
      case 6:
        return dice % 10 == 0 ? LoopCommand(commands::Undo{}) : commands::SetFriction{};
      case 7:
        return dice % 10 < 2 ? LoopCommand(commands::Redo{}) : commands::SetFriction{DryFriction{0.4, 0.3, 1000}};
      case 8:
        return commands::SetEffects{};
      case 9:
        return commands::SetForceMask{{{random() % 8 != 0, true, random() % 8 != 0}, {true, true, true}}};
      case 10:
        return commands::SetRemoval{random() % 4 == 0 ? RemovalLaw::none : RemovalLaw::constant_energy};
      default:
        return commands::HoldForce{random() % 4 == 0};
    }
  };

  std::map<VoxelIndex, ChangedBlock> picture;
  ChangedBlock changed;
  std::uint32_t workpiece = 0;
  const auto look = [&] {
    const LoopSnapshot& seen = loop.latest();
    EXPECT_LE(seen.output.applied.force.norm(), device->capabilities().peak_force * (1 + 1e-9));
    EXPECT_FALSE(has(seen.tool.seen, StepStatus::force_not_finite | StepStatus::pose_rejected));
    while (loop.receive(changed)) {
      if (changed.workpiece != workpiece) picture.clear();
      workpiece = changed.workpiece;
      picture[changed.origin] = changed;
    }
    return seen;
  };
  loop.start();
  std::uint64_t dropped = 0;
  for (int sent = 0; sent < kCommands;) {
    // As many as come to mind, and then a tick or more.
    for (auto burst = random() % 250; burst > 0 && sent < kCommands; --burst) {
      LoopCommand command = next();
      while (!loop.send(std::move(command))) {
        ++dropped;
        std::this_thread::yield();
      }
      ++sent;
    }
    const std::uint64_t tick = look().tick;
    while (loop.latest().tick == tick) std::this_thread::yield();
  }
  loop.send(commands::SetRemoval{RemovalLaw::none});
  for (int calm = 0; calm < 20;) {
    const LoopSnapshot seen = look();
    const bool done = counting.all_ == kCommands + 1 && !seen.tool.undoing && !seen.tool.redoing;
    calm = done && seen.blocks_waiting == 0 ? calm + 1 : 0;
    const std::uint64_t tick = seen.tick;
    while (loop.latest().tick == tick) std::this_thread::yield();
  }
  const RunReport report = loop.stop();
  const LoopSnapshot last = look();

  EXPECT_EQ(report.fault, DeviceFault::none);
  EXPECT_NE(report.guard, ArmingState::fault);
  EXPECT_EQ(counting.all_, kCommands + 1);
  EXPECT_EQ(last.commands_dropped, dropped);
  EXPECT_EQ(last.blocks_outside, 0U);
  std::uint64_t refused = 0;
  for (std::size_t kind = 0; kind < counting.obeyed_.size(); ++kind) {
    EXPECT_GT(counting.obeyed_[kind], 20) << "of kind " << kind;
    refused += std::uint64_t(counting.refused_[kind]);
  }
  EXPECT_EQ(last.commands_refused, refused);
  EXPECT_GT(refused, 50U);
  EXPECT_GT(report.events[std::size_t(SafetyEvent::model_swapped)], 100U);
  const LoopCommand exchange = model.prepare_workpiece(coarse(2e-3), ball());
  EXPECT_EQ(std::uint32_t(counting.obeyed_[exchange.index()]), last.tool.workpiece);

  // What was received of the last workpiece is what is there.
  if (workpiece == last.tool.workpiece)
    for (const auto& [origin, content] : picture) {
      ChangedBlock now;
      now.origin = origin;
      copy_block(simulation.workpiece(), now);
      ASSERT_EQ(content.material, now.material);
      ASSERT_EQ(content.fill, now.fill);
    }
  // And it can still be cut, undone and redone.
  const std::size_t marks = simulation.undo_marks();
  while (simulation.undo_marks() > 0)
    while (!simulation.undo(16)) {
    }
  EXPECT_GE(simulation.redo_marks(), marks);
}

TEST(LiveCommands, AHundredThousandAtRandomInSimulatedTime) { tell_a_hundred_thousand(true, false, 1); }
TEST(LiveCommands, AHundredThousandAtRandomInRealTimeBehindACoupling) { tell_a_hundred_thousand(false, true, 2); }

}  // namespace
}  // namespace hapticut::live_commands_test
