"""What the player has chosen, on every screen and in every game: a value, and the steps from one to another."""

from typing import NamedTuple

from game.drawing.palette import DARK, LIGHT, Theme
from game.effects import ALL, MOVING, PLAIN, EffectKind, Shown

LOUDEST = 100
VOLUME_STEP = 10
THEMES = {"dark": DARK, "light": LIGHT}


class Settings(NamedTuple):
    """One choice of everything."""

    colours: str = "dark"  # a key of THEMES
    sound: bool = True
    volume: int = 80  # 0 to LOUDEST
    reduced_motion: bool = False
    effects: bool = True  # any but the trail
    off: frozenset[EffectKind] = frozenset()  # effects that are not wanted

    @property
    def theme(self) -> Theme:
        """The colours."""
        return THEMES[self.colours]

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
        """Dark to light and back."""
        return self._replace(colours="light" if self.colours == "dark" else "dark")

    def toggled(self, kind: EffectKind) -> "Settings":
        """An effect wanted or not wanted any more."""
        return self._replace(off=self.off ^ {kind})
