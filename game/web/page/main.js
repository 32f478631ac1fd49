// The page: requests pictures from Python in the worker, paints them, and passes on what the player did.

import { Controls } from "./controls.js";
import { Editor } from "./editor.js";
import { Grader } from "./grader.js";
import { Input } from "./input.js";
import { paint } from "./painter.js";
import { Speaker } from "./speaker.js";
import { Words } from "./words.js";

const TOLD_SECONDS = 7;
const LARGEST_FILE = 16 * 1024 * 1024;
const element = (id) => document.getElementById(id);
const canvas = element("picture"), context = canvas.getContext("2d", { alpha: false });
const speaker = new Speaker(), input = new Input(canvas, hurry, (button) => controls.steer(button));
const controls = new Controls(element("menu"), element("toolbar"), canvas, choose);
const editor = new Editor(element("code"), { typed: (text) => input.add({ type: "code", text }), grade: () => choose("grade", ""), left: () => element("item-grade")?.focus() });
const backdrop = document.createElement("canvas"), backdropContext = backdrop.getContext("2d", { alpha: false });
const words = new Words(element("step"), element("words"));
const questions = new Map();
const HUNG = "Your own functions gave no answer, so the page was opened again without them.";
let limit = 0, worker = null, grader = null, background = "#000", toldUntil = 0, asked = 0;
let ready = false, waiting = false, late = false, sentAt = 0, size = null; // late: send the next request as soon as the reply is there

function say(words) {
  element("loading").textContent = words;
  element("loading").hidden = false;
  element("progress").hidden = true;
}

function fail(words) {
  console.error(words);
  say(words);
}

function tell(words) {
  element("told").textContent = words;
  element("told").hidden = false;
  toldUntil = performance.now() + 1000 * TOLD_SECONDS;
}

/** A control was used. */
function choose(id, value) {
  editor.flush();
  input.add({ type: "choose", id, value });
}

/** Ask the game's Python something, for tests; its answer. */
function ask(what, argument) {
  return new Promise((done) => {
    questions.set(++asked, done);
    worker.postMessage({ kind: "ask", what, argument, number: asked });
  });
}

/** Pixels of the canvas per CSS pixel. */
function density() {
  return Math.min(devicePixelRatio || 1, 2);
}

/** Lay out the picture beside the controls and between the words; its size in pixels. */
function fitted() {
  const area = document.querySelector("main").getBoundingClientRect(), full = { width: area.width, height: area.height };
  for (const side of [element("menu"), element("code")]) {
    if (side.hidden || !(side === element("code") || side.classList.contains("side"))) continue;
    const { left, top, width } = side.getBoundingClientRect();
    if (width < area.width) full.width = Math.max(Math.min(full.width, left - area.left), 200);
    else full.height = Math.max(Math.min(full.height, top - area.top), 200);
  }
  const { step, section } = words;
  step.style.width = section.style.width = `${full.width}px`;
  const top = step.hidden ? 0 : step.offsetHeight;
  section.style.bottom = `${area.height - full.height}px`;
  const height = Math.max(full.height - top - (section.hidden ? 0 : section.offsetHeight), 100);
  canvas.style.top = `${top}px`;
  canvas.style.width = `${full.width}px`;
  canvas.style.height = `${height}px`;
  return [Math.round(full.width * density()), Math.round(height * density())];
}

/** Request the picture of a time, in milliseconds, with everything that the player did since the last request. */
function request(now) {
  if (!size && !(input.holds && request.size)) size = fitted(); // the size does not change while something is dragged
  const seconds = sentAt ? Math.max(now - sentAt, 0) / 1000 : 0, [width, height] = size ?? request.size;
  sentAt = Math.max(now, sentAt);
  [waiting, late] = [true, false];
  worker.postMessage({ kind: "frame", request: JSON.stringify({ seconds, width, height, density: density(), signals: input.taken() }) });
  request.size = [width, height];
}

/** After a key or a button: request a picture at once, without waiting for the browser's next frame. */
function hurry() {
  if (waiting) late = true;
  else if (ready) request(performance.now());
}

/** Paint the picture of a reply as soon as it is there: the browser's next frame shows it. */
function show(reply, [width, height]) {
  if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
  if (reply.backdrop) {
    [backdrop.width, backdrop.height] = [width, height];
    backdropContext.fillStyle = background;
    backdropContext.fillRect(0, 0, width, height);
    paint(backdropContext, reply.backdrop, reply.backdrop_texts ?? []);
  }
  context.globalAlpha = 1;
  context.drawImage(backdrop, 0, 0);
  paint(context, reply.numbers, reply.texts ?? []);
}

/** What a reply says beside its picture. */
function heed(reply) {
  if (reply.colours) {
    for (const [name, value] of Object.entries(reply.colours)) document.documentElement.style.setProperty(`--${name}`, value);
    background = reply.colours.background;
  }
  if (reply.language) document.documentElement.lang = reply.language;
  if (reply.toolbar) controls.showToolbar(reply.toolbar);
  if (reply.menu) controls.show(reply.menu);
  if (reply.menu || reply.menu_closed) input.uncaptured = reply.menu?.uncaptured ?? null;
  if (reply.menu_closed) controls.close();
  if (reply.menu || reply.menu_closed) {
    if (reply.menu?.editor) edit(reply.code ?? null);
    else editor.hide();
  } else if (typeof reply.code === "string") edit(reply.code);
  if (reply.words) words.show(reply.words);
  if (reply.grading) grader.grade(reply.grading);
  if (reply.menu || reply.menu_closed || reply.words || reply.code !== undefined) size = null;
  document.body.classList.toggle("playing", element("menu").hidden || element("menu").classList.contains("side"));
  if (reply.sounds) speaker.play(reply.sounds);
  limit = reply.limit ?? 0;
  if (reply.music) speaker.follow(reply.music);
  if (reply.said) element("said").textContent = reply.said;
  if (reply.described && canvas.getAttribute("aria-label") !== reply.described) canvas.setAttribute("aria-label", reply.described);
  if (reply.fragment !== undefined && reply.fragment !== null) replaceFragment(reply.fragment);
  if (reply.told) tell(reply.told);
  if (reply.download) download(reply.download);
  if (reply.full_screen) fillScreen();
}

function edit(code) {
  editor.show(code);
  grader.prepare();
}

function replaceFragment(fragment) {
  history.replaceState(null, "", fragment ? `#${encodeURI(fragment)}` : location.pathname + location.search);
}

function openFragment() {
  let fragment = location.hash.slice(1);
  try {
    fragment = decodeURIComponent(fragment);
  } catch {
    tell("the address of this page has a broken fragment");
    return;
  }
  if (fragment) input.add({ type: "link", fragment });
}

function fillScreen() {
  const done = document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen?.();
  if (done) done.catch(() => tell("the browser lets this page not fill the screen"));
  else tell("this browser has no full screen for pages");
}

function download({ name, data }) {
  const bytes = Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([bytes]));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

async function give(file) {
  if (file.size > LARGEST_FILE) {
    tell(`${file.name}: larger than 16 MB`);
    return;
  }
  const bytes = new Uint8Array(await file.arrayBuffer());
  let letters = "";
  for (let k = 0; k < bytes.length; k += 8192) letters += String.fromCharCode(...bytes.subarray(k, k + 8192));
  input.add({ type: "file", name: file.name, data: btoa(letters) });
}

function turn(now) {
  requestAnimationFrame(turn);
  if (now > toldUntil) element("told").hidden = true;
  if (!waiting) return request(now);
  late = true;
  if (limit && now - sentAt > 1000 * limit) openAgain(HUNG);
  return undefined;
}

/** Nothing else ends a loop within a function written in C. What is stored is there again, and the address says the rest. */
function openAgain(words) {
  worker.terminate();
  history.replaceState({ told: words }, "");
  location.reload();
}

function heard({ data }) {
  if (data.kind === "ready") {
    element("loading").hidden = true;
    element("progress").hidden = true;
    if (history.state?.told) tell(history.state.told);
    history.replaceState(null, "");
    openFragment();
    ready = true;
    requestAnimationFrame(turn);
  } else if (data.kind === "progress") {
    element("progress").value = data.share;
  } else if (data.kind === "frame") {
    waiting = false;
    heed(data.reply);
    show(data.reply, request.size);
    if (!window.polarBreakout.firstFrame) {
      window.polarBreakout.firstFrame = performance.now();
      navigator.serviceWorker?.register("offline.js").catch(() => undefined); // only now: it loads everything once more
    }
    window.polarBreakout.frames += 1;
    if (late) request(performance.now());
  } else if (data.kind === "answer") {
    questions.get(data.number)(data.answer);
    questions.delete(data.number);
  } else if (data.kind === "told") {
    tell(data.words);
  } else {
    fail(`The game cannot go on: ${data.words}`);
  }
}

function start() {
  if (typeof WebAssembly === "undefined" || typeof DecompressionStream === "undefined") {
    say("This page needs a browser with WebAssembly and DecompressionStream: Chrome or Edge 119, Firefox 121, Safari 17, or newer.");
    return;
  }
  worker = new Worker("worker.js", { type: "module" });
  worker.onerror = (event) => fail(`The game cannot be started: ${event.message ?? "its worker is missing"}`);
  worker.onmessage = heard;
  const base = new URL("./", location.href).href;
  grader = new Grader({ base }, (signal) => input.add(signal));
  worker.postMessage({ kind: "start", base, calm: matchMedia("(prefers-reduced-motion: reduce)").matches, languages: navigator.languages.join(","), touch: matchMedia("(pointer: coarse)").matches });
  for (const name of ["pointerdown", "keydown"]) addEventListener(name, () => speaker.wake());
  addEventListener("resize", () => (size = null));
  addEventListener("hashchange", openFragment);
  addEventListener("dragover", (event) => event.preventDefault());
  addEventListener("drop", (event) => {
    event.preventDefault();
    for (const file of event.dataTransfer.files) give(file);
  });
}

window.polarBreakout = { ask, give, input, speaker, frames: 0, firstFrame: 0 };
start();
