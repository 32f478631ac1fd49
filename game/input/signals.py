"""What the player did, as values. Needs no pygame: a window and a browser make the same signals of their events."""

from dataclasses import dataclass

from game.input.actions import Action


@dataclass(frozen=True)
class Pressed:
    """A key or a gamepad's button went down.

    position: of the key, a scancode; 0 where it is not known. Of a button, a number from PAD_POSITIONS on.
    """

    action: Action
    position: int = 0


@dataclass(frozen=True)
class Released:
    """A key or a button came up. position: as that of `Pressed`."""

    action: Action
    position: int = 0


@dataclass(frozen=True)
class KeyboardState:
    """The keys that are down after all events of a frame. down: their positions."""

    down: frozenset[int]


@dataclass(frozen=True)
class Moved:
    """The mouse moved. pixel: of the drawn surface; held: with the main button down."""

    pixel: complex
    held: bool


@dataclass(frozen=True)
class Clicked:
    """The main mouse button went down. pixel: of the drawn surface."""

    pixel: complex


@dataclass(frozen=True)
class Dragged:
    """The mouse moved with its right button held. offset: pixels, to the right and down."""

    offset: complex


@dataclass(frozen=True)
class Zoomed:
    """The wheel turned. steps: above 0 away from the player."""

    steps: float


@dataclass(frozen=True)
class Pointed:
    """A gamepad's stick points somewhere.

    direction: of length 1, to the right and up; 0 once the stick is let go. aims: it is the right stick, which aims the serve;
    the left one moves the paddles. pad: index of the gamepad, 0 for the one that was plugged in first.
    """

    direction: complex
    aims: bool = False
    pad: int = 0


@dataclass(frozen=True)
class Squeezed:
    """A gamepad's triggers moved.

    spin: -1.0 the left one all the way, 0.0 neither or both, +1.0 the right one. pad: as that of `Pointed`.
    """

    spin: float
    pad: int = 0


@dataclass(frozen=True)
class PadChanged:
    """A gamepad was plugged in or pulled out. name: what it calls itself."""

    name: str
    there: bool


@dataclass(frozen=True)
class FocusLost:
    """The player went to another window, or the gamepad is gone: what was held will not be heard coming up."""


Signal = Pressed | Released | KeyboardState | Moved | Clicked | Dragged | Zoomed | Pointed | Squeezed | PadChanged | FocusLost
"""Every kind is a class of its own, and a dataclass equals only its own class: no two kinds compare equal."""

PAD_POSITIONS, POSITIONS_PER_PAD = 1 << 10, 64
"""Positions from the first on are of gamepads: above every scancode, so many for each gamepad."""
STICK = 32
"""The first of a gamepad's positions that is of its stick and not of a button."""


def pad_of(signal: Signal) -> int | None:
    """Index of the gamepad that a signal comes from; None for one that comes from elsewhere."""
    match signal:
        case Pressed(_, position) | Released(_, position) if position >= PAD_POSITIONS:
            return (position - PAD_POSITIONS) // POSITIONS_PER_PAD
        case Pointed() | Squeezed():
            return signal.pad
        case _:
            return None


def is_still_down(position: int, signal: Signal) -> bool:
    """Whether a key or a gamepad's button that was down is so after a signal. position: as that of `Pressed`."""
    match signal:
        case KeyboardState(down):
            return position in down or position >= PAD_POSITIONS
        case Released():
            return signal.position != position
        case FocusLost():
            return False
        case _:
            return True


def pad_position(index: int, control: int) -> int:
    """The position of a gamepad's button, or from STICK on of a direction of its stick. index: of the gamepad."""
    return PAD_POSITIONS + index * POSITIONS_PER_PAD + control


def of_stick(position: int) -> bool:
    """Whether a position is a direction of a gamepad's stick."""
    return position >= PAD_POSITIONS and (position - PAD_POSITIONS) % POSITIONS_PER_PAD >= STICK
