// SPDX-License-Identifier: Apache-2.0
#include "reports/drill.hpp"
#include "reports/progress.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <ctime>

#include "hapticut/core/errors.hpp"

namespace hapticut::apps {

using namespace settings;

namespace {

constexpr double kMaxSteps = 1e7;
constexpr float kDeadline = 1000;  // [us]

/// [us] Processor time of this thread.
double thread_time() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) * 1e6 + double(now.tv_nsec) * 1e-3;
}

/// The quantile `p` of the values.
float percentile(const std::vector<float>& sorted, double p) {
  const auto rank = std::size_t(std::ceil(p * double(sorted.size())));
  return sorted[std::clamp<std::size_t>(rank, 1, sorted.size()) - 1];
}

StepTimes times_of(std::vector<float> times) {
  std::sort(times.begin(), times.end());
  const auto misses = times.end() - std::upper_bound(times.begin(), times.end(), kDeadline);
  return {double(percentile(times, 0.5)), double(percentile(times, 0.99)), double(percentile(times, 0.999)),
          double(times.back()), std::size_t(misses)};
}

void add(const StepResult& step, double speed, const Simulation& simulation, DrillResult& result) {
  result.removed_voxels += step.removed_voxels.size();
  result.removed_volume += step.removed_volume;
  if (step.removed_volume > 0) {
    ++result.steps_cutting;
    result.max_feed = std::max(result.max_feed, speed);
    const bool turns = !has_any(step.status, StepStatus::spindle_stands | StepStatus::spindle_stalled);
    if (turns && has_any(step.status, StepStatus::engaged_layer_thick)) ++result.steps_too_soft;
  }
  if (step.contact.voxels > 0) {
    ++result.steps_in_contact;
    const double force = step.force.norm(), torque = step.torque.norm();
    result.mean_force += force;
    result.mean_torque += torque;
    result.max_force = std::max(result.max_force, force);
    result.max_torque = std::max(result.max_torque, torque);
  }
  if (has_any(step.status, StepStatus::edges_carry_load)) result.blunt_feed += speed;
  for (int id = 1; id <= simulation.workpiece().materials().size(); ++id)
    result.pressed[std::size_t(id)] += simulation.normal_forces()[std::size_t(id)];
  for (auto bits = std::uint32_t(step.status); bits != 0; bits &= bits - 1)
    ++result.status_counts[std::size_t(std::countr_zero(bits))];
}

}  // namespace

std::size_t DrillResult::count(StepStatus bit) const {
  return status_counts[std::size_t(std::countr_zero(std::uint32_t(bit)))];
}

DrillResult drill(Simulation& simulation, const Motion& motion, double rate, bool keep_rows, BesideSteps& beside) {
  const double dt = 1 / rate;
  const double count = std::max(1.0, std::ceil(motion.duration() * rate - 1e-6));
  if (count > kMaxSteps)
    throw Error("the path takes " + format_number(motion.duration()) + " s, which is " + format_number(count) +
                " steps; at most 1e+07 are possible. Raise the feed, or lower the rate.");
  const auto steps = std::size_t(count);
  const Pose X_TH = simulation.tool().X_HT().inverse();

  DrillResult result;
  std::vector<float> times(steps);
  if (keep_rows) result.rows.reserve(steps);
  ProgressBar progress("drilling", steps);

  Pose before = motion.pose_at(0) * X_TH;
  for (std::size_t i = 0; i < steps; ++i) {
    const double t = double(i + 1) * dt;
    const Pose X_WT = motion.pose_at(t);
    const Pose pose = X_WT * X_TH;
    const Twist velocity = twist_between(before, pose, dt);
    before = pose;

    const double start = thread_time();
    const StepResult& step = simulation.step(pose, velocity, dt);
    times[i] = float(thread_time() - start);

    add(step, velocity.linear.norm(), simulation, result);
    if (has_any(step.status, kRejected) && ++result.steps_rejected == 1) result.first_rejected = i + 1;
    if (i == 0) result.starts_in_contact = step.contact.voxels > 0;
    if (keep_rows)
      result.rows.push_back({t, X_WT, step.force, step.torque, step.removed_volume, step.contact.voxels, step.status});
    if (has_any(step.status, StepStatus::blocks_low)) {
      simulation.reserve_blocks(simulation.config().reserved_blocks);
      result.blocks_refilled = true;
    }
    beside.after_step(dt);
    progress.advance_to(i + 1);
  }

  result.steps = steps;
  if (result.steps_in_contact > 0) {
    result.mean_force /= double(result.steps_in_contact);
    result.mean_torque /= double(result.steps_in_contact);
  }
  result.energy = simulation.last_result().energy;
  result.times = times_of(std::move(times));
  return result;
}

}  // namespace hapticut::apps
