"""The words of the report, for the terminal, the page and the JSON file alike."""

import math
from collections.abc import Iterator

from tools.crosscheck.games.sources import AIMED, AUTOPILOT, RANDOM, Source
from tools.crosscheck.results.findings import Findings
from tools.crosscheck.results.measurements import Comparison, Key, Measurement, Summary
from tools.crosscheck.run import RunResult

COMPARISON_NAMES = {
    Comparison.TARGET: "what was hit",
    Comparison.NORMAL_EXACT: "normal, exact shape",
    Comparison.NORMAL_FACETS: "normal, chain of chords",
    Comparison.PRESENCE_TICK: "presence every tick",
    Comparison.PRESENCE_HIT: "presence at contact",
    Comparison.TIME: "time of first touch",
    Comparison.BOUNCE: "bounce, no friction",
    Comparison.VELOCITY: "velocity after",
    Comparison.PHASE: "phase, rebuilt",
    Comparison.SET_FREE: "overlap after freeing",
    Comparison.TURN: "turn by position",
}
UNITS = {
    Comparison.TARGET: "wrong",
    Comparison.NORMAL_EXACT: "rad",
    Comparison.NORMAL_FACETS: "rad",
    Comparison.PRESENCE_TICK: "length",
    Comparison.PRESENCE_HIT: "length",
    Comparison.TIME: "s",
    Comparison.BOUNCE: "speed",
    Comparison.VELOCITY: "speed",
    Comparison.PHASE: "rad",
    Comparison.SET_FREE: "length",
    Comparison.TURN: "rad",
}
BOUNDS = {
    "same": "ring, slot, feature and layers must be the same",
    "noise": "rounding: 7e-15 R, for normals 7e-15 (R + r)/r; R: the ring's outer radius, r: the ball's radius "
    "(derived in tools/crosscheck/pymunk_model/rounding.py)",
    "facet": "d/2, d: the angle of a facet; on outer faces asin(R/(R + r) sin d/2)",
    "window": "the times of touch of a ball larger and of one smaller by the noise",
    "mirror": "2 |w| e: a normal off by e, its noise, turns w, the velocity relative to the surface, by 2e; and rounding",
    "turn": "rounding of three angles, 1e-12; 60 degrees more where the rules aim at a brick after a long wait",
    "grid": "half a step of the game's grid of angles, 2^-51, for every tick",
}
"""Where bounds come from, by the word in the table."""
TERMS = {
    "pose": "where a ball and the rings stand at one tick",
    "presence": "does the ball touch anything in a pose? Its error is the depth of an overlap, or the gap at a contact",
    "turn by position": "by how much the arcade rules turn a ball after a paddle's hit, against the level's number",
    "phase, rebuilt": "the rings' phases, against those computed again from the level and the recorded spins",
    "length, speed": "world units; world units per second",
    "wrong": "1 for a wrong answer, 0 for a right one",
}
"""What the words of the table mean."""

NOT_COMPARED = (
    "Not compared: what the rules do between ticks (a serve, a nudge, a lost ball, the score; a change of speed, width or "
    "bricks by the arcade rules, whose turn of a returned ball is compared). How the player's controls "
    "become the paddles' spin, which is taken as recorded. Where a ball that overlaps material should best be put: only that "
    "it overlapped before and is free after. The order of two balls' hits at one moment. Drawing and sound."
)


def bound_source(key: Key) -> str:
    """Where the bound of a row comes from: a word of BOUNDS."""
    comparison, feature = key
    if comparison == Comparison.NORMAL_FACETS:
        return "noise" if feature == "end" else "facet"
    return _SOURCES.get(comparison, "noise")


_LONG_RUN = 10.0
"""Seconds of comparing from which a rate is said."""
_SOURCES = {
    Comparison.TARGET: "same",
    Comparison.TIME: "window",
    Comparison.BOUNCE: "mirror",
    Comparison.VELOCITY: "mirror",
    Comparison.PHASE: "grid",
    Comparison.TURN: "turn",
}


def verdict(findings: Findings) -> str:
    """One line: do the two engines agree?"""
    result = findings.result
    rows = result.rows
    games = counted(result.games, "game")
    what = f"{rows.contacts:,} contacts, {rows.poses:,} poses in {games}"
    if rows.freed or rows.dropped:
        what += f"; {counted(rows.freed, 'ball')} put outside material, {rows.dropped:,} stopped, as pymunk confirms"
    partial = f"PARTIAL ({result.games} of {len(result.jobs)} games): " if result.partial else ""
    if rows.unexplained:
        return f"{partial}DISAGREE: {rows.unexplained:,} unexplained in {what}"
    if result.lost:
        return f"{partial}INCOMPLETE: {counted(len(result.lost), 'game')} lost; 0 unexplained in {what}"
    if not rows.contacts:
        return f"{partial}NOTHING COMPARED: no contact in {games}"
    if any(not one.holds for one in findings.sabotage or ()):
        missed = [one.mistake.name for one in findings.sabotage or () if not one.holds]
        return f"NOT CAUGHT: {', '.join(missed)}; 0 unexplained in {what}"
    if not result.partial and not findings.agrees:
        return f"DISAGREE: an error does not fall with the facets as it must; 0 unexplained in {what}"
    return f"{partial}AGREE: 0 unexplained in {what}{_caught(findings)}"


def _caught(findings: Findings) -> str:
    """How many mistakes were caught, where they were made."""
    if findings.sabotage is None:
        return ""
    caught = sum([one.caught for one in findings.sabotage])
    hidden = len(findings.sabotage) - caught
    return f"; {caught} of {len(findings.sabotage)} mistakes caught" + (f", {hidden} cannot show in a game" if hidden else "")


def repeat_command(measurement: Measurement) -> str:
    """The command that shows a measurement again, alone."""
    return f"python -m tools.crosscheck {measurement.situation.options} --tick {measurement.situation.tick}"


def summaries(result: RunResult) -> Iterator[tuple[Key, Summary]]:
    """The table's rows that have anything in them, in order."""
    for key in sorted(result.rows.samples, key=_row_order):
        summary = result.rows.samples[key].summary()
        if summary is not None:
            yield key, summary


def number(value: float) -> str:
    """Two digits of a measured value."""
    if math.isnan(value):
        return "-"
    return "0" if value == 0.0 else f"{value:.1e}"


def share(value: float) -> str:
    """How much of its bound an error takes, in percent."""
    if value > 10.0:
        return ">10x"
    return f"{100.0 * value:.1f}%" if value < 0.9995 or value > 1.0 else "99.9%"


def counted(count: int, noun: str) -> str:
    """A count with its noun."""
    return f"{count:,} {noun}{'' if count == 1 else 's'}"


def pace(result: RunResult) -> str:
    """How fast the comparisons were: a rate where they took long enough to have one."""
    contacts, seconds = result.rows.contacts, result.checking
    compared = (
        f"{contacts / seconds:,.0f} contacts compared per second of a core"
        if seconds >= _LONG_RUN
        else f"{counted(contacts, 'contact')} compared in {seconds:.2f} s"
    )
    return (
        f"{result.ticks:,} ticks; {compared}, presence at every tick included; "
        f"pymunk's models took {result.building:.1f} s, the games themselves {result.playing:.1f} s"
    )


_LISTED = 3


def compared_games(result: RunResult) -> str:
    """Which games were compared: each by its level, seed and player where they are few."""
    names = [_game_words(job.source) for job in result.jobs]
    return "compared: " + ("; ".join(names) if len(names) <= _LISTED else f"{len(names):,} games; --report names each")


def _game_words(source: Source) -> str:
    """One game: a replay's file, or level, seed and player, and the longest time."""
    if source.replay is not None:
        return source.replay
    by = f", {AUTOPILOT}" if source.player == AUTOPILOT and source.level not in {RANDOM, AIMED} else ""
    return f"{source.name}{by}, at most {source.ticks:,} ticks"


def _row_order(key: Key) -> tuple[int, int]:
    """The order of the table's rows."""
    return key[0], ("outer face", "inner face", "end", "corner", "anywhere").index(key[1])
