"""The player's settings as a value, and the changes that keys and the settings panel make to it."""

from typing import NamedTuple

from game.drawing.colour_vision import VISIONS, seen_by
from game.drawing.palette import DARK, HIGH_CONTRAST, LIGHT, Theme, without_depth
from game.effects import ALL, MOVING, PLAIN, EffectKind, Shown
from game.input.actions import DEFAULT_KEYS, OwnKeys
from game.language import SYSTEM
from game.unlocks import PLAIN_BALL, PLAIN_TRAIL

LOUDEST = 100
VOLUME_STEP = 10
THEMES = {"dark": DARK, "light": LIGHT, "contrast": HIGH_CONTRAST}
SPEEDS = (50, 100)
"""The least and the most of the game's speed, per cent."""
TEXT_SIZES = (100, 200)
"""The least and the most of the size of text, per cent."""


class Settings(NamedTuple):
    """All settings.

    colours: a key of THEMES. volume: 0 to LOUDEST. reduced_motion: no effect that moves the picture.
    music: its volume beside all else, 0 to LOUDEST; 0 for none. ball, trail: how balls look, and what they leave behind.
    effects: whether there are any but the ball's trail. off: single effects that are not wanted.
    speed: of the game, per cent, within SPEEDS. text_size: per cent, within TEXT_SIZES.
    one_button: whether the paddles turn by themselves and any press reverses them.
    captions: whether words say what sounds say. ghost: whether the best run of a level is raced.
    vision: one of VISIONS, whose colours the player tells apart.
    language: its code, or SYSTEM. own_keys: the player's.
    """

    colours: str = "dark"
    sound: bool = True
    volume: int = 80
    reduced_motion: bool = False
    effects: bool = True
    off: frozenset[EffectKind] = frozenset()
    speed: int = SPEEDS[1]
    text_size: int = TEXT_SIZES[0]
    one_button: bool = False
    captions: bool = False
    ghost: bool = True
    vision: str = VISIONS[0]
    music: int = 60
    ball: str = PLAIN_BALL
    trail: str = PLAIN_TRAIL
    language: str = SYSTEM
    own_keys: OwnKeys = DEFAULT_KEYS

    @property
    def theme(self) -> Theme:
        """The colours."""
        theme = seen_by(self.vision, THEMES[self.colours])
        return theme if EffectKind.DEPTH in self.shown else without_depth(theme)

    @property
    def shown(self) -> Shown:
        """The effects to be seen."""
        wanted = (ALL if self.effects else PLAIN) - self.off
        return wanted - MOVING if self.reduced_motion else wanted

    def louder(self, steps: int) -> "Settings":
        """The volume some steps up, or down below 0; who turns it up wants to hear something."""
        volume = min(max(self.volume + steps * VOLUME_STEP, 0), LOUDEST)
        return self._replace(volume=volume, sound=self.sound or steps > 0)

    def other_colours(self) -> "Settings":
        """The next of THEMES, the first one after the last."""
        names = list(THEMES)
        return self._replace(colours=names[(names.index(self.colours) + 1) % len(names)])

    def toggled(self, kind: EffectKind) -> "Settings":
        """An effect wanted or not wanted any more."""
        return self._replace(off=self.off ^ {kind})
