// A student's functions that are right: the slides' pseudocode in Rust.
use std::f64::consts::{PI, TAU};

pub type Point = (f64, f64);

fn dot(a: Point, b: Point) -> f64 { a.0 * b.0 + a.1 * b.1 }
fn plus(a: Point, b: Point, scale: f64) -> Point { (a.0 + scale * b.0, a.1 + scale * b.1) }
fn length(a: Point) -> f64 { a.0.hypot(a.1) }
fn scaled(a: Point, scale: f64) -> Point { (a.0 * scale, a.1 * scale) }

pub fn normalize_angle(angle: f64) -> f64 { angle.rem_euclid(TAU) }
pub fn add_angles(a: f64, b: f64) -> f64 { normalize_angle(a + b) }
pub fn subtract_angles(a: f64, b: f64) -> f64 { normalize_angle(a - b) }
pub fn min_difference(a: f64, b: f64) -> f64 { let d = subtract_angles(a, b); d.min(TAU - d) }
pub fn on_left(a: f64, b: f64) -> bool { let d = subtract_angles(a, b); 0.0 < d && d < PI }
pub fn to_polar(p: Point) -> Point { (length(p), normalize_angle(p.1.atan2(p.0))) }
pub fn to_cartesian(radius: f64, angle: f64) -> Point { (radius * angle.cos(), radius * angle.sin()) }
pub fn closest_point_on_line(a: Point, b: Point, p: Point) -> Point {
    let ab = plus(b, a, -1.0);
    plus(a, ab, dot(plus(p, a, -1.0), ab) / dot(ab, ab))
}
pub fn broad_phase_outcome(p: Point, r: f64, r_g: f64, r_p: f64, w_p: f64, r_b: f64, w_b: f64) -> &'static str {
    let d = length(p);
    if d - r > r_g { return "game over"; }
    if d + r >= r_p - w_p && d - r <= r_p + w_p { return "paddles"; }
    if d + r >= r_b - w_b && d - r <= r_b + w_b { "bricks" } else { "no collision" }
}
pub fn broad_phase(p: Point, r: f64, theta: f64, positions: &[Point], w_p: f64, phi_p: f64) -> Option<Point> {
    let mut nearest = positions[0];
    for &other in positions {
        if min_difference(theta, other.1) < min_difference(theta, nearest.1) { nearest = other; }
    }
    if min_difference(theta, nearest.1) <= phi_p { return Some(narrow_phase_case_1(p, nearest.0)); }
    narrow_phase_case_2(p, r, theta, nearest.0, nearest.1, w_p, phi_p)
}
pub fn narrow_phase_case_1(p: Point, r_p: f64) -> Point {
    scaled(p, (if length(p) < r_p { -1.0 } else { 1.0 }) / length(p))
}
pub fn narrow_phase_case_2(p: Point, r: f64, theta: f64, r_p: f64, theta_p: f64, w_p: f64, phi_p: f64) -> Option<Point> {
    let end = theta_p + if on_left(theta, theta_p + phi_p) { phi_p } else { -phi_p };
    let q = closest_point_on_line(to_cartesian(r_p - w_p, end), to_cartesian(r_p + w_p, end), p);
    let d = length(plus(p, q, -1.0));
    if 0.0 < d && d < r { Some(scaled(plus(p, q, -1.0), 1.0 / d)) } else { None }
}
pub fn collision_response(v: Point, n: Point, v_p: Point, mu_p: f64, v_0: f64) -> Point {
    let dv = plus(v, v_p, -1.0);
    if dot(dv, n) >= 0.0 { return v; }
    let dv_n = scaled(n, dot(dv, n));
    let dv_t = plus(dv, dv_n, -1.0);
    let slip = length(dv_t);
    let mut v_res = plus(v, dv_n, -2.0);
    if slip > 0.0 { v_res = plus(v_res, dv_t, -mu_p * length(dv_n).min(slip) / slip); }
    scaled(v_res, v_0 / length(v_res))
}
