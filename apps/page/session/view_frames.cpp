// SPDX-License-Identifier: Apache-2.0
// What a session sends to its pages sixty times per second.
#include <algorithm>
#include <chrono>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "page/session/view_session.hpp"

namespace hapticut::apps {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kPagesTime = std::chrono::milliseconds(8);  // time for pages in one frame
constexpr double kSampleRate = 48'000;                     // [Hz]
constexpr double kNoForce = 1e-4;                          // [N] mean force on a material that is no longer shown

}  // namespace

void ViewSession::drain_blocks() {
  ChangedBlock block;
  while (loop_->receive(block)) stream_.update(block.origin, block.material.data(), block.fill.data());
}

void ViewSession::send_pages() {
  const auto end = Clock::now() + kPagesTime;
  SurfacePage page;
  while (Clock::now() < end && stream_.next_page(page)) server_.send(page);
}

/// Shows the values of the model, after it has processed all commands.
void ViewSession::send_controls() {
  const ModelSettings& has = watched_->settings();
  if (!controls_outdated_ || has.answered != sent_) return;
  controls_outdated_ = false;
  controls_.show(has);
  server_.send(controls_.all());
}

LoopSnapshot ViewSession::latest() {
  LoopSnapshot snapshot = loop_->latest();
  snapshot.tool.removed_volume += removed_before_;
  return snapshot;
}

void ViewSession::frame(double seconds) {
  if (!paused_ && !loop_->is_running()) pause();
  drain_blocks();
  send_pages();
  send_controls();
  send_heat();
  send_loose_pieces();
  LoopSnapshot snapshot = latest();
  begins_ =
      begins_ && snapshot.tick == tick_before_;  // before the first tick, the snapshot belongs to the previous run
  if (paused_ || begins_) {
    snapshot.arming = ArmingState::off;
    snapshot.tool.force = snapshot.tool.torque = Vec3::Zero();
    snapshot.tool.spindle_speed = 0;
    server_.send(snapshot);
    return;
  }
  server_.send(snapshot);
  const WatchedModel::Trace trace = watched_->drain_trace();
  server_.send_trace(trace.first, trace.samples, simulation_.config().update_rate);
  server_.send(instruments(snapshot, seconds));
  send_sound(snapshot, seconds);
  send_guard_notice();
  if (device_ != nullptr) {  // a device has no press button: a cut begins at a touch
    const bool touches = snapshot.tool.contact_voxels > 0;
    if (touches && !touched_) begin_cut();
    touched_ = touches;
  }
}

view::Instruments ViewSession::instruments(const LoopSnapshot& snapshot, double seconds) {
  view::Instruments shown;
  const Pose X_WH = WorkspaceMap(map_).to_world(snapshot.device.X_BS);
  shown.X_WG = X_WH * tool_.X_HT();
  if (device_ == nullptr) shown.X_WG = snapshot.device.X_BS;
  const double power = std::max(0.0, snapshot.tool.dissipated - std::exchange(dissipated_, snapshot.tool.dissipated));
  power_ += 0.2 * (power / std::max(seconds, 1e-3) - power_);
  shown.power = power_;
  const auto materials = std::size_t(simulation_.workpiece().materials().size());
  watched_->fill(shown, materials);
  const std::vector<double> forces = watched_->drain_forces(materials);
  forces_.resize(forces.size());
  for (std::size_t n = 0; n < forces.size(); ++n) {
    forces_[n] += 0.3 * (forces[n] - forces_[n]);
    if (forces_[n] < kNoForce) forces_[n] = 0;
  }
  shown.forces = forces_;
  return shown;
}

void ViewSession::send_sound(const LoopSnapshot& snapshot, double seconds) {
  due_samples_ = std::min(due_samples_ + seconds * kSampleRate, 0.1 * kSampleRate);
  samples_.resize(std::size_t(due_samples_));
  due_samples_ -= double(samples_.size());
  sound_.render(samples_, kSampleRate, listener_.listen(snapshot));
  if (!controls_.sound() || server_.connections() == 0) return;
  for (float& sample : samples_) sample *= float(2 * controls_.volume());
  server_.send_sound(samples_, std::uint32_t(kSampleRate));
}

/// Sends the guard's reason for holding back the force.
void ViewSession::send_guard_notice() {
  for (const SafetyLogEntry& entry : device().drain_log()) {
    const bool is_state = entry.event == SafetyEvent::engaged || entry.event == SafetyEvent::fading_in ||
                          entry.event == SafetyEvent::armed || entry.event == SafetyEvent::fault_reset ||
                          entry.event == SafetyEvent::waiting_free;  // snapshots show it
    const bool noise = entry.event == SafetyEvent::saturated || entry.event == SafetyEvent::slew_limited ||
                       entry.event == SafetyEvent::passivity || entry.event == SafetyEvent::late_wake_up;
    if (!is_state && !noise) server_.send_notice(view::Severity::warning, sentence_of(entry));
  }
}

/// Sends new temperatures. Heat that can no longer be computed ends.
void ViewSession::send_heat() {
  if (heat_ == nullptr) return;
  try {
    if (const auto heat = heat_->take()) server_.send(*heat);
  } catch (const std::exception& error) {
    server_.send_notice(view::Severity::error, as_sentence(error));
    pause();
    heat_.reset();
    server_.send(view::Heat{});
    controls_.show_heat(false);
    controls_outdated_ = true;
    start();
  }
}

void ViewSession::send_loose_pieces() {
  if (islands_ == nullptr) return;
  const std::uint64_t count = islands_->count();
  if (count != std::exchange(told_pieces_, count))
    server_.send_notice(view::Severity::info, "A loose piece was removed, " + std::to_string(count) + " so far.");
}

}  // namespace hapticut::apps
