"""Wrong student files: the right one with one line changed, as students get it wrong; and what a grade must call it."""

from typing import NamedTuple

from tests.support.paths import ROOT

RIGHT = ROOT / "tests" / "grade" / "right_functions.py"


class WrongFile(NamedTuple):
    """name: of the mistake. line: of the right file. wrong: what stands in its stead. functions: those that become wrong."""

    name: str
    line: str
    wrong: str
    functions: frozenset[str]

    def text(self):
        """The whole file."""
        right = RIGHT.read_text(encoding="utf-8")
        assert right.count(self.line) == 1, self.line
        return right.replace(self.line, self.wrong)


def _wrong(name, line, wrong, functions):
    return WrongFile(name, line, wrong, frozenset(functions.split()))


RESPONSE, CASE_2 = "collision_response", "narrow_phase_case_2"
WRONG_FILES = (
    _wrong("wrong sign at |p| < r_p", "return -n if abs(p) < r_p else n", "return n", "narrow_phase_case_1 broad_phase"),
    _wrong("no wrap", "    return min(d, TAU - d)", "    return abs(a - b)", "min_difference broad_phase"),
    _wrong("wrap in one direction only", "    return min(d, TAU - d)", "    return d", "min_difference broad_phase"),
    _wrong(
        "wrap in one direction only",
        "    return angle % TAU",
        "    return math.fmod(angle, TAU)",
        "normalize_angle subtract_angles min_difference on_left to_polar narrow_phase_case_2 broad_phase",
    ),
    _wrong(
        "degrees for radians",
        "    return complex(radius * math.cos(angle), radius * math.sin(angle))",
        "    return complex(radius * math.cos(math.radians(angle)), radius * math.sin(math.radians(angle)))",
        "to_cartesian narrow_phase_case_2 broad_phase",
    ),
    _wrong(
        "end by the wrong rule",
        "1 if on_left(theta, theta_p + phi_p) else -1",
        "1 if theta > theta_p + phi_p else -1",
        "narrow_phase_case_2 broad_phase",
    ),
    _wrong("friction unclamped", "min(abs(dv_n), abs(dv_t))", "abs(dv_t)", RESPONSE),
    _wrong("speed not reset", "    return v_0 * v_res / abs(v_res)", "    return v_res", RESPONSE),
    _wrong("responding while separating", "    if dot(dv, n) >= 0:\n        return v\n", "", RESPONSE),
    _wrong("v_p forgotten", "    dv = v - v_p", "    dv = v", RESPONSE),
    _wrong("distance not tested", "if 0 < abs(p - q) < r else None", "", "narrow_phase_case_2"),
    _wrong("range from -π to π", "normalize_angle(math.atan2(p.imag, p.real))", "math.atan2(p.imag, p.real)", "to_polar"),
    _wrong("half a bounce", "    change_n = -2 * dv_n", "    change_n = -dv_n", RESPONSE),
)
