// Has functions graded in a worker of their own, which is ended when they do not answer: an endless loop ends nothing else.

const LOOK_EVERY = 200;

export class Grader {
  #worker = null;
  #ready = null;
  #request = null;
  #asking = ["", 0];
  #since = Infinity;

  /** done: is given what became of a request, as a signal for Python. */
  constructor(options, done) {
    Object.assign(this, { options, done });
    setInterval(() => this.#look(), LOOK_EVERY);
  }

  /** Start the worker before it is needed: that takes some seconds. */
  prepare() {
    if (this.#worker) return;
    this.#worker = new Worker("worker.js", { type: "module" });
    this.#worker.onerror = () => this.#end("", 0);
    this.#ready = new Promise((ready) => {
      this.#worker.onmessage = ({ data }) => (data.kind === "ready" ? ready() : this.#heard(data));
    });
    this.#worker.postMessage({ kind: "start", ...this.options, grades: true });
  }

  async grade(request) {
    this.prepare();
    this.#request = request;
    await this.#ready;
    this.#worker.postMessage({ kind: "ask", what: "grade", argument: JSON.stringify(request), number: request.number });
  }

  #heard(data) {
    if (data.kind === "asking") {
      this.#asking = [data.name, data.call];
      this.#since = data.call ? performance.now() : Infinity;
    } else if (data.kind === "answer") {
      this.#since = Infinity;
      this.done({ type: "graded", number: data.number, reply: data.answer });
    } else if (data.kind === "failed") {
      console.warn(data.words);
      this.#end("", 0);
    }
  }

  #look() {
    if (this.#request && performance.now() - this.#since > 1000 * this.#request.seconds) this.#end(...this.#asking);
  }

  /** End the worker; the next request has a new one. */
  #end(name, call) {
    this.#worker?.terminate();
    this.#worker = null;
    this.#since = Infinity;
    if (this.#request) this.done({ type: "graded", number: this.#request.number, reply: "", function: name, call });
  }
}
