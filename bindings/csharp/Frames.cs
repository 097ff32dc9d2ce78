// SPDX-License-Identifier: Apache-2.0
// Conversion from the world of hapticut (right-handed, z up, metres) to the frames of engines: docs/embedding.md.
using System;

namespace Hapticut {

  /// <summary>A rotation as a quaternion of length 1; w is its real part.</summary>
  public struct Quaternion {
    public double x, y, z, w;
    public Quaternion(double x, double y, double z, double w) { this.x = x; this.y = y; this.z = z; this.w = w; }

    /// <summary>The rotation of a pose, with w not negative.</summary>
    public static Quaternion Of(Pose X) {
      // The largest component is computed first, to avoid a division by a small number.
      double trace = X.r00 + X.r11 + X.r22;
      Quaternion q;
      if (trace >= Math.Max(X.r00, Math.Max(X.r11, X.r22)))
        q = new Quaternion(X.r21 - X.r12, X.r02 - X.r20, X.r10 - X.r01, 1 + trace);
      else if (X.r00 >= X.r11 && X.r00 >= X.r22)
        q = new Quaternion(1 + X.r00 - X.r11 - X.r22, X.r01 + X.r10, X.r02 + X.r20, X.r21 - X.r12);
      else if (X.r11 >= X.r22)
        q = new Quaternion(X.r01 + X.r10, 1 + X.r11 - X.r00 - X.r22, X.r12 + X.r21, X.r02 - X.r20);
      else
        q = new Quaternion(X.r02 + X.r20, X.r12 + X.r21, 1 + X.r22 - X.r00 - X.r11, X.r10 - X.r01);
      double by = (q.w < 0 ? -1 : 1) / Math.Sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
      return new Quaternion(by * q.x, by * q.y, by * q.z, by * q.w);
    }

    /// <summary>The pose with this rotation at p.</summary>
    public Pose At(Vec3 p) {
      return new Pose {
        position = p,
        r00 = 1 - 2 * (y * y + z * z), r01 = 2 * (x * y - z * w), r02 = 2 * (x * z + y * w),
        r10 = 2 * (x * y + z * w), r11 = 1 - 2 * (x * x + z * z), r12 = 2 * (y * z - x * w),
        r20 = 2 * (x * z - y * w), r21 = 2 * (y * z + x * w), r22 = 1 - 2 * (x * x + y * y)
      };
    }
  }

  /// <summary>Unity: left-handed, y up, metres. Each function is its own inverse.</summary>
  public static class UnityFrame {
    /// <summary>Converts a position, a force or a velocity.</summary>
    public static Vec3 Vector(Vec3 v) { return new Vec3(v.x, v.z, v.y); }
    /// <summary>Converts an axial vector: a torque or an angular velocity.</summary>
    public static Vec3 Axial(Vec3 v) { return new Vec3(-v.x, -v.z, -v.y); }
    public static Quaternion Rotation(Quaternion q) { return new Quaternion(-q.x, -q.z, -q.y, q.w); }
  }

  /// <summary>Unreal: left-handed, z up, centimetres.</summary>
  public static class UnrealFrame {
    public const double UnitsPerMetre = 100;
    public static Vec3 Position(Vec3 p) { return new Vec3(100 * p.x, -100 * p.y, 100 * p.z); }
    public static Vec3 PositionBack(Vec3 p) { return new Vec3(p.x / 100, -p.y / 100, p.z / 100); }
    /// <summary>Converts a force, a direction or a velocity in m/s; its own inverse.</summary>
    public static Vec3 Vector(Vec3 v) { return new Vec3(v.x, -v.y, v.z); }
    public static Vec3 Axial(Vec3 v) { return new Vec3(-v.x, v.y, -v.z); }
    public static Quaternion Rotation(Quaternion q) { return new Quaternion(-q.x, q.y, -q.z, q.w); }
  }
}
