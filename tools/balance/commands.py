"""The options of the measurement: `python -m tools.balance`."""

from collections.abc import Callable
from contextlib import closing
from pathlib import Path
from typing import Annotated, Literal

import typer
from rich.console import Console
from rich.progress import Progress
from rich.table import Table

from game.generated import SEQUENCE, sequence
from game.levels import Level, campaign, chosen
from game.rules import Difficulty, Ruleset
from game.system.errors import BadInputError
from game.system.files import check_target, read_input, write_text
from game.system.output import print_line
from game.system.wording import quoted, quoted_path
from tools.balance.games_file import Known, known_game, save_games, saved_games
from tools.balance.human import Skill
from tools.balance.page import has_table, with_table
from tools.balance.players import parsed_seeds, parsed_skills, player_name
from tools.balance.trial import Trial, TrialJob, TrialSummary, played, summary
from tools.executor import Where, results, sure
from tools.executor.options import ClusterOption, WorkersOption, where

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)

_PLAYERS = "150/2,220/5,300/10"
_LARGEST_PAGE = 1024 * 1024


@app.command()
def balance(
    context: typer.Context,
    level: Annotated[
        list[str] | None,
        typer.Option(help="A level: its number, its name or a TOML file; again for more. Default: the campaign."),
    ] = None,
    endless: Annotated[int | None, typer.Option(min=0, max=2**63 - 1, help="Play the levels made from this seed.")] = None,
    count: Annotated[int, typer.Option(min=1, max=SEQUENCE, help="How many of the levels made from a seed.")] = 50,
    players: Annotated[
        str,
        typer.Option(
            metavar="MS/DEG,...",
            help="Simulated humans: reaction in ms / error of the aim in degrees; `autopilot` is one, too.",
        ),
    ] = _PLAYERS,
    difficulty: Annotated[Literal["easy", "normal", "hard"], typer.Option(help="Of the arcade rules.")] = "normal",
    seeds: Annotated[
        str, typer.Option(metavar="N,...", help="Games of every player in every level, or one number for each player.")
    ] = "5",
    workers: WorkersOption = 1,
    cluster: ClusterOption = None,
    known: Annotated[
        Path | None,
        typer.Option(help="A JSON file of games by the same rules: those of unchanged levels are not played again."),
    ] = None,
    json: Annotated[Path | None, typer.Option(help="Write every game into this JSON file.")] = None,
    page: Annotated[Path | None, typer.Option(help="Put the results into the table of this Markdown file.")] = None,
) -> None:
    """Let simulated humans with endless lives play the levels, and print what they lose and how long they take."""
    check_target(json, "--json", ".json")
    check_target(page, "--page", ".md")
    text = None if page is None else _page_text(page)
    levels, skills = _levels(level, endless, count), parsed_skills(players)
    numbers, ruleset = parsed_seeds(seeds, len(skills)), Ruleset(Difficulty[difficulty.upper()])
    games = saved_games(known) if known is not None else {}
    jobs = [
        TrialJob(one, skill, seed, ruleset)
        for one in levels
        for skill, number in zip(skills, numbers, strict=True)
        for seed in range(number)
    ]
    trials: list[Trial] = []
    try:
        _play(jobs, games, where(context, workers, cluster), trials.append)
    finally:  # after Ctrl-C too: what was played is told
        _print(levels, skills, trials)
        if json is not None:
            save_games(trials, levels, json)
    if page is not None and text is not None:
        write_text(page, with_table(text, levels, skills, trials))


def _levels(names: list[str] | None, endless: int | None, count: int) -> tuple[Level, ...]:
    """The levels that the options ask for."""
    if endless is not None and names is not None:
        raise BadInputError("--level and --endless: choose one of them")
    if endless is not None:
        return sequence(endless, count)
    if names is None:
        return campaign()
    levels = tuple([chosen(name)[0] for name in names])
    for number, level in enumerate(levels):
        if level.name in [before.name for before in levels[:number]]:  # names tell the games apart
            raise BadInputError(f"--level: two levels are called {quoted(level.name)}")
    return levels


def _page_text(path: Path) -> str:
    """The text of a page with a table of levels; BadInputError for any other file, before a game is played."""
    try:
        text = read_input(path, "page", _LARGEST_PAGE).decode()
    except UnicodeDecodeError as error:
        raise BadInputError(f"{quoted_path(path)}: not UTF-8 at byte {error.start}") from None
    if not has_table(text):
        raise BadInputError(f"{quoted_path(path)}: no table of levels; expected a line that begins with | 1")
    return text


def _play(jobs: list[TrialJob], known: Known, executor: Where, told: Callable[[Trial], None]) -> None:
    """Play the games that are not known; `told` is given every game."""
    console = Console(stderr=True)
    for job in jobs:
        if (game := known_game(known, job)) is not None:
            told(game)
    unknown = [job for job in jobs if known_game(known, job) is None]
    with (
        Progress(console=console, transient=True, disable=not console.is_terminal) as bar,
        closing(sure(results(played, unknown, executor))) as answers,
    ):
        task = bar.add_task("games", total=len(unknown))
        for answer in answers:
            told(answer)
            bar.advance(task)


def _print(levels: tuple[Level, ...], skills: tuple[Skill | None, ...], trials: list[Trial]) -> None:
    """A line for every level and player of whom there are games, and one for each player's whole campaign."""
    table = Table(box=None, pad_edge=False)
    for heading in ("level", "player", "games", "cleared", "lives lost", "seconds", "longest gap", "given up", "score"):
        table.add_column(heading, justify="left" if heading in {"level", "player"} else "right")
    whole: dict[Skill | None, list[TrialSummary]] = {skill: [] for skill in skills}
    for level in levels:
        for skill in skills:
            found = [trial for trial in trials if trial.level == level.name and trial.skill == skill]
            if found:
                whole[skill].append(summary(found))
                _add(table, level.name, skill, whole[skill][-1])
    for skill, parts in whole.items():
        if len(parts) > 1:
            lost, seconds = sum([part.lost for part in parts]), sum([part.seconds for part in parts])
            table.add_row("all of them", player_name(skill), "", "", f"{lost:.1f}", f"{seconds:.0f}", "", "", "")
    if trials:
        Console(width=120).print(table)
    else:
        print_line("no game was played to its end")


def _add(table: Table, name: str, skill: Skill | None, part: TrialSummary) -> None:
    """One line of the table."""
    table.add_row(
        name,
        player_name(skill),
        str(part.games),
        f"{part.cleared:.0%}",
        f"{part.lost:.1f} ± {part.error:.1f}",
        f"{part.seconds:.0f}",
        f"{part.longest_gap:.1f}",
        f"{part.given_up:.1f}",
        f"{part.score:,.0f}",
    )
