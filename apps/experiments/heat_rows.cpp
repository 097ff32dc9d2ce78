// SPDX-License-Identifier: Apache-2.0
#include "experiments/heat_rows.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "experiments/report.hpp"
#include "experiments/vocabulary.hpp"
#include "hapticut/heat/heat_collector.hpp"
#include "hapticut/heat/heat_field.hpp"
#include "hapticut/simulation/coupling.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/tool/motors.hpp"
#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut::experiments {
namespace {

using units::rpm;

constexpr double kBody = 37;  // [deg C]

/// A dry hole of 6 mm in bone, and the maximum at a probe beside it, half a millimetre off and 3 mm deep.
struct DrilledHole {
  double diameter, speed, feed;  // [m], [rad/s], [m/s]

  /// [K]
  [[nodiscard]] double rise() const {
    constexpr double kDepth = 6 * mm, kStep = 2e-3, kUpdate = 20, kAfter = 30;  // [m], [s], steps, [s]
    const double radius = diameter / 2, side = radius + 6 * mm;
    const Material bone = presets::cortical_bone(CutterKind::twist_drill);
    Simulation simulation(build_block({Vec3(-side, -side, -10 * mm), Vec3(side, side, 0)}, 0.2 * mm, bone),
                          Tool(twist_drill_head(diameter, 14 * mm), RayHandle{0}, Spindle{speed * units::rad_per_s}),
                          {});
    HeatCollector collector(simulation);
    HeatField field(simulation.workpiece());
    const Vec3 probe(radius + 0.5 * mm, 0, -3 * mm);
    double warmest = kBody, z = 0.05 * mm;
    const auto look = [&] { warmest = std::max(warmest, field.temperature_at(probe)); };
    const double lowest = -kDepth - radius / std::tan(kCommonDrillPoint / 2);
    for (int n = 0; z > lowest; ++n) {
      z -= feed * kStep;
      (void)simulation.step(Pose::from_translation({0.013 * mm, 0.021 * mm, z}), {{0, 0, -feed}, Vec3::Zero()}, kStep);
      if (n % int(kUpdate) != 0) continue;
      field.advance(field.drain(collector));
      look();
    }
    for (double time = 0; time < kAfter; time += 0.1) field.advance(0.1), look();
    return warmest - kBody;
  }
};

/// A tooth as a block: 10 x 8 x 8 mm of dentin under 1.5 mm of enamel, with a pulp 4 mm below its top. The side of a
/// coarse diamond goes to and fro on it for a minute.
struct GroundTooth {
  double load, irrigation;  // [N], [W/(m^2 K)]

  /// [K] at the roof of the pulp.
  [[nodiscard]] double rise() const {
    constexpr CutterKind kCutter = CutterKind::coarse_diamond;
    constexpr double kMinute = 60, kUpdate = 50;  // [s], ticks
    const auto outside = [](const Vec3& p) {
      return std::max({std::abs(p.x()) - 5 * mm, std::abs(p.y()) - 4 * mm, p.z(), -p.z() - 8 * mm});
    };
    const auto material = [](const Vec3& p) {
      const bool in_pulp = std::abs(p.x()) < 1.5 * mm && std::abs(p.y()) < 1 * mm && p.z() < -4 * mm && p.z() > -7 * mm;
      return MaterialId(in_pulp ? 3 : p.z() > -1.5 * mm ? 1 : 2);
    };
    const MaterialTable materials({presets::enamel(kCutter), presets::dentin(kCutter), presets::pulp(kCutter)});
    SimulationConfig config;
    config.contact_time = ContactTime::end;
    Simulation simulation(
        build_body({{Vec3(-5, -4, -8) * mm, Vec3(5, 4, 0) * mm}, outside, material}, 0.2 * mm, materials, 4),
        Tool(SphereHead{0.8 * mm}, RayHandle{0}, common_spindle(300000 * rpm), Cutter{kCutter}), config);
    HeatCollector collector(simulation);
    HeatConfig heat;
    heat.irrigation = irrigation;
    HeatField field(simulation.workpiece(), heat);
    const CouplingGains gains;
    VirtualCoupling coupling(simulation, gains);
    Pose hand;
    hand.rotation = Eigen::AngleAxisd(kPi / 2, Vec3::UnitX()).toRotationMatrix();
    hand.translation = Vec3(0, 0, 0.85 * mm);
    double height = hand.translation.z();
    coupling.step(hand, {}, kTick);
    for (int n = 0; n * kTick < kMinute; ++n) {
      const double time = n * kTick;
      hand.translation = Vec3(3 * mm * std::sin(kPi * time), 2 * mm * std::sin(2 * kPi * 0.037 * time),
                              height - load / gains.stiffness);
      height = coupling.step(hand, coupling.last_result().V_WH, kTick).X_WH.translation.z();
      if (n % int(kUpdate) == 0) field.advance(field.drain(collector));
    }
    return field.temperature_at(Vec3(0, 0, -4.5) * mm) - kBody;
  }
};

}  // namespace

std::vector<HeatRow> heat_rows() {
  const std::string augustin = "Augustin et al. 2008, Arch Orthop Trauma Surg 128:71; start at 26 deg C assumed";
  const std::string farah = "Farah et al. 2019, Restor Dent Endod 44:e3";
  constexpr double kPerMinute = 1e-3 / 60;  // [m/s] a millimetre
  const DrilledHole fast = {4.5 * mm, 1820 * rpm, 84 * kPerMinute}, slow = {4.5 * mm, 1820 * rpm, 24 * kPerMinute},
                    thin = {2.5 * mm, 188 * rpm, 56 * kPerMinute};
  return {{"porcine femur, dry, 4.5 mm, 1820 rpm, 84 mm/min", 29.5, fast.rise(), augustin},
          {"the same, 24 mm/min", 29.5, slow.rise(), augustin},
          {"the same, 2.5 mm, 188 rpm, 56 mm/min", 5.4, thin.rise(), augustin},
          {"pulp under a coarse diamond, dry, 60 s, 0.5 N assumed", 6.8, GroundTooth{0.5, 0}.rise(), farah},
          {"the same, water of 23 deg C, 3000 W/(m^2 K) assumed", -8.6, GroundTooth{0.5, 3000}.rise(), farah}};
}

std::string heat_report() {
  std::ostringstream report;
  report
      << "## Heat\n\n"
         "Rises of temperature [K] that the heat field gives with the share of each cutter (`heat_share_of`). Bovine\n"
         "jaw of Sener et al. 2009 (50.9 deg C dry, below 37 deg C with saline) cannot be predicted, because neither\n"
         "load nor feed is known. The shares of drills and dental diamonds were chosen by these rows. Under water the\n"
         "pulp gets colder, so no rise under water is checked.\n\n"
         "| conditions | measured | predicted | factor | source |\n|---|---|---|---|---|\n";
  for (const HeatRow& row : heat_rows())
    report << "| " << row.conditions << " | " << digits(row.measured) << " | " << digits(row.predicted, 2) << " | "
           << digits(row.factor(), 2) << " | " << row.source << " |\n";
  return report.str();
}

}  // namespace hapticut::experiments
