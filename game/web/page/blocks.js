// Projects, shades and paints the blocks of the 3D view. game/drawing/camera.py has the equations of the projection.

import { colour } from "./colours.js";

const STEPS = 16; // from the dimmest shade of a side to the brightest
const CORNERS = 512; // of one prism at most
const pixels = { top: new Float64Array(2 * CORNERS), bottom: new Float64Array(2 * CORNERS) };
const ahead = new Uint8Array(CORNERS);

/** Paints the primitives PRISM and SHADOWS, projected by a CAMERA. Coordinates are those of game/picture/display_list.py. */
export class Blocks {
  #shades = new Map();

  /** Take the projection and the light of the primitive CAMERA. at: index of its first number, here and below. */
  look(numbers, at) {
    const [x, y, scale, azimuth, tilt, closeness, lightX, lightY, dimmest, brightest] = numbers.subarray(at, at + 10);
    const sine = Math.sin(tilt), cosine = Math.cos(tilt);
    if (dimmest !== this.dimmest || brightest !== this.brightest) this.#shades.clear();
    Object.assign(this, { x, y, scale, azimuth, closeness, lightX, lightY, dimmest, brightest, sine, cosine });
  }

  /** Take the rotation of the prisms that follow, as the primitive SLOT gives it. */
  stand(angle) {
    this.turnX = Math.cos(angle - this.azimuth);
    this.turnY = Math.sin(angle - this.azimuth);
    this.towardsX = Math.cos(angle) * this.lightX + Math.sin(angle) * this.lightY;
    this.towardsY = Math.cos(angle) * this.lightY - Math.sin(angle) * this.lightX;
  }

  /** Paint a prism: its visible sides, then its top. packed: its colour as one number. */
  prism(context, numbers, at, packed) {
    const bottom = numbers[at], top = numbers[at + 1], count = numbers[at + 2], { top: tops, bottom: bottoms } = pixels;
    this.#project(numbers, at + 3, count, top, tops);
    if (top > bottom) {
      this.#project(numbers, at + 3, count, bottom, bottoms);
      this.#sides(context, numbers, at + 3, count, this.#shadesOf(packed));
    }
    context.fillStyle = colour(packed);
    context.beginPath();
    context.moveTo(tops[0], tops[1]);
    for (let k = 1; k < count; k++) context.lineTo(tops[2 * k], tops[2 * k + 1]);
    context.fill();
  }

  #project(numbers, at, count, height, found) {
    const { x, y, scale, closeness, sine, cosine, turnX, turnY } = this;
    const near = 1 - closeness * height * cosine, up = height * sine;
    for (let k = 0; k < count; k++) {
      const right = numbers[at + 2 * k] * turnX - numbers[at + 2 * k + 1] * turnY;
      const away = numbers[at + 2 * k] * turnY + numbers[at + 2 * k + 1] * turnX;
      const size = scale / (near + closeness * away * sine);
      found[2 * k] = x + right * size;
      found[2 * k + 1] = y - (away * cosine + up) * size;
    }
  }

  /** Begin the path of a polygon of the ground. at: index of its first corner. */
  polygon(context, numbers, at, count) {
    const { top } = pixels;
    this.stand(0);
    this.#project(numbers, at, count, 0, top);
    context.beginPath();
    for (let k = 0; k < count; k++) context.lineTo(top[2 * k], top[2 * k + 1]);
  }

  /** Paint the sides that face the eye. Neighbours of the same shade become one polygon. Side k ends at corner k. */
  #sides(context, numbers, at, count, shades) {
    const { top, bottom } = pixels;
    let first = 0, shade = -1;
    for (let k = 0; k < count; k++) {
      const before = k ? k - 1 : count - 1;
      const own = faces(before, k) ? this.#shade(numbers, at, before, k) : -1;
      if (own === shade) continue;
      if (shade >= 0) run(context, first, before, count, shades[shade]);
      if (own >= 0 && shade >= 0) { // a line over the seam: between two antialiased edges the background shows
        context.strokeStyle = shades[own];
        context.lineWidth = 1;
        context.lineCap = "round";
        context.setLineDash([]);
        context.beginPath();
        context.moveTo(top[2 * before], top[2 * before + 1]);
        context.lineTo(bottom[2 * before], bottom[2 * before + 1]);
        context.stroke();
      }
      [first, shade] = [before, own];
    }
    if (shade >= 0) run(context, first, count - 1, count, shades[shade]);
  }

  /** The shade of a side, by the angle between its normal and the light. */
  #shade(numbers, at, before, k) {
    const alongX = numbers[at + 2 * k] - numbers[at + 2 * before], alongY = numbers[at + 2 * k + 1] - numbers[at + 2 * before + 1];
    const towards = (alongX * this.towardsY - alongY * this.towardsX) / Math.max(Math.hypot(alongX, alongY), 1e-12);
    return Math.round((0.5 + 0.5 * towards) * STEPS);
  }

  #shadesOf(packed) {
    let shades = this.#shades.get(packed);
    if (!shades) {
      const { dimmest, brightest } = this;
      shades = Array.from({ length: STEPS + 1 }, (_, k) => dimmed(packed, dimmest + ((brightest - dimmest) * k) / STEPS));
      this.#shades.set(packed, shades);
    }
    return shades;
  }

  /** Add shadows to the context's path, each as a subpath. Returns the index after the last number. */
  shadows(context, numbers, at) {
    const x = numbers[at], y = numbers[at + 1], count = numbers[at + 2], slots = numbers[at + 3];
    const outline = at + 4, angles = outline + 2 * count, end = angles + 2 * slots;
    for (let slot = angles; slot < end; slot += 2) {
      const angle = numbers[slot], height = numbers[slot + 1], cosine = Math.cos(angle), sine = Math.sin(angle);
      this.stand(angle);
      this.#swept(context, numbers, outline, count, (x * cosine + y * sine) * height, (y * cosine - x * sine) * height);
    }
    return end;
  }

  /**
   * Add the area that an outline sweeps when it is moved: the sides that face the movement are at its end, the others at its start.
   * movedX, movedY: in the coordinates of the outline, before its rotation.
   */
  #swept(context, numbers, at, count, movedX, movedY) {
    for (let k = 0; k < count; k++) {
      const before = k ? k - 1 : count - 1;
      const alongX = numbers[at + 2 * k] - numbers[at + 2 * before], alongY = numbers[at + 2 * k + 1] - numbers[at + 2 * before + 1];
      ahead[k] = alongX * movedY - alongY * movedX > 0;
    }
    let begun = false;
    const corner = (k, share) => {
      const x = numbers[at + 2 * k] + share * movedX, y = numbers[at + 2 * k + 1] + share * movedY;
      const right = x * this.turnX - y * this.turnY, away = x * this.turnY + y * this.turnX;
      const size = this.scale / (1 + this.closeness * away * this.sine);
      if (begun) context.lineTo(this.x + right * size, this.y - away * this.cosine * size);
      else context.moveTo(this.x + right * size, this.y - away * this.cosine * size);
      begun = true;
    };
    for (let k = 0; k < count; k++) {
      const next = ahead[k + 1 < count ? k + 1 : 0];
      corner(k, ahead[k]);
      if (next !== ahead[k]) corner(k, next);
    }
    context.closePath();
  }
}

function faces(before, k) {
  const { top, bottom } = pixels;
  const alongX = top[2 * k] - top[2 * before], alongY = top[2 * k + 1] - top[2 * before + 1];
  const downX = bottom[2 * before] - top[2 * before], downY = bottom[2 * before + 1] - top[2 * before + 1];
  return alongX * downY < alongY * downX;
}

/** Paint neighbouring sides of one shade, from corner `first` to corner `last`. */
function run(context, first, last, count, own) {
  const { top, bottom } = pixels, end = last < first ? last + count : last;
  context.fillStyle = own;
  context.beginPath();
  context.moveTo(top[2 * first], top[2 * first + 1]);
  for (let k = first + 1; k <= end; k++) context.lineTo(top[2 * (k % count)], top[2 * (k % count) + 1]);
  for (let k = end; k >= first; k--) context.lineTo(bottom[2 * (k % count)], bottom[2 * (k % count) + 1]);
  context.fill();
}

function dimmed(packed, share) {
  const [red, green, blue] = [packed >> 16, (packed >> 8) & 255, packed & 255].map((part) => Math.round(part * share));
  return colour((red << 16) | (green << 8) | blue);
}
