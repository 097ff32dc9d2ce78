// SPDX-License-Identifier: Apache-2.0
// Runs in the audio thread: a queue of samples, at most 0.2 s long. An empty queue is silent.
declare class AudioWorkletProcessor { readonly port: MessagePort; }
declare function registerProcessor(name: string, processor: new () => AudioWorkletProcessor): void;

const kMaxQueued = 4800; // samples, 0.1 s at 48 kHz; the queue has room for twice as many

class Speaker extends AudioWorkletProcessor {
  private waiting: Float32Array[] = [];
  private at = 0;
  private level = 0;

  constructor() {
    super();
    this.port.onmessage = (event: MessageEvent<Float32Array>) => {
      this.waiting.push(event.data);
      let total = this.waiting.reduce((sum, part) => sum + part.length, -this.at);
      for (; total > 2 * kMaxQueued && this.waiting.length > 1; this.at = 0) total -= this.waiting.shift()!.length - this.at;
    };
  }

  process(_inputs: Float32Array[][], outputs: Float32Array[][]): boolean {
    const out = outputs[0][0];
    for (let n = 0; n < out.length; ++n) {
      if (this.waiting.length > 0 && this.at >= this.waiting[0].length) {
        this.waiting.shift();
        this.at = 0;
      }
      // Fades out in a gap, because a jump would click.
      this.level = this.waiting.length > 0 ? this.waiting[0][this.at++] : this.level * 0.995;
      out[n] = this.level;
    }
    return true;
  }
}
registerProcessor("speaker", Speaker);
