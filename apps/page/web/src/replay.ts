// SPDX-License-Identifier: Apache-2.0
// A recording: the messages of a server with their times. It can be played, scrubbed and stepped.
//   "HCRP", version (uint32: 1), then for each: time (float64, s), length (uint32), the message
import { decode, type Message, otherVersion, type SurfacePage } from "./protocol.ts";

export interface Timed {
  time: number;
  message: Message;
}

export function readRecording(bytes: Uint8Array): Timed[] {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const magic = new TextDecoder().decode(bytes.subarray(0, 4));
  if (magic !== "HCRP" || view.getUint32(4, true) !== 1)
    throw new Error("This page cannot play this recording: export it again with the program that made the page.");
  const all: Timed[] = [];
  for (let at = 8; at + 12 <= bytes.length;) {
    const time = view.getFloat64(at, true), length = view.getUint32(at + 8, true);
    const part = bytes.slice(at + 12, at + 12 + length);
    const other = otherVersion(part);
    if (other) throw new Error(`This page ${other.text} than its recording: export it again with the present program.`);
    const message = decode(part);
    if (message === null) throw new Error("The recording is damaged: export it again.");
    all.push({ time, message });
    at += 12 + length;
  }
  return all;
}

/** Decodes a recording that is embedded in the page. */
export const fromBase64 = (text: string) => Uint8Array.from(atob(text.replace(/\s/g, "")), (c) => c.charCodeAt(0));

/** Decompresses gzip data; other data is returned unchanged. */
export async function unpack(raw: Uint8Array): Promise<Uint8Array> {
  if (raw[0] !== 0x1f || raw[1] !== 0x8b) return raw;
  const stream = new Blob([raw as BlobPart]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

export class Player {
  playing = false;
  speed = 1;
  readonly duration: number;
  readonly frames: number[]; // times of the snapshots
  private versions = new Map<string, { time: number; page: SurfacePage }[]>();
  private shown = new Map<string, SurfacePage>();
  private others: Timed[] = [];
  private next = 0;
  private at = 0;

  constructor(all: Timed[], private show: (message: Message) => void, private onRewind: () => void = () => undefined) {
    for (const { time, message } of all) {
      if (message.kind !== "page") {
        this.others.push({ time, message });
        continue;
      }
      const name = message.origin.join();
      this.versions.set(name, [...(this.versions.get(name) ?? []), { time, page: message }]);
    }
    this.frames = this.others.filter((one) => one.message.kind === "snapshot").map((one) => one.time);
    this.duration = this.frames.at(-1) ?? 0;
  }

  get time() { return this.at; }

  advance(seconds: number) {
    if (!this.playing) return;
    this.seek(Math.min(this.duration, this.at + seconds * this.speed));
    if (this.at >= this.duration) this.playing = false;
  }

  step(by: number) {
    const here = this.frames.findIndex((time) => time >= this.at - 1e-9);
    const to = Math.max(0, Math.min(this.frames.length - 1, (here < 0 ? this.frames.length - 1 : here) + by));
    this.playing = false;
    this.seek(this.frames[to] ?? 0);
  }

  /**
   * Shows the state at a time: the pages that differ, the traces since the last call, and the newest message of each
   * other kind. After a step back, it counts from the start of the recording.
   */
  seek(time: number) {
    if (time < this.at) {
      this.next = 0;
      this.onRewind();
    }
    this.at = time;
    const latest = new Map<string, Message>();
    for (; this.next < this.others.length && this.others[this.next].time <= time; ++this.next) {
      const message = this.others[this.next].message;
      if (message.kind === "trace") this.show(message);
      else latest.set(message.kind, message);
    }
    for (const kind of ["hello", "tool", "controls", "snapshot", "instruments", "notice"]) {
      const message = latest.get(kind);
      if (message && !(kind === "hello" && this.shown.size > 0)) this.show(message);
    }
    for (const [name, versions] of this.versions) {
      let page = versions[0].time <= time ? versions[0].page : null;
      for (const one of versions) if (one.time <= time) page = one.page;
      if (page === null || this.shown.get(name) === page) continue;
      this.shown.set(name, page);
      this.show(page);
    }
  }
}
