// SPDX-License-Identifier: Apache-2.0
// What the guard of the hand does, and what to do about it, in words.
export interface GuardState {
  name: string;
  tone: "calm" | "waits" | "works" | "fault";
  text: string;
}

const kStates: GuardState[] = [
  { name: "off", tone: "waits", text: "Nobody leads: the loop stands. Move the tool to go on." },
  { name: "armed", tone: "waits", text: "Waiting for the first readings of the hand." },
  { name: "waiting", tone: "waits", text: "No force until the tool touches nothing: lift it off the workpiece." },
  { name: "fading in", tone: "works", text: "The force is being faded in." },
  { name: "on", tone: "calm", text: "The force is on." },
  { name: "fault", tone: "fault", text: "Stopped without force: press \"Reset\" when the hand is ready." },
];

const kStatus: Record<number, string> = {
  0: "The pose was refused: it is no rotation.",
  3: "The hand jumped: bring it back smoothly.",
  5: "The memory for cut blocks is full: restart, or cut less.",
  8: "The spindle is at its limit: press less.",
  9: "The feed is too fast for the stiffness: feed slower.",
  10: "The vibration is too fast for the loop: lower its frequency.",
  13: "The spindle is stalled: press less.",
  15: "The tool waits for the hand: bring it out of the material, or back to the tool.",
};

export const guardState = (arming: number): GuardState =>
  kStates[arming] ?? { name: "unknown", tone: "fault", text: "The program is of another version." };

export const statusTexts = (status: number): string[] =>
  Object.entries(kStatus).filter(([bit]) => (status & (1 << Number(bit))) !== 0).map(([, text]) => text);
