"""A sweep's rows as a file, and what they come to for each point."""

import csv
import io
from collections.abc import Sequence
from pathlib import Path
from statistics import mean, median
from typing import NamedTuple

from game.system.errors import BadInputError, EnvironmentMissingError
from game.system.files import write_atomically, write_text
from game.system.wording import quoted_path
from tools.sweep.play import Row

CSV, PARQUET = ".csv", ".parquet"


class PointSummary(NamedTuple):
    """The games at one point: of a level and a player, with the same speeds and friction.

    games: how many. cleared: share of them. seconds: median of those that were cleared; None where none was. loops: mean.
    impacts_per_tick: mean. longest_gap: median, seconds. lost: mean, lives.
    """

    level: str
    player: str
    top_speed: float
    friction: float
    ball_speed: float
    games: int
    cleared: float
    seconds: float | None
    loops: float
    impacts_per_tick: float
    longest_gap: float
    lost: float


def summaries(rows: Sequence[Row]) -> list[PointSummary]:
    """What the rows come to, in the order in which the points came."""
    points: dict[tuple[str, str, float, float, float], list[Row]] = {}
    for row in rows:
        points.setdefault((row.level, row.player, row.top_speed, row.friction, row.ball_speed), []).append(row)
    return [_summary(point, found) for point, found in points.items()]


def check_table(path: Path) -> None:
    """Refuse a file whose ending is none of a table's, or that cannot be written with what is installed."""
    if path.suffix not in {CSV, PARQUET}:
        raise BadInputError(f"--out {quoted_path(path)}: expected a name that ends in {CSV} or {PARQUET}")
    if path.suffix == PARQUET:
        _parquet()


def write_table(path: Path, rows: Sequence[Row]) -> None:
    """Write the rows, as the ending of the path asks for."""
    if path.suffix == CSV:
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(Row._fields)
        writer.writerows(rows)
        write_text(path, text.getvalue())
        return
    arrow, parquet = _parquet()
    table = arrow.table({name: [row[k] for row in rows] for k, name in enumerate(Row._fields)})
    data = io.BytesIO()
    parquet.write_table(table, data)
    try:
        write_atomically(path, data.getvalue())
    except OSError as error:
        raise BadInputError(f"{quoted_path(path)}: cannot be written; {error.strerror or error}") from None


def _parquet() -> tuple:  # type: ignore[type-arg]  # two modules
    """The library that writes Parquet."""
    try:
        import pyarrow  # noqa: ICN001, PLC0415  # an extra
        import pyarrow.parquet  # noqa: PLC0415
    except ImportError as error:
        wanted = "python -m pip install 'polar-breakout[table]', or write a .csv file"
        raise EnvironmentMissingError(f"Parquet needs pyarrow, which cannot be imported ({error}); {wanted}") from None
    return pyarrow, pyarrow.parquet


def _summary(point: tuple[str, str, float, float, float], rows: list[Row]) -> PointSummary:
    """What the rows of a point come to."""
    cleared = [row.seconds for row in rows if row.cleared]
    return PointSummary(
        *point,
        len(rows),
        len(cleared) / len(rows),
        median(cleared) if cleared else None,
        mean([row.loops for row in rows]),
        mean([row.impacts_per_tick for row in rows]),
        median([row.longest_gap for row in rows]),
        mean([row.lost for row in rows]),
    )
