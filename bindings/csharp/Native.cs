// SPDX-License-Identifier: Apache-2.0
// The functions of hapticut/c/hapticut.h, and the conversion of their errors to exceptions.
using System;
using System.Runtime.InteropServices;
using System.Text;

namespace Hapticut {

  /// <summary>A call failed. The message of the library says why and what to do.</summary>
  public sealed class HapticutException : Exception {
    /// <summary>The hapticut_result, below 0.</summary>
    public int Code { get; private set; }
    internal HapticutException(int code, string sentence) : base(sentence) { Code = code; }

    public const int Argument = -1, StaleHandle = -2, StructSize = -3, Busy = -4, Refused = -5, Full = -6, Memory = -7;
  }

  internal static class Text {
    /// Converts a text to UTF-8 with a final 0.
    internal static byte[] Of(string text) {
      if (text == null) throw new ArgumentNullException("text");
      byte[] bytes = new byte[Encoding.UTF8.GetByteCount(text) + 1];
      Encoding.UTF8.GetBytes(text, 0, text.Length, bytes, 0);
      return bytes;
    }

    internal static string Of(byte[] bytes) {
      if (bytes == null) return "";
      int length = Array.IndexOf(bytes, (byte)0);
      return Encoding.UTF8.GetString(bytes, 0, length < 0 ? bytes.Length : length);
    }

    internal static string At(IntPtr text) {
      int length = 0;
      while (Marshal.ReadByte(text, length) != 0) ++length;
      byte[] bytes = new byte[length];
      Marshal.Copy(text, bytes, 0, length);
      return Encoding.UTF8.GetString(bytes);
    }
  }

  internal static class Native {
    const string Library = "hapticut_c";
    internal const int Nothing = 1;

    [DllImport(Library)] internal static extern uint hapticut_abi_version();
    [DllImport(Library)] internal static extern IntPtr hapticut_version();
    [DllImport(Library)] internal static extern IntPtr hapticut_last_error();
    [DllImport(Library)] internal static extern int hapticut_release(IntPtr handle);
    [DllImport(Library)] internal static extern int hapticut_status_text(uint status, byte[] text, UIntPtr capacity);

    [DllImport(Library)]
    internal static extern int hapticut_simulation_from_toml(byte[] text, ref SimulationOptions options, out IntPtr made);
    [DllImport(Library)]
    internal static extern int hapticut_simulation_from_file(byte[] path, ref SimulationOptions options, out IntPtr made);
    [DllImport(Library)] internal static extern int hapticut_scene(Simulation of, ref SceneInfo info);
    [DllImport(Library)] internal static extern int hapticut_material(Simulation of, uint id, ref MaterialInfo info);
    [DllImport(Library)] internal static extern int hapticut_path_pose(Simulation of, double time, out Pose X_WH);
    [DllImport(Library)]
    internal static extern int hapticut_step(Simulation of, ref StepInput input, ref StepResult result);
    [DllImport(Library)] internal static extern int hapticut_touches(Simulation of, ref Pose X_WH, out int touches);
    [DllImport(Library)]
    internal static extern int hapticut_distance_to(Simulation of, uint material, ref Pose X_WH, double maxDistance,
                                                    out double distance);
    [DllImport(Library)]
    internal static extern int hapticut_first_hit(Simulation of, ref Vec3 origin, ref Vec3 direction, double maxLength,
                                                  uint material, ref RayHit hit);
    [DllImport(Library)] internal static extern int hapticut_set_spindle_speed(Simulation of, double radPerS);
    [DllImport(Library)] internal static extern int hapticut_set_tool(Simulation of, byte[] text);
    [DllImport(Library)] internal static extern int hapticut_save_workpiece(Simulation of, byte[] path);
    [DllImport(Library)] internal static extern int hapticut_snapshot_take(Simulation of, out IntPtr made);
    [DllImport(Library)] internal static extern int hapticut_snapshot_restore(Simulation of, Snapshot snapshot);
    [DllImport(Library)] internal static extern int hapticut_set_undo_mark(Simulation of);
    [DllImport(Library)] internal static extern int hapticut_undo(Simulation of);
    [DllImport(Library)] internal static extern int hapticut_redo(Simulation of);

    [DllImport(Library)] internal static extern int hapticut_device_open(byte[] name, out IntPtr made);
    [DllImport(Library)] internal static extern int hapticut_device_describe(Device of, ref DeviceInfo info);
    [DllImport(Library)]
    internal static extern int hapticut_loop_start(Simulation of, Device device, ref LoopOptions options, out IntPtr made);
    [DllImport(Library)] internal static extern int hapticut_loop_is_running(Loop of, out int running);
    [DllImport(Library)] internal static extern int hapticut_loop_latest(Loop of, ref LoopState state);
    [DllImport(Library)] internal static extern int hapticut_loop_send(Loop of, ref Command command);
    [DllImport(Library)] internal static extern int hapticut_loop_set_tool(Loop of, byte[] text);
    [DllImport(Library)] internal static extern int hapticut_loop_emergency_stop(Loop of);
    [DllImport(Library)] internal static extern int hapticut_loop_reset_fault(Loop of);
    [DllImport(Library)] internal static extern int hapticut_loop_stop(Loop of, ref LoopReport report);

    [DllImport(Library)] internal static extern int hapticut_surface_open(Simulation of, out IntPtr made);
    [DllImport(Library)] internal static extern int hapticut_surface_poll(Surface of, ref NativePage page);
    [DllImport(Library)] internal static extern int hapticut_surface_release_page(Surface of, ulong ticket);
    [DllImport(Library)] internal static extern int hapticut_surface_look_at(Surface of, ref Vec3 p_WQ);
    [DllImport(Library)] internal static extern int hapticut_surface_catch_up(Surface of);

    [DllImport(Library)]
    internal static extern int hapticut_heat_open(Simulation of, ref HeatConfig config, ThermalProperties[] byMaterial,
                                                  UIntPtr count, out IntPtr made);
    [DllImport(Library)] internal static extern int hapticut_heat_update(Heat of, out double time);
    [DllImport(Library)] internal static extern int hapticut_heat_advance(Heat of, double dt);
    [DllImport(Library)] internal static extern int hapticut_heat_set_irrigation(Heat of, double coefficient);
    [DllImport(Library)]
    internal static extern int hapticut_heat_temperature_at(Heat of, ref Vec3 p_WQ, out double temperature);
    [DllImport(Library)] internal static extern int hapticut_heat_structure(Heat of, uint id, ref HeatStructureInfo info);
    [DllImport(Library)] internal static extern int hapticut_heat_balance(Heat of, ref HeatBalanceInfo info);
    [DllImport(Library)] internal static extern int hapticut_heat_grid(Heat of, ref HeatGridInfo info);
    [DllImport(Library)]
    internal static extern int hapticut_heat_cells(Heat of, HeatQuantity quantity, float[] values, UIntPtr count);

    [DllImport(Library)]
    internal static extern int hapticut_islands_open(Simulation of, ref IslandsOptions options, out IntPtr made);
    [DllImport(Library)] internal static extern int hapticut_islands_count(Islands of, out ulong count);
    [DllImport(Library)] internal static extern int hapticut_islands_poll(Islands of, ref IslandInfo info);

    [DllImport(Library)] internal static extern int hapticut_sound_open(ref SoundOptions options, out IntPtr made);
    [DllImport(Library)]
    internal static extern int hapticut_sound_render(Sound of, ref SoundInput input, double rate, float[] samples,
                                                     UIntPtr count);

    // The second declaration accepts a null handle as device.
    [DllImport(Library)]
    internal static extern int hapticut_recording_start(Simulation of, Device device, byte[] path, out IntPtr made);
    [DllImport(Library, EntryPoint = "hapticut_recording_start")]
    internal static extern int hapticut_recording_start_alone(Simulation of, IntPtr noDevice, byte[] path,
                                                              out IntPtr made);
    [DllImport(Library)] internal static extern int hapticut_recording_stop(Recording of, ref RecordingReport report);

    /// Throws when a call has failed.  Returns false for HAPTICUT_NOTHING.
    internal static bool Check(int code) {
      if (code < 0) throw new HapticutException(code, Text.At(hapticut_last_error()));
      return code != Nothing;
    }

    internal static uint SizeOf<T>() { return Size<T>.Value; }
    static class Size<T> { internal static readonly uint Value = (uint)Marshal.SizeOf(typeof(T)); }
  }

  /// <summary>The library itself.</summary>
  public static class Library {
    /// <summary>[rad/s] One revolution per minute, the unit of `spindle_rpm` of a scene.</summary>
    public const double Rpm = 2 * Math.PI / 60;
    public static string Version { get { return Text.At(Native.hapticut_version()); } }
    public static uint AbiVersion { get { return Native.hapticut_abi_version(); } }

    /// <summary>The names of the bits of a status.</summary>
    public static string StatusText(uint status) {
      byte[] text = new byte[512];
      Native.Check(Native.hapticut_status_text(status, text, (UIntPtr)text.Length));
      return Text.Of(text);
    }
  }

  /// <summary>An object of the library. Dispose releases it at once; otherwise the garbage collector does.</summary>
  public abstract class LibraryObject : SafeHandle {
    protected LibraryObject(IntPtr made) : base(IntPtr.Zero, true) { SetHandle(made); }
    public override bool IsInvalid { get { return handle == IntPtr.Zero; } }
    protected override bool ReleaseHandle() { return Native.hapticut_release(handle) == 0; }
  }
}
