// SPDX-License-Identifier: Apache-2.0
// Vectors and poses, without a graphics library.
import type { Pose, Vec3 } from "./protocol.ts";

export const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (s: number, a: Vec3): Vec3 => [s * a[0], s * a[1], s * a[2]];
export const dot = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec3, b: Vec3): Vec3 =>
  [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const length = (a: Vec3) => Math.hypot(a[0], a[1], a[2]);
export const normalized = (a: Vec3): Vec3 => scale(1 / (length(a) || 1), a);

export function multiply(a: Pose, b: Pose): Pose {
  const rotation = Array.from({ length: 9 }, (_, n) => {
    const row = 3 * Math.floor(n / 3), column = n % 3;
    return a.rotation[row] * b.rotation[column] + a.rotation[row + 1] * b.rotation[3 + column] +
      a.rotation[row + 2] * b.rotation[6 + column];
  });
  return { rotation, translation: transform(a, b.translation) };
}

export const rotate = (R: number[], p: Vec3): Vec3 => [
  R[0] * p[0] + R[1] * p[1] + R[2] * p[2],
  R[3] * p[0] + R[4] * p[1] + R[5] * p[2],
  R[6] * p[0] + R[7] * p[1] + R[8] * p[2],
];

export const transform = (X: Pose, p: Vec3): Vec3 => add(rotate(X.rotation, p), X.translation);

export function inverse(X: Pose): Pose {
  const R = X.rotation;
  const rotation = [R[0], R[3], R[6], R[1], R[4], R[7], R[2], R[5], R[8]];
  return { rotation, translation: scale(-1, rotate(rotation, X.translation)) };
}

/** A rotation about a unit vector (Rodrigues). */
export function rotationAbout(axis: Vec3, angle: number): number[] {
  const [x, y, z] = axis, c = Math.cos(angle), s = Math.sin(angle), t = 1 - c;
  return [
    t * x * x + c, t * x * y - s * z, t * x * z + s * y,
    t * x * y + s * z, t * y * y + c, t * y * z - s * x,
    t * x * z - s * y, t * y * z + s * x, t * z * z + c,
  ];
}

/** The axes of a frame as columns. */
export const fromAxes = (x: Vec3, y: Vec3, z: Vec3): number[] =>
  [x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]];
export const axisOf = (R: number[], column: number): Vec3 => [R[column], R[3 + column], R[6 + column]];

export interface Ray {
  from: Vec3;
  along: Vec3;
}

/** Where a ray meets the plane through `point`; null if the ray is parallel to the plane or points away from it. */
export function meet(ray: Ray, point: Vec3, normal: Vec3): Vec3 | null {
  const slope = dot(ray.along, normal);
  if (Math.abs(slope) < 1e-3) return null;
  const distance = dot(subtract(point, ray.from), normal) / slope;
  return distance > 0 ? add(ray.from, scale(distance, ray.along)) : null;
}

export interface Frustum {
  left: number;
  right: number;
  top: number;
  bottom: number;
  near: number;
  far: number;
}

/**
 * The frustum of an eye beside the middle, for a screen at the distance of convergence (thesis 6.2.4). Both eyes look
 * straight ahead and the frusta are sheared, so that there is no rotation and no vertical parallax.
 * @param eye  distance of the eye to the right of the middle; negative: to the left
 */
export function offAxisFrustum(fovY: number, aspect: number, near: number, far: number, eye: number,
                               convergence: number): Frustum {
  const top = near * Math.tan(fovY / 2), half = top * aspect, shift = (eye * near) / convergence;
  return { left: -half - shift, right: half - shift, top, bottom: -top, near, far };
}
