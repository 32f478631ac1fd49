"""The options of the measurement: `python -m tools.balance`."""

from contextlib import closing
from pathlib import Path
from typing import Annotated, Literal

import msgspec
import typer
from rich.console import Console
from rich.progress import Progress
from rich.table import Table

from game.levels import Level, campaign, chosen
from game.rules import Difficulty, Ruleset
from game.system.errors import BadInputError
from game.system.files import check_target, write_text
from game.system.output import tell
from game.system.wording import quoted
from tools.balance.human import Skill
from tools.balance.trial import Job, Summary, Trial, played, summary
from tools.executor import results, sure
from tools.executor.options import ClusterOption, WorkersOption, where

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)

_PLAYERS = "150/2,220/5,300/10"
_FASTEST, _SLOWEST, _WILDEST = 0, 2000, 90.0
"""Limits of a player: reaction in ms, error in degrees."""


@app.command()
def balance(
    context: typer.Context,
    level: Annotated[
        list[str] | None,
        typer.Option(help="A level: its number, its name or a TOML file; again for more. Default: the campaign."),
    ] = None,
    players: Annotated[
        str, typer.Option(metavar="MS/DEG,...", help="Simulated humans: reaction in ms / error of the aim in degrees.")
    ] = _PLAYERS,
    difficulty: Annotated[Literal["easy", "normal", "hard"], typer.Option(help="Of the arcade rules.")] = "normal",
    seeds: Annotated[int, typer.Option(min=1, max=10**4, help="Games of every player in every level.")] = 5,
    workers: WorkersOption = 1,
    cluster: ClusterOption = None,
    json: Annotated[Path | None, typer.Option(help="Write every game into this JSON file.")] = None,
) -> None:
    """Let simulated humans with endless lives play the levels, and print what they lose and how long they take."""
    check_target(json, "--json", ".json")
    levels = campaign() if level is None else tuple([chosen(name)[0] for name in level])
    skills, ruleset = parsed_skills(players), Ruleset(Difficulty[difficulty.upper()])
    jobs = [Job(one, skill, seed, ruleset) for one in levels for skill in skills for seed in range(seeds)]
    trials: list[Trial] = []
    console = Console(stderr=True)
    try:
        with (
            Progress(console=console, transient=True, disable=not console.is_terminal) as bar,
            closing(sure(results(played, jobs, where(context, workers, cluster)))) as answers,
        ):
            task = bar.add_task("games", total=len(jobs))
            for answer in answers:
                trials.append(answer)
                bar.update(task, completed=len(trials))
    finally:  # after Ctrl-C too: what was played is told
        _print(levels, skills, trials)
        if json is not None:
            hashes = {one.name: one.content_hash()[:16] for one in levels}
            games = [{**trial._asdict(), "skill": trial.skill._asdict(), "level_hash": hashes[trial.level]} for trial in trials]
            write_text(json, msgspec.json.format(msgspec.json.encode(games), indent=1).decode() + "\n")


def parsed_skills(text: str) -> tuple[Skill, ...]:
    """The players that an option names; BadInputError for anything else than MS/DEG pairs in range."""
    skills = []
    for pair in text.split(","):
        milliseconds, _, degrees = pair.partition("/")
        try:
            reaction, noise = float(milliseconds), float(degrees)
        except ValueError:
            reaction = noise = -1.0
        if not (_FASTEST <= reaction <= _SLOWEST and 0.0 <= noise <= _WILDEST):
            raise BadInputError(
                f"--players {quoted(pair)}: expected MS/DEG, as in 220/5; up to {_SLOWEST} ms, {_WILDEST:g} degrees"
            )
        skills.append(Skill(reaction / 1000.0, noise))
    return tuple(skills)


def _print(levels: tuple[Level, ...], skills: tuple[Skill, ...], trials: list[Trial]) -> None:
    """A line for every level and player of whom there are games, and one for each player's whole campaign."""
    table = Table(box=None, pad_edge=False)
    for heading in ("level", "player", "games", "cleared", "lives lost", "seconds", "longest gap", "given up", "score"):
        table.add_column(heading, justify="left" if heading in {"level", "player"} else "right")
    whole: dict[Skill, list[Summary]] = {skill: [] for skill in skills}
    for level in levels:
        for skill in skills:
            found = [trial for trial in trials if trial.level == level.name and trial.skill == skill]
            if found:
                whole[skill].append(summary(found))
                _add(table, level.name, skill, whole[skill][-1])
    for skill, parts in whole.items():
        if len(parts) > 1:
            lost, seconds = sum([part.lost for part in parts]), sum([part.seconds for part in parts])
            name = f"{skill.reaction * 1000.0:g} ms, {skill.noise:g} deg"
            table.add_row("all of them", name, "", "", f"{lost:.1f}", f"{seconds:.0f}", "", "", "")
    if trials:
        Console(width=120).print(table)
    else:
        tell("no game was played to its end")


def _add(table: Table, name: str, skill: Skill, part: Summary) -> None:
    """One line of the table."""
    table.add_row(
        name,
        f"{skill.reaction * 1000.0:g} ms, {skill.noise:g} deg",
        str(part.games),
        f"{part.cleared:.0%}",
        f"{part.lost:.1f}",
        f"{part.seconds:.0f}",
        f"{part.longest_gap:.1f}",
        f"{part.given_up:.1f}",
        f"{part.score:,.0f}",
    )
