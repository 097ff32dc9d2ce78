// SPDX-License-Identifier: Apache-2.0
// Force and torque of the last ten seconds, as minimum and maximum of each column, and the lateness of the loop.
import uPlot from "uplot";
import type { Instruments } from "./protocol.ts";
import { TraceRing } from "./trace.ts";

const kColumns = 260, kSeconds = 10;
const kAxes = ["x", "y", "z"];

export class Curves {
  readonly ring = new TraceRing();
  private force: uPlot;
  private torque: uPlot;
  private shown = -1;

  constructor(force: HTMLElement, torque: HTMLElement) {
    this.force = this.plot(force, "N");
    this.torque = this.plot(torque, "mN m");
    new ResizeObserver(() => this.resize(force, torque)).observe(force);
  }

  draw() {
    if (this.ring.last === this.shown) return;
    this.shown = this.ring.last;
    this.force.setData(this.data(0, 1));
    this.torque.setData(this.data(3, 1e3));
  }
  restyle() {
    this.force.redraw();
    this.torque.redraw();
  }

  private data(first: number, unit: number): uPlot.AlignedData {
    const time = Array.from({ length: 2 * kColumns }, (_, n) => kSeconds * (n / (2 * kColumns) - 1));
    const rows = [0, 1, 2].map((axis) => {
      const { low, high } = this.ring.decimate(first + axis, kColumns);
      return Array.from({ length: 2 * kColumns }, (_, n) => {
        const value = (n % 2 === 0 ? low : high)[n >> 1];
        return Number.isNaN(value) ? null : value * unit;
      });
    });
    return [time, ...rows] as uPlot.AlignedData;
  }

  private plot(parent: HTMLElement, unit: string): uPlot {
    const style = getComputedStyle(parent), ink = () => style.color;
    const maxAbs = (low: number, high: number) => Math.max(Math.abs(low || 0), Math.abs(high || 0), 0.1);
    const axis = (size: number): uPlot.Axis => ({
      stroke: ink, size, space: 20, font: "11px system-ui", grid: { stroke: "#8884", width: 1 }, ticks: { show: false },
    });
    return new uPlot({
      width: 300, height: 112, legend: { show: false }, cursor: { show: false },
      scales: {
        x: { time: false, range: [-kSeconds, 0] },
        y: { range: (_u, low, high) => [-1.08 * maxAbs(low, high), 1.08 * maxAbs(low, high)] },
      },
      axes: [{ ...axis(20), space: 50, values: (_u, ticks) => ticks.map((t) => `${t} s`) },
             { ...axis(46), splits: (_u, _n, low, high) => [low / 1.08, 0, high / 1.08],
                            values: (_u, ticks) => ticks.map((t) => `${+t.toPrecision(2)}`), label: unit, labelSize: 13,
               labelFont: "11px system-ui" }],
      series: [{}, ...kAxes.map((label) => ({ label, stroke: () => style.getPropertyValue(`--${label}`), width: 1, points: { show: false } }))],
    }, [[], [], [], []] as unknown as uPlot.AlignedData, parent);
  }

  private resize(force: HTMLElement, torque: HTMLElement) {
    const width = Math.max(120, force.clientWidth);
    if (width === this.force.width) return;
    this.force.setSize({ width, height: 112 });
    this.torque.setSize({ width: Math.max(120, torque.clientWidth), height: 112 });
  }
}

/** [us] The lateness below which a fraction of the ticks was. */
export function quantile(latency: Uint32Array, bucket: number, fraction: number): number {
  const total = latency.reduce((sum, count) => sum + count, 0);
  let seen = 0;
  for (let n = 0; n < latency.length; ++n) {
    seen += latency[n];
    if (seen >= fraction * total && seen > 0) return 1e6 * bucket * (n + 1);
  }
  return 0;
}

/** Draws bars on a logarithmic scale, with a line at one millisecond. */
export function drawLatency(canvas: HTMLCanvasElement, { latency, bucket }: Instruments) {
  const context = canvas.getContext("2d")!, { width, height } = canvas;
  const style = getComputedStyle(canvas);
  context.clearRect(0, 0, width, height);
  const maxCount = Math.max(...latency, 1), bar = width / latency.length;
  context.fillStyle = style.getPropertyValue("--accent") || "#4c8dff";
  latency.forEach((count, n) => {
    const tall = count > 0 ? Math.max(2, (height * Math.log1p(count)) / Math.log1p(maxCount)) : 0;
    context.fillRect(n * bar, height - tall, Math.max(1, bar - 1), tall);
  });
  context.fillStyle = "#e5534b";
  context.fillRect(1e-3 / bucket * bar, 0, 2, height);
}
