// SPDX-License-Identifier: Apache-2.0
using System;
using System.Collections.Generic;
using UnityEngine;

namespace Hapticut {

  /// <summary>A scene in TOML. While the component is enabled, a device drills the scene in a loop of the library. Its
  /// transform is the world of hapticut; its children are the pages of the surface.</summary>
  public sealed class HapticutScene : MonoBehaviour {
    [Tooltip("TOML: docs/command-line.md of hapticut")] public TextAsset scene;
    [Tooltip("mock:spiral,hand=nominal; openhaptics; ...")] public string device = "mock:spiral,hand=nominal";
    [Tooltip("axis of the device's base that points up")] public Up up = Up.Y;
    [Tooltip("material of the drawn workpiece")] public UnityEngine.Material material;
    [Tooltip("moved to the pose of the tool's head")] public Transform tool;
    [Tooltip("maximum number of pages of the surface that are updated per frame")] public int pagesPerFrame = 32;
    [Tooltip("as fast as possible: for tests with a mock device")] public bool simulatedTime;

    /// <summary>The state of the last frame.</summary>
    public LoopState State { get; private set; }
    /// <summary>The latest input for the audio thread. Each update makes a new object.</summary>
    internal volatile SoundSource heard;
    internal sealed class SoundSource { internal SoundInput input; }

    Simulation simulation_;
    Device device_;
    Surface surface_;
    Loop loop_;
    readonly Page page_ = new Page();
    readonly Dictionary<ulong, SurfacePage> pages_ = new Dictionary<ulong, SurfacePage>();
    static readonly List<HapticutScene> all_ = new List<HapticutScene>();

    /// <summary>Ends all loops. A loop starts again when its scene is enabled again.</summary>
    public static void StopAll() {
      foreach (HapticutScene one in all_.ToArray()) one.End();
    }

    void OnEnable() {
      try {
        simulation_ = Simulation.FromToml(scene.text, new SimulationOptions { ForCoupling = true, undoBlocks = 16384 });
        device_ = Device.Open(device);
        surface_ = Surface.Of(simulation_);
        loop_ = Loop.Start(simulation_, device_, new LoopOptions { up = up, SimulatedTime = simulatedTime });
        all_.Add(this);
      } catch (HapticutException refusal) {
        Debug.LogError("hapticut: " + refusal.Message, this);
        End();
        enabled = false;
      }
    }

    void OnDisable() { End(); }

    void Update() {
      if (loop_ == null) return;
      State = loop_.Latest();
      heard = new SoundSource { input = SoundInput.Of(State) };
      if (tool != null) {
        tool.localPosition = Vector(UnityFrame.Vector(State.X_WT.position));
        tool.localRotation = Rotation(State.X_WT);
      }
      for (int n = 0; n < pagesPerFrame && surface_.Poll(page_); ++n) Show(page_);
    }

    /// <summary>Sends a command, which the loop applies at the next tick.</summary>
    public void Send(CommandKind kind, double value = 0) { if (loop_ != null) loop_.Send(kind, value); }

    /// <summary>Exchanges the tool: TOML with a table [tool].</summary>
    public void SetTool(string toml) { if (loop_ != null) loop_.SetTool(toml); }

    public void EmergencyStop() { if (loop_ != null) loop_.EmergencyStop(); }
    public void ResetFault() { if (loop_ != null) loop_.ResetFault(); }

    void Show(Page page) {
      ulong key = (ulong)(uint)page.originX & 0x1fffff;
      key = key << 21 | ((ulong)(uint)page.originY & 0x1fffff);
      key = key << 21 | ((ulong)(uint)page.originZ & 0x1fffff);
      SurfacePage shown;
      if (!pages_.TryGetValue(key, out shown)) {
        if (page.indexCount == 0) return;
        pages_.Add(key, shown = new SurfacePage(transform, material));
      }
      shown.Show(page);
    }

    void End() {
      all_.Remove(this);
      heard = null;
      if (loop_ != null) {
        try {
          loop_.Stop();
        } catch (HapticutException refusal) {
          Debug.LogError("hapticut: " + refusal.Message, this);
        }
      }
      foreach (IDisposable one in new IDisposable[] { loop_, surface_, device_, simulation_ })
        if (one != null) one.Dispose();
      loop_ = null; surface_ = null; device_ = null; simulation_ = null;
      foreach (SurfacePage one in pages_.Values) one.Remove();
      pages_.Clear();
    }

    internal static Vector3 Vector(Vec3 v) { return new Vector3((float)v.x, (float)v.y, (float)v.z); }
    internal static UnityEngine.Quaternion Rotation(Pose X) {
      Quaternion q = UnityFrame.Rotation(Quaternion.Of(X));
      return new UnityEngine.Quaternion((float)q.x, (float)q.y, (float)q.z, (float)q.w);
    }
  }
}
