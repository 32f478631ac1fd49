// The game's Python, in a thread of its own: CPython on WebAssembly, the project's modules, what is stored.

import { loadPyodide } from "./runtime/pyodide.mjs";

const KEPT = "/kept";
const PACKED = ["pyodide.asm.wasm", "pyodide.asm.mjs", "pyodide-lock.json"];
const TYPES = { wasm: "application/wasm", mjs: "text/javascript", json: "application/json" };
const plain = self.fetch.bind(self);
const GRADES = `
import sys
sys.path[:0] = ["/program/game.zip", "/program/grading.zip"]
from tools.grade.page import PageGrader
PageGrader()
`;
let page = null, python = null, stored = false;

/** Large files of the runtime are served compressed, whatever the host does; they are unpacked here. */
self.fetch = async (wanted, options) => {
  const address = String(wanted?.url ?? wanted);
  const name = PACKED.find((one) => address.endsWith(`/${one}`));
  if (!name) return plain(wanted, options);
  const answer = await plain(`${address}.packed`);
  if (!answer.ok) return answer;
  const type = TYPES[name.split(".").pop()];
  return new Response(answer.body.pipeThrough(new DecompressionStream("gzip")), { headers: { "Content-Type": type } });
};

async function bytes(address) {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address}: ${answer.status}`);
  return new Uint8Array(await answer.arrayBuffer());
}

async function start({ base, calm, languages, grades }) {
  const program = URL.createObjectURL(new Blob([await bytes(`${base}runtime/pyodide.asm.mjs`)], { type: "text/javascript" }));
  const createPyodideModule = (await import(program)).default;
  URL.revokeObjectURL(program);
  const [own, msgspec, sounds] = await Promise.all([bytes(`${base}game.zip`), bytes(`${base}runtime/msgspec.whl`), bytes(`${base}sounds.json`), runtime(createPyodideModule, base)]);
  python.unpackArchive(msgspec, "wheel");
  python.FS.mkdirTree("/program");
  python.FS.writeFile("/program/game.zip", own);
  if (grades) {
    python.FS.writeFile("/program/grading.zip", await bytes(`${base}grading.zip`));
    page = python.runPython(GRADES);
    return;
  }
  stored = await opened();
  python.globals.set("index", python.toPy(sounds));
  python.globals.set("languages", languages);
  page = python.runPython(`
import sys
sys.path.insert(0, "/program/game.zip")
from game.web.client.page import Page
Page(bytes(index), ${stored ? `"${KEPT}"` : '""'}, calm=${calm ? "True" : "False"}, languages=languages)
`);
}

async function runtime(createPyodideModule, base) {
  python = await loadPyodide({ indexURL: `${base}runtime/`, createPyodideModule });
}

/** Mount what the browser stores for this page; false where it stores nothing. */
async function opened() {
  try {
    python.FS.mkdirTree(KEPT);
    python.FS.mount(python.FS.filesystems.IDBFS, {}, KEPT);
    await synced(true);
    return true;
  } catch {
    return false;
  }
}

function synced(reads) {
  return new Promise((done, failed) => python.FS.syncfs(reads, (error) => (error ? failed(error) : done())));
}

let saving = Promise.resolve();

function save() {
  if (stored) saving = saving.then(() => synced(false)).catch((error) => self.postMessage({ kind: "told", words: `not stored: ${error.message ?? error}` }));
  return saving;
}

function copied(list) {
  const view = list.getBuffer("f32"), copy = view.data.slice();
  view.release();
  list.destroy();
  return copy;
}

function frame(request) {
  const reply = JSON.parse(page.frame(request));
  reply.numbers = copied(page.numbers);
  const transfers = [reply.numbers.buffer];
  if (reply.backdrop) {
    reply.backdrop = copied(page.backdrop);
    transfers.push(reply.backdrop.buffer);
  }
  self.postMessage({ kind: "frame", reply }, transfers);
  if (reply.keep) save();
}

const ASKED = {
  grade: (request) => page.grade(request, (name, call) => self.postMessage({ kind: "asking", name, call })),
  probe: () => page.probe(),
  verify: (data) => {
    const given = python.toPy(data);
    const found = page.verify(given.tobytes ? given.tobytes() : given);
    given.destroy?.();
    return found;
  },
  save: () => save().then(() => stored),
  memory: () => python._module.HEAPU8.length,
};

self.onmessage = async ({ data }) => {
  try {
    if (data.kind === "start") {
      await start(data);
      self.postMessage({ kind: "ready" });
    } else if (data.kind === "frame") {
      frame(data.request);
    } else if (data.kind === "ask") {
      self.postMessage({ kind: "answer", number: data.number, answer: await ASKED[data.what](data.argument) });
    }
  } catch (error) {
    self.postMessage({ kind: "failed", words: String(error.message ?? error) });
  }
};
