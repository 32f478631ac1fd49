"""What the page asks the worker that grades, and what that one answers: in JSON."""

import msgspec


class GradingRequest(msgspec.Struct, frozen=True):
    """A text of functions is to be graded.

    number: of the request. given_up: functions that are not asked, since the worker had to be ended, with the number of the
    call that it did not answer. seconds: within which each call must be answered; then the worker is ended.
    """

    number: int
    text: str
    given_up: dict[str, int] = {}
    seconds: float = 4.0


class GradedFunction(msgspec.Struct, frozen=True):
    """What a function's answers are worth.

    defined: whether the text has it. right: whether all that counts is. summary: in a few words. details: sentences about what
    is wrong. line: a share line that opens its simplest wrong answer in the lab; "" where no scene shows it.
    """

    name: str
    defined: bool
    right: bool
    summary: str
    details: tuple[str, ...] = ()
    line: str = ""


class GradingReply(msgspec.Struct, frozen=True):
    """The grade. problem: why there is none, "" for nothing. verdict: one sentence. functions: in the order of the slides."""

    number: int
    problem: str = ""
    verdict: str = ""
    functions: tuple[GradedFunction, ...] = ()
