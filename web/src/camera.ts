// SPDX-License-Identifier: Apache-2.0
// The eye: orbit, pan, zoom, and the named views of a dentist.
import * as three from "three";

export const kViews: Record<string, [number, number, number]> = {
  "three-quarter": [0.7, -0.75, 0.75],
  "top": [0, -0.02, 1],
  "bottom": [0, 0.02, -1],
  "front": [0, -1, 0.02],
  "back": [0, 1, 0.02],
  "left": [-1, 0, 0.02],
  "right": [1, 0, 0.02],
};

export class Eye {
  readonly camera = new three.PerspectiveCamera(32, 1, 0.5, 2000);
  readonly target = new three.Vector3();
  distance = 60;
  private azimuth = -0.8; // from +x, about z
  private elevation = 0.6;
  changed = true;

  look(name: string) {
    const [x, y, z] = kViews[name] ?? kViews["three-quarter"];
    this.lookAlong(new three.Vector3(x, y, z));
  }

  /** From a direction, towards the target. */
  lookAlong(direction: three.Vector3) {
    const d = direction.clone().normalize();
    this.elevation = Math.asin(Math.max(-1, Math.min(1, d.z)));
    this.azimuth = Math.atan2(d.y, d.x);
    this.changed = true;
  }

  frame(box: three.Box3) {
    const ball = box.getBoundingSphere(new three.Sphere());
    this.target.copy(ball.center);
    this.distance = (1.02 * ball.radius) / Math.sin(((this.camera.fov / 2) * Math.PI) / 180);
    this.changed = true;
  }

  orbit(dx: number, dy: number) {
    this.azimuth -= dx;
    this.elevation = Math.max(-1.55, Math.min(1.55, this.elevation + dy));
    this.changed = true;
  }

  /** By shares of the height of the picture. */
  pan(dx: number, dy: number) {
    const height = 2 * this.distance * Math.tan((this.camera.fov * Math.PI) / 360);
    this.target.addScaledVector(this.right, -dx * height).addScaledVector(this.up, dy * height);
    this.changed = true;
  }

  zoom(factor: number) {
    this.distance = Math.max(2, Math.min(1500, this.distance * factor));
    this.changed = true;
  }

  get back(): three.Vector3 {
    const c = Math.cos(this.elevation);
    return new three.Vector3(c * Math.cos(this.azimuth), c * Math.sin(this.azimuth), Math.sin(this.elevation));
  }
  get right(): three.Vector3 { return new three.Vector3(-Math.sin(this.azimuth), Math.cos(this.azimuth), 0); }
  get up(): three.Vector3 { return this.back.cross(this.right); }

  update(aspect: number) {
    this.camera.aspect = aspect;
    this.camera.near = Math.max(0.2, this.distance / 60);
    this.camera.far = this.distance * 12 + 300;
    this.camera.up.set(0, 0, 1);
    this.camera.position.copy(this.target).addScaledVector(this.back, this.distance);
    this.camera.lookAt(this.target);
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld(true);
  }

  /** A ray of the scene through a place of the picture, -1 ... 1. */
  ray(x: number, y: number): three.Ray {
    const caster = new three.Raycaster();
    caster.setFromCamera(new three.Vector2(x, y), this.camera);
    return caster.ray;
  }
}
