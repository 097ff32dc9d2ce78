// SPDX-License-Identifier: Apache-2.0
// Random runs, from a seed, with all that can happen between two steps: setters, holds, refused readings, exchanges.
// The replay of each recording has the same bits. HAPTICUT_COMPOSED_SEED=n begins with the seed that a failure names.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "experiments/setup/cutting.hpp"
#include "support/composed_hand.hpp"
#include "support/composed_scenes.hpp"
#include "support/recordings.hpp"
#include "support/temporary_folder.hpp"

namespace hapticut::composed_recording_test {
namespace {

using namespace test;
using units::mm;

/// What moves the tool: a hand, somebody else's coupling, or the coupling of the library.
enum class Drive { hand, other_coupling, coupling };

/// Numbers of steps in states that a recording must hold.
struct Seen {
  std::uint64_t steps = 0, held_in_contact = 0, crushing = 0, stalled = 0, refused = 0, exhausted = 0, kept = 0,
                cutting = 0;
};

/// Counts the steps in such states.
class SeenSteps final : public StepObserver {
 public:
  SeenSteps(Simulation& simulation, Seen& seen) : simulation_(simulation), seen_(seen) {
    simulation.observers().add(*this);
  }
  ~SeenSteps() override { simulation_.observers().remove(*this); }
  SeenSteps(const SeenSteps&) = delete;
  SeenSteps& operator=(const SeenSteps&) = delete;

  void on_step(const ObservedStep& step) noexcept override {
    const StepStatus status = step.result.status;
    ++seen_.steps;
    seen_.held_in_contact += step.spindle_held && step.result.contact.depth > 0 ? 1 : 0;
    seen_.crushing += has_any(status, StepStatus::material_crushed) ? 1 : 0;
    seen_.stalled += has_any(status, StepStatus::spindle_stalled) ? 1 : 0;
    seen_.refused += has_any(status, kRejected | StepStatus::tool_waits) ? 1 : 0;
    seen_.exhausted += has_any(status, StepStatus::blocks_exhausted) ? 1 : 0;
    seen_.kept += step.path == OutputPath::kept ? 1 : 0;
    seen_.cutting += step.result.removed_volume > 0 ? 1 : 0;
  }

 private:
  Simulation& simulation_;
  Seen& seen_;
};

class RecordedRun {
 public:
  RecordedRun(std::uint64_t seed, Drive drive, Seen& seen)
      : random_(seed),
        drive_(drive),
        voxel_(random_.between(0.12, 0.25) * mm),
        config_(some_settings()),
        simulation_{some_piece(voxel_, random_), some_tool(random_), config_},  // drawn in this order
        fresh_(simulation_.workpiece().snapshot()),
        hand_(simulation_.tool()),
        seen_(seen) {
    if (drive == Drive::coupling) coupling_.emplace(simulation_, some_gains(false, random_));
    simulation_.history().reserve(200);
  }

  /// Records a part of the run, and replays it. The next part begins where this one ends, with a clone of the
  /// workpiece.
  void record(const std::filesystem::path& path) {
    for (int n = below(4, random_); n > 0; --n) one_of(quiet());
    if (below(3, random_) == 0) one_of(setters());
    const int ticks = 100 + below(300, random_);
    std::optional<int> end;  // tick of an exchange
    if (below(3, random_) != 0) end = below(ticks, random_);
    {
      const SeenSteps counting(simulation_, seen_);
      const StepLog log(simulation_);
      Recorder recorder(path, simulation_, patient());
      for (int tick = 0; tick < ticks && tick != end; ++tick) {
        if (left_-- == 0) begin_action();
        if (below(8, random_) == 0)
          for (int n = 1 + below(4, random_); n > 0; --n) one_of(quiet());
        move();
      }
      if (end) one_of(below(2, random_) == 0 ? setters() : exchanges());
      for (int tick = below(3, random_); end && tick > 0; --tick) move();
      recorder.close();
      expect_repeats(path, log);
    }
    if (simulation_.config().removal == RemovalLaw::none) simulation_.set(RemovalLaw::constant_energy);
    simulation_.reset(below(4, random_) == 0 ? some_piece(voxel_, random_) : simulation_.workpiece().clone());
    fresh_ = simulation_.workpiece().snapshot();
  }
  [[nodiscard]] const std::string& events() const { return happened_; }

 private:
  /// Something that happens between two steps.
  struct Event {
    std::string_view name;
    void (*happens)(RecordedRun& run);
  };

  void one_of(const std::vector<Event>& events) {
    const Event& event = events[std::size_t(below(int(events.size()), random_))];
    happened_.append(" ").append(event.name);
    event.happens(*this);
  }

  SimulationConfig some_settings() {
    SimulationConfig config = some_config(random_);
    constexpr std::size_t kReserves[] = {1, 4, 30, 4096};
    config.reserved_blocks = kReserves[below(4, random_)];
    if (drive_ == Drive::hand && below(2, random_) == 0) config.contact_time = ContactTime::middle;
    if (below(3, random_) == 0) config.friction = DryFriction{0.4, 0.3, 1000};
    if (below(3, random_) == 0) config.removed_voxel_capacity = 3;
    config.effects = some_effects();
    return config;
  }

  Effects some_effects() {
    Effects effects;
    const double zero = below(2, random_) == 0 ? 0.0 : -0.0;
    if (below(3, random_) == 0) effects.gravity = Gravity{0.1, Vec3(zero, 0, 0.01), Vec3(zero, 0, -9.81)};
    if (below(3, random_) == 0) effects.vibration.emplace();
    if (below(3, random_) == 0) effects.delta_filter.emplace();
    effects.enabled.force[0] = below(5, random_) != 0;
    if (below(2, random_) == 0) {
      effects.limits.max_force = random_.between(0.5, 3);
      effects.limits.force_growth = 1000;
      effects.limits.ramp_time = 0.1;
    }
    return effects;
  }

  /// A speed of the spindle, often one that it has already.
  AngularSpeed some_speed() {
    const double setting = simulation_.spindle().setting(), own = simulation_.tool().spindle().speed;
    switch (below(6, random_)) {
      case 0:
        return 0 * units::rad_per_s;
      case 1:
        return -0.0 * units::rad_per_s;
      case 2:
        return (setting != 0 ? -setting : -own) * units::rad_per_s;
      case 3:
        return random_.between(0.2, 1) * own * units::rad_per_s;
      default:
        return (setting != 0 ? setting : own) * units::rad_per_s;
    }
  }

  std::size_t some_reserve() {
    const std::size_t asked = simulation_.config().reserved_blocks, there = simulation_.workpiece().reserved_blocks();
    const std::size_t reserves[] = {asked, asked + 1, 1, there + 1, 50};
    return reserves[below(5, random_)];
  }

  BlockVoxels some_voxels() {
    std::vector<VoxelIndex> blocks;
    simulation_.workpiece().for_each_block([&](const BlockView& block) { blocks.push_back(block.origin); });
    BlockVoxels voxels;
    voxels.origin = blocks[std::size_t(below(int(blocks.size()), random_))];
    voxels.voxels.words[std::size_t(below(8, random_))] = 0xffff;
    return voxels;
  }

  /// Events that a recording goes on after.
  static const std::vector<Event>& quiet() {
    static const std::vector<Event> all = {
        {"speed", [](RecordedRun& r) { r.simulation_.spindle().set_speed(r.some_speed()); }},
        {"speed", [](RecordedRun& r) { r.simulation_.spindle().set_speed(r.some_speed()); }},
        {"halt", [](RecordedRun& r) { r.simulation_.spindle().halt(); }},
        {"hold", [](RecordedRun& r) { r.simulation_.spindle().hold(true); }},
        {"let_go", [](RecordedRun& r) { r.simulation_.spindle().hold(false); }},
        {"let_go", [](RecordedRun& r) { r.simulation_.spindle().hold(false); }},
        {"effects", [](RecordedRun& r) { r.simulation_.set(r.some_effects()); }},
        {"reserve", [](RecordedRun& r) { r.simulation_.reserve_blocks(r.some_reserve()); }},
        {"mark", [](RecordedRun& r) { r.simulation_.history().mark(); }},
        {"release", [](RecordedRun& r) { r.simulation_.release_hand(); }},
        {"leave",
         [](RecordedRun& r) {
           if (r.coupling_) r.coupling_->park(VirtualCoupling::Rejoin(below(2, r.random_)));
         }},
        {"gains",
         [](RecordedRun& r) {
           if (r.coupling_) r.coupling_->set_gains(some_gains(false, r.random_));
         }},
        {"ask", [](RecordedRun& r) {
           (void)r.simulation_.touches(r.hand_.X_WD());
           (void)r.simulation_.probe(r.hand_.X_WD(), r.hand_.velocity(), 1e-3);
           (void)r.simulation_.workpiece().snapshot();
         }}};
    return all;
  }

  /// Settings that end a recording, and that one may begin with.
  static const std::vector<Event>& setters() {
    static const std::vector<Event> all = {
        {"tool",
         [](RecordedRun& r) {
           r.simulation_.set(some_tool(r.random_));
           r.grip_tool();
         }},
        {"materials", [](RecordedRun& r) { r.simulation_.set(some_materials(r.random_)); }},
        {"friction",
         [](RecordedRun& r) {
           const std::optional<DryFriction> friction = DryFriction{0.4, 0.3, 1000};
           r.simulation_.set(below(2, r.random_) == 0 ? std::nullopt : friction);
         }},
        {"removal", [](RecordedRun& r) {
           const bool cuts = r.simulation_.config().removal != RemovalLaw::none;
           r.simulation_.set(cuts ? RemovalLaw::none : RemovalLaw::constant_energy);
         }}};
    return all;
  }

  /// Changes of the workpiece, which end a recording.
  static const std::vector<Event>& exchanges() {
    static const std::vector<Event> all = {
        {"undo", [](RecordedRun& r) { undo_all(r.simulation_); }},
        {"part_of_undo", [](RecordedRun& r) { (void)r.simulation_.history().undo(1); }},
        {"redo",
         [](RecordedRun& r) {
           undo_all(r.simulation_);
           redo_all(r.simulation_);
         }},
        {"restore", [](RecordedRun& r) { r.simulation_.history().restore(r.fresh_); }},
        {"reset", [](RecordedRun& r) { r.simulation_.reset(some_piece(r.voxel_, r.random_)); }},
        {"remove", [](RecordedRun& r) { (void)r.simulation_.remove_voxels(r.some_voxels()); }},
        {"exchange",
         [](RecordedRun& r) {
           Simulation other = r.another();
           r.simulation_.exchange(other);
           r.grip_tool();
         }},
        {"exchange_back", [](RecordedRun& r) {
           Simulation other = r.another();
           other.exchange(r.simulation_);
           r.grip_tool();
         }}};
    return all;
  }

  Simulation another() {
    Workpiece piece = some_piece(voxel_, random_);
    return {std::move(piece), some_tool(random_), config_};
  }

  void grip_tool() {
    hand_.grip(simulation_.tool());
    if (!coupling_) return;
    VirtualCoupling::Lists lists(simulation_.worst_case(), simulation_.config());
    coupling_->exchange_lists(lists);
  }

  void begin_action() {
    left_ = int(random_.between(0.01, 0.1) / dt_);
    dt_ = 1 / random_.between(500, 4000);
    const StepStatus status = coupling_ ? coupling_->last_result().status : simulation_.last_result().status;
    const bool waits = has_any(status, StepStatus::tool_waits);
    hand_.begin(waits && below(2, random_) == 0 ? Motion::lift : Motion(below(9, random_)), random_);
  }

  /// A reading of a device, sometimes one that must be refused.
  StepInput reading() {
    StepInput input{hand_.X_WD(), hand_.velocity(), dt_};
    switch (below(80, random_)) {
      case 0:
        input.X_WH.translation[below(3, random_)] = std::numeric_limits<double>::quiet_NaN();
        break;
      case 1:
        input.X_WH.rotation.col(0) *= -1;
        break;
      case 2:
        input.X_WH.rotation = rotation_from_vector(Vec3(units::kPi, 0, 0)) * input.X_WH.rotation;
        break;
      case 3:
        input.V_WH.linear[1] = std::numeric_limits<double>::infinity();
        break;
      case 4:
        input.V_WH.linear *= 1e4;
        break;
      case 5:
        input.dt = random_.between(-0.1, 1);
        break;
      case 6:
        jump_ = random_.vector(80 * mm), jumps_ = 1 + below(3, random_);
        break;
      default:
        break;
    }
    if (jumps_ > 0) --jumps_, input.X_WH.translation += jump_;
    return input;
  }

  /// A coupling of another program: answers at some steps, and keeps its output at others.
  class OtherCoupling final : public HandCoupling {
   public:
    OtherCoupling(const Pose& X_WD, double answers, double dt) : X_WD_(X_WD), answers_(answers), dt_(dt) {}
    std::optional<HandOutput> answer(const StepResult& stepped) noexcept override {
      if (answers_ < 0.3) return std::nullopt;
      return HandOutput{X_WD_, {answers_ * stepped.model.force, stepped.model.torque}, dt_};
    }

   private:
    Pose X_WD_;
    double answers_, dt_;
  };

  void move() {
    hand_.move(simulation_.last_result().force.norm(), dt_);
    const auto [X_WH, V_WH, dt] = reading();
    if (drive_ == Drive::coupling) {
      (void)coupling_->step(X_WH, V_WH, dt);
    } else if (drive_ == Drive::hand) {
      (void)simulation_.step(X_WH, V_WH, dt);
    } else {
      OtherCoupling other(hand_.X_WD(), random_.between(0, 1), dt_);
      (void)simulation_.step(X_WH, V_WH, dt, &other);
    }
  }

  RandomPoses random_;
  Drive drive_;
  double voxel_;
  SimulationConfig config_;
  Simulation simulation_;
  WorkpieceSnapshot fresh_;
  ComposedHand hand_;
  std::optional<VirtualCoupling> coupling_;
  Seen& seen_;
  Vec3 jump_ = Vec3::Zero();  // [m]
  int jumps_ = 0, left_ = 0;
  double dt_ = 1e-3;  // [s]
  std::string happened_;
};

class ComposedRecording : public testing::TestWithParam<Drive> {};

TEST_P(ComposedRecording, ReplaysWithTheSameBits) {
  constexpr std::uint64_t kRuns = kWithAddressSanitizer ? 4 : 12;
  constexpr int kRecordings = 6;
  const TemporaryFolder folder;
  const std::uint64_t first = number_from("HAPTICUT_COMPOSED_SEED", 1);
  const std::uint64_t runs = number_from("HAPTICUT_COMPOSED_RUNS", kRuns);
  Seen seen;
  for (std::uint64_t seed = first; seed < first + runs; ++seed) {
    RecordedRun run(seed, GetParam(), seen);
    for (int n = 0; n < kRecordings && !HasFailure(); ++n) run.record(folder / "a.h5");
    ASSERT_FALSE(HasFailure()) << "seed " << seed << ":" << run.events();
  }
  std::cout << seen.steps << " steps, of which " << seen.cutting << " cut, " << seen.held_in_contact
            << " with a held spindle in material, " << seen.crushing << " crush, " << seen.stalled << " stalled, "
            << seen.refused << " refused, " << seen.exhausted << " without blocks, " << seen.kept
            << " keep the output\n";
  std::vector<std::uint64_t> needed = {seen.cutting, seen.held_in_contact};
  if (GetParam() != Drive::coupling)  // which refuses most readings itself, and presses less
    needed.insert(needed.end(), {seen.crushing, seen.stalled, seen.refused, seen.exhausted});
  for (const std::uint64_t count : needed) EXPECT_GT(count, 10U) << "too few such steps to test anything";
}

std::string name_of(const testing::TestParamInfo<Drive>& drive) {
  constexpr std::array kNames = {"Hand", "OtherCoupling", "Coupling"};
  return kNames[std::size_t(drive.param)];
}
INSTANTIATE_TEST_SUITE_P(Drives, ComposedRecording,
                         testing::Values(Drive::hand, Drive::other_coupling, Drive::coupling), name_of);

}  // namespace
}  // namespace hapticut::composed_recording_test
