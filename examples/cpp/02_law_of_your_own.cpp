// SPDX-License-Identifier: Apache-2.0
// A force law of your own: one class, handed to the simulation in its configuration.
#include <hapticut/hapticut.hpp>
#include <iostream>

using namespace hapticut;
using namespace hapticut::units;

/// A foundation that stiffens as it is pressed: pressure k_v w (1 + w / w_s) instead of k_v w.
class StiffeningLaw final : public ForceLaw {
 public:
  explicit StiffeningLaw(double stiffening_depth) : inverse_depth_(1 / stiffening_depth) {
    require_positive(stiffening_depth, "StiffeningLaw::stiffening_depth [m]");
  }

  // One block of samples in, a force on each out; nothing may be allocated here, and nothing thrown.
  LawTotals evaluate(const HeadMotion& motion, const ContactMaterials& materials,
                     ContactBlock& block) const noexcept override {
    LawTotals totals;
    totals.may_remove = false;  // this law only presses
    const double voxel_volume = std::pow(double(motion.voxel_size), 3);
    for (int i = 0; i < block.lanes(); ++i) {
      const auto n = std::size_t(i);
      const double k = double(materials[block.material_of(i)].stiffness) * double(block.fill[n]) * voxel_volume;
      const double w = double(block.depth[n]);
      const double force = k * w * (1 + w * inverse_depth_);  // 0 where the fill is 0
      block.force_x[n] = float(-force) * block.normal_x[n];
      block.force_y[n] = float(-force) * block.normal_y[n];
      block.force_z[n] = float(-force) * block.normal_z[n];
      block.fill_after[n] = block.fill[n];

      // For the energy ledger: what is stored at the two ends of the step's motion.
      const Eigen::Vector3f at(block.x[n], block.y[n], block.z[n]);
      const Eigen::Vector3f normal(block.normal_x[n], block.normal_y[n], block.normal_z[n]);
      const double advance =
          double((motion.velocity + motion.angular_velocity.cross(at)).dot(normal) * motion.duration);
      totals.energies.elastic_before += energy(k, w - advance / 2);
      totals.energies.elastic += energy(k, w + advance / 2);
    }
    return totals;
  }

 private:
  [[nodiscard]] double energy(double k, double w) const {
    w = std::max(w, 0.0);
    return k * w * w * (0.5 + w * inverse_depth_ / 3);
  }

  double inverse_depth_;  // [1/m]
};

int main() {
  SimulationConfig config;
  config.law = std::make_shared<StiffeningLaw>(0.1 * mm);
  Simulation simulation(build_block({Vec3(-3, -3, -4) * mm, Vec3(3, 3, 0) * mm}, 0.1 * mm, presets::dentin()),
                        Tool(SphereHead{1.5 * mm}), config);
  for (int tick = 1; tick <= 400; ++tick) {
    const Vec3 hand(0, 0, 1.5 * mm - 0.002 * mm * tick);
    const StepResult& result = simulation.step(Pose::from_translation(hand), {}, 1 * ms);
    if (tick % 100 == 0)
      std::cout << 0.002 * tick << " mm deep: " << result.force.z() << " N, stored " << result.energy.elastic
                << " J, ledger off by " << std::abs(result.energy.closure()) * 100 << " %\n";
  }
}
