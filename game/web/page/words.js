// The words around a scene of the lab: the step above the picture; below it the formulas, the line of code that decides, and the note.

export class Words {
  #scene = "";
  #least = 0;
  #formulas = [];

  /** step, section: the elements above and below the picture. */
  constructor(step, section) {
    Object.assign(this, { step, section });
    [this.formula, this.cited, this.note] = section.children;
    addEventListener("resize", () => this.#forget());
  }

  /** Show words. Only what differs is replaced, since numbers change in every frame while something is dragged. */
  show({ scene, step, formula, cited, note, scale }) {
    if (scene !== this.#scene) this.#forget();
    this.#scene = scene;
    if (this.step.innerHTML !== step) this.step.innerHTML = step;
    this.step.hidden = !step;
    this.section.hidden = !scene;
    for (const element of [this.step, this.section]) element.style.setProperty("--scale", scale);
    while (this.formula.children.length > formula.length) this.formula.lastChild.remove();
    formula.forEach((line, index) => {
      const row = this.formula.children[index] ?? this.formula.appendChild(document.createElement("p"));
      if (this.#formulas[index] !== line || !row.innerHTML) row.innerHTML = line; // made by the game's Python, of its own texts
    });
    this.#formulas = formula;
    this.cited.textContent = cited;
    if (this.note.innerHTML !== note) this.note.innerHTML = note;
    this.#fit(scale > 1);
  }

  /**
   * Make the words fit: formulas that do not fit below each other are put side by side. The height never shrinks while a scene is
   * shown. While presenting, the formulas that were revealed first are hidden instead, then the note.
   */
  #fit(presents) {
    const { section } = this, rows = [...this.formula.children], overflows = () => section.scrollHeight > section.clientHeight + 1;
    section.classList.toggle("presents", presents);
    section.classList.remove("dense");
    section.style.minHeight = "";
    for (const row of [...rows, this.note]) row.hidden = false;
    if (presents) {
      while (rows.length > 1 && overflows()) rows.shift().hidden = true;
      if (rows.length > 0 && overflows()) this.note.hidden = true;
      return;
    }
    if (overflows()) section.classList.add("dense");
    this.#least = Math.max(this.#least, section.offsetHeight);
    section.style.minHeight = `${this.#least}px`;
  }

  #forget() {
    this.#least = 0;
  }
}
