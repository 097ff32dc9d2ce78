/* SPDX-License-Identifier: Apache-2.0 */
/** @file
 * hapticut in C: library hapticut_c, for programs in C, C#, Unity and every language that can call C.
 * docs/embedding.md.
 *
 * Results. Every function that can fail returns an int: HAPTICUT_OK, HAPTICUT_NOTHING (no error, but there was no
 * result), or an error < 0, about which `hapticut_last_error` returns a sentence. After an error the outputs are
 * unchanged. The bits in the `status` of a step are no errors; `hapticut_status_text` returns their names.
 * No exception leaves the library.
 *
 * Handles. A handle is a number that identifies an object until `hapticut_release`; it is never 0. A call returns
 * HAPTICUT_ERROR_HANDLE when a handle is 0, released, of another kind, or of another copy of the library. An object
 * keeps the objects that it needs alive, so handles may be released in any order. A running loop ends first.
 *
 * Structs. Each struct begins with `struct_size`, which the caller sets to its sizeof. The library reads and writes no
 * more than that. When an old caller uses a new library, fields that the caller lacks have their default, which is
 * always 0. When a new caller uses an old library, fields that the library lacks must be 0 in inputs, and are 0 in
 * outputs. hapticut_pose, hapticut_vertex and hapticut_thermal_properties have no size and never change. 64-bit
 * processors only.
 *
 * Texts. They are UTF-8 and end with 0, also when they are cut to fit.
 *
 * Threads. Any thread may call. An object handles one call at a time: a second thread that calls meanwhile gets
 * HAPTICUT_ERROR_BUSY at once and may try again; no call waits. While a loop runs, it owns its simulation and its
 * device: calls on them return HAPTICUT_ERROR_BUSY, except where the function says otherwise. Three threads may use a
 * loop at the same time, one for each of: `hapticut_loop_latest`; `hapticut_loop_send` and `hapticut_loop_set_tool`;
 * `hapticut_loop_stop`. Emergency stop and reset never fail while a loop runs. There are no callbacks: no code of the
 * caller runs in the 1 kHz thread.
 *
 * Observers. A simulation has eight places: a surface or a recording takes one, a heat two, the removal of loose pieces
 * one. Open them before a loop starts: while it runs, that returns BUSY. Released meanwhile, they leave when it ends.
 *
 * Real time. hapticut_step, _probe, _touches, _distance_to, _first_hit, _coupling_step, _loop_latest, _loop_send and
 * _sound_render neither allocate nor lock when they succeed. All other functions are for set-up.
 *
 * Process. Nothing is process-wide unless hapticut_loop_options requests it: no signal handlers, no locked memory.
 *
 * Units and frames. SI. W world (that of the workpiece), H handle of the tool, T its head, B base of the device, S
 * its stylus. Right-handed; `X_WH` is the pose of H in W. Forces and torques act on the tool.
 */
#ifndef HAPTICUT_C_HAPTICUT_H
#define HAPTICUT_C_HAPTICUT_H

#include "hapticut/c/heat_types.h"
#include "hapticut/c/types.h"

#if defined(HAPTICUT_C_BUILDS)
#define HAPTICUT_C_API __attribute__((visibility("default")))
#else
#define HAPTICUT_C_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* --- the library -------------------------------------------------------------------------------------------------- */

/** The HAPTICUT_ABI_VERSION of the library. */
HAPTICUT_C_API uint32_t hapticut_abi_version(void);

/** Version and commit, e.g. "0.1.0 6fe0148". The pointer stays valid. */
HAPTICUT_C_API const char* hapticut_version(void);

/** A sentence about the last error in this thread; "" before the first error. Valid until this thread's next error. */
HAPTICUT_C_API const char* hapticut_last_error(void);

/** Releases a handle of any kind. Stops a running loop and waits for its end: the force fades within 0.1 s.
 * BUSY: another thread is in a call with this handle. */
HAPTICUT_C_API int hapticut_release(hapticut_handle handle);

/** Writes the names of the bits of a status: "ok", "blocks_low | power_limited".
 * @param capacity  [bytes] of `text`, including the 0 at its end; a longer text is cut */
HAPTICUT_C_API int hapticut_status_text(uint32_t status, char* text, size_t capacity);

/* --- simulation --------------------------------------------------------------------------------------------------- */

/** Makes a simulation from a scene in TOML, with the keys of docs/command-line.md. Paths in the scene are relative to
 * the working folder.
 * @param options  or null
 * REFUSED: the error has line, key, value and cure, e.g. "scene:7: tool.radius_mm: must be a number > 0, not -1."
 */
HAPTICUT_C_API int hapticut_simulation_from_toml(const char* text, const hapticut_simulation_options* options,
                                                 hapticut_simulation* simulation);

/** Makes a simulation from a scene in a TOML file, whose name is in the errors. Paths in it are relative to its folder.
 */
HAPTICUT_C_API int hapticut_simulation_from_file(const char* path, const hapticut_simulation_options* options,
                                                 hapticut_simulation* simulation);

/** Describes the scene. Also while a loop runs. */
HAPTICUT_C_API int hapticut_scene(hapticut_simulation simulation, hapticut_scene_info* info);

/** Describes a material.
 * @param id  1 ... hapticut_scene_info.materials */
HAPTICUT_C_API int hapticut_material(hapticut_simulation simulation, uint32_t id, hapticut_material_info* info);

/** The pose of the handle on the scene's [path]. Also while a loop runs.
 * @param time  [s] since the start of the path; before and after the path the tool stands still
 * NOTHING: the scene has no [path] */
HAPTICUT_C_API int hapticut_path_pose(hapticut_simulation simulation, double time, hapticut_pose* X_WH);

/** Makes one step: Simulation::step. */
HAPTICUT_C_API int hapticut_step(hapticut_simulation simulation, const hapticut_step_input* input,
                                 hapticut_step_result* result);

/** The wrench and the stiffness that a step would have, without a change. For implicit integrators. */
HAPTICUT_C_API int hapticut_probe(hapticut_simulation simulation, const hapticut_step_input* input,
                                  hapticut_probe_result* result);

/** Whether the head would be in material.
 * @param touches  1: in material; 0: free */
HAPTICUT_C_API int hapticut_touches(hapticut_simulation simulation, const hapticut_pose* X_WH, int* touches);

/** The distance between the head, with the handle at a pose, and what is left of a material: Simulation::distance_to.
 * @param material      id, 1 ... hapticut_scene_info.materials; 0: any material
 * @param max_distance  [m] of the search; 0: no limit
 * @param distance      [m] 0 where the head is in the material
 * NOTHING: nothing of the material is left within max_distance */
HAPTICUT_C_API int hapticut_distance_to(hapticut_simulation simulation, uint32_t material, const hapticut_pose* X_WH,
                                        double max_distance, double* distance);

/** The first place on a ray that is in material: Workpiece::first_hit.
 * @param origin_W     [m] [3] in W
 * @param direction_W  [3] in W, of any length but 0
 * @param max_length   [m] of the ray; 0: no limit
 * @param material     id, 1 ... hapticut_scene_info.materials; 0: any material
 * NOTHING: there is no such material within the length */
HAPTICUT_C_API int hapticut_first_hit(hapticut_simulation simulation, const double* origin_W, const double* direction_W,
                                      double max_length, uint32_t material, hapticut_ray_hit* hit);

/** The energy ledger since the simulation was made. */
HAPTICUT_C_API int hapticut_energy(hapticut_simulation simulation, hapticut_energy_ledger* ledger);

/** Sets the spindle's speed from the next step on.
 * @param rad_per_s  [rad/s], e.g. 40000 * HAPTICUT_RPM */
HAPTICUT_C_API int hapticut_set_spindle_speed(hapticut_simulation simulation, double rad_per_s);

/** Exchanges the tool. If the new head is in material, the next steps have no force and cut nothing until the head is
 * free; their status has tool_waits. This applies after every exchange, undo and redo.
 * @param text  TOML with only a table [tool]. Its cutter must be that of the scene, because the materials depend on it
 */
HAPTICUT_C_API int hapticut_set_tool(hapticut_simulation simulation, const char* text);

/** Writes the present workpiece to a file.
 * @param path  ends with .vdb; `workpiece.source` of a scene reads such a file */
HAPTICUT_C_API int hapticut_save_workpiece(hapticut_simulation simulation, const char* path);

/* --- snapshots and undo ------------------------------------------------------------------------------------------- */

/** Makes a snapshot of the workpiece, which shares memory with it. */
HAPTICUT_C_API int hapticut_snapshot_take(hapticut_simulation simulation, hapticut_snapshot* snapshot);

/** Restores the workpiece; the tool starts again.  REFUSED: the snapshot is of another simulation */
HAPTICUT_C_API int hapticut_snapshot_restore(hapticut_simulation simulation, hapticut_snapshot snapshot);

/** Marks the present state; needs hapticut_simulation_options.undo_blocks. In a loop: HAPTICUT_COMMAND_SET_UNDO_MARK.
 */
HAPTICUT_C_API int hapticut_set_undo_mark(hapticut_simulation simulation);

/** Returns to the last mark.  NOTHING: there is no mark */
HAPTICUT_C_API int hapticut_undo(hapticut_simulation simulation);

/** Redoes the last undo.  NOTHING: nothing was undone, or something was cut since */
HAPTICUT_C_API int hapticut_redo(hapticut_simulation simulation);

/* --- coupling, for a custom loop --------------------------------------------------------------------------------- */

/** Makes a spring and damper between a hand and the tool: VirtualCoupling. The simulation needs `for_coupling`.
 * @param gains  or null */
HAPTICUT_C_API int hapticut_coupling_open(hapticut_simulation simulation, const hapticut_coupling_gains* gains,
                                          hapticut_coupling* coupling);

/** Makes one tick with the coupling. `force` and `torque` are the wrench for the hand, about Ho of the hand. Contact
 * and spindle are those of the last sub-tick.
 * @param input  X_WH and velocities of the hand */
HAPTICUT_C_API int hapticut_coupling_step(hapticut_coupling coupling, const hapticut_step_input* input,
                                          hapticut_step_result* result);

/** Resets the coupling: the tool jumps to the hand in the next step in which the hand's pose is free of material. */
HAPTICUT_C_API int hapticut_coupling_reset(hapticut_coupling coupling);

/* --- device and loop ---------------------------------------------------------------------------------------------- */

/** Opens a device: "mock:spiral", "mock:line,hand=nominal", "replay:FILE", "openhaptics": docs/devices.md. */
HAPTICUT_C_API int hapticut_device_open(const char* name, hapticut_device* device);

/** Describes the device. Also while a loop runs. */
HAPTICUT_C_API int hapticut_device_describe(hapticut_device device, hapticut_device_info* info);

/** Starts a loop in a new thread. The safety guard stands between the force and the device.
 * @param options  or null
 * REFUSED: the device needs a coupling but the simulation was made without `for_coupling`; or the contact is too stiff
 * for the device
 */
HAPTICUT_C_API int hapticut_loop_start(hapticut_simulation simulation, hapticut_device device,
                                       const hapticut_loop_options* options, hapticut_loop* loop);

/** Whether a loop runs.
 * @param running  1 while it runs; 0 after its end, about which hapticut_loop_stop reports */
HAPTICUT_C_API int hapticut_loop_is_running(hapticut_loop loop, int* running);

/** The state after the latest tick. Neither this call nor the loop waits for the other. */
HAPTICUT_C_API int hapticut_loop_latest(hapticut_loop loop, hapticut_loop_state* state);

/** Sends a command, which the loop applies at the next tick.
 * FULL: 256 commands are in the queue.  REFUSED: the value is out of range */
HAPTICUT_C_API int hapticut_loop_send(hapticut_loop loop, const hapticut_command* command);

/** Exchanges the tool at the next tick. There is no force until the tool touches nothing.
 * @param text  see hapticut_set_tool */
HAPTICUT_C_API int hapticut_loop_set_tool(hapticut_loop loop, const char* text);

/** Switches the force off from the next tick on, until the fault is reset. From any thread. */
HAPTICUT_C_API int hapticut_loop_emergency_stop(hapticut_loop loop);

/** Leaves the fault state. From any thread. */
HAPTICUT_C_API int hapticut_loop_reset_fault(hapticut_loop loop);

/** Ends the loop: fades the force out and waits for the end. The caller then owns simulation and device again.
 * @param report  or null
 * NOTHING: the loop was already stopped; the report is filled in all the same */
HAPTICUT_C_API int hapticut_loop_stop(hapticut_loop loop, hapticut_loop_report* report);

/* --- surface ------------------------------------------------------------------------------------------------------ */

/** Opens the surface of the workpiece, in pages of 32 x 32 x 32 voxels. Open it before the first cut, and before the
 * loop starts. */
HAPTICUT_C_API int hapticut_surface_open(hapticut_simulation simulation, hapticut_surface* surface);

/** The next changed page; the page nearest to the point of hapticut_surface_look_at comes first. Also while a loop
 * runs. The arrays stay valid until the page is released. Several pages may be in use. NOTHING: no page has changed */
HAPTICUT_C_API int hapticut_surface_poll(hapticut_surface surface, hapticut_page* page);

/** Releases a page.
 * @param ticket  of a page that was polled and not yet released */
HAPTICUT_C_API int hapticut_surface_release_page(hapticut_surface surface, uint64_t ticket);

/** Sets the point near which pages come first. Also while a loop runs.
 * @param p_WQ  [m] [3] in W */
HAPTICUT_C_API int hapticut_surface_look_at(hapticut_surface surface, const double* p_WQ);

/** Updates the surface with all blocks of the workpiece. A step sends at most 16 blocks; after the last step, or after
 * undo and restore, this call sends the rest. O(blocks) */
HAPTICUT_C_API int hapticut_surface_catch_up(hapticut_surface surface);

/* --- heat: docs/beside-the-step.md -------------------------------------------------------------------------------- */

/** Opens the temperatures of the workpiece, which begins at body temperature. Heat comes from all later steps, also
 * those of a coupling or a loop. Open it before the loop starts.
 * @param config       or null. A field that is 0 has its value in the table [heat] of the scene, else its default
 * @param by_material  [count] properties of the materials 1 ... count, or null. The materials without an entry have
 *                     those of the scene, else of their names: enamel, dentin, pulp, ...; others are as cortical bone
 * REFUSED: a number is out of range, or the workpiece spans too many cells
 */
HAPTICUT_C_API int hapticut_heat_open(hapticut_simulation simulation, const hapticut_heat_config* config,
                                      const hapticut_thermal_properties* by_material, size_t count,
                                      hapticut_heat* heat);

/** Adds the heat of all steps since the last call, and advances the temperatures by their duration. Call it ten to
 * thirty times a second, in one thread, also while a loop runs; it takes milliseconds, and no step waits for it. A step
 * tells of at most 16 changed blocks, so the blocks of an undo come with the next steps.
 * @param time  [s] duration of these steps, 0 if there were none; or null */
HAPTICUT_C_API int hapticut_heat_update(hapticut_heat heat, double* time);

/** Advances the temperatures without steps, e.g. while the tool is put away.
 * @param dt  [s] >= 0 */
HAPTICUT_C_API int hapticut_heat_advance(hapticut_heat heat, double dt);

/** Sets the heat transfer to the water from now on.
 * @param coefficient  [W/(m^2 K)] some thousands under a spray; 0: dry */
HAPTICUT_C_API int hapticut_heat_set_irrigation(hapticut_heat heat, double coefficient);

/** The temperature at a point, between the centres of the cells.
 * @param p_WQ         [m] [3] in W
 * @param temperature  [deg C]
 * NOTHING: there is no material */
HAPTICUT_C_API int hapticut_heat_temperature_at(hapticut_heat heat, const double* p_WQ, double* temperature);

/** The effect of the heat on a material.
 * @param id  1 ... hapticut_scene_info.materials */
HAPTICUT_C_API int hapticut_heat_structure(hapticut_heat heat, uint32_t id, hapticut_heat_structure_info* info);

/** Where the heat has gone since the beginning. */
HAPTICUT_C_API int hapticut_heat_balance(hapticut_heat heat, hapticut_heat_balance_info* info);

/** Describes the cells. */
HAPTICUT_C_API int hapticut_heat_grid(hapticut_heat heat, hapticut_heat_grid_info* info);

/** Copies a quantity of all cells, e.g. into a texture: cell (i, j, k) is number i + dims[0] (j + dims[1] k).
 * @param quantity  hapticut_heat_quantity
 * @param values    [count] NaN where a cell has no material
 * @param count     the product of hapticut_heat_grid_info.dims */
HAPTICUT_C_API int hapticut_heat_cells(hapticut_heat heat, uint32_t quantity, float* values, size_t count);

/* --- loose pieces: docs/beside-the-step.md ------------------------------------------------------------------------ */

/** Removes each piece that is cut loose, until the handle is released: from now on, hapticut_step,
 * hapticut_coupling_step and the ticks of a loop remove a few blocks at their end. A thread of the library searches.
 * Open it before the loop starts. hapticut_material_info.detached_volume has the volume of the pieces, which costs no
 * energy. A recording ends with the first piece. A scene with `remove_loose_pieces` needs no handle; one that is opened
 * takes the place of the scene's.
 * @param options  or null
 * REFUSED: a handle of this simulation removes loose pieces already; or an option is out of range */
HAPTICUT_C_API int hapticut_islands_open(hapticut_simulation simulation, const hapticut_islands_options* options,
                                         hapticut_islands* islands);

/** The number of pieces that were removed. Also while a loop runs. */
HAPTICUT_C_API int hapticut_islands_count(hapticut_islands islands, uint64_t* count);

/** The next of the pieces that were removed, e.g. to let it fall. Also while a loop runs. Of pieces that were not
 * polled, the latest 64 are kept. NOTHING: no other piece was removed */
HAPTICUT_C_API int hapticut_islands_poll(hapticut_islands islands, hapticut_island_info* info);

/* --- sound -------------------------------------------------------------------------------------------------------- */

/** Makes the sound of a drill.
 * @param options  or null */
HAPTICUT_C_API int hapticut_sound_open(const hapticut_sound_options* options, hapticut_sound* sound);

/** Renders the next samples of one channel. The number of samples per call does not matter.
 * @param samples      [count] overwritten; -1 ... 1
 * @param sample_rate  [Hz] 8000 ... 384 000; silence at any other */
HAPTICUT_C_API int hapticut_sound_render(hapticut_sound sound, const hapticut_sound_input* input, double sample_rate,
                                         float* samples, size_t count);

/* --- recording ---------------------------------------------------------------------------------------------------- */

/** Starts a recording of all steps in an HDF5 file, which `hapticut replay` reads: docs/files.md. The simulation
 * must not have made a step yet.
 * @param device  of the loop that will make the steps, or 0
 * REFUSED: also while another recording writes the file, and when the library was built with HAPTICUT_WITH_IO=OFF */
HAPTICUT_C_API int hapticut_recording_start(hapticut_simulation simulation, hapticut_device device, const char* path,
                                            hapticut_recording* recording);

/** Ends the recording and completes the file. Stop the loop first.
 * @param report  or null
 * NOTHING: it was already stopped.  REFUSED: something could not be written; the report is filled in all the same */
HAPTICUT_C_API int hapticut_recording_stop(hapticut_recording recording, hapticut_recording_report* report);

#ifdef __cplusplus
}
#endif
#endif
