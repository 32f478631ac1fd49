// Line protocol of `python -m tools.grade --command ./student`, for the functions in student.rs.
// Points are (f64, f64); no contact is None. Build: rustc -O -o student adapter.rs
// Delete the line of a function that you do not have.
mod student;
use std::io::{self, BufRead};
use student::*;

trait Json {
    fn json(&self) -> String;
}
impl Json for f64 {
    fn json(&self) -> String {
        if self.is_finite() { format!("{self:?}") } else { "\"not finite\"".into() }
    }
}
impl Json for bool {
    fn json(&self) -> String { self.to_string() }
}
impl Json for &str {
    fn json(&self) -> String { format!("\"{self}\"") }
}
impl Json for (f64, f64) {
    fn json(&self) -> String { format!("[{}, {}]", self.0.json(), self.1.json()) }
}
impl Json for Option<(f64, f64)> {
    fn json(&self) -> String { self.map_or("null".into(), |point| point.json()) }
}

fn answer(name: &str, a: &[f64]) -> Option<String> {
    let point = |i: usize| (a[i], a[i + 1]);
    Some(match name {
        "normalize_angle" => normalize_angle(a[0]).json(),
        "add_angles" => add_angles(a[0], a[1]).json(),
        "subtract_angles" => subtract_angles(a[0], a[1]).json(),
        "min_difference" => min_difference(a[0], a[1]).json(),
        "on_left" => on_left(a[0], a[1]).json(),
        "to_polar" => to_polar(point(0)).json(),
        "to_cartesian" => to_cartesian(a[0], a[1]).json(),
        "closest_point_on_line" => closest_point_on_line(point(0), point(2), point(4)).json(),
        "broad_phase_outcome" => broad_phase_outcome(point(0), a[2], a[3], a[4], a[5], a[6], a[7]).json(),
        "broad_phase" => {
            let positions: Vec<(f64, f64)> = a[6..].chunks(2).map(|pair| (pair[0], pair[1])).collect();
            broad_phase(point(0), a[2], a[3], &positions, a[4], a[5]).json()
        }
        "narrow_phase_case_1" => narrow_phase_case_1(point(0), a[2]).json(),
        "narrow_phase_case_2" => narrow_phase_case_2(point(0), a[2], a[3], a[4], a[5], a[6], a[7]).json(),
        "collision_response" => collision_response(point(0), point(2), point(4), a[6], a[7]).json(),
        _ => return None,
    })
}

fn main() {
    for line in io::stdin().lock().lines().map_while(Result::ok) {
        let name = line.split('"').nth(3).unwrap_or(""); // {"function": "to_polar", "arguments": [3.0, 4.0]}
        let numbers = line.split(['[', ']']).nth(1).unwrap_or("").split(", ").filter_map(|number| number.parse().ok());
        let result = answer(name, &numbers.collect::<Vec<f64>>());
        println!("{}", result.map_or("{\"undefined\": true}".into(), |json| format!("{{\"result\": {json}}}")));
    }
}
