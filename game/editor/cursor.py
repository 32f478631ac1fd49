"""The cursor: the slot that is painted without a pointer. It goes along and across rings; bricks are copied from there."""

from game.editor.document import stacks, with_stacks
from game.editor.session import EditorSession, after, chosen_ring
from game.levels import RingSpec
from game.system.errors import BadInputError


def moved_along(session: EditorSession, steps: int) -> EditorSession:
    """The session with the cursor some slots further counter-clockwise on its ring."""
    count = session.document.level.rings[session.ring].count
    return session._replace(slot=(session.slot + steps) % count, message="")


def moved_across(session: EditorSession, steps: int) -> EditorSession:
    """The session with the cursor some rings further outward, round at the end, at the slot that is nearest in angle."""
    angle = _angle(session.document.level.rings[session.ring], session.slot)
    session = chosen_ring(session, steps)
    return session._replace(slot=_slot_at(session.document.level.rings[session.ring], angle))


def with_brush_of_slot(session: EditorSession) -> EditorSession:
    """The session whose brush has the layers and the colour of the slot under the cursor."""
    return session._replace(brush=stacks(session.document.level.rings[session.ring])[session.slot], message="")


def with_bricks_copied(session: EditorSession) -> EditorSession:
    """The session that remembers the bricks of the chosen ring, from the cursor on."""
    slots = stacks(session.document.level.rings[session.ring])
    return session._replace(copied=slots[session.slot :] + slots[: session.slot], message="")


def with_bricks_pasted(session: EditorSession) -> EditorSession:
    """The session with the bricks that were copied on the chosen ring, from the cursor on.

    On a ring with another number of slots each takes the brick that stood where its share of the turn begins.
    """
    if not session.copied:
        return session
    count = session.document.level.rings[session.ring].count
    taken = [session.copied[slot * len(session.copied) // count] for slot in range(count)]
    turned = [taken[(slot - session.slot) % count] for slot in range(count)]
    try:
        return after(session, with_stacks(session.document, session.ring, turned))
    except BadInputError as error:
        return session._replace(message=str(error))


def _angle(ring: RingSpec, slot: int) -> float:
    """The middle of a slot, degrees."""
    return ring.phase + slot * 360.0 / ring.count


def _slot_at(ring: RingSpec, angle: float) -> int:
    """The slot whose middle is nearest to an angle, degrees."""
    return round((angle - ring.phase) * ring.count / 360.0) % ring.count
