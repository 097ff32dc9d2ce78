// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hapticut/core/description.hpp"
#include "hapticut/heat/thermal_properties.hpp"
#include "hapticut/workpiece/workpiece.hpp"

namespace hapticut {

class HeatCollector;

/// How heat spreads in a workpiece.
struct HeatConfig {
  int voxels_per_cell = 4;  ///< [1] voxels along an edge of a cell: 1, 2, 4 or 8

  /// [1] part of the work of a cut that heats the wall; none: that of the cutter.
  /// `heat_share_of` has those of cutters. Every rise of temperature is proportional to it. The rest leaves with chips
  /// and tool.
  std::optional<double> cutting_share = {};
  /// [1] part of the energy of rubbing, damping and dry friction, in steps that cut nothing, that stays in the
  /// workpiece
  double rubbing_share = 0.2;

  /// Properties of the materials in the order of their ids, from 1; may be shorter.
  /// The others have those of their name (`thermal_properties_of`).
  std::vector<ThermalProperties> by_material;

  double body_temperature = 37;  ///< [deg C] temperature of the workpiece at the beginning
  /// [W/(m^2 K)] heat transfer to the water, some thousands under a spray; 0: dry, no heat leaves to the air
  double irrigation = 0;
  double water_temperature = 23;  ///< [deg C] temperature of the irrigation

  /// [deg C] temperature above which time is counted.
  /// Bone just survives 47 deg C for a minute (Eriksson and Albrektsson, J Prosthet Dent 50, 1983, 101).
  double threshold = 47;
};

constexpr auto fields_of(Of<HeatConfig>) {
  using C = HeatConfig;
  return std::tuple{
      field("voxels_per_cell", &C::voxels_per_cell, "1", Range::between(1, 8),
            "voxels along an edge of a cell: 1, 2, 4 or 8"),
      field("cutting_share", &C::cutting_share, "1", Range::between(0, 1),
            "part of the work of a cut that heats the wall; none: that of the cutter"),
      field("rubbing_share", &C::rubbing_share, "1", Range::between(0, 1),
            "part of the energy of rubbing, damping and dry friction, in steps that cut nothing, that stays in the "
            "workpiece"),
      field("by_material", &C::by_material,
            "properties of the materials in the order of their ids, from 1; may be shorter"),
      field("body_temperature", &C::body_temperature, "deg C", Range::between(-50, 200),
            "temperature of the workpiece at the beginning"),
      field("irrigation", &C::irrigation, "W/(m^2 K)", Range::not_negative(),
            "heat transfer to the water, some thousands under a spray; 0: dry, no heat leaves to the air"),
      field("water_temperature", &C::water_temperature, "deg C", Range::between(-50, 200),
            "temperature of the irrigation"),
      field("threshold", &C::threshold, "deg C", Range::between(-50, 500), "temperature above which time is counted"),
  };
}

/// Effect of the heat on one material, over the cells that contain any of it. A temperature is the mean of a cell.
struct StructureHeat {
  MaterialId material = kEmpty;  ///< [1] its id
  double temperature = 0;        ///< [deg C] maximum now; body temperature if none of it is left
  double peak = 0;               ///< [deg C] maximum so far, including removed material
  double time_above = 0;         ///< [s] time above the threshold, maximum over the remaining cells
  double cem43 = 0;              ///< [min] cumulative equivalent minutes at 43 deg C, maximum over the remaining cells
  double volume_above = 0;       ///< [m^3] remaining material that was ever above the threshold
};

constexpr auto fields_of(Of<StructureHeat>) {
  using S = StructureHeat;
  return std::tuple{
      field("material", &S::material, "1", "its id"),
      field("temperature", &S::temperature, "deg C", "maximum now; body temperature if none of it is left"),
      field("peak", &S::peak, "deg C", "maximum so far, including removed material"),
      field("time_above", &S::time_above, "s", "time above the threshold, maximum over the remaining cells"),
      field("cem43", &S::cem43, "min", "cumulative equivalent minutes at 43 deg C, maximum over the remaining cells"),
      field("volume_above", &S::volume_above, "m^3", "remaining material that was ever above the threshold"),
  };
}

/// The warmest place so far.
struct WarmestPlace {
  double temperature = 0;    ///< [deg C] maximum so far, of a cell
  Vec3 p_WQ = Vec3::Zero();  ///< [m] centre of the cell; its material may be removed by now
};

constexpr auto fields_of(Of<WarmestPlace>) {
  using W = WarmestPlace;
  return std::tuple{
      field("temperature", &W::temperature, "deg C", "maximum so far, of a cell"),
      field("p_WQ", &W::p_WQ, "m", "centre of the cell; its material may be removed by now"),
  };
}

/// Balance of the heat, in [J] since the beginning. It closes to rounding: heat that was brought in is stored or has
/// left. What a cut gives to chips and tool at once, 1 minus the share, is not in it.
struct HeatBalance {
  double brought_in = 0;  ///< [J] share of cutting and rubbing that heats the workpiece, and heat of `add_heat`
  double stored = 0;      ///< [J] heat above body temperature, now; negative where water has cooled the workpiece
  double chips = 0;       ///< [J] left later with removed material, or brought in where no material is left
  double irrigation = 0;  ///< [J] removed by the water

  /// [J] Error of the balance; 0 when it closes.
  [[nodiscard]] double imbalance() const { return brought_in - (stored + chips + irrigation); }
};

constexpr auto fields_of(Of<HeatBalance>) {
  using B = HeatBalance;
  return std::tuple{
      field("brought_in", &B::brought_in, "J",
            "share of cutting and rubbing that heats the workpiece, and heat of `add_heat`"),
      field("stored", &B::stored, "J",
            "heat above body temperature, now; negative where water has cooled the workpiece"),
      field("chips", &B::chips, "J", "left later with removed material, or brought in where no material is left"),
      field("irrigation", &B::irrigation, "J", "removed by the water"),
  };
}

/// Cumulative equivalent minutes at 43 deg C of a time at one temperature, t R^(43 - T) with R = 0.5 above 43 deg C and
/// 0.25 below (Sapareto and Dewey, Int J Radiat Oncol Biol Phys 10, 1984, 787).
/// @param temperature  [deg C]
/// @param time         [s]
/// @return [min]
[[nodiscard]] double cem43(double temperature, double time);

/// The temperature of a workpiece on a grid of cells some voxels wide, beside the loop: finite volumes,
///
///     d(rho c V T)/dt = sum over faces of G (T_neighbour - T) + sources - U (T - T_water)
///
/// explicit in time, in as many equal sub-steps as keep every cell between its neighbours. Partly filled material
/// stores and conducts in proportion to its fill. To the air, heat leaves only by irrigation. A cut counts the heat of
/// its chips once, in the share that does not stay: what the cut material held goes to colder material around, which
/// gets no warmer than the cut material was; the rest leaves with the chips. Material that is removed otherwise takes
/// its heat along. Not thread-safe: one thread calls it, ten to thirty times a second.
class HeatField {
 public:
  /// The whole workpiece begins at body temperature.
  /// @throws Error when a number of the configuration is out of range, the workpiece is empty, or there would be too
  ///         many cells
  explicit HeatField(const Workpiece& workpiece, HeatConfig config = {});

  /// Receives everything that a collector has: adds its heat where it arose, and updates the changed blocks.
  /// @return [s] total duration of the steps, for `advance`
  double drain(HeatCollector& collector);

  /// Adds heat at a point, distributed over the material of the cells around it, or over the surface within a radius
  /// [m]. If there is no material near it, the heat counts as left with the chips.
  /// @throws Error when a number is not finite, or heat [J] or radius are negative
  void add_heat(const Vec3& p_WQ, double heat, double radius = 0);

  /// Adds heat where material was removed since the last call, in proportion to its volume and specific cutting energy,
  /// to the material that is left in those cells and beside them, with the heat that the removed material held. Where
  /// little is left, the rest leaves with the chips. If no material was removed yet, the heat waits until some is.
  /// @throws Error when the heat [J] is not finite or negative
  void add_cutting_heat(double heat);

  /// Updates a block to its present content. Material that came back has body temperature.
  /// @param material, fill  [512]
  void update(const VoxelIndex& origin, const MaterialId* material, const float* fill);

  /// Updates blocks of a workpiece that a step has changed.
  /// @throws Error when its voxels are not those of the workpiece that the field was made of
  void update(const Workpiece& workpiece, std::span<const VoxelIndex> origins);

  void advance(double dt);  ///< [s] advances the temperatures by any time, in small enough sub-steps

  /// @param coefficient  [W/(m^2 K)] HeatConfig::irrigation from now on
  /// @throws Error when it is out of range
  void set_irrigation(double coefficient);

  [[nodiscard]] const HeatConfig& config() const { return config_; }
  [[nodiscard]] std::vector<StructureHeat> structures() const;  ///< one entry per material of the workpiece
  [[nodiscard]] HeatBalance balance() const;
  /// Nullopt: nothing was warmer than at the beginning.
  [[nodiscard]] std::optional<WarmestPlace> warmest() const;

  /// [deg C] Interpolated between the centres of the cells around; NaN where none of them contains material.
  [[nodiscard]] double temperature_at(const Vec3& p_WQ) const;

  // --- the cells, for display ---------------------------------------------------------------------------------------
  [[nodiscard]] std::array<int, 3> dims() const { return dims_; }
  [[nodiscard]] double cell_size() const { return cell_size_; }            ///< [m]
  [[nodiscard]] Vec3 center(const std::array<int, 3>& cell) const;         ///< [m] position in W
  [[nodiscard]] double temperature(const std::array<int, 3>& cell) const;  ///< [deg C] NaN: no material
  [[nodiscard]] double peak(const std::array<int, 3>& cell) const;         ///< [deg C] maximum so far
  [[nodiscard]] double dose(const std::array<int, 3>& cell) const;         ///< [min] CEM43

 private:
  /// Heat is stored relative to body temperature.
  struct Cells {
    explicit Cells(std::size_t count);
    std::vector<double> heat, capacity, conductivity, filled;  // [J], [J/K], [W/(m K)], [1]
    std::array<std::vector<double>, 3> conductance;            // [W/K] conductance to the next cell along each axis
    std::vector<double> wetted;                                // [m^2] area of the surface
    std::vector<double> cooling;                               // [W/K] conductance to the water
    std::vector<double> rise, peak, above, dose;               // [K], [K], [s], [min]
    std::vector<double> removed, held, held_capacity;          // of removed material: cutting energy, heat [J], [J/K]
  };

  [[nodiscard]] std::size_t number_of(const std::array<int, 3>& cell) const;
  void set_content(std::size_t cell, const std::vector<float>& volumes);
  void refresh_changed();
  void refresh_faces(std::size_t cell);
  void refresh_cooling(std::size_t cell);
  [[nodiscard]] bool add_to_surface(const Vec3& p_WQ, double heat, double radius);
  void spread(std::size_t cell, double heat);
  void give_back(std::size_t cell);
  void step(double dt);
  void count_dose(double dt);
  [[nodiscard]] double max_rate() const;
  struct Around {
    int count = 0;  // 8, or 0 where there are no cells
    std::array<std::size_t, 8> cell;
    std::array<double, 8> weight;  // adding up to 1
  };
  [[nodiscard]] Vec3 in_cells(const Vec3& p_WQ) const;
  [[nodiscard]] Around cells_around(const Vec3& p_WQ) const;
  [[nodiscard]] std::array<int, 3> cell_of(std::size_t number) const;

  HeatConfig config_;
  GridFrame frame_;
  double cell_size_ = 0, cell_volume_ = 0;         // [m], [m^3]
  VoxelIndex first_ = {0, 0, 0};                   // voxel of the first cell
  std::array<int, 3> dims_ = {0, 0, 0};            // without the empty cells around
  std::array<std::size_t, 3> stride_ = {0, 0, 1};  // steps of cell numbers
  std::size_t materials_ = 0;
  std::vector<ThermalProperties> properties_;  // by id from 1
  std::vector<double> cutting_energy_;         // [J/m^3] by id from 1
  Cells cells_;
  std::vector<float> volumes_;        // [1] fraction of each cell's volume by material, cell by cell
  std::vector<std::size_t> changed_;  // cells whose content has changed
  std::vector<std::size_t> removed_;  // cells that lost material since the last `add_cutting_heat`
  std::vector<double> peaks_;         // [K] by id from 1, including removed material
  std::size_t warmest_ = 0;           // cell of the highest temperature so far
  double warmest_rise_ = 0;           // [K] in that cell, then
  double waiting_ = 0;                // [J] heat of cutting, whose place is not known yet
  double rate_ = 0;                   // [1/s] maximum of the cells; 0: not known
  HeatBalance balance_;
};

}  // namespace hapticut
