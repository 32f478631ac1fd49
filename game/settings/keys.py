"""The keys that change a setting on every screen, and what is said about it."""

from game.input.keys import Action
from game.language import tr
from game.overlay.toast import Toast
from game.settings.values import LOUDEST, Settings


def changed(settings: Settings, action: Action) -> tuple[Settings, Toast] | None:
    """The settings after a key, and a word about them; None for the keys that change none."""
    match action:
        case Action.MUTE:
            settings = settings._replace(sound=not settings.sound)
            return settings, Toast(tr("Sound on") if settings.sound else tr("Sound off"))
        case Action.LESS | Action.MORE:
            settings = settings.louder(1 if action is Action.MORE else -1)
            return settings, Toast(tr("Volume {percent} %").format(percent=settings.volume), settings.volume / LOUDEST)
        case Action.THEME:
            settings = settings.other_colours()
            told = {"dark": tr("Dark colours"), "light": tr("Light colours"), "contrast": tr("High contrast")}
            return settings, Toast(told[settings.colours])
        case Action.EFFECTS:
            settings = settings._replace(effects=not settings.effects)
            return settings, Toast(tr("Effects on") if settings.effects else tr("Effects off"))
    return None
