// SPDX-License-Identifier: Apache-2.0
#include "bench/gestures/gesture_list.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace gestures {
namespace {

int number_of(const std::string& id) { return std::stoi(id.substr(1)); }

/// The largest change of a quantity from one run to another, as a row of invariant 7.
GestureRow comparison(const Report& from, const Report& to, const std::string& scene, const GestureRow& like) {
  GestureRow row = like;
  row.scene = scene;
  row.voxel_size = 0;
  row.demand = "invariant 7";
  row.expected = "each quantity changes by less than its tolerance";
  row.pass = from.quantities().size() == to.quantities().size();
  double worst = 0;
  row.seen = "nothing to compare";
  for (std::size_t n = 0; n < std::min(from.quantities().size(), to.quantities().size()); ++n) {
    const Quantity &a = from.quantities()[n], &b = to.quantities()[n];
    const double size = std::max(std::abs(a.value), std::abs(b.value));
    const double change = size > 0 ? std::abs(a.value - b.value) / size : 0;
    if (!(change <= a.tolerance)) row.pass = false;
    if (!(change / a.tolerance >= worst)) continue;
    worst = change / a.tolerance;
    row.seen = a.what + " of " + a.scene + ": " + shown(a.value, "") + " and " + shown(b.value, a.unit) +
               ", tolerance " + shown(100 * a.tolerance, "%");
  }
  return row;
}

void append(std::vector<GestureRow>& rows, Report& report) {
  std::move(report.rows().begin(), report.rows().end(), std::back_inserter(rows));
}

std::string at_size(double voxel) { return shown(1e3 * voxel, "mm"); }

/// All sizes of voxels; then the coarsest once more with probes between the steps, and at twice the rate.
std::vector<GestureRow> rows_of(const Gesture& gesture, std::vector<double> sizes) {
  if (!gesture.has_voxels) sizes = {0};
  std::vector<GestureRow> rows;
  std::vector<Report> reports;
  for (const double voxel : sizes) {
    gesture.run(reports.emplace_back(gesture.id, gesture.name, voxel));
    append(rows, reports.back());
  }
  const GestureRow like{gesture.id, gesture.name, "", 0, "", "", "", true, 0, ""};

  Report probed(gesture.id, gesture.name, sizes.front());
  probed.probing = true;
  gesture.run(probed);
  GestureRow same = like;
  same.scene = "run again, with probes between the steps";
  same.voxel_size = sizes.front();
  same.demand = "invariant 6";
  same.expected = "the same bits";
  same.pass = probed.bits() == reports.front().bits();
  same.seen = same.pass ? "the same" : "other bits";
  rows.push_back(same);

  if (reports.front().quantities().empty()) return rows;
  for (std::size_t n = 1; n < reports.size(); ++n)
    rows.push_back(comparison(reports[n - 1], reports[n],
                              "voxels of " + at_size(sizes[n - 1]) + " and of " + at_size(sizes[n]), like));
  const std::string coarse = ", voxels of " + at_size(sizes.front());
  Report faster(gesture.id, gesture.name, sizes.front());
  faster.period = 0.5e-3;
  gesture.run(faster);
  rows.push_back(comparison(reports.front(), faster, "1 kHz and 2 kHz" + coarse, like));
  Report turned(gesture.id, gesture.name, sizes.front());
  turned.turn = rotation_from_vector(Vec3(0.7, 0.3, -0.5));
  gesture.run(turned);
  rows.push_back(
      comparison(reports.front(), turned, "grid and hand as they are, and turned by 52 degrees" + coarse, like));
  return rows;
}

}  // namespace

std::vector<Gesture> all_gestures() {
  std::vector<Gesture> all;
  for (const auto& part : {hole_gestures(), press_gestures(), cutting_gestures(), motor_gestures(), device_gestures(),
                           loop_gestures(), further_gestures(), further_loop_gestures(), coupled_gestures()})
    all.insert(all.end(), part.begin(), part.end());
  std::ranges::sort(all, {}, [](const Gesture& gesture) { return number_of(gesture.id); });
  return all;
}

}  // namespace gestures

std::vector<std::string> gesture_ids() {
  std::vector<std::string> ids;
  for (const gestures::Gesture& gesture : gestures::all_gestures()) ids.push_back(gesture.id);
  return ids;
}

std::vector<GestureRow> run_gestures(const GestureOptions& options) {
  if (options.voxel_sizes.empty()) throw Error("GestureOptions::voxel_sizes is empty; give one size at least.");
  for (const double voxel : options.voxel_sizes) require_positive(voxel, "GestureOptions::voxel_sizes [m]");
  std::vector<GestureRow> rows;
  std::size_t done = 0;
  bool found = false;
  for (const gestures::Gesture& gesture : gestures::all_gestures()) {
    ++done;
    if (!options.only.empty() && gesture.id != options.only) continue;
    found = true;
    std::vector<GestureRow> of_one = gestures::rows_of(gesture, options.voxel_sizes);
    std::move(of_one.begin(), of_one.end(), std::back_inserter(rows));
    if (options.progress) options.progress(done);
  }
  if (!found) {
    std::string known;
    for (const std::string& id : gesture_ids()) known += (known.empty() ? "" : ", ") + id;
    throw Error("there is no gesture '" + options.only + "'; there are " + known + ".");
  }
  for (GestureRow& row : rows)
    for (const KnownGestureFailure& failure : known_gesture_failures())
      if (!row.pass && row.gesture == failure.gesture && row.demand == failure.demand) row.known = failure.reason;
  return rows;
}

}  // namespace hapticut
