// The game's Python, in a thread of its own: CPython on WebAssembly, the project's modules, what is stored.

import { addFiles, startedPython } from "./python.js";
import { discardSnapshots, storeSnapshot } from "./snapshot.js";

const FOLDER = "/kept"; // also the name of the database in which browsers have stored it
const SNAPSHOT_DELAY = 3000; // milliseconds from the start until its memory is stored
const LOCK_PATIENCE = 2000; // milliseconds: the page that is loaded again may wait for the end of the worker before
const ANOTHER_TAB = "the game is open in another tab: what is played in this one is not stored";
let page = null, pictures = null, python = null, stored = false, storing = Promise.resolve(null), background = "#000";

async function start({ base, calm, languages, touch, grades, port = null }) {
  performance.mark("worker began");
  pictures = port;
  const first = grades ? null : alone();
  const [started, sounds] = await Promise.all([startedPython(), fetch(`${base}sounds.json`).then((answer) => answer.arrayBuffer())]);
  python = started.python;
  if (grades) {
    await addFiles(python, "grading");
    page = python.runPython("from tools.grade.page import PageGrader; PageGrader()");
    return;
  }
  const read = await opened();
  stored = read && (await first);
  python.globals.set("index", python.toPy(new Uint8Array(sounds)));
  python.globals.set("languages", languages);
  page = python.runPython(`
from game.web.client.page import Page
Page(bytes(index), ${read ? `"${FOLDER}"` : '""'}, calm=${calm ? "True" : "False"}, touch=${touch ? "True" : "False"}, languages=languages)
`);
  if (read && !stored) self.postMessage({ kind: "notification", words: ANOTHER_TAB });
  performance.mark("page made");
  if (started.snapshot) {
    storing = new Promise((done) => setTimeout(done, SNAPSHOT_DELAY)).then(() => storeSnapshot(started.snapshot));
  }
}

/** Whether no other tab stores. What one tab has stored since the other was opened would be deleted by the other's next file. */
function alone() {
  if (!navigator.locks) return true; // the page is not from a secure address, as on a local network
  return new Promise((done) => {
    const held = () => {
      done(true);
      return new Promise(() => undefined); // until this worker ends
    };
    navigator.locks.request("stored files", { signal: AbortSignal.timeout(LOCK_PATIENCE) }, held).catch(() => done(false));
  });
}

/** Mount what the browser stores for this page; false where it stores nothing. */
async function opened() {
  try {
    python.FS.mkdirTree(FOLDER);
    python.FS.mount(python.FS.filesystems.IDBFS, {}, FOLDER);
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
  if (stored) saving = saving.then(() => synced(false)).catch((error) => self.postMessage({ kind: "notification", words: `not stored: ${error.message ?? error}` }));
  return saving;
}

function copied(list) {
  const view = list.getBuffer("f32"), copy = view.data.slice();
  view.release();
  list.destroy();
  return copy;
}

/** Let Python play and draw. Another worker paints the picture; the page gets the rest of the reply. */
function frame(request) {
  const { texts = [], backdrop, backdrop_texts: backdropTexts = [], ...reply } = JSON.parse(page.frame(JSON.stringify(request)));
  background = reply.colours?.background ?? background;
  self.postMessage({ kind: "frame", reply });
  const picture = { width: request.width, height: request.height, background, numbers: copied(page.numbers), texts };
  if (backdrop) picture.backdrop = { numbers: copied(page.backdrop), texts: backdropTexts };
  pictures.postMessage(picture, [picture.numbers, picture.backdrop?.numbers].filter(Boolean).map((numbers) => numbers.buffer));
  if (reply.keep) save();
  if (reply.second_engine) loadEngine();
}

/** Load the files of pymunk, the lab's second engine, and hand them to Python. */
async function loadEngine() {
  try {
    await addFiles(python, "pymunk");
    const engine = python.runPython(`
from game.web.cffi.backend import load_library
load_library("pymunk", "_chipmunk")
from tools.crosscheck.second_engine import Pymunk
Pymunk()
`);
    page.second_engine(engine);
  } catch (error) {
    self.postMessage({ kind: "notification", words: `pymunk cannot be loaded: ${error.message ?? error}` });
  }
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
  random: () => python.runPython("import random; random.random()"),
  memory: () => python._module.HEAPU8.length,
  snapshot: () => storing,
  timeline: () => performance.getEntriesByType("mark").map(({ name, startTime }) => [name, performance.timeOrigin + startTime]),
};

self.onmessage = async ({ data }) => {
  try {
    if (data.kind === "start") {
      await start(data).catch(async (error) => {
        await discardSnapshots(); // so that a reload does not find what may have been the cause
        throw error;
      });
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
