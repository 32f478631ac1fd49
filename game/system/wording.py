"""Words for messages: one line, whatever they quote, and not too much of it."""

import re

MOST_QUOTED = 80
"""Characters of an input that a message repeats at most."""
_MOST_OF_A_PATH = 240
_LONG = re.compile(rf"'[^']{{{MOST_QUOTED},}}'|`[^`]{{{MOST_QUOTED},}}`|\"[^\"]{{{MOST_QUOTED},}}\"|\S{{{MOST_QUOTED + 1},}}")
_ELLIPSIS = "..."


def printable(text: str) -> str:
    r"""The text on one line: line breaks, control characters and what else cannot be seen as their escapes.

    >>> print(printable("a\nb\x1b[31m"))
    a\nb\x1b[31m
    """
    return "".join([c if c.isprintable() else c.encode("unicode_escape", "surrogatepass").decode("ascii") for c in text])


def quoted(text: object, most: int = MOST_QUOTED) -> str:
    """An input as a message repeats it: one line, its middle left out where it is longer than `most` characters.

    >>> quoted("x" * 100, 13)
    'xxxxx...xxxxx'
    """
    line = printable(str(text))
    if len(line) <= most:
        return line
    head = (most - len(_ELLIPSIS)) // 2
    return line[:head] + _ELLIPSIS + line[-(most - len(_ELLIPSIS) - head) :]


def quoted_path(path: object) -> str:
    """A path as a message repeats it; more of it than of other inputs, as one has to find the file."""
    return quoted(path, _MOST_OF_A_PATH)


def quoted_message(message: str) -> str:
    """What a library says about an input, on one line, every long word or quotation in it shortened."""
    line = " ".join(message.split())
    return quoted(_LONG.sub(lambda found: quoted(found.group()), printable(line)), 4 * MOST_QUOTED)
