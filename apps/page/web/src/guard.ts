// SPDX-License-Identifier: Apache-2.0
// How the page shows the state of the guard and the sentences of the program.
import type { Hello, Sentence, Snapshot } from "./protocol.ts";

export type Tone = "calm" | "waits" | "works" | "fault";

const kTones: Record<string, Tone> = { on: "calm", ramp: "works", fault: "fault" };
const kUnknown: Sentence = { value: 0, name: "unknown", text: "" };

export interface GuardState {
  name: string;
  tone: Tone;
  text: string;
}

/**
 * The state of the guard in words, with the sentence of the state and the first report of the step. If the force is on
 * and the step has reports, the text is the first two reports.
 */
export function guardState(sentences: Pick<Hello, "arming" | "status">,
                           { arming, status }: Pick<Snapshot, "arming" | "status">): GuardState {
  const state = sentences.arming.find((one) => one.value === arming) ?? kUnknown;
  const tone = kTones[state.name] ?? "waits";
  const reports = sentences.status.filter((one) => (status & one.value) !== 0).map((one) => one.text);
  const texts = tone === "calm" && reports.length > 0 ? reports : [state.text, ...reports];
  return { name: state.name.replaceAll("_", " "), tone, text: texts.slice(0, 2).join(" ") };
}
