// The picture that the player sees. The worker paints it: what a browser tells the page's own thread may wait for its next frame.

import { paint } from "./painter.js";

export class Picture {
  #canvas;
  #context;
  #backdrop = new OffscreenCanvas(1, 1);
  #backdropContext = this.#backdrop.getContext("2d", { alpha: false });

  /** canvas: an OffscreenCanvas, which the page's canvas shows. */
  constructor(canvas) {
    this.#canvas = canvas;
    this.#context = canvas.getContext("2d", { alpha: false });
  }

  /** Paint the backdrop anew, behind the pictures that follow. background: the colour behind it. */
  setBackdrop({ width, height }, background, numbers, texts) {
    [this.#backdrop.width, this.#backdrop.height] = [width, height];
    this.#backdropContext.fillStyle = background;
    this.#backdropContext.fillRect(0, 0, width, height);
    paint(this.#backdropContext, numbers, texts);
  }

  /** Paint a picture. It is shown by the browser's next frame. */
  show({ width, height }, numbers, texts) {
    if (this.#canvas.width !== width || this.#canvas.height !== height) [this.#canvas.width, this.#canvas.height] = [width, height];
    this.#context.globalAlpha = 1;
    this.#context.drawImage(this.#backdrop, 0, 0);
    paint(this.#context, numbers, texts);
  }
}
