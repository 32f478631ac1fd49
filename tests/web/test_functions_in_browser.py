"""The player's own functions on the page, in a real browser: graded, shown in the lab, flown; no loop hangs the page."""

from tests.grade.wrong_files import RIGHT

WRONG = RIGHT.read_text(encoding="utf-8").replace("return -n if abs(p) < r_p else n", "return n")
LOOP = "def on_left(a, b):\n    while True:\n        pass\n"
LOOP_IN_C = "import itertools\n\n\ndef on_left(a, b):\n    return sum(itertools.count())\n"


def graded(page, text):
    """Give the page a file, and wait for its grade."""
    page.drop("mine.py", text.encode())
    page.use("grade")
    page.wait(lambda: page.tab.is_enabled("#item-grade"), lambda: page.tab.inner_text("#menu"))
    return page.tab.inner_text("#menu")


def test_functions_are_graded_shown_and_flown(page, axe):
    """A wrong one is named with its simplest wrong answer, which opens as a scene with a pane of its own; then a ball flies."""
    page.go("functions")
    assert page.title() == "Your own functions"
    page.wait(
        lambda: "def narrow_phase_case_1" in page.tab.evaluate("document.querySelector('.CodeMirror')?.CodeMirror.getValue()")
    )
    told = graded(page, WRONG)
    assert "11 of 13 functions right" in told
    assert "wrong sign at |p| < r_p" in told
    assert page.standing()["panes"][-1] == "yours: functions.py"  # the first wrong answer
    page.use("case:narrow_phase_case_1")
    assert page.standing()["line"].startswith("case-1?ball=5.57,6.32")
    assert page.standing()["panes"][-1] == "yours: functions.py"
    page.tab.evaluate(axe)
    assert page.tab.evaluate("axe.run(document, {resultTypes: ['violations']})")["violations"] == []
    page.use("fly")
    page.tab.keyboard.press("Space")
    page.wait(lambda: page.standing()["phase"] == "PLAYING", page.standing)
    before = page.standing()["tick"]
    page.wait(lambda: page.standing()["tick"] > before + 60)


def test_functions_that_hang_in_the_lab_alone_open_the_page_again(page):
    """They answered all that the grading asked, and loop in C later: the page says so in one line, and goes on without them."""
    text = WRONG.replace("    n = p / abs(p)\n", "    if r_p == 7.77:\n        sum(itertools.count())\n    n = p / abs(p)\n", 1)
    page.go("functions")
    graded(page, f"import itertools\n{text}")
    page.tab.evaluate("location.hash = '#lab/case-1?radius=7.77'")
    page.wait(lambda: page.notification().startswith("Your own functions gave no answer"), page.notification)
    page.wait(lambda: page.tab.evaluate("polarBreakout.firstFrame > 0"))
    page.go("lab/case-1?radius=7.77")
    assert page.standing()["panes"] == [""]


def test_what_is_typed_is_graded_by_the_keyboard_alone(page):
    """Ctrl+Enter grades what stands in the editor; Escape leaves it for the controls."""
    page.go("functions")
    page.tab.click(".CodeMirror")
    page.tab.keyboard.press("Control+A")
    page.tab.keyboard.type("def on_left(a, b):\nreturn a > b")  # the editor indents
    page.tab.keyboard.press("Control+Enter")
    page.wait(lambda: "no wrap" in page.tab.inner_text("#menu"), lambda: page.tab.inner_text("#menu"))
    page.tab.keyboard.press("Escape")
    assert page.tab.evaluate("document.activeElement.id") == "item-grade"


def test_endless_loops_hang_nothing(page):
    """A loop in Python is named by its line; one in C by the call, after its worker was ended. The page's frames go on."""
    page.go("functions")
    assert "line 3: TooLongError: no answer within 1 seconds" in graded(page, LOOP)
    page.drop("mine.py", LOOP_IN_C.encode())
    page.use("grade")
    page.frames(30)
    page.wait(lambda: page.tab.is_enabled("#item-grade"), lambda: page.tab.inner_text("#menu"))
    told = page.tab.inner_text("#menu")
    assert "no answer to on_left(a=" in told
    assert "not used in the lab and in the game" in told
    assert not page.tab.is_enabled("#item-fly")
    assert "functions.py gave no answer within 4 seconds" in graded(page, "import itertools\nsum(itertools.count())\n")
