// SPDX-License-Identifier: Apache-2.0
// Drills the molar with the mouse, and uses every panel.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import {
  atRest, drawn, drill, isReady, middle, openPage, removed, startBrowser, startProgram, until, whole,
} from "./viewer.mjs";

let program, browser, page;
before(async () => {
  program = await startProgram("molar");
  browser = await startBrowser();
  page = await openPage(browser, program.url, { viewport: { width: 1024, height: 576 } });
  await isReady(page);
});
after(async () => {
  await browser?.close();
  await program?.stop();
});

const open = (panel) => page.locator("details", { has: page.locator("summary", { hasText: panel }) })
  .evaluate((details) => { details.open = true; });
const valueOf = (label) => page.evaluate((name) => hapticut.panels.control(name).value, label);
const button = (name) => page.getByRole("button", { name, exact: true });

test("a pointer without a pressed button removes nothing, wherever it moves", async () => {
  const { x, y } = await middle(page);
  for (const [dx, dy] of [[-120, -60], [110, 70], [-90, 90], [130, -80], [-20, 10], [0, -40]]) {
    await page.mouse.move(x + dx, y + dy);
    await page.waitForTimeout(80);
  }
  await atRest(page);
  assert.equal(await removed(page), 0);
  assert.equal(await page.evaluate(() => hapticut.snapshot.undoMarks), 0);
});

test("the mouse drills the tooth, the curve shows the force, and undo and redo restore the surface", async () => {
  const { x, y } = await middle(page);
  const curve = () => page.evaluate(() => [0, 1, 2].map((axis) => hapticut.curves.ring.decimate(axis, 50))
    .reduce(([a, b], { low, high }) => [Math.min(a, ...low.filter(Number.isFinite)), Math.max(b, ...high.filter(Number.isFinite))],
            [0, 0]));
  let low, high;
  await drill(page, { x, y: y - 40 }, Array.from({ length: 20 }, (_, n) => ({ x: x + n, y: y - 40 })), 40,
              async () => { [low, high] = await curve(); });
  const gone = await removed(page);
  assert.ok(gone > 0.1, `${gone} mm^3`);
  assert.ok(high - low > 0.01, `the curve goes from ${low} to ${high} N`);
  await whole(page);
  const before = await page.evaluate(() => hapticut.workpiece.triangles);
  await button("Undo").click();
  await until(page, () => hapticut.snapshot.undoMarks === 0 && hapticut.snapshot.redoMarks === 1 && !hapticut.snapshot.undoing);
  await until(page, (then) => hapticut.workpiece.triangles !== then, before);
  await button("Redo").click();
  await until(page, () => hapticut.snapshot.redoMarks === 0 && !hapticut.snapshot.redoing);
  await until(page, (then) => hapticut.workpiece.triangles === then, before);
});

/** Presses and moves to and fro until a condition in the page is true. */
async function drillUntil({ x, y }, condition, argument) {
  await drawn(page);
  await page.mouse.move(x, y);
  await atRest(page);
  await page.mouse.down();
  for (let n = 0; !await page.evaluate(condition, argument) && n < 2000; ++n) {
    await page.mouse.move(x + 12 * Math.sin(0.1 * n), y + 6 * Math.cos(0.1 * n));
    await page.waitForTimeout(40);
  }
  await page.mouse.up();
  await until(page, condition, argument);
}

test("a cut names its materials, warms the tooth, and water cools it; without heat the page shows none", async () => {
  const { x, y } = await middle(page);
  const set = (label, value) => page.evaluate(([name, to]) => hapticut.panels.set(name, to), [label, value]);
  const hottest = () => page.evaluate(() => Math.max(...hapticut.heat.structures.map(({ now }) => now)));
  assert.equal(await page.locator("#heat").isVisible(), false);
  await set("Heat", 1);
  await until(page, () => hapticut.heat !== null && hapticut.snapshot.arming === 4);
  assert.ok(await hottest() <= 37.1, "the whole tooth has the temperature of the body");
  assert.equal(await page.locator("#legend").isVisible(), true);
  await drillUntil({ x: x - 20, y: y - 10 }, () => / %/.test(document.getElementById("cut").textContent));
  await drillUntil({ x: x - 20, y: y - 10 }, () => Math.max(...hapticut.heat.structures.map(({ now }) => now)) > 39);
  await until(page, () => /peak (39|[4-9]\d|\d{3})/.test(document.getElementById("hottest").textContent));
  const dry = await hottest();
  await set("Irrigation", 10_000);
  await set("Water", 1);
  await until(page, (then) => Math.max(...hapticut.heat.structures.map(({ now }) => now)) < Math.min(then, 38), dry);
  assert.ok(await page.evaluate(() => hapticut.heat.cells.some((byte) => byte > 0 && hapticut.heat.first + 0.5 * byte < 34)));
  const watcher = await openPage(browser, program.url);
  await until(watcher, () => hapticut.heat !== null && /peak/.test(document.getElementById("hottest").textContent));
  assert.deepEqual(watcher.mistakes, []);
  await watcher.close();
  await set("Heat", 0);
  await until(page, () => hapticut.heat === null && document.getElementById("heat").hidden);
});

test("a control that does nothing says why beside it", async () => {
  const beside = () => page.evaluate(() => [...hapticut.panels.controls.values()].map(({ id, label, idle }) =>
    ({ label, idle, text: document.getElementById(`idle-${id}`).textContent })));
  const controls = await beside();
  for (const { label, idle, text } of controls) assert.equal(text, idle, label);
  const friction = controls.find(({ label }) => label.endsWith("static friction"));
  assert.equal(friction.text, "only while the spindle stands");
});

test("every control of every panel of the program changes its value", async () => {
  const controls = await page.evaluate(() => JSON.parse(JSON.stringify([...hapticut.panels.controls.values()])));
  assert.ok(controls.length > 50, `${controls.length} controls`);
  for (const panel of new Set(controls.map((one) => one.panel)))
    await open(panel.charAt(0).toUpperCase() + panel.slice(1));
  for (const { label, control, panel, value, min, max, choices } of controls) {
    if (control === "button" || label === "Record" || label === "Haptics") continue;
    const scope = page.locator(`details[data-panel="${panel}"]`);
    let wanted;
    if (control === "switch") {
      wanted = value === 0 ? 1 : 0;
      await scope.getByRole("checkbox", { name: label, exact: true }).setChecked(wanted === 1);
    } else if (control === "choice") {
      wanted = (value + 1) % choices.length;
      await scope.getByRole("combobox", { name: label, exact: true }).selectOption(String(wanted));
    } else {
      wanted = value * 1.05 > max || value === 0 ? Math.min(max, Math.max(min, (value + min) / 2 || max / 20)) : value * 1.05;
      wanted = Number(wanted.toPrecision(3));
      const field = scope.getByRole("textbox", { name: label });
      await field.first().fill(String(wanted));
      await field.first().press("Enter");
    }
    await until(page, ([name, to]) => Math.abs(hapticut.panels.control(name).value - to) <= 1e-6 * Math.abs(to),
                [label, wanted]).catch((error) => assert.fail(`${label}: ${value}, not ${wanted}: ${error.message}`));
  }
  assert.equal(await page.evaluate(() => document.getElementById("notice").dataset.severity ?? "0"), "0",
               await page.locator("#notice").textContent());
});

test("a value that is out of range is marked and not sent", async () => {
  const field = page.locator('details[data-panel="tool"]').getByRole("textbox", { name: "Diameter" });
  const before = await valueOf("Diameter");
  await field.fill("9000");
  await field.press("Enter");
  assert.equal(await field.getAttribute("aria-invalid"), "true");
  assert.equal(await valueOf("Diameter"), before);
  await field.fill(String(before));
  await field.press("Enter");
});

test("a number of a material tells its range and its source", async () => {
  const known = page.locator('details[data-panel="material"] small.known');
  assert.match(await known.filter({ hasText: "J/mm³" }).first().textContent(), /^typical [\d.]+ J\/mm³, [\d.]+ \.\.\. [\d.]+$/);
  assert.match(await known.first().getAttribute("title"), /^Source: .{10}/);
});

test("the emergency stop removes the force, and a reset restores it", async () => {
  await page.keyboard.press("Escape");
  await until(page, () => hapticut.snapshot.arming === 5);
  await until(page, () => /fault/.test(document.getElementById("guard").textContent)); // seen in the next picture
  assert.match(await page.locator("#cure").textContent(), /reset/);
  await button("Reset").click();
  await until(page, () => hapticut.snapshot.arming === 4);
  await until(page, () => document.getElementById("notice").textContent === ""); // no notice
});

test("another scene loads, the tool changes while it cuts, and the sound has the tone of the spindle", async () => {
  await open("Load");
  await page.getByRole("button", { name: "clay", exact: true }).click();
  await until(page, () => hapticut.panels.control("clay stiffness") !== undefined && hapticut.snapshot?.arming === 4);
  await isReady(page);
  await button("top").click();
  await drawn(page);
  const { x, y } = await middle(page);
  await page.mouse.move(x, y);
  await atRest(page);
  await page.mouse.down();
  await until(page, () => hapticut.snapshot.removed > 1e-10);
  await page.evaluate(() => hapticut.panels.set("Head", 3));
  await until(page, () => hapticut.panels.control("Head").value === 3 && hapticut.snapshot.arming === 4);
  const rpm = 60 * 2000;
  await page.evaluate((speed) => hapticut.panels.set("Speed", speed), rpm);
  await until(page, () => Math.abs(hapticut.snapshot.speed / (2 * Math.PI) - 2000) < 20);
  const heard = await page.evaluate(() => hapticut.speaker.heard);
  await until(page, (then) => hapticut.speaker.heard > then + 24_000, heard); // 0.5 s; the tone follows within 30 ms
  const tone = await page.evaluate(() => {
    const samples = hapticut.speaker.recent.slice(-4800);
    let best = [0, 0];
    for (let f = 1900; f <= 2100; f += 2) {
      let re = 0, im = 0;
      samples.forEach((s, n) => { re += s * Math.cos(2 * Math.PI * f * n / 48000); im += s * Math.sin(2 * Math.PI * f * n / 48000); });
      if (Math.hypot(re, im) > best[1]) best = [f, Math.hypot(re, im)];
    }
    return best[0];
  });
  await page.mouse.up();
  assert.ok(Math.abs(tone - 2000) <= 20, `${tone} Hz`);
});

test("stereo shows two halves or two colours", async () => {
  await open("Stereo");
  const pixels = (mode) => page.evaluate(async (name) => {
    const select = [...document.querySelectorAll('details[data-panel="stereo"] select')][0];
    select.value = name;
    select.dispatchEvent(new Event("change"));
    for (const then = hapticut.frames; hapticut.frames < then + 3;) await new Promise((done) => setTimeout(done, 50));
    const gl = hapticut.picture.renderer.getContext(), w = gl.drawingBufferWidth, h = gl.drawingBufferHeight;
    const data = new Uint8Array(4 * w * h);
    gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, data);
    const ground = data.slice(0, 3);
    let left = 0, right = 0, colored = 0;
    for (let n = 0; n < w * h; ++n) {
      const [r, g, b] = [data[4 * n], data[4 * n + 1], data[4 * n + 2]];
      if (Math.abs(r - ground[0]) + Math.abs(g - ground[1]) + Math.abs(b - ground[2]) < 40) continue;
      if (n % w < w / 2) ++left; else ++right;
      if (r > g + 50 || b > r + 50) ++colored; // dentin has less red
    }
    return { left, right, colored, all: w * h };
  }, mode);
  const flat = await pixels("off");
  const halves = await pixels("side-by-side");
  assert.ok(Math.abs(halves.left - halves.right) < 0.15 * halves.left, JSON.stringify(halves));
  const red = await pixels("anaglyph");
  assert.ok(red.colored > flat.colored + 0.002 * red.all, JSON.stringify([flat, red]));
  await pixels("off");
});

test("the page reports no errors", () => assert.deepEqual(page.mistakes, []));
