// SPDX-License-Identifier: Apache-2.0
// Maps the pointer to the tool. The tool hovers over the surface. When pressed, it works in the tangent plane of the
// point where it was pressed, so that removed material does not pull the tool along.
import {
  add, axisOf, cross, dot, fromAxes, inverse, meet, multiply, normalized, type Ray, rotate, rotationAbout, scale,
} from "./geometry.ts";
import { identity, type Pose, type Vec3 } from "./protocol.ts";

export interface Hit {
  point: Vec3;
  normal: Vec3;
}

export const kHover = 1e-3; // [m] height of the tip above the surface
export const kWheelStep = 0.1e-3; // [m] depth per notch

/** The rotation with z along `axis` and with x as close as possible to that of `before`. */
export function rotatedTo(before: number[], axis: Vec3): number[] {
  const z = normalized(axis);
  const x0 = axisOf(before, 0);
  let x = add(x0, scale(-dot(x0, z), z));
  if (dot(x, x) < 1e-6) {
    const y0 = axisOf(before, 1);
    x = add(y0, scale(-dot(y0, z), z));
  }
  x = normalized(x);
  return fromAxes(x, cross(z, x), z);
}

export class Hand {
  /** [m] Depth of the tip below the plane while it is pressed. */
  depth = 0.5e-3;
  /** Whether the axis of the tool follows the normal of the surface. */
  follow = false;
  pressed = false;
  private R_WT: number[] = identity.rotation;
  private X_HT: Pose = identity;
  private tip: Vec3 = [0, 0, 0]; // position of the tool's tip, in W
  private tipHeight = 0; // z of the tip in T
  private plane: Hit | null = null;
  private lift = 0;

  begin(X_WT: Pose) {
    this.R_WT = X_WT.rotation;
    this.tip = add(X_WT.translation, scale(this.tipHeight, axisOf(this.R_WT, 2)));
    this.pressed = false;
    this.plane = null;
  }

  useTool(X_HT: Pose, tipHeight: number) {
    this.X_HT = X_HT;
    this.tipHeight = tipHeight;
  }

  /** [m] The position of the tip, in W. */
  get place(): Vec3 { return this.tip; }
  get axis(): Vec3 { return axisOf(this.R_WT, 2); }

  /** Presses at the surface under the pointer. */
  press(hit: Hit | null) {
    this.pressed = true;
    this.lift = 0;
    this.plane = hit ?? { point: this.tip, normal: this.axis };
    this.rotateTo(hit);
    this.tip = this.below(this.plane.point);
  }

  release() {
    if (!this.pressed) return;
    this.pressed = false;
    if (this.plane) this.tip = add(this.tip, scale(this.depth + kHover, this.plane.normal));
    this.plane = null;
  }

  /** Handles a move of the pointer. */
  point(ray: Ray, hit: Hit | null, facing: Vec3) {
    if (this.pressed && this.plane) {
      const on = meet(ray, this.plane.point, this.plane.normal);
      if (on) this.tip = this.below(on);
      return;
    }
    this.rotateTo(hit);
    if (hit) {
      this.tip = add(hit.point, scale(kHover + this.lift, hit.normal));
    } else {
      this.tip = meet(ray, this.tip, facing) ?? this.tip;
    }
  }

  /** Increases the depth by notches of the wheel, at once if pressed. */
  push(notches: number) {
    const by = Math.max(-this.depth, notches * kWheelStep);
    this.depth += by;
    if (this.plane) this.tip = add(this.tip, scale(-by, this.plane.normal));
  }

  /** Moves the tip by a vector in W, for keys and gamepads. */
  move(by: Vec3) { this.tip = add(this.tip, by); }

  /** Tilts the tool about an axis in W; its tip stays. */
  tilt(about: Vec3, angle: number) {
    const R = rotationAbout(normalized(about), angle);
    const columns = [0, 1, 2].map((n) => rotate(R, axisOf(this.R_WT, n)));
    this.R_WT = fromAxes(columns[0], columns[1], columns[2]);
  }

  upright(axis: Vec3) { this.R_WT = rotatedTo(this.R_WT, axis); }

  get X_WT(): Pose {
    return { rotation: this.R_WT, translation: add(this.tip, scale(-this.tipHeight, this.axis)) };
  }
  get X_WH(): Pose { return multiply(this.X_WT, inverse(this.X_HT)); }

  private rotateTo(hit: Hit | null) {
    if (this.follow && hit) this.R_WT = rotatedTo(this.R_WT, hit.normal);
  }
  private below(point: Vec3): Vec3 {
    return this.plane ? add(point, scale(-this.depth, this.plane.normal)) : point;
  }
}
