// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { test } from "node:test";
import { axisOf, cross, dot, inverse, length, multiply, offAxisFrustum, rotationAbout, subtract, transform } from "../../src/geometry.ts";
import { guardState, statusTexts } from "../../src/guard.ts";
import { Hand, kHover, kWheelStep, turnedTo } from "../../src/hand.ts";
import { outline } from "../../src/outline.ts";
import { commands, decode, identity, type Pose, type Vec3 } from "../../src/protocol.ts";
import { kSamples, TraceRing } from "../../src/trace.ts";

const close = (a: number, b: number, tolerance = 1e-9) => assert.ok(Math.abs(a - b) <= tolerance, `${a} is not ${b}`);
const up: Vec3 = [0, 0, 1];
const down = (x: number, y: number) => ({ from: [x, y, 1] as Vec3, along: [0, 0, -1] as Vec3 });

test("the tip hovers above the surface, and works below its tangent plane", () => {
  const hand = new Hand();
  hand.useTool(identity, 0);
  hand.depth = 0.4e-3;
  hand.point(down(0, 0), { point: [0, 0, 0], normal: up }, up);
  close(hand.X_WT.translation[2], kHover);
  hand.press({ point: [0, 0, 0], normal: up });
  close(hand.X_WT.translation[2], -0.4e-3);
  hand.point(down(2e-3, 1e-3), { point: [2e-3, 1e-3, -5e-3], normal: up }, up); // the surface has gone from there
  assert.deepEqual(hand.X_WT.translation.map((v) => Math.round(v * 1e6)), [2000, 1000, -400]);
  hand.push(2);
  close(hand.X_WT.translation[2], -0.4e-3 - 2 * kWheelStep);
  hand.release();
  close(hand.X_WT.translation[2], kHover);
});

test("the origin of a head whose tip is below it stays above the point", () => {
  const hand = new Hand();
  hand.useTool(identity, -2e-3);
  hand.point(down(0, 0), { point: [0, 0, 0], normal: up }, up);
  close(hand.X_WT.translation[2], kHover + 2e-3);
});

test("the pose of the hand is that of the head through the handle", () => {
  const hand = new Hand();
  const X_HT: Pose = { rotation: rotationAbout([0, 1, 0], 0.5), translation: [0.01, 0.02, -0.1] };
  hand.useTool(X_HT, 0);
  hand.tilt([1, 0, 0], 0.3);
  const X_WT = multiply(hand.X_WH, X_HT);
  X_WT.rotation.forEach((value, n) => close(value, hand.X_WT.rotation[n], 1e-12));
  assert.ok(length(subtract(X_WT.translation, hand.X_WT.translation)) < 1e-12);
});

test("a tool that follows the surface stays a rotation", () => {
  let R = identity.rotation;
  for (const axis of [[0, 0.6, 0.8], [1, 0, 0], [0, 0, -1], [0.1, -0.9, 0.2]] as Vec3[]) {
    R = turnedTo(R, axis);
    const [x, y, z] = [0, 1, 2].map((n) => axisOf(R, n));
    close(dot(x, y), 0);
    close(length(z), 1);
    close(length(subtract(cross(x, y), z)), 0);
  }
});

test("a pose times its inverse is nothing", () => {
  const X: Pose = { rotation: rotationAbout([0.6, 0, 0.8], 1.1), translation: [1, 2, 3] };
  const p = transform(multiply(X, inverse(X)), [4, 5, 6]);
  p.forEach((value, n) => close(value, [4, 5, 6][n], 1e-12));
});

test("both eyes see the same at the distance of convergence, and nothing is turned", () => {
  const left = offAxisFrustum(0.6, 1.5, 1, 100, -3, 50), right = offAxisFrustum(0.6, 1.5, 1, 100, 3, 50);
  const seen = (f: typeof left, eye: number, x: number, z: number) => ((x - eye) / z - f.left) / (f.right - f.left);
  for (const x of [-5, 0, 7]) close(seen(left, -3, x, 50), seen(right, 3, x, 50), 1e-12);
  assert.ok(seen(left, -3, 0, 20) > seen(right, 3, 0, 20), "what is nearer stands before the screen");
  close(left.top, right.top);
});

test("an arc bulges outwards, and a hollow one inwards", () => {
  const [ball] = outline(-1, [{ rho: 0, z: 1, radius: 1, cutting: true }]);
  for (const [rho, z] of ball.points) close(Math.hypot(rho, z), 1);
  assert.ok(Math.max(...ball.points.map(([rho]) => rho)) > 0.99);
  const [hollow] = outline(0, [{ rho: 1, z: 1, radius: -1, cutting: true }]);
  for (const [rho, z] of hollow.points.slice(1, -1)) assert.ok(z > rho || z < rho, `${rho} ${z}`);
});

test("the least and the greatest of each column are kept", () => {
  const ring = new TraceRing();
  const samples = new Float32Array(6 * 1000);
  samples[6 * 500] = 7;
  samples[6 * 501] = -3;
  ring.add(0, samples);
  const { low, high } = ring.decimate(0, 10, 1000);
  assert.equal(high[5], 7);
  assert.equal(low[5], -3);
  assert.equal(high[4], 0);
  ring.add(900, new Float32Array(6 * 200)); // the first hundred are known already
  assert.equal(ring.last, 1100);
  ring.add(50_000, new Float32Array(6));
  assert.equal(ring.last, 50_001);
  assert.ok(ring.size <= kSamples);
});

test("a command is its bytes", () => {
  assert.deepEqual([...commands.undo()], [3, 2, 0, 0]);
  assert.deepEqual([...commands.load("clay")], [12, 2, 0, 0, 99, 108, 97, 121]);
  const set = commands.setControl(513, -2.5);
  assert.deepEqual([...set.subarray(0, 8)], [11, 2, 0, 0, 1, 2, 0, 0]);
  assert.equal(new DataView(set.buffer).getFloat64(8, true), -2.5);
  assert.equal(commands.moveHand(identity, true).length, 4 + 96 + 1);
});

test("what is no message in every byte is none", () => {
  const notice = [8, 2, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 79, 75];
  assert.deepEqual(decode(Uint8Array.from(notice)), { kind: "notice", severity: 1, text: "OK" });
  assert.equal(decode(Uint8Array.from(notice.slice(0, -1))), null);
  assert.equal(decode(Uint8Array.from([...notice, 0])), null);
  assert.equal(decode(Uint8Array.from([8, 1, ...notice.slice(2)])), null, "another version");
  assert.equal(decode(new Uint8Array()), null);
});

test("a state of the guard has a cure in words", () => {
  assert.match(guardState(2).text, /lift it off/);
  assert.match(guardState(5).text, /Reset/);
  assert.deepEqual(statusTexts(0), []);
  assert.match(statusTexts(1 << 13)[0], /press less/);
});
