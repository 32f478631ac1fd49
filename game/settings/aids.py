"""What makes a game easier for this player, in words: a score that was made with it says so."""

from game.language import tr
from game.settings.values import SPEEDS, Settings


def badge(settings: Settings) -> str:
    """The aids in use; empty without any."""
    speed = tr("speed {percent} %").format(percent=settings.speed) if settings.speed < SPEEDS[1] else ""
    one_button = tr("one button") if settings.one_button else ""
    return ", ".join(filter(None, [speed, one_button]))
