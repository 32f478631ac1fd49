// A student's functions that are right: the slides' pseudocode in C++.
#include <algorithm>

const double TAU = 2.0 * M_PI;

double normalize_angle(double angle) {
    const double rest = std::fmod(angle, TAU);
    return rest < 0.0 ? rest + TAU : rest;
}

double add_angles(double a, double b) { return normalize_angle(a + b); }

double subtract_angles(double a, double b) { return normalize_angle(a - b); }

double min_difference(double a, double b) {
    const double d = subtract_angles(a, b);
    return std::min(d, TAU - d);
}

bool on_left(double a, double b) {
    const double d = subtract_angles(a, b);
    return 0.0 < d && d < M_PI;
}

Polar to_polar(Point p) { return {std::abs(p), normalize_angle(std::arg(p))}; }

Point to_cartesian(double radius, double angle) { return {radius * std::cos(angle), radius * std::sin(angle)}; }

double dot(Point a, Point b) { return a.real() * b.real() + a.imag() * b.imag(); }

Point closest_point_on_line(Point a, Point b, Point p) { return a + (b - a) * (dot(p - a, b - a) / dot(b - a, b - a)); }

std::string broad_phase_outcome(Point p, double r, double r_g, double r_p, double w_p, double r_b, double w_b) {
    const double d = std::abs(p);
    if (d - r > r_g) return "game over";
    if (d + r >= r_p - w_p && d - r <= r_p + w_p) return "paddles";
    if (d + r >= r_b - w_b && d - r <= r_b + w_b) return "bricks";
    return "no collision";
}

Point narrow_phase_case_1(Point p, double r_p) {
    const Point n = p / std::abs(p);
    return std::abs(p) < r_p ? -n : n;
}

std::optional<Point> narrow_phase_case_2(
    Point p, double r, double theta, double r_p, double theta_p, double w_p, double phi_p) {
    const int sign = on_left(theta, theta_p + phi_p) ? 1 : -1;
    const Point a = to_cartesian(r_p - w_p, theta_p + sign * phi_p);
    const Point b = to_cartesian(r_p + w_p, theta_p + sign * phi_p);
    const Point q = closest_point_on_line(a, b, p);
    const double distance = std::abs(p - q);
    if (0.0 < distance && distance < r) return (p - q) / distance;
    return std::nullopt;
}

std::optional<Point> broad_phase(
    Point p, double r, double theta, const std::vector<Polar>& positions, double w_p, double phi_p) {
    Polar nearest = positions[0];
    for (const Polar& other : positions)
        if (min_difference(theta, other.second) < min_difference(theta, nearest.second)) nearest = other;
    if (min_difference(theta, nearest.second) <= phi_p) return narrow_phase_case_1(p, nearest.first);
    return narrow_phase_case_2(p, r, theta, nearest.first, nearest.second, w_p, phi_p);
}

Point collision_response(Point v, Point n, Point v_p, double mu_p, double v_0) {
    const Point dv = v - v_p;
    if (dot(dv, n) >= 0.0) return v;
    const Point dv_n = dot(dv, n) * n, dv_t = dv - dv_n;
    const double slip = std::abs(dv_t);
    Point v_res = v - 2.0 * dv_n;
    if (slip > 0.0) v_res -= mu_p * std::min(std::abs(dv_n), slip) * dv_t / slip;
    return v_0 * v_res / std::abs(v_res);
}
