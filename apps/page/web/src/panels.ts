// SPDX-License-Identifier: Apache-2.0
// The panels of controls. The program describes each control, and the page draws it.
import { commands, type Control } from "./protocol.ts";

export const element = <K extends keyof HTMLElementTagNameMap>(
  tag: K, attributes: Record<string, string> = {}, ...children: (Node | string)[]): HTMLElementTagNameMap[K] => {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
};

/** A number with at most six digits. */
export const shown = (value: number): string => {
  if (value === 0) return "0";
  const size = Math.abs(value);
  return size >= 1e7 || size < 1e-3 ? value.toExponential(2).replace("e+", "e") : String(+value.toPrecision(6));
};

/** The typed number; null if it is not a number within the range. */
export function parse(text: string, min: number, max: number): number | null {
  const value = Number(text.trim().replace(",", "."));
  return text.trim() === "" || !Number.isFinite(value) || value < min || value > max ? null : value;
}

/** The known range of a control, and its usual value; empty if nothing is known. */
export function knownText({ low, typical, high, unit, source }: Control): string {
  if (source === "") return "";
  const range = low === high ? "no range" : `${short(low)} ... ${short(high)}`;
  return `typical ${short(typical)}${unit && ` ${unit}`}, ${range}`;
}
const short = (value: number) => shown(+value.toPrecision(3));

const isWide = (control: Control) => control.max / Math.max(control.min, 1e-12) > 2000 || !Number.isFinite(control.max);

/** The known range as a small text, with its source behind it. */
function known(control: Control): HTMLElement[] {
  const text = knownText(control);
  return text ? [element("small", { class: "known", title: `Source: ${control.source}` }, text)] : [];
}

export class Panels {
  private controls = new Map<number, Control>();
  private rows = new Map<number, { update: (control: Control) => void }>();
  private order = "";

  constructor(private parent: HTMLElement, private send: (command: Uint8Array) => void) {}

  control(label: string, panel?: string): Control | undefined {
    return [...this.controls.values()].find((one) => one.label === label && (!panel || one.panel === panel));
  }
  set(label: string, value: number) {
    const control = this.control(label);
    if (control) this.send(commands.setControl(control.id, value));
  }

  show(all: Control[]) {
    const order = all.map((one) => [one.id, one.panel, one.label, one.control, one.choices.join("|"), knownText(one), one.source].join("/")).join();
    this.controls = new Map(all.map((one) => [one.id, one]));
    if (order !== this.order) this.build(all);
    this.order = order;
    for (const control of all) {
      this.rows.get(control.id)?.update(control);
      const why = this.parent.querySelector<HTMLElement>(`#idle-${control.id}`);
      if (why) why.textContent = control.idle;
    }
  }

  enable(may: boolean) {
    this.parent.querySelectorAll<HTMLFieldSetElement>("fieldset.server").forEach((set) => { set.disabled = !may; });
  }

  private build(all: Control[]) {
    this.parent.querySelectorAll("details.server").forEach((old) => old.remove());
    this.rows.clear();
    const before = this.parent.firstChild;
    for (const panel of new Set(all.map((one) => one.panel))) {
      const box = element("fieldset", { class: "server" });
      const name = panel.charAt(0).toUpperCase() + panel.slice(1);
      const details = element("details", { class: "server", "data-panel": panel }, element("summary", {}, name), box);
      if (panel === "application" || panel === "tool") details.open = true;
      for (const control of all.filter((one) => one.panel === panel))
        box.append(this.row(control), ...known(control), element("small", { class: "idle", id: `idle-${control.id}` }));
      this.parent.insertBefore(details, before);
    }
  }

  private row(control: Control): HTMLElement {
    switch (control.control) {
      case "button": {
        const button = element("button", { type: "button" }, control.label);
        button.onclick = () => this.send(commands.setControl(control.id, 1));
        this.rows.set(control.id, { update: (now) => { button.disabled = now.value === 0; } });
        return button;
      }
      case "switch": {
        const box = element("input", { type: "checkbox" });
        box.onchange = () => this.send(commands.setControl(control.id, box.checked ? 1 : 0));
        this.rows.set(control.id, { update: (now) => { box.checked = now.value !== 0; } });
        return element("label", { class: "row switch" }, box, element("span", {}, control.label));
      }
      case "choice": {
        const select = element("select");
        control.choices.forEach((name, n) => select.append(element("option", { value: String(n) }, name.replaceAll("_", " "))));
        select.onchange = () => this.send(commands.setControl(control.id, Number(select.value)));
        this.rows.set(control.id, { update: (now) => { select.value = String(now.value); } });
        return element("label", { class: "row" }, element("span", {}, control.label), select);
      }
      default:
        return this.numberRow(control);
    }
  }

  private numberRow(control: Control): HTMLElement {
    const field = element("input", { type: "text", inputmode: "decimal", size: "8" });
    const label = element("label", { class: "row" }, element("span", {}, control.label), field,
                          element("span", { class: "unit" }, control.unit));
    field.title = `${shown(control.min)} ... ${shown(control.max)} ${control.unit}`;
    const change = (value: number | null) => {
      field.setAttribute("aria-invalid", String(value === null));
      if (value !== null) this.send(commands.setControl(control.id, value));
    };
    field.onchange = () => change(parse(field.value, control.min, control.max));
    field.onkeydown = (event) => {
      const step = { ArrowUp: 1, ArrowDown: -1 }[event.key];
      if (step === undefined) return;
      event.preventDefault();
      const now = this.controls.get(control.id) ?? control;
      const by = isWide(now) ? Math.max(Math.abs(now.value) * 0.1, 1e-9) : (now.max - now.min) / 100;
      change(Math.min(now.max, Math.max(now.min, now.value + step * by)));
    };
    this.rows.set(control.id, {
      update: (now) => {
        if (document.activeElement === field && field.getAttribute("aria-invalid") === "true") return;
        field.value = shown(now.value);
        field.setAttribute("aria-invalid", "false");
      },
    });
    return label;
  }
}
