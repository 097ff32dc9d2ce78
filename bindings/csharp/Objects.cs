// SPDX-License-Identifier: Apache-2.0
// One class for each kind of handle.
using System;
using System.Runtime.InteropServices;

namespace Hapticut {

  /// <summary>A tool and a workpiece, from a scene in TOML. One thread at a time may use it, and no thread while a loop
  /// runs.</summary>
  public sealed class Simulation : LibraryObject {
    Simulation(IntPtr made) : base(made) {}

    public static Simulation FromToml(string text, SimulationOptions options = default(SimulationOptions)) {
      options.structSize = Native.SizeOf<SimulationOptions>();
      IntPtr made;
      Native.Check(Native.hapticut_simulation_from_toml(Text.Of(text), ref options, out made));
      return new Simulation(made);
    }

    public static Simulation FromFile(string path, SimulationOptions options = default(SimulationOptions)) {
      options.structSize = Native.SizeOf<SimulationOptions>();
      IntPtr made;
      Native.Check(Native.hapticut_simulation_from_file(Text.Of(path), ref options, out made));
      return new Simulation(made);
    }

    public SceneInfo Scene {
      get {
        SceneInfo info = new SceneInfo { structSize = Native.SizeOf<SceneInfo>() };
        Native.Check(Native.hapticut_scene(this, ref info));
        return info;
      }
    }

    /// <param name="id">1 ... SceneInfo.materials</param>
    public MaterialInfo Material(uint id) {
      MaterialInfo info = new MaterialInfo { structSize = Native.SizeOf<MaterialInfo>() };
      Native.Check(Native.hapticut_material(this, id, ref info));
      return info;
    }

    /// <summary>The pose of the handle on the scene's path.</summary>
    /// <returns>false if the scene has no path</returns>
    public bool PathPose(double time, out Pose X_WH) {
      return Native.Check(Native.hapticut_path_pose(this, time, out X_WH));
    }

    public StepResult Step(StepInput input) {
      StepResult result = new StepResult { structSize = Native.SizeOf<StepResult>() };
      input.structSize = Native.SizeOf<StepInput>();
      Native.Check(Native.hapticut_step(this, ref input, ref result));
      return result;
    }

    public bool Touches(Pose X_WH) {
      int touches;
      Native.Check(Native.hapticut_touches(this, ref X_WH, out touches));
      return touches != 0;
    }

    /// <summary>The distance [m] between the head at a pose and what is left of a material, 0 where it is in it.</summary>
    /// <param name="material">id; 0: any</param>
    /// <param name="maxDistance">[m] of the search; 0: no limit</param>
    /// <returns>false if nothing of the material is left within maxDistance</returns>
    public bool DistanceTo(uint material, Pose X_WH, out double distance, double maxDistance = 0) {
      return Native.Check(Native.hapticut_distance_to(this, material, ref X_WH, maxDistance, out distance));
    }

    /// <summary>The first place on a ray that is in material.</summary>
    /// <param name="maxLength">[m] of the ray; 0: no limit</param>
    /// <param name="material">id; 0: any</param>
    /// <returns>false if there is none</returns>
    public bool FirstHit(Vec3 origin, Vec3 direction, out RayHit hit, double maxLength = 0, uint material = 0) {
      hit = new RayHit { structSize = Native.SizeOf<RayHit>() };
      return Native.Check(Native.hapticut_first_hit(this, ref origin, ref direction, maxLength, material, ref hit));
    }

    /// <param name="radPerS">[rad/s], e.g. 40000 * Library.Rpm</param>
    public void SetSpindleSpeed(double radPerS) { Native.Check(Native.hapticut_set_spindle_speed(this, radPerS)); }

    /// <param name="toml">only a table [tool]</param>
    public void SetTool(string toml) { Native.Check(Native.hapticut_set_tool(this, Text.Of(toml))); }

    public void SaveWorkpiece(string path) { Native.Check(Native.hapticut_save_workpiece(this, Text.Of(path))); }

    public Snapshot TakeSnapshot() {
      IntPtr made;
      Native.Check(Native.hapticut_snapshot_take(this, out made));
      return new Snapshot(made);
    }

    public void Restore(Snapshot snapshot) { Native.Check(Native.hapticut_snapshot_restore(this, snapshot)); }
    public void SetUndoMark() { Native.Check(Native.hapticut_set_undo_mark(this)); }
    public bool Undo() { return Native.Check(Native.hapticut_undo(this)); }
    public bool Redo() { return Native.Check(Native.hapticut_redo(this)); }
  }

  /// <summary>A state of a workpiece.</summary>
  public sealed class Snapshot : LibraryObject {
    internal Snapshot(IntPtr made) : base(made) {}
  }

  /// <summary>A haptic device, real or simulated.</summary>
  public sealed class Device : LibraryObject {
    Device(IntPtr made) : base(made) {}

    public static Device Open(string name) {
      IntPtr made;
      Native.Check(Native.hapticut_device_open(Text.Of(name), out made));
      return new Device(made);
    }

    public DeviceInfo Info {
      get {
        DeviceInfo info = new DeviceInfo { structSize = Native.SizeOf<DeviceInfo>() };
        Native.Check(Native.hapticut_device_describe(this, ref info));
        return info;
      }
    }
  }

  /// <summary>A device that drives a simulation in a thread of the library. Garbage collection does not stop that
  /// thread.</summary>
  public sealed class Loop : LibraryObject {
    Loop(IntPtr made) : base(made) {}

    public static Loop Start(Simulation simulation, Device device, LoopOptions options = default(LoopOptions)) {
      options.structSize = Native.SizeOf<LoopOptions>();
      IntPtr made;
      Native.Check(Native.hapticut_loop_start(simulation, device, ref options, out made));
      return new Loop(made);
    }

    public bool IsRunning {
      get {
        int running;
        Native.Check(Native.hapticut_loop_is_running(this, out running));
        return running != 0;
      }
    }

    public LoopState Latest() {
      LoopState state = new LoopState { structSize = Native.SizeOf<LoopState>() };
      Native.Check(Native.hapticut_loop_latest(this, ref state));
      return state;
    }

    public void Send(CommandKind kind, double value = 0) {
      Command command = new Command { structSize = Native.SizeOf<Command>(), kind = kind, value = value };
      Native.Check(Native.hapticut_loop_send(this, ref command));
    }

    /// <param name="toml">only a table [tool]</param>
    public void SetTool(string toml) { Native.Check(Native.hapticut_loop_set_tool(this, Text.Of(toml))); }

    public void EmergencyStop() { Native.Check(Native.hapticut_loop_emergency_stop(this)); }
    public void ResetFault() { Native.Check(Native.hapticut_loop_reset_fault(this)); }

    public LoopReport Stop() {
      LoopReport report = new LoopReport { structSize = Native.SizeOf<LoopReport>() };
      Native.Check(Native.hapticut_loop_stop(this, ref report));
      return report;
    }
  }

  /// <summary>A copy of a page of triangles. The next poll into the same object reuses its arrays.</summary>
  public sealed class Page {
    public int originX, originY, originZ;  // identifies the page
    public ulong version;
    public Pose X_WP;
    public double step;  // [m] unit of a vertex position
    public int vertexCount, indexCount;
    public byte[] vertices = new byte[0];  // 12 bytes each: Vertex
    public short[] indices = new short[0];  // bits of 16-bit unsigned numbers

    /// <summary>[m] The position of a vertex in W.</summary>
    public Vec3 Position(int n) {
      double x = step * BitConverter.ToInt16(vertices, 12 * n), y = step * BitConverter.ToInt16(vertices, 12 * n + 2),
             z = step * BitConverter.ToInt16(vertices, 12 * n + 4);
      return new Vec3(X_WP.position.x + X_WP.r00 * x + X_WP.r01 * y + X_WP.r02 * z,
                      X_WP.position.y + X_WP.r10 * x + X_WP.r11 * y + X_WP.r12 * z,
                      X_WP.position.z + X_WP.r20 * x + X_WP.r21 * y + X_WP.r22 * z);
    }

    public int Index(int n) { return (ushort)indices[n]; }

    internal void CopyFrom(NativePage page) {
      originX = page.originX; originY = page.originY; originZ = page.originZ;
      version = page.version; X_WP = page.X_WP; step = page.step;
      vertexCount = (int)page.vertexCount; indexCount = (int)page.indexCount;
      if (vertices.Length < 12 * vertexCount) vertices = new byte[24 * vertexCount];
      if (indices.Length < indexCount) indices = new short[2 * indexCount];
      if (vertexCount > 0) Marshal.Copy(page.vertices, vertices, 0, 12 * vertexCount);
      if (indexCount > 0) Marshal.Copy(page.indices, indices, 0, indexCount);
    }
  }

  /// <summary>The surface of a workpiece in pages. One thread may use it, also while a loop runs.</summary>
  public sealed class Surface : LibraryObject {
    Surface(IntPtr made) : base(made) {}

    /// <summary>Opens the surface. Call it before the first cut.</summary>
    public static Surface Of(Simulation simulation) {
      IntPtr made;
      Native.Check(Native.hapticut_surface_open(simulation, out made));
      return new Surface(made);
    }

    /// <summary>Reads the next changed page.</summary>
    /// <returns>false if no page has changed</returns>
    public bool Poll(Page page) {
      NativePage native = new NativePage { structSize = Native.SizeOf<NativePage>() };
      if (!Native.Check(Native.hapticut_surface_poll(this, ref native))) return false;
      try {
        page.CopyFrom(native);
      } finally {
        Native.hapticut_surface_release_page(this, native.ticket);
      }
      return true;
    }

    public void LookAt(Vec3 p_WQ) { Native.Check(Native.hapticut_surface_look_at(this, ref p_WQ)); }
    public void CatchUp() { Native.Check(Native.hapticut_surface_catch_up(this)); }
  }

  /// <summary>The temperatures of a workpiece. One thread may use it, also while a loop runs.</summary>
  public sealed class Heat : LibraryObject {
    Heat(IntPtr made) : base(made) {}

    /// <summary>Opens the temperatures. Heat comes from all later steps. Call it before the loop starts.</summary>
    /// <param name="byMaterial">properties of the materials 1, 2, ...; 0 or absent: those of the scene or the name</param>
    public static Heat Of(Simulation simulation, HeatConfig config = default(HeatConfig),
                          params ThermalProperties[] byMaterial) {
      config.structSize = Native.SizeOf<HeatConfig>();
      IntPtr made;
      Native.Check(Native.hapticut_heat_open(simulation, ref config, byMaterial, (UIntPtr)byMaterial.Length, out made));
      return new Heat(made);
    }

    /// <summary>Adds the heat of all steps since the last call, and advances by their duration.</summary>
    /// <returns>[s] that duration</returns>
    public double Update() {
      double time;
      Native.Check(Native.hapticut_heat_update(this, out time));
      return time;
    }

    /// <summary>Advances the temperatures by dt [s] without steps.</summary>
    public void Advance(double dt) { Native.Check(Native.hapticut_heat_advance(this, dt)); }

    /// <param name="coefficient">[W/(m^2 K)] some thousands under a spray; 0: dry</param>
    public void SetIrrigation(double coefficient) {
      Native.Check(Native.hapticut_heat_set_irrigation(this, coefficient));
    }

    /// <summary>The temperature [deg C] at a point.</summary>
    /// <returns>false if there is no material</returns>
    public bool TemperatureAt(Vec3 p_WQ, out double temperature) {
      return Native.Check(Native.hapticut_heat_temperature_at(this, ref p_WQ, out temperature));
    }

    /// <param name="id">1 ... SceneInfo.materials</param>
    public HeatStructureInfo Structure(uint id) {
      HeatStructureInfo info = new HeatStructureInfo { structSize = Native.SizeOf<HeatStructureInfo>() };
      Native.Check(Native.hapticut_heat_structure(this, id, ref info));
      return info;
    }

    public HeatBalanceInfo Balance {
      get {
        HeatBalanceInfo info = new HeatBalanceInfo { structSize = Native.SizeOf<HeatBalanceInfo>() };
        Native.Check(Native.hapticut_heat_balance(this, ref info));
        return info;
      }
    }

    public HeatGridInfo Grid {
      get {
        HeatGridInfo info = new HeatGridInfo { structSize = Native.SizeOf<HeatGridInfo>() };
        Native.Check(Native.hapticut_heat_grid(this, ref info));
        return info;
      }
    }

    /// <summary>Copies a quantity of all cells; x is the fastest index.</summary>
    /// <param name="values">one for each cell of the grid; NaN where it has no material</param>
    public void Cells(HeatQuantity quantity, float[] values) {
      Native.Check(Native.hapticut_heat_cells(this, quantity, values, (UIntPtr)values.Length));
    }
  }

  /// <summary>The removal of pieces that are cut loose, until it is disposed of.</summary>
  public sealed class Islands : LibraryObject {
    Islands(IntPtr made) : base(made) {}

    /// <summary>Removes each piece that the tool cuts loose from now on. Call it before the loop starts.</summary>
    public static Islands Of(Simulation simulation, IslandsOptions options = default(IslandsOptions)) {
      options.structSize = Native.SizeOf<IslandsOptions>();
      IntPtr made;
      Native.Check(Native.hapticut_islands_open(simulation, ref options, out made));
      return new Islands(made);
    }

    /// <summary>The number of pieces that were removed.</summary>
    public ulong Count {
      get {
        ulong count;
        Native.Check(Native.hapticut_islands_count(this, out count));
        return count;
      }
    }

    /// <summary>The next of the pieces that were removed.</summary>
    /// <returns>false if no other piece was removed</returns>
    public bool Poll(out IslandInfo info) {
      info = new IslandInfo { structSize = Native.SizeOf<IslandInfo>() };
      return Native.Check(Native.hapticut_islands_poll(this, ref info));
    }
  }

  /// <summary>The sound of a drill. Use it in the thread that needs the samples.</summary>
  public sealed class Sound : LibraryObject {
    Sound(IntPtr made) : base(made) {}

    /// <param name="volume">above 0, up to 1; 0 means 0.5</param>
    public static Sound Open(uint flutes = 0, double volume = 0) {
      SoundOptions options =
          new SoundOptions { structSize = Native.SizeOf<SoundOptions>(), flutes = flutes, volume = volume };
      IntPtr made;
      Native.Check(Native.hapticut_sound_open(ref options, out made));
      return new Sound(made);
    }

    public void Render(SoundInput input, double sampleRate, float[] samples) {
      input.structSize = Native.SizeOf<SoundInput>();
      Native.Check(Native.hapticut_sound_render(this, ref input, sampleRate, samples, (UIntPtr)samples.Length));
    }
  }

  /// <summary>A file that records every step.</summary>
  public sealed class Recording : LibraryObject {
    Recording(IntPtr made) : base(made) {}

    /// <param name="device">of the loop that will make the steps, or null</param>
    public static Recording Start(Simulation simulation, Device device, string path) {
      IntPtr made;
      Native.Check(device != null
                       ? Native.hapticut_recording_start(simulation, device, Text.Of(path), out made)
                       : Native.hapticut_recording_start_alone(simulation, IntPtr.Zero, Text.Of(path), out made));
      return new Recording(made);
    }

    public RecordingReport Stop() {
      RecordingReport report = new RecordingReport { structSize = Native.SizeOf<RecordingReport>() };
      Native.Check(Native.hapticut_recording_stop(this, ref report));
      return report;
    }
  }
}
