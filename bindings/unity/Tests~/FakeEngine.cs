// SPDX-License-Identifier: Apache-2.0
// The part of the engine that bindings/unity uses, implemented as far as the test needs it.
using System;
using System.Collections.Generic;

namespace UnityEngine {
  public struct Vector3 {
    public float x, y, z;
    public Vector3(float x, float y, float z) { this.x = x; this.y = y; this.z = z; }
    public static Vector3 operator *(Vector3 v, float by) { return new Vector3(v.x * by, v.y * by, v.z * by); }
  }
  public struct Quaternion {
    public float x, y, z, w;
    public Quaternion(float x, float y, float z, float w) { this.x = x; this.y = y; this.z = z; this.w = w; }
  }
  public struct Bounds { public Bounds(Vector3 center, Vector3 size) {} }

  public class Object {
    public bool destroyed;
    public static void Destroy(Object one) { one.destroyed = true; }
    public static void DestroyImmediate(Object one) { one.destroyed = true; }
  }
  public class Component : Object { public readonly Transform transform = new Transform(); }
  public class Behaviour : Component { public bool enabled = true; }
  public class MonoBehaviour : Behaviour {}
  public class Transform : Object {
    public Vector3 localPosition, localScale;
    public Quaternion localRotation;
    public Transform parent;
    public void SetParent(Transform to, bool worldPositionStays) { parent = to; }
  }
  public sealed class GameObject : Object {
    public readonly Transform transform = new Transform();
    public static readonly List<GameObject> All = new List<GameObject>();
    public readonly List<Component> components = new List<Component>();
    public GameObject(string name) { All.Add(this); }
    public T AddComponent<T>() where T : Component, new() {
      T made = new T();
      components.Add(made);
      return made;
    }
  }
  public sealed class MeshFilter : Component { public Mesh sharedMesh; }
  public sealed class MeshRenderer : Component { public Material sharedMaterial; }
  public sealed class AudioSource : Component {}
  public sealed class Material : Object {}
  public sealed class TextAsset : Object {
    public string text { get; private set; }
    public TextAsset(string text) { this.text = text; }
  }
  public sealed class Mesh : Object {
    public int vertices, indices, uploads, subMeshCount;
    public byte[] data;
    public short[] order;
    public Bounds bounds { get; set; }
    public void MarkDynamic() {}
    public void SetVertexBufferParams(int count, params Rendering.VertexAttributeDescriptor[] layout) {
      vertices = count;
    }
    public void SetVertexBufferData<T>(T[] from, int start, int bufferStart, int count, int stream = 0,
                                       Rendering.MeshUpdateFlags flags = 0) where T : struct {
      data = new byte[count];
      Array.Copy(from, start, data, bufferStart, count);
      ++uploads;
    }
    public void SetIndexBufferParams(int count, Rendering.IndexFormat format) { indices = count; }
    public void SetIndexBufferData<T>(T[] from, int start, int bufferStart, int count,
                                      Rendering.MeshUpdateFlags flags = 0) where T : struct {
      order = new short[count];
      Array.Copy(from, start, order, bufferStart, count);
    }
    public void SetSubMesh(int index, Rendering.SubMeshDescriptor what, Rendering.MeshUpdateFlags flags = 0) {}
  }
  public static class Debug {
    public static readonly List<string> Errors = new List<string>();
    public static void LogError(object message, Object context) { Errors.Add(message.ToString()); }
  }
  public static class Application { public static bool isPlaying = true; }
  public static class AudioSettings { public static int outputSampleRate = 48000; }
  public sealed class TooltipAttribute : Attribute { public TooltipAttribute(string text) {} }
  public sealed class RangeAttribute : Attribute { public RangeAttribute(float from, float to) {} }
  public sealed class RequireComponent : Attribute { public RequireComponent(Type type) {} }
}

namespace UnityEngine.Rendering {
  public enum VertexAttribute { Position, Normal }
  public enum VertexAttributeFormat { SNorm16, SNorm8 }
  public enum IndexFormat { UInt16 }
  [Flags] public enum MeshUpdateFlags { DontValidateIndices = 1, DontRecalculateBounds = 8 }
  public struct VertexAttributeDescriptor {
    public VertexAttributeDescriptor(VertexAttribute what, VertexAttributeFormat format, int dimension) {}
  }
  public struct SubMeshDescriptor { public SubMeshDescriptor(int start, int count) {} }
}

namespace UnityEditor {
  public sealed class InitializeOnLoadAttribute : Attribute {}
  public static class AssemblyReloadEvents {
    public delegate void AssemblyReloadCallback();
    public static event AssemblyReloadCallback beforeAssemblyReload;
    public static void Reload() { if (beforeAssemblyReload != null) beforeAssemblyReload(); }
  }
}
