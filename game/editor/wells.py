"""The editor's commands for gravity wells: choose, add, move, remove."""

import cmath
import math

import msgspec

from game.editor.document import Path, Value, well_added, well_removed, with_values
from game.editor.history import EditHistory
from game.editor.session import EditorSession, after
from game.levels import Level, WellSpec
from game.system.errors import BadInputError

_DISTANCE, _REACH, _PULL = 0.5, 0.22, 0.4
"""Of the first well: distance and reach in ground radii, and share of the strongest pull that the reach allows at the speed."""
_NEXT = 120.0
"""Degrees from a well to its copy if strokes are not repeated around the ring."""
_SNAP = 2
"""Decimals of distances and angles that were not typed."""


def chosen_well(session: EditorSession, offset: int) -> EditorSession:
    """The session with the well chosen that is `offset` after the chosen one; the first follows the last."""
    count = len(session.document.level.wells)
    return session._replace(well=(session.well + offset) % count, message="") if count else session


def position_of(well: WellSpec) -> complex:
    """The position of a well."""
    return cmath.rect(well.distance, math.radians(well.angle))


def with_well_added(session: EditorSession, at: complex | None = None) -> EditorSession:
    """The session with a copy of the chosen well added and chosen. at: its position; None for one beside the chosen well."""
    wells, turn = session.document.level.wells, _NEXT
    if session.symmetry.fold > 1:
        turn = 360.0 / session.symmetry.fold
    well = _first(session.document.level)
    if wells:
        like = wells[session.well]
        well = msgspec.structs.replace(like, angle=_angle(like.angle + turn))
    if at is not None:
        well = msgspec.structs.replace(well, **dict(zip(("distance", "angle"), _polar(at), strict=True)))
    try:
        return after(session, well_added(session.document, well))._replace(well=len(wells))
    except BadInputError as error:
        return session._replace(message=str(error))


def with_well_removed(session: EditorSession) -> EditorSession:
    """The session without the chosen well; the well before it is chosen."""
    if not session.document.level.wells:
        return session
    removed = after(session, well_removed(session.document, session.well))
    return removed._replace(well=max(session.well - 1, 0))


def with_well_at(session: EditorSession, at: complex, before: EditHistory | None = None) -> EditorSession:
    """The session with the chosen well moved to a position. before: as in `stroked`."""
    path: Path = ("wells", session.well)
    distance, angle = _polar(at)
    values: dict[Path, Value] = {(*path, "distance"): distance, (*path, "angle"): angle}
    document = with_values(session.document, values)
    return session._replace(history=(before or session.history).changed(document), message="")


def _first(level: Level) -> WellSpec:
    """The well that is added to a level without wells."""
    reach = round(_REACH * level.ground_radius, _SNAP)
    strength = round(_PULL * level.ball.speed * level.ball.speed / reach, _SNAP)
    return WellSpec(round(_DISTANCE * level.ground_radius, _SNAP), strength, reach, 90.0)


def _polar(at: complex) -> tuple[float, float]:
    """Distance and angle of a point, as in a level file."""
    return round(abs(at), _SNAP), round(_angle(math.degrees(cmath.phase(at))), _SNAP)


def _angle(degrees: float) -> float:
    """An angle reduced to 0 to below 360 degrees."""
    return degrees % 360.0
