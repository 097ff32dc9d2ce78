// SPDX-License-Identifier: Apache-2.0
#include "gestures/gesture_list.hpp"

#include <algorithm>
#include <cmath>

namespace hapticut::gestures {
namespace {

int number_of(const std::string& id) { return std::stoi(id.substr(1)); }

/// A row of invariant 7: the largest change of a quantity between two runs.
Row comparison(const Report& from, const Report& to, const std::string& id, const std::string& scene) {
  Row row{id, scene, 0, "invariant 7", "each quantity changes by less than its tolerance", "nothing to compare", true};
  row.is_met = from.quantities().size() == to.quantities().size();
  for (std::size_t n = 0; n < std::min(from.quantities().size(), to.quantities().size()); ++n) {
    const Quantity &a = from.quantities()[n], &b = to.quantities()[n];
    const double size = std::max(std::abs(a.value), std::abs(b.value));
    const double change = size > 0 ? std::abs(a.value - b.value) / size : 0;
    if (!(change <= a.tolerance)) row.is_met = false;
    if (!(change / a.tolerance >= row.strain)) continue;
    row.strain = change / a.tolerance;
    row.seen = a.what + " of " + a.scene + ": " + shown(a.value, "") + " and " + shown(b.value, a.unit) +
               ", tolerance " + shown(100 * a.tolerance, "%");
  }
  return row;
}

std::string at_size(double voxel) { return shown(1e3 * voxel, "mm"); }

}  // namespace

std::vector<Gesture> all_gestures() {
  std::vector<Gesture> all;
  for (const auto& part : {hole_gestures(), press_gestures(), cutting_gestures(), motor_gestures(), device_gestures(),
                           loop_gestures(), further_gestures(), further_loop_gestures(), coupled_gestures()})
    all.insert(all.end(), part.begin(), part.end());
  std::ranges::sort(all, {}, [](const Gesture& gesture) { return number_of(gesture.id); });
  return all;
}

std::vector<Row> rows_of(const Gesture& gesture, std::vector<double> sizes) {
  if (!gesture.has_voxels) sizes = {0};
  std::vector<Row> rows;
  std::vector<Report> reports;
  for (const double voxel : sizes) {
    gesture.run(reports.emplace_back(gesture.id, voxel));
    rows.insert(rows.end(), reports.back().rows().begin(), reports.back().rows().end());
  }
  const Report& coarse = reports.front();

  Report probed(gesture.id, sizes.front());
  probed.probing = true;
  gesture.run(probed);
  const bool same = probed.bits() == coarse.bits();
  rows.push_back({gesture.id, "run again, with probes between the steps", sizes.front(), "invariant 6", "the same bits",
                  same ? "the same bits" : "other bits", same});

  if (coarse.quantities().empty()) return rows;
  for (std::size_t n = 1; n < reports.size(); ++n)
    rows.push_back(comparison(reports[n - 1], reports[n], gesture.id,
                              "voxels of " + at_size(sizes[n - 1]) + " and of " + at_size(sizes[n])));
  const std::string of_coarse = ", voxels of " + at_size(sizes.front());
  Report faster(gesture.id, sizes.front());
  faster.period = 0.5e-3;
  gesture.run(faster);
  rows.push_back(comparison(coarse, faster, gesture.id, "1 kHz and 2 kHz" + of_coarse));
  Report turned(gesture.id, sizes.front());
  turned.turn = rotation_from_vector(Vec3(0.7, 0.3, -0.5));
  gesture.run(turned);
  rows.push_back(
      comparison(coarse, turned, gesture.id, "grid and hand as they are, and turned by 52 degrees" + of_coarse));
  return rows;
}

}  // namespace hapticut::gestures
