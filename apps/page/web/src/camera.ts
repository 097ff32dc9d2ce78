// SPDX-License-Identifier: Apache-2.0
// The eye: orbit, pan, zoom, and the named views of a dentist. It stays outside the drawn surface.
import * as three from "three";

/** The drawn surface, in mm. */
export interface Ground {
  hit(ray: three.Ray): { point: number[] } | null; // [m]
  /** [mm] A lower bound of the distance from a point to the surface. */
  clearance(point: three.Vector3): number;
  /** Whether the first surface along a direction is seen from behind. */
  isInside(point: three.Vector3, along: three.Vector3): boolean;
}

const kMinDistance = 0.5, kMaxDistance = 1500; // mm, from the eye to its target

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

  /** Looks from a direction towards the target. */
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

  /** Pans by fractions of the height of the picture. */
  pan(dx: number, dy: number) {
    const height = 2 * this.distance * Math.tan((this.camera.fov * Math.PI) / 360);
    this.target.addScaledVector(this.right, -dx * height).addScaledVector(this.up, dy * height);
    this.stayOutside();
  }

  /** Zooms so that the point of the scene at (x, y), each -1 ... 1, stays there. The eye stops before the surface. */
  zoom(factor: number, x = 0, y = 0) {
    const ray = this.ray(x, y), hit = this.ground.hit(ray);
    const about = hit ? new three.Vector3(...hit.point).multiplyScalar(1e3)
      : ray.intersectPlane(new three.Plane().setFromNormalAndCoplanarPoint(this.back, this.target), new three.Vector3());
    if (!about) return;
    let by = Math.max(kMinDistance / this.distance, Math.min(kMaxDistance / this.distance, factor));
    if (by < 1) by = this.freeFraction(about, by);
    this.target.sub(about).multiplyScalar(by).add(about);
    this.distance *= by;
    if (by > 1) this.stayOutside();
    this.changed = true;
  }

  /** The remaining fraction of the distance to a point after moving towards it as far as the surface allows. */
  private freeFraction(about: three.Vector3, factor: number): number {
    const at = this.position, direction = about.clone().sub(at), total = direction.length();
    direction.normalize();
    let left = total;
    for (let n = 0; n < 32 && left > factor * total; ++n) {
      const step = Math.min(left - factor * total, this.ground.clearance(at) - this.room);
      if (step <= 1e-3) break;
      at.addScaledVector(direction, step);
      left -= step;
    }
    return left / total;
  }

  /** Moves back until the eye is outside. */
  private stayOutside() {
    const isBad = (at: three.Vector3) => this.ground.clearance(at) < this.room || this.ground.isInside(at, this.back);
    for (let n = 0; n < 80 && this.distance < kMaxDistance && isBad(this.position); ++n) this.distance *= 1.05;
    this.changed = true;
  }

  private get near(): number { return Math.max(0.2, this.distance / 60); }
  /** The free distance that the eye needs: the corners of the near plane are farther away than the plane. */
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

  /** The ray of the scene through a point of the picture, each coordinate -1 ... 1. */
  ray(x: number, y: number, through: (camera: three.PerspectiveCamera) => three.PerspectiveCamera = (camera) => camera): three.Ray {
    this.update(this.camera.aspect);
    const caster = new three.Raycaster();
    caster.setFromCamera(new three.Vector2(x, y), through(this.camera));
    return caster.ray;
  }
}
