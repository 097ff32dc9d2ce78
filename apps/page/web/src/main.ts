// SPDX-License-Identifier: Apache-2.0
// The page: shows the messages of the program, and sends the commands of hand and panels.
import * as three from "three";
import { Eye } from "./camera.ts";
import { Curves, drawLatency } from "./curves.ts";
import { Hand } from "./hand.ts";
import { HeatTable } from "./heat.ts";
import { Indicators } from "./indicators.ts";
import { connect, type Link } from "./link.ts";
import { ownPanels, viewButtons } from "./own_panels.ts";
import { element, Panels } from "./panels.ts";
import { Picture } from "./picture.ts";
import { Pointer } from "./pointer.ts";
import { commands, type Heat, type Instruments, type Message, type Pose, type Snapshot } from "./protocol.ts";
import { showPlayer } from "./player.ts";
import { Workpiece } from "./scene.ts";
import { Speaker } from "./sound.ts";
import { ToolView } from "./tool.ts";

const byId = <T extends HTMLElement>(id: string) => document.getElementById(id) as T;
const canvas = byId<HTMLCanvasElement>("scene");

class Page {
  readonly scene = new three.Scene();
  readonly workpiece = new Workpiece();
  readonly eye = new Eye(this.workpiece);
  readonly hand = new Hand();
  readonly tool = new ToolView(this.scene);
  readonly speaker = new Speaker();
  readonly curves = new Curves(byId("force-curve"), byId("torque-curve"));
  readonly indicators = new Indicators(byId);
  readonly heatTable = new HeatTable(byId);
  readonly path: { time: number; X_WH: Pose; pressed: boolean }[] = []; // poses that were sent, newest last
  snapshot: Snapshot | null = null;
  instruments: Instruments | null = null;
  heat: Heat | null = null; // null: off
  frames = 0;
  frameTime = 0; // ms between drawn pictures, running mean
  writer = false;
  link: Link = { send: () => undefined, open: false };
  picture: Picture | null = null;
  panels = new Panels(byId("panels"), (command) => this.send(command));
  changed = true;
  private framed = false;
  private began = 0;
  private moved = false;
  private placed = false;
  private hasTool = false;
  private pointer: Pointer;
  private showOwn = () => {};
  private last = performance.now();
  private drawn = 0;
  private charted = 0;

  constructor() {
    try {
      this.picture = new Picture(canvas);
    } catch {
      const blank = byId("blank");
      blank.hidden = false;
      blank.textContent = "This browser does not support WebGL: turn on hardware acceleration, or use another browser. " +
        "Panels and curves work.";
    }
    this.scene.add(this.workpiece.group, new three.HemisphereLight(0xffffff, 0x8a94a0, 1.5));
    const sun = new three.DirectionalLight(0xffffff, 2);
    sun.position.set(0.3, 0.5, 0.8);
    this.scene.add(sun);
    this.pointer = new Pointer({
      canvas, eye: this.eye, hand: this.hand, picture: this.picture, hit: (ray) => this.workpiece.hit(ray),
      leads: () => this.writer,
      mayMove: () => this.writer && this.placed,
      moved: () => { this.moved = true; },
    });
    if (this.picture)
      this.showOwn = ownPanels({
        parent: byId("panels"), eye: this.eye, hand: this.hand, picture: this.picture, tool: this.tool,
        workpiece: this.workpiece, changed: () => { this.changed = true; },
      });
    viewButtons(byId("views"), (name) => this.look(name), () => this.whole());
    canvas.addEventListener("pointerdown", () => { this.framed = true; });
    new ResizeObserver(() => this.resize()).observe(byId("stage"));
    // A hidden page draws no further picture.
    document.addEventListener("visibilitychange", () => { if (document.hidden) this.sendHand(); });
    this.setUpButtons();
    this.setTheme(matchMedia("(prefers-color-scheme: light)").matches ? "light" : "dark");
  }

  handle(message: Message) {
    switch (message.kind) {
      case "hello":
        this.workpiece.begin(message);
        this.lead(message.writer);
        if (!document.body.classList.contains("replay"))
          this.indicators.role(message.writer ? "in control" : "watching");
        this.indicators.begin(message);
        this.heatTable.begin(message);
        this.heat = null;
        this.pointer.begin();
        this.began = performance.now();
        this.framed = this.placed = false;
        this.snapshot = this.instruments = null;
        this.curves.ring.clear();
        this.send(commands.lookAt([0, 0, 0])); // restarts a scene that paused when its last writer left
        break;
      case "page":
        this.workpiece.put(message);
        if (!this.framed) this.whole(false);
        break;
      case "snapshot":
        this.snapshot = message;
        this.indicators.settle(message);
        this.place();
        break;
      case "tool":
        this.tool.use(message);
        this.hand.useTool(message.X_HT, message.tip);
        this.hasTool = true;
        if (this.placed) this.moved = true;
        break;
      case "controls":
        this.panels.show(message.controls);
        this.panels.enable(this.writer);
        this.indicators.controls(this.panels);
        break;
      case "trace": this.curves.ring.add(message.first, message.samples); return;
      case "notice": this.indicators.notice(message.text, message.severity); return;
      case "sound": this.speaker.play(message.samples); return;
      case "instruments": this.instruments = message; break;
      case "heat":
        this.heat = message.cells.length > 0 ? message : null;
        this.workpiece.warm(message);
        this.heatTable.show(message);
        break;
    }
    this.changed = true;
  }

  private lead(leads: boolean) {
    this.writer = leads;
    document.body.classList.toggle("looks", !leads);
    this.panels.enable(leads);
  }

  /** The connection has ended: the last state is no longer valid. */
  lost(text: string) {
    this.lead(false);
    this.snapshot = this.instruments = null;
    this.indicators.lost(text);
  }

  private place() {
    if (this.placed || !this.hasTool || !this.snapshot) return;
    this.hand.begin(this.instruments?.X_WG ?? this.snapshot.X_WT);
    this.placed = true;
    const back = new three.Vector3(...this.hand.axis).addScaledVector(new three.Vector3(0.4, -0.9, 0.25), 0.75);
    this.eye.lookAlong(back);
  }

  look(name: string) {
    this.framed = true;
    this.eye.look(name);
  }
  whole(keep = true) {
    if (this.workpiece.bounds.isEmpty()) return;
    this.eye.frame(this.workpiece.bounds);
    this.framed = keep || performance.now() - this.began > 6000;
  }

  frame(now: number) {
    const seconds = Math.min(0.25, (now - this.last) / 1e3);
    this.last = now;
    this.pointer.frame(seconds);
    this.sendHand();
    const pause = this.picture?.pause(now) ?? 0; // without a graphics card the loop needs the processor
    if ((this.changed || this.eye.changed) && now - this.drawn >= pause) this.draw(now, seconds);
    if (now - this.charted < pause) return;
    this.charted = now;
    this.curves.draw();
  }

  private sendHand() {
    if (!this.moved || !this.link.open) return;
    this.moved = false;
    const { X_WH, pressed } = this.hand;
    this.path.push({ time: performance.now() / 1e3, X_WH, pressed });
    if (this.path.length > 20_000) this.path.shift();
    this.send(commands.moveHand(X_WH, pressed));
  }

  private draw(now: number, seconds: number) {
    this.changed = this.eye.changed = false;
    this.showOwn();
    const { snapshot, picture } = this;
    if (snapshot) {
      this.tool.place(snapshot, this.instruments?.X_WG ?? null, seconds);
      this.indicators.show(snapshot, this.instruments, this.curves.ring);
    }
    if (this.instruments) drawLatency(byId<HTMLCanvasElement>("latency"), this.instruments);
    if (!picture) return;
    const box = canvas.getBoundingClientRect();
    this.eye.update(box.width / picture.columns / Math.max(1, box.height));
    const key = this.eye.back.addScaledVector(this.eye.right, -0.55).addScaledVector(this.eye.up, 0.75).normalize();
    this.workpiece.lightFrom(key);
    picture.draw(this.scene, this.eye.camera, Math.max(0.6, this.eye.distance / 28));
    ++this.frames;
    this.frameTime = this.frameTime === 0 ? now - this.drawn : 0.9 * this.frameTime + 0.1 * (now - this.drawn);
    this.drawn = now;
  }

  private resize() {
    const box = byId("stage").getBoundingClientRect();
    // The page may frame the workpiece before the first picture, and needs the aspect for it.
    this.eye.camera.aspect = box.width / Math.max(1, box.height);
    this.picture?.resize(Math.max(1, Math.floor(box.width)), Math.max(1, Math.floor(box.height)));
    this.changed = true;
  }

  setTheme(theme: string) {
    document.documentElement.dataset.theme = theme;
    byId("theme").textContent = theme === "dark" ? "Light" : "Dark";
    this.scene.background = new three.Color(theme === "dark" ? 0x0b0f14 : 0xc9d4de);
    this.curves.restyle();
    this.changed = true;
  }

  /** Sends a command if this page is the writer. The server disconnects other pages that send. */
  send(command: Uint8Array) {
    if (this.writer) this.link.send(command);
  }

  stop() { this.send(commands.stop()); }

  private setUpButtons() {
    byId("undo").onclick = () => this.send(commands.undo());
    byId("redo").onclick = () => this.send(commands.redo());
    byId("stop").onclick = () => this.stop();
    const record = byId("record");
    record.onclick = () => this.panels.set("Record", record.getAttribute("aria-pressed") === "true" ? 0 : 1);
    byId("theme").onclick = () => this.setTheme(document.documentElement.dataset.theme === "dark" ? "light" : "dark");
    const speaker = byId("speaker");
    speaker.onclick = async () => {
      await (this.speaker.on ? this.speaker.stop() : this.speaker.start());
      speaker.setAttribute("aria-pressed", String(this.speaker.on));
    };
    addEventListener("keydown", (event) => this.key(event));
  }

  private key(event: KeyboardEvent) {
    const typing = event.target instanceof HTMLInputElement && event.target.type === "text";
    if (event.key === "Escape" && !byId<HTMLDialogElement>("help").open) this.stop();
    if (typing) return;
    const control = event.ctrlKey || event.metaKey;
    if (control && event.key === "z") this.send(event.shiftKey ? commands.redo() : commands.undo());
    else if (control && event.key === "y") this.send(commands.redo());
    else if (event.key === "?") byId<HTMLDialogElement>("help").showModal();
    else if (!control && /^[0-7]$/.test(event.key) && !(event.target instanceof HTMLSelectElement)) {
      if (event.key === "0") this.whole();
      else byId("views").querySelectorAll("button")[Number(event.key) - 1].click();
    } else return;
    event.preventDefault();
  }

  load(name: string) { this.send(commands.load(name)); }
}

function loadPanel(page: Page) {
  const field = element("input",
                        { type: "text", "aria-label": "File", placeholder: "path of a file", maxlength: "100" });
  field.style.flex = "1";
  const open = element("button", { type: "button" }, "Open");
  open.onclick = () => page.load(field.value);
  const scenes = ["clay", "molar", "skull"].map((name) => {
    const button = element("button", { type: "button" }, name);
    button.onclick = () => page.load(name);
    return button;
  });
  const details = element("details", { "data-panel": "load" }, element("summary", {}, "Load"),
                          element("fieldset", { class: "server" }, ...scenes, field, open));
  byId("panels").prepend(details);
}

const page = new Page();
(window as unknown as { hapticut: Page }).hapticut = page; // for the console, and for tests
page.picture?.renderer.setAnimationLoop((now) => page.frame(now));
if (!page.picture) setInterval(() => page.frame(performance.now()), 16);
if (!showPlayer(page, byId)) {
  loadPanel(page);
  page.link = connect(new URLSearchParams(location.search).get("token") ?? "", (message) => page.handle(message),
                      (text) => page.lost(text));
}
