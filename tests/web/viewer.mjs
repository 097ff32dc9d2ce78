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
const { chromium } = createRequire(join(env("HAPTICUT_WEB"), "package.json"))("playwright-core");

/** Runs the program until it has told its address. */
export async function startProgram(scene, ...more) {
  const folder = mkdtempSync(join(tmpdir(), "hapticut-view-"));
  const child = spawn(env("HAPTICUT_PROGRAM"), ["view", scene, "--no-browser", "--page", env("HAPTICUT_PAGE"), ...more],
                      { cwd: folder });
  let said = "", failed = "";
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
  const ended = new Promise((resolve) => { child.on("exit", (code, signal) => resolve({ code, signal })); });
  return { child, url, folder, ended, async stop(signal = "SIGINT") { child.kill(signal); return ended; } };
}

export const startBrowser = () => chromium.launch({
  executablePath: env("HAPTICUT_CHROMIUM"),
  args: ["--headless=new", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
         "--autoplay-policy=no-user-gesture-required", ...(process.getuid() === 0 ? ["--no-sandbox"] : [])],
});

/** A page that has its scene, and says what goes wrong in it. */
export async function openPage(browser, url, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, colorScheme: "dark", ...options });
  const page = await context.newPage();
  page.mistakes = [];
  page.on("pageerror", (error) => page.mistakes.push(error.message));
  page.on("console", (message) => { if (message.type() === "error") page.mistakes.push(message.text()); });
  await page.goto(url);
  return page;
}

/** Waits until something that the page computes is so. The page's own rules forbid to evaluate texts in it. */
export async function until(page, condition, argument, timeout = 30_000) {
  for (const end = Date.now() + timeout; ;) {
    if (await page.evaluate(condition, argument)) return;
    if (Date.now() > end) {
      const notice = await page.evaluate(() => document.getElementById("notice").textContent);
      throw new Error(`never came about: ${condition}, ${JSON.stringify(argument)}; the page says: ${notice}`);
    }
    await page.waitForTimeout(50);
  }
}

export const isReady = (page) => until(page, () => hapticut.snapshot?.arming === 4 && hapticut.workpiece.triangles > 1000 &&
  hapticut.instruments !== null);

export const removed = (page) => page.evaluate(() => hapticut.snapshot.removed * 1e9); // mm^3

export async function middle(page) {
  const box = await page.getByRole("application", { name: "Workpiece and tool" }).boundingBox();
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** Presses at a place of the page, goes along a way, and lets go. */
export async function drill(page, from, way, pause = 40) {
  await page.mouse.move(from.x, from.y);
  await page.waitForTimeout(500);
  await page.mouse.down();
  await page.waitForTimeout(500);
  for (const { x, y } of way) {
    await page.mouse.move(x, y);
    await page.waitForTimeout(pause);
  }
  await page.waitForTimeout(700);
  await page.mouse.up();
  await page.waitForTimeout(300);
}
