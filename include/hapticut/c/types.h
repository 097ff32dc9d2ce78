/* SPDX-License-Identifier: Apache-2.0 */
/** @file
 * Types of the functions of hapticut/c/hapticut.h, which has the rules. Include that header.
 */
#ifndef HAPTICUT_C_TYPES_H
#define HAPTICUT_C_TYPES_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Increases when functions or fields are added. No function or field is ever removed or moved. */
#define HAPTICUT_ABI_VERSION 1

/** [rad/s] One revolution per minute: `40000 * HAPTICUT_RPM` equals `spindle_rpm = 40000` of a scene. */
#define HAPTICUT_RPM 0.10471975511965977

enum hapticut_result {
  HAPTICUT_OK = 0,
  HAPTICUT_NOTHING = 1,            /**< no error, but there was no result */
  HAPTICUT_ERROR_ARGUMENT = -1,    /**< a null pointer, or an invalid number */
  HAPTICUT_ERROR_HANDLE = -2,      /**< a handle that is 0, released, of another kind, or invalid */
  HAPTICUT_ERROR_STRUCT_SIZE = -3, /**< struct_size is not set, or a newer caller sets fields that this library lacks */
  HAPTICUT_ERROR_BUSY = -4,        /**< another thread or a loop uses the object; nothing has changed */
  HAPTICUT_ERROR_REFUSED = -5,     /**< it cannot be done; hapticut_last_error says what is wrong and what to do */
  HAPTICUT_ERROR_FULL = -6,        /**< the queue of commands is full, or there are 4096 handles; try again later */
  HAPTICUT_ERROR_MEMORY = -7,      /**< there is not enough memory */
  HAPTICUT_ERROR_INTERNAL = -8     /**< a bug in the library */
};

/** Identifies an object; 0 is no handle. The other type names say which kind of object. */
typedef uint64_t hapticut_handle;
typedef hapticut_handle hapticut_simulation; /**< a tool and a workpiece, from a scene */
typedef hapticut_handle hapticut_snapshot;   /**< a state of a workpiece that can be restored */
typedef hapticut_handle hapticut_coupling;   /**< spring and damper between a hand and a simulation */
typedef hapticut_handle hapticut_device;
typedef hapticut_handle hapticut_loop;      /**< a device that drives a simulation in a thread of the library */
typedef hapticut_handle hapticut_surface;   /**< the pages of triangles of a simulation's workpiece */
typedef hapticut_handle hapticut_sound;     /**< the sound of a drill */
typedef hapticut_handle hapticut_recording; /**< a file that records the steps of a simulation */

typedef struct hapticut_pose {
  double position[3]; /**< [m] */
  double rotation[9]; /**< [1] row by row; orthonormal, determinant +1 */
} hapticut_pose;

/* --- simulation --------------------------------------------------------------------------------------------------- */

typedef struct hapticut_simulation_options {
  uint32_t struct_size;
  uint32_t
      for_coupling; /**< 1: for use with a coupling, also in a loop; the contact is then evaluated at a step's end */
  uint64_t undo_blocks; /**< [blocks] memory for undo, 2.7 kB each; 0: no undo */
} hapticut_simulation_options;

typedef struct hapticut_scene_info {
  uint32_t struct_size;
  uint32_t materials; /**< ids are 1 ... materials */
  double rate;        /**< [Hz] update rate of the scene */
  double voxel_size;  /**< [m] */
  double box_min[3];  /**< [m] box around the workpiece at its creation, in W */
  double box_max[3];
  hapticut_pose X_WV; /**< pose of the voxel grid */
  hapticut_pose X_HT; /**< pose of the head in the handle frame */
  double head_min[3]; /**< [m] box around the head, in T */
  double head_max[3];
  double spindle_speed; /**< [rad/s] speed setting of the tool */
  double path_duration; /**< [s] duration of the scene's [path]; 0: no path */
  uint32_t flutes;      /**< number of cutting edges of the tool, for its sound */
  uint32_t unused;
} hapticut_scene_info;

typedef struct hapticut_material_info {
  uint32_t struct_size;
  uint32_t unused;
  double removed_volume; /**< [m^3] cut away so far */
  double volume;         /**< [m^3] remaining */
  char name[64];
  double detached_volume; /**< [m^3] removed so far as loose pieces: hapticut_islands_open */
} hapticut_material_info;

typedef struct hapticut_step_input {
  uint32_t struct_size;
  uint32_t unused;
  hapticut_pose X_WH;         /**< pose at the end of the step */
  double linear_velocity[3];  /**< [m/s] velocity of Ho, in W */
  double angular_velocity[3]; /**< [rad/s] angular velocity, in W */
  double dt;                  /**< [s] since the last step */
} hapticut_step_input;

typedef struct hapticut_step_result {
  uint32_t struct_size;
  uint32_t status;         /**< bits of StepStatus; 0: nothing to report. hapticut_status_text returns the names */
  double force[3];         /**< [N] on the tool, in W */
  double torque[3];        /**< [N m] on the tool about Ho, in W */
  double removed_volume;   /**< [m^3] by this step */
  uint64_t removed_voxels; /**< number of voxels that this step has emptied */
  double spindle_speed;    /**< [rad/s] */
  double spindle_torque;   /**< [N m] that the motor delivers */
  double contact_depth;    /**< [m] */
  double contact_volume;   /**< [m^3] */
  uint32_t contact_voxels;
  uint32_t sub_steps;         /**< 0: the input was rejected */
  hapticut_pose X_WH;         /**< pose of the tool: the input, or with a coupling that of the simulated tool */
  double contact_point_W[3];  /**< [m] point for a force arrow, in W; zero without a contact */
  double contact_normal_W[3]; /**< [1] direction of the push on the tool without the drag of the spin, in W; zero
                                 without a contact */
  double contact_area;        /**< [m^2] area of the head's surface in material */
  double contact_pressure;    /**< [Pa] mean over that area */
  uint64_t first_touched[4];  /**< set of the materials that were touched for the first time since the simulation was
                                 made: HAPTICUT_HAS_MATERIAL */
  double load_to_cut;         /**< [N] thrust that the edges of a twist drill carry without a chip; 0: other cutters */
} hapticut_step_result;

typedef struct hapticut_probe_result {
  uint32_t struct_size;
  uint32_t contact_voxels;
  double force[3];      /**< [N] on the tool, in W, without effects and limits */
  double torque[3];     /**< [N m] about Ho, in W */
  double stiffness[36]; /**< [N/m, N/rad; N, N m/rad] row by row; force, torque over translation, rotation of Ho in W */
  double contact_depth; /**< [m] */
} hapticut_probe_result;

/** 1 if a set of materials, four words of 64 bits, has the material with an id, else 0. */
#define HAPTICUT_HAS_MATERIAL(set, id) ((int)(((set)[(id) / 64] >> ((id) % 64)) & 1))

typedef struct hapticut_ray_hit {
  uint32_t struct_size;
  uint32_t material;  /**< id of the material that was met */
  double distance;    /**< [m] from the origin of the ray; 0 if the origin is in the material */
  double point_W[3];  /**< [m] place that the ray met, in W */
  double normal_W[3]; /**< [1] unit vector out of the material, in W; zero deep inside the material */
} hapticut_ray_hit;

typedef struct hapticut_energy_ledger {
  uint32_t struct_size;
  uint32_t unused;
  double hand_work; /**< [J] like all fields below; accumulated, except the stored `elastic` and `anchored` */
  double motor_work;
  double elastic;
  double cutting;
  double crushed;
  double released;
  double damping;
  double rubbing;
  double anchored;
  double sliding;
  double credited;
  double entered;
  double imbalance; /**< hand_work + motor_work + credited - stored - lost: about -entered */
  double turnover;  /**< sum of absolute hand_work, motor_work and entered of all sub-steps: scale for imbalance */
} hapticut_energy_ledger;

/* --- coupling, for a custom loop --------------------------------------------------------------------------------- */

typedef struct hapticut_coupling_gains {
  uint32_t struct_size;
  uint32_t unused;
  double stiffness;         /**< [N/m] that the device renders stably; 0: 700 */
  double damping;           /**< [N s/m] 0: 12 */
  double mass;              /**< [kg] mass of the simulated tool; 0: 0.05 */
  double max_force;         /**< [N] 0: no limit */
  double angular_stiffness; /**< [N m/rad] 0: the tool rotates with the hand */
  double angular_damping;   /**< [N m s/rad] */
  double inertia;           /**< [kg m^2] 0: 2e-5 */
  double max_torque;        /**< [N m] 0: no limit */
} hapticut_coupling_gains;

/* --- device and loop ---------------------------------------------------------------------------------------------- */

typedef struct hapticut_device_info {
  uint32_t struct_size;
  int32_t input_degrees_of_freedom;  /**< 3 or 6 */
  int32_t output_degrees_of_freedom; /**< 0, 3 or 6 */
  uint32_t unused;
  double rate;             /**< [Hz] */
  double peak_force;       /**< [N] this and all fields below are 0 if the driver does not report them */
  double continuous_force; /**< [N] */
  double peak_torque;      /**< [N m] */
  double stiffness;        /**< [N/m] maximum that the maker promises to be stable */
  double damping;          /**< [N s/m] maximum that the maker promises to be stable */
  double workspace_min[3]; /**< [m] box of the device's workspace, in B */
  double workspace_max[3];
  char model[64];
  char serial_number[64];
} hapticut_device_info;

enum hapticut_coupling_choice {
  HAPTICUT_COUPLING_BY_DEVICE = 0, /**< if the device promises a stiffness */
  HAPTICUT_COUPLING_ALWAYS = 1,
  HAPTICUT_COUPLING_NEVER = 2
};

enum hapticut_up { HAPTICUT_UP_Y = 0, HAPTICUT_UP_Z = 1 };

typedef struct hapticut_loop_options {
  uint32_t struct_size;
  uint32_t coupling; /**< hapticut_coupling_choice */
  double seconds;    /**< [s] device time after which the loop ends; 0: it ends when it is stopped */
  double scale;      /**< [1] metres in W per metre of the hand; 0: 1 */
  uint32_t up;       /**< hapticut_up: axis of B that points along z of W. Devices have y, mock and replay z */
  uint32_t has_X_WB; /**< 1: `X_WB` is set; 0: the device's origin puts the tool's tip on the middle of the workpiece's
                        top */
  hapticut_pose X_WB;
  double stiffness;           /**< [N/m] stiffness of the coupling at the device; 0: what the device promises */
  uint32_t simulated_time;    /**< 1: as fast as possible; mock and replay only */
  uint32_t ordinary_priority; /**< 1: ordinary priority; 0: request SCHED_FIFO 80 for the loop's thread */
  uint32_t lock_memory;       /**< 1: lock the process in memory (mlockall): process-wide */
  uint32_t stop_on_signals;   /**< 1: SIGINT, SIGTERM, SIGHUP end the loop first: process-wide handlers */
  uint32_t stop_on_crash;     /**< 1: SIGSEGV and other crashes switch the force off first: process-wide handlers */
  uint32_t unused;
} hapticut_loop_options;

enum hapticut_arming {
  HAPTICUT_ARMING_OFF = 0,
  HAPTICUT_ARMING_ARMED = 1,     /**< waits for valid readings: no force */
  HAPTICUT_ARMING_WAIT_FREE = 2, /**< waits until the tool touches nothing: no force */
  HAPTICUT_ARMING_RAMP = 3,
  HAPTICUT_ARMING_ON = 4,
  HAPTICUT_ARMING_FAULT = 5 /**< no force until hapticut_loop_reset_fault */
};

/** Bits of hapticut_loop_state.flags. */
enum hapticut_loop_flag {
  HAPTICUT_LOOP_READING_VALID = 1,
  HAPTICUT_LOOP_TOUCHING = 2,
  HAPTICUT_LOOP_UNDOING = 4,
  HAPTICUT_LOOP_REDOING = 8,
  HAPTICUT_LOOP_FORCE_HELD = 16
};

typedef struct hapticut_loop_state {
  uint32_t struct_size;
  uint32_t status;          /**< status of the last step */
  uint64_t tick;            /**< number of ticks since the loop began */
  uint32_t arming;          /**< hapticut_arming */
  uint32_t fault;           /**< DeviceFault of the reading; 0: none */
  uint32_t flags;           /**< bits of hapticut_loop_flag */
  uint32_t buttons;         /**< bit n: button n is pressed */
  uint32_t output_changes;  /**< bits of OutputChange: why applied and commanded force differ */
  uint32_t status_seen;     /**< status bits of all steps since the loop began */
  double time;              /**< [s] time of the reading */
  hapticut_pose X_BS;       /**< pose of the stylus */
  hapticut_pose X_WT;       /**< pose of the head, for drawing */
  double force[3];          /**< [N] on the tool, in W */
  double torque[3];         /**< [N m] about Ho, in W */
  double applied_force[3];  /**< [N] rendered by the motors, in B */
  double applied_torque[3]; /**< [N m] rendered by the motors, in B */
  double spindle_speed;     /**< [rad/s] */
  double removed_volume;    /**< [m^3] since the loop began */
  double dissipated;        /**< [J] sum of all losses since the loop began */
  double power;             /**< [W] mean since the last call, for the sound */
  double removal_rate;      /**< [m^3/s] mean since the last call, for the sound */
  double contact_depth;     /**< [m] */
  uint32_t contact_voxels;
  uint32_t undo_marks; /**< number of marks for undo */
  uint32_t redo_marks; /**< number of marks for redo */
  uint32_t unused;
  uint64_t commands_dropped; /**< commands that found the queue full */
  uint64_t commands_refused; /**< commands that did not suit the objects in place */
  double contact_point_W[3]; /**< [m] point for a force arrow, in W; zero without a contact */
  uint64_t touched[4];       /**< set of the materials that were touched since the simulation was made:
                                HAPTICUT_HAS_MATERIAL */
} hapticut_loop_state;

/** A kind is the position of a command in hapticut::LoopCommand, from 1. The commands 11 to 15 (friction, effects,
   tool, materials, workpiece) need more than a number and have no name here. The next new command is 16. */
enum hapticut_command_kind {
  HAPTICUT_COMMAND_SET_SPINDLE_SPEED = 1, /**< value [rad/s], e.g. 40000 * HAPTICUT_RPM */
  HAPTICUT_COMMAND_OPEN_CLUTCH = 2,       /**< the hand moves, the tool stays */
  HAPTICUT_COMMAND_CLOSE_CLUTCH = 3,
  HAPTICUT_COMMAND_SET_SCALE = 4, /**< value [1] > 0, world over hand */
  HAPTICUT_COMMAND_SET_UNDO_MARK = 5,
  HAPTICUT_COMMAND_UNDO = 6,
  HAPTICUT_COMMAND_REDO = 7,
  HAPTICUT_COMMAND_HOLD_FORCE = 8,     /**< value 1: hold the last force; 0: end the hold */
  HAPTICUT_COMMAND_SET_REMOVAL = 9,    /**< value 0: nothing is cut; 1: as in the scene */
  HAPTICUT_COMMAND_SET_FORCE_MASK = 10 /**< value: bits 0, 1, 2: force along x, y, z of W; bits 3, 4, 5: torque */
};

typedef struct hapticut_command {
  uint32_t struct_size;
  uint32_t kind; /**< hapticut_command_kind */
  double value;
} hapticut_command;

typedef struct hapticut_loop_report {
  uint32_t struct_size;
  uint32_t fault; /**< DeviceFault that ended the loop; 0: none */
  uint64_t ticks;
  uint64_t missed;    /**< ticks that were skipped because the loop was late */
  double compute_p99; /**< [s] 99th percentile of the duration of a tick */
  double compute_max; /**< [s] maximum duration of a tick */
  double wake_up_p99; /**< [s] 99th percentile of the delay of a tick */
  double wake_up_max; /**< [s] maximum delay of a tick */
  uint32_t arming;    /**< hapticut_arming when the loop ended */
  uint32_t unused;
  char end[256];       /**< why the loop ended */
  char warnings[1024]; /**< settings that were not permitted, and complaints of the driver, one per line */
} hapticut_loop_report;

/* --- surface ------------------------------------------------------------------------------------------------------ */

/** 12 bytes in the layout of a vertex buffer. */
typedef struct hapticut_vertex {
  int16_t position[3]; /**< [hapticut_page.step] from the page's origin, along its axes */
  uint8_t material;    /**< id of the material */
  uint8_t unused_1;
  int8_t normal[3]; /**< [1/127] pointing out of the material */
  uint8_t unused_2;
} hapticut_vertex;

typedef struct hapticut_page {
  uint32_t struct_size;
  uint32_t vertex_count; /**< 0: this page has no surface any more */
  uint32_t index_count;
  int32_t origin[3]; /**< [voxels] identifies the page: a page with the same origin replaces it */
  uint64_t version;  /**< increases with every page */
  const hapticut_vertex* vertices;
  const uint16_t* indices; /**< three per triangle, counter-clockwise seen from outside */
  hapticut_pose X_WP;      /**< pose of the page's origin and axes: p_W = X_WP (step position) */
  double step;             /**< [m] */
  uint64_t ticket;         /**< for hapticut_surface_release_page */
} hapticut_page;

/* --- sound -------------------------------------------------------------------------------------------------------- */

typedef struct hapticut_sound_options {
  uint32_t struct_size;
  uint32_t flutes;   /**< number of cutting edges of the tool; 0: 6 */
  double volume;     /**< [1] above 0, up to 1 for full scale; 0: 0.5 */
  double half_power; /**< [W] power at which the noise has half of its maximum; 0: 2 */
} hapticut_sound_options;

typedef struct hapticut_sound_input {
  uint32_t struct_size;
  uint32_t touching;    /**< 1: the head touches the workpiece */
  double spindle_speed; /**< [rad/s] */
  double power;         /**< [W] from hapticut_loop_state, like the other fields */
  double removal_rate;  /**< [m^3/s] */
} hapticut_sound_input;

/* --- recording ---------------------------------------------------------------------------------------------------- */

typedef struct hapticut_recording_report {
  uint32_t struct_size;
  uint32_t unused;
  uint64_t recorded; /**< steps */
  uint64_t lost;     /**< steps that found the queue full, or came after the end */
} hapticut_recording_report;

#ifdef __cplusplus
}
#endif
#endif
