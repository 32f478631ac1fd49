// Line protocol of `python -m tools.grade --command "node adapter.js"`, for the functions that student.js exports.
// Points are arrays [x, y]; no contact is null. What student.js does not export is not graded.
"use strict";
const readline = require("node:readline");
console.log = console.error; // what the student's code prints is no answer
const student = require("./student.js");

const point = (a, i) => [a[i], a[i + 1]];
const pairs = (a, from) => Array.from({ length: (a.length - from) / 2 }, (_, k) => point(a, from + 2 * k));

// How the flat list of numbers becomes the arguments of each function; where it is not here, every number is one.
const shapes = {
  to_polar: (a) => [point(a, 0)],
  closest_point_on_line: (a) => [point(a, 0), point(a, 2), point(a, 4)],
  broad_phase_outcome: (a) => [point(a, 0), ...a.slice(2)],
  broad_phase: (a) => [point(a, 0), a[2], a[3], pairs(a, 6), a[4], a[5]],
  narrow_phase_case_1: (a) => [point(a, 0), a[2]],
  narrow_phase_case_2: (a) => [point(a, 0), ...a.slice(2)],
  collision_response: (a) => [point(a, 0), point(a, 2), point(a, 4), a[6], a[7]],
};

function answer(name, numbers) {
  if (typeof student[name] !== "function") return { undefined: true };
  try {
    const result = student[name](...(shapes[name] ?? ((a) => a))(numbers));
    return { result: result ?? null };
  } catch (error) {
    return { error: String(error) };
  }
}

readline.createInterface({ input: process.stdin }).on("line", (line) => {
  const { function: name, arguments: numbers } = JSON.parse(line);
  process.stdout.write(JSON.stringify(answer(name, numbers)) + "\n");
});
