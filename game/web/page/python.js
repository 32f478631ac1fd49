// Starts CPython on WebAssembly with the game's modules imported: from a stored snapshot of its memory, or from the beginning.

import { loadPyodide } from "./runtime/pyodide.mjs";
import { discardSnapshots, storedSnapshot } from "./snapshot.js";

const FOLDER = "/program";
const LIBRARY = `${FOLDER}/msgspec/_core.cpython-314-wasm32-emscripten.so`;
const TYPES = { wasm: "application/wasm", mjs: "text/javascript", zip: "application/zip" };
const SNAPSHOT_HEADER_WORDS = 2; // the second word is where the memory begins, bytes
const IMPORTS = `
import sys
sys.path.insert(0, "${FOLDER}")
import game.web.client.page
from game.levels import campaign, classic
campaign(), classic()
`;
const AWAKE = `
import random
random.seed()
`; // or every visit would draw the same numbers
const DOWNLOADED = 0.7; // share of the progress
const STEPS = { "runtime ready": 0.75, "python started": 0.85, "game imported": 1, "memory copied": 1 }; // the same, when they are reached
const plain = self.fetch.bind(self);
const begun = new Map(); // downloads that nobody has asked for yet
let expected = 0, received = 0; // bytes

function reached(step) {
  performance.mark(step);
  self.postMessage({ kind: "progress", share: STEPS[step] });
}

function count(chunk, out) {
  received += chunk.length;
  if (expected) self.postMessage({ kind: "progress", share: DOWNLOADED * Math.min(received / expected, 1) });
  out.enqueue(chunk);
}

/** Large files are served compressed, whatever the host does; they are unpacked here. */
async function unpacked(name) {
  const answer = await plain(new URL(`${name}.packed`, import.meta.url));
  if (!answer.ok) throw new Error(`${name}: ${answer.status}`);
  const type = TYPES[name.split(".").pop()] ?? "application/octet-stream";
  expected += Number(answer.headers.get("Content-Length"));
  const counted = answer.body.pipeThrough(new TransformStream({ transform: count }));
  return new Response(counted.pipeThrough(new DecompressionStream("gzip")), { headers: { "Content-Type": type } });
}

function download(name) {
  const answer = begun.get(name) ?? unpacked(name);
  begun.delete(name);
  return answer;
}

const PACKED = ["runtime/pyodide.asm.wasm", "runtime/pyodide.asm.mjs", "runtime/python_stdlib.zip", "program"];
for (const name of PACKED) {
  begun.set(name, unpacked(name));
  begun.get(name).catch(() => undefined); // told to whoever asks for it
}

/** The runtime asks for its files by itself. */
self.fetch = (wanted, options) => {
  const address = String(wanted?.url ?? wanted);
  const name = PACKED.find((one) => address.endsWith(`/${one}`));
  return name ? download(name) : plain(wanted, options);
};

async function bytes(answer) {
  return new Uint8Array(await (await answer).arrayBuffer());
}

/** What makes the runtime's module. Its program is unpacked first, so its address is a blob's. */
async function moduleMaker() {
  const address = URL.createObjectURL(new Blob([await bytes(download("runtime/pyodide.asm.mjs"))], { type: "text/javascript" }));
  const made = (await import(address)).default;
  URL.revokeObjectURL(address);
  return made;
}

/** Write the game's files: a list of names and lengths, its own length before it, their contents after it. */
function writeFiles(files, packed) {
  const length = new DataView(packed.buffer, packed.byteOffset).getUint32(0, true);
  let start = 4 + length;
  for (const [name, size] of JSON.parse(new TextDecoder().decode(packed.subarray(4, start)))) {
    const path = `${FOLDER}/${name}`;
    files.mkdirTree(path.slice(0, path.lastIndexOf("/")));
    files.writeFile(path, packed.subarray(start, start + size));
    start += size;
  }
}

/** More of the game's files, from an archive of that name. */
export async function addFiles(python, name) {
  writeFiles(python.FS, await bytes(download(name)));
  python.runPython("import sys; sys.path_importer_cache.clear()");
}

/** Start the runtime. snapshot: of its memory, null for none. */
async function runtime(make, program, snapshot) {
  const memory = snapshot ? snapshot.length - new Uint32Array(snapshot.buffer, 0, SNAPSHOT_HEADER_WORDS)[1] : 0;
  const createPyodideModule = (settings) => {
    let module = null;
    settings.preRun.push((made) => (module = made));
    // msgspec's library is loaded before Python runs: so its functions and data have the same addresses with and without a snapshot.
    settings.onRuntimeInitialized = () => {
      writeFiles(module.FS, program);
      module.loadDynamicLibrary(LIBRARY, { global: false, nodelete: true, allowUndefined: true });
      if (memory > module.HEAPU8.length) module.growMemory(memory);
      reached("runtime ready");
    };
    return make(settings);
  };
  const indexURL = new URL("runtime/", import.meta.url).href;
  const memoryOptions = snapshot ? { _loadSnapshot: snapshot } : { _makeSnapshot: true };
  const python = await loadPyodide({ indexURL, createPyodideModule, ...memoryOptions });
  delete python._api.config._loadSnapshot; // some 27 MB
  return python;
}

/** The memory in use, for `storedSnapshot`: what lies above is zero. */
function snapshotOf(python) {
  const made = python.makeMemorySnapshot(), module = python._module;
  const start = new Uint32Array(made.buffer, 0, SNAPSHOT_HEADER_WORDS)[1];
  return made.subarray(0, start + module.HEAPU32[module._emscripten_get_sbrk_ptr() >>> 2]);
}

/** Python with the game imported. snapshot: of it, to be stored; null where it has come from a stored one. */
export async function startedPython() {
  const [make, program, stored] = await Promise.all([moduleMaker(), bytes(download("program")), storedSnapshot()]);
  performance.mark("files read");
  if (stored) {
    try {
      const python = await runtime(make, program, stored);
      python.runPython(AWAKE);
      reached("memory copied");
      return { python, snapshot: null };
    } catch (error) {
      console.warn(`a stored snapshot cannot be used: ${error.message ?? error}`);
      await discardSnapshots();
    }
  }
  const python = await runtime(make, program, null);
  reached("python started");
  python.runPython(IMPORTS);
  reached("game imported");
  let snapshot = null;
  try {
    snapshot = snapshotOf(python);
  } catch {
    // Every visit will start like this one.
  }
  return { python, snapshot };
}
