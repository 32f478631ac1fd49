"""The translations beside the texts in the code: what is missing, what is left over, what has other placeholders.

`python -m tools.translations` says so and exits with 1; with `--update`, texts that are new are added to the .po files without
a translation, and those that are gone are taken out.
"""

import ast
import string
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Annotated, NamedTuple

import polib
import typer

from game.language import ENGLISH, LANGUAGES
from game.levels import built_in
from game.system.errors import CheckFailedError
from game.system.output import print_line

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "game" / "languages"
TEMPLATES = frozenset({"tr", "tr_noop", "ntr"})
"""The functions of game.language whose arguments are texts."""

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)


class Text(NamedTuple):
    """A text of the game. many: the same for a count other than 1; empty for a text without a count."""

    one: str
    many: str = ""


def texts(folder: Path = ROOT / "game") -> dict[Text, str]:
    """Every text in the code of a folder and in the built-in levels, in that order, with the file where it is first.

    Raises CheckFailedError for a text that is put together before it is translated.
    """
    found: dict[Text, str] = {}
    for path in sorted(folder.rglob("*.py")):
        for text in _texts_in(path):
            found.setdefault(text, path.relative_to(folder.parent).as_posix())
    for level in built_in():
        for message in (level.name, level.description, level.chapter):
            found.setdefault(Text(message), "game/levels")
    return found


def problems(wanted: Iterable[Text], catalogue: Iterable[polib.POEntry], forms: int) -> list[str]:
    """What is wrong with a catalogue, a line each. forms: of a plural in its language."""
    found = []
    entries = {Text(entry.msgid, entry.msgid_plural): entry for entry in catalogue if not entry.obsolete}
    wanted = set(wanted)
    found += [f"missing: {text.one!r}" for text in sorted(wanted - set(entries))]
    found += [f"not in the code any more: {text.one!r}" for text in sorted(set(entries) - wanted)]
    for text, entry in entries.items():
        translated = list(entry.msgstr_plural.values()) if text.many else [entry.msgstr]
        if not all(translated) or entry.fuzzy or (text.many and len(translated) != forms):
            found.append(f"not translated: {text.one!r}")
        else:
            found += [f"other placeholders or edges: {text.one!r}: {one!r}" for one in translated if not _alike(text, one)]
    return found


def _alike(text: Text, translated: str) -> bool:
    """Whether a translation has the placeholders of a text, and its spaces and line ends at both ends."""
    names, theirs = (_placeholders(text.many or text.one), _placeholders(translated))
    fits = theirs <= names if text.many else theirs == names  # "one life left" may do without the number
    edges = [part[: len(part) - len(part.lstrip())] + part[len(part.rstrip()) :] for part in (text.one, translated)]
    return fits and edges[0] == edges[1]


def _placeholders(text: str) -> set[str]:
    """The names in braces, with their formats."""
    return {f"{name}:{form}" for _, name, form, _ in string.Formatter().parse(text) if name is not None}


def _texts_in(path: Path) -> Iterator[Text]:
    """The texts in a file, from its top down."""
    text = path.read_text(encoding="utf-8")
    if "game.language" not in text:
        return
    calls = [node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Call)]
    for call in sorted(calls, key=lambda call: (call.lineno, call.col_offset)):
        if not (isinstance(call.func, ast.Name) and call.func.id in TEMPLATES):
            continue
        arguments = call.args[: 2 if call.func.id == "ntr" else 1]
        constants = [one.value for one in arguments if isinstance(one, ast.Constant) and isinstance(one.value, str)]
        if len(constants) == len(arguments):
            yield Text(*constants)
        elif call.func.id != "tr" or any([isinstance(one, ast.JoinedStr | ast.BinOp) for one in arguments]):
            raise CheckFailedError(f"{path}:{call.lineno}: a text is put together before it is translated")


def _updated(catalogue: polib.POFile, wanted: dict[Text, str]) -> polib.POFile:
    """The catalogue with exactly the texts that are wanted, in their order; what was translated stays so."""
    known = {Text(entry.msgid, entry.msgid_plural): entry for entry in catalogue}
    updated = polib.POFile(wrapwidth=100)
    updated.header, updated.metadata = catalogue.header, catalogue.metadata
    for text, file in wanted.items():
        entry = known.get(text)
        if entry is None:
            entry = polib.POEntry(msgid=text.one, msgid_plural=text.many)
            if text.many:
                entry.msgstr_plural = dict.fromkeys(range(_forms(catalogue)), "")
        entry.occurrences = [(file, "")]
        updated.append(entry)
    return updated


def _forms(catalogue: polib.POFile) -> int:
    """How many forms a plural has in the catalogue's language."""
    return int(catalogue.metadata["Plural-Forms"].partition("nplurals=")[2].partition(";")[0])


@app.command()
def check(
    *, update: Annotated[bool, typer.Option("--update", help="Add texts that are new, take out those that are gone.")] = False
) -> None:
    """Compare the translations with the texts of the game."""
    wanted, wrong = texts(), 0
    for language in LANGUAGES:
        if language is ENGLISH:
            continue
        path = FOLDER / f"{language.code}.po"
        catalogue = polib.pofile(str(path))
        if update:
            catalogue = _updated(catalogue, wanted)
            catalogue.save(str(path))
        lines = problems(wanted, catalogue, _forms(catalogue))
        wrong += len(lines)
        print_line(f"{language.name}: {len(wanted)} texts, {len(lines)} problems")
        for line in lines:
            print_line(f"  {line}")
    if wrong:
        raise CheckFailedError(f"{wrong} problems in game/languages")
