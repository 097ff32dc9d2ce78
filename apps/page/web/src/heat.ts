// SPDX-License-Identifier: Apache-2.0
// The colours of temperatures: one table for the picture and the legend. The cells of a message become a texture, in
// which the surface looks up its temperature.
import * as three from "three";
import { element } from "./panels.ts";
import type { Heat, Hello } from "./protocol.ts";

/** A colour of the scale: of a temperature [deg C], and how much of the material's own colour it covers. */
export interface Stop {
  at: number;
  color: [number, number, number];
  cover: number;
}

const kNeutral = 1.5; // K around the temperature of the body without a colour
const kCold = 15, kHot = 45; // K of the scale below the body, and above the threshold

/** Blue for cooled, nothing for the body, yellow below the threshold, orange at it, then red and nearly black. */
export function scaleOf({ body, threshold }: Pick<Heat, "body" | "threshold">): Stop[] {
  const warm = body + kNeutral, between = threshold - warm;
  return [
    { at: body - kCold, color: [20, 75, 215], cover: 0.85 },
    { at: body - 0.5 * kCold, color: [80, 155, 245], cover: 0.7 },
    { at: body - kNeutral, color: [150, 190, 240], cover: 0 },
    { at: warm, color: [255, 236, 130], cover: 0 },
    { at: warm + 0.4 * between, color: [255, 225, 70], cover: 0.85 },
    { at: threshold, color: [255, 150, 20], cover: 0.95 },
    { at: threshold + 0.3 * kHot, color: [225, 35, 20], cover: 1 },
    { at: threshold + kHot, color: [70, 0, 40], cover: 1 },
  ];
}

/** The colour of a temperature, between the stops around it. */
export function colorAt(scale: Stop[], temperature: number): Stop {
  const next = scale.findIndex((stop) => stop.at >= temperature);
  if (next <= 0) return scale[next === 0 ? 0 : scale.length - 1];
  const a = scale[next - 1], b = scale[next], part = (temperature - a.at) / (b.at - a.at);
  const mix = (low: number, high: number) => low + part * (high - low);
  return { at: temperature, cover: mix(a.cover, b.cover),
           color: [0, 1, 2].map((n) => mix(a.color[n], b.color[n])) as Stop["color"] };
}

/** Two bytes for each cell: its temperature, and 255 where it contains material. */
export function texels(cells: Uint8Array): Uint8Array {
  const data = new Uint8Array(2 * cells.length);
  cells.forEach((byte, n) => {
    data[2 * n] = byte;
    data[2 * n + 1] = byte === 0 ? 0 : 255;
  });
  return data;
}

const kStops = 8;

/** What a fragment shader needs for `heated`: the colour of a place [mm] by its temperature, with the isotherm. */
export const heatShader = `
uniform highp sampler3D heatCells;
uniform mat4 toHeat;
uniform vec4 heatScale; // temperature of byte 0, of 255 bytes, of the body, of the threshold
uniform vec4 heatStops[${kStops}]; // linear colour, cover
uniform float heatAt[${kStops}];
uniform bool showsHeat;
float temperatureAt(vec3 place) {
  vec2 cell = texture(heatCells, (toHeat * vec4(place, 1.0)).xyz).rg;
  return cell.g > 0.01 ? heatScale.x + heatScale.y * cell.r / cell.g : heatScale.z;
}
vec3 heated(vec3 own, float temperature, float slope) {
  vec4 stop = heatStops[0];
  for (int n = 1; n < ${kStops}; ++n)
    stop = mix(stop, heatStops[n], clamp((temperature - heatAt[n - 1]) / (heatAt[n] - heatAt[n - 1]), 0.0, 1.0));
  float line = 1.0 - smoothstep(0.8, 1.6, abs(temperature - heatScale.w) / max(slope, 1e-4));
  return mix(mix(own, stop.rgb, stop.a), vec3(0.0), line);
}`;

export class HeatColors {
  readonly uniforms = {
    heatCells: { value: emptyTexture() }, toHeat: { value: new three.Matrix4() },
    heatScale: { value: new three.Vector4() }, showsHeat: { value: false },
    heatStops: { value: Array.from({ length: kStops }, () => new three.Vector4()) },
    heatAt: { value: Array.from({ length: kStops }, (_, n) => n) },
  };

  /** @param X_WC  pose of the cells, in mm */
  use(heat: Heat, X_WC: three.Matrix4) {
    const u = this.uniforms, [x, y, z] = heat.dims, size = 1e3 * heat.cellSize;
    u.showsHeat.value = heat.cells.length > 0;
    if (heat.cells.length === 0) return;
    const old = u.heatCells.value;
    if (old.image.width === x && old.image.height === y && old.image.depth === z) {
      old.image.data = texels(heat.cells);
      old.needsUpdate = true;
    } else {
      old.dispose();
      u.heatCells.value = textureOf(texels(heat.cells), x, y, z);
    }
    u.toHeat.value.copy(X_WC).multiply(new three.Matrix4().makeScale(size * x, size * y, size * z))
      .multiply(new three.Matrix4().makeTranslation(-0.5 / x, -0.5 / y, -0.5 / z)).invert();
    u.heatScale.value.set(heat.first - heat.step, 255 * heat.step, heat.body, heat.threshold);
    scaleOf(heat).forEach(({ at, color, cover }, n) => {
      const [r, g, b] = color.map((c) => (c / 255) ** 2.2);
      u.heatStops.value[n].set(r, g, b, cover);
      u.heatAt.value[n] = at;
    });
  }
}

function textureOf(data: Uint8Array, x: number, y: number, z: number): three.Data3DTexture {
  const texture = new three.Data3DTexture(data as Uint8Array<ArrayBuffer>, x, y, z);
  texture.format = three.RGFormat;
  texture.minFilter = texture.magFilter = three.LinearFilter;
  texture.unpackAlignment = 1;
  texture.needsUpdate = true;
  return texture;
}
const emptyTexture = () => textureOf(new Uint8Array(2), 1, 1, 1);

type ById = <T extends HTMLElement>(id: string) => T;

/** The legend in the picture, and the table of temperatures beside it. */
export class HeatTable {
  private materials: Hello["materials"] = [];

  constructor(private byId: ById) {}

  begin(hello: Hello) {
    this.materials = hello.materials;
    this.hide(true);
  }

  show(heat: Heat) {
    this.hide(heat.cells.length === 0);
    if (heat.cells.length === 0) return;
    this.showLegend(heat);
    const max = (which: "now" | "peak") => Math.max(...heat.structures.map((one) => one[which]));
    this.byId("hottest").textContent = `max ${max("now").toFixed(1)}, peak ${max("peak").toFixed(1)} °C`;
    const head = element("tr", {}, ...["°C", "now", "peak", `over ${heat.threshold}`].map((text) => element("th", {}, text)));
    this.byId("temperatures").replaceChildren(head, ...heat.structures.map(({ now, peak, timeAbove }, n) => {
      const { name, color } = this.materials[n] ?? { name: `${n + 1}`, color: [0, 0, 0] };
      const cells = [now.toFixed(1), peak.toFixed(1), `${timeAbove.toFixed(1)} s`];
      const row = element("tr", {}, element("td", {}, swatch(color), name.replaceAll("_", " ")),
                          ...cells.map((text) => element("td", {}, text)));
      row.classList.toggle("above", peak > heat.threshold);
      return row;
    }));
  }

  private hide(hides: boolean) { for (const id of ["heat", "legend"]) this.byId(id).hidden = hides; }

  private showLegend(heat: Heat) {
    const scale = scaleOf(heat), low = scale[0].at, high = scale[scale.length - 1].at;
    const place = (at: number) => `${((100 * (at - low)) / (high - low)).toFixed(1)}%`;
    const colors = scale.map(({ at, color, cover }) => `rgb(${color.join()}, ${cover}) ${place(at)}`);
    const bar = element("div", { class: "bar" });
    bar.style.backgroundImage = `linear-gradient(to right, ${colors.join()})`;
    const marks = [low, heat.body, heat.threshold, high].map((at) => {
      const mark = element("span", { class: at === heat.threshold ? "mark line" : "mark" }, `${at}`);
      mark.style.left = place(at);
      return mark;
    });
    this.byId("legend").replaceChildren(bar, ...marks, element("span", { class: "unit" }, "°C"));
  }
}

export function swatch(color: number[]): HTMLElement {
  const made = element("span", { class: "swatch" });
  made.style.background = `rgb(${color.join()})`;
  return made;
}
