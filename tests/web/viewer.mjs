// SPDX-License-Identifier: Apache-2.0
// The program and a browser, for tests of the page. What they need comes by the environment: HAPTICUT_PROGRAM,
// HAPTICUT_WEB (with node_modules), HAPTICUT_PAGE, HAPTICUT_CHROMIUM.
import { spawn } from "node:child_process";
import { mkdtempSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";

const env = (name) => {
  if (!process.env[name]) throw new Error(`${name} is not set; run these tests by ctest.`);
  return process.env[name];
};
const kEnd = Date.now() + 580_000; // a little before ctest ends the script, so that it is said what was waited for
const left = () => Math.max(1, kEnd - Date.now());
let fallen = ""; // of a program that nobody has stopped
const { chromium } = createRequire(join(env("HAPTICUT_WEB"), "package.json"))("playwright-core");

/** Runs the program until it has told its address. */
export async function startProgram(scene, ...more) {
  const folder = mkdtempSync(join(tmpdir(), "hapticut-view-"));
  const child = spawn(env("HAPTICUT_PROGRAM"), ["view", scene, "--no-browser", "--page", env("HAPTICUT_PAGE"), ...more],
                      { cwd: folder });
  let said = "", failed = "", stopped = false;
  child.stderr.on("data", (text) => { failed += text; });
  const url = await new Promise((resolve, reject) => {
    child.stdout.on("data", (text) => {
      said += text;
      const found = said.match(/http:\S+/);
      if (found) resolve(found[0]);
    });
    child.on("exit", (code) => reject(new Error(`the program ended with ${code}: ${failed}`)));
    child.on("error", reject);
  });
  const ended = new Promise((resolve) => {
    child.on("exit", (code, signal) => {
      if (!stopped) fallen = `the program ended with ${code ?? signal}: ${failed}`;
      resolve({ code, signal });
    });
  });
  /** Ends it, which it must do well unless it is killed. */
  const stop = async (signal = "SIGINT") => {
    if (stopped) return ended;
    stopped = true;
    child.kill(signal);
    const how = await ended;
    if (signal !== "SIGKILL" && how.code !== 0) throw new Error(`the program ended with ${how.code ?? how.signal}: ${failed}`);
    return how;
  };
  return { child, url, folder, ended, stop };
}

export const startBrowser = () => chromium.launch({
  executablePath: env("HAPTICUT_CHROMIUM"),
  timeout: left(),
  args: ["--headless=new", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
         "--autoplay-policy=no-user-gesture-required", ...(process.getuid() === 0 ? ["--no-sandbox"] : [])],
});

/** A page that says what goes wrong in it. */
export async function openPage(browser, url, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, colorScheme: "dark", ...options });
  context.setDefaultTimeout(left());
  const page = await context.newPage();
  page.mistakes = [];
  page.on("pageerror", (error) => page.mistakes.push(error.message));
  page.on("console", (message) => { if (message.type() === "error") page.mistakes.push(message.text()); });
  await page.goto(url);
  return page;
}

/**
 * Waits until something that the page computes is so, however slow the machine is: as long as the program runs and the
 * page is connected to it. The page's own rules forbid to evaluate texts in it.
 */
export async function until(page, condition, argument) {
  const texts = () => ["role", "notice"].map((id) => document.getElementById(id).textContent);
  for (;;) {
    const [role, notice] = await page.evaluate(texts);
    if (await page.evaluate(condition, argument)) return;
    const why = fallen || (role === "disconnected" && "the page is alone") || (Date.now() > kEnd && "its time is over");
    if (why) throw new Error(`${why}; never so: ${condition}, ${JSON.stringify(argument)}; the page says: ${notice}`);
    await page.waitForTimeout(50);
  }
}

/** Another snapshot than the one that the page has. The second from now on is of after now. */
export async function nextSnapshot(page) {
  const tick = await page.evaluate(() => hapticut.snapshot.tick);
  await until(page, (then) => hapticut.snapshot !== null && hapticut.snapshot.tick !== then, tick);
}

/** Waits until the surface is whole: each frame of the program sends a part of it, while one is due. */
export async function whole(page) {
  for (let calm = 0, then = -1; calm < 5; ++calm) {
    const bytes = await page.evaluate(() => hapticut.workpiece.uploaded);
    if (bytes !== then) calm = 0;
    then = bytes;
    await nextSnapshot(page);
  }
}

/** Waits until a page leads and has its scene. Where the page before is not yet gone for the program, it comes anew. */
export async function isReady(page) {
  await until(page, () => hapticut.snapshot !== null);
  if (await page.locator("#role").textContent() === "watching") {
    await until(page, () => hapticut.snapshot?.arming === 0);
    await page.reload();
    return isReady(page);
  }
  await until(page, () => hapticut.snapshot?.arming === 4 && hapticut.workpiece.triangles > 1000 &&
    hapticut.instruments !== null);
  await whole(page);
}

/** Waits until the camera is where it was sent. */
export const drawn = (page) => until(page, () => !hapticut.eye.changed);

/** Waits until the loop has the hand where the pointer is, and the tool creeps slower than 0.1 mm/s. */
export async function atRest(page) {
  await until(page, () => {
    const { hand, instruments, moved, pointer } = hapticut, to = hand.X_WT.translation;
    return !pointer.waiting && !moved && Math.hypot(...instruments.X_WG.translation.map((at, n) => at - to[n])) < 1e-6;
  });
  const tool = () => page.evaluate(() => ({ tick: hapticut.snapshot.tick, at: hapticut.snapshot.X_WT.translation }));
  for (let then = await tool(), way = 1; way > 1e-5;) {
    await until(page, (tick) => Math.abs(hapticut.snapshot.tick - tick) >= 100, then.tick);
    const now = await tool();
    way = Math.hypot(...now.at.map((at, n) => at - then.at[n]));
    then = now;
  }
}

export const removed = (page) => page.evaluate(() => hapticut.snapshot.removed * 1e9); // mm^3

export async function middle(page) {
  const box = await page.getByRole("application", { name: "Workpiece and tool" }).boundingBox();
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/**
 * Presses at a place of the page, goes along a way, and lets go.
 * @param pause  ms between places  @param atEnd  what to do before it lets go
 */
export async function drill(page, from, way, pause = 40, atEnd = async () => {}) {
  await drawn(page);
  await page.mouse.move(from.x, from.y);
  await atRest(page);
  await page.mouse.down();
  await atRest(page);
  for (const { x, y } of way) {
    await page.mouse.move(x, y);
    await page.waitForTimeout(pause);
  }
  await atRest(page);
  await atEnd();
  await page.mouse.up();
  await atRest(page);
}
