// Makes the page's controls of the values that Python gives, and says which was used.

import { paint } from "./painter.js";

const PAD = { use: 0, up: 12, down: 13, left: 14, right: 15 }; // a gamepad's buttons in the standard layout
const READ = new Set(["words", "heading", "pair", "number", "buttons"]); // the hint is within the control, or there is none
const SLIDER_STEPS = 400; // of a number that may have any value

function made(tag, properties = {}, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

/** A number's name, what it means, a slider, and a field; the two follow each other. */
function number(item, name, use) {
  const limits = { min: item.low, max: item.high, step: item.step || "any", value: item.value };
  const field = made("input", { type: "number", id: name, ...limits });
  field.oninput = () => { field.dataset.typed = "yes"; };
  field.onchange = () => use(item.id, field.value);
  field.onblur = () => { delete field.dataset.typed; };
  const slider = made("input", { type: "range", ...limits, step: item.step || (item.high - item.low) / SLIDER_STEPS });
  slider.setAttribute("aria-label", `${item.label} ${item.hint ?? ""}`);
  slider.oninput = () => use(item.id, slider.value);
  const words = made("label", { htmlFor: name }, item.label, ...(item.hint ? [made("small", {}, item.hint)] : []));
  return made("div", { className: "number" }, words, slider, field);
}

/** A picture before words, of two canvas pixels per CSS pixel. */
function pictured(numbers) {
  const canvas = made("canvas", { width: 48, height: 48 });
  paint(canvas.getContext("2d"), Float32Array.from(numbers), []);
  return canvas;
}

/** Several buttons in a row, after their common name. */
function buttons(item, name, use) {
  const row = item.options.map(([value, words, spoken]) => {
    const button = made("button", { type: "button", id: `${name}-${value}`, onclick: () => use(item.id, value) }, words);
    button.setAttribute("aria-label", spoken);
    return button;
  });
  return made("div", { id: name, className: "buttons" }, made("span", {}, item.label), ...row);
}

/** Let a control show another value, unless somebody is typing in it. A number that was typed stays until its field is left. */
function update(element, item) {
  for (const field of element.querySelectorAll("select, input")) {
    if (field.dataset.typed || (field === document.activeElement && field.type === "text")) continue;
    if (field.type === "checkbox") field.checked = item.value === "True";
    else if (field.value !== item.value) field.value = item.value;
  }
}

function control(item, use) {
  const hint = item.hint ? { title: item.hint } : {};
  const name = `item-${item.id}`;
  if (item.kind === "button") {
    return made("button", { type: "button", id: name, disabled: item.disabled, onclick: () => use(item.id, ""), ...hint }, item.label);
  }
  if (item.kind === "words") return made("p", { id: name }, ...(item.picture.length ? [pictured(item.picture)] : []), item.label);
  if (item.kind === "heading") return made("h2", { id: name }, item.label, ...(item.hint ? [made("small", {}, item.hint)] : []));
  if (item.kind === "pair") return made("p", { id: name, className: "pair" }, made("b", {}, item.label), " ", made("span", {}, item.hint));
  if (item.kind === "buttons") return buttons(item, name, use);
  if (item.kind === "choice") {
    const options = item.options.map(([value, words]) => made("option", { value, selected: value === item.value }, words));
    const select = made("select", { id: name, onchange: () => use(item.id, select.value) }, ...options);
    return made("label", hint, item.label, select);
  }
  if (item.kind === "switch") {
    const box = made("input", { type: "checkbox", id: name, checked: item.value === "True", onchange: () => use(item.id, box.checked ? "True" : "False") });
    return made("label", hint, item.label, box);
  }
  if (item.kind === "number") return number(item, name, use);
  const field = made("input", { type: "text", id: name, value: item.value, maxLength: item.high || 400, spellcheck: false });
  const enter = () => use(item.id, field.value);
  field.onkeydown = (event) => event.key === "Enter" && enter();
  return made("label", hint, item.label, field, made("button", { type: "button", id: `${name}-enter`, onclick: enter }, "Enter"));
}

/** A control with its description below it. */
function hinted(own, hint) {
  return made("div", {}, own, made("p", { className: "hint" }, hint));
}

export class Controls {
  #captures = false; // whether keys and buttons mean something else now
  #shape = "";
  #wanted = "";
  #lines = [];
  #items = [];

  constructor(menu, toolbar, canvas, use) {
    Object.assign(this, { menu, toolbar, canvas, use });
    menu.addEventListener("keydown", (event) => this.#move(event));
  }

  /** Show a menu in place of the one before; the control that had the keyboard keeps it where it is still there. */
  show(menu) {
    const held = document.activeElement?.id, same = this.menu.dataset.title === menu.title && !this.menu.hidden;
    const shape = JSON.stringify([menu.title, menu.lines?.length, menu.side, menu.editor, menu.items.map((item) => ({ ...item, value: "" }))]);
    if (same && shape === this.#shape) return this.#update(menu);
    this.#shape = shape;
    const position = this.menu.scrollTop;
    const title = made("h1", { id: "menu-title" }, menu.title);
    const lines = menu.lines.map((line) => made("p", {}, line));
    const items = made("div", { className: "items" }), elements = menu.items.map((item) => control(item, this.use));
    for (const [index, item] of menu.items.entries()) {
      const own = elements[index], explained = item.hint && !READ.has(item.kind) && !menu.side;
      items.append(explained ? hinted(own, item.hint) : own);
    }
    this.menu.replaceChildren(title, ...lines, items);
    this.#lines = lines;
    this.#items = elements;
    this.menu.dataset.title = menu.title;
    this.menu.classList.toggle("side", menu.side);
    document.body.classList.toggle("coding", menu.editor);
    this.menu.hidden = false;
    this.#captures = Boolean(menu.uncaptured);
    this.menu.scrollTop = same ? position : 0;
    const first = same || !menu.focus ? null : document.getElementById(`item-${menu.focus}`);
    if (first) return first.focus();
    const wanted = held || this.#wanted, again = same && wanted ? document.getElementById(wanted) : null;
    this.#wanted = again?.disabled ? wanted : ""; // a disabled control gets the focus back when it is enabled again
    if (again && this.menu.contains(again)) again.focus({ preventScroll: true });
    else if (!menu.side) this.#controls()[0]?.focus({ preventScroll: true });
    return undefined;
  }

  /** Give the same controls new values. The elements are kept, so that a slider can be dragged on. */
  #update(menu) {
    menu.lines.forEach((line, index) => {
      if (this.#lines[index].textContent !== line) this.#lines[index].textContent = line;
    });
    menu.items.forEach((item, index) => update(this.#items[index], item));
  }

  close() {
    this.#shape = "";
    this.menu.hidden = true;
    document.body.classList.remove("coding");
    this.menu.replaceChildren();
    this.canvas.focus({ preventScroll: true });
  }

  showToolbar(items) {
    const held = document.activeElement?.id;
    this.toolbar.replaceChildren(...items.map((item) => control(item, (id, value) => {
      this.use(id, value);
      this.canvas.focus({ preventScroll: true });
    })));
    this.toolbar.hidden = items.length === 0;
    if (held) document.getElementById(held)?.focus({ preventScroll: true });
  }

  #controls() {
    return [...this.menu.querySelectorAll("button:not(:disabled), select, input")];
  }

  /** The arrows go from control to control, as in the game's own menus; within a field they are the field's. Where there is only one, they scroll. */
  #move(event) {
    const step = { ArrowUp: -1, ArrowDown: 1 }[event.key], side = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (event.target.tagName !== "BUTTON" || (step && this.#controls().length < 2)) return;
    if (step) this.#focus(step);
    else if (!side || !aside(event.target, side)) return;
    event.preventDefault();
  }

  /** Let the control above or below have the keyboard; a row of buttons counts as one, and the column stays. */
  #focus(step) {
    const rows = [...new Set(this.#controls().map((control) => control.closest(".buttons") ?? control))], held = document.activeElement;
    const row = held?.closest(".buttons") ?? held, next = rows[(rows.indexOf(row) + step + rows.length) % rows.length];
    const column = row === held ? 0 : [...row.querySelectorAll("button")].indexOf(held);
    (next?.querySelectorAll("button")[column] ?? next)?.focus();
  }

  /** A gamepad's button: up and down go from control to control, left and right change its value, A uses it. */
  steer(button) {
    if (this.menu.hidden || this.#captures || this.menu.classList.contains("side")) return;
    const held = document.activeElement, side = { [PAD.left]: -1, [PAD.right]: 1 }[button];
    if (button === PAD.up || button === PAD.down) this.#focus(button === PAD.up ? -1 : 1);
    else if (!this.menu.contains(held)) return;
    else if (button === PAD.use && (held.tagName === "BUTTON" || held.type === "checkbox")) held.click();
    else if (side && !aside(held, side)) changed(held, side);
  }
}

/** Let the next button of a row have the keyboard; whether the one that has it is in a row. */
function aside(button, step) {
  const row = button.closest(".buttons"), all = [...(row?.querySelectorAll("button") ?? [])];
  all[(all.indexOf(button) + step + all.length) % all.length]?.focus();
  return row !== null;
}

/** Another value of a choice or of a number. */
function changed(field, step) {
  if (field.tagName === "SELECT") field.selectedIndex = Math.min(Math.max(field.selectedIndex + step, 0), field.options.length - 1);
  else if (field.type !== "number") return;
  else if (step < 0) field.stepDown();
  else field.stepUp();
  field.dispatchEvent(new Event("change"));
}
