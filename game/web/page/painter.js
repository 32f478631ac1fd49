// Paints flat lists of primitives on a canvas. game/picture/primitives.py documents every primitive.

import { Blocks } from "./blocks.js";
import { colour } from "./colours.js";
import * as ground from "./ground.js";
import { bar, cast, foot, relief, sector } from "./slots.js";

const DISC = 1, CIRCLE = 2, SECTOR = 3, POLYGON = 4, LINE = 5, TEXT = 6, GLOW = 7, FILL = 8, CELLS = 9, CLIP = 10, TURN = 11,
  STRIP = 12, BAND = 13, PLATE = 14, SPRITE = 15, CAMERA = 16, SLOT = 17, PRISM = 18, SHADOWS = 19, BOX = 20, TEXTURE = 21, TEXTURED = 22,
  FOOT = 23, RELIEF = 24, CAST = 25, BAR = 26, GROUND_DISC = 27, GROUND_CIRCLE = 28, GROUND_SIDE = 29, GROUND_MARK = 30;
const FONT = "system-ui, sans-serif", DESKTOP_FONT = `Arial, Helvetica, "Liberation Sans", ${FONT}`;
const DESKTOP_EM = 0.71; // of the desktop's letters, in shares of their size
const BEND = 0.02, OVERLAP = 0.6;
// Of a light: shares of its radius, and how much of it is left there, as a colour's alpha.
const LIGHT = [[0, "ff"], [0.2, "d7"], [0.4, "80"], [0.6, "33"], [0.8, "0c"], [1, "00"]];
const blocks = new Blocks();
const textures = new Map();

// Kinds of runs of letters by their sign: font, size, and offset below the middle of the text.
const INDEX = "\x13", WORD_INDEX = "\x14", PRIME = "\x15";
const RUNS = {
  "\x10": ["normal", 1, 0],
  "\x11": ["italic", 1, 0],
  "\x12": ["bold", 1, 0],
  [INDEX]: ["italic", 0.72, 0.32],
  [WORD_INDEX]: ["normal", 0.72, 0.32],
  [PRIME]: ["normal", 0.8, -0.2],
};

function font(size, bold) {
  return bold ? `700 ${size * DESKTOP_EM}px ${DESKTOP_FONT}` : `${size}px ${FONT}`;
}

/** Paint a list. numbers: a Float32Array; texts: those that it refers to. */
export function paint(context, numbers, texts) {
  shapes(context, numbers, texts);
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.globalAlpha = 1;
}

function shapes(context, numbers, texts) {
  let at = 0;
  let turned = false, clipped = false, code = 0;
  while (at < numbers.length) {
    const before = code, style = numbers[at + 1];
    code = numbers[at];
    context.globalAlpha = numbers[at + 2];
    at += 3;
    switch (code) {
      case DISC:
        context.fillStyle = colour(style);
        context.beginPath();
        context.arc(numbers[at], numbers[at + 1], numbers[at + 2], 0, 2 * Math.PI);
        context.fill();
        at += 3;
        break;
      case CIRCLE:
        context.strokeStyle = colour(style);
        context.lineWidth = numbers[at + 3];
        context.setLineDash([]);
        context.beginPath();
        context.arc(numbers[at], numbers[at + 1], numbers[at + 2], 0, 2 * Math.PI);
        context.stroke();
        at += 4;
        break;
      case SECTOR:
        context.fillStyle = colour(style);
        sector(context, numbers, at);
        at += 7;
        break;
      case POLYGON: {
        const count = numbers[at];
        context.fillStyle = colour(style);
        path(context, numbers, at + 1, count);
        context.fill();
        at += 1 + 2 * count;
        break;
      }
      case LINE: {
        const count = numbers[at + 2], dash = numbers[at + 1];
        context.strokeStyle = colour(style);
        context.lineWidth = numbers[at];
        context.lineCap = dash ? "butt" : "round";
        context.lineJoin = "round";
        context.setLineDash(dash ? [dash, dash] : []);
        path(context, numbers, at + 3, count);
        context.stroke();
        at += 3 + 2 * count;
        break;
      }
      case TEXT:
        text(context, numbers, at, style, texts[numbers[at]]);
        at += 7;
        break;
      case GLOW:
        glow(context, numbers, at, style);
        at += 5;
        break;
      case FILL:
        context.fillStyle = colour(style);
        context.fillRect(0, 0, context.canvas.width, context.canvas.height);
        break;
      case CELLS:
        at = cells(context, numbers, at);
        break;
      case CLIP:
        if (clipped) context.restore();
        clipped = numbers[at + 2] > 0;
        if (clipped) {
          context.save();
          context.beginPath();
          context.rect(numbers[at], numbers[at + 1], numbers[at + 2], numbers[at + 3]);
          context.clip();
        }
        at += 4;
        break;
      case TURN:
        if (turned) context.setTransform(1, 0, 0, 1, 0, 0);
        turned = numbers[at + 2] !== 0;
        if (turned) {
          context.translate(numbers[at], numbers[at + 1]);
          context.rotate(numbers[at + 2]);
          context.translate(-numbers[at], -numbers[at + 1]);
        }
        at += 3;
        break;
      case STRIP: {
        const count = numbers[at];
        context.fillStyle = colour(style);
        strip(context, numbers, at + 1, count);
        at += 1 + 4 * count;
        break;
      }
      case BAND: {
        const count = numbers[at];
        band(context, numbers, at + 1, count);
        at += 1 + 4 * count;
        break;
      }
      case PLATE:
        plate(context, numbers.subarray(at, at + 8), style, texts);
        at += 8;
        break;
      case SPRITE: {
        const count = numbers[at + 3];
        context.save();
        context.translate(numbers[at], numbers[at + 1]);
        shapes(context, numbers.subarray(at + 4, at + 4 + count), texts);
        context.restore();
        at += 4 + count;
        break;
      }
      case CAMERA:
        blocks.look(numbers, at);
        at += 12;
        break;
      case SLOT:
        blocks.stand(numbers[at], numbers[at + 1]);
        at += 2;
        code = before;
        break;
      case PRISM:
        blocks.prism(context, numbers, at, style);
        at += 5 + 2 * numbers[at + 4];
        break;
      case SHADOWS: // those of several rings are one path, so that overlaps are not darker
        context.fillStyle = colour(style);
        if (before !== SHADOWS) context.beginPath();
        at = blocks.shadows(context, numbers, at);
        if (numbers[numbers[at] === SLOT ? at + 5 : at] !== SHADOWS) context.fill();
        break;
      case BOX:
        box(context, numbers, at, style);
        at += 7;
        break;
      case TEXTURE: {
        const count = numbers[at + 2];
        textures.set(numbers[at], grid(numbers, at + 3, numbers[at + 1], count / numbers[at + 1]));
        at += 3 + count;
        break;
      }
      case TEXTURED:
        textured(context, numbers, at);
        at += 4;
        break;
      case FOOT:
        foot(context, numbers, at, numbers[at - 1]);
        at += 8;
        break;
      case RELIEF:
        relief(context, numbers, at, numbers[at - 1]);
        at += 10;
        break;
      case CAST:
        cast(context, numbers, at, numbers[at - 1]);
        at += 9;
        break;
      case BAR:
        context.fillStyle = colour(style);
        bar(context, numbers, at);
        at += 8;
        break;
      case GROUND_DISC:
        ground.disc(context, blocks, numbers, at);
        at += 3 + 3 * numbers[at + 2];
        break;
      case GROUND_CIRCLE:
        context.fillStyle = colour(style);
        ground.circle(context, blocks, numbers, at);
        at += 2;
        break;
      case GROUND_SIDE:
        context.fillStyle = colour(style);
        ground.side(context, blocks, numbers, at);
        at += 2;
        break;
      case GROUND_MARK:
        context.fillStyle = colour(style);
        blocks.polygon(context, numbers, at + 1, numbers[at]);
        context.fill();
        at += 1 + 2 * numbers[at];
        break;
      default:
        throw new Error(`primitive ${code} at ${at - 3}`);
    }
  }
  if (clipped) context.restore();
}

/** Draw a text of several runs, each with its sign before it: an index is lower than the letter before it, a prime higher. */
function runs(context, words, size, x, y, across) {
  const placed = [];
  let end = 0, primed = 0;
  for (const [, sign, letters] of words.matchAll(/([\x10-\x15])([^\x10-\x15]*)/g)) {
    const [look, height, down] = RUNS[sign], begin = sign === INDEX || sign === WORD_INDEX ? end - primed : end;
    context.font = `${look} ${size * height}px ${FONT}`;
    const { width } = context.measureText(letters);
    placed.push([context.font, letters, begin, size * down]);
    end = Math.max(end, begin + width);
    primed = sign === PRIME ? width : 0;
  }
  context.textAlign = "left";
  for (const [own, letters, begin, down] of placed) {
    context.font = own;
    context.fillText(letters, x + begin - across * end, y + down);
  }
}

function text(context, numbers, at, style, words) {
  const across = numbers[at + 4], bold = numbers[at + 5], room = numbers[at + 6];
  context.fillStyle = colour(style);
  if (words[0] in RUNS) {
    context.textBaseline = "middle";
    runs(context, words, numbers[at + 1], numbers[at + 2], numbers[at + 3], across);
    return;
  }
  context.font = font(numbers[at + 1], bold);
  context.textBaseline = "middle";
  context.textAlign = across === 0 ? "left" : across === 1 ? "right" : "center";
  if (room) {
    const { width } = context.measureText(words);
    if (width > room) context.font = font((numbers[at + 1] * room) / width, bold);
  }
  context.fillText(words, numbers[at + 2], numbers[at + 3]);
}

function path(context, numbers, at, count) {
  context.beginPath();
  context.moveTo(numbers[at], numbers[at + 1]);
  for (let k = 1; k < count; k++) context.lineTo(numbers[at + 2 * k], numbers[at + 2 * k + 1]);
}

function strip(context, numbers, at, count) {
  context.beginPath();
  context.moveTo(numbers[at], numbers[at + 1]);
  for (let k = 1; k < count; k++) context.lineTo(numbers[at + 4 * k], numbers[at + 4 * k + 1]);
  for (let k = count - 1; k >= 0; k--) context.lineTo(numbers[at + 4 * k + 2], numbers[at + 4 * k + 3]);
  context.fill();
}

// Every piece begins a little earlier: the smooth edges of two polygons let through what is behind their seam.
function band(context, numbers, at, count) {
  let before = 0;
  for (let k = 1; k < count; k++) {
    const [x, y, from, , endX, endY, to, style] = numbers.subarray(at + 4 * k - 4, at + 4 * k + 4);
    const length = Math.hypot(endX - x, endY - y);
    if (length === 0) continue;
    const right = (endX - x) / length, down = (endY - y) / length, heading = Math.atan2(down, right);
    const startX = x - right * OVERLAP, startY = y - down * OVERLAP;
    context.fillStyle = colour(style);
    if (Math.abs(Math.sin(heading - before)) > BEND) {
      context.beginPath();
      context.arc(x, y, from, 0, 2 * Math.PI);
      context.fill();
    }
    context.beginPath();
    context.moveTo(startX - down * from, startY + right * from);
    context.lineTo(endX - down * to, endY + right * to);
    context.lineTo(endX + down * to, endY - right * to);
    context.lineTo(startX + down * from, startY - right * from);
    context.fill();
    before = heading;
  }
}

function plate(context, [index, size, x, y, across, down, edge, edgeStyle], style, texts) {
  context.font = font(size, 1);
  const width = context.measureText(texts[index]).width + 2 * across, height = size + 2 * down;
  context.fillStyle = colour(style);
  context.strokeStyle = colour(edgeStyle);
  context.lineWidth = edge;
  context.setLineDash([]);
  context.beginPath();
  context.roundRect(x - width / 2, y - height / 2, width, height, height / 2);
  context.fill();
  context.stroke();
}

function box(context, numbers, at, style) {
  const [x, y, width, height, radius, edge, edgeStyle] = numbers.subarray(at, at + 7);
  for (const [inset, own] of edge ? [[0, edgeStyle], [edge, style]] : [[0, style]]) {
    context.fillStyle = colour(own);
    context.beginPath();
    context.roundRect(x + inset, y + inset, width - 2 * inset, height - 2 * inset, Math.max(radius - inset, 0));
    context.fill();
  }
}

function glow(context, numbers, at, style) {
  const x = numbers[at], y = numbers[at + 1], across = numbers[at + 2], down = numbers[at + 3], multiplies = numbers[at + 4];
  if (across < 0.5 || down < 0.5) return;
  const before = context.getTransform();
  context.globalCompositeOperation = multiplies ? "multiply" : "lighter";
  context.translate(x, y);
  context.scale(1, down / across);
  const gradient = context.createRadialGradient(0, 0, 0, 0, 0, across), own = colour(style);
  for (const [share, strength] of LIGHT) gradient.addColorStop(share, own + strength);
  context.fillStyle = gradient;
  context.beginPath();
  context.arc(0, 0, across, 0, 2 * Math.PI);
  context.fill();
  context.globalCompositeOperation = "source-over";
  context.setTransform(before);
}

/** A canvas with one pixel for every cell. at: index of the first colour. */
function grid(numbers, at, columns, rows) {
  const small = new OffscreenCanvas(columns, rows), own = small.getContext("2d");
  const image = own.createImageData(columns, rows);
  for (let k = 0; k < columns * rows; k++) {
    const packed = numbers[at + k];
    image.data.set([packed >> 16, (packed >> 8) & 255, packed & 255, 255], 4 * k);
  }
  own.putImageData(image, 0, 0);
  return small;
}

function cells(context, numbers, at) {
  const [x, y, width, height, columns, rows] = numbers.subarray(at, at + 6);
  context.imageSmoothingEnabled = true;
  context.drawImage(grid(numbers, at + 6, columns, rows), x, y, width, height);
  return at + 6 + columns * rows;
}

function textured(context, numbers, at) {
  const x = numbers[at], y = numbers[at + 1], radius = numbers[at + 2], picture = textures.get(numbers[at + 3]);
  const pattern = context.createPattern(picture, "no-repeat"), size = (2 * radius) / picture.width;
  pattern.setTransform(new DOMMatrix([size, 0, 0, size, x - radius, y - radius]));
  context.imageSmoothingEnabled = true;
  context.fillStyle = pattern;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
}
