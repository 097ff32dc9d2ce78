// SPDX-License-Identifier: Apache-2.0
#include "hapticut/build/volume_builders.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <utility>

#include "build/boxes.hpp"
#include "build/volume_fields.hpp"
#include "build/voxel_amounts.hpp"
#include "core/interruption.hpp"
#include "hapticut/build/volume_operations.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/block_grid.hpp"

namespace hapticut {
namespace {

/// Position of the voxels of the workpiece among the samples of the volume.
struct Layout {
  GridFrame frame;
  IndexBox samples;  // samples in use
  IndexBox voxels;   // voxels that may be solid
  Vec3 first;        // [samples] position of the centre of voxel (0,0,0)
  Vec3 step;         // [samples] size of a voxel
  bool one_to_one;   // voxel (i, j, k) is sample (i, j, k)
};

/// Voxels of the smallest grid-aligned box around a box of W.
IndexBox voxels_around(const Box& box, const GridFrame& frame) {
  if (!is_finite(box.min) || !is_finite(box.max) || !((box.max - box.min).minCoeff() > 0))
    throw Error("VolumeBuildOptions::crop"_name + " must be finite and have max > min along every axis.");
  const Pose X_VW = frame.X_WV.inverse();
  const Eigen::AlignedBox3d around =
      box_of_moved(box, [&](const Vec3& corner) { return Vec3(X_VW * corner / frame.voxel_size); });
  const Vec3 &low = around.min(), &high = around.max();
  IndexBox voxels;
  for (int axis = 0; axis < 3; ++axis) {
    // The voxel reaches half an edge to each side; a face on a boundary does not touch the next voxel.
    constexpr double kFar = 1e9;
    voxels.min[axis] = int(std::clamp(std::floor(low[axis] + 0.5 + 1e-6), -kFar, kFar));
    voxels.max[axis] = int(std::clamp(std::ceil(high[axis] + 0.5 - 1e-6), -kFar, kFar)) - 1;
  }
  return voxels;
}

template <class Value>
Layout layout_of(const Volume<Value>& volume, const VolumeBuildOptions& options) {
  require_valid(volume);
  require_not_negative(options.voxel_size, "VolumeBuildOptions::voxel_size [m]");
  require_between(options.subsamples, 1, kMaxSubsamples, "VolumeBuildOptions::subsamples");
  const double size = options.voxel_size > 0 ? options.voxel_size : volume.spacing.minCoeff();
  if (options.voxel_size <= 0 && size > kMaxVoxelSize)
    throw Error("its samples are " + format_number(size / units::mm) + " mm apart; voxels have at most " +
                format_number(kMaxVoxelSize / units::mm) +
                " mm. Its unit may be wrong: spacings are in metres; for a file set " +
                "VolumeReadOptions::spacing"_name + ".");
  require_metres(size, kMaxVoxelSize, "voxel size [m]");

  Layout layout;
  layout.step = size * volume.spacing.cwiseInverse();
  layout.one_to_one = ((layout.step.array() - 1).abs() < 1e-6).all();
  if (layout.one_to_one) layout.step.setOnes();
  layout.first = (layout.step.array() - 1) / 2;
  const Vec3 p_GV = layout.first.cwiseProduct(volume.spacing);
  layout.frame = {size, volume.X_WG * Pose::from_translation(p_GV)};

  const IndexBox all = samples_of(volume);
  layout.samples = options.crop_samples ? overlap(all, *options.crop_samples) : all;
  if (layout.samples.empty())
    throw Error("VolumeBuildOptions::crop_samples"_name + " has no sample of the volume, which has " +
                std::to_string(volume.dims[0]) + " x " + std::to_string(volume.dims[1]) + " x " +
                std::to_string(volume.dims[2]) + ".");
  for (int axis = 0; axis < 3; ++axis) {
    // From the lower face of the first sample to the upper face of the last; rounding noise is no voxel.
    const double low = layout.samples.min[axis] / layout.step[axis];
    const double high = (layout.samples.max[axis] + 1.0) / layout.step[axis];
    if (!(high < 1 << 30))
      throw Error("the workpiece would be " + format_number(high) + " voxels long; choose a larger voxel size.");
    layout.voxels.min[axis] = int(std::floor(low + 1e-6));
    layout.voxels.max[axis] = int(std::ceil(high - 1e-6)) - 1;
  }
  if (options.crop) {
    layout.voxels = overlap(layout.voxels, voxels_around(*options.crop, layout.frame));
    if (layout.voxels.empty())
      throw Error("VolumeBuildOptions::crop"_name + " does not meet the volume; check its units and pose.");
  }
  return layout;
}

/// [samples] The box of the voxels, lower and upper corner; sample n reaches from n - 1/2 to n + 1/2.
std::array<Vec3, 2> box_of_voxels(const Layout& layout) {
  const auto corner = [&](const VoxelIndex& voxel, double side) {
    return Vec3(layout.first + (Vec3(voxel[0], voxel[1], voxel[2]).array() + side).matrix().cwiseProduct(layout.step));
  };
  return {corner(layout.voxels.min, -0.5), corner(layout.voxels.max, 0.5)};
}

/// Estimates the work, calls the observer, and checks the limits. The number of voxels that a surface cuts is not known
/// yet; a tenth of all voxels is assumed.
void announce(const Layout& layout, const VolumeBuildOptions& options) {
  constexpr double kCutFraction = 0.1, kSecondsPerVoxel = 5e-8, kSecondsPerCutVoxel = 2e-6;
  constexpr double kBytesPerVoxel = 1.3, kBytesPerCutVoxel = 12;
  WorkEstimate estimate;
  estimate.voxels = 1;
  for (int axis = 0; axis < 3; ++axis) estimate.voxels *= layout.voxels.max[axis] - layout.voxels.min[axis] + 1.0;
  estimate.cut_voxels = options.antialias ? kCutFraction * estimate.voxels : 0;
  estimate.memory_bytes = kBytesPerVoxel * estimate.voxels + kBytesPerCutVoxel * estimate.cut_voxels;
  estimate.seconds = kSecondsPerVoxel * estimate.voxels + kSecondsPerCutVoxel * estimate.cut_voxels;
  if (options.observer) options.observer(estimate);
  require_allowed(estimate, options.large);
}

/// Calls `visit(row, count)` for every row of the samples in use, from several threads.
template <class Value, class Visit>
void for_each_row(const Volume<Value>& volume, const IndexBox& samples, const Visit& visit) {
  const auto rows = tbb::blocked_range<int>(samples.min[2], samples.max[2] + 1);
  tbb::parallel_for(rows, [&](const tbb::blocked_range<int>& slices) {
    for (int k = slices.begin(); k != slices.end(); ++k) {
      look_for_interruption();
      for (int j = samples.min[1]; j <= samples.max[1]; ++j)
        visit(&volume.at(samples.min[0], j, k), samples.max[0] - samples.min[0] + 1);
    }
  });
}

template <class Field>
Workpiece build(const Volume<typename Field::Sample>& volume, const Field& field, const Layout& layout,
                const MaterialTable& materials, const VolumeBuildOptions& options) {
  // Points must not be further apart than samples, or they would miss some samples.
  const int dense_enough = int(std::min(std::ceil(layout.step.maxCoeff() - 1e-6), double(kMaxSubsamples)));
  const int subsamples = options.antialias ? std::max(options.subsamples, dense_enough) : 1;
  announce(layout, options);
  const VolumeFiller<Field> fill(volume, field, layout.samples, layout.first, layout.step, subsamples,
                                 options.antialias ? dense_enough : 1, options.antialias);
  return Workpiece::from_blocks(layout.voxels, layout.frame, materials, std::cref(fill));
}

/// Copies labels, sample by sample.
BlockKind copy_labels(const LabelVolume& volume, const LabelField& field, const IndexBox& samples,
                      const VoxelIndex& origin, BlockContent& content) {
  content.material.fill(kEmpty);
  content.fill.fill(0);
  content.centroid.fill({});
  const auto& [low, high] = overlap(voxels_of_block(origin), samples);
  for (int k = low[2]; k <= high[2]; ++k)
    for (int j = low[1]; j <= high[1]; ++j)
      for (int i = low[0]; i <= high[0]; ++i) {
        const int n = block_offset(i - origin[0], j - origin[1], k - origin[2]);
        content.material[n] = field.material_of(volume.at(i, j, k));
        content.fill[n] = content.material[n] != kEmpty ? 1.0F : 0.0F;
      }
  return BlockKind::mixed();
}

/// Marks the labels of the samples in use.  @return [65536]
std::vector<bool> labels_in(const LabelVolume& volume, const IndexBox& samples) {
  std::vector<std::atomic<bool>> seen(65536);
  for_each_row(volume, samples, [&](const std::uint16_t* row, int count) {
    for (int i = 0; i < count; ++i) {
      if (i > 0 && row[i] == row[i - 1]) continue;
      if (!seen[row[i]].load(std::memory_order_relaxed)) seen[row[i]].store(true, std::memory_order_relaxed);
    }
  });
  return {seen.begin(), seen.end()};
}

void require_all_claimed(const std::vector<bool>& present, const std::vector<bool>& claimed) {
  std::string unclaimed;
  int count = 0;
  for (std::size_t label = 1; label < present.size(); ++label)
    if (present[label] && !claimed[label] && ++count <= 10)
      unclaimed += (unclaimed.empty() ? "" : ", ") + std::to_string(label);
  if (count > 10) unclaimed += " and " + std::to_string(count - 10) + " more";
  if (count > 0)
    throw Error("the volume has labels that no material claims: " + unclaimed +
                ". Give each a material, or leave them out with " + "UnclaimedLabels::leave_out"_name + ".");
}

void require_finite_values(const GreyVolume& volume, const IndexBox& samples) {
  std::atomic<bool> finite = true;
  for_each_row(volume, samples, [&](const float* row, int count) {
    float sum = 0;  // x * 0 is 0 for every finite x and not a number otherwise
    for (int i = 0; i < count; ++i) sum += row[i] * 0.0F;
    if (!(sum == 0)) finite.store(false, std::memory_order_relaxed);
  });
  if (!finite)
    throw Error("the volume has grey values that are not finite in single precision; replace them or crop them away.");
}

std::optional<Vec3> spacing_at_borders(const GreyVolume& volume, const VolumeBuildOptions& options) {
  return options.partial_volume ? std::optional(volume.spacing) : std::nullopt;
}

void warn_of_empty_ranges(const Workpiece& workpiece, const GreyVolume& volume, const std::vector<GreyRange>& ranges,
                          const std::function<void(const std::string&)>& warn) {
  for (const MaterialAmount& amount : workpiece.amounts()) {
    if (amount.volume > 0) continue;
    const GreyRange& range = ranges[amount.material - 1U];
    const auto [lowest, highest] = grey_range(volume);
    warn("no voxel is '" + range.material.name + "', grey values " + format_number(range.from, range.to) + " ... " +
         format_number(range.to, range.from) + "; those of the volume are " + format_number(lowest) + " ... " +
         format_number(highest) +
         ". Correct the range, choose smaller voxels, or set partial_volume to false if the range is only the rise to "
         "another material.");
  }
}

double between(double low, double high, double t) { return low + t * (high - low); }

}  // namespace

Workpiece build_from_labels(const LabelVolume& volume, const std::vector<LabelMaterial>& materials,
                            const VolumeBuildOptions& options, UnclaimedLabels unclaimed) {
  const Layout layout = layout_of(volume, options);
  MaterialTable table;
  std::vector<MaterialId> material_of(65536, kEmpty);
  std::vector<bool> claimed(65536, false);
  for (const LabelMaterial& entry : materials) {
    const MaterialId id = table.add(entry.material);
    for (const std::uint16_t label : entry.labels) {
      if (claimed[label])
        throw Error("label " + std::to_string(label) + " is claimed twice, the second time by material '" +
                    entry.material.name + "'; a label can be one material only.");
      claimed[label] = true;
      material_of[label] = id;
    }
  }
  const std::vector<bool> present = labels_in(volume, layout.samples);
  if (unclaimed == UnclaimedLabels::refuse) require_all_claimed(present, claimed);
  for (const LabelMaterial& entry : materials)
    if (options.warn && std::ranges::none_of(entry.labels, [&](std::uint16_t label) { return present[label]; }))
      options.warn("no sample in use has a label of '" + entry.material.name + "'.");
  const LabelField field(material_of);
  if (!layout.one_to_one) {
    Workpiece workpiece = build(volume, field, layout, table, options);
    compare_with_labels(workpiece, volume, material_of, layout.samples, box_of_voxels(layout), options.warn);
    return workpiece;
  }
  return Workpiece::from_blocks(layout.voxels, layout.frame, std::move(table),
                                [&](const VoxelIndex& origin, BlockContent& content) {
                                  return copy_labels(volume, field, layout.samples, origin, content);
                                });
}

Workpiece build_from_grey(const GreyVolume& volume, const std::vector<GreyRange>& ranges,
                          const VolumeBuildOptions& options) {
  const Layout layout = layout_of(volume, options);
  MaterialTable table;
  std::vector<GreyField::Bounds> bounds;
  for (const GreyRange& range : ranges) {
    if (!(range.from < range.to))
      throw Error("the grey range of '" + range.material.name + "' is " + format_number(range.from, range.to) +
                  " ... " + format_number(range.to, range.from) + "; `from` must be less than `to`.");
    bounds.push_back({float(range.from), float(range.to), table.add(range.material)});
  }
  std::sort(bounds.begin(), bounds.end(), [](const auto& a, const auto& b) { return a.from < b.from; });
  for (std::size_t n = 1; n < bounds.size(); ++n)
    if (bounds[n].from < bounds[n - 1].to)
      throw Error("the grey ranges of '" + table[bounds[n - 1].material].name + "' and '" +
                  table[bounds[n].material].name + "' overlap; a grey value can be one material only.");
  require_finite_values(volume, layout.samples);
  Workpiece workpiece =
      build(volume, GreyField(bounds, false, spacing_at_borders(volume, options)), layout, table, options);
  if (options.warn) warn_of_empty_ranges(workpiece, volume, ranges, options.warn);
  return workpiece;
}

std::vector<Material> materials_of(const Grade& grade) {
  if (!std::isfinite(grade.low) || !std::isfinite(grade.high) || !(grade.low < grade.high))
    throw Error("the grade goes from grey value " + format_number(grade.low, grade.high) + " to " +
                format_number(grade.high, grade.low) + "; both must be finite and `low` less than `high`.");
  require_between(grade.steps, 1, 200, "Grade::steps");
  validate(grade.at_low);
  validate(grade.at_high);
  std::vector<Material> materials;
  const Material &a = grade.at_low, &b = grade.at_high;
  if (a.cutter && b.cutter && a.cutter != b.cutter)
    throw Error("the grade goes from '" + a.name + "', whose constants are for the cutter " +
                std::string(name_or_null(*a.cutter)) + ", to '" + b.name + "', which is for " +
                std::string(name_or_null(*b.cutter)) + ". Use the same cutter for both: find_preset(name, cutter).");
  for (int n = 0; n < grade.steps; ++n) {
    const double t = (n + 0.5) / grade.steps;
    Material m;
    m.name = a.name + " " + std::to_string(n + 1) + "/" + std::to_string(grade.steps);
    for_each_number<Material>(
        [&](const auto& field) { m.*field.member = between(a.*field.member, b.*field.member, t); });
    // The energy of a lip is proportional to u h_e and u sqrt(h_s). If both factors were linear, the middle would be
    // the hardest piece.
    const double u = m.specific_cutting_energy, edge = between(a.specific_cutting_energy * a.edge_length,
                                                               b.specific_cutting_energy * b.edge_length, t);
    m.edge_length = edge / u;
    const double size = between(a.specific_cutting_energy * std::sqrt(a.size_length),
                                b.specific_cutting_energy * std::sqrt(b.size_length), t);
    m.size_length = std::pow(size / u, 2);
    m.cutter = a.cutter ? a.cutter : b.cutter;
    materials.push_back(std::move(m));
  }
  return materials;
}

Workpiece build_from_grey(const GreyVolume& volume, const Grade& grade, const VolumeBuildOptions& options) {
  const Layout layout = layout_of(volume, options);
  MaterialTable table(materials_of(grade));
  std::vector<GreyField::Bounds> bounds;
  const auto bound = [&](int n) { return float(between(grade.low, grade.high, double(n) / grade.steps)); };
  bounds.reserve(std::size_t(grade.steps));
  for (int n = 0; n < grade.steps; ++n) bounds.push_back({bound(n), bound(n + 1), MaterialId(n + 1)});
  bounds.back().to = std::numeric_limits<float>::infinity();
  require_finite_values(volume, layout.samples);
  return build(volume, GreyField(bounds, true, spacing_at_borders(volume, options)), layout, table, options);
}

}  // namespace hapticut
