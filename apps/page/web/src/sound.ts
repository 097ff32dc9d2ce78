// SPDX-License-Identifier: Apache-2.0
// Plays the samples of the server in an audio worklet.
export class Speaker {
  on = false;
  heard = 0; // number of received samples
  recent = new Float32Array(8192); // newest last, for tests
  private context: AudioContext | null = null;
  private node: AudioWorkletNode | null = null;

  /** Call after a key or a click: browsers allow sound only then. */
  async start() {
    if (!this.context) {
      this.context = new AudioContext({ sampleRate: 48_000, latencyHint: "interactive" });
      await this.context.audioWorklet.addModule("speaker.js");
      this.node = new AudioWorkletNode(this.context, "speaker", { outputChannelCount: [1] });
      this.node.connect(this.context.destination);
    }
    await this.context.resume();
    this.on = true;
  }
  async stop() {
    this.on = false;
    await this.context?.suspend();
  }

  play(samples: Int16Array) {
    const values = Float32Array.from(samples, (sample) => sample / 32768);
    this.heard += values.length;
    const keep = Math.min(values.length, this.recent.length);
    this.recent.copyWithin(0, keep);
    this.recent.set(values.subarray(values.length - keep), this.recent.length - keep);
    if (this.on) this.node?.port.postMessage(values, [values.buffer]);
  }
}
