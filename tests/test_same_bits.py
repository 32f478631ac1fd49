"""The simulation uses nothing that may give other bits on another machine. Every rule is shown to catch what breaks it."""

from functools import cache

import pytest

from tests.support.paths import ROOT
from tests.support.source_code.kinds import Names
from tests.support.source_code.same_bits import findings

RULES_OF_THE_GAME = ("rules", "autopilot")


def simulation():
    """The modules in which the state evolves: the physics, but for its batch, which is compared with it, and the rules."""
    physics = [path for path in sorted((ROOT / "physics").rglob("*.py")) if "batch" not in path.parts]
    game = [
        path for name in RULES_OF_THE_GAME for path in [ROOT / "game" / f"{name}.py", *(ROOT / "game" / name).rglob("*.py")]
    ]
    return physics + [path for path in game if path.exists()]


@cache
def names_of_the_simulation():
    """What its annotations say, and those of the levels' fields."""
    return Names([path.read_text(encoding="utf-8") for path in [*simulation(), *(ROOT / "game" / "level_format").glob("*.py")]])


def test_the_simulation_is_found():
    """A renamed file must not slip out of the rule."""
    names = {path.relative_to(ROOT).as_posix() for path in simulation()}
    assert {
        "physics/trig.py",
        "physics/step.py",
        "physics/time_of_impact.py",
        "game/rules/turn.py",
        "game/autopilot/source_pilot.py",
    } <= names


@pytest.mark.parametrize("path", simulation(), ids=lambda path: path.relative_to(ROOT).as_posix())
def test_no_module_of_the_simulation_depends_on_the_machine(path):
    """A finding is named with its line."""
    assert findings(path.read_text(encoding="utf-8"), names_of_the_simulation()) == []


SHAPES = """
from typing import NamedTuple

class Ball(NamedTuple):
    position: complex
    velocity: complex
    radius: float

class Arena(NamedTuple):
    balls: tuple[Ball, ...]
    layers: tuple[tuple[int, ...], ...]

def direction(angle: float) -> complex: ...
def length(a: complex) -> float: ...
"""

WRONG = {
    "sine": ("import math\nx = math.sin(1.0)", "math.sin"),
    "sine under another name": ("import math as m\nf = m.sin", "math.sin"),
    "cosine imported": ("from math import cos", "math.cos"),
    "arc tangent": ("import math\nmath.atan2(1.0, 2.0)", "math.atan2"),
    "arc cosine": ("import math\nmath.acos(0.5)", "math.acos"),
    "tangent": ("import math\nmath.tan(0.5)", "math.tan"),
    "hypotenuse": ("import math\nmath.hypot(3.0, 4.0)", "math.hypot"),
    "distance": ("import math\nmath.dist((3.0,), (4.0,))", "math.dist"),
    "exponential": ("import math\nmath.exp(1.0)", "math.exp"),
    "power of math": ("import math\nmath.pow(2.0, 0.5)", "math.pow"),
    "logarithm in a function": ("import math\ndef f(x: float) -> float:\n    return math.log(x)", "math.log"),
    "power": ("def f(x: float) -> float:\n    return x ** 0.5", "**"),
    "square": ("def f(x: float) -> float:\n    return x ** 2", "**"),
    "power in place": ("def f(x: float) -> float:\n    x **= 2\n    return x", "**"),
    "power called": ("x = pow(2.0, 0.5)", "pow()"),
    "cmath": ("import cmath", "import cmath"),
    "cmath imported from": ("from cmath import phase", "import cmath"),
    "numpy": ("import numpy.linalg", "import numpy.linalg"),
    "a clock": ("import time", "import time"),
    "the date": ("from datetime import datetime", "import datetime"),
    "the system's chance": ("import secrets", "import secrets"),
    "abs of an argument": ("def f(p: complex) -> float:\n    return abs(p)", "abs() of complex"),
    "abs of a difference": ("def f(p: complex, q: complex) -> float:\n    return abs(p - q)", "abs() of complex"),
    "abs of a field": ("def f(ball: Ball) -> float:\n    return abs(ball.position)", "abs() of complex"),
    "abs of a result": ("def f() -> float:\n    return abs(direction(1.0))", "abs() of complex"),
    "abs of what was unpacked": ("def f(ball: Ball) -> float:\n    p, v, r = ball\n    return abs(v)", "abs() of complex"),
    "abs in a loop": ("def f(arena: Arena) -> None:\n    for p, _, _ in arena.balls:\n        abs(p)", "abs() of complex"),
    "abs of an item": ("def f(arena: Arena) -> float:\n    return abs(arena.balls[0][1])", "abs() of complex"),
    "abs of an optional": ("def f(p: complex | None) -> float:\n    return abs(p)", "abs() of complex"),
    "abs of a choice": ("def f(x: float, p: complex) -> float:\n    return abs(p if x else x)", "abs() of complex"),
    "abs of the unknown": ("def f(x):\n    return abs(x)", "abs() of what may be complex"),
    "abs in a method": ("class A(Ball):\n    def f(self) -> float:\n        return abs(self.position)", "abs() of complex"),
    "abs of an assigned": ("def f() -> float:\n    n = direction(0.1)\n    m = -n\n    return abs(m)", "abs() of complex"),
    "product": ("def f(p: complex, q: complex) -> complex:\n    return p * q", "two complex"),
    "product with a literal": ("def f(p: complex) -> complex:\n    return p * 1j", "two complex"),
    "product with a sum": ("def f(p: complex, x: float) -> complex:\n    return (x + p) * p", "two complex"),
    "product of fields": ("def f(b: Ball) -> complex:\n    return b.position.conjugate() * b.velocity", "two complex"),
    "product in place": ("def f(p: complex) -> complex:\n    p *= 1j\n    return p", "two complex"),
    "product in a comprehension": ("def f(ps: list[complex]) -> list[complex]:\n    return [p * p for p in ps]", "two complex"),
    "quotient": ("def f(p: complex, q: complex) -> complex:\n    return p / q", "two complex"),
    "quotient by a complex": ("def f(p: complex) -> complex:\n    return 1.0 / p", "two complex"),
    "product of the unknown": ("def f(x, p: complex) -> complex:\n    return x * p", "* or / of what may be complex"),
    "sum": ("def f(xs: list[float]) -> float:\n    return sum(xs)", "sum() of float"),
    "sum of lengths": ("def f(a: Arena) -> float:\n    return sum(length(b.velocity) for b in a.balls)", "sum() of float"),
    "sum of fields": ("def f(arena: Arena) -> float:\n    return sum([ball.radius for ball in arena.balls])", "sum() of float"),
    "sum of vectors": ("def f(ps: list[complex]) -> complex:\n    return sum(ps)", "sum() of complex"),
    "sum of the unknown": ("def f(xs):\n    return sum(xs)", "sum() of what may be floats"),
    "module of chance": ("import random\nx = random.random()", "random.random"),
    "chance imported": ("from random import uniform", "random.uniform"),
    "system chance": ("import random\nr = random.SystemRandom()", "random.SystemRandom"),
    "no seed": ("import random\nr = random.Random()", "Random() without a seed"),
    "choice": ("import random\nr = random.Random(1)\nr.choice([1, 2])", ".choice"),
    "shuffle": ("def f(rng: Random) -> None:\n    rng.shuffle([1, 2])", ".shuffle"),
    "uniform": ("def f(rng: Random) -> float:\n    return rng.uniform(0.0, 1.0)", ".uniform"),
    "loop over a set": ("for x in {1, 2}:\n    print(x)", "iteration over a set"),
    "loop over a name": ("def f(xs: set[int]) -> None:\n    for x in xs:\n        print(x)", "iteration over a set"),
    "loop over an assigned": (
        "def f() -> None:\n    xs = set([1, 2])\n    for x in xs:\n        print(x)",
        "iteration over a set",
    ),
    "list of a set": ("xs = list({1, 2})", "iteration over a set"),
    "comprehension of a set": ("xs = [x for x in {1, 2}]", "iteration over a set"),
    "unpacked set": ("xs = [*{1, 2}]", "iteration over a set"),
    "numbered set": ("for k, x in enumerate(frozenset([1])):\n    print(x)", "iteration over a set"),
    "dict from a set": ("xs = {x: 1 for x in {1, 2}}", "iteration over a set"),
    "pop of a set": ("xs = {1, 2}\nx = xs.pop()", "pop() of a set"),
    "hash": ("x = hash((1, 2))", "hash()"),
    "id": ("x = id(object())", "id()"),
}

RIGHT = {
    "exact functions": "import math\nx = math.sqrt(2.0) + math.floor(1.5) * math.pi / math.tau\nmath.fmod(x, 1.0)",
    "powers of literals": "x, y = 2.0**50, 2.0**-600",
    "scaling": "def f(p: complex, x: float) -> complex:\n    return p * x + x * p - p / x * 2",
    "abs of a float": "def f(p: complex) -> float:\n    return abs(p.real) + abs(length(p) - 1.0)",
    "products of floats": "def f(ball: Ball) -> float:\n    p, v, r = ball\n    return p.real * v.imag * r",
    "sum of comparisons": "def f(xs: list[float]) -> int:\n    return sum(x > 0.5 for x in xs)",
    "sum of a list of comparisons": "def f(xs: list[float]) -> int:\n    out = [x > 0.5 for x in xs]\n    return sum(out)",
    "sum of whole numbers": "def f(arena: Arena) -> int:\n    return sum([n for row in arena.layers for n in row if n > 0])",
    "sum of ones and lengths": "def f(xs: list[str]) -> int:\n    return sum(1 for x in xs) + sum(len(x) for x in xs)",
    "the exact sum": "import math\ndef f(xs: list[float]) -> float:\n    return math.fsum(xs)",
    "seeded chance": "import random\nr = random.Random(7)\nx = r.random() * 2.0",
    "seeded chance imported": "from random import Random\nr = Random(7)\nx = r.random()",
    "sets asked and sorted": "xs = {1, 2}\ny = 1 in xs\nfor x in sorted(xs):\n    print(x, len(xs), max(xs))",
    "sets in comprehensions that are sorted": "xs = sorted([x for x in {1, 2} if x])\nys = {x + 1 for x in {1, 2}}",
    "dictionaries": "for key, value in {1: 2}.items():\n    print(key, value)",
}


@pytest.mark.parametrize("name", WRONG)
def test_what_may_differ_is_found(name):
    """Each rule catches what breaks it, and nothing else in that text."""
    text, expected = WRONG[name]
    found = findings(text, Names([text, SHAPES]))
    assert found
    assert all(expected in finding.what for finding in found), found


@pytest.mark.parametrize("name", RIGHT)
def test_what_is_the_same_everywhere_is_left_alone(name):
    """IEEE 754 fixes + - * / and the root, and floor and fmod are exact."""
    assert findings(RIGHT[name], Names([RIGHT[name], SHAPES])) == []


def test_a_finding_knows_its_line():
    """For whoever has to mend it."""
    text = "import math\n\nx = math.sin(1.0)"
    (finding,) = findings(text, Names([text]))
    assert finding == (3, "math.sin")


@pytest.mark.parametrize(
    ("module", "good", "bad"),
    [
        ("physics/vectors.py", "return math.sqrt(a.real * a.real + a.imag * a.imag)", "return abs(a)"),
        ("physics/narrow_phase.py", "return a + ab * (along / square)", "return a + ab * (p - a)"),
        ("physics/shapes.py", "quarter_turn(point) * self.spin", "point * 1j * self.spin"),
        (
            "physics/escape.py",
            "for step in range(-_slots_aside(ball, ring), _slots_aside(ball, ring) + 1):",
            "for step in set(range(ring.count)):",
        ),
    ],
)
def test_the_real_modules_are_watched(module, good, bad):
    """A line of the engine, written the tempting way, is found."""
    source = (ROOT / module).read_text(encoding="utf-8")
    assert good in source
    assert findings(source.replace(good, bad), names_of_the_simulation())
