// Paints what stands in a slot of the flat view. game/picture/display_list.py documents the primitives.
// at: index of a primitive's first number.

const MOST_STEPS = 6; // sectors that a shade is made of, where no gradient of the canvas has its shape
const gradients = new Map();

/** The primitive SECTOR, in the context's colour. */
export function sector(context, numbers, at) {
  if (outline(context, numbers, at, numbers[at + 6])) context.fill();
}

/** The primitive FOOT. */
export function foot(context, numbers, at, opacity) {
  const inset = numbers[at + 6], reach = numbers[at + 7], steps = stepsOf(reach);
  context.fillStyle = "#000";
  for (let k = 0; k < steps; k++) {
    context.globalAlpha = added(opacity, k, steps);
    if (outline(context, numbers, at, Math.max(inset - reach * (1 - (k + 0.5) / steps), 0))) context.fill();
  }
}

/** The primitive CAST: sectors, the smaller on the larger ones, whose borders are where it is half a step darker than before. */
export function cast(context, numbers, at, opacity) {
  const inner = numbers[at + 2], outer = numbers[at + 3], half = numbers[at + 5];
  const inwards = numbers[at + 6], outwards = numbers[at + 7], aside = numbers[at + 8], steps = stepsOf(outwards / 2);
  context.fillStyle = "#000";
  for (let k = 0; k < steps; k++) {
    const dark = (k + 0.5) / steps, beyond = 1 - Math.sqrt(dark), side = aside * (1 - dark);
    const first = Math.max(inner - inwards * beyond, 0), last = outer + outwards * beyond;
    context.globalAlpha = added(opacity, k, steps);
    annulus(context, numbers, at, first, last, half + side / Math.max(first, 1), half + side / last);
    context.fill();
  }
}

/** The primitive RELIEF: a gradient from face to face, and one along each end. */
export function relief(context, numbers, at, opacity) {
  const [x, y, inner, outer, angle, half, own, atFaces, atEnds, slope] = numbers.subarray(at, at + 10);
  const width = outer - inner, edge = Math.min(own, width / 2), within = slope * (1 - (2 * edge) / width);
  context.globalAlpha = 1;
  context.fillStyle = cached([x, y, inner, outer, own, atFaces, slope, opacity], () => {
    const gradient = context.createRadialGradient(x, y, inner, x, y, outer);
    for (const [share, light] of [[0, atFaces + slope], [edge / width, within], [0.5, 0]]) {
      gradient.addColorStop(share, `rgb(255 255 255 / ${light * opacity})`);
    }
    for (const [share, shade] of [[0.5, 0], [1 - edge / width, within], [1, atFaces + slope]]) {
      gradient.addColorStop(share, `rgb(0 0 0 / ${shade * opacity})`);
    }
    return gradient;
  });
  outline(context, numbers, at, 0);
  context.fill();
  if (half >= Math.PI) return;
  for (const side of [-1, 1]) {
    const end = angle + side * half, alongX = Math.cos(end), alongY = Math.sin(end);
    const inX = side * edge * alongY, inY = -side * edge * alongX;
    const gradient = context.createLinearGradient(x, y, x + inX, y + inY);
    gradient.addColorStop(0, `rgb(255 255 255 / ${atEnds * opacity})`);
    gradient.addColorStop(1, "rgb(255 255 255 / 0)");
    context.fillStyle = gradient;
    context.beginPath();
    context.moveTo(x + alongX * inner, y + alongY * inner);
    context.lineTo(x + alongX * outer, y + alongY * outer);
    context.lineTo(x + alongX * (outer - edge) + inX, y + alongY * (outer - edge) + inY);
    context.lineTo(x + alongX * (inner + edge) + inX, y + alongY * (inner + edge) + inY);
    context.fill();
  }
}

/** The primitive BAR, in the context's colour. */
export function bar(context, numbers, at) {
  const [x, y, angle, inner, start, outer, end, half] = numbers.subarray(at, at + 8);
  context.beginPath();
  for (const [radius, middle, side] of [[inner, start, -1], [inner, start, 1], [outer, end, 1], [outer, end, -1]]) {
    const own = angle - middle - (side * half) / radius;
    context.lineTo(x + radius * Math.cos(own), y + radius * Math.sin(own));
  }
  context.fill();
}

/** Begin the path of a sector whose sides are moved inwards. Returns false if nothing is left of it. */
function outline(context, numbers, at, inset) {
  const inner = numbers[at + 2] + inset, outer = numbers[at + 3] - inset, half = numbers[at + 5];
  const atInner = half - Math.asin(Math.min(inset / inner, 1)), atOuter = half - Math.asin(Math.min(inset / outer, 1));
  if (inner >= outer || Math.min(atInner, atOuter) <= 0) return false;
  annulus(context, numbers, at, inner, outer, atInner, atOuter);
  return true;
}

/** Begin the path of an annular sector. atInner, atOuter: its half angle at both radii. */
function annulus(context, numbers, at, inner, outer, atInner, atOuter) {
  const x = numbers[at], y = numbers[at + 1], angle = numbers[at + 4];
  context.beginPath();
  if (numbers[at + 5] >= Math.PI) {
    context.arc(x, y, outer, 0, 2 * Math.PI);
    context.arc(x, y, inner, 2 * Math.PI, 0, true);
  } else {
    context.arc(x, y, outer, angle - atOuter, angle + atOuter);
    context.arc(x, y, inner, angle + atInner, angle - atInner, true);
  }
  context.closePath();
}

/** The number of sectors that a shade of some width is made of. */
function stepsOf(width) {
  return Math.min(Math.max(Math.ceil(width), 2), MOST_STEPS);
}

/** The opacity of the sector number k of so many, which together are as dark as `opacity` in equal steps. */
function added(opacity, k, steps) {
  return 1 - (1 - (opacity * (k + 1)) / steps) / (1 - (opacity * k) / steps);
}

/** A gradient that depends on some numbers, made once. */
function cached(numbers, make) {
  const key = numbers.join();
  let found = gradients.get(key);
  if (!found) {
    if (gradients.size > 256) gradients.clear();
    gradients.set(key, (found = make()));
  }
  return found;
}
