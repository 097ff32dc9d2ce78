// SPDX-License-Identifier: Apache-2.0
// The tool: its head with cutting and smooth edges in two colours, shank and handle, a ghost at the set point of the
// hand, and the arrow of the force. Units of the scene are mm.
import * as three from "three";
import { outline } from "./outline.ts";
import type { Pose, Snapshot, Tool } from "./protocol.ts";
import { toMatrix } from "./scene.ts";

const kCutting = 0xd9a441, kSmooth = 0x9aa4ad, kHandle = 0x8895a1, kGhost = 0x3fa7ff;

function lathe(points: [number, number][], material: three.Material): three.Mesh {
  const profile = points.map(([rho, z]) => new three.Vector2(1e3 * rho, 1e3 * z));
  const geometry = new three.LatheGeometry(profile, 40).rotateX(Math.PI / 2).scale(1, -1, 1);
  return new three.Mesh(flipped(geometry), material);
}

/** Reverses the triangles, because mirroring inverts their orientation. */
function flipped(geometry: three.BufferGeometry): three.BufferGeometry {
  const index = geometry.index!;
  for (let n = 0; n < index.count; n += 3) {
    const a = index.getX(n);
    index.setX(n, index.getX(n + 1));
    index.setX(n + 1, a);
  }
  geometry.computeVertexNormals();
  return geometry;
}

function rod(from: three.Vector3, to: three.Vector3, radius: number, material: three.Material): three.Mesh {
  const along = to.clone().sub(from), length = Math.max(along.length(), 1e-3);
  const mesh = new three.Mesh(new three.CylinderGeometry(radius, radius, length, 20), material);
  mesh.position.copy(from).addScaledVector(along, 0.5);
  mesh.quaternion.setFromUnitVectors(new three.Vector3(0, 1, 0), along.normalize());
  return mesh;
}

const metal = (color: number, roughness: number) =>
  new three.MeshStandardMaterial({ color, roughness, metalness: 0.08, side: three.DoubleSide });

export class ToolView {
  readonly group = new three.Group(); // at X_WT
  readonly ghost = new three.Group(); // at X_WG
  readonly arrow = new three.ArrowHelper(new three.Vector3(0, 0, 1), new three.Vector3(), 1, 0xff5470);
  showHandle = true;
  tip = 0;
  reach = 1; // mm
  private spin = new three.Group();
  private handle = new three.Group();
  private thread = new three.Line(
    new three.BufferGeometry().setFromPoints([new three.Vector3(), new three.Vector3()]),
    new three.LineBasicMaterial({ color: kGhost }));

  constructor(readonly scene: three.Scene) {
    this.group.matrixAutoUpdate = this.ghost.matrixAutoUpdate = false;
    this.group.add(this.spin, this.handle);
    this.group.visible = this.ghost.visible = this.arrow.visible = this.thread.visible = false;
    this.thread.frustumCulled = false;
    scene.add(this.group, this.ghost, this.arrow, this.thread);
  }

  use(tool: Tool) {
    this.spin.clear();
    this.handle.clear();
    this.ghost.clear();
    this.tip = tool.tip;
    const cutting = metal(kCutting, 0.45), smooth = metal(kSmooth, 0.35), grip = metal(kHandle, 0.55);
    const ghost = new three.MeshBasicMaterial({ color: kGhost, transparent: true, opacity: 0.3, depthWrite: false });
    let top = tool.tip, maxRadius = 0;
    for (const stretch of outline(tool.tip, tool.edges)) {
      this.spin.add(lathe(stretch.points, stretch.cutting ? cutting : smooth));
      this.ghost.add(lathe(stretch.points, ghost));
      for (const [rho, z] of stretch.points) {
        top = Math.max(top, z);
        maxRadius = Math.max(maxRadius, rho);
      }
    }
    this.reach = 1e3 * Math.max(maxRadius, top - tool.tip);
    this.addFlutes(tool);
    this.addHandle(tool, 1e3 * top, 1e3 * maxRadius, smooth, grip);
    this.group.visible = true;
  }

  /** Adds blades as dark lines, so that the rotation is visible. */
  private addFlutes(tool: Tool) {
    const material = new three.LineBasicMaterial({ color: 0x5a4010 });
    const points = outline(tool.tip, tool.edges).filter((one) => one.cutting).flatMap((one) => one.points);
    for (let blade = 0; blade < 6; ++blade) {
      const line = points.map(([rho, z], n) => {
        const angle = (blade * Math.PI) / 3 + (0.9 * n) / Math.max(1, points.length);
        return new three.Vector3(1010 * rho * Math.cos(angle), 1010 * rho * Math.sin(angle), 1e3 * z);
      });
      this.spin.add(new three.Line(new three.BufferGeometry().setFromPoints(line), material));
    }
  }

  private addHandle(tool: Tool, top: number, maxRadius: number, smooth: three.Material, grip: three.Material) {
    const X_TH = toMatrix(tool.X_HT).invert();
    const hand = new three.Vector3().applyMatrix4(X_TH);
    const shank = Math.max(0.25, Math.min(maxRadius * 0.55, 1.2));
    const up = new three.Vector3(0, 0, 1);
    const elbow = tool.angled ? up.clone().multiplyScalar(1e3 * tool.neck) : hand;
    const neck = Math.min(elbow.length(), top + 9);
    if (neck > top)
      this.handle.add(rod(up.clone().multiplyScalar(top), up.clone().multiplyScalar(neck), shank, smooth));
    if (!tool.angled) {
      if (hand.length() > neck) this.handle.add(rod(up.clone().multiplyScalar(neck), hand, Math.max(1.9, shank), grip));
      return;
    }
    if (elbow.length() > neck) this.handle.add(rod(up.clone().multiplyScalar(neck), elbow, Math.max(1.5, shank), grip));
    const corner = new three.Mesh(new three.SphereGeometry(2.6, 20, 14), grip);
    corner.position.copy(elbow);
    this.handle.add(corner, rod(elbow, hand, 2.4, grip));
  }

  /** Places tool, ghost and arrow. The spindle is shown slower than it runs. */
  place(snapshot: Snapshot, X_WG: Pose | null, seconds: number) {
    const { X_WT, force, speed } = snapshot;
    this.group.matrix.copy(toMatrix(X_WT));
    this.handle.visible = this.showHandle;
    this.spin.rotation.z += Math.sign(speed) * Math.min(Math.abs(speed) / 400, 18) * seconds;
    const at = new three.Vector3().setFromMatrixPosition(this.group.matrix);
    if (X_WG) {
      this.ghost.matrix.copy(toMatrix(X_WG));
      const wanted = new three.Vector3().setFromMatrixPosition(this.ghost.matrix);
      const apart = wanted.distanceTo(at) > 0.05;
      this.ghost.visible = this.thread.visible = apart;
      this.thread.geometry.setFromPoints([at, wanted]);
    }
    const size = Math.hypot(...force);
    this.arrow.visible = size > 0.02;
    if (!this.arrow.visible) return;
    if (snapshot.voxels > 0) this.arrow.position.set(...snapshot.point).multiplyScalar(1e3);
    else this.arrow.position.copy(at);
    this.arrow.setDirection(new three.Vector3(...force).normalize());
    const long = this.reach * Math.min(3.5, 0.6 + 0.9 * Math.sqrt(size));
    this.arrow.setLength(long, Math.min(0.3 * long, 2), Math.min(0.16 * long, 1));
  }
}
