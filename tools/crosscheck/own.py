"""A player's own functions beside pymunk: the normal and the bounce at every contact of a game that the engine flies."""

import cmath
import math
from collections import Counter
from collections.abc import Iterator, Sequence
from enum import Enum
from typing import NamedTuple

from rich.console import Console
from rich.table import Table

from game.student.answering import answers_to
from game.student.engine_functions import EngineFunctions
from game.student.functions_file import FunctionsFile
from game.student.reply import Reply
from game.student.signatures import SIGNATURES, Result, agrees, answer
from game.student.slides import SlideFunctions
from game.system.errors import CheckFailedError
from game.system.output import print_error
from tools.crosscheck.comparisons.bounce import mirrored, with_friction
from tools.crosscheck.comparisons.hit_frame import CheckedTick, Moment, geometry_of, moment_of
from tools.crosscheck.comparisons.rules import MOST_BOUNCES, STOPPED
from tools.crosscheck.games.sources import Source, ticks_of
from tools.crosscheck.games.trajectory import flight_paths
from tools.crosscheck.pymunk_model.ring_model import RingModel, ShapeContact, ring_model
from tools.crosscheck.results.measurements import FEATURE_OF_PART

_FACETS = 3
"""Per arc: the exact shapes answer, and no chord is made."""
_TOLERANCE = 1e-6
"""Of a unit normal's coordinates; of a velocity's in shares of the ball's speed."""
_OVERLAP = 1.0 + 1e-6
"""By how much the ball is larger for the functions, which see no contact where it only touches. No normal moves."""
_SLIDES, _ENGINE = SlideFunctions(), EngineFunctions()


class OwnVerdict(Enum):
    """Whose answer it is; the first that fits."""

    PYMUNK = "as pymunk"
    SLIDES = "as the slides have it"
    GAME = "as the game has it"
    DIFFERS = "differs"


class OwnContact(NamedTuple):
    """One question at a contact.

    row: of the table. pymunks: its answer. size: of its numbers. where: the command that shows the contact.
    """

    row: str
    function: str
    arguments: tuple[float, ...]
    pymunks: Result
    size: float
    where: str


def compare_own(sources: Sequence[Source], functions: FunctionsFile, console: Console) -> None:
    """Print a row for each kind of contact; CheckFailedError where an answer is nobody's, or the file has failed."""
    counts: Counter[tuple[str, OwnVerdict]] = Counter()
    first: dict[str, str] = {}
    for source in sources:
        for contacts in _contacts(source):
            for contact, reply in zip(contacts, _answers(functions, contacts), strict=True):
                verdict = _verdict(contact, reply)
                counts[contact.row, verdict] += 1
                if verdict is OwnVerdict.DIFFERS and contact.row not in first:
                    first[contact.row] = _difference(contact, reply)
            if functions.problem:
                break
    table = Table(box=None, pad_edge=False)
    for heading in ("contact", *[verdict.value for verdict in OwnVerdict]):
        table.add_column(heading, justify="left" if heading == "contact" else "right")
    for row in dict.fromkeys([row for row, _ in counts]):
        table.add_row(row, *[f"{counts[row, verdict]:,}" for verdict in OwnVerdict])
    console.print(table)
    for words in first.values():
        print_error(f"polar-crosscheck: {words}")
    functions.check()
    differing = sum([count for (_, verdict), count in counts.items() if verdict is OwnVerdict.DIFFERS])
    if differing:
        raise CheckFailedError(f"{differing:,} of {counts.total():,} answers of {functions.name} differ")


def _contacts(source: Source) -> Iterator[list[OwnContact]]:
    """For each tick with one hit, what is asked there. Where there are more, it is not known what each of them met."""
    models: list[RingModel] = []
    level: object = None
    for tick in ticks_of(source):
        if tick.level is not level:
            level, models = tick.level, [ring_model(ring.geometry, _FACETS) for ring in tick.level.rings]
        if len(tick.step.hits) == 1 and not tick.step.freed:
            moment = _moment(CheckedTick(tick, models, source.options()))
            yield [] if moment is None else _asked(moment)


def _moment(checked: CheckedTick) -> Moment | None:
    """The only hit of a tick; None where the ball's flight does not lead there, or the ring has not the level's sizes."""
    tick, (hit,) = checked.tick, checked.tick.step.hits
    ends = [leg.end for path in flight_paths(tick, MOST_BOUNCES) if path.fits for leg in path.legs if leg.hit is hit]
    model = checked.models[hit.ring]
    if not ends or geometry_of(tick.arena.rings[hit.ring]) != model.geometry:
        return None
    model.set_alive(tick.arena.layers[hit.ring])
    return moment_of(checked, hit, ends[0])


def _asked(moment: Moment) -> list[OwnContact]:
    """The normal and the bounce."""
    touched = moment.model.exact(moment.local, moment.reach)
    if touched is None:
        return []
    feature, normal = FEATURE_OF_PART[touched.shape.part], moment.world(touched.normal)
    where = f"python -m tools.crosscheck {moment.options} --tick {moment.tick.number}"
    positions = _positions(moment)
    p, geometry = moment.position, moment.model.geometry
    sector = (moment.ball_radius * _OVERLAP, cmath.phase(p) % math.tau, geometry.half_width, geometry.half_angle)
    asked = [
        OwnContact(
            f"normal, {feature}", "broad_phase", (p.real, p.imag, *sector, *positions), [normal.real, normal.imag], 1.0, where
        )
    ]
    bounced = _bounced(moment, touched)
    if bounced is not None:
        v, v_p = moment.hit.before, moment.pushed(touched)
        numbers = (v.real, v.imag, normal.real, normal.imag, v_p.real, v_p.imag, moment.numbers.friction, moment.speed)
        velocity: Result = [bounced.real, bounced.imag]
        asked.append(OwnContact("bounce", "collision_response", numbers, velocity, moment.speed, where))
    return asked


def _positions(moment: Moment) -> list[float]:
    """r_p and theta_p of every sector that is left in the ring, at the moment of the hit."""
    geometry = moment.model.geometry
    pitch = math.tau / geometry.count
    angles = [(moment.angle + slot * pitch) % math.tau for slot, alive in enumerate(moment.model.alive) if alive]
    return [number for angle in angles for number in (geometry.radius, angle)]


def _bounced(moment: Moment, touched: ShapeContact) -> complex | None:
    """pymunk's velocity after the bounce, reset to v_0 as the source does it; None where there is no direction left."""
    result = mirrored(moment, touched)
    if moment.numbers.friction > 0.0:
        result = with_friction(moment, touched, result, moment.numbers.friction)
    size = abs(result.velocity)
    return None if size <= STOPPED * moment.speed + result.velocity_error else result.velocity * (moment.speed / size)


def _answers(functions: FunctionsFile, contacts: Sequence[OwnContact]) -> list[Reply]:
    """The answers of the file's functions, of which one may call another that is the slides'."""
    return answers_to(functions, [(contact.function, contact.arguments) for contact in contacts], composed=True)


def _verdict(contact: OwnContact, reply: Reply) -> OwnVerdict:
    """Whose answer it is."""
    kind, tolerance = SIGNATURES[contact.function].result, _TOLERANCE * contact.size
    if reply.problem is not None:
        return OwnVerdict.DIFFERS
    if agrees(kind, reply.result, contact.pymunks, tolerance):
        return OwnVerdict.PYMUNK
    for verdict, others in ((OwnVerdict.SLIDES, _SLIDES), (OwnVerdict.GAME, _ENGINE)):
        if agrees(kind, reply.result, answer(others, contact.function, contact.arguments), tolerance):
            return verdict
    return OwnVerdict.DIFFERS


def _difference(contact: OwnContact, reply: Reply) -> str:
    """A difference in one line."""
    said = reply.problem or f"{contact.function} = {_words(reply.result)}, pymunk {_words(contact.pymunks)}"
    return f"{contact.row}: {said}: {contact.where}"


def _words(result: object) -> str:
    """A point in a few letters."""
    return f"({result[0]:.6g}, {result[1]:.6g})" if isinstance(result, list) else str(result)
