"""The falling stack: a hit takes the lowest layer, and what is left comes down."""

import math
from typing import NamedTuple

from game.effects.falling import BOUNCE, GRAVITY, FallingStack, after_hit, fallen
from game.lab.kit import handles
from game.lab.kit.cited_line import CitedLine, code_line
from game.lab.kit.marks import VELOCITY_SCALE, ring_marks
from game.lab.kit.parameters import Count, Given, Number
from game.lab.kit.picture import Arrow, Circle, Disc, Line, Mark, Pane, Picture, Role, Stroke, Toggle, Words
from game.lab.kit.scene import Claim, LabScene, Motion, Preset, ViewBox
from game.rules import TICK
from physics import PERMANENT, Arena, Ball, Hit, Ring, advance, contact, length, to_cartesian

_RINGS = (Ring(4.0, 0.6, 0.4, 4), Ring(8.0, 0.3, math.pi, 1))
_STACKS, _SLOT = 0, 0
"""Indices of the ring with the stacks, and of the slot whose stack is shown from the side."""
_START, _RADIUS = 6.0 + 0j, 0.4
_BASE, _WIDTH, _HEIGHT = -6.5, 3.0, 1.3
"""The stack from the side, world units: where it stands, half of its width, the height of a layer."""
_TRAIL = 240
_RUN = 240


class _StackState(NamedTuple):
    """The arena, what is still falling, and what was hit.

    hits: those of the stack in the last tick. taken: layers that were taken from the stack so far.
    trail: the last positions of the ball.
    """

    arena: Arena
    falling: tuple[FallingStack, ...]
    hits: tuple[Hit, ...]
    taken: int
    trail: tuple[complex, ...]


def _start(given: Given) -> _StackState:
    """A ball between a wall and a ring of four stacks, one of them unbreakable."""
    ball = Ball(_START, to_cartesian(given.number("speed"), given.angle("heading")), _RADIUS)
    layers = given.count("layers")
    return _StackState(Arena((ball,), _RINGS, ((layers, layers, PERMANENT, layers), (PERMANENT,))), (), (), 0, (_START,))


def _step(given: Given, state: _StackState) -> _StackState:
    """A tick later. The rules take the layer at once; only the picture of the stack takes time to fall."""
    step = advance(state.arena, TICK, given.number("speed"))
    falling, here = state.falling, [hit for hit in step.hits if (hit.ring, hit.slot) == (_STACKS, _SLOT)]
    for hit in step.hits:
        if hit.layers != PERMANENT:
            falling = after_hit(falling, hit.ring, hit.slot, hit.layers)
    bounces = [hit.contact.point + hit.contact.normal * _RADIUS for hit in step.hits]
    trail = (*state.trail, *bounces, step.arena.balls[0].position)[-_TRAIL:]
    return _StackState(step.arena, fallen(falling), tuple(here), state.taken + len(here), trail)


def _layers(state: _StackState) -> int:
    """The layers of the stack that is shown from the side."""
    return state.arena.layers[_STACKS][_SLOT]


def _height(state: _StackState) -> float:
    """How far that stack still is above the ground, in layers."""
    return next((drop.height for drop in state.falling if (drop.ring, drop.slot) == (_STACKS, _SLOT)), 0.0)


def _picture(given: Given, state: _StackState) -> Picture:
    """The arena from above with the number of layers in each slot, and one stack from the side."""
    panes = (
        Pane(_from_above(state), "from above: layers in each slot"),
        Pane(_from_the_side(state), f"slot {_SLOT} from the side:   {_layers(state)} layers", has_handles=False),
    )
    return Picture(panes, _formula(given, state), _cited(state), _note(state))


def _from_above(state: _StackState) -> tuple[Mark, ...]:
    """The rings, the ball and its path."""
    stacks, wall = _RINGS
    layers, ball = state.arena.layers[_STACKS], state.arena.balls[0]
    marks: list[Mark] = [*ring_marks(wall, nearest=-1), *ring_marks(stacks, layers, nearest=_SLOT)]
    marks += [
        Words(
            to_cartesian(stacks.radius, stacks.angle(slot)),
            "unbreakable" if layers[slot] == PERMANENT else str(layers[slot]),
            Role.PLAIN,
        )
        for slot in range(stacks.count)
        if layers[slot]
    ]
    marks += [Line(state.trail, Role.OURS, Toggle.SWEPT), Circle(_START, _RADIUS, Role.GHOST, None, Stroke.DASHED)]
    marks.append(Disc(ball.position, _RADIUS, Role.BALL))
    if len(state.trail) == 1:
        marks.append(Arrow(_START, ball.velocity * VELOCITY_SCALE / 2.0, Role.PLAIN, label="v"))
    return tuple(marks)


def _from_the_side(state: _StackState) -> tuple[Mark, ...]:
    """The ground, and the layers of one stack, as high as they are now."""
    low = _BASE + _height(state) * _HEIGHT
    marks: list[Mark] = [Line((complex(-8.0, _BASE), complex(8.0, _BASE)), Role.FAINT)]
    for layer in range(_layers(state)):
        bottom, top = low + layer * _HEIGHT, low + (layer + 0.9) * _HEIGHT
        outline = (complex(-_WIDTH, bottom), complex(_WIDTH, bottom), complex(_WIDTH, top), complex(-_WIDTH, top))
        marks.append(Line((*outline, outline[0]), Role.SECTOR, None, Stroke.THICK))
    return tuple(marks)


def _formula(given: Given, state: _StackState) -> tuple[str, ...]:
    """The count, and the fall."""
    return (
        f"layers = {given.count('layers')} - {state.taken} hits = {_layers(state)}",
        f"above the ground by {_height(state):.2f} layers,   falling with g = {GRAVITY:g} layers/s²",
        f"a landing leaves {BOUNCE:g} of the speed",
    )


def _cited(state: _StackState) -> CitedLine:
    """The line that lets a stack fall, after a hit; before it, the one that flies the ball."""
    if state.taken:
        return code_line(after_hit, "return (*others, before._replace(height=before.height + 1.0))")
    return code_line(advance, "return _flown(free, _moved_balls(arena, free), dt, speed)")


def _note(state: _StackState) -> str:
    """What is happening."""
    if _layers(state) == 0:
        return "No layer is left: the slot is empty, and the ball flies through it."
    if _height(state) > 0.0:
        return "The fall is a picture only: the ground is two-dimensional, and a sector is hit at any height."
    if state.taken:
        return "The stack has landed. The next hit takes the layer that is the lowest now."
    return "The ball has not hit the stack yet."


def _check(given: Given) -> tuple[Claim, ...]:
    """A second of flight: every hit takes one layer, and the picture comes to rest on the ground."""
    state, layers = _start(given), given.count("layers")
    counted, lasting, apart, above = True, True, True, True
    for _ in range(_RUN):
        state = _step(given, state)
        counted &= _layers(state) == layers - state.taken
        lasting &= state.arena.layers[_STACKS][2] == PERMANENT
        ball = state.arena.balls[0]
        slots = [slot for slot in range(_RINGS[_STACKS].count) if state.arena.layers[_STACKS][slot]]
        apart &= min([contact(ball, _RINGS[_STACKS], slot).gap for slot in slots]) > -1e-9
        above &= _height(state) >= 0.0
    still = state._replace(falling=_settled(state.falling))
    return (
        Claim("every hit takes one layer from the stack", counted),
        Claim("an unbreakable stack loses none", lasting),
        Claim("the ball overlaps no stack that is left", apart),
        Claim("a stack never sinks into the ground", above),
        Claim("two seconds after the last hit it has landed", _height(still) == 0.0 and not still.falling),
        Claim("the speed is v_0", abs(length(state.arena.balls[0].velocity) - given.number("speed")) < 1e-9),
    )


def _settled(falling: tuple[FallingStack, ...]) -> tuple[FallingStack, ...]:
    """What is still falling two seconds later."""
    for _ in range(round(2.0 / TICK)):
        falling = fallen(falling)
    return falling


SCENE = LabScene(
    name="falling-stack",
    title="The falling stack",
    idea="A hit takes the lowest layer of a stack at once. What is left falls, which is a picture and changes no collision.",
    functions=("advance",),
    parameters=(
        Count("layers", "layers", 1, 8, 4, "of each stack at first"),
        Number("heading", "ψ", "°", 0.0, 360.0, 180.0, 0.5, "direction of v"),
        Number("speed", "v_0", "", 1.0, 40.0, 16.0, 0.5, "the ball's fixed speed"),
    ),
    handles=(handles.polar_vector("speed", "heading", lambda _: _START, VELOCITY_SCALE / 2.0, "velocity"),),
    view_box=ViewBox(0j, 8.8 + 8.8j),
    shows=Motion(_start, _step, _picture, ticks=720),
    check=_check,
    presets=(
        Preset("four layers", "layers=4"),
        Preset("hit again while it falls", "layers=8&speed=40"),
        Preset("one layer", "layers=1"),
        Preset("slanting", "heading=160"),
    ),
)
