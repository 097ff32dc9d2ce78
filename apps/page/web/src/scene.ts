// SPDX-License-Identifier: Apache-2.0
// The surface of the workpiece: one draw call per page, twelve bytes per vertex. Units of the scene are mm.
import * as three from "three";
import { HeatColors, heatShader } from "./heat.ts";
import type { Heat, Hello, Pose, SurfacePage, Vec3 } from "./protocol.ts";

const kEdge = 32; // voxels per page
const kSteps = 512; // steps of a vertex position per voxel

const vertexShader = `
uniform vec3 colors[16];
in vec3 extra;
out vec3 vColor, vNormal, vPlace, vEye;
float byteOf(float v) { return v > 127.0 ? v - 256.0 : v; }
void main() {
  float packed = extra.y < 0.0 ? extra.y + 65536.0 : extra.y;
  float high = floor(packed / 256.0);
  vec3 n = vec3(byteOf(packed - 256.0 * high), byteOf(high), byteOf(extra.z));
  int id = int(extra.x + 0.5);
  vColor = colors[clamp(id, 0, 15)];
  vNormal = normalize(mat3(modelMatrix) * n);
  vec4 place = modelMatrix * vec4(position, 1.0);
  vPlace = place.xyz;
  vec4 eye = viewMatrix * place;
  vEye = eye.xyz;
  gl_Position = projectionMatrix * eye;
}`;

const fragmentShader = `
uniform vec4 section;
uniform vec3 keyLight;
in vec3 vColor, vNormal, vPlace, vEye;
out vec4 color;
${heatShader}
void main() {
  vec3 own = vColor;
  if (showsHeat) {
    float temperature = temperatureAt(vPlace);
    own = heated(own, temperature, fwidth(temperature));
  }
  if (dot(section.xyz, vPlace) > section.w) discard;
  vec3 toEye = normalize(cameraPosition - vPlace);
  if (!gl_FrontFacing) {
    float stripe = smoothstep(0.35, 0.5, abs(fract((vPlace.x + vPlace.y + vPlace.z) * 1.2) - 0.5));
    color = vec4(own * mix(0.22, 0.3, stripe), 1.0);
    return;
  }
  vec3 n = normalize(vNormal);
  float key = max(dot(n, keyLight), 0.0);
  float head = max(dot(n, toEye), 0.0);
  float sky = 0.5 + 0.5 * n.z;
  vec3 halfway = normalize(keyLight + toEye);
  float gloss = 0.10 * pow(max(dot(n, halfway), 0.0), 40.0);
  color = vec4(own * (0.16 + 0.14 * sky + 0.52 * key + 0.26 * head * head) + gloss, 1.0);
}`;

export const toMatrix = (X: Pose): three.Matrix4 => {
  const R = X.rotation, t = X.translation;
  return new three.Matrix4().set(
    R[0], R[1], R[2], 1e3 * t[0], R[3], R[4], R[5], 1e3 * t[1], R[6], R[7], R[8], 1e3 * t[2], 0, 0, 0, 1);
};

const toLinear = (c: number) => (c / 255) ** 2.2;

export class Workpiece {
  readonly group = new three.Group();
  readonly bounds = new three.Box3();
  triangles = 0;
  uploaded = 0; // bytes
  private pages = new Map<string, three.Mesh>();
  private X_WV = new three.Matrix4();
  private voxel = 1; // mm
  private heat = new HeatColors();
  private material = new three.ShaderMaterial({
    glslVersion: three.GLSL3, vertexShader, fragmentShader, side: three.DoubleSide,
    uniforms: {
      colors: { value: Array.from({ length: 16 }, () => new three.Vector3(0.8, 0.8, 0.8)) },
      section: { value: new three.Vector4(0, 0, 0, 1) },
      keyLight: { value: new three.Vector3(0.3, 0.5, 0.8).normalize() },
      ...this.heat.uniforms,
    },
  });

  begin(hello: Hello) {
    this.clear();
    this.heat.uniforms.showsHeat.value = false;
    const h = (this.voxel = hello.voxelSize * 1e3);
    this.X_WV = toMatrix(hello.X_WV).multiply(new three.Matrix4().makeScale(h, h, h));
    const colors = this.material.uniforms.colors.value as three.Vector3[];
    hello.materials.slice(0, 15).forEach((material, n) =>
      colors[n + 1].set(toLinear(material.color[0]), toLinear(material.color[1]), toLinear(material.color[2])));
  }

  clear() {
    for (const mesh of this.pages.values()) mesh.geometry.dispose();
    this.pages.clear();
    this.group.clear();
    this.bounds.makeEmpty();
    this.triangles = 0;
  }

  put(page: SurfacePage) {
    const name = page.origin.join();
    const old = this.pages.get(name);
    if (old) {
      this.triangles -= (old.geometry.index?.count ?? 0) / 3;
      this.group.remove(old);
      old.geometry.dispose();
      this.pages.delete(name);
    }
    if (page.indices.length === 0) return;
    const mesh = new three.Mesh(geometryOf(page), this.material);
    mesh.matrixAutoUpdate = false;
    mesh.matrix.copy(this.X_WV).multiply(new three.Matrix4().makeTranslation(...page.origin))
      .multiply(new three.Matrix4().makeScale(1 / kSteps, 1 / kSteps, 1 / kSteps));
    mesh.updateMatrixWorld(true);
    this.group.add(mesh);
    this.pages.set(name, mesh);
    this.triangles += page.indices.length / 3;
    this.uploaded += page.vertices.byteLength + page.indices.byteLength;
    this.bounds.union(mesh.geometry.boundingBox!.clone().applyMatrix4(mesh.matrixWorld));
  }

  /** Colours the surface by temperature, or not if there are no cells. */
  warm(heat: Heat) { this.heat.use(heat, toMatrix(heat.X_WC)); }

  get draws() { return this.pages.size; }

  /** Sets the section plane: points with normal . p > offset [mm] are not drawn. */
  cutAt(normal: three.Vector3 | null, offset: number) {
    (this.material.uniforms.section.value as three.Vector4)
      .set(normal?.x ?? 0, normal?.y ?? 0, normal?.z ?? 0, normal ? offset : 1);
  }
  /** [mm] The distance from a point to the drawn surface, minus a voxel, because only corners are checked. */
  clearance(point: three.Vector3): number {
    const near = this.group.children.map((child) => {
      const { geometry, matrixWorld } = child as three.Mesh;
      return { geometry, matrixWorld, away: geometry.boundingBox!.clone().applyMatrix4(matrixWorld).distanceToPoint(point) };
    }).sort((a, b) => a.away - b.away);
    const section = this.material.uniforms.section.value as three.Vector4, corner = new three.Vector3();
    const plane = new three.Vector3(section.x, section.y, section.z);
    let min = Infinity;
    for (const { geometry, matrixWorld, away } of near) {
      if (away >= min) break;
      const data = geometry.getAttribute("position");
      for (let n = 0; n < data.count; ++n) {
        const away = corner.fromBufferAttribute(data, n).applyMatrix4(matrixWorld).distanceTo(point);
        if (away < min && plane.dot(corner) <= section.w) min = away;
      }
    }
    return min - this.voxel;
  }

  isInside(point: three.Vector3, along: three.Vector3): boolean {
    const found = this.first(new three.Ray(point, along));
    return found !== undefined && found.face!.normal.clone().transformDirection(found.object.matrixWorld).dot(along) > 0;
  }

  lightFrom(direction: three.Vector3) { this.material.uniforms.keyLight.value.copy(direction); }

  /** [m] The point where a ray of the scene meets the surface, with a mean normal of its surroundings. */
  hit(ray: three.Ray): { point: Vec3; normal: Vec3 } | null {
    const found = this.first(ray);
    if (!found) return null;
    const mesh = found.object as three.Mesh;
    const normal = smoothNormal(mesh.geometry, [found.face!.a, found.face!.b, found.face!.c])
      .transformDirection(this.X_WV);
    const p = found.point;
    return { point: [p.x / 1e3, p.y / 1e3, p.z / 1e3], normal: [normal.x, normal.y, normal.z] };
  }

  /** The first intersection of a ray with the drawn surface. */
  private first(ray: three.Ray): three.Intersection | undefined {
    const section = this.material.uniforms.section.value as three.Vector4;
    const plane = new three.Vector3(section.x, section.y, section.z);
    return new three.Raycaster(ray.origin, ray.direction).intersectObjects(this.group.children, false)
      .find((one) => plane.dot(one.point) <= section.w && one.face !== null);
  }
}

function geometryOf(page: SurfacePage): three.BufferGeometry {
  const geometry = new three.BufferGeometry();
  const buffer = new three.InterleavedBuffer(page.vertices, 6);
  geometry.setAttribute("position", new three.InterleavedBufferAttribute(buffer, 3, 0));
  geometry.setAttribute("extra", new three.InterleavedBufferAttribute(buffer, 3, 3));
  geometry.setIndex(new three.BufferAttribute(page.indices, 1));
  const low = new three.Vector3(Infinity, Infinity, Infinity), high = low.clone().negate();
  const corner = new three.Vector3();
  for (let n = 0; n < page.vertices.length; n += 6) {
    corner.set(page.vertices[n], page.vertices[n + 1], page.vertices[n + 2]);
    low.min(corner);
    high.max(corner);
  }
  geometry.boundingBox = new three.Box3(low, high);
  geometry.boundingSphere = geometry.boundingBox.getBoundingSphere(new three.Sphere());
  return geometry;
}

/** The mean of the normals within 2.7 voxels of a triangle, in V. */
function smoothNormal(geometry: three.BufferGeometry, face: number[]): three.Vector3 {
  const data = (geometry.getAttribute("position") as three.InterleavedBufferAttribute).data.array as Int16Array;
  const bytes = new Int8Array(data.buffer, data.byteOffset, data.byteLength);
  const at = face[0] * 6, reach = (kEdge / 12) * kSteps;
  const sum = new three.Vector3();
  for (let n = 0; n < data.length; n += 6) {
    const dx = data[n] - data[at], dy = data[n + 1] - data[at + 1], dz = data[n + 2] - data[at + 2];
    if (dx * dx + dy * dy + dz * dz > reach * reach) continue;
    sum.x += bytes[2 * n + 8];
    sum.y += bytes[2 * n + 9];
    sum.z += bytes[2 * n + 10];
  }
  return sum.lengthSq() > 0 ? sum.normalize() : new three.Vector3(0, 0, 1);
}
