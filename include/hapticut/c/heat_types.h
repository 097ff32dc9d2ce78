/* SPDX-License-Identifier: Apache-2.0 */
/** @file
 * Types of the heat and of the loose pieces in hapticut/c/hapticut.h, which has the rules. Include that header.
 */
#ifndef HAPTICUT_C_HEAT_TYPES_H
#define HAPTICUT_C_HEAT_TYPES_H

#include "hapticut/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef hapticut_handle hapticut_heat;    /**< the temperatures of a simulation's workpiece */
typedef hapticut_handle hapticut_islands; /**< the removal of the pieces that are cut loose from a workpiece */

/* --- heat --------------------------------------------------------------------------------------------------------- */

/** How heat spreads in a workpiece: HeatConfig. A field that is 0 has its default, or its value in the scene; for 0
 * itself write 1e-9. */
typedef struct hapticut_heat_config {
  uint32_t struct_size;
  uint32_t voxels_per_cell; /**< voxels along an edge of a cell: 1, 2, 4 or 8; 0: 4 */
  double cutting_share;     /**< [1] part of the work of a cut that heats the wall; 0: that of the cutter */
  double rubbing_share;     /**< [1] part of the energy of steps that only rub that stays in the workpiece; 0: 0.2 */
  double body_temperature;  /**< [deg C] temperature of the workpiece at the beginning; 0: 37 */
  double irrigation;        /**< [W/(m^2 K)] heat transfer to the water, some thousands under a spray; 0: none */
  double water_temperature; /**< [deg C] temperature of the irrigation; 0: 23 */
  double threshold;         /**< [deg C] temperature above which time is counted; 0: 47 */
} hapticut_heat_config;

/** How a material stores and conducts heat. */
typedef struct hapticut_thermal_properties {
  double conductivity;  /**< [W/(m K)] 0: that of the material's name */
  double heat_capacity; /**< [J/(m^3 K)] of a volume; 0: that of the material's name */
} hapticut_thermal_properties;

/** Effect of the heat on one material. A temperature is the mean of a cell. */
typedef struct hapticut_heat_structure_info {
  uint32_t struct_size;
  uint32_t material;   /**< its id */
  double temperature;  /**< [deg C] maximum now; body temperature if none of it is left */
  double peak;         /**< [deg C] maximum so far, including removed material */
  double time_above;   /**< [s] time above the threshold, maximum over the remaining cells */
  double cem43;        /**< [min] cumulative equivalent minutes at 43 deg C, maximum over the remaining cells */
  double volume_above; /**< [m^3] remaining material that was ever above the threshold */
} hapticut_heat_structure_info;

/** Heat since the beginning. Heat that was brought in is stored or has left. */
typedef struct hapticut_heat_balance_info {
  uint32_t struct_size;
  uint32_t unused;
  double brought_in; /**< [J] share of cutting and rubbing that heats the workpiece */
  double stored;     /**< [J] heat above body temperature, now; negative where water has cooled the workpiece */
  double chips;      /**< [J] left with removed material, or brought in where no material is left */
  double irrigation; /**< [J] removed by the water */
  double imbalance;  /**< [J] brought_in - (stored + chips + irrigation): 0 up to rounding */
} hapticut_heat_balance_info;

/** The cells of the temperatures. They never change. */
typedef struct hapticut_heat_grid_info {
  uint32_t struct_size;
  uint32_t dims[3];   /**< number of cells along the axes of the voxel grid */
  double cell_size;   /**< [m] */
  hapticut_pose X_WC; /**< pose of the first cell's centre, with those axes: p_W = X_WC (cell_size (i, j, k)) */
} hapticut_heat_grid_info;

enum hapticut_heat_quantity {
  HAPTICUT_HEAT_TEMPERATURE = 0, /**< [deg C] now */
  HAPTICUT_HEAT_PEAK = 1,        /**< [deg C] maximum so far */
  HAPTICUT_HEAT_DOSE = 2         /**< [min] CEM43 */
};

/* --- loose pieces ------------------------------------------------------------------------------------------------- */

/** What is a loose piece, and how it is removed: IslandWatchOptions. */
typedef struct hapticut_islands_options {
  uint32_t struct_size;
  uint32_t has_fixed; /**< 1: the pieces that reach into the box `fixed_min` ... `fixed_max` stay; 0: the largest one */
  double fixed_min[3];      /**< [m] in W */
  double fixed_max[3];      /**< [m] in W */
  double min_fill;          /**< [1] voxels with less fill join nothing; 0: 0.05 */
  double period;            /**< [s] time between two searches; 0: 0.01 */
  uint64_t blocks_per_tick; /**< [blocks] of a piece that a step checks or removes at most, 1 us each; 0: 16 */
} hapticut_islands_options;

/** A piece that was removed. */
typedef struct hapticut_island_info {
  uint32_t struct_size;
  uint32_t unused;
  uint64_t voxels;    /**< number of its voxels */
  double center_W[3]; /**< [m] mean of their centres, in W */
} hapticut_island_info;

#ifdef __cplusplus
}
#endif
#endif
