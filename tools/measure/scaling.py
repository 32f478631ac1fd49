"""What a ball-step costs against the number of bricks and of balls, as a picture: `python -m tools.bench --plot FILE`."""

import io
from dataclasses import dataclass, field
from statistics import median

from matplotlib.figure import Figure

from tools.measure.contenders import Play, facets, plain, pymunk_play
from tools.measure.many_games import many_balls, many_bricks, missing
from tools.measure.standard_arena import arena

BRICKS_A_ROW = (4, 16, 64, 256, 1024, 4000)
BALLS = (1, 2, 4, 8, 16)
_PYMUNK_BALLS = (1, 10, 100)


@dataclass
class ScalingCurve:
    """One line of the picture: a contender, the numbers along the axis, and the costs found."""

    name: str
    numbers: tuple[int, ...]
    plays: list[Play]
    costs: list[list[float]] = field(default_factory=list)


def scaling_plot(rounds: int, ticks: int) -> bytes:
    """A PNG; the costs are medians of rounds, in which all points of both panels take turns."""
    bricks = [ScalingCurve("physics.advance", tuple([3 * n for n in BRICKS_A_ROW]), [Play("", plain(n)) for n in BRICKS_A_ROW])]
    balls = [
        ScalingCurve(
            "pymunk, one space", _PYMUNK_BALLS, [Play("", pymunk_play(facets, n, turning=False), n) for n in _PYMUNK_BALLS]
        )
    ]
    if missing() is None:
        bricks.append(ScalingCurve("physics.batch, 256 games", bricks[0].numbers, [many_bricks(n) for n in BRICKS_A_ROW]))
        balls.append(ScalingCurve("physics.batch, 256 games, balls a game", BALLS, [many_balls(n) for n in BALLS]))
    for curve in bricks + balls:
        curve.costs = [[] for _ in curve.plays]
    for _ in range(rounds):
        for curve in bricks + balls:
            for play, found in zip(curve.plays, curve.costs, strict=True):
                start = play.clock()
                aside = play.run(ticks) or 0.0
                found.append((play.clock() - start - aside) / (ticks * play.balls) * 1e9)
    figure = Figure(figsize=(11.0, 4.5), layout="constrained")
    for panel, label, curves in zip(figure.subplots(1, 2), ("bricks", "balls"), (bricks, balls), strict=True):
        for curve in curves:
            panel.plot(curve.numbers, [median(found) for found in curve.costs], marker="o", label=curve.name)
        panel.set(xscale="log", yscale="log", xlabel=label, ylabel="ns a ball-step")
        panel.grid(alpha=0.3, which="both")
        panel.legend(fontsize="small")
    assert sum([ring.count for ring in arena(BRICKS_A_ROW[-1]).rings[1:]]) == bricks[0].numbers[-1]
    data = io.BytesIO()
    figure.savefig(data, format="png", dpi=120)
    return data.getvalue()
