"""The keys that change a setting on every screen, and what is said about it."""

from typing import NamedTuple

from game.input.actions import Action
from game.language import tr
from game.settings.values import LOUDEST, Settings


class Changed(NamedTuple):
    """The settings after a key, and a word about them. level: how full a bar behind it is, 0 to 1; None for no bar."""

    settings: Settings
    words: str
    level: float | None = None


def changed(settings: Settings, action: Action) -> Changed | None:
    """The settings after a key; None for the keys that change none."""
    match action:
        case Action.MUTE:
            settings = settings._replace(sound=not settings.sound)
            return Changed(settings, tr("Sound on") if settings.sound else tr("Sound off"))
        case Action.LESS | Action.MORE:
            settings = settings.louder(1 if action is Action.MORE else -1)
            return Changed(settings, tr("Volume {percent} %").format(percent=settings.volume), settings.volume / LOUDEST)
        case Action.THEME:
            settings = settings.other_colours()
            told = {"dark": tr("Dark colours"), "light": tr("Light colours"), "contrast": tr("High contrast")}
            return Changed(settings, told[settings.colours])
        case Action.EFFECTS:
            settings = settings._replace(effects=not settings.effects)
            return Changed(settings, tr("Effects on") if settings.effects else tr("Effects off"))
    return None
