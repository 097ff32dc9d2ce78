// SPDX-License-Identifier: Apache-2.0
// A custom force law: one class that the configuration passes to the simulation.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <hapticut/hapticut.hpp>
#include <iostream>
#include <memory>

using namespace hapticut;
using namespace hapticut::units;

/// A foundation that becomes stiffer with depth: its pressure is k_v w (1 + w / w_s) instead of k_v w.
class StiffeningLaw final : public ForceLaw {
 public:
  explicit StiffeningLaw(double stiffening_depth) : inverse_depth_(1 / stiffening_depth) {
    require_positive(stiffening_depth, "StiffeningLaw::stiffening_depth [m]");
  }

  // Computes the force on each sample of a block. It must not allocate and must not throw.
  LawTotals evaluate(const HeadMotion& motion, const ContactMaterials& materials,
                     ContactBlock& block) const noexcept override {
    LawTotals totals;
    totals.may_remove = false;  // this law never cuts
    const double voxel_volume = std::pow(double(motion.voxel_size), 3);
    for (int i = 0; i < block.lanes(); ++i) {
      const auto n = std::size_t(i);
      const double k = double(materials[block.material_of(i)].stiffness) * double(block.fill[n]) * voxel_volume;
      const double w = double(block.depth[n]);
      const double force = k * w * (1 + w * inverse_depth_);  // 0 if the voxel is empty
      block.force_x[n] = float(-force) * block.normal_x[n];
      block.force_y[n] = float(-force) * block.normal_y[n];
      block.force_z[n] = float(-force) * block.normal_z[n];
      block.fill_after[n] = block.fill[n];

      // Elastic energy at the beginning and at the end of the step, for the energy ledger.
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
