// The music: every layer is mixed once, of notes that Python has rendered; then all play together at the gains that Python decides.

import { archived, undifferenced, unzipped } from "./archives.js";

const SOON = 0.1; // seconds from the order to play until it begins
const SMOOTH = 0.03; // seconds in which a gain comes to a new value

/** A layer as a loop. What rings on beyond its end begins it. */
export async function mixed(layer, samples) {
  const offline = new OfflineAudioContext(2, layer.length, layer.rate);
  const output = new GainNode(offline, { gain: layer.gain });
  output.connect(offline.destination);
  const buffers = layer.waves.map(([start, length, scale]) => {
    const buffer = offline.createBuffer(1, length, layer.rate), channel = buffer.getChannelData(0);
    for (let k = 0; k < length; k++) channel[k] = samples[start + k] * scale;
    return buffer;
  });
  for (const [number, start, ...ears] of layer.notes) {
    const buffer = buffers[number], begins = start % layer.length, merger = offline.createChannelMerger(2);
    merger.connect(output);
    const gains = ears.map((gain, ear) => {
      const node = new GainNode(offline, { gain });
      node.connect(merger, 0, ear);
      return node;
    });
    for (const [at, skipped] of [[begins, 0], [0, layer.length - begins]]) {
      if (skipped >= buffer.length) continue;
      const source = new AudioBufferSourceNode(offline, { buffer });
      for (const node of gains) source.connect(node);
      source.start(at / layer.rate, skipped / layer.rate);
    }
  }
  return offline.startRendering();
}

export class Music {
  #gains = null;
  #nodes = null;

  constructor(context, output) {
    Object.assign(this, { context, output });
    this.#start().catch((error) => console.warn(`no music: ${error.message ?? error}`));
  }

  follow(gains) {
    this.#gains = gains;
    this.#nodes?.forEach((node, layer) => node.gain.setTargetAtTime(gains[layer], this.context.currentTime, SMOOTH));
  }

  async #start() {
    const files = archived(await unzipped("music.packed"));
    const { seconds, layers } = JSON.parse(new TextDecoder().decode(files.get("index")));
    const loops = [];
    for (const [number, layer] of layers.entries()) loops.push(await mixed(layer, undifferenced(files.get(`${number}`))));
    const begins = this.context.currentTime + SOON;
    this.#nodes = loops.map((buffer) => {
      const node = new GainNode(this.context, { gain: 0 });
      node.connect(this.output);
      const source = new AudioBufferSourceNode(this.context, { buffer, loop: true, loopEnd: seconds });
      source.connect(node);
      source.start(begins);
      return node;
    });
    this.follow(this.#gains);
  }
}
