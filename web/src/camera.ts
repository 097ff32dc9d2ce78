// SPDX-License-Identifier: Apache-2.0
// The eye: orbit, pan, zoom, and the named views of a dentist. It stays outside of what is drawn.
import * as three from "three";

/** What is drawn, in mm. */
export interface Ground {
  hit(ray: three.Ray): { point: number[] } | null; // [m]
  /** [mm] from a point to the surface, never more than it is. */
  clearance(point: three.Vector3): number;
  /** Whether the first that is met from a point along a direction is seen from behind. */
  isInside(point: three.Vector3, along: three.Vector3): boolean;
}

const kLeast = 0.5, kMost = 1500; // mm from the eye to what it turns about

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

  constructor(private ground: Ground) {}

  look(name: string) {
    const [x, y, z] = kViews[name] ?? kViews["three-quarter"];
    this.lookAlong(new three.Vector3(x, y, z));
  }

  /** From a direction, towards the target. */
  lookAlong(direction: three.Vector3) {
    const d = direction.clone().normalize();
    this.elevation = Math.asin(Math.max(-1, Math.min(1, d.z)));
    this.azimuth = Math.atan2(d.y, d.x);
    this.stayOutside();
  }

  frame(box: three.Box3) {
    const ball = box.getBoundingSphere(new three.Sphere());
    this.target.copy(ball.center);
    const half = Math.tan((this.camera.fov * Math.PI) / 360) * Math.min(1, this.camera.aspect);
    this.distance = (1.02 * ball.radius) / Math.sin(Math.atan(half));
    this.changed = true;
  }

  orbit(dx: number, dy: number) {
    this.azimuth -= dx;
    this.elevation = Math.max(-1.55, Math.min(1.55, this.elevation + dy));
    this.stayOutside();
  }

  /** By shares of the height of the picture. */
  pan(dx: number, dy: number) {
    const height = 2 * this.distance * Math.tan((this.camera.fov * Math.PI) / 360);
    this.target.addScaledVector(this.right, -dx * height).addScaledVector(this.up, dy * height);
    this.stayOutside();
  }

  /** What is seen at a place of the picture, -1 ... 1, stays there; the eye stops before the surface. */
  zoom(factor: number, x = 0, y = 0) {
    const ray = this.ray(x, y), hit = this.ground.hit(ray);
    const about = hit ? new three.Vector3(...hit.point).multiplyScalar(1e3)
      : ray.intersectPlane(new three.Plane().setFromNormalAndCoplanarPoint(this.back, this.target), new three.Vector3());
    if (!about) return;
    let by = Math.max(kLeast / this.distance, Math.min(kMost / this.distance, factor));
    if (by < 1) by = this.nearer(about, by);
    this.target.sub(about).multiplyScalar(by).add(about);
    this.distance *= by;
    if (by > 1) this.stayOutside();
    this.changed = true;
  }

  /** How much of a way to a point is free, as what is left of it: in steps as long as nothing can be in their way. */
  private nearer(about: three.Vector3, factor: number): number {
    const at = this.position, way = about.clone().sub(at), whole = way.length();
    way.normalize();
    let left = whole;
    for (let n = 0; n < 32 && left > factor * whole; ++n) {
      const step = Math.min(left - factor * whole, this.ground.clearance(at) - this.room);
      if (step <= 1e-3) break;
      at.addScaledVector(way, step);
      left -= step;
    }
    return left / whole;
  }

  /** Goes back as far as it must. */
  private stayOutside() {
    const isBad = (at: three.Vector3) => this.ground.clearance(at) < this.room || this.ground.isInside(at, this.back);
    for (let n = 0; n < 80 && this.distance < kMost && isBad(this.position); ++n) this.distance *= 1.05;
    this.changed = true;
  }

  private get near(): number { return Math.max(0.2, this.distance / 60); }
  /** Before the eye: the corners of the near plane are farther away than it is. */
  private get room(): number { return 2 * this.near; }
  private get position(): three.Vector3 { return this.target.clone().addScaledVector(this.back, this.distance); }

  get back(): three.Vector3 {
    const c = Math.cos(this.elevation);
    return new three.Vector3(c * Math.cos(this.azimuth), c * Math.sin(this.azimuth), Math.sin(this.elevation));
  }
  get right(): three.Vector3 { return new three.Vector3(-Math.sin(this.azimuth), Math.cos(this.azimuth), 0); }
  get up(): three.Vector3 { return this.back.cross(this.right); }

  update(aspect: number) {
    this.camera.aspect = aspect;
    this.camera.near = this.near;
    this.camera.far = this.distance * 12 + 300;
    this.camera.up.set(0, 0, 1);
    this.camera.position.copy(this.position);
    this.camera.lookAt(this.target);
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld(true);
  }

  /** A ray of the scene through a place of the picture, -1 ... 1. */
  ray(x: number, y: number, through: (camera: three.PerspectiveCamera) => three.PerspectiveCamera = (camera) => camera): three.Ray {
    this.update(this.camera.aspect);
    const caster = new three.Raycaster();
    caster.setFromCamera(new three.Vector2(x, y), through(this.camera));
    return caster.ray;
  }
}
