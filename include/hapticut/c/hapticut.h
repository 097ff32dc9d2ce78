/* SPDX-License-Identifier: Apache-2.0 */
/** @file
 * hapticut in C: library hapticut_c, for programs in C, C#, Unity and whatever else can call C.
 * docs/embedding.md.
 *
 * Results. Every function that can fail returns an int: HAPTICUT_OK, HAPTICUT_NOTHING (no error, and nothing
 * there), or an error < 0; `hapticut_last_error` is then the sentence about it. What was to be filled in is left
 * alone after an error. A step's bits of trouble are in its `status`; they are no errors. `hapticut_status_text` has
 * their names.
 * No exception leaves the library.
 *
 * Handles. What is made here is named by a number, never 0, until `hapticut_release`. A call with 0, with a handle
 * that was released, of another kind, or of another copy of the library returns HAPTICUT_ERROR_HANDLE. What needs
 * another one keeps it alive: handles may be released in any order, a loop that runs ends first.
 *
 * Structs. Each begins with `struct_size`, which the caller sets to sizeof: the library reads and writes no more
 * than that. So an old caller meets a new library: what it does not know of has its default, which is always 0. A
 * new caller may meet an old library: bytes that it does not know must be 0 in what it reads, and are 0 in what it
 * writes. hapticut_pose and hapticut_vertex have no size and never change. 64-bit processors only.
 *
 * Texts. They are UTF-8 and end with 0, also when they were cut to fit.
 *
 * Threads. Any thread may call. One handle does one thing at a time: a second thread that comes meanwhile gets
 * HAPTICUT_ERROR_BUSY at once and may try again; nobody waits. While a loop runs, its simulation and its device are
 * the loop's: calls on them return HAPTICUT_ERROR_BUSY, except where it says so. Of a loop three threads may do one
 * each of: `hapticut_loop_latest`; `hapticut_loop_send` and `hapticut_loop_set_tool`; `hapticut_loop_stop`.
 * Emergency stop and reset never fail for a loop that runs. There is no callback: no code of the caller runs in the
 * 1 kHz thread.
 *
 * Real time. hapticut_step, _probe, _touches, _coupling_step, _loop_latest, _loop_send and _sound_render neither
 * allocate nor lock when they succeed. All else is set-up.
 *
 * Process. Nothing is process-wide unless hapticut_loop_options asks for it: no signal handlers, no locked memory.
 *
 * Units and frames. SI. W world (that of the workpiece), H handle of the tool, T its head, B base of the device, S
 * its stylus. Right-handed; `X_WH` is the pose of H in W. Forces and torques act on the tool.
 */
#ifndef HAPTICUT_C_HAPTICUT_H
#define HAPTICUT_C_HAPTICUT_H

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

/** HAPTICUT_ABI_VERSION of the library. */
HAPTICUT_C_API uint32_t hapticut_abi_version(void);

/** Version and commit, e.g. "0.1.0 6fe0148"; valid for ever. */
HAPTICUT_C_API const char* hapticut_version(void);

/** What went wrong last in this thread, one sentence; "" before anything did. Valid until this thread's next error. */
HAPTICUT_C_API const char* hapticut_last_error(void);

/** Lets go of a handle of any kind. A loop that runs is stopped, and waited for: the force fades within 0.1 s.
 * BUSY: another thread is in a call with it. */
HAPTICUT_C_API int hapticut_release(hapticut_handle handle);

/** The names of the bits of a status: "ok", "blocks_low | power_limited".
 * @param capacity  [bytes] of `text`, with the 0 at its end; a longer text is cut */
HAPTICUT_C_API int hapticut_status_text(uint32_t status, char* text, size_t capacity);

/* --- simulation --------------------------------------------------------------------------------------------------- */

/** A simulation of the scene that a text in TOML describes: the keys of docs/command-line.md. Files that it names are
 * looked for in the working folder.
 * @param options  or null
 * REFUSED: line, key, value and cure are in the sentence, e.g. "scene:7: tool.radius_mm: must be a number > 0, not -1."
 */
HAPTICUT_C_API int hapticut_simulation_from_toml(const char* text, const hapticut_simulation_options* options,
                                                 hapticut_simulation* simulation);

/** The same from a file, whose name stands in the messages. The files that it names are relative to its folder. */
HAPTICUT_C_API int hapticut_simulation_from_file(const char* path, const hapticut_simulation_options* options,
                                                 hapticut_simulation* simulation);

/** What the scene has. Also while a loop runs. */
HAPTICUT_C_API int hapticut_scene(hapticut_simulation simulation, hapticut_scene_info* info);

/** @param id  1 ... hapticut_scene_info.materials */
HAPTICUT_C_API int hapticut_material(hapticut_simulation simulation, uint32_t id, hapticut_material_info* info);

/** Where the handle is on the scene's [path]. Also while a loop runs.
 * @param time  [s] since its beginning; before and after it the tool stands still
 * NOTHING: the scene has no [path] */
HAPTICUT_C_API int hapticut_path_pose(hapticut_simulation simulation, double time, hapticut_pose* X_WH);

/** One step: Simulation::step. */
HAPTICUT_C_API int hapticut_step(hapticut_simulation simulation, const hapticut_step_input* input,
                                 hapticut_step_result* result);

/** What a step would feel, and how stiff the contact would be; changes nothing. For implicit integrators. */
HAPTICUT_C_API int hapticut_probe(hapticut_simulation simulation, const hapticut_step_input* input,
                                  hapticut_probe_result* result);

/** @param touches  1 when the head would be in material, else 0 */
HAPTICUT_C_API int hapticut_touches(hapticut_simulation simulation, const hapticut_pose* X_WH, int* touches);

/** Where the work went since the simulation was made. */
HAPTICUT_C_API int hapticut_energy(hapticut_simulation simulation, hapticut_energy_ledger* ledger);

/** @param rad_per_s  from the next step on, as 40000 * HAPTICUT_RPM */
HAPTICUT_C_API int hapticut_set_spindle_speed(hapticut_simulation simulation, double rad_per_s);

/** Another tool for the same workpiece. Where it is in material the steps that follow feel and cut nothing, as after
 * every exchange and way back, until the head is free: their status has tool_waits.
 * @param text  TOML with a table [tool] and nothing else; its cutter is that of the scene, whose materials are for it
 */
HAPTICUT_C_API int hapticut_set_tool(hapticut_simulation simulation, const char* text);

/** Writes the workpiece as it is.
 * @param path  ends with .vdb; `workpiece.source` of a scene reads it again */
HAPTICUT_C_API int hapticut_save_workpiece(hapticut_simulation simulation, const char* path);

/* --- there and back ----------------------------------------------------------------------------------------------- */

/** The state of the workpiece; shares memory with it. */
HAPTICUT_C_API int hapticut_snapshot_take(hapticut_simulation simulation, hapticut_snapshot* snapshot);

/** Puts the workpiece back; the tool starts afresh.  REFUSED: the snapshot is of another simulation */
HAPTICUT_C_API int hapticut_snapshot_restore(hapticut_simulation simulation, hapticut_snapshot snapshot);

/** Marks the present state; needs hapticut_simulation_options.undo_blocks. In a loop: HAPTICUT_COMMAND_SET_UNDO_MARK.
 */
HAPTICUT_C_API int hapticut_set_undo_mark(hapticut_simulation simulation);

/** Back to the last mark.  NOTHING: there is none */
HAPTICUT_C_API int hapticut_undo(hapticut_simulation simulation);

/** Forth again.  NOTHING: nothing was undone, or something was cut since */
HAPTICUT_C_API int hapticut_redo(hapticut_simulation simulation);

/* --- coupling, for a loop of the caller -------------------------------------------------------------------------- */

/** A spring and damper between a hand and the tool: VirtualCoupling. The simulation was made with `for_coupling`.
 * @param gains  or null */
HAPTICUT_C_API int hapticut_coupling_open(hapticut_simulation simulation, const hapticut_coupling_gains* gains,
                                          hapticut_coupling* coupling);

/** One step of the simulation, led by a hand. `force` and `torque` are what the hand feels, about Ho of the hand;
 * contact and spindle are those of the last part of the tick.
 * @param input  X_WH and velocities of the hand */
HAPTICUT_C_API int hapticut_coupling_step(hapticut_coupling coupling, const hapticut_step_input* input,
                                          hapticut_step_result* result);

/** The next step puts the tool where the hand is, or the first one in which that is in no material. */
HAPTICUT_C_API int hapticut_coupling_reset(hapticut_coupling coupling);

/* --- device and loop ---------------------------------------------------------------------------------------------- */

/** Opens a device: "mock:spiral", "mock:line,hand=nominal", "replay:FILE", "openhaptics": docs/devices.md. */
HAPTICUT_C_API int hapticut_device_open(const char* name, hapticut_device* device);

/** What the device is. Also while a loop runs. */
HAPTICUT_C_API int hapticut_device_describe(hapticut_device device, hapticut_device_info* info);

/** Begins a loop in a thread of its own, behind the guard that stands between every force and a device.
 * @param options  or null
 * REFUSED: the simulation was made without `for_coupling` and the device needs one; the contact is too stiff for the
 * device
 */
HAPTICUT_C_API int hapticut_loop_start(hapticut_simulation simulation, hapticut_device device,
                                       const hapticut_loop_options* options, hapticut_loop* loop);

/** @param running  1 while ticks come; 0 when it has ended, by itself too: then hapticut_loop_stop says why */
HAPTICUT_C_API int hapticut_loop_is_running(hapticut_loop loop, int* running);

/** The latest tick. Never waits for the loop, nor the loop for it. */
HAPTICUT_C_API int hapticut_loop_latest(hapticut_loop loop, hapticut_loop_state* state);

/** Sends a command, to be obeyed at the next tick.
 * FULL: 256 are under way.  REFUSED: its value is out of range */
HAPTICUT_C_API int hapticut_loop_send(hapticut_loop loop, const hapticut_command* command);

/** Another tool, from the next tick on. There is no force until it touches nothing.
 * @param text  as of hapticut_set_tool */
HAPTICUT_C_API int hapticut_loop_set_tool(hapticut_loop loop, const char* text);

/** No force from the next tick on, until the fault is reset. From any thread. */
HAPTICUT_C_API int hapticut_loop_emergency_stop(hapticut_loop loop);

/** Leaves the fault state. From any thread. */
HAPTICUT_C_API int hapticut_loop_reset_fault(hapticut_loop loop);

/** Ends the loop, fades the force out, and waits until it has ended. Simulation and device are the caller's again.
 * @param report  or null
 * NOTHING: it was stopped before; the report is that one */
HAPTICUT_C_API int hapticut_loop_stop(hapticut_loop loop, hapticut_loop_report* report);

/* --- surface ------------------------------------------------------------------------------------------------------ */

/** The surface of the workpiece, in pages of 32 x 32 x 32 voxels. Open it before the first cut, and before a loop that
 * shall be seen; at most 8 surfaces and recordings of one simulation. */
HAPTICUT_C_API int hapticut_surface_open(hapticut_simulation simulation, hapticut_surface* surface);

/** The next page that has become another one, nearest to the point looked at first. Also while a loop runs. Its arrays
 * stay until it is released; several may be held.
 * NOTHING: none waits */
HAPTICUT_C_API int hapticut_surface_poll(hapticut_surface surface, hapticut_page* page);

/** @param ticket  of a page that was polled and not yet released */
HAPTICUT_C_API int hapticut_surface_release_page(hapticut_surface surface, uint64_t ticket);

/** @param p_WQ  [m] [3] whose surroundings come first. Also while a loop runs */
HAPTICUT_C_API int hapticut_surface_look_at(hapticut_surface surface, const double* p_WQ);

/** Takes over all blocks of the workpiece as they are. A step hands on up to 16 blocks; after the last one, or after
 * undo and restore, the rest comes by this. O(blocks) */
HAPTICUT_C_API int hapticut_surface_catch_up(hapticut_surface surface);

/* --- sound -------------------------------------------------------------------------------------------------------- */

/** @param options  or null */
HAPTICUT_C_API int hapticut_sound_open(const hapticut_sound_options* options, hapticut_sound* sound);

/** The next samples of one channel. How they are cut into calls does not matter.
 * @param samples      [count] overwritten; -1 ... 1
 * @param sample_rate  [Hz] 8000 ... 384 000; silence at any other */
HAPTICUT_C_API int hapticut_sound_render(hapticut_sound sound, const hapticut_sound_input* input, double sample_rate,
                                         float* samples, size_t count);

/* --- recording ---------------------------------------------------------------------------------------------------- */

/** Records every step from now on in an HDF5 file, which `hapticut replay` reads: docs/files.md. The simulation has
 * made no step yet.
 * @param device  whose loop will make the steps, or 0
 * REFUSED: also when the library was built with HAPTICUT_WITH_IO=OFF */
HAPTICUT_C_API int hapticut_recording_start(hapticut_simulation simulation, hapticut_device device, const char* path,
                                            hapticut_recording* recording);

/** Ends it and puts the file in place; after the loop has been stopped.
 * @param report  or null
 * NOTHING: it was stopped before.  REFUSED: something could not be written; the report is filled in all the same */
HAPTICUT_C_API int hapticut_recording_stop(hapticut_recording recording, hapticut_recording_report* report);

#ifdef __cplusplus
}
#endif
#endif
