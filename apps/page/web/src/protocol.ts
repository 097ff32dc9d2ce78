// SPDX-License-Identifier: Apache-2.0
// The messages between server and page: the comment of include/hapticut/view/protocol.hpp describes their bytes.

export const kVersion = 6;

export type Vec3 = [number, number, number];

/** Rotation row by row, translation in metres. */
export interface Pose {
  rotation: number[];
  translation: Vec3;
}

export const identity: Pose = { rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1], translation: [0, 0, 0] };

/** Name of a state or a bit, and its sentence for the user. */
export interface Sentence {
  value: number;
  name: string;
  text: string;
}

export interface Hello {
  kind: "hello";
  writer: boolean;
  voxelSize: number;
  X_WV: Pose;
  materials: { name: string; color: Vec3 }[];
  arming: Sentence[]; // states of the guard
  status: Sentence[]; // bits of a step
}

export interface SurfacePage {
  kind: "page";
  origin: Vec3;
  version: number;
  vertices: Int16Array; // six numbers of 16 bits per vertex
  indices: Uint16Array;
}

export interface Snapshot {
  kind: "snapshot";
  arming: number;
  tick: number;
  X_WT: Pose;
  force: Vec3;
  torque: Vec3;
  removed: number;
  dissipated: number;
  depth: number;
  speed: number; // rad/s
  voxels: number;
  status: number;
  statusSeen: number;
  undoMarks: number;
  redoMarks: number;
  undoing: boolean;
  redoing: boolean;
  held: boolean;
  workpiece: number;
  blocksWaiting: number;
  point: Vec3; // m, of the contact
}

export interface Sound {
  kind: "sound";
  rate: number;
  samples: Int16Array;
}

export interface ToolEdge {
  rho: number;
  z: number;
  radius: number;
  cutting: boolean;
}

export interface Tool {
  kind: "tool";
  X_HT: Pose;
  angled: boolean;
  length: number;
  neck: number;
  bend: number;
  tip: number;
  edges: ToolEdge[];
}

export type ControlKind = "number" | "switch" | "choice" | "button";

export interface Control {
  id: number;
  control: ControlKind;
  panel: string;
  label: string;
  unit: string;
  choices: string[];
  idle: string; // why it does nothing at present
  value: number;
  min: number;
  max: number;
  low: number; // known range and usual value, if there is a source
  typical: number;
  high: number;
  source: string; // who measured them; empty: nothing is known
}

export interface Controls {
  kind: "controls";
  controls: Control[];
}

export interface Trace {
  kind: "trace";
  first: number; // tick of the first sample
  samples: Float32Array; // force x y z, torque x y z of each tick
}

export interface Notice {
  kind: "notice";
  severity: number; // 0 info, 1 warning, 2 error
  text: string;
}

export interface Instruments {
  kind: "instruments";
  X_WG: Pose; // pose of the head at the set point of the hand
  power: number; // W
  ticks: number;
  missed: number;
  bucket: number; // s
  latency: Uint32Array;
  removed: number[]; // m^3, by material id from 1
  forces: number[]; // N, normal force on the head by material id from 1; 0 while it cuts nothing
  under: number; // id of the material under the tip; 0: none
}

export interface Heat {
  kind: "heat";
  X_WC: Pose; // of the cells; the origin is in the centre of the first one
  cellSize: number; // m
  dims: Vec3; // cells along x, y, z; 0: heat is off
  first: number; // deg C of byte 1
  step: number; // K between two bytes
  body: number; // deg C
  threshold: number; // deg C, of the line
  structures: { now: number; peak: number; timeAbove: number }[]; // deg C, deg C, s by material id from 1
  cells: Uint8Array; // temperatures, x fastest; 0: no material
}

export type Message =
  | Hello | SurfacePage | Snapshot | Sound | Tool | Controls | Trace | Notice | Instruments | Heat;

class Reader {
  private at = 0;
  private view: DataView;
  constructor(private bytes: Uint8Array) {
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  }
  u8() { return this.view.getUint8(this.at++); }
  u16() { return this.move(2, this.view.getUint16(this.at, true)); }
  u32() { return this.move(4, this.view.getUint32(this.at, true)); }
  i32() { return this.move(4, this.view.getInt32(this.at, true)); }
  u64() { return this.move(8, Number(this.view.getBigUint64(this.at, true))); }
  f64() { return this.move(8, this.view.getFloat64(this.at, true)); }
  vec(): Vec3 { return [this.f64(), this.f64(), this.f64()]; }
  pose(): Pose {
    const rotation = Array.from({ length: 9 }, () => this.f64());
    return { rotation, translation: this.vec() };
  }
  sentences(): Sentence[] {
    return Array.from({ length: this.u32() }, () => (
      { value: this.u32(), name: this.text(this.u16()), text: this.text(this.u16()) }));
  }
  text(length: number) { return new TextDecoder().decode(this.read(length)); }
  read(length: number) {
    if (this.at + length > this.bytes.length) throw new RangeError("the message is too short");
    const part = this.bytes.slice(this.at, this.at + length);
    return this.move(length, part);
  }
  get complete() { return this.at === this.bytes.length; }
  private move<T>(length: number, value: T): T {
    this.at += length;
    return value;
  }
}

const kControls: ControlKind[] = ["number", "switch", "choice", "button"];

function readMessage(kind: number, r: Reader): Message | null {
  switch (kind) {
    case 1: {
      const writer = r.u32() === 1, voxelSize = r.f64(), X_WV = r.pose();
      const materials = Array.from({ length: r.u32() }, () => {
        const color: Vec3 = [r.u8(), r.u8(), r.u8()];
        return { color, name: r.text(r.u8()) };
      });
      return { kind: "hello", writer, voxelSize, X_WV, materials, arming: r.sentences(), status: r.sentences() };
    }
    case 2: {
      const origin: Vec3 = [r.i32(), r.i32(), r.i32()];
      const version = r.u64(), vertices = r.u32(), indices = r.u32();
      return {
        kind: "page", origin, version,
        vertices: new Int16Array(r.read(12 * vertices).buffer),
        indices: new Uint16Array(r.read(2 * indices).buffer),
      };
    }
    case 3: {
      const arming = r.u32(), tick = r.u64(), X_WT = r.pose(), force = r.vec(), torque = r.vec();
      const removed = r.f64(), dissipated = r.f64(), depth = r.f64(), speed = r.f64();
      const voxels = r.u32(), status = r.u32(), statusSeen = r.u32(), undoMarks = r.u32(), redoMarks = r.u32();
      const flags = r.u32(), workpiece = r.u32(), blocksWaiting = r.u32(), point = r.vec();
      return {
        kind: "snapshot", arming, tick, X_WT, force, torque, removed, dissipated, depth, speed, voxels, status,
        statusSeen, undoMarks, redoMarks, undoing: (flags & 1) !== 0, redoing: (flags & 2) !== 0,
        held: (flags & 4) !== 0, workpiece, blocksWaiting, point,
      };
    }
    case 4: {
      const rate = r.u32(), count = r.u32();
      return { kind: "sound", rate, samples: new Int16Array(r.read(2 * count).buffer) };
    }
    case 5: {
      const X_HT = r.pose(), angled = r.u32() === 1, length = r.f64(), neck = r.f64(), bend = r.f64(), tip = r.f64();
      const edges = Array.from({ length: r.u32() }, () => (
        { rho: r.f64(), z: r.f64(), radius: r.f64(), cutting: r.u32() === 1 }));
      return { kind: "tool", X_HT, angled, length, neck, bend, tip, edges };
    }
    case 6: {
      const controls = Array.from({ length: r.u32() }, (): Control => {
        const id = r.u16(), control = kControls[r.u8()] ?? "number";
        r.u8();
        const value = r.f64(), min = r.f64(), max = r.f64(), low = r.f64(), typical = r.f64(), high = r.f64();
        const [panel, label, unit, choices, idle, source] = Array.from({ length: 6 }, () => r.text(r.u16()));
        return { id, control, panel, label, unit, choices: choices ? choices.split("|") : [], idle, value, min, max,
                 low, typical, high, source };
      });
      return { kind: "controls", controls };
    }
    case 7: {
      const first = r.u64(), count = r.u32();
      return { kind: "trace", first, samples: new Float32Array(r.read(24 * count).buffer) };
    }
    case 8: {
      const severity = r.u32();
      return { kind: "notice", severity, text: r.text(r.u32()) };
    }
    case 9: {
      const X_WG = r.pose(), power = r.f64(), ticks = r.u64(), missed = r.u64(), bucket = r.f64();
      const latency = Uint32Array.from({ length: r.u32() }, () => r.u32());
      const removed = Array.from({ length: r.u32() }, () => r.f64());
      const forces = Array.from({ length: r.u32() }, () => r.f64());
      return { kind: "instruments", X_WG, power, ticks, missed, bucket, latency, removed, forces, under: r.u32() };
    }
    case 10: {
      const X_WC = r.pose(), cellSize = r.f64(), dims: Vec3 = [r.u32(), r.u32(), r.u32()];
      const first = r.f64(), step = r.f64(), body = r.f64(), threshold = r.f64();
      const structures = Array.from({ length: r.u32() }, () => ({ now: r.f64(), peak: r.f64(), timeAbove: r.f64() }));
      const cells = r.read(dims[0] * dims[1] * dims[2]);
      return { kind: "heat", X_WC, cellSize, dims, first, step, body, threshold, structures, cells };
    }
    default:
      return null;
  }
}

/** A version of the page that differs from that of a message. */
export interface OtherVersion {
  older: boolean; // than the sender of the message
  text: string; // completes "This page ... than the program"
}

/** For a message of another version, whether the page is older or newer than its sender; null for the same version. */
export function otherVersion(bytes: Uint8Array): OtherVersion | null {
  const theirs = bytes[1] ?? kVersion;
  if (theirs === kVersion) return null;
  const older = theirs > kVersion;
  return { older, text: `${older ? "is older" : "is newer"} (protocol ${kVersion}, not ${theirs})` };
}

/** @returns null when any byte of the message is invalid */
export function decode(bytes: Uint8Array): Message | null {
  try {
    const r = new Reader(bytes);
    const kind = r.u8();
    if (r.u8() !== kVersion || r.u16() !== 0) return null;
    const message = readMessage(kind, r);
    return r.complete ? message : null;
  } catch {
    return null;
  }
}

class Writer {
  private bytes: number[];
  private number = new DataView(new ArrayBuffer(8));
  constructor(kind: number) { this.bytes = [kind, kVersion, 0, 0]; }
  u8(value: number) { this.bytes.push(value & 255); return this; }
  u16(value: number) { return this.u8(value).u8(value >> 8); }
  f64(value: number) {
    this.number.setFloat64(0, value, true);
    for (let n = 0; n < 8; ++n) this.bytes.push(this.number.getUint8(n));
    return this;
  }
  all(values: number[]) { values.forEach((value) => this.f64(value)); return this; }
  text(value: string) { this.bytes.push(...new TextEncoder().encode(value)); return this; }
  finish() { return Uint8Array.from(this.bytes); }
}

export const commands = {
  spindleSpeed: (speed: number) => new Writer(1).f64(speed).finish(),
  undoMark: () => new Writer(2).finish(),
  undo: () => new Writer(3).finish(),
  redo: () => new Writer(4).finish(),
  hold: (hold: boolean) => new Writer(5).u8(hold ? 1 : 0).finish(),
  moveHand: (X_WH: Pose, pressed: boolean) =>
    new Writer(6).all(X_WH.rotation).all(X_WH.translation).u8(pressed ? 1 : 0).finish(),
  stop: () => new Writer(7).finish(),
  lookAt: (point: Vec3) => new Writer(8).all(point).finish(),
  setControl: (id: number, value: number) => new Writer(9).u16(id).f64(value).finish(),
  load: (name: string) => new Writer(10).text(name).finish(),
};
