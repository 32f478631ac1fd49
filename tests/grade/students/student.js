// A student's functions: angles, case 1 and the response, in JavaScript.
"use strict";
const TAU = 2 * Math.PI;
const normalize_angle = (angle) => ((angle % TAU) + TAU) % TAU;
const dot = (a, b) => a[0] * b[0] + a[1] * b[1];
const plus = (a, b, scale = 1) => [a[0] + scale * b[0], a[1] + scale * b[1]];
const scaled = (a, scale) => [a[0] * scale, a[1] * scale];

exports.normalize_angle = normalize_angle;
exports.add_angles = (a, b) => normalize_angle(a + b);
exports.subtract_angles = (a, b) => normalize_angle(a - b);
exports.min_difference = (a, b) => Math.min(normalize_angle(a - b), TAU - normalize_angle(a - b));
exports.on_left = (a, b) => normalize_angle(a - b) > 0 && normalize_angle(a - b) < Math.PI;
exports.to_polar = (p) => [Math.hypot(...p), normalize_angle(Math.atan2(p[1], p[0]))];
exports.to_cartesian = (radius, angle) => [radius * Math.cos(angle), radius * Math.sin(angle)];
exports.narrow_phase_case_1 = (p, r_p) => {
  console.log("p is", p);
  return scaled(p, (Math.hypot(...p) < r_p ? -1 : 1) / Math.hypot(...p));
};
exports.collision_response = (v, n, v_p, mu_p, v_0) => {
  const dv = plus(v, v_p, -1);
  if (dot(dv, n) >= 0) return v;
  const dv_n = scaled(n, dot(dv, n));
  const dv_t = plus(dv, dv_n, -1);
  const slip = Math.hypot(...dv_t);
  let v_res = plus(v, dv_n, -2);
  if (slip > 0) v_res = plus(v_res, dv_t, (-mu_p * Math.min(Math.hypot(...dv_n), slip)) / slip);
  return scaled(v_res, v_0 / Math.hypot(...v_res));
};
