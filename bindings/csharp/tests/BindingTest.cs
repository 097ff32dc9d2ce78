// SPDX-License-Identifier: Apache-2.0
// Tests bindings/csharp under Mono. Ends with 1 at the first failure.
using System;
using System.Diagnostics;
using System.IO;
using System.Runtime.InteropServices;
using System.Text.RegularExpressions;
using System.Threading;
using Hapticut;

static class BindingTest {
  const string Scene = @"[workpiece]
source = 'block'
size_mm = [6, 6, 3]
voxel_mm = 0.2
material = 'cortical_bone'
[tool]
head = 'sphere'
radius_mm = 1
handle = 'ray'
handle_length_mm = 20
spindle_rpm = 40000
";
  const string OtherTool = "[tool]\nhead = 'sphere'\nradius_mm = 0.6\nhandle = 'ray'\nhandle_length_mm = 20\n" +
                           "spindle_rpm = 40000\n";

  static void Require(bool condition, string what) {
    if (condition) return;
    Console.WriteLine("failed: " + what);
    Environment.Exit(1);
  }

  static HapticutException Refused(Action action, string what) {
    try {
      action();
    } catch (HapticutException refusal) {
      return refusal;
    }
    Require(false, what + " was not refused");
    return null;
  }

  static void WaitFor(Func<bool> condition, string what) {
    for (int n = 0; n < 60000 && !condition(); ++n) Thread.Sleep(1);
    Require(condition(), what);
  }

  static StepInput Above(double depth) {
    return new StepInput { X_WH = Pose.At(3e-3, 3e-3, 3e-3 + 1e-3 + 20e-3 - depth),
                           linearVelocity = new Vec3(0, 0, -2e-3), dt = 1e-3 };
  }

  // The structs have the same sizes as in C: tests/unit/c/c_structs_test.cpp.
  static void Sizes() {
    Type[] types = { typeof(Pose), typeof(SimulationOptions), typeof(SceneInfo), typeof(MaterialInfo),
                     typeof(StepInput), typeof(StepResult), typeof(RayHit), typeof(DeviceInfo), typeof(LoopOptions), typeof(LoopState), typeof(LoopReport),
                     typeof(Vertex), typeof(SoundInput), typeof(RecordingReport), typeof(HeatConfig),
                     typeof(ThermalProperties), typeof(HeatStructureInfo), typeof(HeatBalanceInfo), typeof(HeatGridInfo),
                     typeof(IslandsOptions), typeof(IslandInfo) };
    int[] sizes = { 96, 16, 336, 96, 160, 312, 64, 240, 160, 472, 1344, 12, 32, 24, 56, 16, 48, 48, 120, 80, 40 };
    for (int n = 0; n < types.Length; ++n)
      Require(Marshal.SizeOf(types[n]) == sizes[n], types[n].Name + " has " + Marshal.SizeOf(types[n]) + " bytes");
  }

  // The enumerations have the names and numbers of C: HAPTICUT_COMMAND_SET_SCALE = 4 is CommandKind.SetScale.
  static void Enumerations(string header) {
    string text = File.ReadAllText(header);
    string[] prefixes = { "COMMAND", "ARMING", "COUPLING", "UP", "LOOP" };
    Type[] types = { typeof(CommandKind), typeof(Arming), typeof(CouplingChoice), typeof(Up), typeof(LoopFlags) };
    for (int n = 0; n < types.Length; ++n) {
      MatchCollection values = Regex.Matches(text, "HAPTICUT_" + prefixes[n] + @"_(\w+) = (\d+)");
      Require(values.Count == Enum.GetNames(types[n]).Length, types[n].Name + " has other values than in C");
      foreach (Match value in values) {
        string name = Enum.GetName(types[n], uint.Parse(value.Groups[2].Value));
        Require(name != null && name.ToUpperInvariant() == value.Groups[1].Value.Replace("_", ""),
                value + " is " + name);
      }
    }
  }

  static void Steps() {
    using (Simulation simulation = Simulation.FromToml(Scene, new SimulationOptions { undoBlocks = 4096 })) {
      SceneInfo scene = simulation.Scene;
      Require(scene.materials == 1 && Math.Abs(scene.voxelSize - 0.2e-3) < 1e-12 && scene.boxMax.z == 3e-3,
              "the scene");
      Require(Math.Abs(scene.X_HT.position.z + 20e-3) < 1e-12, "the head's place");
      simulation.SetUndoMark();
      double removed = 0;
      int firstTouches = 0;
      StepResult result = new StepResult();
      for (int n = 1; n <= 400; ++n) {
        result = simulation.Step(Above(2e-6 * n));
        if (result.firstTouched.Has(1)) ++firstTouches;
        removed += result.removedVolume;
      }
      Require(firstTouches == 1, "the first touch");
      Require(result.force.z > 1 && removed > 0 && (result.status & 15) == 0,
              "a step: " + result.force + " " + result.status);
      MaterialInfo bone = simulation.Material(1);
      Require(bone.Name == "cortical_bone" && Math.Abs(bone.removedVolume - removed) < 1e-9 * removed, "the material");
      Require(simulation.Touches(Above(2e-3).X_WH) && !simulation.Touches(Above(-1e-3).X_WH), "what touches");
      Require(simulation.Undo() && !simulation.Undo() && simulation.Material(1).volume > bone.volume, "undo");
      using (Snapshot snapshot = simulation.TakeSnapshot()) simulation.Restore(snapshot);
      double distance;
      Require(simulation.DistanceTo(1, Above(-2e-3).X_WH, out distance) && Math.Abs(distance - 2e-3) < 0.05e-3 &&
              !simulation.DistanceTo(1, Above(-2e-3).X_WH, out distance, 1e-3), "the distance to the material");
      RayHit hit;
      Require(simulation.FirstHit(new Vec3(1e-3, 1e-3, 8e-3), new Vec3(0, 0, -1), out hit) && hit.material == 1 &&
              Math.Abs(hit.distance - 5e-3) < 0.05e-3 && hit.normal.z > 0.9, "a ray");
      Pose pose;
      Require(!simulation.PathPose(0, out pose), "there is no path");
      StepInput wrong = Above(0);
      wrong.X_WH.r00 = 2;
      Require(Library.StatusText(simulation.Step(wrong).status) == "pose_rejected", "an invalid pose");
    }
  }

  static void HeatAndPieces() {
    string scene = Scene.Replace("[6, 6, 3]", "[6, 0.8, 0.8]").Replace("0.2", "0.1").Replace("radius_mm = 1", "radius_mm = 0.6");
    using (Simulation simulation = Simulation.FromToml(scene))
    using (Heat heat = Heat.Of(simulation, new HeatConfig { voxelsPerCell = 2 }))
    using (Islands islands = Islands.Of(simulation)) {
      StepInput input = Above(0);
      input.X_WH.position.x = 4e-3;
      input.X_WH.position.y = 0.4e-3;
      int ticks = 0;
      Action step = () => {
        if (ticks < 525) ++ticks;
        input.X_WH.position.z = 20e-3 + 1.4e-3 - 4e-6 * ticks;
        simulation.Step(input);
      };
      while (ticks < 525) step();
      Require(Math.Abs(heat.Update() - 0.525) < 1e-9, "the time of the steps");
      HeatStructureInfo bone = heat.Structure(1);
      HeatBalanceInfo balance = heat.Balance;
      Require(bone.material == 1 && bone.peak > 38 && bone.cem43 > 0, "drilling heats: " + bone.peak);
      Require(balance.broughtIn > 0 && Math.Abs(balance.imbalance) < 1e-9 * balance.broughtIn, "the balance");
      HeatGridInfo grid = heat.Grid;
      float[] cells = new float[grid.dimsX * grid.dimsY * grid.dimsZ];
      heat.Cells(HeatQuantity.Temperature, cells);
      double temperature, warmest = 0;
      foreach (float cell in cells) if (cell > warmest) warmest = cell;
      Require(Math.Abs(warmest - bone.temperature) < 1e-3, "the cells: " + warmest);
      Require(heat.TemperatureAt(new Vec3(2e-3, 0.4e-3, 0.4e-3), out temperature) && temperature >= 36.9 &&
              !heat.TemperatureAt(new Vec3(1, 1, 1), out temperature), "a temperature");
      heat.SetIrrigation(5000);
      heat.Advance(20);
      Require(heat.Structure(1).temperature < 37 && heat.Balance.irrigation > 0, "water cools");
      Refused(() => heat.SetIrrigation(-1), "a coefficient");
      Refused(() => heat.Cells(HeatQuantity.Dose, new float[3]), "a wrong number of cells");
      Refused(() => Heat.Of(simulation, new HeatConfig(), new ThermalProperties { conductivity = -1 }), "a conductivity");

      IslandInfo piece = new IslandInfo();
      bool found = false;
      WaitFor(() => {
        step();
        return found = found || islands.Poll(out piece);
      }, "a loose piece");
      Require(islands.Count == 1 && piece.voxels > 500 && piece.center.x > 5e-3 &&
              simulation.Material(1).detachedVolume > 0.6e-9, "the piece");
    }
    Simulation.FromToml(scene + "[simulation]\nremove_loose_pieces = true\n").Dispose();
  }

  static void Errors() {
    HapticutException refusal =
        Refused(() => Simulation.FromToml(Scene.Replace("radius_mm = 1", "radius_mm = -1")), "a radius");
    Require(refusal.Code == HapticutException.Refused &&
            refusal.Message == "scene:8: tool.radius_mm: must be a number > 0 and <= 300, not -1.", refusal.Message);
    Require(Refused(() => Simulation.FromToml(Scene.Replace("cortical_bone", "k\u00f6rper")), "a material").Message
                .Contains("k\u00f6rper"), "texts are UTF-8 both ways");
    Refused(() => Simulation.FromToml("[tool"), "a syntax error");
    Refused(() => Device.Open("no_such_device"), "a device");
    Simulation released = Simulation.FromToml(Scene);
    released.Dispose();
    released.Dispose();
    try {
      released.Step(Above(0));
      Require(false, "a released object was used");
    } catch (ObjectDisposedException) {
    }
  }

  static void Forgotten() {
    for (int n = 0; n < 200; ++n) Sound.Open();
  }

  class Thing { public volatile int value = 1; }
  static Thing nothing = null;

  static void Loops() {
    Simulation simulation = Simulation.FromToml(Scene, new SimulationOptions { ForCoupling = true, undoBlocks = 4096 });
    Device device = Device.Open("mock:spiral,hand=nominal");
    Require(device.Info.Model.Length > 0 && device.Info.stiffness > 0, "the device");
    Surface surface = Surface.Of(simulation);
    LoopOptions options = new LoopOptions { up = Up.Z, SimulatedTime = true, OrdinaryPriority = true };
    Loop loop = Loop.Start(simulation, device, options);
    Require(Refused(() => simulation.Step(Above(0)), "a step in a loop").Code == HapticutException.Busy, "busy");
    WaitFor(() => loop.Latest().removedVolume > 0, "the loop cuts nothing");

    // The runtime turns SIGSEGV into exceptions; the loop does not interfere.
    int caught = 0;
    for (int n = 0; n < 100; ++n)
      try {
        caught += nothing.value - nothing.value;
      } catch (NullReferenceException) {
        ++caught;
      }
    Require(caught == 100, "an exception was lost");
    ulong before = loop.Latest().tick;
    GC.Collect();
    WaitFor(() => loop.Latest().tick > before + 100, "the loop has stopped ticking");
    Require(loop.Latest().arming != Arming.Fault, "the force was switched off without a request");

    loop.Send(CommandKind.SetUndoMark);
    WaitFor(() => loop.Latest().undoMarks == 1, "a command");
    Refused(() => loop.Send(CommandKind.SetScale, -1), "a scale");
    loop.SetTool(OtherTool);
    loop.EmergencyStop();
    WaitFor(() => loop.Latest().arming == Arming.Fault, "the emergency stop");
    loop.ResetFault();
    WaitFor(() => loop.Latest().arming != Arming.Fault, "the reset");

    Page page = new Page();
    int pages = 0, triangles = 0;
    WaitFor(() => {
      while (surface.Poll(page)) {
        ++pages;
        triangles += page.indexCount / 3;
        for (int n = 0; n < page.indexCount; ++n) Require(page.Index(n) < page.vertexCount, "an index");
        for (int n = 0; n < page.vertexCount; ++n) Require(Math.Abs(page.Position(n).z - 1.5e-3) < 1.7e-3, "a vertex");
      }
      return triangles > 1000;
    }, "there are no pages");

    float[] samples = new float[4800];
    using (Sound sound = Sound.Open(6, 1)) {
      SoundInput heard = SoundInput.Of(loop.Latest());
      heard.spindleSpeed = 4000;
      heard.Touching = true;
      sound.Render(heard, 48000, samples);
    }
    float loudest = 0;
    foreach (float sample in samples) loudest = Math.Max(loudest, Math.Abs(sample));
    Require(loudest > 0.01f && loudest <= 1, "the sound: " + loudest);

    LoopReport report = loop.Stop();
    Require(report.ticks > 100 && report.End.Length > 0, "the report");
    simulation.Step(Above(-5e-3));
    // The order differs from that of construction, as with a garbage collector.
    simulation.Dispose();
    device.Dispose();
    surface.Dispose();
    loop.Dispose();

    // A loop that was not stopped ends with its object.
    Loop.Start(Simulation.FromToml(Scene, new SimulationOptions { ForCoupling = true }), Device.Open("mock:rest"),
               options);
  }

  static void Frames() {
    Random random = new Random(5);
    Func<double> any = () => 2 * random.NextDouble() - 1;
    Func<Vec3> vector = () => new Vec3(any(), any(), any());
    for (int n = 0; n < 1000; ++n) {
      Quaternion q = new Quaternion(any(), any(), any(), any());
      double length = Math.Sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
      q = new Quaternion(q.x / length, q.y / length, q.z / length, q.w / length);
      Vec3 p = vector(), force = vector(), torque = vector(), velocity = vector(), rotation = vector();
      Near(UnityFrame.Vector(UnityFrame.Vector(p)), p, "Unity, there and back");
      Near(UnityFrame.Axial(UnityFrame.Axial(p)), p, "Unity, there and back");
      Near(UnrealFrame.PositionBack(UnrealFrame.Position(p)), p, "Unreal, there and back");
      Near(UnrealFrame.Axial(UnrealFrame.Axial(p)), p, "Unreal, there and back");
      double power = force.Dot(velocity) + torque.Dot(rotation);
      Near(UnityFrame.Vector(force).Dot(UnityFrame.Vector(velocity)) +
               UnityFrame.Axial(torque).Dot(UnityFrame.Axial(rotation)), power, "Unity, power");
      Near(UnrealFrame.Vector(force).Dot(UnrealFrame.Vector(velocity)) +
               UnrealFrame.Axial(torque).Dot(UnrealFrame.Axial(rotation)), power, "Unreal, power");
      // Rotation and change of frame commute.
      Near(UnityFrame.Vector(Rotated(q, p)), Rotated(UnityFrame.Rotation(q), UnityFrame.Vector(p)), "Unity, rotation");
      Near(UnrealFrame.Vector(Rotated(q, p)), Rotated(UnrealFrame.Rotation(q), UnrealFrame.Vector(p)),
           "Unreal, rotation");
      // r x F is a torque in every frame.
      Near(UnityFrame.Axial(Cross(p, force)), Cross(UnityFrame.Vector(p), UnityFrame.Vector(force)), "Unity, lever");
      Near(UnrealFrame.Axial(Cross(p, force)), Cross(UnrealFrame.Vector(p), UnrealFrame.Vector(force)),
           "Unreal, lever");
      Quaternion back = Quaternion.Of(q.At(p));
      double sign = q.w < 0 ? -1 : 1;
      Near(new Vec3(back.x, back.y, back.z), new Vec3(sign * q.x, sign * q.y, sign * q.z),
           "a rotation, there and back");
    }
  }
  static Vec3 Cross(Vec3 a, Vec3 b) {
    return new Vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
  }
  static Vec3 Rotated(Quaternion q, Vec3 v) {
    Pose X = q.At(new Vec3());
    return new Vec3(X.r00 * v.x + X.r01 * v.y + X.r02 * v.z, X.r10 * v.x + X.r11 * v.y + X.r12 * v.z,
                    X.r20 * v.x + X.r21 * v.y + X.r22 * v.z);
  }
  static void Near(Vec3 a, Vec3 b, string what) { Near(a.x, b.x, what); Near(a.y, b.y, what); Near(a.z, b.z, what); }
  static void Near(double a, double b, string what) { Require(Math.Abs(a - b) < 1e-12, what + ": " + a + " and " + b); }

  static int Main(string[] arguments) {
    Require(Library.AbiVersion == 1 && Library.Version.StartsWith("0."), "the version");
    Sizes();
    Enumerations(arguments[0]);
    Frames();
    Steps();
    HeatAndPieces();
    Errors();
    Forgotten();
    GC.Collect();
    GC.WaitForPendingFinalizers();
    Loops();
    GC.Collect();
    GC.WaitForPendingFinalizers();

    using (Sound sound = Sound.Open()) {
      SoundInput input = new SoundInput();
      float[] one = new float[1];
      const int calls = 200000;
      Stopwatch watch = Stopwatch.StartNew();
      for (int n = 0; n < calls; ++n) sound.Render(input, 0, one);
      Console.WriteLine("a call takes " + (1e9 * watch.Elapsed.TotalSeconds / calls).ToString("F0") + " ns");
    }
    Console.WriteLine("keeps its promises");
    return 0;
  }
}
