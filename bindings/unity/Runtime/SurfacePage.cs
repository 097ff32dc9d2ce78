// SPDX-License-Identifier: Apache-2.0
using UnityEngine;
using UnityEngine.Rendering;

namespace Hapticut {

  /// <summary>A page of the surface as a Mesh. Its 12 bytes per vertex go to the graphics card unchanged, except that y
  /// and z are swapped. The swap mirrors the page into the left-handed frame of Unity, where the triangles still look
  /// counter-clockwise. Unity needs clockwise triangles, so they are reversed.</summary>
  sealed class SurfacePage {
    // The shader receives 16-bit numbers as n/32767 and 8-bit numbers as n/127. w of the position is the material's
    // id/32767.
    static readonly VertexAttributeDescriptor[] Layout = {
      new VertexAttributeDescriptor(VertexAttribute.Position, VertexAttributeFormat.SNorm16, 4),
      new VertexAttributeDescriptor(VertexAttribute.Normal, VertexAttributeFormat.SNorm8, 4)
    };
    const float StepsPerUnit = 32767, Edge = 33 * 512 / StepsPerUnit;

    readonly GameObject object_ = new GameObject("hapticut page");
    readonly Mesh mesh_ = new Mesh();

    internal SurfacePage(Transform parent, UnityEngine.Material material) {
      mesh_.MarkDynamic();
      object_.transform.SetParent(parent, false);
      object_.AddComponent<MeshFilter>().sharedMesh = mesh_;
      object_.AddComponent<MeshRenderer>().sharedMaterial = material;
    }

    internal void Show(Page page) {
      float scale = (float)(page.step * StepsPerUnit);
      object_.transform.localPosition = HapticutScene.Vector(UnityFrame.Vector(page.X_WP.position));
      object_.transform.localRotation = HapticutScene.Rotation(page.X_WP);
      object_.transform.localScale = new Vector3(scale, scale, scale);
      SwapAxes(page.vertices, page.vertexCount);
      ReverseTriangles(page.indices, page.indexCount);
      const MeshUpdateFlags trust = MeshUpdateFlags.DontValidateIndices | MeshUpdateFlags.DontRecalculateBounds;
      mesh_.SetVertexBufferParams(page.vertexCount, Layout);
      mesh_.SetVertexBufferData(page.vertices, 0, 0, 12 * page.vertexCount, 0, trust);
      mesh_.SetIndexBufferParams(page.indexCount, IndexFormat.UInt16);
      mesh_.SetIndexBufferData(page.indices, 0, 0, page.indexCount, trust);
      mesh_.subMeshCount = 1;
      mesh_.SetSubMesh(0, new SubMeshDescriptor(0, page.indexCount), trust);
      mesh_.bounds = new Bounds(new Vector3(Edge / 2, Edge / 2, Edge / 2), new Vector3(Edge, Edge, Edge) * 1.1f);
    }

    internal void Remove() {
      if (Application.isPlaying) {
        Object.Destroy(mesh_);
        Object.Destroy(object_);
      } else {
        Object.DestroyImmediate(mesh_);
        Object.DestroyImmediate(object_);
      }
    }

    static void SwapAxes(byte[] vertices, int count) {
      for (int at = 0; at < 12 * count; at += 12) {
        byte low = vertices[at + 2], high = vertices[at + 3], normal = vertices[at + 9];
        vertices[at + 2] = vertices[at + 4]; vertices[at + 3] = vertices[at + 5];
        vertices[at + 4] = low; vertices[at + 5] = high;
        vertices[at + 9] = vertices[at + 10]; vertices[at + 10] = normal;
      }
    }

    static void ReverseTriangles(short[] indices, int count) {
      for (int n = 0; n + 2 < count; n += 3) {
        short second = indices[n + 1];
        indices[n + 1] = indices[n + 2];
        indices[n + 2] = second;
      }
    }
  }
}
