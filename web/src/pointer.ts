// SPDX-License-Identifier: Apache-2.0
// Mouse, touch, keys and gamepad: what moves the eye, and what moves the hand.
import * as three from "three";
import type { Eye } from "./camera.ts";
import type { Ray } from "./geometry.ts";
import type { Hand, Hit } from "./hand.ts";
import type { Vec3 } from "./protocol.ts";

export interface PointerOptions {
  canvas: HTMLCanvasElement;
  eye: Eye;
  hand: Hand;
  hit: (ray: three.Ray) => Hit | null;
  mayMove: () => boolean;
  moved: () => void;
}

const kKeyStep = 0.1e-3; // m
const asArray = (v: three.Vector3): Vec3 => [v.x, v.y, v.z];
const inMetres = (ray: three.Ray): Ray => ({ from: asArray(ray.origin.clone().divideScalar(1e3)), along: asArray(ray.direction) });

export class Pointer {
  private touches = new Map<number, { x: number; y: number }>();
  private last = { x: 0, y: 0 };
  private waiting: PointerEvent | null = null;

  constructor(private o: PointerOptions) {
    const { canvas } = o;
    canvas.addEventListener("pointerdown", (event) => this.down(event));
    canvas.addEventListener("pointermove", (event) => this.move(event));
    for (const name of ["pointerup", "pointercancel"] as const) canvas.addEventListener(name, (event) => this.up(event));
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    canvas.addEventListener("keydown", (event) => this.key(event));
    canvas.addEventListener("keyup", (event) => {
      if (event.key === " ") this.let(() => o.hand.release());
    });
  }

  /** Once for each picture: the newest place of the pointer, and the gamepad. */
  frame(seconds: number) {
    if (this.waiting) {
      const event = this.waiting;
      this.waiting = null;
      this.let(() => this.point(event));
    }
    this.gamepad(seconds);
  }

  private let(change: () => void) {
    if (!this.o.mayMove()) return;
    change();
    this.o.moved();
  }

  private place(event: { clientX: number; clientY: number }): three.Ray {
    const box = this.o.canvas.getBoundingClientRect();
    return this.o.eye.ray((2 * (event.clientX - box.left)) / box.width - 1, 1 - (2 * (event.clientY - box.top)) / box.height);
  }

  private point(event: { clientX: number; clientY: number }) {
    const ray = this.place(event), { hand, eye, hit } = this.o;
    hand.point(inMetres(ray), hand.pressed ? null : hit(ray), asArray(eye.back));
  }

  private down(event: PointerEvent) {
    const { canvas, hand, hit } = this.o;
    canvas.focus();
    canvas.setPointerCapture(event.pointerId);
    this.last = { x: event.clientX, y: event.clientY };
    this.touches.set(event.pointerId, this.last);
    if (event.button !== 0) return;
    this.let(() => {
      if (this.touches.size > 1) return hand.release(); // a second finger turns the view
      hand.press(hit(this.place(event)));
    });
  }

  private move(event: PointerEvent) {
    const { eye, canvas } = this.o;
    const dx = event.clientX - this.last.x, dy = event.clientY - this.last.y;
    this.last = { x: event.clientX, y: event.clientY };
    if (this.touches.size > 1) return this.pinch(event);
    if (this.touches.has(event.pointerId)) this.touches.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if ((event.buttons & 2) !== 0) return eye.orbit(dx / 150, dy / 150);
    if ((event.buttons & 4) !== 0) return eye.pan(dx / canvas.clientHeight, dy / canvas.clientHeight);
    this.waiting = event;
  }

  private pinch(event: PointerEvent) {
    const before = [...this.touches.values()];
    const spread = (p: { x: number; y: number }[]) => Math.hypot(p[0].x - p[1].x, p[0].y - p[1].y);
    const old = this.touches.get(event.pointerId);
    this.touches.set(event.pointerId, { x: event.clientX, y: event.clientY });
    const after = [...this.touches.values()];
    if (!old || spread(before) < 1 || spread(after) < 1) return;
    this.o.eye.zoom(spread(before) / spread(after));
    this.o.eye.orbit((event.clientX - old.x) / 300, (event.clientY - old.y) / 300);
  }

  private up(event: PointerEvent) {
    this.touches.delete(event.pointerId);
    if (event.button <= 0) this.let(() => this.o.hand.release());
  }

  private wheel(event: WheelEvent) {
    event.preventDefault();
    const notches = (event.deltaY || event.deltaX) / (event.deltaMode === 0 ? 100 : 3);
    if (event.shiftKey || event.ctrlKey) return this.o.eye.zoom(1.12 ** notches);
    this.let(() => {
      if (event.altKey) this.o.hand.tilt(asArray(this.o.eye.right), notches * 0.05);
      else this.o.hand.push(-notches);
    });
  }

  private key(event: KeyboardEvent) {
    const { eye, hand, hit } = this.o;
    const step = kKeyStep * (event.shiftKey ? 10 : 1);
    const along = (direction: three.Vector3, by: number) => () =>
      hand.move(asArray(direction.clone().multiplyScalar(by)));
    const lean = (axis: three.Vector3, angle: number) => () => hand.tilt(asArray(axis), angle);
    const moves: Record<string, () => void> = {
      ArrowRight: along(eye.right, step), ArrowLeft: along(eye.right, -step), ArrowUp: along(eye.up, step),
      ArrowDown: along(eye.up, -step), PageUp: along(eye.back, -step), PageDown: along(eye.back, step),
      w: lean(eye.right, -0.05), s: lean(eye.right, 0.05), a: lean(eye.back, 0.05), d: lean(eye.back, -0.05),
      " ": () => { if (!event.repeat) hand.press(hit(this.place({ clientX: this.last.x, clientY: this.last.y }))); },
    };
    const act = event.ctrlKey || event.metaKey ? undefined : moves[event.key] ?? moves[event.key.toLowerCase()];
    if (act) {
      event.preventDefault();
      this.let(act);
    } else if (event.key === "+" || event.key === "=") {
      eye.zoom(0.9);
    } else if (event.key === "-") {
      eye.zoom(1.1);
    }
  }

  private gamepad(seconds: number) {
    const pad = navigator.getGamepads?.().find((one) => one?.connected);
    if (!pad) return;
    const axis = (n: number) => (Math.abs(pad.axes[n] ?? 0) > 0.12 ? pad.axes[n] : 0);
    const { eye, hand } = this.o;
    if (axis(2) !== 0 || axis(3) !== 0) eye.orbit(-axis(2) * seconds * 2, -axis(3) * seconds * 2);
    const trigger = (pad.buttons[7]?.value ?? 0) > 0.3;
    const bumpers = (pad.buttons[5]?.pressed ? 1 : 0) - (pad.buttons[4]?.pressed ? 1 : 0);
    if (axis(0) === 0 && axis(1) === 0 && trigger === hand.pressed && bumpers === 0) return;
    this.let(() => {
      const by = eye.right.multiplyScalar(axis(0)).addScaledVector(eye.up, -axis(1)).multiplyScalar(0.02 * seconds);
      hand.move(asArray(by));
      if (bumpers !== 0) hand.push(bumpers * seconds * 10);
      if (trigger && !hand.pressed) hand.press(null);
      if (!trigger && hand.pressed) hand.release();
    });
  }
}
