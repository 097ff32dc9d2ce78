// SPDX-License-Identifier: Apache-2.0
// Panels for settings of the page itself: the view, stereo, the pointer.
import * as three from "three";
import { type Eye, kViews } from "./camera.ts";
import type { Hand } from "./hand.ts";
import { element } from "./panels.ts";
import type { Picture, Stereo } from "./picture.ts";
import type { ToolView } from "./tool.ts";
import type { Workpiece } from "./scene.ts";

interface Own {
  parent: HTMLElement;
  eye: Eye;
  hand: Hand;
  picture: Picture;
  tool: ToolView;
  workpiece: Workpiece;
  changed: () => void;
}

function panel(parent: HTMLElement, name: string, ...rows: HTMLElement[]): HTMLElement {
  const details = element("details", { "data-panel": name.toLowerCase() }, element("summary", {}, name),
                          element("fieldset", {}, ...rows));
  parent.append(details);
  return details;
}

function box(label: string, value: boolean, change: (value: boolean) => void): HTMLElement {
  const input = element("input", { type: "checkbox" });
  input.checked = value;
  input.onchange = () => change(input.checked);
  return element("label", { class: "row switch" }, input, element("span", {}, label));
}

function slider(label: string, value: number, low: number, high: number, unit: string, change: (value: number) => void) {
  const input = element("input", { type: "range", min: `${low}`, max: `${high}`, step: "any" });
  const out = element("span", { class: "unit" });
  const show = (now: number) => { out.textContent = `${+now.toPrecision(3)} ${unit}`; };
  input.value = String(value);
  input.oninput = () => {
    show(Number(input.value));
    change(Number(input.value));
  };
  show(value);
  const follow = (now: number) => {
    input.value = String(now);
    show(now);
  };
  return { row: element("label", { class: "row" }, element("span", {}, label), input, out), follow };
}

function pick(label: string, names: string[], change: (name: string) => void): HTMLElement {
  const select = element("select");
  for (const name of names) select.append(element("option", {}, name));
  select.onchange = () => change(select.value);
  return element("label", { class: "row" }, element("span", {}, label), select);
}

const kAxes: Record<string, three.Vector3> = {
  "x": new three.Vector3(1, 0, 0), "-x": new three.Vector3(-1, 0, 0), "y": new three.Vector3(0, 1, 0),
  "-y": new three.Vector3(0, -1, 0), "z": new three.Vector3(0, 0, 1),
};

/** @returns a function that updates the panels after changes elsewhere */
export function ownPanels(o: Own): () => void {
  const { eye, hand, picture, tool, workpiece, changed } = o;
  let axis: three.Vector3 | null = null, fraction = 0.5;
  const cut = () => {
    const bounds = workpiece.bounds;
    if (!axis || bounds.isEmpty()) {
      workpiece.cutAt(null, 0);
    } else {
      const ends = [bounds.min.dot(axis), bounds.max.dot(axis)].sort((a, b) => a - b);
      workpiece.cutAt(axis, ends[0] + fraction * (ends[1] - ends[0]));
    }
    changed();
  };
  panel(o.parent, "View",
        pick("Section plane", ["off", ...Object.keys(kAxes)], (name) => { axis = kAxes[name] ?? null; cut(); }),
        slider("Section place", 0.5, 0, 1, "", (value) => { fraction = value; cut(); }).row,
        box("Shade cavities", true, (value) => { picture.occlusion = value; changed(); }),
        box("Show handle", true, (value) => { tool.showHandle = value; changed(); }),
        slider("Field of view", eye.camera.fov, 10, 70, "°", (value) => { eye.camera.fov = value; changed(); }).row);
  const depth = slider("Depth", hand.depth * 1e3, 0, 4, "mm", (value) => { hand.depth = value / 1e3; });
  panel(o.parent, "Pointer",
        box("Tool follows the surface", hand.follow, (value) => { hand.follow = value; }),
        depth.row).classList.add("hand");
  panel(o.parent, "Stereo",
        pick("Stereo", ["off", "side-by-side", "anaglyph"], (name) => { picture.stereo = name as Stereo; changed(); }),
        slider("Eye distance", picture.eyeDistance, 0, 12, "mm", (value) => { picture.eyeDistance = value; changed(); }).row,
        slider("Convergence", picture.convergence, 10, 300, "mm", (value) => { picture.convergence = value; changed(); }).row);
  return () => depth.follow(hand.depth * 1e3);
}

export function viewButtons(parent: HTMLElement, look: (name: string) => void, all: () => void) {
  Object.keys(kViews).forEach((name, n) => {
    const button = element("button", { type: "button", title: `Key ${n + 1}` }, name);
    button.onclick = () => look(name);
    parent.append(button);
  });
  const whole = element("button", { type: "button", title: "Key 0" }, "whole");
  whole.onclick = all;
  parent.append(whole);
}
