// SPDX-License-Identifier: Apache-2.0
#include "gestures/scripted_loops.hpp"

#include <utility>
#include "hapticut/loop/coupling_gains.hpp"

namespace hapticut::gestures {
namespace {

constexpr double kArming = 1.7;  // [s] time in the air before the script, while the guard arms

/// A workpiece rotated about the origin together with its grid.
Workpiece turned(Workpiece piece, const Mat3& turn) {
  if (turn.isIdentity(0)) return piece;
  GridFrame frame = piece.frame();
  frame.X_WV = Pose{turn, Vec3::Zero()} * frame.X_WV;
  return Workpiece::from_blocks(piece.bounds(), frame, piece.materials(),
                                [&](const VoxelIndex& origin, BlockContent& content) {
                                  for (int n = 0; n < kBlockVoxels; ++n) {
                                    const VoxelIndex at = voxel_at(origin, n);
                                    content.material[std::size_t(n)] = piece.material_at(at);
                                    content.fill[std::size_t(n)] = float(piece.fill_at(at));
                                    content.centroid[std::size_t(n)] = piece.centroid_at(at);
                                  }
                                  return BlockKind::mixed();
                                });
}

Wrench turned_back(const Wrench& wrench, const Mat3& turn) {
  return {turn.transpose() * wrench.force, turn.transpose() * wrench.torque};
}

SimulationConfig with_contact_time(SimulationConfig config, bool coupled) {
  if (coupled) config.contact_time = ContactTime::end;
  config.reserved_blocks = std::max<std::size_t>(config.reserved_blocks, 4096);
  return config;
}

}  // namespace

Tick tick_of(const Simulation& simulation, double time, const Mat3& turn) {
  const StepResult& result = simulation.last_result();
  Tick tick;
  tick.time = time;
  tick.model = turned_back(result.model, turn);
  tick.depth = result.contact.depth;
  tick.voxels = result.contact.voxels;
  tick.speed = result.spindle.speed;
  tick.energy = result.energy;
  tick.status = result.status;
  return tick;
}

ScriptedLoop::ScriptedLoop(Report& report, Workpiece workpiece, Tool tool, Grip grip, SimulationConfig config,
                           const std::optional<CouplingGains>& gains)
    : simulation(turned(std::move(workpiece), report.turn), std::move(tool),
                 with_contact_time(std::move(config), grip == Grip::by_coupling)),
      log(Limits{}, report),
      report_(report) {
  simulation.observers().add(log);
  if (grip == Grip::by_coupling) couple(gains.value_or(touch_gains()));
}

ScriptedLoop::~ScriptedLoop() { simulation.observers().remove(log); }

void ScriptedLoop::couple(const CouplingGains& gains) {
  coupling_.emplace(simulation, gains);
  log.limits = {gains.max_force, 0, gains.stiffness, false};
}

Span ScriptedLoop::play(const Hand& hand, const std::function<void(Pose&, double& dt)>& spoil) {
  const std::size_t first = log.ticks.size();
  const double period = report_.period;
  const Mat3& turn = report_.turn;
  const long ticks = std::lround(hand.seconds() / period);
  if (first == 0) log.begin(simulation);
  for (long n = 1; n <= ticks; ++n) {
    const Pose meant = hand.at(double(n) * period);
    const Twist path = twist_between(last_.value_or(hand.at(double(n - 1) * period)), meant, period);
    Pose pose = Pose{turn, Vec3::Zero()} * meant;
    const Twist velocity{turn * path.linear, turn * path.angular};
    double dt = period;
    if (spoil) spoil(pose, dt);
    Wrench felt;
    Pose X_WH = pose;
    double removed = 0;
    if (coupling_) {
      const CoupledResult& result = coupling_->step(pose, velocity, dt);
      felt = result.hand;
      X_WH = result.X_WH;
      removed = result.removed_volume;
    } else {
      const StepResult& result = simulation.step(pose, velocity, dt);
      felt = {result.force, result.torque};
      removed = result.removed_volume;
    }
    last_ = meant;
    Tick tick = tick_of(simulation, time_ + double(n) * period, turn);
    tick.X_WD = meant;
    tick.X_WH = Pose{turn.transpose(), Vec3::Zero()} * X_WH;
    tick.felt = tick.applied = turned_back(felt, turn);
    tick.removed = removed;
    if (coupling_) tick.contacts = coupling_->last_result().newton_steps + coupling_->last_result().sub_ticks;
    log.add(tick, simulation, coupling_ ? &*coupling_ : nullptr);
  }
  time_ += double(ticks) * period;
  end_ = hand.end();
  return {first, log.ticks.size()};
}

// --- the chain -------------------------------------------------------------------------------------------------------

DeviceChain::DeviceChain(Report& a_report, Workpiece workpiece, Tool tool, ChainOptions options)
    : simulation(turned(std::move(workpiece), a_report.turn), std::move(tool),
                 with_contact_time(options.config, options.coupled)),
      log({device_model(options.device).peak_force, device_model(options.device).peak_torque,
           device_model(options.device).rendered_stiffness, true},
          a_report),
      report_(a_report),
      options_(std::move(options)) {
  MockOptions mock;
  mock.device = device_model(options_.device);
  mock.rigid = options_.hand.empty();
  if (!mock.rigid) mock.hand = hand_model(options_.hand);
  mock.path = [this](double time) { return path_(time); };
  const auto read = [this](DeviceState& state) {
    if (spoil) spoil(state, state.time - kArming);
  };
  device_ = std::make_unique<test::FollowedMock>(mock, read, [this](const Wrench& given) { applied(given); });
  options_.map.X_WB = Pose{report_.turn, Vec3::Zero()} * options_.map.X_WB;
  SimulationModelOptions model;
  model.map = options_.map;
  if (options_.coupled) model.coupling = options_.gains.value_or(coupling_gains(device_->capabilities()));
  model.undo_blocks = options_.undo_blocks;
  model_ = std::make_unique<SimulationModel>(simulation, *device_, model);
  simulation.observers().add(log);
}

DeviceChain::~DeviceChain() { simulation.observers().remove(log); }

Device& DeviceChain::device() { return *device_; }

bool DeviceChain::tell(LoopCommand command) {
  model_->check(command);
  return model_->apply(command);
}

Span DeviceChain::play(const Hand& hand) {
  const std::size_t first = log.ticks.size();
  if (first == 0) log.begin(simulation);
  seconds_ = hand.seconds();
  count_ = 0;
  path_ = [hand](double time) { return hand.at(time - kArming); };
  RunOptions run;
  run.simulated_time = true;
  run.stop_on_signals = false;
  run.guard.period = report_.period;
  report = device_->run([this](const DeviceState& reading) { return tick(reading); }, run);
  under_way_.reset();
  return {first, log.ticks.size()};
}

DeviceCommand DeviceChain::tick(const DeviceState& reading) {
  const double scripted = double(count_) * report_.period;  // the time of the reading may be changed
  const double time = scripted - kArming;
  for (Moment& moment : moments_)
    if (moment.happens && time >= moment.time) std::exchange(moment.happens, {})();
  if (before) before(time);
  const double dt = count_ == 0 ? report_.period : reading.time - last_time_;
  last_time_ = reading.time;
  DeviceCommand command;
  command.wrench = model_->step(reading, dt > 0 ? dt : report_.period, snapshot_);
  command.contact = model_->contact();
  Tick tick = tick_of(simulation, time, report_.turn);
  tick.X_WD = path_(scripted);
  if (!options_.hand.empty() && reading.valid) tick.X_WD = reading.X_BS;
  tick.X_WH = Pose{report_.turn.transpose(), Vec3::Zero()} * snapshot_.X_WT * simulation.tool().X_HT().inverse();
  tick.felt = command.wrench;
  tick.effects = command.contact.effects;
  tick.removed = snapshot_.tool.removed_volume - std::exchange(last_removed_, snapshot_.tool.removed_volume);
  tick.depth = snapshot_.tool.contact_depth;
  tick.voxels = snapshot_.tool.contact_voxels;
  tick.arming = device_->last_arming();
  under_way_ = tick;
  ++count_;
  command.stop = time >= seconds_;
  return command;
}

/// The motors have the wrench, so the tick is complete.
void DeviceChain::applied(const Wrench& wrench) {
  if (!under_way_) return;
  under_way_->applied = wrench;
  log.add(*under_way_, simulation, nullptr);
  under_way_.reset();
}

}  // namespace hapticut::gestures
