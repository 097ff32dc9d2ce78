// SPDX-License-Identifier: Apache-2.0
// The mouse removes the same volume as its path does without page, loop and coupling.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { drawn, drill, isReady, middle, openPage, removed, startBrowser, startProgram } from "./viewer.mjs";

// The material yields to almost no force, so the coupling keeps the tool on the path of the hand.
const kScene = `
[workpiece]
source = "block"
size_mm = [20, 20, 20]
voxel_mm = 0.2
material = "clay"

[material.clay]
specific_cutting_energy_J_per_m3 = 1e5
edge_pressure_Pa = 0
viscosity_Pas_per_m = 0

[tool]
head = "sphere"
radius_mm = 2
handle = "ray"
handle_length_mm = 100
spindle_rpm = 1000
`;
const scene = join(mkdtempSync(join(tmpdir(), "hapticut-path-")), "scene.toml");

let program, browser;
before(async () => {
  writeFileSync(scene, kScene);
  program = await startProgram(scene);
  browser = await startBrowser();
});
after(async () => {
  await browser?.close();
  await program?.stop();
});

test("a scripted path of the mouse removes the volume that the simulation removes, within 2 %", async () => {
  const page = await openPage(browser, program.url);
  await isReady(page);
  await page.getByRole("button", { name: "top", exact: true }).click();
  await drawn(page);
  const { x, y } = await middle(page);
  await page.evaluate(() => { hapticut.hand.depth = 1e-3; hapticut.path.length = 0; });
  const way = Array.from({ length: 80 }, (_, n) => ({ x: x - 60 + 1.5 * n, y: y + 25 * Math.sin(n / 12) }));
  await drill(page, way[0], way, 60);
  const by_hand = await removed(page);
  const path = await page.evaluate(() => hapticut.path);
  const begin = path[0].time;
  const rows = path.map(({ time, X_WH: { rotation, translation } }) =>
    [time - begin, ...translation.map((value) => 1e3 * value), ...rotation].join());
  const names = ["t_s", "x_mm", "y_mm", "z_mm", ...[0, 1, 2].flatMap((r) => [0, 1, 2].map((c) => `r${r}${c}`))];
  const file = join(program.folder, "path.csv"), report = join(program.folder, "report.json");
  writeFileSync(file, [names.join(), ...rows].join("\n") + "\n");
  execFileSync(process.env.HAPTICUT_PROGRAM,
               ["drill", "--settings", scene, "--path", "poses", "--poses", file, "--point", "handle", "--json", report]);
  const text = JSON.parse(readFileSync(report, "utf8"));
  const by_path = text.removed_volume_mm3?.total ?? text.results?.removed_volume_mm3?.total;
  assert.ok(by_hand > 5, `${by_hand} mm^3`);
  assert.ok(Math.abs(by_hand - by_path) <= 0.02 * by_path, `${by_hand} mm^3 by hand, ${by_path} mm^3 by the path`);
  console.log(`by hand ${by_hand.toFixed(3)} mm^3, by the path ${by_path.toFixed(3)} mm^3`);
  await page.context().close();
});
