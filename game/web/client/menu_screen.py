"""A menu of the page, as a list of items. Behind it the autopilot plays, or another screen stands still."""

from collections.abc import Callable, Iterable
from typing import NamedTuple

from game.input.actions import Action
from game.input.signals import Pressed, Signal
from game.language import tr
from game.screens.demo import Demo
from game.web.client.messages import PageItem, PageMenu
from game.web.client.state import PageScreen, PageState, Pictures

_DEMO_SEED = 5
_ASIDE = 0.17
"""How far to the right the demonstration is, in shares of a wide canvas: the menu stands at the left."""
_STILL_SECONDS, _STEP = 6.0, 0.25
"""With reduced motion: the moment of the demonstration that is shown, and how it is reached."""
_GOES_ON = frozenset({"go-on", "next"})
"""Items with the same effect as going back: a menu with one of them has no further item for it."""


class Opened(NamedTuple):
    """An item of a menu, and what using it does: the screen that follows. Its argument is the control's value.

    used: None for what is only read.
    """

    item: PageItem
    used: Callable[[str], PageScreen] | None = None


class MenuScreen:
    """A menu over a game that plays itself, or over another screen that stands still."""

    fragment = ""

    def __init__(
        self,
        state: PageState,
        title: str,
        contents: Callable[["MenuScreen"], tuple[Iterable[str], Iterable[Opened]]],
        back: Callable[[], PageScreen] | None = None,
        under: PageScreen | None = None,
        *,
        focus: str = "",
        uncaptured: tuple[str, ...] | None = None,
    ) -> None:
        """contents: lines and items, asked for anew after every use. back: what Escape does. under: what stands behind it.

        focus, uncaptured: as of `PageMenu`.
        """
        self._focus, self._uncaptured = focus, uncaptured
        self.state, self._title, self._contents, self._back, self._under = state, title, contents, back, under
        self._menu: PageMenu | None = None
        self._used: dict[str, Callable[[str], PageScreen] | None] = {}

    @property
    def menu(self) -> PageMenu:
        """Its title, lines and items."""
        if self._menu is None:
            lines, opened = self._contents(self)
            opened = list(opened)
            if self._back is not None and not _GOES_ON.intersection([one.item.id for one in opened]):
                back = self._back
                opened.append(Opened(PageItem("back", tr("Back")), lambda _value: back()))
            self._used = {one.item.id: one.used for one in opened}
            self._menu = PageMenu(
                self._title,
                tuple(lines),
                tuple([one.item for one in opened]),
                focus=self._focus,
                uncaptured=self._uncaptured,
            )
        return self._menu

    @property
    def toolbar(self) -> tuple[PageItem, ...]:
        """None: the menu has all."""
        return ()

    @property
    def described(self) -> str:
        """What is behind it."""
        return tr("A game that plays itself.") if self._under is None else self._under.described

    def answer(self, signal: Signal, size: tuple[int, int]) -> PageScreen:
        """Escape and the pause key lead back."""
        del size
        if isinstance(signal, Pressed) and signal.action in (Action.BACK, Action.PAUSE) and self._back is not None:
            return self._back()
        return self

    def refresh(self) -> None:
        """Make its lines and items anew: a setting has changed elsewhere."""
        self._menu = None

    def choose(self, item: str, value: str) -> PageScreen:
        """What an item does; the menu is made anew."""
        if self._menu is None:
            _ = self.menu
        self._menu = None
        used = self._used.get(item)
        return self if used is None else used(value)

    def advance(self, seconds: float, size: tuple[int, int]) -> PageScreen:
        """Let the demonstration play, unless motion is reduced."""
        del size
        if self._under is None and not self.state.settings.reduced_motion:
            demo = _demo(self.state)
            demo.advance(seconds, self.state.settings.shown)
            if demo.ended:
                self.state.demo = None
        return self

    def draw(self, out: Pictures, size: tuple[int, int]) -> None:
        """What is behind the menu."""
        if self._under is not None:
            self._under.draw(out, size)
        else:
            scene = _demo(self.state).scene()
            seen = self.state.layout(size, scene.ground_radius)
            aside = _ASIDE * size[0] if seen.beside else 0.0
            self.state.draw_scene(out, scene, seen.camera._replace(centre=seen.camera.centre + aside), size)


def _demo(state: PageState) -> Demo:
    """The demonstration behind all menus; with reduced motion it stands still at some moment."""
    if state.demo is None:
        state.demo = Demo(state.levels[0], _DEMO_SEED)
        if state.settings.reduced_motion:
            for _ in range(round(_STILL_SECONDS / _STEP)):
                state.demo.advance(_STEP, state.settings.shown)
    return state.demo
