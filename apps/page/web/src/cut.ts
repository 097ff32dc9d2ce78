// SPDX-License-Identifier: Apache-2.0
// Which materials the tool cuts, as shares of the force, and what is under its tip.
import type { Hello, Instruments } from "./protocol.ts";

const kFelt = 0.01; // N: below this sum nothing is cut
const kShown = 0.005; // smaller shares are not named

export interface Share {
  name: string;
  color: number[];
  part: number; // of the force
}

/** The materials that are cut, the largest share first; empty while nothing is cut. */
export function sharesOf(materials: Hello["materials"], forces: number[]): Share[] {
  const sum = forces.reduce((a, b) => a + b, 0);
  if (sum < kFelt) return [];
  return forces.map((force, n) => ({ name: nameOf(materials, n + 1), color: materials[n]?.color ?? [0, 0, 0], part: force / sum }))
    .filter(({ part }) => part >= kShown).sort((a, b) => b.part - a.part);
}

/** "enamel 70 % · dentin 30 %"; without a cut, the material under the tip, or "nothing". */
export function textOfCut(materials: Hello["materials"], { forces, under }: Pick<Instruments, "forces" | "under">): string {
  const shares = sharesOf(materials, forces);
  if (shares.length > 0) return shares.map(({ name, part }) => `${name} ${Math.round(100 * part)} %`).join(" · ");
  return under === 0 ? "nothing" : nameOf(materials, under);
}

const nameOf = (materials: Hello["materials"], id: number) => (materials[id - 1]?.name ?? `material ${id}`).replaceAll("_", " ");
