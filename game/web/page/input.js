// Listens to keyboard, pointers, wheel and gamepads, and collects what they did until the next frame.

const MOST_PADS = 2;
const TYPED = new Set(["INPUT", "SELECT", "TEXTAREA"]);
const LEFT_BY_ESCAPE = new Set(["INPUT", "SELECT"]);
const CONTROLS = new Set(["INPUT", "SELECT", "TEXTAREA", "BUTTON", "A"]);
const SCROLLING = new Set(["ArrowUp", "ArrowDown", "ArrowLeft", "ArrowRight", " ", "Home", "End", "F1"]);

export class Input {
  #signals = [];
  #pads = []; // the last state of every gamepad
  #pressed = []; // the buttons that are down on each of them
  #held = new Set();
  uncaptured = null; // while every key is sent to Python: the codes of those that are not
  size = [1, 1]; // of the picture, in pixels

  /** hurry: called when something was pressed, released or chosen. steer: called with the number of a gamepad's button that was pressed. */
  constructor(canvas, hurry, steer) {
    Object.assign(this, { canvas, hurry, steer });
    addEventListener("keydown", (event) => this.#key(event, true), { capture: true });
    addEventListener("keyup", (event) => this.#key(event, false));
    for (const [name, phase] of [["pointerdown", "down"], ["pointermove", "move"], ["pointerup", "up"], ["pointercancel", "cancel"]]) {
      canvas.addEventListener(name, (event) => this.#pointer(event, phase));
    }
    navigator.keyboard?.getLayoutMap?.().then((map) => this.add({ type: "layout", written: Object.fromEntries(map) })).catch(() => undefined);
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
    addEventListener("blur", () => this.add({ type: "away" }));
    document.addEventListener("visibilitychange", () => document.hidden && this.add({ type: "away" }));
  }

  /** Whether a pointer is down on the picture, or was since the last request took its events. */
  get holds() {
    return this.#held.size > 0;
  }

  add(signal) {
    if (signal.phase === "down") this.#held.add(signal.id);
    this.#signals.push(signal);
    if (signal.phase !== "move" && signal.type !== "wheel") this.hurry();
  }

  /** What happened since the last call. */
  taken() {
    this.#poll();
    const taken = this.#signals;
    for (const { type, phase, id } of taken) if (type === "pointer" && phase !== "down" && phase !== "move") this.#held.delete(id);
    this.#signals = [];
    return taken;
  }

  #key(event, down) {
    const inControl = CONTROLS.has(event.target.tagName);
    if (down && (event.ctrlKey || event.metaKey || event.altKey || event.repeat)) return; // a key released meanwhile is released
    if (this.uncaptured && down && !this.uncaptured.includes(event.code)) {
      event.preventDefault();
      event.stopPropagation();
      this.add({ type: "key", code: event.code, key: event.key, down });
      return;
    }
    const typed = TYPED.has(event.target.tagName) || event.target.isContentEditable;
    if (typed && (event.key !== "Escape" || !LEFT_BY_ESCAPE.has(event.target.tagName))) return;
    if (inControl && (event.key === " " || event.key === "Enter")) return;
    if ((SCROLLING.has(event.key) || event.key.length === 1) && !inControl) event.preventDefault(); // some browsers search a page for what is typed
    this.add({ type: "key", code: event.code, key: event.key, down });
  }

  #pointer(event, phase) {
    if (phase === "down") {
      this.canvas.focus({ preventScroll: true });
      this.canvas.setPointerCapture(event.pointerId);
    }
    this.add({ type: "pointer", phase, id: event.pointerId, touch: event.pointerType === "touch", buttons: event.buttons, ...this.#pixel(event) });
  }

  #wheel(event) {
    event.preventDefault();
    const notch = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? 100 : 3;
    this.add({ type: "wheel", steps: -event.deltaY / notch, ...this.#pixel(event) });
  }

  #pixel(event) {
    const box = this.canvas.getBoundingClientRect(), [width, height] = this.size;
    return { x: ((event.clientX - box.left) * width) / box.width, y: ((event.clientY - box.top) * height) / box.height };
  }

  #poll() {
    const there = [...(navigator.getGamepads?.() ?? [])].filter((one) => one?.connected && one.mapping === "standard");
    there.slice(0, MOST_PADS).forEach((pad, number) => {
      const state = { type: "pad", pad: number, buttons: pad.buttons.map((button) => button.value), axes: [...pad.axes] };
      const text = JSON.stringify(state);
      if (text === this.#pads[number]) return;
      this.#pads[number] = text;
      this.#signals.push(state);
      const pressed = state.buttons.map((value) => value > 0.5), before = this.#pressed[number] ?? [];
      this.#pressed[number] = pressed;
      pressed.forEach((down, button) => down && !before[button] && this.steer(button));
    });
  }
}
