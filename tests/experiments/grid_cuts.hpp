// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/checks.hpp"
#include "experiments/vocabulary.hpp"

/// @file
/// Cuts in every direction of the grid: the worst mean and the worst ripple.
namespace hapticut::experiments {

/// How the tool stands in the grid, and where a point of its path lies between the voxels.
struct Way {
  Mat3 R_VT;
  Vec3 p_V;
};
/// Seven of them.
[[nodiscard]] std::vector<Way> ways(double voxel);

/// A block whose edges are along the tool's axes, on a grid whose axes need not be.
[[nodiscard]] Workpiece oriented_block(const Way& way, const Box& box_T, double voxel, const Material& material);

/// What is the same in all cuts, unless they say otherwise.
inline constexpr forms::SteadyCut kSlowCut = {3e8, 0.5, 2000, 2 * units::mm, 0};

/// The same with chips: the lengths of their edges and of their size effect, over the chip.
[[nodiscard]] forms::SteadyCut slow_cut_with_chips(double edge, double size);

/// One cut, in the tool's axes: fed from `start` quickly to `begin`, then at the speed of the cut to `end`; the last
/// part of that way is measured.
struct GridCut {
  std::string id, what;
  ToolHead head;
  Box box;
  Vec3 start, begin, end;
  double measured;  ///< [1] of the way
  Wrench expected;
  forms::SteadyCut cut = kSlowCut;
  double tick = kTick;  ///< [s]

  /// [1] Layer over the radius kR: what is pressed in by the pressure at the radius, u v_f/(kappa omega R).
  [[nodiscard]] double layer(double stiffness) const;

  static constexpr Cutter kCutter = {CutterKind::carbide_bur, 2};

  [[nodiscard]] Material material() const;
  /// At the start of the cut's own way, with the quick one behind it.
  [[nodiscard]] Simulation at_begin(const Way& way, Workpiece block, double stiffness) const;
};

/// Fed sideways at a height of the head's origin.
[[nodiscard]] GridCut milled(const char* id, const char* what, const ToolHead& head, const Box& box, double height,
                             const Wrench& expected);

/// Mean force over the measured way, and its standard deviation about a straight line.
struct Course {
  Vec3 mean = Vec3::Zero(), ripple = Vec3::Zero();
  double torque_z = 0, closure = 0;
};
[[nodiscard]] Course follow(Simulation& simulation, const GridCut& cut, const Way& way);

/// How far the worst of a case may be off.
struct Limits {
  double mean, torque, ripple;  ///< [1] on stiff foundations
  double soft = 0;              ///< [1] mean and torque on soft ones, with 0.1 mm: so much more, times layer/R
  double stiff_from = 1e16;     ///< [N/m^4] with 0.1 mm
};

/// On voxels of a size, or of 0.1 and 0.05 mm, and on stiff foundations: 1e16 N/m^4, the default and 1e17. With 0.1 mm
/// on soft ones too, 1e14 and 1e15, where the layer that a cut presses in, 0.11 R and 0.035 R in `kSlowCut`, is not
/// thin, as the forms have it: there the error goes with the layer, whatever the voxel.
[[nodiscard]] std::vector<Check> in_every_direction(const GridCut& cut, const Limits& limits, double voxel);
[[nodiscard]] std::vector<Check> in_every_direction(const GridCut& cut, const Limits& coarse, const Limits& fine);

/// Turned about the tool's axis by 0, 29 and 45 degrees, on voxels of 0.1 mm whose faces are those of the plate.
[[nodiscard]] std::vector<Check> along_the_faces(const GridCut& cut, const Limits& limits,
                                                 const std::vector<double>& foundations);

/// Tilted by 10 and 45 degrees and along <111>, on voxels of 0.1 mm.
[[nodiscard]] std::vector<Check> tilted(const GridCut& cut, const Limits& limits,
                                        const std::vector<double>& foundations);

inline const Box kPlate = {Vec3(-0.4, -1.4, -1) * units::mm, Vec3(2.6, 1.4, 0) * units::mm};
inline const Box kBlock = {Vec3(-1.4, -1.4, -1.3) * units::mm, Vec3(1.4, 1.4, 0) * units::mm};

}  // namespace hapticut::experiments
