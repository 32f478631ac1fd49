// A student's functions: the slides' pseudocode in Java, but the response.
class Student {
    static final double TAU = 2 * Math.PI;

    static double normalize_angle(double angle) { return (angle % TAU + TAU) % TAU; }

    static double add_angles(double a, double b) { return normalize_angle(a + b); }

    static double subtract_angles(double a, double b) { return normalize_angle(a - b); }

    static double min_difference(double a, double b) {
        double d = subtract_angles(a, b);
        return Math.min(d, TAU - d);
    }

    static boolean on_left(double a, double b) {
        double d = subtract_angles(a, b);
        return 0 < d && d < Math.PI;
    }

    static double[] to_polar(double[] p) {
        return new double[] {Math.hypot(p[0], p[1]), normalize_angle(Math.atan2(p[1], p[0]))};
    }

    static double[] to_cartesian(double radius, double angle) {
        return new double[] {radius * Math.cos(angle), radius * Math.sin(angle)};
    }

    static double[] closest_point_on_line(double[] a, double[] b, double[] p) {
        double x = b[0] - a[0], y = b[1] - a[1];
        double share = ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / (x * x + y * y);
        return new double[] {a[0] + share * x, a[1] + share * y};
    }

    static String broad_phase_outcome(double[] p, double r, double r_g, double r_p, double w_p, double r_b, double w_b) {
        double d = Math.hypot(p[0], p[1]);
        if (d - r > r_g) return "game over";
        if (d + r >= r_p - w_p && d - r <= r_p + w_p) return "paddles";
        return d + r >= r_b - w_b && d - r <= r_b + w_b ? "bricks" : "no collision";
    }

    static double[] broad_phase(double[] p, double r, double theta, double[][] positions, double w_p, double phi_p) {
        double[] nearest = positions[0];
        for (double[] other : positions)
            if (min_difference(theta, other[1]) < min_difference(theta, nearest[1])) nearest = other;
        if (min_difference(theta, nearest[1]) <= phi_p) return narrow_phase_case_1(p, nearest[0]);
        return narrow_phase_case_2(p, r, theta, nearest[0], nearest[1], w_p, phi_p);
    }

    static double[] narrow_phase_case_1(double[] p, double r_p) {
        double d = Math.hypot(p[0], p[1]), sign = d < r_p ? -1 : 1;
        return new double[] {sign * p[0] / d, sign * p[1] / d};
    }

    static double[] narrow_phase_case_2(
            double[] p, double r, double theta, double r_p, double theta_p, double w_p, double phi_p) {
        double end = theta_p + (on_left(theta, theta_p + phi_p) ? phi_p : -phi_p);
        double[] q = closest_point_on_line(to_cartesian(r_p - w_p, end), to_cartesian(r_p + w_p, end), p);
        double x = p[0] - q[0], y = p[1] - q[1], d = Math.hypot(x, y);
        return 0 < d && d < r ? new double[] {x / d, y / d} : null;
    }

    static double[] collision_response(double[] v, double[] n, double[] v_p, double mu_p, double v_0) {
        throw new UnsupportedOperationException("not written yet");
    }
}
