// SPDX-License-Identifier: Apache-2.0
// Runs in the thread of the sound: a queue of samples, a tenth of a second at most, silence when it is empty.
declare class AudioWorkletProcessor { readonly port: MessagePort; }
declare function registerProcessor(name: string, processor: new () => AudioWorkletProcessor): void;

const kMost = 4800;

class Speaker extends AudioWorkletProcessor {
  private waiting: Float32Array[] = [];
  private at = 0;
  private level = 0;

  constructor() {
    super();
    this.port.onmessage = (event: MessageEvent<Float32Array>) => {
      this.waiting.push(event.data);
      let total = this.waiting.reduce((sum, part) => sum + part.length, -this.at);
      for (; total > 2 * kMost && this.waiting.length > 1; this.at = 0) total -= this.waiting.shift()!.length - this.at;
    };
  }

  process(_inputs: Float32Array[][], outputs: Float32Array[][]): boolean {
    const out = outputs[0][0];
    for (let n = 0; n < out.length; ++n) {
      if (this.waiting.length > 0 && this.at >= this.waiting[0].length) {
        this.waiting.shift();
        this.at = 0;
      }
      // A gap fades, so that it does not click.
      this.level = this.waiting.length > 0 ? this.waiting[0][this.at++] : this.level * 0.995;
      out[n] = this.level;
    }
    return true;
  }
}
registerProcessor("speaker", Speaker);
