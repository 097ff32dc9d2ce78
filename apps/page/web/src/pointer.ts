// SPDX-License-Identifier: Apache-2.0
// Mouse, touch, keys and gamepads move the eye and the hand.
import * as three from "three";
import type { Eye } from "./camera.ts";
import { dot, type Ray } from "./geometry.ts";
import type { Hand, Hit } from "./hand.ts";
import type { Picture } from "./picture.ts";
import type { Vec3 } from "./protocol.ts";

export interface PointerOptions {
  canvas: HTMLCanvasElement;
  eye: Eye;
  hand: Hand;
  picture: Picture | null;
  hit: (ray: three.Ray) => Hit | null;
  leads: () => boolean; // whether this page has control; otherwise a drag turns the view
  mayMove: () => boolean;
  moved: () => void;
}

interface Place {
  x: number;
  y: number;
}
interface InPicture extends Place {
  column: number; // index of the picture, if they are side by side
}
type Client = Pick<MouseEvent, "clientX" | "clientY">;

const kKeyStep = 0.1e-3; // m
const asArray = (v: three.Vector3): Vec3 => [v.x, v.y, v.z];
const inMetres = (ray: three.Ray): Ray => (
  { from: asArray(ray.origin.clone().divideScalar(1e3)), along: asArray(ray.direction) });
const nameOfPad = ({ index }: Gamepad) => `gamepad ${index}`;
const nameOf = (event: PointerEvent) => `pointer ${event.pointerId}`;

/** Whether a key is for the scene. It is not if the focused element needs it. */
export const isForTheScene = (event: KeyboardEvent) => {
  const target = event.target instanceof Element ? event.target : null;
  return !event.defaultPrevented && !target?.closest("aside, dialog, input, select") &&
    !(event.key === " " && target?.closest("button"));
};

export class Pointer {
  private down = new Map<number, Place>(); // pointers that are pressed on the canvas
  private fingers = new Set<number>(); // pressed pointers that are fingers
  private holders = new Set<string>(); // inputs that press; the press ends when the last one is released
  private pulled = new Set<string>(); // pulled triggers of gamepads
  private waiting: PointerEvent | null = null;

  constructor(private o: PointerOptions) {
    const { canvas } = o;
    canvas.addEventListener("pointerdown", (event) => this.press(event));
    canvas.addEventListener("pointermove", (event) => this.move(event));
    for (const name of ["pointerup", "pointercancel"] as const)
      canvas.addEventListener(name, (event) => this.up(event));
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    addEventListener("keydown", (event) => { if (isForTheScene(event)) this.key(event); });
    // If the focus moves while a key is down, the canvas does not receive the release.
    addEventListener("keyup", (event) => { if (event.key === " ") this.release("space"); });
    const releaseAll = () => [...this.holders].forEach((source) => this.release(source));
    addEventListener("blur", releaseAll);
    document.addEventListener("visibilitychange", releaseAll);
  }

  /** Begins another scene. Inputs that are still down do not press in it. */
  begin() { this.holders.clear(); }

  /** Called once per picture: handles the newest place of the pointer, and the gamepads. */
  frame(seconds: number) {
    if (this.waiting) {
      const event = this.waiting;
      this.waiting = null;
      this.apply(() => this.point(event));
    }
    const pads = (navigator.getGamepads?.() ?? []).filter((pad) => pad?.connected) as Gamepad[];
    for (const pad of pads) this.gamepad(pad, seconds);
    const gone = [...this.pulled].filter((source) => !pads.some((pad) => nameOfPad(pad) === source));
    gone.forEach((source) => this.trigger(source, false));
  }

  private apply(change: () => void) {
    if (!this.o.mayMove()) return;
    change();
    this.o.moved();
  }

  private hold(source: string, hit: () => Hit | null) {
    if (!this.o.mayMove()) return;
    this.holders.add(source);
    if (!this.o.hand.pressed) this.apply(() => this.o.hand.press(hit()));
  }
  private release(source: string) {
    if (this.holders.delete(source) && this.holders.size === 0) this.apply(() => this.o.hand.release());
  }

  /** The surface under the tip, along the tool. Keys and gamepads press there. */
  private under(): Hit | null {
    const { hand, hit } = this.o, along = new three.Vector3(...hand.axis).negate();
    const found = hit(new three.Ray(new three.Vector3(...hand.place).multiplyScalar(1e3), along));
    return found && dot(found.normal, hand.axis) > 0 ? found : null; // from inside there is no surface to press on
  }

  private inPicture({ clientX, clientY }: Client): InPicture {
    const box = this.o.canvas.getBoundingClientRect(), columns = this.o.picture?.columns ?? 1;
    const across = (columns * (clientX - box.left)) / box.width;
    const column = Math.max(0, Math.min(columns - 1, Math.floor(across)));
    return { x: 2 * (across - column) - 1, y: 1 - (2 * (clientY - box.top)) / box.height, column };
  }
  private ray(event: Client): three.Ray {
    const { eye, picture } = this.o, { x, y, column } = this.inPicture(event);
    if (picture?.columns !== 2) return eye.ray(x, y);
    return eye.ray(x, y, (camera) => picture.eyeOf(camera, column === 0 ? -1 : 1));
  }

  private point(event: Client) {
    const ray = this.ray(event), { hand, eye, hit } = this.o;
    hand.point(inMetres(ray), hand.pressed ? null : hit(ray), asArray(eye.back));
  }

  private press(event: PointerEvent) {
    const { canvas, hit } = this.o;
    canvas.focus();
    canvas.setPointerCapture(event.pointerId);
    this.down.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (event.pointerType === "touch") this.fingers.add(event.pointerId);
    if (this.fingers.size > 1) this.fingers.forEach((id) => this.release(`pointer ${id}`)); // two fingers turn the view
    else if (event.button === 0) this.hold(nameOf(event), () => hit(this.ray(event)));
  }

  private move(event: PointerEvent) {
    const { eye, canvas, hit, leads } = this.o, before = this.down.get(event.pointerId);
    if (before) {
      const now = { x: event.clientX, y: event.clientY }, dx = now.x - before.x, dy = now.y - before.y;
      if (this.fingers.has(event.pointerId) && this.fingers.size > 1) return this.pinch(event.pointerId, before, now);
      this.down.set(event.pointerId, now);
      // With several buttons, only the first press and the last release have their own events.
      if ((event.buttons & 1) === 0) this.release(nameOf(event));
      else if (event.button === 0) this.hold(nameOf(event), () => hit(this.ray(event)));
      if ((event.buttons & 2) !== 0 || ((event.buttons & 1) !== 0 && !leads())) return eye.orbit(dx / 150, dy / 150);
      if ((event.buttons & 4) !== 0) return eye.pan(dx / canvas.clientHeight, dy / canvas.clientHeight);
    }
    this.waiting = event;
  }

  private pinch(id: number, before: Place, now: Place) {
    const other = this.down.get([...this.fingers].find((one) => one !== id)!)!;
    const spread = (p: Place) => Math.max(1, Math.hypot(p.x - other.x, p.y - other.y));
    this.down.set(id, now);
    const middle = this.inPicture({ clientX: (now.x + other.x) / 2, clientY: (now.y + other.y) / 2 });
    this.o.eye.zoom(spread(before) / spread(now), middle.x, middle.y);
    this.o.eye.orbit((now.x - before.x) / 300, (now.y - before.y) / 300);
  }

  private up(event: PointerEvent) {
    this.down.delete(event.pointerId);
    this.fingers.delete(event.pointerId);
    this.release(nameOf(event));
  }

  private wheel(event: WheelEvent) {
    event.preventDefault();
    const notches = (event.deltaY || event.deltaX) / (event.deltaMode === 0 ? 100 : 3);
    if (event.shiftKey || event.ctrlKey || !this.o.leads()) {
      const { x, y } = this.inPicture(event);
      return this.o.eye.zoom(1.12 ** notches, x, y);
    }
    this.apply(() => {
      if (event.altKey) this.o.hand.tilt(asArray(this.o.eye.right), notches * 0.05);
      else this.o.hand.push(-notches);
    });
  }

  private key(event: KeyboardEvent) {
    const { eye, hand } = this.o;
    const step = kKeyStep * (event.shiftKey ? 10 : 1);
    const along = (direction: three.Vector3, by: number) => () =>
      hand.move(asArray(direction.clone().multiplyScalar(by)));
    const lean = (axis: three.Vector3, angle: number) => () => hand.tilt(asArray(axis), angle);
    const moves: Record<string, () => void> = {
      ArrowRight: along(eye.right, step), ArrowLeft: along(eye.right, -step), ArrowUp: along(eye.up, step),
      ArrowDown: along(eye.up, -step), PageUp: along(eye.back, -step), PageDown: along(eye.back, step),
      w: lean(eye.right, -0.05), s: lean(eye.right, 0.05), a: lean(eye.back, 0.05), d: lean(eye.back, -0.05),
    };
    if (event.ctrlKey || event.metaKey) return;
    const leads = this.o.leads(), act = moves[event.key] ?? moves[event.key.toLowerCase()];
    if (leads && act) this.apply(act);
    else if (leads && event.key === " ") this.hold("space", () => this.under());
    else if (event.key === "+" || event.key === "=") eye.zoom(0.9);
    else if (event.key === "-") eye.zoom(1 / 0.9);
    else return;
    event.preventDefault();
  }

  private gamepad(pad: Gamepad, seconds: number) {
    const axis = (n: number) => (Math.abs(pad.axes[n] ?? 0) > 0.12 ? pad.axes[n] : 0);
    const { eye, hand } = this.o;
    if (axis(2) !== 0 || axis(3) !== 0) eye.orbit(-axis(2) * seconds * 2, -axis(3) * seconds * 2);
    const bumpers = (pad.buttons[5]?.pressed ? 1 : 0) - (pad.buttons[4]?.pressed ? 1 : 0);
    if (axis(0) !== 0 || axis(1) !== 0 || bumpers !== 0)
      this.apply(() => {
        const direction = eye.right.multiplyScalar(axis(0)).addScaledVector(eye.up, -axis(1));
        hand.move(asArray(direction.multiplyScalar(0.02 * seconds)));
        hand.push(bumpers * seconds * 10);
      });
    this.trigger(nameOfPad(pad), (pad.buttons[7]?.value ?? 0) > 0.3);
  }

  /** A trigger at rest sends nothing, so that it does not end another press. */
  private trigger(source: string, isPulled: boolean) {
    if (isPulled === this.pulled.has(source)) return;
    if (isPulled) {
      this.pulled.add(source);
      this.hold(source, () => this.under());
    } else {
      this.pulled.delete(source);
      this.release(source);
    }
  }
}
