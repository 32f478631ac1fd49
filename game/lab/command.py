"""What `python -m game lab` does without a window: list the scenes, check them, draw one into a file."""

from collections import Counter
from pathlib import Path
from typing import Literal

from rich.console import Console
from rich.table import Table

from game.lab.kit.arena_level import ARENA, given_of
from game.lab.kit.second_engine import Engine
from game.lab.registry import chapters, scene_named, scenes
from game.lab.session.checks import Report, after_drags, lines, report
from game.lab.session.share import SharedScene, parsed, share_line
from game.lab.yours.answers import AnswerVerdict, OwnAnswer, own_answers
from game.lab.yours.calls import calls_of
from game.levels import load_file
from game.student.functions_file import FunctionsFile
from game.system.errors import BadInputError, CheckFailedError
from game.system.output import print_error, print_line
from game.system.wording import quoted_path

_SEED = 1
FILE_KINDS: tuple[Literal["png", "svg", "gif"], ...] = ("png", "svg", "gif")


def arena_line(path: Path) -> str:
    """The share line of an arena of one's own with a level's numbers; BadInputError for a file that is no level."""
    scene = scene_named(ARENA)
    return share_line(SharedScene(scene, given_of(load_file(path), scene.parameters)))


def list_scenes() -> None:
    """Print every scene's name, title, and the rows of the documentation's table "Beyond the source", chapter by chapter."""
    table = Table(box=None, pad_edge=False)
    for heading in ("scene", "title", 'rows of "Beyond the source"'):
        table.add_column(heading, no_wrap=heading == "scene")
    for chapter, chapter_scenes in chapters().items():
        table.add_section()
        table.add_row(f"-- {chapter}")
        for scene in chapter_scenes:
            table.add_row(scene.name, scene.title, ", ".join([str(row) for row in scene.rows]))
    Console().print(table)
    print_line('"Beyond the source" is a table in docs/algorithm.md')


def check_scenes(line: str | None, drags: int, engine: Engine | None) -> None:
    """Check the claims of every scene at its defaults, its presets and after random drags, and print a row for each scene.

    line: a share line, to check only that scene, at those values too. drags: how many random ones for each scene.
    CheckFailedError after the last scene, when a claim has failed.
    """
    named = None if line is None else parsed(line, engine)
    chosen = [(scene, ()) for scene in scenes()] if named is None else [(named.scene, (named.given,))]
    table = Table(box=None, pad_edge=False)
    for heading in ("scene", "settings", "claims", "failed"):
        table.add_column(heading, justify="left" if heading == "scene" else "right")
    reports = [report(scene, drags, _SEED, engine, more) for scene, more in chosen]
    for one in reports:
        table.add_row(one.scene.name, f"{one.settings:,}", f"{one.claims:,}", f"{len(one.failures):,}")
    Console().print(table)
    _raise_failures(reports)


def check_yours(line: str | None, drags: int, functions: FunctionsFile) -> None:
    """Ask the player's functions what each scene asks at its defaults, its presets and after random drags; a row for each.

    The arguments are those of `check_scenes`. CheckFailedError after the last scene, when an answer is neither ours nor the
    slides', or the file has failed.
    """
    table = Table(box=None, pad_edge=False)
    for heading in ("scene", "answers", *[verdict.value for verdict in AnswerVerdict]):
        table.add_column(heading, justify="left" if heading == "scene" else "right")
    named = None if line is None else parsed(line)
    found: list[tuple[SharedScene, OwnAnswer]] = []
    for scene in [scene for scene in scenes() if named is None or scene is named.scene]:
        more = () if named is None else (named.given,)
        answers = [
            (SharedScene(scene, given), one)
            for given in [*lines(scene), *more, *after_drags(scene, drags, _SEED)]
            for one in own_answers(functions, calls_of(scene.name, given))
        ]
        counts = Counter([one.verdict for _, one in answers])
        if answers:
            table.add_row(scene.name, f"{len(answers):,}", *[f"{counts[verdict]:,}" for verdict in AnswerVerdict])
        found += [answer for answer in answers if answer[1].verdict is AnswerVerdict.DIFFERS]
    Console().print(table)
    first = {one.call.function: (shared, one) for shared, one in reversed(found)}
    for shared, one in first.values():
        why = one.problem or f"yours {one.yours}, ours {one.ours}"
        print_error(f'polar-breakout: {one.call.function}: {why}: python -m game lab "{share_line(shared)}"')
    functions.check()
    if found:
        raise CheckFailedError(f"lab: {len(found):,} answers of {functions.name} differ")


def save_picture(
    line: str | None,
    path: Path,
    size: tuple[int, int],
    theme: str,
    engine: Engine | None,
    functions: FunctionsFile | None = None,
    *,
    presents: bool = False,
) -> None:
    """Draw a scene into a PNG file and say where it is; BadInputError where it cannot be written.

    presents: whether it is drawn as for a lecture room.
    """
    from game.lab.window.screenshot import save_screenshot  # noqa: PLC0415  # pygame, only where it is needed

    shared = parsed(scenes()[0].name if line is None else line, engine)
    try:
        save_screenshot(shared, path, size, theme, functions, presents=presents)
    except OSError as error:
        raise BadInputError(f"--screenshot {quoted_path(path)}: cannot write; {error.strerror or error}") from None
    print_line(f"picture: {path.absolute()}")


def export(line: str | None, folder: Path, kind: str, size: tuple[int, int], theme: str, *, steps: bool) -> None:
    """Write pictures of every scene, or of one, into a folder, and say how many; BadInputError where they cannot be written.

    line: a share line; None for every scene. kind: png, svg, gif or all. steps: whether each is a file of its own, too.
    """
    from game.lab.export.folder import ExportWish, export_scenes  # noqa: PLC0415  # pygame, only where it is needed

    shared = [parsed(scene.name) for scene in scenes()] if line is None else [parsed(line)]
    kinds = tuple([one for one in FILE_KINDS if kind in {one, "all"}])
    files = export_scenes(shared, folder, ExportWish(kinds, size, theme, steps))
    print_line(f"{len(files)} pictures in {folder.absolute()}")


def _raise_failures(reports: list[Report]) -> None:
    """Name the first failures of each scene on stderr, then raise CheckFailedError, if there are any."""
    failed = [one for one in reports if one.failures]
    for one in failed:
        for failure in one.failures[:3]:
            print_error(f'polar-breakout: "{failure.fact}" does not hold: python -m game lab "{failure.line}"')
    if failed:
        raise CheckFailedError(f"lab: {len(failed)} of {len(reports)} scenes failed")
