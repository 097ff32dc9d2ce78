// SPDX-License-Identifier: Apache-2.0
// Texts and numbers of the page: the guard, the notices, the meters.
import { quantile } from "./curves.ts";
import { sharesOf, textOfCut } from "./cut.ts";
import { type GuardState, type Tone, guardState } from "./guard.ts";
import { swatch } from "./heat.ts";
import { element, type Panels } from "./panels.ts";
import type { Hello, Instruments, Snapshot } from "./protocol.ts";
import type { TraceRing } from "./trace.ts";

const kTogether = 5000; // ms

type ById = <T extends HTMLElement>(id: string) => T;

export class Indicators {
  private numbers = new Map<string, HTMLElement>();
  private removed: HTMLElement[] = [];
  private materials: Hello["materials"] = [];
  private tone: Tone = "waits";
  private notices: { text: string; severity: number; time: number }[] = [];
  private sentences: Pick<Hello, "arming" | "status"> = { arming: [], status: [] };

  constructor(private byId: ById) {}

  role(text: string) { this.byId("role").textContent = text; }
  /** Shows the notices of the last seconds together, so that none disappears at once. */
  notice(text: string, severity: number) {
    const time = performance.now();
    this.notices = this.notices.filter((one) => one.text !== text && time - one.time < kTogether).slice(-2);
    this.notices.push({ text, severity, time });
    this.showNotices();
  }
  private showNotices() {
    const notice = this.byId("notice");
    notice.textContent = notice.title = this.notices.map(({ text }) => text).join(" ");
    notice.dataset.severity = String(Math.max(0, ...this.notices.map(({ severity }) => severity)));
  }
  /** Removes the warnings of the guard when the force comes back. */
  settle(snapshot: Snapshot) {
    const { tone } = guardState(this.sentences, snapshot);
    if (tone !== this.tone && (tone === "calm" || tone === "works")) {
      this.notices = this.notices.filter(({ severity }) => severity !== 1);
      this.showNotices();
    }
    this.tone = tone;
  }
  lost(text: string) {
    this.role("disconnected");
    this.byId("role").dataset.tone = "fault";
    this.notices = [];
    this.notice(text, 2);
    this.guard({ name: "unknown", tone: "fault", text: "" });
  }
  private guard({ name, tone, text }: GuardState) {
    const guard = this.byId("guard");
    guard.textContent = `guard: ${name}`;
    guard.dataset.tone = this.byId("rim").dataset.tone = tone;
    this.byId("cure").textContent = text;
  }

  begin(hello: Hello) {
    this.sentences = hello;
    this.materials = hello.materials;
    this.cut(null);
    delete this.byId("role").dataset.tone;
    const body = this.byId("removed").querySelector("tbody")!;
    body.replaceChildren();
    this.removed = hello.materials.map(({ name, color }) => {
      const value = element("td", {}, "0 mm³");
      body.append(element("tr", {}, element("td", {}, swatch(color), name.replaceAll("_", " ")), value));
      return value;
    });
  }

  controls(panels: Panels) {
    const recording = panels.control("Record")?.value === 1;
    this.byId("record").setAttribute("aria-pressed", String(recording));
  }

  show(snapshot: Snapshot, instruments: Instruments | null, trace: TraceRing) {
    this.guard(guardState(this.sentences, snapshot));
    const norm = (v: number[]) => Math.hypot(...v);
    this.number("force", `${norm(snapshot.force).toFixed(2)} N`);
    this.number("torque", `${(1e3 * norm([3, 4, 5].map((n) => trace.newest(n)))).toFixed(1)} mN m`);
    this.number("spindle", `${Math.round((snapshot.speed * 30) / Math.PI).toLocaleString("en")} rpm`);
    this.number("load", `${(instruments?.power ?? 0).toFixed(2)} W`);
    this.number("depth", `${(1e3 * snapshot.depth).toFixed(2)} mm`);
    this.number("removed", `${(1e9 * snapshot.removed).toFixed(2)} mm³`);
    (this.byId("undo") as HTMLButtonElement).disabled = snapshot.undoMarks === 0;
    (this.byId("redo") as HTMLButtonElement).disabled = snapshot.redoMarks === 0;
    this.cut(instruments);
    if (!instruments) return;
    this.removed.forEach((cell, n) => {
      cell.textContent = `${(1e9 * (instruments.removed[n] ?? 0)).toFixed(2)} mm³`;
    });
    const p99 = quantile(instruments.latency, instruments.bucket, 0.99);
    this.byId("lateness").textContent = `99 % below ${Math.round(p99)} µs, ${instruments.missed} missed`;
  }

  /** The materials that are cut, with their shares of the force, else the one under the tip. */
  private cut(instruments: Instruments | null) {
    const { forces, under } = instruments ?? { forces: [], under: 0 };
    const shares = sharesOf(this.materials, forces);
    this.byId("cut-label").textContent = shares.length > 0 ? "cuts" : "under the tip";
    this.byId("cut").textContent = textOfCut(this.materials, { forces, under });
    this.byId("cut-shares").replaceChildren(...shares.map(({ color, part }) => {
      const bar = element("i");
      bar.style.background = `rgb(${color.join()})`;
      bar.style.flexGrow = String(part);
      return bar;
    }));
  }

  private number(name: string, text: string) {
    let cell = this.numbers.get(name);
    if (!cell) {
      cell = element("dd", { "aria-label": name });
      this.byId("numbers").append(element("dt", {}, name), cell);
      this.numbers.set(name, cell);
    }
    if (cell.textContent !== text) cell.textContent = text;
  }
}
