// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { test } from "node:test";
import * as three from "three";
import { Eye, type Ground } from "../../src/camera.ts";
import { axisOf, cross, dot, inverse, length, multiply, offAxisFrustum, rotationAbout, subtract, transform } from "../../src/geometry.ts";
import { guardState } from "../../src/guard.ts";
import { Hand, kHover, kWheelStep, rotatedTo } from "../../src/hand.ts";
import { connect } from "../../src/link.ts";
import { outline } from "../../src/outline.ts";
import { commands, decode, identity, kVersion, otherVersion, type Pose, type Vec3 } from "../../src/protocol.ts";
import { readRecording } from "../../src/replay.ts";
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
  hand.point(down(2e-3, 1e-3), { point: [2e-3, 1e-3, -5e-3], normal: up }, up); // the material there has been removed
  assert.deepEqual(hand.X_WT.translation.map((v) => Math.round(v * 1e6)), [2000, 1000, -400]);
  hand.push(2);
  close(hand.X_WT.translation[2], -0.4e-3 - 2 * kWheelStep);
  hand.release();
  close(hand.X_WT.translation[2], kHover);
  hand.press({ point: [0, 0, 0], normal: up });
  hand.push(-50); // stops at the surface, because the next press has the same depth
  close(hand.X_WT.translation[2], 0);
  close(hand.depth, 0);
});

test("the origin of a head whose tip is below it stays above the point", () => {
  const hand = new Hand();
  hand.useTool(identity, -2e-3);
  hand.point(down(0, 0), { point: [0, 0, 0], normal: up }, up);
  close(hand.X_WT.translation[2], kHover + 2e-3);
});

test("the pose of the hand times X_HT is the pose of the head", () => {
  const hand = new Hand();
  const X_HT: Pose = { rotation: rotationAbout([0, 1, 0], 0.5), translation: [0.01, 0.02, -0.1] };
  hand.useTool(X_HT, 0);
  hand.tilt([1, 0, 0], 0.3);
  const X_WT = multiply(hand.X_WH, X_HT);
  X_WT.rotation.forEach((value, n) => close(value, hand.X_WT.rotation[n], 1e-12));
  assert.ok(length(subtract(X_WT.translation, hand.X_WT.translation)) < 1e-12);
});

test("a tool that follows the surface keeps a valid rotation", () => {
  let R = identity.rotation;
  for (const axis of [[0, 0.6, 0.8], [1, 0, 0], [0, 0, -1], [0.1, -0.9, 0.2]] as Vec3[]) {
    R = rotatedTo(R, axis);
    const [x, y, z] = [0, 1, 2].map((n) => axisOf(R, n));
    close(dot(x, y), 0);
    close(length(z), 1);
    close(length(subtract(cross(x, y), z)), 0);
  }
});

test("a pose times its inverse is the identity", () => {
  const X: Pose = { rotation: rotationAbout([0.6, 0, 0.8], 1.1), translation: [1, 2, 3] };
  const p = transform(multiply(X, inverse(X)), [4, 5, 6]);
  p.forEach((value, n) => close(value, [4, 5, 6][n], 1e-12));
});

test("both eyes see the same at the distance of convergence, without vertical parallax", () => {
  const left = offAxisFrustum(0.6, 1.5, 1, 100, -3, 50), right = offAxisFrustum(0.6, 1.5, 1, 100, 3, 50);
  const seen = (f: typeof left, eye: number, x: number, z: number) => ((x - eye) / z - f.left) / (f.right - f.left);
  for (const x of [-5, 0, 7]) close(seen(left, -3, x, 50), seen(right, 3, x, 50), 1e-12);
  assert.ok(seen(left, -3, 0, 20) > seen(right, 3, 0, 20), "a nearer point appears in front of the screen");
  close(left.top, right.top);
});

test("a convex arc bulges outwards, a concave arc inwards", () => {
  const [ball] = outline(-1, [{ rho: 0, z: 1, radius: 1, cutting: true }]);
  for (const [rho, z] of ball.points) close(Math.hypot(rho, z), 1);
  assert.ok(Math.max(...ball.points.map(([rho]) => rho)) > 0.99);
  const [hollow] = outline(0, [{ rho: 1, z: 1, radius: -1, cutting: true }]);
  for (const [rho, z] of hollow.points.slice(1, -1)) assert.ok(z > rho || z < rho, `${rho} ${z}`);
});

test("each column keeps its minimum and maximum", () => {
  const ring = new TraceRing();
  const samples = new Float32Array(6 * 1000);
  samples[6 * 500] = 7;
  samples[6 * 501] = -3;
  ring.add(0, samples);
  const { low, high } = ring.decimate(0, 10, 1000);
  assert.equal(high[5], 7);
  assert.equal(low[5], -3);
  assert.equal(high[4], 0);
  ring.add(900, new Float32Array(6 * 200)); // the ring already has the first hundred
  assert.equal(ring.last, 1100);
  ring.add(50_000, new Float32Array(6));
  assert.equal(ring.last, 50_001);
  assert.ok(ring.size <= kSamples);
});

test("commands have the bytes of the protocol", () => {
  assert.deepEqual([...commands.undo()], [3, kVersion, 0, 0]);
  assert.deepEqual([...commands.load("clay")], [10, kVersion, 0, 0, 99, 108, 97, 121]);
  const set = commands.setControl(513, -2.5);
  assert.deepEqual([...set.subarray(0, 6)], [9, kVersion, 0, 0, 1, 2]);
  assert.equal(new DataView(set.buffer).getFloat64(6, true), -2.5);
  assert.equal(commands.moveHand(identity, true).length, 4 + 96 + 1);
});

test("a message with an invalid byte is refused", () => {
  const notice = [8, kVersion, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 79, 75];
  assert.deepEqual(decode(Uint8Array.from(notice)), { kind: "notice", severity: 1, text: "OK" });
  assert.equal(decode(Uint8Array.from(notice.slice(0, -1))), null);
  assert.equal(decode(Uint8Array.from([...notice, 0])), null);
  assert.equal(decode(Uint8Array.from([8, 1, ...notice.slice(2)])), null, "another version");
  assert.equal(decode(new Uint8Array()), null);
});

test("reports of the guard and of a step appear in the sentences that the program sent", () => {
  const text = (words: string) => [words.length, 0, ...new TextEncoder().encode(words)];
  const sentence = (value: number, name: string, words: string) => [value, 0, 0, 0, ...text(name), ...text(words)];
  const count = (n: number) => [n, 0, 0, 0];
  const hello = decode(Uint8Array.from([
    1, kVersion, 0, 0, ...count(1), ...Array(8 + 96).fill(0), ...count(0),
    ...count(3), ...sentence(2, "wait_free", "Lift it off."), ...sentence(4, "on", "It is on."), ...sentence(5, "fault", "Reset."),
    ...count(2), ...sentence(8, "jump", "Bring it back."), ...sentence(16, "low", "Restart."),
  ]));
  assert.ok(hello?.kind === "hello");
  assert.deepEqual(guardState(hello, { arming: 2, status: 8 }), { name: "wait free", tone: "waits", text: "Lift it off. Bring it back." });
  assert.deepEqual(guardState(hello, { arming: 4, status: 0 }), { name: "on", tone: "calm", text: "It is on." });
  assert.deepEqual(guardState(hello, { arming: 4, status: 24 }), { name: "on", tone: "calm", text: "Bring it back. Restart." });
  assert.equal(guardState(hello, { arming: 5, status: 0 }).tone, "fault");
});

class Line { // replaces WebSocket
  static all: Line[] = [];
  static readonly OPEN = 1;
  readyState = 1;
  closed = false;
  onopen = () => {};
  onclose = (_event: { code: number }) => {};
  onmessage = (_event: { data: ArrayBuffer }) => {};
  constructor() { Line.all.push(this); }
  close() { this.closed = true; }
}
Object.assign(globalThis, { WebSocket: Line, location: { host: "here" } });
const line = () => {
  const said: string[] = [];
  connect("", () => said.push("heard"), (text) => said.push(text));
  return { said, now: () => Line.all.at(-1)! };
};
const noticeOf = (version: number) => Uint8Array.from([8, version, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 79, 75]);

test("a message of another version ends the connection with a cure: the page or the program is older", () => {
  for (const [version, sentence] of [[kVersion + 1, /page is older .* reload the page/], [kVersion - 1, /page is newer .* end hapticut view/]] as const) {
    const { said, now } = line();
    now().onopen();
    now().onmessage({ data: noticeOf(version).buffer });
    now().onmessage({ data: noticeOf(version).buffer });
    now().onclose({ code: 1000 });
    assert.equal(said.length, 1);
    assert.match(said[0], sentence);
    assert.ok(now().closed);
  }
  assert.equal(otherVersion(noticeOf(kVersion)), null);
  assert.deepEqual([1, -1].map((more) => otherVersion(noticeOf(kVersion + more))?.older), [true, false]);
});

test("a lost connection is opened again, unless the program has ended", () => {
  const { said, now } = line(), first = now();
  first.onopen();
  first.onmessage({ data: noticeOf(kVersion).buffer });
  first.onclose({ code: 1006 });
  assert.notEqual(now(), first);
  assert.deepEqual(said, ["heard"]);
  now().onclose({ code: 1006 });
  assert.match(said[1], /program has ended/);
});

test("a recording of another version and a damaged recording are refused with a reason", () => {
  const recordingOf = (message: Uint8Array) =>
    Uint8Array.from([72, 67, 82, 80, 1, 0, 0, 0, ...Array(8).fill(0), message.length, 0, 0, 0, ...message]);
  assert.equal(readRecording(recordingOf(noticeOf(kVersion))).length, 1);
  assert.throws(() => readRecording(recordingOf(noticeOf(kVersion + 1))), /page is older .* export it again/);
  assert.throws(() => readRecording(recordingOf(noticeOf(kVersion - 1))), /page is newer .* export it again/);
  assert.throws(() => readRecording(recordingOf(noticeOf(kVersion).slice(0, -1))), /damaged/);
});

const ball: Ground = { // radius 10 mm
  hit: (ray) => {
    const at = ray.intersectSphere(new three.Sphere(new three.Vector3(), 10), new three.Vector3());
    return at && { point: at.divideScalar(1e3).toArray() };
  },
  clearance: (point) => Math.abs(point.length() - 10),
  isInside: (point) => point.length() < 10,
};
const eyeBefore = (fov = 32) => {
  const eye = new Eye(ball);
  eye.camera.fov = fov;
  eye.update(1.5);
  return eye;
};

test("zoom keeps the point under the pointer in place, and the eye stays outside", () => {
  for (const [x, y] of [[0, 0], [0.2, -0.1], [-0.28, 0.3], [0.9, 0.9]]) {
    const eye = eyeBefore(), before = ball.hit(eye.ray(x, y));
    for (let n = 0; n < 60; ++n) {
      eye.zoom(1 / 1.12, x, y);
      eye.update(1.5);
      assert.ok(eye.camera.position.length() >= 10 + eye.camera.near, `${n}: ${eye.camera.position.length()}`);
      if (!before) continue;
      const seen = new three.Vector3(...before.point).multiplyScalar(1e3).project(eye.camera);
      assert.ok(Math.hypot(seen.x - x, seen.y - y) < 1e-6);
    }
    if (before) assert.ok(eye.camera.position.length() < 11, `${eye.camera.position.length()}`);
    for (let n = 0; n < 120; ++n) eye.zoom(1.12, x, y);
    assert.ok(eye.distance > 1000 && eye.distance <= 1500);
  }
});

test("an eye that turns, moves or changes the view near the surface moves back until it is outside", () => {
  for (const act of [(eye: Eye) => eye.orbit(1.5, 0), (eye: Eye) => eye.pan(0.8, 2), (eye: Eye) => eye.look("bottom")]) {
    const eye = eyeBefore();
    for (let n = 0; n < 60; ++n) eye.zoom(1 / 1.12, 0.25, 0.3);
    act(eye);
    eye.update(1.5);
    assert.ok(eye.camera.position.length() >= 10 + eye.camera.near, `${eye.camera.position.length()}`);
  }
});

test("the whole workpiece fits in the picture, also in a narrow one", () => {
  for (const aspect of [2, 0.5]) {
    const eye = new Eye(ball), side = new three.Vector3();
    eye.update(aspect);
    eye.frame(new three.Box3(new three.Vector3(-5, -5, -5), new three.Vector3(5, 5, 5)));
    eye.update(aspect);
    for (const one of [eye.right, eye.up]) {
      side.copy(one).multiplyScalar(5).project(eye.camera);
      assert.ok(Math.abs(side.x) < 1 && Math.abs(side.y) < 1, `${aspect}: ${side.x}, ${side.y}`);
    }
  }
});
