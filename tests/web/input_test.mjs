// SPDX-License-Identifier: Apache-2.0
// Mouse, keys, fingers and gamepads together: on a page in control, on a watching page and on a replay.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readdirSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { atRest, drawn, drill, isReady, middle, openPage, startBrowser, startProgram, until } from "./viewer.mjs";

const kSize = { viewport: { width: 901, height: 500 } };
let program, browser, page;
before(async () => {
  program = await startProgram("molar");
  browser = await startBrowser();
  page = await openPage(browser, program.url, { ...kSize, hasTouch: true });
  await isReady(page);
  await page.evaluate(() => {
    const button = () => ({ value: 0, pressed: false });
    window.pads = [0, 1].map((index) => ({ index, connected: true, axes: [0, 0, 0, 0], buttons: Array.from({ length: 17 }, button) }));
    navigator.getGamepads = () => window.pads;
  });
});
after(async () => {
  await browser?.close();
  await program?.stop();
});

const pictures = async (on = page, count = 2) => {
  const then = await on.evaluate(() => hapticut.frames);
  await until(on, ([from, more]) => hapticut.frames >= from + more, [then, count]);
};
const pressed = async () => {
  await pictures(); // each picture reads the gamepads
  return page.evaluate(() => hapticut.hand.pressed);
};
const pull = (pad, value) => page.evaluate(([n, to]) => { window.pads[n].buttons[7].value = to; }, [pad, value]);
const direction = (on) => on.evaluate(() => hapticut.eye.back.toArray());
const turned = async (on, from) => {
  const to = await direction(on);
  return Math.hypot(...to.map((at, n) => at - from[n]));
};
const drag = async (on, button = "left") => {
  const { x, y } = await middle(on);
  await on.mouse.move(x, y);
  await on.mouse.down({ button });
  await on.mouse.move(x + 60, y + 20, { steps: 3 });
  await on.mouse.up({ button });
};

test("a press lasts until the last input is released, and idle gamepads neither hold nor release it", async () => {
  const { x, y } = await middle(page);
  await page.mouse.move(x, y - 40);
  await page.mouse.down();
  assert.ok(await pressed(), "the mouse, with two idle gamepads");
  await page.keyboard.down(" ");
  await page.mouse.up();
  assert.ok(await pressed(), "Space");
  await pull(1, 1);
  await page.keyboard.up(" ");
  assert.ok(await pressed(), "the second gamepad");
  await pull(1, 0);
  assert.ok(!await pressed(), "no input");
  await pull(1, 1);
  assert.ok(await pressed(), "the second gamepad again");
  await page.evaluate(() => { window.kept = window.pads; window.pads = [null, null]; });
  await until(page, () => !hapticut.hand.pressed); // the gamepads are disconnected
  await page.evaluate(() => { window.pads = window.kept; });
  await pull(1, 0);
  await page.mouse.down();
  await page.mouse.down({ button: "right" });
  await page.mouse.up();
  assert.ok(!await pressed(), "only the right button is still pressed");
  await page.mouse.up({ button: "right" });
  await page.keyboard.down(" ");
  assert.ok(await pressed(), "Space again");
  await page.evaluate(() => dispatchEvent(new Event("blur")));
  assert.ok(!await pressed(), "the window lost the focus with a key down");
  await page.keyboard.up(" ");
  await page.mouse.down();
  assert.ok(await pressed());
  const told = await page.evaluate(() => { // without another picture
    Object.defineProperty(document, "hidden", { value: true, configurable: true });
    document.dispatchEvent(new Event("visibilitychange"));
    delete document.hidden;
    return hapticut.path.at(-1).pressed;
  });
  assert.ok(!told, "the page is hidden, and releases the press at once");
  await page.mouse.up();
});

test("keys move the tool with any focus, except in controls that use keys", async () => {
  const tip = () => page.evaluate(() => hapticut.hand.place.join());
  for (const [place, leads] of [["#views button", true], ["#record", true], ["aside input[type=text]", false], ["aside select", false]]) {
    await page.locator(place).first().evaluate((one) => one.focus());
    const before = await tip();
    await page.keyboard.press("ArrowLeft");
    assert.equal(await tip() !== before, leads, place);
  }
  await page.evaluate(() => document.activeElement.blur());
  const before = await tip();
  await page.keyboard.press("PageDown");
  assert.notEqual(await tip(), before, "without any focus");
});

test("Space and a trigger press on the surface under the tip, wherever keys have moved it", async () => {
  const { x, y } = await middle(page);
  for (const source of ["Space", "trigger"]) {
    await page.mouse.move(x, y - 20);
    await atRest(page);
    for (let n = 0; n < 3; ++n) await page.keyboard.press("Shift+ArrowLeft");
    const before = await page.evaluate(() => ({ tip: hapticut.hand.place, axis: hapticut.hand.axis }));
    await (source === "Space" ? page.keyboard.down(" ") : pull(0, 1));
    assert.ok(await pressed());
    const after = await page.evaluate(() => {
      const { hand } = hapticut;
      return { tip: hand.place, depth: hand.depth };
    });
    const way = after.tip.map((at, n) => at - before.tip[n]);
    const along = way.reduce((sum, by, n) => sum + by * before.axis[n], 0);
    const aside = Math.hypot(...way.map((by, n) => by - along * before.axis[n]));
    assert.ok(aside < 1e-3, `${source}: ${1e3 * aside} mm beside the place that the keys have set`);
    assert.ok(along < -after.depth, `${source}: ${1e3 * along} mm along the tool`);
    await (source === "Space" ? page.keyboard.up(" ") : pull(0, 0));
    assert.ok(!await pressed());
  }
});

/** The middle in whole pixels, as a mouse reports it. Zoom would enlarge a fraction of a pixel. */
const pixel = async () => {
  const { x, y } = await middle(page);
  return { x: Math.floor(x), y: Math.floor(y) };
};
const aim = (at) => page.evaluate(({ x, y }) => {
  const box = document.getElementById("scene").getBoundingClientRect();
  const { point } = hapticut.workpiece.hit(hapticut.eye.ray((2 * (x - box.left)) / box.width - 1, 1 - (2 * (y - box.top)) / box.height));
  return point;
}, at);
const isThere = async (point, at, pixels) => {
  const { x, y, clearance, near, inside } = await page.evaluate((p) => {
    const { eye, workpiece } = hapticut, box = document.getElementById("scene").getBoundingClientRect();
    eye.update(box.width / box.height);
    const seen = eye.back.fromArray(p).multiplyScalar(1e3).project(eye.camera), place = eye.camera.position;
    return { x: box.left + (box.width * (seen.x + 1)) / 2, y: box.top + (box.height * (1 - seen.y)) / 2,
             clearance: workpiece.clearance(place), near: eye.camera.near, inside: workpiece.isInside(place, eye.back) };
  }, point);
  assert.ok(Math.hypot(x - at.x, y - at.y) < pixels, `${x}, ${y} is not ${at.x}, ${at.y}`);
  assert.ok(clearance >= near && !inside, `${clearance} mm from the surface, ${near} mm to the near plane, inside: ${inside}`);
};

test("thirty notches of the wheel zoom to the surface under the pointer, and end in front of it", async () => {
  const { x, y } = await pixel();
  for (const at of [{ x: x + 25, y: y - 30 }, { x: x - 30, y: y + 10 }]) {
    await page.keyboard.press("0");
    await drawn(page);
    await page.mouse.move(at.x, at.y);
    const point = await aim(at), distance = await page.evaluate(() => hapticut.eye.distance);
    await page.keyboard.down("Shift");
    for (let n = 0; n < 30; ++n) await page.mouse.wheel(0, -100);
    await page.keyboard.up("Shift");
    await until(page, (from) => hapticut.eye.distance < from / 4, distance);
    await drawn(page);
    await isThere(point, at, 3);
    await drag(page, "right"); // the view can turn so close to the surface
    await isThere(point, at, Infinity);
  }
});

test("spreading two fingers zooms to the surface between them", async () => {
  await page.keyboard.press("0");
  await drawn(page);
  const { x, y } = await pixel(), at = { x: x + 20, y: y - 20 }, point = await aim(at);
  const distance = await page.evaluate(() => hapticut.eye.distance);
  const hands = await page.context().newCDPSession(page);
  const touch = (type, apart) => hands.send("Input.dispatchTouchEvent", { type, touchPoints:
    apart === null ? [] : [{ x: at.x - apart, y: at.y, id: 1 }, { x: at.x + apart, y: at.y, id: 2 }] });
  await touch("touchStart", 20);
  for (let apart = 22; apart <= 80; apart += 2) await touch("touchMove", apart);
  await touch("touchEnd", null);
  assert.ok(!await pressed(), "two fingers do not drill");
  assert.ok(await page.evaluate(() => hapticut.eye.distance) < distance / 2.5);
  await isThere(point, at, 6);
  await page.keyboard.press("0");
});

test("side by side, the pointer uses the eye of the half that it is in", async () => {
  const choose = (name) => page.evaluate((to) => {
    const select = document.querySelector('details[data-panel="stereo"] select');
    select.value = to;
    select.dispatchEvent(new Event("change"));
  }, name);
  await choose("side-by-side");
  await pictures();
  await page.keyboard.press("0");
  await drawn(page);
  const { x, y } = await pixel(), box = await page.locator("#scene").boundingBox();
  for (const side of [-1, 1]) {
    const at = { x: Math.floor(x + (side * box.width) / 4 + 5), y: y - 10 };
    await page.mouse.move(at.x, at.y);
    await until(page, () => !hapticut.pointer.waiting);
    const seen = await page.evaluate((eye) => { // the tip hovers a little above the surface, along its normal
      const { hand, workpiece, picture, eye: middle } = hapticut;
      const three = middle.back.constructor, camera = picture.eyeOf(middle.camera, eye), at = new three().setFromMatrixPosition(camera.matrixWorld);
      const tip = new three(...hand.place).multiplyScalar(1e3);
      const { x, y } = tip.clone().project(camera);
      return { x, y, away: workpiece.clearance(tip), far: at.distanceTo(tip) };
    }, side);
    const pixels = { x: box.x + (box.width / 4) * (seen.x + (side < 0 ? 1 : 3)), y: box.y + (box.height * (1 - seen.y)) / 2 };
    assert.ok(seen.away < 1.2, "the tip hovers over the surface");
    const hover = (box.height / (2 * Math.tan((16 * Math.PI) / 180))) / seen.far; // pixels per millimetre
    assert.ok(Math.hypot(pixels.x - at.x, pixels.y - at.y) < hover + 1, JSON.stringify([side, pixels, at, hover]));
  }
  await choose("off");
  await pictures();
});

test("the panel shows the depth that the wheel set", async () => {
  await page.mouse.wheel(0, -200);
  await pictures();
  assert.match(await page.locator('details[data-panel="pointer"] label', { hasText: "Depth" }).textContent(), /0\.7 mm/);
  await page.mouse.wheel(0, 200);
});

test("every text is readable in the dark and in the light theme", async () => {
  for (const theme of ["dark", "light"]) {
    await page.evaluate((name) => { hapticut.setTheme(name); }, theme);
    await page.evaluate(() => { for (const panel of document.querySelectorAll("details")) panel.open = true; });
    const faint = await page.evaluate(() => {
      const numbers = (color) => color.match(/[\d.]+/g).map(Number);
      const light = ([r, g, b]) => [r, g, b].map((c) => (c / 255 <= 0.03928 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4))
        .reduce((sum, c, n) => sum + c * [0.2126, 0.7152, 0.0722][n], 0);
      const ground = (one) => {
        for (; one; one = one.parentElement) {
          const color = numbers(getComputedStyle(one).backgroundColor);
          if ((color[3] ?? 1) === 1) return color;
        }
        return [255, 255, 255];
      };
      const found = [];
      for (const one of document.querySelectorAll("header *, aside *")) {
        const has = [...one.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.textContent.trim() !== "");
        if (!has || one.closest(":disabled, .uplot") || !one.checkVisibility()) continue;
        const [a, b] = [light(numbers(getComputedStyle(one).color)), light(ground(one))].sort((p, q) => q - p);
        if ((a + 0.05) / (b + 0.05) < 4.5) found.push(`${one.textContent}: ${((a + 0.05) / (b + 0.05)).toFixed(1)}`);
      }
      return found;
    });
    assert.deepEqual(faint, [], theme);
  }
});

test("buttons, notices and units are inside the page, also on a phone", async () => {
  const text = "A sentence of a hundred and twenty letters, as long as those of the guard with their cure, is read to its very end: yes.";
  for (const viewport of [{ width: 390, height: 844 }, { width: 1280, height: 720 }]) {
    await page.setViewportSize(viewport);
    await page.evaluate((words) => { hapticut.indicators.notice(words, 1); }, text);
    await pictures(); // the curves then have the new width
    const outside = await page.evaluate(() => [...document.querySelectorAll("header *, aside *")].filter((one) => {
      const { left, right } = one.getBoundingClientRect();
      return one.checkVisibility() && (left < 0 || right > innerWidth + 1 || (one.id === "notice" && one.scrollWidth > one.clientWidth));
    }).map((one) => one.id || one.outerHTML.slice(0, 80)));
    assert.deepEqual(outside, [], JSON.stringify(viewport));
    const { height } = await page.locator("header").boundingBox();
    assert.ok(height < (viewport.width < 900 ? 200 : 60), `${height}`);
  }
  await page.setViewportSize(kSize.viewport);
});

test("a drag turns the view of a watching page, which has no controls of the page in control", async () => {
  const second = await openPage(browser, program.url, kSize);
  await until(second, () => document.getElementById("role").textContent === "watching" && hapticut.workpiece.triangles > 1000);
  const from = await direction(second);
  await drag(second);
  assert.ok(await turned(second, from) > 0.1);
  for (const name of ["Undo", "Record", "Emergency stop"])
    assert.ok(!await second.getByRole("button", { name, exact: true }).isVisible(), name);
  assert.match(await second.locator("#keys").innerText(), /^Drag: turn the view/);
  await second.context().close();
});

test("an exported page plays, turns, zooms and lists its keys, and has no controls without effect", async () => {
  await page.getByRole("button", { name: "Record" }).click();
  await until(page, () => document.getElementById("record").getAttribute("aria-pressed") === "true" && hapticut.snapshot.arming === 4);
  const { x, y } = await middle(page);
  await drill(page, { x, y }, [{ x: x + 10, y }]);
  // Moves the tool out of the tooth. It is outside at the start of a run, too.
  for (let n = 0; n < 4; ++n) await page.keyboard.press("Shift+PageDown");
  await atRest(page);
  await page.getByRole("button", { name: "Record" }).click();
  await until(page, () => /is complete/.test(document.getElementById("notice").textContent));
  await until(page, () => hapticut.snapshot.arming === 4);
  await pictures();
  assert.match(await page.locator("#notice").textContent(), /is complete/, "the badge, not the notice, shows that the force is on");
  const recording = join(program.folder, readdirSync(program.folder).find((name) => name.endsWith(".h5")));
  const file = join(program.folder, "page.html");
  execFileSync(process.env.HAPTICUT_PROGRAM, ["export", recording, file, "--page", process.env.HAPTICUT_PAGE]);
  const replay = await openPage(browser, `file://${file}`, kSize);
  await until(replay, () => hapticut.snapshot !== null && hapticut.workpiece.triangles > 1000);
  for (const button of await replay.getByRole("button").all())
    if (await button.isVisible()) assert.doesNotMatch(await button.innerText(), /Sound|Undo|Redo|Record|stop|Open/);
  assert.deepEqual(await replay.locator("aside#panels summary:visible").allInnerTexts(), ["View", "Stereo"]);
  assert.match(await replay.locator("#keys").innerText(), /Drag: turn the view · wheel: zoom .* Space: play/);
  const from = await direction(replay), distance = await replay.evaluate(() => hapticut.eye.distance);
  await drag(replay);
  assert.ok(await turned(replay, from) > 0.1, "a drag turns the view");
  await replay.mouse.wheel(0, -300);
  await until(replay, (then) => hapticut.eye.distance < 0.9 * then, distance);
  await replay.keyboard.press(" ");
  await until(replay, () => player.time > 0.05);
  assert.deepEqual(replay.mistakes, []);
});

test("the page reports no errors", () => assert.deepEqual(page.mistakes, []));
