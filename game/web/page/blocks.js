// Projects, shades and paints the blocks of the 3D view. game/drawing/camera.py has the equations of the projection.

import { colour } from "./colours.js";

const CORNERS = 512; // of one prism at most
const UNDER_TOP = 0.7; // pixels that a side goes on below the top: between two antialiased edges the background shows
const pixels = { top: new Float64Array(2 * CORNERS), bottom: new Float64Array(2 * CORNERS) };
const ahead = new Uint8Array(CORNERS);

/** Paints the primitives PRISM and SHADOWS, projected by a CAMERA. Coordinates are those of game/picture/primitives.py. */
export class Blocks {
  /** Take the projection and the light of the primitive CAMERA. at: index of its first number, here and below. */
  look(numbers, at) {
    const [x, y, scale, azimuth, tilt, closeness, lightX, lightY, dimmest, brightest, shadowX, shadowY] = numbers.subarray(at, at + 12);
    const sine = Math.sin(tilt), cosine = Math.cos(tilt);
    Object.assign(this, { x, y, scale, azimuth, closeness, lightX, lightY, dimmest, brightest, shadowX, shadowY, sine, cosine });
  }

  /** Take the rotation of what follows and how far out it is, as the primitive SLOT gives them. */
  stand(angle, out) {
    const right = Math.cos(angle), up = Math.sin(angle);
    this.angle = angle;
    this.out = out;
    this.turnX = Math.cos(angle - this.azimuth);
    this.turnY = Math.sin(angle - this.azimuth);
    this.towardsX = right * this.lightX + up * this.lightY;
    this.towardsY = right * this.lightY - up * this.lightX;
    this.movedX = right * this.shadowX + up * this.shadowY;
    this.movedY = right * this.shadowY - up * this.shadowX;
  }

  /** Paint a prism: its visible sides, then its top. packed: its colour as one number. */
  prism(context, numbers, at, packed) {
    const bottom = numbers[at], top = numbers[at + 1], ends = numbers[at + 2], even = numbers[at + 3], count = numbers[at + 4];
    const { top: tops, bottom: bottoms } = pixels;
    this.#project(numbers, at + 5, count, top, tops);
    if (top > bottom) {
      this.#project(numbers, at + 5, count, bottom, bottoms);
      this.#sides(context, numbers, at + 5, count, ends, even, packed);
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
      const grown = this.#grown(numbers, at + 2 * k);
      const along = numbers[at + 2 * k] * grown, across = numbers[at + 2 * k + 1] * grown;
      const right = along * turnX - across * turnY, away = along * turnY + across * turnX;
      const size = scale / (near + closeness * away * sine);
      found[2 * k] = x + right * size;
      found[2 * k + 1] = y - (away * cosine + up) * size;
    }
  }

  /** Begin the path of a polygon of the ground. at: index of its first corner. */
  polygon(context, numbers, at, count) {
    const { top } = pixels;
    this.stand(0, 0);
    this.#project(numbers, at, count, 0, top);
    context.beginPath();
    for (let k = 0; k < count; k++) context.lineTo(top[2 * k], top[2 * k + 1]);
  }

  /** By how much the distance of a point from the arena's centre is multiplied, so that the point is farther out. */
  #grown(numbers, at) {
    return this.out ? 1 + this.out / Math.hypot(numbers[at], numbers[at + 1]) : 1;
  }

  /** Paint the sides that face the eye. Neighbours of the same shade become one polygon. Side k ends at corner k. */
  #sides(context, numbers, at, count, ends, even, packed) {
    const half = count / 2;
    let first = 0, shade = -1, begun = -1;
    for (let k = 0; k < count; k++) {
      const before = k ? k - 1 : count - 1, onArc = k % half;
      let own = -1;
      if ((onArc || ends & (k ? 2 : 1)) && faces(before, k)) {
        own = this.#shade(packed, onArc && even ? this.towardsX * (k < half ? -1 : 1) : this.#towards(numbers, at, before, k));
      }
      if (own === shade) continue;
      if (shade >= 0) run(context, first, before, count, shade);
      if (own >= 0 && shade >= 0) seam(context, before, own);
      [first, shade] = [before, own];
      if (!k) begun = own;
    }
    if (shade < 0) return;
    if (begun >= 0 && begun !== shade) seam(context, count - 1, shade);
    run(context, first, count - 1, count, shade);
  }

  /** The cosine of the angle between a side's normal and the light. */
  #towards(numbers, at, before, k) {
    const alongX = numbers[at + 2 * k] - numbers[at + 2 * before], alongY = numbers[at + 2 * k + 1] - numbers[at + 2 * before + 1];
    return (alongX * this.towardsY - alongY * this.towardsX) / Math.max(Math.hypot(alongX, alongY), 1e-12);
  }

  /** A colour as a side shows it. towards: the cosine of the angle between the side's normal and the light. */
  #shade(packed, towards) {
    const share = this.dimmest + (this.brightest - this.dimmest) * (0.5 + 0.5 * towards);
    const red = Math.round((packed >> 16) * share), green = Math.round(((packed >> 8) & 255) * share);
    return (red << 16) | (green << 8) | Math.round((packed & 255) * share);
  }

  /** Add shadows to the context's path, each as a subpath. Returns the index after the last number. */
  shadows(context, numbers, at) {
    const count = numbers[at], ends = numbers[at + 2], angles = at + 3 + 4 * count, end = angles + 3 * numbers[at + 1];
    const { angle, out } = this;
    for (let slot = angles; slot < end; slot += 3) {
      this.stand(angle + numbers[slot], out);
      this.#swept(context, numbers, at + 3, count, ends, numbers[slot + 1], numbers[slot + 2]);
    }
    this.stand(angle, out);
    return end;
  }

  /** Add a shadow: a closed line. The sides that face its movement are at its end, and are the second outline's. */
  #swept(context, numbers, at, count, ends, low, high) {
    const { movedX, movedY } = this, casting = at + 2 * count, half = count / 2;
    for (let k = 0; k < count; k++) {
      const before = k ? k - 1 : count - 1;
      const alongX = numbers[at + 2 * k] - numbers[at + 2 * before], alongY = numbers[at + 2 * k + 1] - numbers[at + 2 * before + 1];
      ahead[k] = (k % half || ends & (k ? 2 : 1)) && alongX * movedY - alongY * movedX > 0;
    }
    let begun = false;
    const corner = (own, height) => {
      const grown = this.#grown(numbers, own);
      const x = numbers[own] * grown + height * movedX, y = numbers[own + 1] * grown + height * movedY;
      const right = x * this.turnX - y * this.turnY, away = x * this.turnY + y * this.turnX;
      const size = this.scale / (1 + this.closeness * away * this.sine);
      if (begun) context.lineTo(this.x + right * size, this.y - away * this.cosine * size);
      else context.moveTo(this.x + right * size, this.y - away * this.cosine * size);
      begun = true;
    };
    for (let k = 0; k < count; k++) {
      const next = ahead[k + 1 < count ? k + 1 : 0];
      if (ahead[k]) corner(casting + 2 * k, high);
      else corner(at + 2 * k, low);
      if (next === ahead[k]) continue;
      corner(casting + 2 * k, low); // along the side's own line: where an end is joined, both outlines differ
      if (next) corner(casting + 2 * k, high);
      else corner(at + 2 * k, low);
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

/** Paint a line over the edge at a corner: between two antialiased sides the background shows. */
function seam(context, k, own) {
  const { top, bottom } = pixels;
  context.strokeStyle = colour(own);
  context.lineWidth = 1;
  context.lineCap = "round";
  context.setLineDash([]);
  context.beginPath();
  context.moveTo(top[2 * k], top[2 * k + 1]);
  context.lineTo(bottom[2 * k], bottom[2 * k + 1]);
  context.stroke();
}

/** Paint neighbouring sides of one shade, from corner `first` to corner `last`. */
function run(context, first, last, count, own) {
  const { top, bottom } = pixels, end = last < first ? last + count : last;
  context.fillStyle = colour(own);
  context.beginPath();
  for (let k = first; k <= end; k++) context.lineTo(top[2 * (k % count)], top[2 * (k % count) + 1] - UNDER_TOP);
  for (let k = end; k >= first; k--) context.lineTo(bottom[2 * (k % count)], bottom[2 * (k % count) + 1]);
  context.fill();
}
