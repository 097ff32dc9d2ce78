// SPDX-License-Identifier: Apache-2.0
// A custom force law that cuts: springs at points, and each removed volume costs the cutting energy.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <hapticut/closed_forms.hpp>
#include <hapticut/hapticut.hpp>
#include <iostream>
#include <memory>

using namespace hapticut;
using namespace hapticut::units;

/// Law A of docs/model.md, section 3, without its damper and without chips.
class CuttingLaw final : public ForceLaw {
 public:
  LawTotals evaluate(const HeadMotion& motion, const ContactMaterials& materials,
                     ContactBlock& block) const noexcept override {
    LawTotals totals;
    totals.may_remove = motion.cuts();
    const double volume = std::pow(double(motion.voxel_size), 3), dt = double(motion.duration);
    for (int i = 0; i < block.lanes(); ++i) {
      const auto n = std::size_t(i);
      const ContactMaterial& material = materials[block.material_of(i)];
      const double k = double(material.stiffness), u = double(material.cutting_energy);
      const double kappa = motion.spin != 0 ? double(material.cutting_ratio) : 0;
      const double fill = double(block.fill[n]), w = double(block.depth[n]);

      // Motion of the head's surface at this sample: `advance` towards the material, `slip` along it.
      const Vec3 r(block.x[n], block.y[n], block.z[n]), normal(block.normal_x[n], block.normal_y[n], block.normal_z[n]);
      const Vec3 path = motion.velocity.cast<double>() + motion.angular_velocity.cast<double>().cross(r);
      const Vec3 surface = path + double(motion.spin) * Vec3::UnitZ().cross(r);
      const double advance = path.dot(normal) * dt;
      const Vec3 slip = surface - surface.dot(normal) * normal;
      const double slip_squared = slip.squaredNorm(), slip_speed = std::sqrt(slip_squared + kSmallSlip * kSmallSlip);
      const double rubbed = kappa * slip_squared / slip_speed * dt;  // [m]; times the normal force: work of the drag

      // On a full voxel the work of the drag pays for removing the fraction x. The fill decays exponentially; its mean
      // over the step gives the force.
      const double x = motion.cuts() && w > double(material.cutting_depth) ? k * w * rubbed / u : 0;
      const double left = fill * std::exp(-x), mean = x > 1e-9 ? (fill - left) / x : fill;
      const double pressing = k * volume * mean * w;
      const Vec3 force = -pressing * normal - kappa * pressing / slip_speed * slip;
      block.force_x[n] = float(force.x());
      block.force_y[n] = float(force.y());
      block.force_z[n] = float(force.z());
      block.fill_after[n] = float(left);

      // Energy ledger: stored energy before and after, energy of cutting or rubbing, and energy lost with the chips.
      const double before = stored(k * volume * fill, w - advance / 2),
                   after = stored(k * volume * left, w + advance / 2);
      LawEnergies& energies = totals.energies;
      energies.elastic_before += before;
      energies.elastic += after;
      (x > 0 ? energies.cutting : energies.rubbing) += x > 0 ? u * volume * (fill - left) : pressing * rubbed;
      if (x > 0) energies.released += before + pressing * advance - after;
    }
    return totals;
  }

 private:
  static constexpr double kSmallSlip = 1e-3;  // [m/s] avoids a division by zero where nothing slips

  [[nodiscard]] static double stored(double k, double w) { return w > 0 ? k * w * w / 2 : 0; }
};

int main() {
  constexpr double kRadius = 1 * mm, kDepth = 0.5 * mm, kFeed = 1 * mm_per_s, kVoxel = kRadius / 20;
  const Cutter cutter{CutterKind::coarse_diamond};  // this law has no chip thickness; use ChipChord for blades
  const Tool tool(SphereHead{kRadius}, RayHandle{0}, Spindle{40000 * rpm}, cutter);
  const Material bone = find_preset("cortical_bone", cutter.kind);
  const double omega = tool.spindle().speed, layer = kRadius / 20;

  SimulationConfig config;
  config.law = std::make_shared<CuttingLaw>();
  config.reference_stiffness =  // C34: gives a cutting layer of a twentieth of the radius, which is one voxel
      2 * bone.specific_cutting_energy * kFeed / (bone.cutting_ratio * omega * kRadius * layer * layer);
  Simulation simulation(build_block({Vec3(-3, -2, -2) * mm, Vec3(3, 2, 0) * mm}, kVoxel, bone), tool, config);

  Vec3 sum = Vec3::Zero();
  constexpr int kTicks = 6000, kSteady = 4000;
  for (int tick = 1; tick <= kTicks; ++tick) {
    const Vec3 hand(-4.5 * mm + kFeed * ms * tick, 0, kRadius - kDepth);
    const StepResult& result = simulation.step(Pose::from_translation(hand), {{kFeed, 0, 0}, Vec3::Zero()}, 1 * ms);
    if (tick > kSteady) sum += result.force;
  }
  const closed_forms::SteadyCut cut{.specific_cutting_energy = bone.specific_cutting_energy,
                                    .cutting_ratio = bone.cutting_ratio,
                                    .spin = omega,
                                    .feed_speed = kFeed};
  std::cout << "mean force: " << (sum / (kTicks - kSteady)).transpose() << " N\n"
            << "on paper:   " << closed_forms::groove_wrench(cut, kRadius, kDepth).force.transpose() << " N (C26)\n"
            << "ledger off by " << std::abs(simulation.last_result().energy.closure()) * 100 << " %\n";
}
