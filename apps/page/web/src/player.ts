// SPDX-License-Identifier: Apache-2.0
// A page that replays a recording. The recording is in the page or in a separate file.
import { isForTheScene } from "./pointer.ts";
import type { Message } from "./protocol.ts";
import { fromBase64, Player, readRecording, unpack } from "./replay.ts";

type ById = <T extends HTMLElement>(id: string) => T;
interface PageParts {
  handle(message: Message): void;
  curves: { ring: { clear(): void } };
  indicators: { role(text: string): void; notice(text: string, severity: number): void };
}

/** @returns whether this page has a recording */
export function showPlayer(page: PageParts, byId: ById): boolean {
  const inside = document.getElementById("recording");
  if (!inside) return false;
  document.body.classList.add("replay", "looks");
  page.indicators.role("replay");
  const source = inside.dataset.from ?? null;
  const packed = source === null ? Promise.resolve(fromBase64(inside.textContent ?? ""))
    : fetch(source + location.search).then(async (answer) => new Uint8Array(await answer.arrayBuffer()));
  packed.then(unpack)
    .then((all) => {
      const show = (message: Message) => page.handle(message), rewind = () => page.curves.ring.clear();
      play(new Player(readRecording(all), show, rewind), byId);
    })
    .catch((error: Error) => page.indicators.notice(error.message, 2));
  return true;
}

function play(player: Player, byId: ById) {
  (window as unknown as { player: Player }).player = player;
  const time = byId<HTMLInputElement>("time"), clock = byId("clock"), button = byId("play");
  byId("player").hidden = false;
  time.max = String(player.duration);
  const show = () => {
    time.value = String(player.time);
    clock.textContent = `${player.time.toFixed(2)} / ${player.duration.toFixed(1)} s`;
    button.textContent = player.playing ? "Pause" : "Play";
  };
  const seek = (change: () => void) => {
    change();
    show();
  };
  button.onclick = () => {
    player.playing = !player.playing;
    if (player.playing && player.time >= player.duration) seek(() => player.seek(0));
    show();
  };
  time.oninput = () => seek(() => player.seek(Number(time.value)));
  byId("back").onclick = () => seek(() => player.step(-1));
  byId("forward").onclick = () => seek(() => player.step(1));
  addEventListener("keydown", (event) => {
    const name = ({ " ": "play", ArrowLeft: "back", ArrowRight: "forward" } as Record<string, string>)[event.key];
    if (name && isForTheScene(event)) byId(name).click();
  });
  const speed = byId<HTMLSelectElement>("speed");
  speed.onchange = () => { player.speed = Number(speed.value); };
  let last = performance.now();
  const tick = (now: number) => {
    if (player.playing) {
      player.advance((now - last) / 1e3);
      show();
    }
    last = now;
    requestAnimationFrame(tick);
  };
  player.seek(0);
  show();
  requestAnimationFrame(tick);
}
