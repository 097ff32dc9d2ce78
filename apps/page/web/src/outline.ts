// SPDX-License-Identifier: Apache-2.0
// The meridian of a head as points: a line has two points, an arc has many.
import type { ToolEdge } from "./protocol.ts";

export interface Stretch {
  cutting: boolean;
  points: [number, number][]; // rho, z [m]
}

/** @param edges  radius 0: straight; > 0: a convex arc; < 0: a concave arc; at most a half circle */
export function outline(tip: number, edges: ToolEdge[], perArc = 16): Stretch[] {
  let from: [number, number] = [0, tip];
  return edges.map(({ rho, z, radius, cutting }) => {
    const points: [number, number][] = [from];
    const to: [number, number] = [rho, z];
    if (radius !== 0) points.push(...arc(from, to, radius, perArc));
    points.push(to);
    from = to;
    return { cutting, points };
  });
}

function arc(a: [number, number], b: [number, number], radius: number, count: number): [number, number][] {
  const dx = b[0] - a[0], dz = b[1] - a[1], chord = Math.hypot(dx, dz);
  const r = Math.max(Math.abs(radius), chord / 2);
  const back = Math.sqrt(Math.max(0, r * r - (chord * chord) / 4));
  // The body is to the left of the path. The centre of a convex arc is on that side.
  const side = Math.sign(radius);
  const center = [(a[0] + b[0]) / 2 - (side * back * dz) / chord, (a[1] + b[1]) / 2 + (side * back * dx) / chord];
  const begin = Math.atan2(a[1] - center[1], a[0] - center[0]);
  let sweep = Math.atan2(b[1] - center[1], b[0] - center[0]) - begin;
  while (sweep * side < 0) sweep += side * 2 * Math.PI;
  return Array.from({ length: count - 1 }, (_, n) => {
    const angle = begin + (sweep * (n + 1)) / count;
    return [Math.max(0, center[0] + r * Math.cos(angle)), center[1] + r * Math.sin(angle)];
  });
}
