"""What the mouse does in the arena, by the part of the panel that is shown: paint bricks, move rings, or place wells."""

import math
from typing import NamedTuple

from game.editor import session as editing
from game.editor.document import Stack
from game.editor.fields import RING_FIELDS, PanelPart
from game.editor.history import EditHistory
from game.editor.session import EditorSession
from game.editor.wells import position_of, with_well_added, with_well_at, with_well_removed
from game.levels import Level

ERASER = Stack(0)
"""The stack that the right button paints."""
_RADIUS = next(field for field in RING_FIELDS if field.key == "radius")
_CATCH = 0.04
"""Greatest distance of a press from a well's centre that drags the well, in ground radii."""
_SNAP = 0.05
"""A ring's radius and a well's position are multiples of it while they are dragged, world units of ground radius 10."""


class EditorDrag(NamedTuple):
    """What the mouse, or a held key, does until it is released.

    part: of the panel, which decides what is dragged. before: the history at its beginning. stack: what is painted. offset:
    from the ring's radius, or the well's position, to the mouse.
    """

    part: PanelPart
    before: EditHistory
    stack: Stack | None = None
    offset: complex = 0j


def slot_at(level: Level, point: complex) -> tuple[int, int] | None:
    """Ring and slot at a point of the world; None if no ring is there. Gaps between sectors belong to the nearer slot."""
    distance, angle = abs(point), math.degrees(math.atan2(point.imag, point.real))
    for index, ring in enumerate(level.rings):
        if abs(distance - ring.radius) <= ring.half_width:
            return index, round((angle - ring.phase) * ring.count / 360.0) % ring.count
    return None


def well_near(level: Level, point: complex) -> int | None:
    """Index of the gravity well whose centre is at a point of the world; None if there is none."""
    near = [(abs(position_of(well) - point), index) for index, well in enumerate(level.wells)]
    distance, index = min(near, default=(math.inf, 0))
    return index if distance <= _CATCH * level.ground_radius else None


def pressed(
    session: EditorSession, part: PanelPart, point: complex, *, erases: bool
) -> tuple[EditorSession, EditorDrag | None]:
    """The session after a press at a point of the world, and the drag that begins. erases: whether by the right button."""
    if part is PanelPart.WELLS:
        return _well_pressed(session, point, erases=erases)
    at = slot_at(session.document.level, point)
    if part is PanelPart.RING:
        if at is None or erases:
            return session, None
        session = editing.with_ring(session, at[0])._replace(slot=at[1])
        offset = abs(point) - session.document.level.rings[at[0]].radius
        return session, EditorDrag(part, session.history, offset=complex(offset))
    drag = EditorDrag(PanelPart.BRICKS, session.history, ERASER if erases else session.brush)
    return dragged(session, drag, point), drag


def dragged(session: EditorSession, drag: EditorDrag, point: complex) -> EditorSession:
    """The session after a drag to a point of the world."""
    unit = _SNAP * session.document.level.ground_radius / 10.0
    if drag.part is PanelPart.WELLS:
        moved = point - drag.offset
        snapped = complex(_multiple(moved.real, unit), _multiple(moved.imag, unit))
        return with_well_at(session, snapped, drag.before)
    if drag.part is PanelPart.RING:
        radius = _multiple(abs(point) - drag.offset.real, unit)
        moved_ring = editing.entered(session, _RADIUS, max(radius, unit))
        return moved_ring._replace(history=drag.before.changed(moved_ring.document))
    at = slot_at(session.document.level, point)
    return session if at is None else editing.stroked(session, *at, stack=drag.stack, before=drag.before)


def _well_pressed(session: EditorSession, point: complex, *, erases: bool) -> tuple[EditorSession, EditorDrag | None]:
    """Begin to drag a well, remove it with the right button, or add one if there is none at the point."""
    index = well_near(session.document.level, point)
    if index is not None:
        session = session._replace(well=index, message="")
        if erases:
            return with_well_removed(session), None
        return session, EditorDrag(
            PanelPart.WELLS, session.history, offset=point - position_of(session.document.level.wells[index])
        )
    if erases or abs(point) > session.document.level.ground_radius:
        return session, None
    added = with_well_added(session, point)
    return added, None if added.message else EditorDrag(PanelPart.WELLS, session.history)


def _multiple(number: float, unit: float) -> float:
    """The multiple of `unit` nearest to a number."""
    return round(number / unit) * unit
