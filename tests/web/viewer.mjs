// SPDX-License-Identifier: Apache-2.0
// The program and a browser, for tests of the page. They use these environment variables: HAPTICUT_PROGRAM,
// HAPTICUT_WEB (with node_modules), HAPTICUT_PAGE, HAPTICUT_CHROMIUM.
import { spawn } from "node:child_process";
import { mkdtempSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";

const env = (name) => {
  if (!process.env[name]) throw new Error(`${name} is not set; run these tests with ctest.`);
  return process.env[name];
};
// Shortly before ctest ends the script, to report the condition that did not become true.
const kEnd = Date.now() + 580_000;
const left = () => Math.max(1, kEnd - Date.now());
let unexpectedEnd = ""; // how a program ended that no test has stopped
const { chromium } = createRequire(join(env("HAPTICUT_WEB"), "package.json"))("playwright-core");

/** Starts the program, and waits until it has printed its address. */
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
      if (!stopped) unexpectedEnd = `the program ended with ${code ?? signal}: ${failed}`;
      resolve({ code, signal });
    });
  });
  /** Ends the program. Throws if its exit code is not 0, unless it is killed. */
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

/** Opens a page that collects its errors in `mistakes`. */
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
 * Waits until a condition in the page is true. A slow machine may take long, so the wait fails only when the program
 * ends, the page loses its connection, or ctest would end the script. The condition is a function, because the content
 * policy of the page forbids evaluating strings.
 */
export async function until(page, condition, argument) {
  const texts = () => ["role", "notice"].map((id) => document.getElementById(id).textContent);
  for (;;) {
    const [role, notice] = await page.evaluate(texts);
    if (await page.evaluate(condition, argument)) return;
    const why = unexpectedEnd || (role === "disconnected" && "the page is disconnected") || (Date.now() > kEnd && "timeout");
    if (why) throw new Error(`${why}; never true: ${condition}, ${JSON.stringify(argument)}; the page says: ${notice}`);
    await page.waitForTimeout(50);
  }
}

/** Waits for the next snapshot. It may be older than the call; the snapshot after it is not. */
export async function nextSnapshot(page) {
  const tick = await page.evaluate(() => hapticut.snapshot.tick);
  await until(page, (then) => hapticut.snapshot !== null && hapticut.snapshot.tick !== then, tick);
}

/** Waits until the surface is complete. Each frame of the program sends only a part of the changes. */
export async function whole(page) {
  for (let calm = 0, then = -1; calm < 5; ++calm) {
    const bytes = await page.evaluate(() => hapticut.workpiece.uploaded);
    if (bytes !== then) calm = 0;
    then = bytes;
    await nextSnapshot(page);
  }
}

/** Waits until a page has control and its scene. Reloads the page if an earlier page still has control. */
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

/** Waits until the camera has reached its target. */
export const drawn = (page) => until(page, () => !hapticut.eye.changed);

/** Waits until the loop has received the position of the pointer and the tool moves slower than 0.1 mm/s. */
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
 * Presses the mouse at a point of the page, moves it along a path, and releases it.
 * @param pause  ms between the points of the path  @param atEnd  called before the release
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
