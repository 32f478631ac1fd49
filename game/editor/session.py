"""What the editor knows: the documents, the chosen ring, the brush. Pure; the window draws it and sends it commands."""

from typing import NamedTuple

from game.editor.document import (
    Document,
    Path,
    opened,
    painted,
    ring_added,
    ring_removed,
    value_at,
    with_count,
    with_value,
)
from game.editor.history import EditHistory
from game.editor.symmetry import Symmetry, images
from game.system.errors import BadInputError
from physics import PERMANENT

_APART = 0.05
"""World units of ground radius 10 that a new ring leaves to its neighbour; a ball need not fit between."""


class Row(NamedTuple):
    """A number that the editor shows and changes.

    name: as in the file.
    path: of the value in the level.
    step: that one press of a key changes it by.
    """

    name: str
    path: Path
    step: float


class EditorSession(NamedTuple):
    """The state of the editor.

    history: of documents.
    ring: index of the chosen ring.
    brush: layers that a stroke puts: 1 to 9, 0 for a gap, -1 for an unbreakable stack.
    symmetry: of a stroke.
    message: what the last command could not do; empty where it could.
    saved: the text that the file has.
    slot: of the chosen ring: the cursor.
    copied: layers of the slots of a ring, from the cursor on; empty before the first copy.
    """

    history: EditHistory
    ring: int
    brush: int
    symmetry: Symmetry
    message: str
    saved: str
    slot: int = 0
    copied: tuple[int, ...] = ()

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
    return EditorSession(EditHistory(opened(text)), 0, 1, Symmetry(), "", saved)


def rows(session: EditorSession) -> tuple[Row, ...]:
    """The numbers of the chosen ring, then those of the arena."""
    ring = ("rings", session.ring)
    own = [
        Row(name, (*ring, name), step)
        for name, step in (
            ("radius", 0.1),
            ("half_width", 0.05),
            ("count", 1.0),
            ("half_angle", 0.5),
            ("phase", 1.0),
            ("spin", 1.0),
            ("friction", 0.1),
        )
    ]
    arena = [
        Row(f"{table}.{name}", (table, name), step)
        for table, name, step in (
            ("ball", "radius", 0.01),
            ("ball", "speed", 0.25),
            ("paddles", "count", 1.0),
            ("paddles", "half_angle", 1.0),
            ("paddles", "half_width", 0.05),
            ("paddles", "radius", 0.1),
            ("paddles", "top_speed", 1.0),
            ("paddles", "acceleration", 50.0),
            ("paddles", "friction", 0.1),
        )
    ]
    return tuple(own + arena)


def stroked(
    session: EditorSession, ring: int, slot: int, *, layers: int | None = None, before: EditHistory | None = None
) -> EditorSession:
    """The session after a stroke on a slot and its images.

    layers: to put there, the brush's where None. before: the history when the drag began that the stroke belongs to, so that
    undo takes back the drag as a whole, and nothing else; None for a stroke of its own.
    """
    put = session.brush if layers is None else layers
    slots = images(session.document.level.rings[ring], slot, session.symmetry)
    try:
        document = painted(session.document, ring, slots, put)
    except BadInputError as error:
        return session._replace(message=str(error))
    history = (before or session.history).changed(document)
    return session._replace(history=history, ring=ring, slot=slot, message="")


def stepped(session: EditorSession, row: Row, steps: float) -> EditorSession:
    """The session after a number was changed by some steps. What the format refuses stays as it was, with a message."""
    value = value_at(session.document, row.path) + steps * row.step
    return entered(session, row, value)


def entered(session: EditorSession, row: Row, value: float) -> EditorSession:
    """The session with a number set. What the format refuses stays as it was, with a message."""
    try:
        if row.path[-1] == "count" and row.path[0] == "rings":
            return after(session, with_count(session.document, session.ring, round(value)))
        whole = isinstance(value_at(session.document, row.path), int)
        return after(session, with_value(session.document, row.path, round(value) if whole else float(value)))
    except BadInputError as error:
        return session._replace(message=str(error))


def with_ring_copied(session: EditorSession) -> EditorSession:
    """The session with a copy of the chosen ring just outside the outermost one, and that copy chosen."""
    rings = session.document.level.rings
    outermost = max(rings, key=lambda ring: ring.radius + ring.half_width)
    apart = _APART * session.document.level.ground_radius / 10.0
    radius = outermost.radius + outermost.half_width + apart + rings[session.ring].half_width
    try:
        return _within(after(session, ring_added(session.document, session.ring, radius))._replace(ring=len(rings)))
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


def brushed(session: EditorSession, layers: int) -> EditorSession:
    """The session with another brush. layers: -1 to 9."""
    return session._replace(brush=min(max(layers, PERMANENT), 9), message="")


def chosen_ring(session: EditorSession, offset: int) -> EditorSession:
    """The session with another ring chosen: the offset counts from the chosen one outward, round at the end."""
    rings = session.document.level.rings
    outward = sorted(range(len(rings)), key=lambda index: rings[index].radius)
    position = (outward.index(session.ring) + offset) % len(rings)
    return _within(session._replace(ring=outward[position], message=""))


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
        return session._replace(message=str(error), saved=text)
    return after(session, document)._replace(saved=text)


def after(session: EditorSession, document: Document) -> EditorSession:
    """The session after a change that can be undone."""
    return _within(session._replace(history=session.history.changed(document), message=""))


def _within(session: EditorSession) -> EditorSession:
    """The session with a ring chosen, and a slot of it, that there are."""
    rings = session.document.level.rings
    ring = min(session.ring, len(rings) - 1)
    return session._replace(ring=ring, slot=session.slot % rings[ring].count)
