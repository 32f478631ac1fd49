"""An open scene: its values, the states that it has run through, and whether it runs. Nothing here knows a window."""

import hashlib
import struct
from typing import Any, NamedTuple

from game.lab.kit.parameters import Clamped, Given, defaults
from game.lab.kit.picture import Picture
from game.lab.kit.scene import LabScene, Motion, picture_of, started, stepped
from game.lab.kit.second_engine import Engine
from game.lab.session.share import SharedScene, share_line

PACES = (1 / 64, 1 / 32, 1 / 16, 1 / 8, 1 / 4, 1 / 2, 1.0)
"""Speeds at which a scene can run, as shares of real time."""
_PACE = PACES.index(1 / 4)
_MOST_PER_FRAME = 64
"""Ticks: a scene that is slow to compute runs more slowly, and the window goes on."""


class Session(NamedTuple):
    """One scene as it stands. Its state is a function of its values and its tick, so a step back is a look-up.

    states: at tick 0, 1, 2, ..., as far as the scene was run. tick: the one that is shown. pace: an index of PACES.
    rest: the part of a tick that is due but not yet run, in [0, 1). notes: what the last change had to clamp or refuse.
    """

    scene: LabScene
    given: Given
    states: tuple[Any, ...]
    tick: int = 0
    playing: bool = False
    pace: int = _PACE
    rest: float = 0.0
    notes: tuple[str, ...] = ()

    @property
    def runs(self) -> bool:
        """Whether the scene is one that runs."""
        return isinstance(self.scene.shows, Motion)

    @property
    def last(self) -> int:
        """The tick at which it stops; 0 for a scene that does not run."""
        return self.scene.shows.ticks if isinstance(self.scene.shows, Motion) else 0

    @property
    def picture(self) -> Picture:
        """The picture of the tick that is shown."""
        return picture_of(self.scene, self.given, self.states[self.tick])

    @property
    def line(self) -> str:
        """The share line that opens it as it stands."""
        return share_line(SharedScene(self.scene, self.given, self.tick))


def opened(shared: SharedScene) -> Session:
    """A scene as a share line names it. At tick 0, one that runs starts at once; at a later tick it is paused there."""
    new = Session(shared.scene, shared.given, (started(shared.scene, shared.given),))
    return at_tick(new, shared.tick) if shared.tick else new._replace(playing=new.runs)


def fresh(scene: LabScene, engine: Engine | None) -> Session:
    """A scene at its defaults."""
    return opened(SharedScene(scene, defaults(scene.parameters, engine)))


def changed(session: Session, clamped: Clamped) -> Session:
    """After a change of values, which takes a scene that runs back to tick 0."""
    if clamped.given.values == session.given.values:
        return session._replace(notes=clamped.notes)
    start = (started(session.scene, clamped.given),)
    return session._replace(given=clamped.given, states=start, tick=0, rest=0.0, notes=clamped.notes)


def with_engine(session: Session, engine: Engine) -> Session:
    """The same scene at the same tick, with a second engine available."""
    given = session.given._replace(engine=engine)
    return at_tick(session._replace(given=given, states=(started(session.scene, given),)), session.tick)


def restarted(session: Session) -> Session:
    """Back at tick 0 with the same values, and running if the scene is one that runs."""
    return session._replace(tick=0, rest=0.0, playing=session.runs, notes=())


def reset(session: Session) -> Session:
    """At the scene's defaults."""
    return changed(session, Clamped(defaults(session.scene.parameters, session.given.engine), ()))


def toggled(session: Session) -> Session:
    """Paused if it was running, else running; at its last tick it starts again."""
    if session.runs and session.tick == session.last:
        return restarted(session)
    return session._replace(playing=session.runs and not session.playing, notes=())


def moved(session: Session, ticks: int) -> Session:
    """Paused, and so many ticks later, or earlier where `ticks` is below 0."""
    return at_tick(session._replace(playing=False, notes=()), session.tick + ticks)


def paced(session: Session, steps: int) -> Session:
    """Faster by so many of the paces, or slower where `steps` is below 0."""
    return session._replace(pace=min(max(session.pace + steps, 0), len(PACES) - 1))


def later(session: Session, seconds: float) -> Session:
    """After some seconds of real time: as many ticks later as are due at its pace."""
    if not (session.playing and isinstance(session.scene.shows, Motion)):
        return session
    due = session.rest + min(seconds, 1.0) * PACES[session.pace] / session.scene.shows.tick
    ticks = min(int(due), _MOST_PER_FRAME)
    there = at_tick(session, session.tick + ticks)._replace(rest=due - int(due))
    return there._replace(playing=there.tick < there.last)


def at_tick(session: Session, tick: int) -> Session:
    """At a tick, to which the scene is run if it was not yet."""
    tick = min(max(tick, 0), session.last)
    states = list(session.states)
    while len(states) <= tick:
        states.append(stepped(session.scene, session.given, states[-1]))
    return session._replace(states=tuple(states) if len(states) > len(session.states) else session.states, tick=tick)


def state_hash(session: Session) -> str:
    """The first 12 digits of a SHA-256 over the values and the state: little-endian float64, -0.0 as 0.0."""
    values = [session.given.values[parameter.name] for parameter in session.scene.parameters]
    packed = _packed((session.scene.name, tuple(values), session.tick, session.states[session.tick]))
    return hashlib.sha256(packed).hexdigest()[:12]


def _packed(value: Any) -> bytes:
    """A nested value as bytes."""
    if isinstance(value, tuple | list):
        return b"(" + b"".join([_packed(part) for part in value]) + b")"
    if isinstance(value, float | complex) and not isinstance(value, bool):
        return struct.pack("<2d", value.real + 0.0, value.imag + 0.0)
    return repr(value).encode() + b";"
