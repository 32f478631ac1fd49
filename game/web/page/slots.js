// Paints what stands in a slot of the flat view. game/picture/primitives.py documents the primitives.
// at: index of a primitive's first number.

const MOST_STEPS = 6; // sectors that a shade is made of, where no gradient of the canvas has its shape
const MOST_RELIEFS = 64; // that are cached: one for each ring
const reliefs = new Map();

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
  const [x, y, inner, outer, angle, half, inwards, outwards, aside] = numbers.subarray(at, at + 9), steps = stepsOf(outwards / 2);
  context.fillStyle = "#000";
  for (let k = 0; k < steps; k++) {
    const dark = (k + 0.5) / steps, beyond = 1 - Math.sqrt(dark), side = aside * (1 - dark);
    const first = Math.max(inner - inwards * beyond, 0), last = outer + outwards * beyond;
    context.globalAlpha = added(opacity, k, steps);
    context.beginPath();
    annulus(context, x, y, first, last, angle, half + side / Math.max(first, 1), half + side / last);
    context.fill();
  }
}

/** The primitive RELIEF: a gradient from face to face, and one along each end. The sectors of a ring share them. */
export function relief(context, numbers, at, opacity) {
  const angle = numbers[at + 4], half = numbers[at + 5], before = context.getTransform();
  const { faces, light, ends, edge } = shared(context, numbers, at, opacity);
  context.globalAlpha = 1;
  context.translate(numbers[at], numbers[at + 1]);
  context.rotate(angle);
  context.fillStyle = light;
  context.fill(faces);
  if (half < Math.PI) {
    context.fillStyle = edge;
    context.rotate(-half);
    context.fill(ends);
    context.rotate(2 * half);
    context.scale(1, -1);
    context.fill(ends);
  }
  context.setTransform(before);
}

/** The paths of a relief's faces and of an end, and the gradients that fill them: about the centre, at the angle 0. */
function shared(context, numbers, at, opacity) {
  const [inner, outer, , half, own, atFaces, atEnds, slope] = numbers.subarray(at + 2, at + 10);
  const key = `${inner} ${outer} ${half} ${own} ${atFaces} ${atEnds} ${slope} ${opacity}`;
  let found = reliefs.get(key);
  if (found) return found;
  const width = outer - inner, depth = Math.min(own, width / 2), within = slope * (1 - (2 * depth) / width);
  const light = context.createRadialGradient(0, 0, inner, 0, 0, outer), edge = context.createLinearGradient(0, 0, 0, depth);
  for (const [share, strength] of [[0, atFaces + slope], [depth / width, within], [0.5, 0]]) {
    light.addColorStop(share, `rgb(255 255 255 / ${strength * opacity})`);
  }
  for (const [share, strength] of [[0.5, 0], [1 - depth / width, within], [1, atFaces + slope]]) {
    light.addColorStop(share, `rgb(0 0 0 / ${strength * opacity})`);
  }
  edge.addColorStop(0, `rgb(255 255 255 / ${atEnds * opacity})`);
  edge.addColorStop(1, "rgb(255 255 255 / 0)");
  const faces = new Path2D(), ends = new Path2D(`M${inner} 0H${outer}L${outer - depth} ${depth}H${inner + depth}Z`);
  annulus(faces, 0, 0, inner, outer, 0, half, half);
  if (reliefs.size >= MOST_RELIEFS) reliefs.clear();
  reliefs.set(key, (found = { faces, light, ends, edge }));
  return found;
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
  const inner = numbers[at + 2] + inset, outer = numbers[at + 3] - inset, half = numbers[at + 5], whole = half >= Math.PI;
  const atInner = whole ? half : half - Math.asin(Math.min(inset / inner, 1));
  const atOuter = whole ? half : half - Math.asin(Math.min(inset / outer, 1));
  if (inner >= outer || Math.min(atInner, atOuter) <= 0) return false;
  context.beginPath();
  annulus(context, numbers[at], numbers[at + 1], inner, outer, numbers[at + 4], atInner, atOuter);
  return true;
}

/** Add an annular sector to a path. atInner, atOuter: its half angle at both radii. */
function annulus(path, x, y, inner, outer, angle, atInner, atOuter) {
  if (atOuter >= Math.PI) {
    path.arc(x, y, outer, 0, 2 * Math.PI);
    path.arc(x, y, inner, 2 * Math.PI, 0, true);
  } else {
    path.arc(x, y, outer, angle - atOuter, angle + atOuter);
    path.arc(x, y, inner, angle + atInner, angle - atInner, true);
  }
  path.closePath();
}

/** The number of sectors that a shade of some width is made of. */
function stepsOf(width) {
  return Math.min(Math.max(Math.ceil(width), 2), MOST_STEPS);
}

/** The opacity of the sector number k of so many, which together are as dark as `opacity` in equal steps. */
function added(opacity, k, steps) {
  return 1 - (1 - (opacity * (k + 1)) / steps) / (1 - (opacity * k) / steps);
}
