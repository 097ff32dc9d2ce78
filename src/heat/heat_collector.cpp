// SPDX-License-Identifier: Apache-2.0
#include "hapticut/heat/heat_collector.hpp"

#include <algorithm>
#include <boost/lockfree/spsc_queue.hpp>
#include <cmath>

#include "hapticut/core/units.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/workpiece/preset_constants.hpp"

namespace hapticut {
namespace {

constexpr double kMostlyAxial =
    0.1;                       // [1] minimum part of the squared force across the axis, or its line does not pass near
constexpr int kHalvings = 20;  // down to a millionth of the head

double heat_of_rubbing(const EnergyLedger& energy) { return energy.rubbing + energy.damping + energy.sliding; }
double heat_of_cutting(const EnergyLedger& energy) { return energy.losses() - heat_of_rubbing(energy); }

std::vector<double> shares_of_cutters() {
  std::vector<double> shares;
  for (const auto& kind : names_of(Of<CutterKind>{})) shares.push_back(heat_share_of(kind.value));
  return shares;
}

}  // namespace

double heat_share_of(CutterKind cutter) {
  const PresetConstant* share = find_constant(name_or_null(cutter), "heat_share");
  return share->typical;
}

struct HeatCollector::Queue {
  explicit Queue(std::size_t capacity) : pulses(capacity) {}
  boost::lockfree::spsc_queue<HeatPulse> pulses;
};

HeatCollector::HeatCollector(Simulation& simulation, const HeatCollectorOptions& options)
    : simulation_(simulation),
      shares_(shares_of_cutters()),
      before_(simulation.last_result().energy),
      feed_(simulation, options.blocks) {
  require_fields_within(options, "HeatCollectorOptions::");
  queue_ = std::make_unique<Queue>(options.pulses);
  simulation.observers().add(*this);
}

HeatCollector::~HeatCollector() { simulation_.observers().remove(*this); }

bool HeatCollector::receive(HeatPulse& pulse) { return queue_->pulses.pop(pulse); }

void HeatCollector::on_exchange() noexcept { before_ = simulation_.last_result().energy; }

void HeatCollector::on_step(const ObservedStep& step) noexcept {
  const EnergyLedger& now = step.result.energy;
  const double cut = std::max(0.0, heat_of_cutting(now) - heat_of_cutting(before_));
  const double rubbed = std::max(0.0, heat_of_rubbing(now) - heat_of_rubbing(before_));
  before_ = now;
  pending_.dt += step.input.dt;
  pending_.cut += cut;
  pending_.share = shares_[std::size_t(step.simulation.tool().cutter().kind)];
  if (step.result.removed_volume > 0) {
    pending_.rubbed_in_cut += rubbed;
  } else if (rubbed > 0) {
    pending_.rubbed += rubbed;
    const Tool& tool = step.simulation.tool();
    const Pose X_WT = step.input.X_WH * tool.X_HT();
    const Wrench about_To = transport(step.result.model, step.input.X_WH.translation - X_WT.translation);
    const Mat3 R_TW = X_WT.rotation.transpose();
    pending_.p_WQ = X_WT * touching_point(tool.head(), {R_TW * about_To.force, R_TW * about_To.torque});
    const Contact& contact = step.result.contact;  // a disc as deep as the head, with the same volume
    pending_.radius = contact.depth > 0 ? std::sqrt(contact.volume / (units::kPi * contact.depth)) : 0.0;
  }
  if (queue_->pulses.push(pending_)) pending_ = {};
}

Vec3 touching_point(const ToolHead& head, const Wrench& wrench_T) noexcept {
  const Vec3& f = wrench_T.force;
  const double length = f.norm();
  if (!(length > 0)) return Vec3::Zero();
  // A force at the height z of the axis has the torque z (e_z x f).
  const HeadBox box = head.bounding_box();
  const Vec3 across = Vec3::UnitZ().cross(f);
  double height = 0.5 * (box.min.z() + box.max.z());
  if (across.squaredNorm() > kMostlyAxial * length * length) {
    const double margin = 1e-3 * (box.max.z() - box.min.z());
    height = std::clamp(wrench_T.torque.dot(across) / across.squaredNorm(), box.min.z() + margin, box.max.z() - margin);
  }
  const Vec3 from(0, 0, height), to = from - f / length * (box.max - box.min).norm();
  double inside = 0, outside = 1;
  for (int n = 0; n < kHalvings; ++n) {
    const double middle = 0.5 * (inside + outside);
    (head.spring_at(from + middle * (to - from)).depth > 0 ? inside : outside) = middle;
  }
  return from + inside * (to - from);
}

}  // namespace hapticut
