// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <vector>

#include "hapticut/islands/island_watch.hpp"
#include "hapticut/loop/simulation_model.hpp"
#include "hapticut/realtime/triple_buffer.hpp"
#include "hapticut/view/protocol.hpp"
#include "page/session/material_under.hpp"

namespace hapticut::apps {

/// State of the model that the controls of a page change.
struct ModelSettings {
  double spindle_speed = 0;  ///< [rad/s] set speed while there is a force
  RemovalLaw removal = RemovalLaw::none;
  Effects effects;
  std::uint64_t answered = 0;  ///< number of processed commands, applied or refused
};

/// A model that records data of every tick for a page: the force on the hand (the model's force as limited by the
/// guard), the contact torque, the lateness, and by material the removed volume and the force on the head. It also
/// publishes its settings after every command. The loop writes the data and one other thread reads them, without
/// waiting.
class WatchedModel final : public LoopModel {
 public:
  static constexpr std::size_t kTicks = 4096;          ///< capacity of the trace
  static constexpr double kBucket = 25e-6;             ///< [s]
  static constexpr std::size_t kBuckets = 60;          ///< buckets of lateness; the last one includes all later ticks
  static constexpr std::size_t kMaterials = 16;        ///< number of materials with reported volumes
  static constexpr std::uint64_t kTicksOfAFrame = 16;  ///< ticks between two looks at the material under the tip

  WatchedModel(SimulationModel& model, const Simulation& simulation, const Device& device, double period)
      : model_(model), simulation_(simulation), device_(device), period_(period), settings_(settings_now()) {}

  // --- for the reading thread
  // -----------------------------------------------------------------------------------------
  struct Trace {
    std::uint64_t first = 0;
    std::vector<view::TraceSample> samples;
  };
  /// Removes and returns the samples since the last call, at most kTicks.
  [[nodiscard]] Trace drain_trace() {
    const std::uint64_t written = written_.load(std::memory_order_acquire);
    Trace trace{drained_, {}};
    for (; drained_ < written; ++drained_) trace.samples.push_back(ring_[drained_ % kTicks]);
    free_from_.store(drained_, std::memory_order_release);
    return trace;
  }
  void fill(view::Instruments& instruments, std::size_t materials) const {
    instruments.bucket = kBucket;
    instruments.latency.resize(kBuckets);
    for (std::size_t n = 0; n < kBuckets; ++n) instruments.latency[n] = latency_[n].load(std::memory_order_relaxed);
    instruments.missed = missed_.load(std::memory_order_relaxed);
    instruments.ticks = ticks_.load(std::memory_order_relaxed);
    instruments.removed.resize(std::min(materials, kMaterials));
    for (std::size_t n = 0; n < instruments.removed.size(); ++n)
      instruments.removed[n] = removed_[n].load(std::memory_order_relaxed);
    instruments.under = MaterialId(under_.load(std::memory_order_relaxed));
  }
  /// [N] Mean normal force on the head in the ticks since the last call, by material id from 1.
  [[nodiscard]] std::vector<double> drain_forces(std::size_t materials) {
    std::vector<double> mean(std::min(materials, kMaterials));
    const std::uint64_t ticks = ticks_.load(std::memory_order_acquire);
    const double share = ticks > drained_ticks_ ? 1 / double(ticks - drained_ticks_) : 0;
    for (std::size_t n = 0; n < mean.size(); ++n) {
      const double sum = pressed_[n].load(std::memory_order_relaxed);
      mean[n] = share * (sum - std::exchange(drained_pressed_[n], sum));
    }
    drained_ticks_ = ticks;
    return mean;
  }

  /// The settings of the model after the last processed command.
  [[nodiscard]] const ModelSettings& settings() noexcept { return settings_.latest(); }

  // --- for the loop's thread
  // ----------------------------------------------------------------------------------------------
  Wrench step(const DeviceState& state, double dt, LoopSnapshot& snapshot) noexcept override {
    note_time(monotonic_time());
    Wrench wrench = model_.step(state, dt, snapshot);
    const double fraction = applied_fraction();
    snapshot.tool.force *= fraction, snapshot.tool.torque *= fraction;
    note(snapshot.tool, fraction);
    const ByMaterial<double>& removed = simulation_.totals().removed_volume;
    for (std::size_t n = 0; n < kMaterials; ++n) removed_[n].store(removed[n + 1], std::memory_order_relaxed);
    note_materials(snapshot);
    if (islands_ != nullptr) islands_->tick();
    return wrench;
  }
  /// Removes loose pieces between the ticks. Not during a run.
  /// @param islands  null: they stay
  void remove_with(IslandWatch* islands) noexcept { islands_ = islands; }
  /// Forgets the last tick, so a pause between runs is not lateness.
  void begin_run() noexcept { last_ = 0; }

  [[nodiscard]] ModelContact contact() const noexcept override { return model_.contact(); }
  void check(const LoopCommand& command) const override { model_.check(command); }
  bool apply(LoopCommand& command) noexcept override {
    const bool applied = model_.apply(command);
    ++answered_;
    settings_.write(settings_now());
    return applied;
  }
  [[nodiscard]] Simulation* simulation() noexcept override { return model_.simulation(); }

 private:
  [[nodiscard]] ModelSettings settings_now() const noexcept {
    const SimulationConfig& config = simulation_.config();
    return {model_.spindle_speed(), config.removal, config.effects, answered_};
  }
  /// [1] Applied fraction 0 ... 1 of the force that the model requested in the previous tick.
  [[nodiscard]] double applied_fraction() const noexcept {
    const ArmingState arming = device_.last_arming();
    if (arming != ArmingState::ramp && arming != ArmingState::on) return 0;
    const DeviceOutput& output = device_.last_output();
    const double asked = output.commanded.force.norm();
    return asked > 0 ? std::min(1.0, output.applied.force.norm() / asked) : 1;
  }
  void note_time(double now) noexcept {
    if (last_ > 0) {
      const double late = std::max(0.0, now - last_ - period_);
      latency_[std::min(kBuckets - 1, std::size_t(late / kBucket))].fetch_add(1, std::memory_order_relaxed);
      if (late > period_) missed_.fetch_add(std::uint64_t(late / period_), std::memory_order_relaxed);
    }
    last_ = now;
    ticks_.fetch_add(1, std::memory_order_relaxed);
  }
  void note_materials(const LoopSnapshot& snapshot) noexcept {
    const ByMaterial<double>& pressed = simulation_.normal_forces();
    for (std::size_t n = 0; n < kMaterials; ++n)
      pressed_[n].store(pressed_[n].load(std::memory_order_relaxed) + pressed[n + 1], std::memory_order_relaxed);
    if (ticks_.load(std::memory_order_relaxed) % kTicksOfAFrame != 1) return;
    under_.store(material_under(simulation_.workpiece(), simulation_.tool().head(), snapshot.X_WT),
                 std::memory_order_relaxed);
  }
  void note(const ToolSnapshot& tool, double fraction) noexcept {
    const std::uint64_t at = written_.load(std::memory_order_relaxed);
    if (at - free_from_.load(std::memory_order_acquire) >= kTicks)
      return;  // the buffer is full, because nothing reads it
    const bool touches = tool.contact_voxels > 0;
    view::TraceSample& sample = ring_[at % kTicks];
    for (Eigen::Index n = 0; n < 3; ++n) {
      sample.force[std::size_t(n)] = float(tool.force[n]);
      sample.torque[std::size_t(n)] = touches ? float(fraction * simulation_.last_result().model.torque[n]) : 0.0F;
    }
    written_.store(at + 1, std::memory_order_release);
  }

  SimulationModel& model_;
  const Simulation& simulation_;
  const Device& device_;
  double period_, last_ = 0;
  std::uint64_t answered_ = 0;
  TripleBuffer<ModelSettings> settings_;
  std::array<view::TraceSample, kTicks> ring_{};
  std::atomic<std::uint64_t> written_{0}, free_from_{0}, missed_{0}, ticks_{0};
  std::uint64_t drained_ = 0, drained_ticks_ = 0;
  std::array<std::atomic<std::uint32_t>, kBuckets> latency_{};
  std::array<std::atomic<double>, kMaterials> removed_{}, pressed_{};  // pressed_: [N] sum over the ticks
  std::array<double, kMaterials> drained_pressed_{};
  std::atomic<MaterialId> under_ = kEmpty;
  IslandWatch* islands_ = nullptr;
};

}  // namespace hapticut::apps
