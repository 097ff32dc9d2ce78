// SPDX-License-Identifier: Apache-2.0
// Tests bindings/unity with a fake engine: a scene is drilled, drawn and heard, stopped by a reload, and refused.
using System;
using System.Reflection;
using System.Threading;
using Hapticut;
using UnityEngine;

static class UnityTest {
  const string Scene = @"[workpiece]
source = 'block'
size_mm = [12, 10, 4]
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
    foreach (string error in Debug.Errors) Console.WriteLine(error);
    Environment.Exit(1);
  }

  // Calls a private method, as the engine does.
  static void Call(MonoBehaviour one, string message, params object[] with) {
    try {
      one.GetType().GetMethod(message, BindingFlags.Instance | BindingFlags.NonPublic).Invoke(one, with);
    } catch (TargetInvocationException thrown) {
      Require(false, message + " threw " + thrown.InnerException);
    }
  }

  static void FramesUntil(HapticutScene scene, Func<bool> condition, string what) {
    for (int n = 0; n < 60000 && !condition(); ++n) {
      Call(scene, "Update");
      Thread.Sleep(1);
    }
    Require(condition(), what);
  }

  static int Meshes(Func<GameObject, bool> which) { return GameObject.All.FindAll(one => which(one)).Count; }
  static Mesh MeshOf(GameObject page) { return ((MeshFilter)page.components[0]).sharedMesh; }

  static int Main() {
    Transform tool = new Transform();
    HapticutScene scene =
        new HapticutScene { scene = new TextAsset(Scene), up = Up.Z, simulatedTime = true, tool = tool };
    Call(scene, "OnEnable");
    Require(scene.enabled && Debug.Errors.Count == 0, "the scene begins");

    // 5 s of drilling.
    FramesUntil(scene, () => scene.State.time >= 5, "5 s of device time");
    Require(scene.State.removedVolume > 0, "something is cut");
    FramesUntil(scene, () => Meshes(one => MeshOf(one).uploads > 1) > 0, "a page that was cut is drawn again");
    Require(Meshes(one => MeshOf(one).indices > 0) >= 4, "there are pages");
    // In Unity y is up: the block is 4 mm high, 12 mm and 10 mm wide; the tool is above or inside it.
    foreach (GameObject page in GameObject.All) {
      Mesh mesh = MeshOf(page);
      Require(page.transform.parent == scene.transform, "a page is a child of the scene");
      for (int n = 0; n < mesh.indices; ++n) Require((ushort)mesh.order[n] < mesh.vertices, "an index");
      for (int n = 0; n < mesh.vertices; ++n) {
        float[] p = new float[3];
        for (int axis = 0; axis < 3; ++axis) p[axis] = BitConverter.ToInt16(mesh.data, 12 * n + 2 * axis) / 32767f;
        float x = page.transform.localPosition.x + page.transform.localScale.x * p[0],
              y = page.transform.localPosition.y + page.transform.localScale.y * p[1],
              z = page.transform.localPosition.z + page.transform.localScale.z * p[2];
        Require(x > -2e-4f && x < 12.2e-3f && y > -2e-4f && y < 4.2e-3f && z > -2e-4f && z < 10.2e-3f,
                "a vertex at " + x + " " + y + " " + z);
      }
      ClockwiseFromOutside(page, mesh);
    }
    Require(tool.localPosition.y > 0 && tool.localPosition.y < 0.02f, "the tool is drawn");

    HapticutSound sound = new HapticutSound { scene = scene, volume = 1 };
    Call(sound, "OnEnable");
    float[] stereo = new float[2048];
    for (int n = 0; n < 20; ++n) {
      Array.Clear(stereo, 0, stereo.Length);
      Call(sound, "OnAudioFilterRead", stereo, 2);
    }
    float loudest = 0;
    foreach (float sample in stereo) loudest = Math.Max(loudest, Math.Abs(sample));
    Require(loudest > 1e-3f && loudest <= 1 && stereo[0] == stereo[1], "the sound: " + loudest);
    Call(sound, "OnDisable");
    Call(sound, "OnAudioFilterRead", stereo, 2);

    scene.SetTool(OtherTool);
    scene.Send(CommandKind.SetUndoMark);
    FramesUntil(scene, () => scene.State.undoMarks == 1, "commands arrive");
    scene.EmergencyStop();
    FramesUntil(scene, () => scene.State.arming == Arming.Fault, "the emergency stop");
    scene.ResetFault();
    FramesUntil(scene, () => scene.State.arming != Arming.Fault, "the reset");

    // The editor reloads: the loop ends completely, and starts again.
    Type stops = typeof(HapticutScene).Assembly.GetType("Hapticut.StopBeforeReload");
    System.Runtime.CompilerServices.RuntimeHelpers.RunClassConstructor(stops.TypeHandle);
    UnityEditor.AssemblyReloadEvents.Reload();
    Require(Meshes(one => !one.destroyed) == 0, "the pages are gone");
    Call(scene, "Update");
    GameObject.All.Clear();
    Call(scene, "OnEnable");
    FramesUntil(scene, () => GameObject.All.Count >= 4 && scene.State.tick > 0, "the scene begins again");
    Call(scene, "OnDisable");
    Call(scene, "OnDisable");

    HapticutScene wrong = new HapticutScene { scene = new TextAsset(Scene.Replace("radius_mm = 1", "radius_mm = -1")) };
    Call(wrong, "OnEnable");
    Require(!wrong.enabled && Debug.Errors.Count == 1 &&
            Debug.Errors[0] == "hapticut: scene:8: tool.radius_mm: must be a number > 0 and <= 300, not -1.",
            "a scene with an error");
    Console.WriteLine("drilled, seen, heard");
    return 0;
  }

  // Checks that triangles face outwards: for a clockwise triangle in left-handed axes, (b - a) x (c - a) points towards
  // the viewer, like the normals. For (0, 0, 0), (0, 1, 0), (1, 0, 0), clockwise for a camera along +z, it is
  // (0, 0, -1).
  static void ClockwiseFromOutside(GameObject page, Mesh mesh) {
    int outwards = 0;
    for (int n = 0; n + 2 < mesh.indices; n += 3) {
      double[] a = At(mesh, n), b = At(mesh, n + 1), c = At(mesh, n + 2);
      double[] u = { b[0] - a[0], b[1] - a[1], b[2] - a[2] }, v = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
      double[] face = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
      int at = 12 * (ushort)mesh.order[n] + 8;
      double along = face[0] * (sbyte)mesh.data[at] + face[1] * (sbyte)mesh.data[at + 1] +
                     face[2] * (sbyte)mesh.data[at + 2];
      if (along > 0) ++outwards;
    }
    Require(outwards >= 0.97 * mesh.indices / 3, "triangles look outwards: " + outwards + " of " + mesh.indices / 3);
  }
  static double[] At(Mesh mesh, int n) {
    int at = 12 * (ushort)mesh.order[n];
    return new double[] { BitConverter.ToInt16(mesh.data, at), BitConverter.ToInt16(mesh.data, at + 2),
                          BitConverter.ToInt16(mesh.data, at + 4) };
  }
}
