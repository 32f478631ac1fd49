// Plays the game's sounds: samples that Python has rendered, at the gains that Python decides.

/** 16-bit samples from their third differences, whose low bytes come first, then all high bytes; the sign is in the lowest bit. */
export function unpacked(bytes) {
  const count = bytes.length / 2, samples = new Int16Array(count);
  let value = 0, slope = 0, bend = 0;
  for (let k = 0; k < count; k++) {
    const folded = bytes[k] | (bytes[count + k] << 8);
    bend += (folded >> 1) ^ -(folded & 1);
    slope += bend;
    value += slope;
    samples[k] = value;
  }
  return samples;
}

export class Speaker {
  #context = null;
  #buffers = null;
  #loading = null;

  /** A browser lets a page make sounds only after the player has done something: call it then. */
  async wake() {
    if (this.#loading) return this.#context.resume();
    if (typeof AudioContext === "undefined") return undefined;
    this.#context = new AudioContext();
    this.#loading = this.#load();
    return this.#loading;
  }

  async #load() {
    const [index, bytes] = await Promise.all([
      fetch("sounds.json").then((answer) => answer.json()),
      fetch("sounds.packed").then((answer) => new Response(answer.body.pipeThrough(new DecompressionStream("gzip"))).arrayBuffer()),
    ]);
    const samples = unpacked(new Uint8Array(bytes));
    this.#buffers = index.sounds.map(([, , , start, length]) => {
      const buffer = this.#context.createBuffer(1, length, index.rate), channel = buffer.getChannelData(0);
      for (let k = 0; k < length; k++) channel[k] = samples[start + k] / 32767;
      return buffer;
    });
  }

  /** Begin sounds: number, gain of the left ear, gain of the right. */
  play(sounds) {
    if (!this.#buffers || this.#context.state !== "running") return;
    for (const [number, left, right] of sounds) {
      const source = this.#context.createBufferSource(), ears = this.#context.createChannelMerger(2);
      source.buffer = this.#buffers[number];
      [left, right].forEach((gain, ear) => {
        const node = this.#context.createGain();
        node.gain.value = gain;
        source.connect(node).connect(ears, 0, ear);
      });
      ears.connect(this.#context.destination);
      source.start();
    }
  }
}
