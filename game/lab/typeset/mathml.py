"""Translates a formula of the lab from the TeX that matplotlib typesets to MathML, for browsers and screen readers.

Browsers do not wrap a formula. So a line becomes several formulas and the words between them, with spaces where it may be
wrapped: before a relation, and between words.
"""

import itertools
import re
from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import NamedTuple

from game.lab.typeset.tex import tex_line

_MOST_LINES = 512
_TOKEN = re.compile(r"\\[A-Za-z]+ ?|\\.|\d+(?:\.\d+)?(?:e[+-]\d+)?|.")
_NAMES_OF_GREEK = """
    alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho sigma tau upsilon phi chi psi omega
    varphi varepsilon Delta
"""
_GREEK = dict(zip(_NAMES_OF_GREEK.split(), "αβγδεζηθικλμνξοπρστυφχψωφεΔ", strict=True))
_SIGNS = {r"\cdot": "·", r"\times": "×", r"\leq": "≤", r"\geq": "≥", "-": "\u2212"}
_SPACES = {r"\quad": "\u2003 ", r"\ ": " ", r"\,": "", r"\;": "", r"\:": ""}
"""The text for a space of TeX at which a line may be wrapped; "" for the other spaces."""
_WIDTHS = {r"\quad": 1.0, r"\ ": 0.3, r"\,": 0.17, r"\;": 0.0, r"\:": 0.0}
"""Of spaces within a formula, in sizes of the letters; MathML has spaces of its own beside relations."""
_TIGHT = frozenset("|,:;.?!/")
"""Signs without space beside them; TeX writes the space after a comma explicitly."""
_NAMES = frozenset({r"\min", r"\max", r"\sin", r"\cos"})
_KINDS = {"relation": "=<>≤≥≔", "open": "([", "close": ")]", "comma": ",:;.?!"}
"""The signs of each kind; all others are only signs."""
_COMMANDS = {
    r"\hat": '<mover accent="true">{}<mo stretchy="false">^</mo></mover>',
    r"\sqrt": "<msqrt>{}</msqrt>",
    r"\dfrac": '<mfrac displaystyle="true">{}{}</mfrac>',
}
_PRIME, _TWO_PRIMES = "\u2032", "\u2033"
_PRIMED = f"<mo>{_PRIME}</mo></msup>"
_JOINER = "\u2060"
"""Joins a formula and the comma after it, so that no line is wrapped between them."""
_MINUS = "\u2013"
"""The sign of a number in the lab's TeX."""


class _Atom(NamedTuple):
    """A part of a formula. kind: word, space, relation, open, close, comma, sign or term. text: of a word, a space, a sign."""

    kind: str
    markup: str
    text: str = ""


@lru_cache(maxsize=_MOST_LINES)
def mathml_line(line: str) -> str:
    """A line of the lab as HTML: `<math>` for formulas, text for words."""
    atoms = _atoms(iter(_TOKEN.findall(tex_line(line)[1:-1])))
    done, formula = "", list[_Atom]()
    depth = 0
    for index, atom in enumerate(atoms):
        depth += (atom.kind == "open") - (atom.kind == "close")
        alone = not depth and atom.kind in {"word", "comma", "space"} and _stands_alone(atoms, index)
        if alone or (not depth and atom.kind == "relation"):
            broken = " " if atom.kind == "relation" and formula else ""
            done, formula = done + _math(formula) + broken, []
        if alone:
            stays = _JOINER if atom.kind == "comma" and done.endswith(">") else ""
            done += stays + (escaped(atom.text) or " ")
        else:
            formula.append(atom)
    return done + _math(formula)


def _stands_alone(atoms: Sequence[_Atom], index: int) -> bool:
    """Whether a word, a comma or a space is text between formulas, not part of one."""
    atom = atoms[index]
    before, after = (atoms[k] if 0 <= k < len(atoms) else None for k in (index - 1, index + 1))
    if atom.kind == "space":
        return bool(atom.text) or (before is not None and before.kind == "comma")
    if atom.kind == "comma":
        return True
    return (before is None or before.kind in {"space", "comma"}) and (after is None or after.kind in {"space", "comma"})


def _math(atoms: Sequence[_Atom]) -> str:
    """One formula; "" for none."""
    return f"<math>{_row(atoms)}</math>" if atoms else ""


def _row(atoms: Sequence[_Atom]) -> str:
    """Atoms beside each other; a minus at the beginning of a term is marked as a sign."""
    parts = list[str]()
    before: _Atom | None = None
    for atom in atoms:
        if atom.text == _SIGNS["-"] and (before is None or before.kind in {"relation", "open", "comma"}):
            parts.append('<mo form="prefix">\u2212</mo>')
        elif atom.kind == "relation" and before is None:  # the space before the formula serves
            parts.append(atom.markup.replace("<mo>", '<mo form="infix" lspace="0">'))
        else:
            parts.append(atom.markup)
        before = atom
    return "".join(parts)


def _atoms(parts: Iterator[str]) -> list[_Atom]:
    """The atoms up to the end of a group."""
    atoms: list[_Atom] = []
    for part in parts:
        command = part if part == r"\ " else part.rstrip(" ")
        if command == "}":
            break
        if command in {"^", "_"}:
            atoms[-1:] = [_scripted(atoms[-1], command, _argument(parts))]
        elif command == r"\prime":
            atoms[-1:] = [_primed(atoms[-1])]
        elif command == r"\mathrm":
            atoms = _with_word(atoms, _plain(parts))
        elif command in _NAMES or command == r"\_":
            atoms = _with_word(atoms, command[1:])
        elif command[0].isdigit() and atoms and atoms[-1].text == _MINUS:
            atoms[-1] = _Atom("term", f"<mn>{_SIGNS['-']}{command}</mn>")
        else:
            atoms.append(_atom(command, parts))
    return atoms


def _atom(command: str, parts: Iterator[str]) -> _Atom:
    """The atom that begins with a command, a number, a letter or a sign."""
    if command == "{":
        inner = _atoms(parts)
        return inner[0] if len(inner) == 1 else _Atom("term", f"<mrow>{_row(inner)}</mrow>")
    if command == r"\mathbf":
        return _Atom("term", f'<mi mathvariant="normal" class="vector">{_letter(_plain(parts))}</mi>')
    if command in _COMMANDS:
        form = _COMMANDS[command]
        return _Atom("term", form.format(*[_argument(parts).markup for _ in range(form.count("{}"))]))
    return _leaf(command)


def _leaf(command: str) -> _Atom:
    """The atom of a space, a number, a letter or a sign."""
    letter = _letter(command)
    if command in _SPACES:
        return _Atom("space", f'<mspace width="{_WIDTHS[command]}em"/>' if _WIDTHS[command] else "", _SPACES[command])
    if command[0].isdigit():
        return _Atom("term", f"<mn>{command}</mn>")
    if letter.isalpha():
        return _Atom("term", f"<mi>{letter}</mi>" if letter != "Δ" else '<mi mathvariant="normal">Δ</mi>')
    return _sign(_SIGNS.get(command, command.removeprefix("\\")))


def _sign(sign: str) -> _Atom:
    """The atom of a sign."""
    kind = next((kind for kind, signs in _KINDS.items() if sign in signs), "sign")
    tight = ' stretchy="false" lspace="0" rspace="0"' if sign in _TIGHT else ""
    return _Atom(kind, f"<mo{tight}>{escaped(sign)}</mo>", sign)


def _argument(parts: Iterator[str]) -> _Atom:
    """The argument of a command: a group, or one letter, number or sign."""
    return _atom(next(parts).rstrip(" "), parts)


def _letter(command: str) -> str:
    """The letter that a command names; anything else unchanged."""
    return _GREEK.get(command.removeprefix("\\"), command)


def _plain(parts: Iterator[str]) -> str:
    """The text in a group."""
    next(parts)  # the group's opening bracket
    return "".join(itertools.takewhile(lambda part: part != "}", parts)).replace(r"\_", "_")


def _with_word(atoms: list[_Atom], text: str) -> list[_Atom]:
    """The atoms with a text added: a minus as a sign, a word joined to a word directly before it."""
    if text == _MINUS:
        return [*atoms, _Atom("sign", "<mo>\u2212</mo>", _MINUS)]
    whole = (atoms[-1].text if atoms and atoms[-1].kind == "word" else "") + text
    kept = atoms[:-1] if atoms and atoms[-1].kind == "word" else atoms
    return [*kept, _Atom("word", f"<mtext>{escaped(whole)}</mtext>", whole)]


def _scripted(base: _Atom, command: str, script: _Atom) -> _Atom:
    """A base with an index (_) or an exponent (^); a degree sign is a part of its number."""
    if script.text == "circ":
        return _Atom("term", base.markup.replace("</mn>", "°</mn>"))
    if base.markup.endswith(_PRIMED) and command == "_":
        inner = base.markup.removeprefix("<msup>").removesuffix(_PRIMED)
        return _Atom("term", f"<msubsup>{inner}{script.markup}{_PRIMED.replace('msup', 'msubsup')}")
    name = "msup" if command == "^" else "msub"
    return _Atom("term", f"<{name}>{base.markup}{script.markup}</{name}>")


def _primed(base: _Atom) -> _Atom:
    """A base with an additional prime."""
    if base.markup.endswith(_PRIMED):
        return _Atom("term", base.markup.removesuffix(_PRIMED) + _PRIMED.replace(_PRIME, _TWO_PRIMES))
    return _Atom("term", f"<msup>{base.markup}{_PRIMED}")


def escaped(text: str) -> str:
    """A text escaped for HTML. The page's standard library has no module for it."""
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
