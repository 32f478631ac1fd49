// Paints the ground. game/picture/primitives.py documents the primitives, game/drawing/camera.py the projection.
// view: the projection; at: index of a primitive's first number.

const SEAM = 1; // pixels by which a disc is larger, so that what is painted around it has no seam
const SHADES = 4096; // squares of radii, up to that of a disc, whose colours are computed
const shades = new Uint32Array(SHADES + 1);
let image, layer = null; // made when it is used: the page imports this file, too, also in a browser that has no OffscreenCanvas

/** The primitive GROUND_DISC: the colour of every pixel, by its distance from the centre. */
export function disc(context, view, numbers, at) {
  const { x, scale, cosine } = view, lean = view.closeness * view.sine, radius = numbers[at + 1] + SEAM / scale;
  const box = boxOf(context.canvas, ellipse(new Path2D(), view, radius, 0));
  if (box.width < 1 || box.height < 1) return;
  shade(numbers, at, radius);
  if (!layer || layer.width < box.width || layer.height < box.height) [layer, image] = [new OffscreenCanvas(box.width, box.height)];
  const own = layer.getContext("2d");
  image ??= own.createImageData(layer.width, layer.height);
  const pixels = new Uint32Array(image.data.buffer);
  for (let row = 0; row < box.height; row++) { // sees a straight line of the ground, parallel to the screen
    const up = (view.y - box.top - row - 0.5) / scale, away = up / (cosine - up * lean), wide = 1 + lean * away, begin = row * layer.width;
    const half = (Math.sqrt(Math.max(radius * radius - away * away, 0)) / wide) * scale;
    const first = Math.max(Math.ceil(x - half - 0.5) - box.left, 0), end = Math.min(Math.floor(x + half + 0.5) - box.left, box.width);
    const step = (wide / scale / radius) * Math.sqrt(SHADES), square = (away / radius) ** 2 * SHADES;
    pixels.fill(0, begin, begin + first).fill(0, begin + end, begin + box.width);
    for (let column = first, across = (first + box.left + 0.5 - x) * step; column < end; column++, across += step) {
      pixels[begin + column] = shades[(across * across + square) | 0];
    }
  }
  own.putImageData(image, 0, 0, 0, 0, box.width, box.height);
  context.drawImage(layer, 0, 0, box.width, box.height, box.left, box.top, box.width, box.height);
}

/** The pixels of a canvas in which an ellipse may lie. */
function boxOf(canvas, { x, y, across, down }) {
  const left = Math.max(Math.floor(x - across), 0), top = Math.max(Math.floor(y - down), 0);
  return { left, top, width: Math.min(Math.ceil(x + across), canvas.width) - left, height: Math.min(Math.ceil(y + down), canvas.height) - top };
}

/** Compute the colours from the centre to a radius, by its square: so the loop above needs no root. */
function shade(numbers, at, radius) {
  const inner = numbers[at], steps = numbers[at + 2] - 1, each = (numbers[at + 1] - inner) / steps;
  for (let k = 0; k <= SHADES; k++) {
    const here = Math.min(Math.max((Math.sqrt((k + 0.5) / SHADES) * radius - inner) / each, 0), steps), low = Math.min(Math.floor(here), steps - 1);
    const begin = at + 3 + 3 * low, share = here - low;
    const channel = (index) => Math.round(numbers[index] * (1 - share) + numbers[index + 3] * share);
    shades[k] = (255 << 24) | (channel(begin + 2) << 16) | (channel(begin + 1) << 8) | channel(begin);
  }
}

/** The primitive GROUND_CIRCLE, in the context's colour. */
export function circle(context, view, numbers, at) {
  context.beginPath();
  ellipse(context, view, numbers[at] + numbers[at + 1], 0);
  ellipse(context, view, numbers[at], 0);
  context.fill("evenodd");
}

/** The primitive GROUND_SIDE, in the context's colour: all that is below the disc; what is painted later covers the top. */
export function side(context, view, numbers, at) {
  context.beginPath();
  const top = ellipse(context, view, numbers[at], 0), bottom = ellipse(context, view, numbers[at], -numbers[at + 1]);
  context.fill();
  context.beginPath();
  context.moveTo(view.x - top.across, top.y);
  context.lineTo(view.x + top.across, top.y);
  context.lineTo(view.x + bottom.across, bottom.y);
  context.lineTo(view.x - bottom.across, bottom.y);
  context.fill();
}

/**
 * Add a horizontal circle about the centre to a path: every such circle is seen as an ellipse.
 *
 * A point that is `away` from the eye, beyond the centre, has the row (away cosine + up) / (level + lean away), upwards positive.
 */
function ellipse(path, view, radius, height) {
  const { x, scale, closeness, sine, cosine } = view;
  const lean = closeness * sine, level = 1 - closeness * height * cosine, up = height * sine;
  const far = (radius * cosine + up) / (level + lean * radius), near = (up - radius * cosine) / (level - lean * radius);
  const middle = (far + near) / 2, away = (up - middle * level) / (middle * lean - cosine);
  const across = (Math.sqrt(Math.max(radius * radius - away * away, 0)) / (level + lean * away)) * scale;
  const y = view.y - middle * scale, down = ((far - near) / 2) * scale;
  path.moveTo(x + across, y);
  path.ellipse(x, y, across, down, 0, 0, 2 * Math.PI);
  return { x, y, across, down };
}
