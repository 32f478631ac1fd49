"""The player's own functions on the page: typed into the editor, graded, and then used in the lab and in the game."""

from pathlib import Path

import msgspec

from game.student.template import PAGE_TEMPLATE
from game.system.files import write_atomically
from game.web.client.functions.grading import GradedFunction, GradingReply, GradingRequest
from game.web.client.functions.text import NAME, FunctionsText
from game.web.client.messages import Download, Graded, PageItem

_MOST_GIVEN_UP = 4
"""How often the worker that grades is ended and begins again; then there is no grade."""
_LONGEST = 200_000
"""Characters of a text."""
CASE = "case"
"""Of an item, before a function's name: its wrong answer in the lab."""
_LINES = (
    "Write any of the source's functions, or drop a Python file here. What is not written is ours.",
    "Ctrl+Enter grades. Escape leaves the editor. Nothing leaves this computer.",
)


_UNSAFE = "What did not answer is not used in the lab and in the game."


class OwnFunctionsPanel:
    """The text, and its grade. It is kept from screen to screen.

    Attributes:
        is_open: whether the editor is there.
        running: what was graded last, as the lab and the game use it; None for nothing, and where it did not always answer.
        request: for the worker that grades, to be sent now.
        fresh: a text that the editor is to show, to be sent now.
    """

    def __init__(self, folder: Path | None = None) -> None:
        """folder: where the text is stored; None for nowhere."""
        self._path = None if folder is None else folder / NAME
        self._text = self._stored()
        self.is_open = False
        self.running: FunctionsText | None = None
        self.request: GradingRequest | None = None
        self.fresh: str | None = None
        self._waiting: GradingRequest | None = None
        self._number = 0
        self._grade: GradingReply | None = None

    @property
    def lines(self) -> tuple[str, ...]:
        """What is read above the controls."""
        if self._waiting is not None:
            return ("Grading: every function is asked some hundred questions ...",)
        if self._grade is None:
            return _LINES
        said = self._grade.problem or self._grade.verdict
        return (said,) if self.running is not None or self._grade.problem else (said, _UNSAFE)

    @property
    def items(self) -> tuple[PageItem, ...]:
        """The controls, and the grade of every function that is written."""
        functions = () if self._grade is None or self._waiting is not None else self._grade.functions
        return (
            PageItem("grade", "Grade", disabled=self._waiting is not None),
            PageItem("fly", "Play on these functions", disabled=self.running is None or not self.running.own),
            PageItem("download", f"Download {NAME}"),
            PageItem("close", "Close the editor"),
            *[item for found in functions if found.defined and not found.right for item in _wrong(found)],
            *[PageItem(f"right:{one.name}", f"\u2713 {one.name}: {one.summary}", "words") for one in functions if one.right],
        )

    @property
    def download(self) -> Download:
        """The text as a file."""
        return Download(NAME, self._text.encode())

    def open(self, text: str | None = None) -> None:
        """Show the editor. text: in place of what it holds; None for that."""
        if text is not None:
            self._text = text[:_LONGEST]
        self.is_open, self.fresh = True, self._text

    def typed(self, text: str) -> None:
        """The editor holds another text."""
        self._text = text[:_LONGEST]

    def line_of(self, function: str) -> str:
        """The share line of a function's wrong answer; "" for none."""
        functions = () if self._grade is None else self._grade.functions
        return next((found.line for found in functions if found.name == function), "")

    def grade(self) -> str:
        """Have the text graded, and store it; a line about what went wrong with storing, "" for nothing."""
        self._ask(self._text, {})
        try:
            if self._path is not None:
                write_atomically(self._path, self._text.encode())
        except OSError as error:
            return f"{NAME}: cannot be stored; {error.strerror}"
        return ""

    def graded(self, message: Graded) -> str:
        """A grade has come; or the worker had to be ended, and begins again without the function that did not answer.

        The share line of the first wrong answer that a scene shows; "" while there is none.
        """
        asked = self._waiting
        if asked is None or message.number != asked.number:
            return ""
        if message.reply:
            self._done(asked, msgspec.json.decode(message.reply, type=GradingReply))
        elif message.function and len(asked.given_up) < _MOST_GIVEN_UP:
            self._ask(asked.text, asked.given_up | {message.function: message.call})
        else:
            what = message.function or (NAME if message.call else "the worker that grades")
            self._done(asked, GradingReply(asked.number, f"{what} gave no answer within {asked.seconds:g} seconds"))
        functions = () if self._waiting is not None or self._grade is None else self._grade.functions
        return next((found.line for found in functions if found.line), "")

    def _ask(self, text: str, given_up: dict[str, int]) -> None:
        """Send a text to the worker."""
        self._number += 1
        self._waiting = self.request = GradingRequest(self._number, text, given_up)

    def _done(self, asked: GradingRequest, grade: GradingReply) -> None:
        """Show a grade. What has once not answered does not run in this process, which nothing would end."""
        self._waiting, self._grade = None, grade
        self.running = None if grade.problem or asked.given_up else FunctionsText(asked.text)

    def _stored(self) -> str:
        """The text of the last visit; for the first, what to begin with."""
        try:
            return PAGE_TEMPLATE if self._path is None else self._path.read_text(encoding="utf-8")
        except (OSError, UnicodeDecodeError):
            return PAGE_TEMPLATE


def _wrong(found: GradedFunction) -> list[PageItem]:
    """What is wrong with a function, and the way into the lab."""
    words = [f"\u2717 {found.name}: {found.summary}", *found.details]
    items = [PageItem(f"wrong:{found.name}:{number}", line, "words") for number, line in enumerate(words)]
    return [*items, PageItem(f"{CASE}:{found.name}", f"{found.name}: the wrong case in the lab", disabled=not found.line)]
