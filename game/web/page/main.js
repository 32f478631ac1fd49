// The page: requests pictures with what the player did, and shows the menus and words that come with them.

import { Controls } from "./controls.js";
import { Editor } from "./editor.js";
import { Grader } from "./grader.js";
import { Input } from "./input.js";
import { Speaker } from "./speaker.js";
import { Words } from "./words.js";

const NOTIFICATION_SECONDS = 7;
const LARGEST_FILE = 16 * 1024 * 1024;
const MOST_WAITING = 3; // requests without a picture: each key has one of its own, unless the workers are too slow
const element = (id) => document.getElementById(id);
const canvas = element("picture");
const speaker = new Speaker(), input = new Input(canvas, hurry, (button) => controls.steer(button));
const controls = new Controls(element("menu"), element("toolbar"), canvas, choose);
const editor = new Editor(element("code"), { typed: (text) => input.add({ type: "code", text }), grade: () => choose("grade", ""), left: () => element("item-grade")?.focus() });
const words = new Words(element("step"), element("words"));
const questions = new Map();
const HUNG = "Your own functions gave no answer, so the page was opened again without them.";
let limit = 0, worker = null, grader = null, notifiedUntil = 0, asked = 0;
let ready = false, late = false, sentAt = 0; // late: the next request is sent as soon as no picture is missing
let size = null, resized = true; // the picture's size in pixels; whether it has to be determined again
const waiting = []; // when the requests were sent whose pictures are not painted yet

function say(words) {
  element("loading").textContent = words;
  element("loading").hidden = false;
  element("progress").hidden = true;
}

function fail(words) {
  console.error(words);
  say(words);
}

function notify(words) {
  element("notification").textContent = words;
  element("notification").hidden = false;
  notifiedUntil = performance.now() + 1000 * NOTIFICATION_SECONDS;
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
  if (resized && !(input.holds && size)) { // the size does not change while something is dragged
    [size, resized] = [fitted(), false];
    input.size = size;
  }
  const seconds = sentAt ? Math.max(now - sentAt, 0) / 1000 : 0, [width, height] = size;
  sentAt = Math.max(now, sentAt);
  waiting.push(now);
  late = false;
  worker.postMessage({ kind: "frame", request: { seconds, width, height, density: density(), signals: input.taken() } });
}

/**
 * After a key or a button: request a picture at once. It waits neither for the browser's next frame nor for another picture,
 * of which some browsers tell only after the next frame when a key was pressed.
 */
function hurry() {
  if (!ready) return;
  if (waiting.length < MOST_WAITING) request(performance.now());
  else late = true;
}

/** What a reply says beside its picture. */
function apply(reply) {
  for (const [name, value] of Object.entries(reply.colours ?? {})) document.documentElement.style.setProperty(`--${name}`, value);
  if (reply.language) document.documentElement.lang = reply.language;
  if (reply.toolbar) controls.showToolbar(reply.toolbar);
  if (reply.menu) controls.show(reply.menu);
  if (reply.menu_closed) controls.close();
  if (reply.menu || reply.menu_closed) {
    input.uncaptured = reply.menu?.uncaptured ?? null;
    if (reply.menu?.editor) edit(reply.code ?? null);
    else editor.hide();
  } else if (typeof reply.code === "string") edit(reply.code);
  if (reply.words) words.show(reply.words);
  if (reply.grading) grader.grade(reply.grading);
  if (reply.menu || reply.menu_closed || reply.words || reply.code !== undefined) resized = true;
  document.body.classList.toggle("playing", element("menu").hidden || element("menu").classList.contains("side"));
  if (reply.sounds) speaker.play(reply.sounds);
  limit = reply.limit ?? 0;
  if (reply.music) speaker.follow(reply.music);
  if (reply.announcement) element("announcement").textContent = reply.announcement;
  if (reply.described && canvas.getAttribute("aria-label") !== reply.described) canvas.setAttribute("aria-label", reply.described);
  if (typeof reply.fragment === "string") replaceFragment(reply.fragment);
  if (reply.notification) notify(reply.notification);
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
    notify("the address of this page has a broken fragment");
    return;
  }
  if (fragment) input.add({ type: "link", fragment });
}

function fillScreen() {
  const done = document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen?.();
  if (done) done.catch(() => notify("the browser lets this page not fill the screen"));
  else notify("this browser has no full screen for pages");
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
    notify(`${file.name}: larger than 16 MB`);
    return;
  }
  const bytes = new Uint8Array(await file.arrayBuffer());
  let letters = "";
  for (let k = 0; k < bytes.length; k += 8192) letters += String.fromCharCode(...bytes.subarray(k, k + 8192));
  input.add({ type: "file", name: file.name, data: btoa(letters) });
}

function turn(now) {
  requestAnimationFrame(turn);
  if (now > notifiedUntil) element("notification").hidden = true;
  if (!waiting.length) return request(now);
  late = true;
  if (limit && now - waiting[0] > 1000 * limit) openAgain(HUNG);
  return undefined;
}

/** Nothing else ends a loop within a function written in C. What is stored is there again, and the address says the rest. */
function openAgain(words) {
  worker.terminate();
  history.replaceState({ notification: words }, "");
  location.reload();
}

function receive({ data }) {
  if (data.kind === "ready") {
    element("loading").hidden = true;
    element("progress").hidden = true;
    if (history.state?.notification) notify(history.state.notification);
    history.replaceState(null, "");
    openFragment();
    ready = true;
    requestAnimationFrame(turn);
  } else if (data.kind === "progress") {
    element("progress").value = data.share;
  } else if (data.kind === "frame") {
    apply(data.reply);
    window.polarBreakout.frames += 1;
  } else if (data.kind === "painted") {
    waiting.shift();
    if (!window.polarBreakout.firstFrame) {
      window.polarBreakout.firstFrame = performance.now();
      navigator.serviceWorker?.register("offline.js").catch(() => undefined); // only now: it loads everything once more
    }
    if (late && !waiting.length) request(performance.now());
  } else if (data.kind === "answer") {
    questions.get(data.number)(data.answer);
    questions.delete(data.number);
  } else if (data.kind === "notification") {
    notify(data.words);
  } else {
    fail(`The game cannot go on: ${data.words}`);
  }
}

function start() {
  const needed = ["WebAssembly", "DecompressionStream", "OffscreenCanvas"];
  if (needed.some((name) => !(name in globalThis)) || !canvas.transferControlToOffscreen) {
    say("This page needs a browser with WebAssembly, DecompressionStream and OffscreenCanvas: Chrome or Edge 119, Firefox 121, Safari 17, or newer.");
    return;
  }
  const painter = new Worker("picture.js", { type: "module" }), shown = canvas.transferControlToOffscreen();
  worker = new Worker("worker.js", { type: "module" });
  for (const one of [painter, worker]) {
    one.onerror = (event) => fail(`The game cannot ${ready ? "go on" : "be started"}: ${event.message ?? "its worker is missing"}`);
    one.onmessage = receive;
  }
  const base = new URL("./", location.href).href, { port1, port2 } = new MessageChannel();
  grader = new Grader({ base }, (signal) => input.add(signal));
  const calm = matchMedia("(prefers-reduced-motion: reduce)").matches, touch = matchMedia("(pointer: coarse)").matches;
  const languages = navigator.languages.join(",");
  painter.postMessage({ canvas: shown, port: port1 }, [shown, port1]);
  worker.postMessage({ kind: "start", base, calm, languages, touch, port: port2 }, [port2]);
  for (const name of ["pointerdown", "keydown"]) addEventListener(name, () => speaker.wake());
  addEventListener("resize", () => (resized = true));
  addEventListener("hashchange", openFragment);
  addEventListener("dragover", (event) => event.preventDefault());
  addEventListener("drop", (event) => {
    event.preventDefault();
    for (const file of event.dataTransfer.files) give(file);
  });
}

window.polarBreakout = { ask, give, input, speaker, frames: 0, firstFrame: 0 };
start();
