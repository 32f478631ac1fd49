// Plays the game's sounds: samples that Python has rendered, at the gains that Python decides.

import { Music } from "./music.js";
import { undifferenced, unzipped } from "./archives.js";

export class Speaker {
  #buffers = null;
  #loading = null;
  #music = null;
  #gains = null;
  context = null;
  output = null; // what everything goes through

  /** A browser lets a page make sounds only after the player has done something: call it then. */
  async wake() {
    if (this.#loading) return this.context.resume();
    if (typeof AudioContext === "undefined") return undefined;
    this.context = new AudioContext();
    this.output = this.context.createGain();
    this.output.connect(this.context.destination);
    document.addEventListener("visibilitychange", () => (document.hidden ? this.context.suspend() : this.context.resume()));
    this.#loading = this.#load();
    if (this.#gains) this.follow(this.#gains);
    return this.#loading;
  }

  async #load() {
    const [index, bytes] = await Promise.all([
      fetch("sounds.json").then((answer) => answer.json()),
      unzipped("sounds.packed"),
    ]);
    const samples = undifferenced(bytes);
    this.#buffers = index.sounds.map(([, , , start, length]) => {
      const buffer = this.context.createBuffer(1, length, index.rate), channel = buffer.getChannelData(0);
      for (let k = 0; k < length; k++) channel[k] = samples[start + k] / 32767;
      return buffer;
    });
  }

  /** Begin sounds: number, gain of the left ear, gain of the right. */
  play(sounds) {
    if (!this.#buffers || this.context.state !== "running") return;
    for (const [number, left, right] of sounds) {
      const source = this.context.createBufferSource(), ears = this.context.createChannelMerger(2);
      source.buffer = this.#buffers[number];
      [left, right].forEach((gain, ear) => {
        const node = this.context.createGain();
        node.gain.value = gain;
        source.connect(node).connect(ears, 0, ear);
      });
      ears.connect(this.output);
      source.start();
    }
  }

  /** Bring the layers of the music to these gains. It is loaded when it is first to be heard. */
  follow(gains) {
    this.#gains = gains;
    if (!this.context || (!this.#music && !gains.some((gain) => gain > 0))) return;
    this.#music ??= new Music(this.context, this.output);
    this.#music.follow(gains);
  }
}
