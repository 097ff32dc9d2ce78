// SPDX-License-Identifier: Apache-2.0
// From the pointer to the tool: over the surface it hovers, pressed it works in the tangent plane of where it was
// pressed, so that the material that leaves does not pull the tool after it.
import {
  add, axisOf, cross, dot, fromAxes, inverse, meet, multiply, normalized, type Ray, rotate, rotationAbout, scale,
} from "./geometry.ts";
import { identity, type Pose, type Vec3 } from "./protocol.ts";

export interface Hit {
  point: Vec3;
  normal: Vec3;
}

export const kHover = 1e-3; // [m] of the tip above the surface
export const kWheelStep = 0.1e-3; // [m] of depth a notch

/** A rotation whose z is `axis` and whose x is as near to that of `before` as can be. */
export function turnedTo(before: number[], axis: Vec3): number[] {
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
  /** How deep the tip goes below the plane while it is pressed. */
  depth = 0.5e-3;
  /** The axis of the tool follows the normal of the surface. */
  follow = false;
  pressed = false;
  private R_WT: number[] = identity.rotation;
  private X_HT: Pose = identity;
  private tip: Vec3 = [0, 0, 0]; // of the tool, in W
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

  /** Of the tip, in W. */
  get place(): Vec3 { return this.tip; }
  get axis(): Vec3 { return axisOf(this.R_WT, 2); }

  /** Presses at what is under the pointer. */
  press(hit: Hit | null) {
    this.pressed = true;
    this.lift = 0;
    this.plane = hit ?? { point: this.tip, normal: this.axis };
    this.turnTo(hit);
    this.tip = this.below(this.plane.point);
  }

  release() {
    if (!this.pressed) return;
    this.pressed = false;
    if (this.plane) this.tip = add(this.tip, scale(this.depth + kHover, this.plane.normal));
    this.plane = null;
  }

  /** The pointer is somewhere else. */
  point(ray: Ray, hit: Hit | null, facing: Vec3) {
    if (this.pressed && this.plane) {
      const on = meet(ray, this.plane.point, this.plane.normal);
      if (on) this.tip = this.below(on);
      return;
    }
    this.turnTo(hit);
    if (hit) {
      this.tip = add(hit.point, scale(kHover + this.lift, hit.normal));
    } else {
      this.tip = meet(ray, this.tip, facing) ?? this.tip;
    }
  }

  /** Deeper by some notches of the wheel, at once where it is pressed. */
  push(notches: number) {
    const by = Math.max(-this.depth, notches * kWheelStep);
    this.depth += by;
    if (this.plane) this.tip = add(this.tip, scale(-by, this.plane.normal));
  }

  /** By steps of the keys or of a gamepad, in W. */
  move(by: Vec3) { this.tip = add(this.tip, by); }

  /** Leans the tool about an axis in W; its tip stays. */
  tilt(about: Vec3, angle: number) {
    const R = rotationAbout(normalized(about), angle);
    const columns = [0, 1, 2].map((n) => rotate(R, axisOf(this.R_WT, n)));
    this.R_WT = fromAxes(columns[0], columns[1], columns[2]);
  }

  upright(axis: Vec3) { this.R_WT = turnedTo(this.R_WT, axis); }

  get X_WT(): Pose {
    return { rotation: this.R_WT, translation: add(this.tip, scale(-this.tipHeight, this.axis)) };
  }
  get X_WH(): Pose { return multiply(this.X_WT, inverse(this.X_HT)); }

  private turnTo(hit: Hit | null) {
    if (this.follow && hit) this.R_WT = turnedTo(this.R_WT, hit.normal);
  }
  private below(point: Vec3): Vec3 {
    return this.plane ? add(point, scale(-this.depth, this.plane.normal)) : point;
  }
}
