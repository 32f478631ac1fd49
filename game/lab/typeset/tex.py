"""A formula of the lab, written in the source's letters on one line, as TeX that matplotlib's mathtext can set.

In `v := v_0 v_res / |v_res|` the vectors become bold, the word in the index upright, and what is divided stands above what
divides it. Numbers are pieces of their own: while something is dragged only they change.
"""

import re
import unicodedata
from collections.abc import Sequence
from typing import NamedTuple

_TOKEN = re.compile(
    r"(?P<space>\s+)"
    r"|(?P<number>\d+(?:\.\d+)?(?:e[+-]\d+)?°?)"
    r"|(?P<unit>[a-z]{2,}/s(?![A-Za-z])|(?<=\d )s(?![A-Za-z_'²]))"
    r"|(?P<code>[A-Za-z]{2,}(?:_[A-Za-z0-9]+)+)(?=\()"
    r"|(?P<symbol>Δ?(?:[A-Za-z](?![A-Za-z])|[\u03b1-\u03c9])'*(?:_[A-Za-z0-9\u03b1-\u03c9]+)?)"
    r"|(?P<word>[A-Za-z]+(?:-[A-Za-z]+)*(?:'s)?)"
    r"|(?P<other>:=|.)"
)
_ARTICLE = re.compile(r"[aA] (?!is\b|mod\b|t\b|c\b)[a-z]{2,}")
_VECTORS = frozenset("vnpq")
_ACCENTS = {"q": "hat"}
_SCALAR_INDICES = frozenset({"0", "x", "y", "z"})
"""Of a vector's components and its fixed length: v_0, n_x."""
_GREEK = {
    **{chr(code): unicodedata.name(chr(code)).split()[-1].lower() for code in range(0x3B1, 0x3CA) if code != 0x3C2},
    "φ": "varphi",
    "ε": "varepsilon",
    "λ": "lambda",
    "Δ": "Delta",
}
_FUNCTIONS = frozenset({"min", "max", "sin", "cos"})
_OPERATORS = {"·": r"\cdot ", "×": r"\times ", "≤": r"\leq ", "≥": r"\geq ", ":=": r"\;≔\;", "²": "^2", "³": "^3", "|": "|"}
_RELATIONS = frozenset({"=", "<", ">", "≤", "≥", ":=", "+", "-", "·", "×", "/"})
_AFTER_OPERATOR = r"\:"
_GAPS = {r"\quad ": 1.0, r"\ ": 0.3, r"\,": 0.17, _AFTER_OPERATOR: 0.2}
"""The spaces of a line, in sizes of the letters."""
_PRIME = r"\prime "
_PRINTED = str.maketrans({"'": "\u2019", "-": "\u2010"})
"""In words, mathtext takes an apostrophe for a prime and a hyphen for a minus."""
_ESCAPED = frozenset("%$#&{}_^\\")
_PAIRS = {")": "(", "|": "|"}


class Piece(NamedTuple):
    """A part of a line: exactly one of its fields is set.

    tex: for mathtext, without dollar signs. number: digits. gap: a space before a number, in sizes of the letters.
    """

    tex: str = ""
    number: str = ""
    gap: float = 0.0


class Symbol(NamedTuple):
    """A variable: Δv'_n is the change (Δ) of the vector v, with one prime and the index n."""

    letter: str
    is_vector: bool
    is_change: bool
    primes: int
    below: str


class Token(NamedTuple):
    """kind: the name of a group of _TOKEN, or "tex" for what is set already. text: as it was written."""

    kind: str
    text: str
    tex: str


def pieces(line: str) -> tuple[Piece, ...]:
    """A line as pieces in its order: numbers, and what is between them."""
    tokens = _with_fractions(_with_roots(tokens_of(line)))
    found: list[Piece] = []
    space = ""
    for index, token in enumerate(tokens):
        before, after = _neighbours(tokens, index)
        if token.kind == "space":
            operates = before is not None and before.text in _RELATIONS and after is not None and after.kind == "number"
            space = _AFTER_OPERATOR if operates else _spacing(token.text, before, after)
        elif token.kind == "number":
            found += [Piece(gap=_GAPS[space])] if space else []
            found.append(Piece(number=token.text))
            space = ""
        else:
            if found and found[-1].tex:
                found[-1] = Piece(found[-1].tex + space + token.tex)
            else:
                found.append(Piece(("{}" if found else "") + space + token.tex))  # after a number, a minus is between two
            space = ""
    return tuple(found)


def tex_line(line: str) -> str:
    """A line as one formula, with its dollar signs."""
    return f"${_joined(_with_fractions(_with_roots(tokens_of(line))))}$"


def has_symbols(text: str) -> bool:
    """Whether a text has a variable in it, such as v_p; one in words alone has none."""
    return any([token.kind == "symbol" for token in tokens_of(text)])


def tokens_of(line: str) -> list[Token]:
    """The parts of a line; a minus that belongs to a number is a part of it."""
    tokens: list[Token] = []
    for match in _TOKEN.finditer(line):
        kind, text = str(match.lastgroup), match.group()
        if text in {"a", "A"} and _ARTICLE.match(line, match.start()):
            kind = "word"
        signed = kind == "number" and tokens and tokens[-1].text == "-" and _begins(tokens[:-1])
        if signed:
            tokens[-1] = Token("number", f"-{text}", "")
        else:
            tokens.append(Token(kind, text, _tex(kind, text, tokens)))
    return tokens


def _begins(tokens: Sequence[Token]) -> bool:
    """Whether what follows is the beginning of a term, so that a minus there is a sign."""
    last = next((token for token in reversed(tokens) if token.kind != "space"), None)
    return last is None or last.text in _RELATIONS or last.text in {"(", ",", ":", "["}


def _tex(kind: str, text: str, before: Sequence[Token]) -> str:
    """The TeX of a token; empty for a number, which is set by its digits."""
    match kind:
        case "symbol":
            last = [token.text for token in before if token.kind != "space"][-1:]
            return _symbol(text, last[0] if last else "")
        case "code":
            return rf"\mathrm{{{text.replace('_', chr(92) + '_')}}}"
        case "unit":
            return rf"\mathrm{{{text}}}"
        case "word":
            return rf"\{text}" if text in _FUNCTIONS else rf"\mathrm{{{text.translate(_PRINTED)}}}"
        case "other":
            return rf"\{text}" if text in _ESCAPED else _OPERATORS.get(text, text)
    return ""


def _symbol(text: str, before: str) -> str:
    """A variable with its accents and its index. before: the token before it."""
    symbol = symbol_of(text, before)
    letter, index = symbol.letter, symbol.below
    tex = rf"\{_GREEK[letter]}" if letter in _GREEK else letter
    tex = rf"\mathbf{{{tex}}}" if symbol.is_vector else f"{{{tex}}}"
    tex = rf"\{_ACCENTS[letter]}{{{tex}}}" if symbol.is_vector and letter in _ACCENTS else tex
    below = "" if not index else f"_{{{_index(index)}}}"
    return (r"\Delta " if symbol.is_change else "") + tex + _PRIME * symbol.primes + below


def symbol_of(text: str, before: str = "") -> Symbol:
    """The parts of a variable. before: the token before it."""
    name, _, index = text.partition("_")
    base = name.rstrip("'")
    primes, is_change = len(name) - len(base), base.startswith("Δ") and len(base) > 1
    letter = base[1:] if is_change else base
    is_count = letter == "n" and not index and before in {"/", "mod", "round"}
    is_point = primes and letter == "p" and not index
    is_vector = letter in _VECTORS and index not in _SCALAR_INDICES and not is_count and not is_point
    return Symbol(letter, is_vector, is_change, primes, index)


def _index(index: str) -> str:
    """What stands below a variable: a letter is slanted, a word upright."""
    if index in _GREEK:
        return rf"\{_GREEK[index]}"
    return index if len(index) == 1 else rf"\mathrm{{{index}}}"


def _with_roots(tokens: list[Token]) -> list[Token]:
    """`sqrt(x)` and `√(x)` as roots."""
    done: list[Token] = []
    index = 0
    while index < len(tokens):
        is_root = tokens[index].text in {"sqrt", "√"} and index + 1 < len(tokens) and tokens[index + 1].text == "("
        end = _closing(tokens, index + 1) if is_root else None
        if end is None:
            done.append(tokens[index])
            index += 1
        else:
            done.append(Token("tex", "", rf"\sqrt{{{_joined(tokens[index + 2 : end])}}}"))
            index = end + 1
    return done


def _with_fractions(tokens: list[Token]) -> list[Token]:
    """` / ` between two terms as a fraction; a slash without spaces, as in rad/s, stays."""
    for index, token in enumerate(tokens):
        spaced = 0 < index < len(tokens) - 1 and tokens[index - 1].kind == tokens[index + 1].kind == "space"
        if token.text != "/" or not spaced:
            continue
        start, end = _term_before(tokens, index - 1), _term_after(tokens, index + 2)
        if start is None or end is None:
            continue
        above, below = (_bare(part) for part in (tokens[start : index - 1], tokens[index + 2 : end]))
        fraction = Token("tex", "", rf"\dfrac{{{_joined(above)}}}{{{_joined(below)}}}")
        return _with_fractions([*tokens[:start], fraction, *tokens[end:]])
    return tokens


def _term_before(tokens: Sequence[Token], end: int) -> int | None:
    """Where the term begins that ends before an index: a symbol, a number, or brackets; with what it is dotted with."""
    index = end - 1
    if index < 0 or (tokens[index].kind not in {"symbol", "number", "tex"} and tokens[index].text not in _PAIRS):
        return None
    if tokens[index].text in _PAIRS:
        opening = _PAIRS[tokens[index].text]
        depth = 0
        for start in range(index - 1, -1, -1):
            depth += (tokens[start].text == ")") - (tokens[start].text == "(")
            if tokens[start].text == opening and depth <= (-1 if opening == "(" else 0):
                index = start
                break
        else:
            return None
    dotted = index >= 3 and tokens[index - 2].text == "·"
    return _term_before(tokens, index - 3) if dotted else index


def _term_after(tokens: Sequence[Token], start: int) -> int | None:
    """Where the term ends that begins at an index, with its exponent."""
    if start >= len(tokens):
        return None
    if tokens[start].text in {"(", "|"}:
        closing = _closing(tokens, start)
        end = None if closing is None else closing + 1
    else:
        end = start + 1 if tokens[start].kind in {"symbol", "number", "tex"} else None
    return end + 1 if end is not None and end < len(tokens) and tokens[end].text in {"²", "³"} else end


def _closing(tokens: Sequence[Token], start: int) -> int | None:
    """Where the bracket or bar at an index is closed."""
    opening = tokens[start].text
    depth = 0
    for index in range(start + 1, len(tokens)):
        text = tokens[index].text
        if depth == 0 and text == (")" if opening == "(" else "|"):
            return index
        depth += (text == "(") - (text == ")")
    return None


def _bare(tokens: Sequence[Token]) -> Sequence[Token]:
    """A term of a fraction without the brackets around all of it."""
    around = len(tokens) > 2 and tokens[0].text == "(" and _closing(tokens, 0) == len(tokens) - 1
    return tokens[1:-1] if around else tokens


def _joined(tokens: Sequence[Token]) -> str:
    """Tokens as TeX, their numbers included."""
    parts = []
    for index, token in enumerate(tokens):
        before, after = _neighbours(tokens, index)
        if token.kind == "number":
            parts.append(_number(token.text))
        else:
            parts.append(_spacing(token.text, before, after) if token.kind == "space" else token.tex)
    return "".join(parts)


def _number(text: str) -> str:
    """A number as TeX."""
    return text.replace("°", r"^\circ").replace("-", "\\mathrm{\u2013}", 1 if text.startswith("-") else 0)


def _neighbours(tokens: Sequence[Token], index: int) -> tuple[Token | None, Token | None]:
    """The token before and the token after."""
    return tokens[index - 1] if index > 0 else None, tokens[index + 1] if index + 1 < len(tokens) else None


def _spacing(text: str, before: Token | None, after: Token | None) -> str:
    """A space as TeX: wide where several were written, none beside an operator, which brings its own."""
    if before is None or after is None:
        return ""
    if len(text) > 1:
        return r"\quad "
    if before.text in _RELATIONS or after.text in _RELATIONS:
        return ""
    if {"word", "code", "unit"} & {before.kind, after.kind} or before.text in {":", ";"}:
        return r"\ "
    return r"\,"
