// SPDX-License-Identifier: Apache-2.0
// Connections: which pages are accepted, and what remains when a page or the program ends without notice.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { readdirSync, statSync } from "node:fs";
import http from "node:http";
import { join } from "node:path";
import { after, afterEach, before, test } from "node:test";
import { drill, isReady, middle, nextSnapshot, openPage, startBrowser, startProgram, until } from "./viewer.mjs";

let program, browser;
// The pages are small, because two of them draw at once without a GPU.
const open = (url) => openPage(browser, url, { viewport: { width: 800, height: 450 } });
before(async () => {
  program = await startProgram("clay");
  browser = await startBrowser();
});
afterEach(async () => { for (const context of browser.contexts()) await context.close(); });
after(async () => {
  await browser?.close();
  await program?.stop();
});

test("the second page watches, and takes control after the first has closed", async () => {
  const first = await open(program.url);
  await isReady(first);
  const second = await open(program.url);
  await until(second, () => document.getElementById("role").textContent === "watching");
  await until(second, () => hapticut.workpiece.triangles > 1000);
  await until(second, () => document.querySelector('details[data-panel="tool"] fieldset')?.disabled === true);
  await second.keyboard.press("Escape"); // a watching page does not send it: the server would disconnect the page
  await first.evaluate(() => hapticut.panels.set("Volume", 0.25));
  await until(second, () => hapticut.panels.control("Volume").value === 0.25);
  assert.equal(await second.locator("#role").textContent(), "watching");
  await first.context().close();
  await until(second, () => hapticut.snapshot.arming === 0); // off: no page has control
  assert.deepEqual(await second.evaluate(() => hapticut.snapshot.force), [0, 0, 0]);
  await until(second, () => /reload this page if it only watches/.test(document.getElementById("cure").textContent));
  await second.reload();
  await isReady(second);
  assert.equal(await second.locator("#role").textContent(), "in control");
});

test("a page with a wrong token shows this in a sentence", async () => {
  const page = await open(program.url.replace(/token=.*/, "token=" + "0".repeat(32)));
  await until(page, () => /token/.test(document.getElementById("notice").textContent));
});

test("a page of another origin is refused", async () => {
  const { port, search } = new URL(program.url);
  const status = await new Promise((resolve) => {
    const request = http.request({ port, host: "127.0.0.1", path: "/socket" + search, headers: {
      Connection: "Upgrade", Upgrade: "websocket", "Sec-WebSocket-Version": "13",
      "Sec-WebSocket-Key": "AAAAAAAAAAAAAAAAAAAAAA==", Origin: "http://example.org" } }, (r) => resolve(r.statusCode));
    request.on("upgrade", () => resolve(101));
    request.end();
  });
  assert.equal(status, 403);
});

test("an unknown scene and a port in use each give one sentence", async () => {
  const page = await open(program.url);
  await isReady(page);
  await page.evaluate(() => hapticut.load("no_such_thing.vdb"));
  await until(page, () => /no scene 'no_such_thing.vdb'/.test(document.getElementById("notice").textContent));
  await isReady(page);
  await page.context().close();
  const other = spawnSync(process.env.HAPTICUT_PROGRAM, ["view", "clay", "--no-browser", "--page", process.env.HAPTICUT_PAGE,
                          "--port", new URL(program.url).port], { encoding: "utf8" });
  assert.equal(other.status, 1);
  assert.match(other.stderr, /port .* Choose another port/);
});

test("the program ends without an error after its page has closed, after a load as the first command, and while it loads", async () => {
  const own = await startProgram("clay");
  try {
    const first = await open(own.url);
    await isReady(first);
    await first.context().close();
    const second = await open(own.url);
    await isReady(second);
    await second.evaluate(() => hapticut.load("clay"));
    await until(second, () => /clay is ready/.test(document.getElementById("notice").textContent));
    await second.evaluate(() => hapticut.load("molar"));
    await until(second, () => /Loading molar/.test(document.getElementById("notice").textContent));
  } finally {
    await own.stop();
  }
});

test("a killed program leaves a recording that opens, and its page reports the end", async () => {
  const page = await open(program.url);
  await isReady(page);
  await page.getByRole("button", { name: "Record" }).click();
  await until(page, () => document.getElementById("record").getAttribute("aria-pressed") === "true");
  for (let n = 0; n < 2; ++n) await nextSnapshot(page); // snapshots of the recorded run
  await until(page, () => hapticut.snapshot.arming === 4);
  const { x, y } = await middle(page);
  await drill(page, { x, y }, [{ x: x + 10, y }]);
  const recording = () => readdirSync(program.folder).find((name) => name.endsWith(".h5"));
  const size = () => statSync(join(program.folder, recording())).size;
  for (const then = size(); size() === then;) await nextSnapshot(page); // until the drilled steps are written
  await program.stop("SIGKILL");
  await until(page, () => /program has ended/.test(document.getElementById("notice").textContent));
  assert.equal(await page.locator("#cure").textContent(), "", "no cure of the last state stays visible");
  assert.ok(!await page.getByRole("button", { name: "Emergency stop" }).isVisible());
  const file = recording();
  assert.ok(file, "there is no recording");
  execFileSync(process.env.HAPTICUT_PROGRAM, ["export", join(program.folder, file), join(program.folder, "steps.csv")]);
});
