// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/checks.hpp"
#include "experiments/vocabulary.hpp"

/// @file
/// Cuts in every direction of the grid: the worst error of the mean and the worst ripple.
namespace hapticut::experiments {

/// Orientation of the tool in the grid, and the place of its path between the voxels.
struct Way {
  Mat3 R_VT;
  Vec3 p_V;
};
/// Seven directions.
[[nodiscard]] std::vector<Way> ways(double voxel);

/// A block whose edges are along the tool's axes, on a rotated grid.
[[nodiscard]] Workpiece oriented_block(const Way& way, const Box& box_T, double voxel, const Material& material);

/// The default of all cuts.
inline constexpr forms::SteadyCut kSlowCut = {3e8, 0.5, 2000, 2 * units::mm, 0};

/// `kSlowCut` with chips. @param edge, size  [1] h_e and h_s over the chip
[[nodiscard]] forms::SteadyCut slow_cut_with_chips(double edge, double size);

/// One cut, in the tool's axes: quickly from `start` to `begin`, then at the speed of the cut to `end`. The last part
/// of this path is measured.
struct GridCut {
  std::string id, what;
  ToolHead head;
  Box box;
  Vec3 start, begin, end;
  double measured;  ///< [1] part of the path that is measured
  Wrench expected;
  forms::SteadyCut cut = kSlowCut;
  double tick = kTick;  ///< [s]

  /// [1] Layer over the radius kR, at the pressure at the radius, u v_f/(kappa omega R).
  [[nodiscard]] double layer(double stiffness) const;

  static constexpr Cutter kCutter = {CutterKind::carbide_bur, 2};

  [[nodiscard]] Material material() const;
  /// A simulation at `begin`, after the quick part.
  [[nodiscard]] Simulation at_begin(const Way& way, Workpiece block, double stiffness) const;
};

/// A cut fed sideways at a height of the head's origin.
[[nodiscard]] GridCut milled(const char* id, const char* what, const ToolHead& head, const Box& box, double height,
                             const Wrench& expected);

/// Mean force over the measured path, and its standard deviation about a straight line.
struct Course {
  Vec3 mean = Vec3::Zero(), ripple = Vec3::Zero();
  double torque_z = 0, closure = 0;
};
[[nodiscard]] Course follow(Simulation& simulation, const GridCut& cut, const Way& way);

/// Allowed errors of a case.
struct Limits {
  double mean, torque, ripple;  ///< [1] on stiff foundations
  double soft = 0;              ///< [1] additional error of mean and torque on soft foundations, over layer/R
  double stiff_from = 1e16;     ///< [N/m^4] with 0.1 mm
};

/// Runs a cut in all directions with voxels of one size, or of 0.1 and 0.05 mm, on stiff foundations: 1e16 N/m^4, the
/// default and 1e17. Voxels of 0.1 mm also run on soft foundations, 1e14 and 1e15. Their layer, 0.11 R and 0.035 R in
/// `kSlowCut`, is not thin, so the error follows the layer, whatever the voxel size.
[[nodiscard]] std::vector<Check> in_every_direction(const GridCut& cut, const Limits& limits, double voxel);
[[nodiscard]] std::vector<Check> in_every_direction(const GridCut& cut, const Limits& coarse, const Limits& fine);

/// Runs a cut rotated about the tool's axis by 0, 29 and 45 degrees, in a plate whose faces are faces of voxels of 0.1
/// mm.
[[nodiscard]] std::vector<Check> along_the_faces(const GridCut& cut, const Limits& limits,
                                                 const std::vector<double>& foundations);

/// Runs a cut tilted by 10 and 45 degrees and along <111>, with voxels of 0.1 mm.
[[nodiscard]] std::vector<Check> tilted(const GridCut& cut, const Limits& limits,
                                        const std::vector<double>& foundations);

inline const Box kPlate = {Vec3(-0.4, -1.4, -1) * units::mm, Vec3(2.6, 1.4, 0) * units::mm};
inline const Box kBlock = {Vec3(-1.4, -1.4, -1.3) * units::mm, Vec3(1.4, 1.4, 0) * units::mm};

}  // namespace hapticut::experiments
