// SPDX-License-Identifier: Apache-2.0
// The structs of hapticut/c/types.h and heat_types.h, which document the fields.
using System;
using System.Runtime.InteropServices;

namespace Hapticut {

  [StructLayout(LayoutKind.Sequential)]
  public struct Vec3 {
    public double x, y, z;

    public Vec3(double x, double y, double z) { this.x = x; this.y = y; this.z = z; }
    public double Dot(Vec3 other) { return x * other.x + y * other.y + z * other.z; }
    public override string ToString() { return "(" + x + ", " + y + ", " + z + ")"; }
  }

  /// <summary>Position [m], and rotation row by row.</summary>
  [StructLayout(LayoutKind.Sequential)]
  public struct Pose {
    public Vec3 position;
    public double r00, r01, r02, r10, r11, r12, r20, r21, r22;

    public static Pose At(double x, double y, double z) {
      return new Pose { position = new Vec3(x, y, z), r00 = 1, r11 = 1, r22 = 1 };
    }
  }

  [StructLayout(LayoutKind.Sequential)]
  public struct SimulationOptions {
    internal uint structSize;
    internal uint forCoupling;
    public ulong undoBlocks;
    public bool ForCoupling { get { return forCoupling != 0; } set { forCoupling = value ? 1u : 0u; } }
  }

  [StructLayout(LayoutKind.Sequential)]
  public struct SceneInfo {
    internal uint structSize;
    public uint materials;
    public double rate, voxelSize;
    public Vec3 boxMin, boxMax;
    public Pose X_WV, X_HT;
    public Vec3 headMin, headMax;
    public double spindleSpeed, pathDuration;
    public uint flutes;
    internal uint unused;
  }

  [StructLayout(LayoutKind.Sequential)]
  public struct MaterialInfo {
    internal uint structSize;
    internal uint unused;
    public double removedVolume, volume;
    [MarshalAs(UnmanagedType.ByValArray, SizeConst = 64)] internal byte[] name;
    public double detachedVolume;
    public string Name { get { return Text.Of(name); } }
  }

  [StructLayout(LayoutKind.Sequential)]
  public struct StepInput {
    internal uint structSize;
    internal uint unused;
    public Pose X_WH;
    public Vec3 linearVelocity, angularVelocity;
    public double dt;
  }

  [StructLayout(LayoutKind.Sequential)]
  public struct StepResult {
    internal uint structSize;
    public uint status;
    public Vec3 force, torque;
    public double removedVolume;
    public ulong removedVoxels;
    public double spindleSpeed, spindleTorque, contactDepth, contactVolume;
    public uint contactVoxels, subSteps;
    public Pose X_WH;
    public Vec3 contactPoint, contactNormal;
    public double contactArea, contactPressure;
    public MaterialSet firstTouched;
    public double loadToCut;
  }

  /// <summary>A set of materials, by their ids.</summary>
  [StructLayout(LayoutKind.Sequential)]
  public struct MaterialSet {
    internal ulong from0, from64, from128, from192;

    public bool Has(uint id) {
      ulong word = id < 64 ? from0 : id < 128 ? from64 : id < 192 ? from128 : from192;
      return id < 256 && (word >> (int)(id % 64) & 1) != 0;
    }
  }

  [StructLayout(LayoutKind.Sequential)]
  public struct RayHit {
    internal uint structSize;
    public uint material;
    public double distance;
    public Vec3 point, normal;
  }

  [StructLayout(LayoutKind.Sequential)]
  public struct DeviceInfo {
    internal uint structSize;
    public int inputDegreesOfFreedom, outputDegreesOfFreedom;
    internal uint unused;
    public double rate, peakForce, continuousForce, peakTorque, stiffness, damping;
    public Vec3 workspaceMin, workspaceMax;
    [MarshalAs(UnmanagedType.ByValArray, SizeConst = 64)] internal byte[] model;
    [MarshalAs(UnmanagedType.ByValArray, SizeConst = 64)] internal byte[] serialNumber;
    public string Model { get { return Text.Of(model); } }
    public string SerialNumber { get { return Text.Of(serialNumber); } }
  }

  public enum CouplingChoice : uint { ByDevice = 0, Always = 1, Never = 2 }

  public enum Up : uint { Y = 0, Z = 1 }

  [StructLayout(LayoutKind.Sequential)]
  public struct LoopOptions {
    internal uint structSize;
    public CouplingChoice coupling;
    public double seconds, scale;
    public Up up;
    internal uint hasX_WB;
    internal Pose given;
    public double stiffness;
    internal uint simulatedTime, ordinaryPriority, lockMemory, stopOnSignals, stopOnCrash, unused;

    public Pose X_WB { get { return given; } set { given = value; hasX_WB = 1; } }
    public bool SimulatedTime { get { return simulatedTime != 0; } set { simulatedTime = value ? 1u : 0u; } }
    public bool OrdinaryPriority { get { return ordinaryPriority != 0; } set { ordinaryPriority = value ? 1u : 0u; } }
    public bool LockMemory { get { return lockMemory != 0; } set { lockMemory = value ? 1u : 0u; } }
  }

  public enum Arming : uint { Off = 0, Armed = 1, WaitFree = 2, Ramp = 3, On = 4, Fault = 5 }

  [Flags]
  public enum LoopFlags : uint { ReadingValid = 1, Touching = 2, Undoing = 4, Redoing = 8, ForceHeld = 16 }

  [StructLayout(LayoutKind.Sequential)]
  public struct LoopState {
    internal uint structSize;
    public uint status;
    public ulong tick;
    public Arming arming;
    public uint fault;
    public LoopFlags flags;
    public uint buttons, outputChanges, statusSeen;
    public double time;
    public Pose X_BS, X_WT;
    public Vec3 force, torque, appliedForce, appliedTorque;
    public double spindleSpeed, removedVolume, dissipated, power, removalRate, contactDepth;
    public uint contactVoxels, undoMarks, redoMarks;
    internal uint unused;
    public ulong commandsDropped, commandsRefused;
    public Vec3 contactPoint;
    public MaterialSet touched;
  }

  public enum CommandKind : uint {
    SetSpindleSpeed = 1, OpenClutch = 2, CloseClutch = 3, SetScale = 4, SetUndoMark = 5, Undo = 6, Redo = 7,
    HoldForce = 8, SetRemoval = 9, SetForceMask = 10
  }

  [StructLayout(LayoutKind.Sequential)]
  internal struct Command {
    internal uint structSize;
    internal CommandKind kind;
    internal double value;
  }

  [StructLayout(LayoutKind.Sequential)]
  public struct LoopReport {
    internal uint structSize;
    public uint fault;
    public ulong ticks, missed;
    public double computeP99, computeMax, wakeUpP99, wakeUpMax;
    public Arming arming;
    internal uint unused;
    [MarshalAs(UnmanagedType.ByValArray, SizeConst = 256)] internal byte[] end;
    [MarshalAs(UnmanagedType.ByValArray, SizeConst = 1024)] internal byte[] warnings;
    public string End { get { return Text.Of(end); } }
    public string Warnings { get { return Text.Of(warnings); } }
  }

  /// <summary>12 bytes in the layout of a vertex buffer.</summary>
  [StructLayout(LayoutKind.Sequential)]
  public struct Vertex {
    public short x, y, z;
    public byte material, unused1;
    public sbyte nx, ny, nz;
    public byte unused2;
  }

  [StructLayout(LayoutKind.Sequential)]
  internal struct NativePage {
    internal uint structSize, vertexCount, indexCount;
    internal int originX, originY, originZ;
    internal ulong version;
    internal IntPtr vertices, indices;
    internal Pose X_WP;
    internal double step;
    internal ulong ticket;
  }

  [StructLayout(LayoutKind.Sequential)]
  internal struct SoundOptions {
    internal uint structSize, flutes;
    internal double volume, halfPower;
  }

  [StructLayout(LayoutKind.Sequential)]
  public struct SoundInput {
    internal uint structSize;
    internal uint touching;
    public double spindleSpeed, power, removalRate;
    public bool Touching { get { return touching != 0; } set { touching = value ? 1u : 0u; } }

    /// <summary>The input for the sound of a loop.</summary>
    public static SoundInput Of(LoopState state) {
      return new SoundInput { Touching = (state.flags & LoopFlags.Touching) != 0, spindleSpeed = state.spindleSpeed,
                              power = state.power, removalRate = state.removalRate };
    }
  }

  [StructLayout(LayoutKind.Sequential)]
  public struct RecordingReport {
    internal uint structSize;
    internal uint unused;
    public ulong recorded, lost;
  }

  [StructLayout(LayoutKind.Sequential)]
  public struct HeatConfig {
    internal uint structSize;
    public uint voxelsPerCell;
    public double cuttingShare, rubbingShare, bodyTemperature, irrigation, waterTemperature, threshold;
  }

  [StructLayout(LayoutKind.Sequential)]
  public struct ThermalProperties {
    public double conductivity, heatCapacity;
  }

  [StructLayout(LayoutKind.Sequential)]
  public struct HeatStructureInfo {
    internal uint structSize;
    public uint material;
    public double temperature, peak, timeAbove, cem43, volumeAbove;
  }

  [StructLayout(LayoutKind.Sequential)]
  public struct HeatBalanceInfo {
    internal uint structSize;
    internal uint unused;
    public double broughtIn, stored, chips, irrigation, imbalance;
  }

  [StructLayout(LayoutKind.Sequential)]
  public struct HeatGridInfo {
    internal uint structSize;
    public uint dimsX, dimsY, dimsZ;
    public double cellSize;
    public Pose X_WC;
  }

  public enum HeatQuantity : uint { Temperature = 0, Peak = 1, Dose = 2 }

  [StructLayout(LayoutKind.Sequential)]
  public struct IslandsOptions {
    internal uint structSize;
    internal uint hasFixed;
    internal Vec3 fixedMin, fixedMax;
    public double minFill, period;
    public ulong blocksPerTick;

    /// <summary>The pieces that reach into this box [m] in W stay, in place of the largest one.</summary>
    public void Fix(Vec3 min, Vec3 max) { hasFixed = 1; fixedMin = min; fixedMax = max; }
  }

  [StructLayout(LayoutKind.Sequential)]
  public struct IslandInfo {
    internal uint structSize;
    internal uint unused;
    public ulong voxels;
    public Vec3 center;
  }
}
