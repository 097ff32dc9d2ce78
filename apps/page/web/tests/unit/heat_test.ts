// SPDX-License-Identifier: Apache-2.0
// Temperatures, shares of the force, and known ranges.
import assert from "node:assert/strict";
import { test } from "node:test";
import * as three from "three";
import { sharesOf, textOfCut } from "../../src/cut.ts";
import { colorAt, HeatColors, scaleOf, texels } from "../../src/heat.ts";
import { knownText } from "../../src/panels.ts";
import { type Control, decode, type Heat, kVersion, type Vec3 } from "../../src/protocol.ts";

const kTooth = [{ name: "enamel", color: [250, 248, 240] as Vec3 }, { name: "cortical_bone", color: [1, 2, 3] as Vec3 }];

/** The bytes of a message of heat with cells along x. */
function messageOf(cells: number[], structures: number[][]): Uint8Array {
  const bytes: number[] = [10, kVersion, 0, 0];
  const number = (size: number, set: (view: DataView) => void) => {
    const view = new DataView(new ArrayBuffer(size));
    set(view);
    bytes.push(...new Uint8Array(view.buffer));
  };
  const f64 = (value: number) => number(8, (view) => view.setFloat64(0, value, true));
  const u32 = (value: number) => number(4, (view) => view.setUint32(0, value, true));
  [1, 0, 0, 0, 1, 0, 0, 0, 1, 0.001, 0.002, 0.003, 0.0004].forEach(f64);
  [cells.length, 1, 1].forEach(u32);
  [10.25, 0.5, 37, 47].forEach(f64);
  u32(structures.length);
  structures.flat().forEach(f64);
  return Uint8Array.from([...bytes, ...cells]);
}

test("a message of heat has its cells, and the temperatures of each material", () => {
  const heat = decode(messageOf([0, 74, 255], [[52.5, 80, 3]])) as Heat;
  assert.deepEqual([heat.dims, heat.cellSize, heat.first, heat.step], [[3, 1, 1], 0.0004, 10.25, 0.5]);
  assert.deepEqual(heat.structures, [{ now: 52.5, peak: 80, timeAbove: 3 }]);
  assert.deepEqual([...heat.cells], [0, 74, 255]);
  assert.equal(decode(messageOf([1, 2], []).slice(0, -1)), null, "a cell is missing");
});

test("the body has no colour, the threshold is orange, and the cold is blue", () => {
  const scale = scaleOf({ body: 37, threshold: 47 });
  assert.equal(scale.length, 8, "the shader has as many stops");
  scale.slice(1).forEach((stop, n) => assert.ok(stop.at > scale[n].at));
  for (const at of [36, 37, 38]) assert.equal(colorAt(scale, at).cover, 0, `${at}`);
  const [warm, line, cold] = [colorAt(scale, 45), colorAt(scale, 47), colorAt(scale, 25)];
  assert.ok(warm.cover > 0.8 && warm.color[0] > warm.color[2] + 100);
  assert.deepEqual(line.color, [255, 150, 20]);
  assert.ok(cold.color[2] > cold.color[0] + 100);
  assert.deepEqual(colorAt(scale, 500), scale[7]);
  assert.deepEqual(colorAt(scale, -100), scale[0]);
});

test("the texture says where there is no material, and the centre of a cell is that of its texel", () => {
  assert.deepEqual([...texels(Uint8Array.from([0, 7]))], [0, 0, 7, 255]);
  const colors = new HeatColors(), heat = decode(messageOf([0, 74, 255], [])) as Heat;
  colors.use(heat, new three.Matrix4().makeTranslation(1, 2, 3));
  assert.equal(colors.uniforms.showsHeat.value, true);
  const second = new three.Vector3(1.4, 2, 3).applyMatrix4(colors.uniforms.toHeat.value);
  [0.5, 0.5, 0.5].forEach((at, axis) => assert.ok(Math.abs(second.getComponent(axis) - at) < 1e-9, `${second.toArray()}`));
  const { x, y } = colors.uniforms.heatScale.value; // the shader: x + y r/g
  assert.equal(x + y * (74 / 255), 10.25 + 73 * 0.5);
  colors.use({ ...heat, dims: [0, 0, 0], cells: new Uint8Array() }, new three.Matrix4());
  assert.equal(colors.uniforms.showsHeat.value, false);
});

test("a cut has the shares of the force, and without one the tip has a material", () => {
  assert.deepEqual(sharesOf(kTooth, [0.3, 0.7]).map(({ name, part }) => [name, part]), [["cortical bone", 0.7], ["enamel", 0.3]]);
  assert.equal(textOfCut(kTooth, { forces: [1.4, 0.6], under: 2 }), "enamel 70 % · cortical bone 30 %");
  assert.equal(textOfCut(kTooth, { forces: [2, 0.001], under: 2 }), "enamel 100 %");
  assert.equal(textOfCut(kTooth, { forces: [0.001, 0], under: 2 }), "cortical bone");
  assert.equal(textOfCut(kTooth, { forces: [], under: 0 }), "nothing");
});

test("a control tells its known range", () => {
  const control = { low: 0.1278, typical: 0.18, high: 0.266, unit: "J/mm³", source: "White 1998" } as Control;
  assert.equal(knownText(control), "typical 0.18 J/mm³, 0.128 ... 0.266");
  assert.equal(knownText({ ...control, low: 1, typical: 1, high: 1, unit: "" }), "typical 1, no range");
  assert.equal(knownText({ ...control, source: "" }), "");
});
