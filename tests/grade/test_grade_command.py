"""The command `python -m tools.grade`: its output, its files, its exit codes, and the teacher's file."""

import ast
import json
import sys
from xml.etree import ElementTree as ET

import pytest

from game.lab.session.share import parsed
from game.student.own_functions import PYTHON_ORDER
from game.system.command_line import run
from tests.grade.wrong_files import RIGHT, WRONG_FILES
from tools.grade import command
from tools.grade.commands import app

SIGN = WRONG_FILES[0]
ANGLES = "def add_angles(a, b):\n    return (a + b) % 6.283185307179586\n"


@pytest.fixture(autouse=True)
def _few(monkeypatch, published):
    """A tenth of the vectors: what is looked at here is the report."""
    monkeypatch.setattr(command, "vectors", lambda _: [vector for vector in published if vector.number % 10 == 1])


@pytest.fixture
def mine(tmp_path):
    """Writes a student's file."""

    def write(text):
        path = tmp_path / "mine.py"
        path.write_text(text, encoding="utf-8")
        return path

    return write


def graded(capsys, *arguments):
    """Exit code, stdout and stderr of the command."""
    code = run(
        app,
        "python -m tools.grade",
        [*[str(argument) for argument in arguments], "--start-limit", "3600", "--time-limit", "3600"],
    )
    return code, *capsys.readouterr()


def test_a_right_file_is_exit_code_0(capsys):
    """The verdict is the last line."""
    code, out, err = graded(capsys, RIGHT)
    assert (code, err) == (0, "")
    assert out.splitlines()[-1] == "RIGHT: score 100.0 of 100, 13 of 13 functions right, seed 0"


def test_a_wrong_file_is_exit_code_1(capsys, mine):
    """The report has the counts, the simplest wrong answer, a line that the lab opens, and the hint."""
    code, out, err = graded(capsys, mine(SIGN.text()))
    assert (code, err) == (1, "")
    assert "mistake: wrong sign at |p| < r_p. The inner face's normal points to the centre" in out
    assert "    simplest: narrow_phase_case_1(p=(" in out
    (line, *_) = [line.split("'")[1] for line in out.splitlines() if "python -m game lab" in line and "case-1" in line]
    assert parsed(line).scene.name == "case-1"


def test_a_wrong_answer_is_drawn(capsys, mine, tmp_path):
    """A picture for each wrong function; none for the right ones."""
    text = ANGLES + "def narrow_phase_case_1(p, r_p):\n    return p / abs(p)\n"
    code, out, _ = graded(capsys, mine(text), "--pictures", tmp_path / "pictures")
    assert (code, out.splitlines()[-1]) == (1, f"picture: {tmp_path / 'pictures' / 'narrow_phase_case_1.png'}")
    assert [path.name for path in (tmp_path / "pictures").iterdir()] == ["narrow_phase_case_1.png"]
    assert (tmp_path / "pictures" / "narrow_phase_case_1.png").read_bytes().startswith(b"\x89PNG")


def test_a_file_may_define_only_some_functions(capsys, mine):
    """The others do not count."""
    code, out, _ = graded(capsys, mine(ANGLES))
    assert code == 0
    assert out.count("not defined") == 12
    assert out.splitlines()[-1] == "RIGHT: score 100.0 of 100, 1 of 1 functions right, seed 0"


def test_json_has_what_the_report_says(capsys, mine, tmp_path):
    """Numbers and text, versioned."""
    file = tmp_path / "grade.json"
    _, out, _ = graded(capsys, mine(SIGN.text()), "--json", file, "--seed", 3)
    record = json.loads(file.read_text(encoding="utf-8"))
    assert (record["format"], record["vectors"], record["seed"]) == ("polar-breakout grade 1", "polar-breakout vectors 1", 3)
    assert record["verdict"] == out.splitlines()[-1]
    assert not record["right"]
    (wrong, *_) = [function for function in record["functions"] if function["function"] == "narrow_phase_case_1"]
    assert wrong["mistakes"][0]["name"] == SIGN.name
    assert wrong["passed"] + wrong["traps"]["|p| < r_p"]["counted"] == wrong["counted"]
    assert wrong["simplest"]["lab"].startswith("case-1?ball=")
    assert wrong["simplest"]["id"].startswith("narrow_phase_case_1-")


def test_junit_has_a_suite_for_each_function(capsys, mine, tmp_path):
    """A test case for each trap; the failures are counted."""
    file = tmp_path / "grade.xml"
    graded(capsys, mine(SIGN.text()), "--junit", file)
    root = ET.parse(file).getroot()  # noqa: S314  # our own file
    failures = {suite.get("name"): int(suite.get("failures")) for suite in root}
    assert len(failures) == 13
    assert {name for name, count in failures.items() if count} == SIGN.functions
    (case,) = [case for case in root.iter("testcase") if case.get("name") == "|p| < r_p"]
    assert SIGN.name in case.find("failure").text
    assert all(int(suite.get("tests")) == len(suite.findall("testcase")) for suite in root)


def test_a_template_has_every_function_and_none_is_written(capsys, tmp_path):
    """With the parameters in their order. What is filled in is graded, what is not does not count; no file is overwritten."""
    path = tmp_path / "new.py"
    assert graded(capsys, "--template", path)[0] == 0
    assert graded(capsys, "--template", path)[0] == 2
    text = path.read_text(encoding="utf-8")
    functions = {node.name: node for node in ast.parse(text).body if isinstance(node, ast.FunctionDef)}
    assert {name: tuple(one.arg for one in functions[name].args.args) for name in PYTHON_ORDER} == dict(PYTHON_ORDER)
    assert graded(capsys, path)[0] == 2
    outline, rest = text.split("def add_angles(a, b):")
    path.write_text(
        f"{outline}def add_angles(a, b):{rest.replace('raise NotImplementedError', 'return (a + b) % math.tau', 1)}"
    )
    code, out, _ = graded(capsys, path)
    assert (code, out.splitlines()[-1]) == (0, "RIGHT: score 100.0 of 100, 1 of 1 functions right, seed 0")


def test_a_function_that_calls_one_not_yet_written_does_not_count(capsys, mine):
    """It is neither right nor wrong."""
    text = "def later(a):\n    raise NotImplementedError\ndef on_left(a, b):\n    return later(a)\n"
    code, out, _ = graded(capsys, mine(text + ANGLES))
    assert (code, out.count("not defined")) == (0, 12)


def test_a_teachers_file_sets_what_counts(capsys, mine, tmp_path):
    """A function that must be there and is not has no points; what is not listed is shown, and does not count."""
    scheme = tmp_path / "scheme.toml"
    scheme.write_text('title = "Homework 3"\nfunctions = ["add_angles", "on_left"]\nweights = { add_angles = 3 }\n')
    code, out, _ = graded(capsys, mine(ANGLES + "def to_polar(p): return 1\n"), "--scheme", scheme)
    assert code == 1
    assert out.startswith("Homework 3\n")
    assert "on_left                  not defined, but it counts" in out
    assert "(does not count)" in next(line for line in out.splitlines() if "to_polar" in line)
    assert out.splitlines()[-1] == "WRONG: score 75.0 of 100, 1 of 2 functions right, seed 0"


def test_a_teachers_tolerance_holds(capsys, mine, tmp_path):
    """Single precision is wrong by the vectors' own tolerance, and right by a wider one."""
    scheme = tmp_path / "scheme.toml"
    path = mine("def add_angles(a, b):\n    return (a + b) % 6.2831855\n")
    assert graded(capsys, path)[0] == 1
    for text in ("tolerance = 1e-5", "tolerance = 1e-12\n[tolerances]\nadd_angles = 1e-5"):
        scheme.write_text(text)
        assert graded(capsys, path, "--scheme", scheme)[0] == 0


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("weight = 1", "no key 'weight'"),
        ("functions = []", "functions: expected a list"),
        ("functions = ['cos']", "functions: no function 'cos'"),
        ("[weights]\non_left = -1", "weights.on_left: expected a number from 0"),
        ("[weights]\nleft = 1", "weights: no function 'left'"),
        ("functions = ['on_left']\n[weights]\non_left = 0", "weights: all are 0"),
        ("tolerance = 0", "tolerance: expected a number above 0"),
        ("tolerance = nan", "tolerance: expected a number above 0"),
        ("tolerances = 3", "tolerances: expected a table"),
        ("title = 3", "title: expected text"),
        ("title =", "Invalid value"),
    ],
)
def test_a_teachers_file_that_cannot_be_used(capsys, tmp_path, text, words):
    """One line names the key and the rule: exit code 2."""
    scheme = tmp_path / "scheme.toml"
    scheme.write_text(text)
    code, out, err = graded(capsys, RIGHT, "--scheme", scheme)
    assert (code, out, len(err.splitlines())) == (2, "", 1)
    assert words in err


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("def on_left(a, b:\n    pass\n", "mine.py, line 1: SyntaxError"),
        ("\nimport nothing_of_that_name\n", "mine.py, line 2: ModuleNotFoundError"),
        ("raise SystemExit\n", "mine.py, line 1: SystemExit"),
        ("x = 1\n", "none of the source's functions is written yet"),
    ],
)
def test_a_file_that_cannot_be_used(capsys, mine, text, words):
    """It names the student's line."""
    code, out, err = graded(capsys, mine(text))
    assert (code, out, len(err.splitlines())) == (2, "", 1)
    assert words in err


@pytest.mark.parametrize(
    "arguments",
    [
        [],
        ["nowhere.py"],
        [RIGHT, "--command", "true"],
        ["--command", "no-program-of-that-name"],
        ["--command", "'"],
        ["--command", ""],
        [RIGHT, "--json", "/nowhere/grade.json"],
        [RIGHT, "--scheme", "nowhere.toml"],
        [RIGHT, "--memory", "1"],
    ],
)
def test_bad_input_is_one_line_and_exit_code_2(capsys, arguments):
    """No traceback, and nothing on stdout."""
    code, out, err = graded(capsys, *arguments)
    assert (code, out, len(err.splitlines())) == (2, "", 1)


def test_a_command_is_graded(capsys, tmp_path):
    """Any program that answers line by line; here a Python one that knows a single function."""
    program = tmp_path / "student.py"
    program.write_text(
        "import json, sys\nfor line in sys.stdin:\n    q = json.loads(line)\n"
        "    known = q['function'] == 'add_angles'\n"
        "    answer = {'result': sum(q['arguments']) % 6.283185307179586} if known else {'undefined': True}\n"
        "    print(json.dumps(answer), flush=True)\n"
    )
    code, out, _ = graded(capsys, "--command", f"{sys.executable} {program}")
    assert (code, out.splitlines()[-1]) == (0, "RIGHT: score 100.0 of 100, 1 of 1 functions right, seed 0")


@pytest.mark.parametrize(("words", "problem"), [("exit()", "(exit code 0)"), ("print('hello')", "not an answer: hello")])
def test_a_program_that_answers_nothing_is_bad_input(capsys, tmp_path, words, problem):
    """It is said after the first question, not after thousands."""
    program = tmp_path / "student.py"
    program.write_text(f"import sys\nsys.stdin.readline()\n{words}\n")
    code, out, err = graded(capsys, "--command", f"{sys.executable} {program}")
    assert (code, out, len(err.splitlines())) == (2, "", 1)
    assert "the program answers no question" in err
    assert problem in err


def test_points_may_be_of_the_students_own_kind(capsys, mine):
    """A file with make_point gets its points so; pairs and tuples are answers, too."""
    text = (
        "def make_point(x, y): return {'x': x, 'y': y}\n"
        "def narrow_phase_case_1(p, r_p):\n"
        "    d = (p['x'] ** 2 + p['y'] ** 2) ** 0.5\n"
        "    s = -1 if d < r_p else 1\n"
        "    return s * p['x'] / d, s * p['y'] / d\n"
    )
    code, out, _ = graded(capsys, mine(text))
    assert (code, out.splitlines()[-1]) == (0, "RIGHT: score 100.0 of 100, 1 of 1 functions right, seed 0")
