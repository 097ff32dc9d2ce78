// SPDX-License-Identifier: Apache-2.0
// A loop that warns before the pulp, and tells when each tissue is first touched. docs/other-scenes.md.
#include <atomic>
#include <hapticut/hapticut.hpp>
#include <iostream>

using namespace hapticut;
using namespace hapticut::units;

/// Measures in each step, in the thread of the loop, how far the head is from the pulp.
class PulpWatch final : public StepObserver {
 public:
  PulpWatch(Simulation& simulation, MaterialId pulp) : simulation_(simulation), pulp_(pulp) {
    simulation_.observers().add(*this);
  }
  ~PulpWatch() override { simulation_.observers().remove(*this); }

  void on_step(const ObservedStep& step) noexcept override {
    distance_ = step.simulation.distance_to(pulp_, step.input.X_WH, 2 * mm);  // beyond 2 mm it is infinite
  }
  [[nodiscard]] double distance() const { return distance_; }  ///< [m] for any thread

 private:
  Simulation& simulation_;
  const MaterialId pulp_;
  std::atomic<double> distance_ = 1;
};

int main() {
  std::cout.precision(3);
  const Box box{Vec3(-4, -4, -6) * mm, Vec3(4, 4, 0) * mm};
  SimulationConfig config;
  config.contact_time = ContactTime::end;
  Simulation simulation(
      build_layered_slab(box, 0.1 * mm,
                         {{presets::enamel(), 0.3 * mm}, {presets::dentin(), 1 * mm}, {presets::pulp(), 3 * mm}}),
      Tool(SphereHead{0.6 * mm}, RayHandle{0}, common_spindle(40000 * rpm)), config);
  const MaterialTable& materials = simulation.workpiece().materials();
  const MaterialId pulp = materials.id_of("pulp");
  PulpWatch watch(simulation, pulp);
  VirtualCoupling coupling(simulation, CouplingGains{});

  bool warned = false;
  for (int n = 1; n <= 12000; ++n) {  // the hand goes down by 0.5 mm/s, to 5.3 mm below the top of the tooth
    const double time = n * 1e-3;
    const Pose X_WD = Pose::from_translation(Vec3(0, 0, 0.7 * mm - 0.5 * mm * time));
    const CoupledResult& tick = coupling.step(X_WD, {Vec3(0, 0, -0.5 * mm), Vec3::Zero()}, 1 * ms);
    tick.first_touched.for_each(
        [&](MaterialId id) { std::cout << time << " s: " << materials[id].name << " is touched\n"; });
    if (!warned && watch.distance() < 0.5 * mm) {
      warned = true;
      std::cout << time << " s: " << watch.distance() / mm << " mm to the pulp, the spindle stops\n";
      simulation.spindle().set_speed(0 * rpm);
    }
  }
  std::cout << "at the end: " << watch.distance() / mm << " mm to the pulp, which was "
            << (simulation.totals().touched.has(pulp) ? "touched\n" : "not touched\n");
}
