"""A sweep as a picture: what each axis does to each level."""

import io
import itertools
from collections.abc import Sequence
from statistics import mean

from matplotlib.figure import Figure

from tools.sweep.table import PointSummary

_AXES = {"top_speed": "paddles' top speed, x the level's", "friction": "friction", "ball_speed": "ball's speed, x the level's"}
_MEASURES = {"cleared": "cleared", "seconds": "s to clear", "loops": "loops a game", "impacts_per_tick": "impacts a tick"}
_STYLES, _COLOURS = ("-", "--", ":", "-."), 10
"""Of lines: for players, and how many for levels."""
_BINS = 8
"""Groups of an axis with more values than that: a random sample."""


def plot(points: Sequence[PointSummary]) -> bytes:
    """A PNG: a column for each axis that was varied, a row for each measure, a line for each level and player."""
    axes = [axis for axis in _AXES if _is_varied(points, axis)] or [*_AXES][:1]
    figure = Figure(figsize=(2.5 + 4.0 * len(axes), 2.4 * len(_MEASURES)), layout="constrained")
    panels = figure.subplots(len(_MEASURES), len(axes), sharex="col", sharey="row", squeeze=False)
    levels, players = (list(dict.fromkeys([point[k] for point in points])) for k in (0, 1))
    for column, axis in enumerate(axes):
        for row, (measure, named) in enumerate(_MEASURES.items()):
            panel = panels[row][column]
            for level, player in itertools.product(levels, players):
                found = [point for point in points if point[:2] == (level, player) and getattr(point, measure) is not None]
                xs, ys = _line([(getattr(point, axis), getattr(point, measure)) for point in found])
                style = _STYLES[players.index(player) % len(_STYLES)]
                colour = f"C{levels.index(level) % _COLOURS}"
                panel.plot(xs, ys, style, color=colour, marker="o", markersize=3, label=f"{level}, {player}")
            panel.grid(alpha=0.3)
            panel.set_ylim(bottom=0.0)
            if column == 0:
                panel.set_ylabel(named)
        panels[-1][column].set_xlabel(_AXES[axis])
    handles, names = panels[0][0].get_legend_handles_labels()
    figure.legend(handles, names, loc="outside right upper", fontsize="small")
    data = io.BytesIO()
    figure.savefig(data, format="png", dpi=120)
    return data.getvalue()


def _is_varied(points: Sequence[PointSummary], axis: str) -> bool:
    """Whether a level was played with more than one value of an axis."""
    values: dict[str, set[float]] = {}
    for point in points:
        values.setdefault(point.level, set()).add(getattr(point, axis))
    return any([len(found) > 1 for found in values.values()])


def _line(points: list[tuple[float, float]]) -> tuple[list[float], list[float]]:
    """The means of what has the same x, or, of many x, of what is in the same part of the axis."""
    groups: dict[float, list[float]] = {}
    values = {x for x, _ in points}
    least, most = min(values, default=0.0), max(values, default=0.0)
    width = (most - least) / _BINS
    for x, y in points:
        place = x if len(values) <= _BINS else least + (min(int((x - least) / width), _BINS - 1) + 0.5) * width
        groups.setdefault(place, []).append(y)
    xs = sorted(groups)
    return xs, [mean(groups[x]) for x in xs]
