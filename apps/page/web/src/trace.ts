// SPDX-License-Identifier: Apache-2.0
// The last ten seconds at 1000 samples/s, drawn as minimum and maximum of each column.
export const kSamples = 10_000;
export const kChannels = 6;

export class TraceRing {
  private values = new Float32Array(kSamples * kChannels);
  private next = -1; // tick after the last sample
  private filled = 0;

  /** @param first  tick of the first sample; samples that are already there are skipped, gaps are 0 */
  add(first: number, samples: Float32Array) {
    const count = samples.length / kChannels;
    if (first < this.next - kSamples || this.next < 0) this.clear(first);
    if (first - this.next > kSamples) this.clear(first);
    for (; this.next < first; ++this.next) this.put(this.next, null, 0);
    for (let n = Math.max(0, this.next - first); n < count; ++n) {
      this.put(first + n, samples, n * kChannels);
      this.next = first + n + 1;
    }
  }
  clear(next = -1) {
    this.next = next;
    this.filled = 0;
  }
  get last() { return this.next; }
  get size() { return this.filled; }

  /** A channel of the newest sample. */
  newest(channel: number): number {
    return this.filled > 0 ? this.values[((this.next - 1) % kSamples) * kChannels + channel] : 0;
  }

  /** The newest `ticks` of a channel in `columns` pairs of minimum and maximum. */
  decimate(channel: number, columns: number, ticks = kSamples) {
    const low = new Float64Array(columns).fill(NaN), high = new Float64Array(columns).fill(NaN);
    const begin = this.next - ticks;
    const from = Math.max(begin, this.next - this.filled);
    for (let tick = from; tick < this.next; ++tick) {
      const column = Math.min(columns - 1, Math.floor(((tick - begin) * columns) / ticks));
      const value = this.values[(((tick % kSamples) + kSamples) % kSamples) * kChannels + channel];
      if (!(low[column] <= value)) low[column] = value;
      if (!(high[column] >= value)) high[column] = value;
    }
    return { low, high };
  }

  private put(tick: number, samples: Float32Array | null, at: number) {
    const place = (((tick % kSamples) + kSamples) % kSamples) * kChannels;
    for (let c = 0; c < kChannels; ++c) this.values[place + c] = samples ? samples[at + c] : 0;
    this.filled = Math.min(kSamples, this.filled + 1);
  }
}
