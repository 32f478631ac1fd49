"""What the editor knows: the documents, the chosen ring, the brush. Pure; the window draws it and sends it commands."""

import math
from typing import Any, NamedTuple

import msgspec

from game.editor.document import (
    Document,
    Path,
    Stack,
    Value,
    opened,
    painted,
    ring_added,
    ring_removed,
    value_at,
    with_count,
    with_value,
)
from game.editor.fields import Field, is_whole, named, range_of
from game.editor.history import EditHistory
from game.editor.symmetry import Symmetry, images
from game.language import tr
from game.rules.speed import USUAL_TOP
from game.system.errors import BadInputError
from physics import PERMANENT

_APART = 0.05
"""World units of ground radius 10 that a new ring leaves to its neighbour; a ball need not fit between."""
BRUSH = Stack(1)
"""The brush that the editor begins with."""


class EditorSession(NamedTuple):
    """The state of the editor.

    history: of documents.
    ring: index of the chosen ring. slot: the cursor's slot on that ring. well: index of the chosen gravity well.
    brush: what a stroke paints. symmetry: of a stroke.
    message: why the last command failed; "" if it did not.
    saved: the text in the file.
    file_error: why the text that another program wrote into the file cannot be used; "" if it can.
    copied: the stacks of a ring from the cursor on; empty before the first copy.
    """

    history: EditHistory
    saved: str
    ring: int = 0
    slot: int = 0
    well: int = 0
    brush: Stack = BRUSH
    symmetry: Symmetry = Symmetry()
    message: str = ""
    file_error: str = ""
    copied: tuple[Stack, ...] = ()

    @property
    def document(self) -> Document:
        """The document that is edited."""
        return self.history.present

    @property
    def changed(self) -> bool:
        """Whether there is something to save."""
        return self.document.text != self.saved


def begun(text: str, saved: str) -> EditorSession:
    """The editor with a level file's text. saved: what the file has, empty for a new one. BadInputError as `opened`."""
    return EditorSession(EditHistory(opened(text)), saved)


def stroked(
    session: EditorSession, ring: int, slot: int, *, stack: Stack | None = None, before: EditHistory | None = None
) -> EditorSession:
    """The session after a stroke on a slot and its images.

    stack: what is painted; None for the brush. before: the history at the beginning of the drag that the stroke belongs to, so
    that undo takes back the whole drag and nothing else; None for a single stroke.
    """
    slots = images(session.document.level.rings[ring], slot, session.symmetry)
    try:
        document = painted(session.document, ring, slots, session.brush if stack is None else stack)
    except BadInputError as error:
        return session._replace(message=str(error))
    history = (before or session.history).changed(document)
    return session._replace(history=history, ring=ring, slot=slot, message="")


def value_of(session: EditorSession, field: Field) -> Any:
    """The value of a key; a key of rings or wells is that of the chosen one. None if the file leaves it out."""
    return value_at(session.document, path_of(session, field))


def path_of(session: EditorSession, field: Field) -> Path:
    """The path of a key; a key of rings or wells is that of the chosen one."""
    return field.path(session.well if field.table == "wells" else session.ring)


def stepped(session: EditorSession, field: Field, steps: float) -> EditorSession:
    """The session after a number was changed by some steps, within the format's limits."""
    value = value_of(session, field)
    if value is None:
        value = USUAL_TOP * session.document.level.ball.speed
    low, high = range_of(field.table, field.key) or (-math.inf, math.inf)
    return entered(session, field, min(max(value + steps * field.step, low), high), path_of(session, field))


def entered(session: EditorSession, field: Field, value: Value, step: Path | None = None) -> EditorSession:
    """The session with a key set; None removes it from the file. A value that the format refuses gives a message instead.

    step: the path of the number if this is a step of it, as in `EditHistory.changed`.
    """
    path = path_of(session, field)
    if isinstance(value, float) and is_whole(field.table, field.key):
        value = round(value) if math.isfinite(value) else value
    limits = range_of(field.table, field.key)
    if isinstance(value, float | int) and limits is not None and not limits[0] <= value <= limits[1]:
        words = tr("{key}: {value} is not from {low} to {high}")
        low, high = (f"{limit:.10g}" for limit in limits)
        return session._replace(message=words.format(key=named(path), value=f"{value:.10g}", low=low, high=high))
    try:
        if field.table == "rings" and field.key == "count" and isinstance(value, int):
            return after(session, with_count(session.document, session.ring, value), step)
        return after(session, with_value(session.document, path, value), step)
    except BadInputError as error:
        return session._replace(message=str(error))


def with_ring_copied(session: EditorSession) -> EditorSession:
    """The session with a copy of the chosen ring just outside the outermost one, and that copy chosen."""
    rings = session.document.level.rings
    outermost = max(rings, key=lambda ring: ring.radius + ring.half_width)
    apart = _APART * session.document.level.ground_radius / 10.0
    radius = outermost.radius + outermost.half_width + apart + rings[session.ring].half_width
    copy = msgspec.structs.replace(rings[session.ring], radius=radius)
    try:
        return _within(after(session, ring_added(session.document, copy))._replace(ring=len(rings)))
    except BadInputError as error:
        return session._replace(message=str(error))


def with_ring_removed(session: EditorSession) -> EditorSession:
    """The session without the chosen ring, the one before it chosen."""
    try:
        return _within(after(session, ring_removed(session.document, session.ring))._replace(ring=max(session.ring - 1, 0)))
    except BadInputError as error:
        return session._replace(message=str(error))


def filled(session: EditorSession) -> EditorSession:
    """The session with the brush put into every slot of the chosen ring."""
    count = session.document.level.rings[session.ring].count
    return after(session, painted(session.document, session.ring, range(count), session.brush))


def brushed(session: EditorSession, layers: int | None) -> EditorSession:
    """The session with a brush of other layers, as in `Stack`; -1 to 9."""
    return _with_brush(session, session.brush._replace(layers=None if layers is None else min(max(layers, PERMANENT), 9)))


def tinted(session: EditorSession, tint: int | None) -> EditorSession:
    """The session with a brush of another colour, as in `Stack`."""
    return _with_brush(session, session.brush._replace(tint=tint))


def _with_brush(session: EditorSession, brush: Stack) -> EditorSession:
    """The session with another brush; if it would leave both layers and colour, it paints one layer instead."""
    return session._replace(brush=BRUSH if brush == Stack(None) else brush, message="")


def chosen_ring(session: EditorSession, offset: int) -> EditorSession:
    """The session with another ring chosen: the offset counts from the chosen one outward, round at the end."""
    outward = rings_outward(session)
    return with_ring(session, outward[(outward.index(session.ring) + offset) % len(outward)])


def with_ring(session: EditorSession, ring: int) -> EditorSession:
    """The session with another ring chosen. ring: its index."""
    return _within(session._replace(ring=ring, message=""))


def rings_outward(session: EditorSession) -> list[int]:
    """Indices of the rings, the innermost first."""
    rings = session.document.level.rings
    return sorted(range(len(rings)), key=lambda index: rings[index].radius)


def undone(session: EditorSession) -> EditorSession:
    """The session one change back."""
    return _within(session._replace(history=session.history.undone(), message=""))


def redone(session: EditorSession) -> EditorSession:
    """The session one undone change forth."""
    return _within(session._replace(history=session.history.redone(), message=""))


def reloaded(session: EditorSession, text: str) -> EditorSession:
    """The session with what another program wrote into the file; what does not fit the format leaves the document as it was."""
    try:
        document = opened(text)
    except BadInputError as error:
        return session._replace(file_error=str(error), saved=text)
    return after(session, document)._replace(saved=text, file_error="")


def after(session: EditorSession, document: Document, step: Path | None = None) -> EditorSession:
    """The session after a change that can be undone. step: as in `EditHistory.changed`."""
    return _within(session._replace(history=session.history.changed(document, step), message=""))


def _within(session: EditorSession) -> EditorSession:
    """The session with the chosen ring, slot and well limited to those that exist."""
    level = session.document.level
    ring, well = min(session.ring, len(level.rings) - 1), min(session.well, max(len(level.wells) - 1, 0))
    return session._replace(ring=ring, slot=session.slot % level.rings[ring].count, well=well)
