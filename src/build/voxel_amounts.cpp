// SPDX-License-Identifier: Apache-2.0
#include "build/voxel_amounts.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut {
namespace {

using Amounts = ByMaterial<double>;

/// [samples] Share of each sample of an axis between two places.
std::vector<double> shares_between(double low, double high, int count) {
  std::vector<double> shares(std::size_t(count), 0.0);
  for (int n = 0; n < count; ++n)
    shares[std::size_t(n)] = std::clamp(std::min(high, n + 0.5) - std::max(low, n - 0.5), 0.0, 1.0);
  return shares;
}

/// [samples] Amount of each material within the box of the voxels.
Amounts amounts_of_labels(const LabelVolume& volume, const std::vector<MaterialId>& material_of,
                          const IndexBox& samples, const std::array<Vec3, 2>& voxels) {
  std::array<std::vector<double>, 3> shares;
  for (std::size_t axis = 0; axis < 3; ++axis)
    shares[axis] = shares_between(voxels[0][int(axis)], voxels[1][int(axis)], volume.dims[axis]);
  const auto rows = tbb::blocked_range<int>(samples.min[2], samples.max[2] + 1);
  const auto add_slices = [&](const tbb::blocked_range<int>& slices, Amounts amounts) {
    for (int k = slices.begin(); k != slices.end(); ++k)
      for (int j = samples.min[1]; j <= samples.max[1]; ++j) {
        const double share = shares[2][std::size_t(k)] * shares[1][std::size_t(j)];
        const std::uint16_t* row = &volume.at(0, j, k);
        for (int i = samples.min[0]; i <= samples.max[0]; ++i)
          amounts[material_of[row[i]]] += share * shares[0][std::size_t(i)];
      }
    return amounts;
  };
  const auto sum = [](Amounts a, const Amounts& b) {
    for (std::size_t n = 0; n < a.size(); ++n) a[n] += b[n];
    return a;
  };
  return tbb::parallel_deterministic_reduce(rows, Amounts{}, add_slices, sum);
}

std::string cubic_mm(double volume) { return format_number(std::round(volume / units::mm3 * 1e4) / 1e4) + " mm^3"; }

}  // namespace

std::string differences_of(const Workpiece& workpiece, const ByMaterial<double>& wanted, const std::string& of) {
  constexpr double kDifference = 0.05;  // [1] rounded corners of a body of a few samples stay below
  std::string list;
  for (const MaterialAmount& amount : workpiece.amounts()) {
    const double volume = wanted[amount.material];
    if (std::abs(amount.volume - volume) <= kDifference * volume) continue;
    list += std::string(list.empty() ? "'" : ", '") + workpiece.materials()[amount.material].name + "' fills " +
            cubic_mm(amount.volume) + ", its " + of + " " + cubic_mm(volume);
  }
  if (list.empty()) return "";
  return "voxels of " + format_number(workpiece.voxel_size() / units::mm) + " mm are too coarse for the " + of + ": " +
         list + ". ";
}

void compare_with_labels(const Workpiece& workpiece, const LabelVolume& volume,
                         const std::vector<MaterialId>& material_of, const IndexBox& samples,
                         const std::array<Vec3, 2>& voxels, const std::function<void(const std::string&)>& warn) {
  Amounts labels = amounts_of_labels(volume, material_of, samples, voxels);
  for (double& amount : labels) amount *= volume.spacing.prod();
  const std::string differences = differences_of(workpiece, labels, "labels");
  if (differences.empty()) return;
  const double smallest = volume.spacing.minCoeff();
  const bool cubes = volume.spacing.maxCoeff() <= smallest * (1 + 1e-6);
  const std::string sentence =
      differences + (cubes
                         ? "Choose voxels of " + format_number(smallest / units::mm) + " mm, the spacing of the labels"
                         : "Resample the labels to cubes first, and choose voxels of that size");
  if (!warn)
    throw Error(sentence + Sentence::clause(", or set " + "VolumeBuildOptions::warn"_name + " to go on") + ".");
  warn(sentence + ".");
}

}  // namespace hapticut
