"""How to play, in words: what the game is about, how one aims, what drops out of bricks, and how one steers."""

from game.effects.pops import POWER_NAMES
from game.input.key_names import key_name
from game.input.keys import Action
from game.language import tr
from game.rules import LASTING, TICK, PowerUp


def game_words() -> tuple[str, ...]:
    """What it is about."""
    return (
        tr("Keep the ball inside the circle and break every brick."),
        tr("All paddles move around the rim together. A ball that leaves the circle is lost."),
        tr("Each layer of a brick takes one hit; the dots count the layers. Steel never breaks."),
        tr("Bricks hit in a row, without a paddle in between, count more and more: up to eight times."),
    )


def aiming_words() -> tuple[str, ...]:
    """How one steers a ball: off centre, on the move, by the serve; and what else helps."""
    return (
        tr("Off centre: the ball leaves towards the side that it hits, the more so the nearer to the end."),
        tr("On the move: a moving paddle takes the ball along."),
        tr("The serve: the ball flies along the arrow. Wait for the right moment, or point the way."),
        tr("A ball that flies past the core comes out on the far side: be there first."),
    )


def powers_words() -> str:
    """What to do about power-ups."""
    caught = tr("A broken brick may release a power-up. It drifts outward: catch it with a paddle before it leaves the circle.")
    return f"{caught} {tr('Let the spiky ones go.')}"


def gauges_words() -> str:
    """What the arcs beside the circle show."""
    return tr("Arcs beside the circle show how long each lasts; the red one with the target, what is left of a core.")


def power_words(kind: PowerUp) -> str:
    """What a power-up does."""
    name, seconds = tr(POWER_NAMES[kind]), LASTING.get(kind, 0) * TICK
    words = name[:1].upper() + name[1:]
    if seconds:
        words = tr("{power} for {seconds:.0f} s").format(power=words, seconds=seconds)
    meaning = _meanings().get(kind, "")
    return f"{words}: {meaning}" if meaning else words


def keyboard_words() -> tuple[str, str]:
    """The keyboard, and how one plays by it."""
    return tr("Keyboard"), tr("Two keys turn the paddles; {key} serves.").format(key=key_name(Action.SERVE))


def other_controls() -> tuple[tuple[str, str], ...]:
    """Other devices than keyboard and mouse, and how one plays by them."""
    return (
        (
            tr("Gamepad"),
            tr(
                "The paddle goes where the stick points; the triggers turn it; the lower button serves. "
                "The other stick aims the serve, and moves the camera in 3D."
            ),
        ),
        (tr("Touch"), tr("Drag to where a paddle should go; tap to serve. In 3D two fingers turn and zoom.")),
        (tr("One button"), tr("Can be turned on in the settings: the paddles never stop, and every press reverses them.")),
    )


def _meanings() -> dict[PowerUp, str]:
    """What those do whose names do not say it."""
    return {
        PowerUp.MULTI_BALL: tr("two more balls; only losing the last one costs a life."),
        PowerUp.STICKY: tr("a paddle holds the ball until you serve."),
        PowerUp.SHIELD: tr("a ring at the rim sends one ball back."),
        PowerUp.PIERCE: tr("it breaks bricks and flies on."),
    }
