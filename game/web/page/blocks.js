// Projects what stands on the ground aslant, shades it, and paints it. game/drawing/camera.py has the equations of the projection.

import { colour } from "./colours.js";

const STEPS = 16; // from the dimmest shade of a side to the brightest
const CORNERS = 512; // of one prism at most
const pixels = { top: new Float64Array(2 * CORNERS), bottom: new Float64Array(2 * CORNERS) };
const ahead = new Uint8Array(CORNERS);

/** Paints PRISM and SHADOWS as a CAMERA sees them. */
export class Blocks {
  #shades = new Map();

  /** CAMERA. */
  look(numbers, at) {
    const [x, y, scale, azimuth, tilt, closeness, lightX, lightY, dimmest, brightest] = numbers.subarray(at, at + 10);
    const sine = Math.sin(tilt), cosine = Math.cos(tilt);
    if (dimmest !== this.dimmest || brightest !== this.brightest) this.#shades.clear();
    Object.assign(this, { x, y, scale, azimuth, closeness, lightX, lightY, dimmest, brightest, sine, cosine });
  }

  /** SLOT. */
  stand(angle) {
    this.turnX = Math.cos(angle - this.azimuth);
    this.turnY = Math.sin(angle - this.azimuth);
    this.towardsX = Math.cos(angle) * this.lightX + Math.sin(angle) * this.lightY;
    this.towardsY = Math.cos(angle) * this.lightY - Math.sin(angle) * this.lightX;
  }

  /** PRISM. at: of its bottom. */
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

  /** The sides that face the eye; neighbours of one shade are one polygon. The side k ends at the corner k. */
  #sides(context, numbers, at, count, shades) {
    const { top, bottom } = pixels;
    let first = 0, shade = -1;
    for (let k = 0; k < count; k++) {
      const before = k ? k - 1 : count - 1;
      const own = faces(before, k) ? this.#shade(numbers, at, before, k) : -1;
      if (own === shade) continue;
      if (shade >= 0) run(context, first, before, count, shades[shade]);
      if (own >= 0 && shade >= 0) { // the smooth edges of two polygons let through what is behind their seam
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

  /** SHADOWS, as subpaths of the context's path; where the numbers end. */
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

  /** What an outline passes over as it is moved: the sides that face that direction are at its end. Moved as before the turn. */
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

/** Neighbouring sides of one shade, from a corner to a later one. */
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
