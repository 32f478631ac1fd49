// Files as the site has them: compressed, several in one, samples as differences.

/** A file that is served compressed. */
export async function unzipped(address) {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address}: ${answer.status}`);
  return new Uint8Array(await new Response(answer.body.pipeThrough(new DecompressionStream("gzip"))).arrayBuffer());
}

/** The files of an archive by name: a list of names and lengths, its own length before it, their contents after it. */
export function archived(packed) {
  const files = new Map(), length = new DataView(packed.buffer, packed.byteOffset).getUint32(0, true);
  let start = 4 + length;
  for (const [name, size] of JSON.parse(new TextDecoder().decode(packed.subarray(4, start)))) {
    files.set(name, packed.subarray(start, start + size));
    start += size;
  }
  return files;
}

/** 16-bit samples from their third differences, whose low bytes come first, then all high bytes; the sign is in the lowest bit. */
export function undifferenced(bytes) {
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
