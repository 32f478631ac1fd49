// A worker that paints on the page's canvas. It is neither the page's own thread, to which Chromium gives no message after a key until
// it has drawn the next frame, nor Python's worker: without a GPU, filling the pixels takes longer than Python's answer.

import { paint } from "./painter.js";

const backdropCanvas = new OffscreenCanvas(1, 1), backdropContext = backdropCanvas.getContext("2d", { alpha: false });
let canvas = null, context = null;

/** Paint what is behind the pictures that follow. */
function showBackdrop({ width, height, background }, { numbers, texts }) {
  [backdropCanvas.width, backdropCanvas.height] = [width, height];
  backdropContext.fillStyle = background;
  backdropContext.fillRect(0, 0, width, height);
  paint(backdropContext, numbers, texts);
}

/** Paint a picture, and tell the page when that was. The browser's next frame shows it. */
function show({ width, height, background, backdrop, numbers, texts }) {
  if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
  if (backdrop) showBackdrop({ width, height, background }, backdrop);
  context.globalAlpha = 1;
  context.drawImage(backdropCanvas, 0, 0);
  paint(context, numbers, texts);
  self.postMessage({ kind: "painted", time: performance.timeOrigin + performance.now() });
}

/** The page gives its canvas, and the port at which Python's worker sends pictures. */
self.onmessage = ({ data }) => {
  canvas = data.canvas;
  context = canvas.getContext("2d", { alpha: false });
  data.port.onmessage = (event) => show(event.data);
};
