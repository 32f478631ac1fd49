// The editor for the player's own functions: CodeMirror, loaded when it is first wanted; without it a plain text field.

import { archived, unzipped } from "./archives.js";

const TYPED_AFTER = 300;
const FILES = ["codemirror.css", "codemirror.js", "python.js"];

export class Editor {
  #loading = null;
  #mirror = null;
  #timer = 0;
  #sent = null;

  /** typed: is given the text when it has changed; grade: is called for Ctrl+Enter; left: for Escape. */
  constructor(section, { typed, grade, left }) {
    Object.assign(this, { section, typed, grade, left, field: section.querySelector("textarea") });
    this.field.addEventListener("input", () => this.#changed());
    section.addEventListener("keydown", (event) => this.#key(event));
  }

  async show(text) {
    this.section.hidden = false;
    this.#loading ??= this.#load();
    await this.#loading;
    if (text !== null && text !== this.#text()) {
      if (this.#mirror) this.#mirror.setValue(text);
      else this.field.value = text;
    }
    this.#sent = this.#text();
    this.#mirror?.refresh();
  }

  hide() {
    this.section.hidden = true;
  }

  /** Send at once what was typed. */
  flush() {
    clearTimeout(this.#timer);
    if (this.section.hidden || this.#sent === null || this.#text() === this.#sent) return;
    this.#sent = this.#text();
    this.typed(this.#sent);
  }

  #text() {
    return this.#mirror ? this.#mirror.getValue() : this.field.value;
  }

  #changed() {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.flush(), TYPED_AFTER);
  }

  /** Of the plain field; CodeMirror reads what was typed before it hears a key. */
  #key(event) {
    if (event.target !== this.field) return;
    if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) this.grade();
    else if (event.key === "Escape") this.left();
    else return;
    event.preventDefault();
  }

  async #load() {
    try {
      const files = archived(await unzipped("editor.packed")), text = new TextDecoder();
      for (const name of FILES) {
        const tag = name.endsWith(".css") ? "style" : "script";
        document.head.append(Object.assign(document.createElement(tag), { textContent: text.decode(files.get(name)) }));
      }
      this.#mirror = globalThis.CodeMirror.fromTextArea(this.field, {
        mode: "python",
        inputStyle: "contenteditable", // what screen readers read
        lineNumbers: true,
        indentUnit: 4,
        lineWrapping: true,
        screenReaderLabel: this.field.getAttribute("aria-label"),
        extraKeys: {
          Tab: (mirror) => mirror.execCommand(mirror.somethingSelected() ? "indentMore" : "insertSoftTab"),
          "Shift-Tab": "indentLess",
          "Ctrl-Enter": () => this.grade(),
          "Cmd-Enter": () => this.grade(),
          Esc: () => this.left(),
        },
      });
      this.#mirror.on("changes", () => this.#changed());
    } catch (error) {
      console.warn(error.message);
    }
  }
}
