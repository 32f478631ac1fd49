"""The settings on the page: the desktop's, part by part."""

from collections.abc import Callable, Iterable
from functools import partial

from game.drawing.colour_vision import VISION_NAMES, VISIONS
from game.effects import EffectKind
from game.language import LANGUAGES, SYSTEM, tr
from game.screens.earned import feats
from game.settings.effect_names import effect_names
from game.settings.values import LOUDEST, SPEEDS, TEXT_SIZES, Settings
from game.unlocks import BALLS, TRAILS, Condition, ball_names, trail_names, unlocked
from game.web.client.controls_menu import controls_menu
from game.web.client.menu_screen import MenuScreen, Opened
from game.web.client.messages import PageItem
from game.web.client.state import PageScreen, PageState


def settings_menu(state: PageState, back: Callable[[], PageScreen], under: PageScreen | None = None) -> MenuScreen:
    """The menu of the settings."""

    def contents(menu: MenuScreen) -> tuple[Iterable[str], Iterable[Opened]]:
        held, part = state.settings, _Part(state, menu)
        languages = ((SYSTEM, tr("system language")), *[(language.code, language.name) for language in LANGUAGES])
        colours = (("dark", tr("Dark")), ("light", tr("Light")), ("contrast", tr("High contrast")))
        visions = tuple([(vision, tr(VISION_NAMES[vision])) for vision in VISIONS])
        again = partial(settings_menu, state, back, under)
        effects, keys = partial(_effects_menu, state, again, under), partial(controls_menu, state, again, under)
        ghost = tr("Pale outlines replay your best run of the level while you play.")
        words = tr("Important sounds in words, with where they come from.")
        motion = tr("No shake, flashes, waves or hit-stop, the camera cuts instead of gliding, and the title stands still.")
        return (), (
            _heading(tr("Picture")),
            part.choice("colours", tr("Colours"), colours),
            Opened(PageItem("full-screen", tr("Full screen")), lambda _value: _full_screen(state, menu)),
            part.switch("reduced_motion", tr("Reduced motion"), motion),
            part.switch("ghost", tr("Ghost"), ghost),
            part.choice("ball", tr("Ball"), *_unlocked(state, "ball", BALLS, ball_names())),
            part.choice("trail", tr("Trail"), *_unlocked(state, "trail", TRAILS, trail_names())),
            part.switch("effects", tr("Effects")),
            Opened(PageItem("one-by-one", tr("One by one"), disabled=not held.effects), lambda _value: effects()),
            _heading(tr("Sound")),
            part.switch("sound", tr("Sound")),
            part.number("volume", tr("Volume"), (0, LOUDEST), 10.0),
            part.number("music", tr("Music"), (0, LOUDEST), 10.0),
            _heading(tr("Keys")),
            Opened(PageItem("keys", tr("Choose keys and buttons")), lambda _value: keys()),
            _heading(tr("Accessibility")),
            part.choice("language", tr("Language"), languages),
            part.number("text_size", f"{tr('Text size')}, %", TEXT_SIZES, 25.0),
            part.choice("vision", tr("Colour vision"), visions),
            part.switch("captions", tr("Captions"), words),
            part.number("speed", tr("Game speed, %"), SPEEDS, 5.0),
            part.switch("one_button", tr("One button: the paddles turn by themselves, any press reverses them")),
        )

    return MenuScreen(state, tr("Settings"), contents, back, under)


def _heading(words: str) -> Opened:
    """What the settings below it are about."""
    return Opened(PageItem(f"heading-{words}", words, "heading"))


class _Part:
    """Makes the controls of a settings menu, each for a field of `Settings`."""

    def __init__(self, state: PageState, menu: MenuScreen) -> None:
        """Create it. menu: shown after a change."""
        self._state, self._menu = state, menu

    def switch(self, name: str, label: str, hint: str = "") -> Opened:
        """A setting that is on or off."""
        on = bool(getattr(self._state.settings, name))
        return Opened(PageItem(name, label, "switch", str(on), hint=hint), lambda value: self._change(name, value == "True"))

    def choice(self, name: str, label: str, options: tuple[tuple[str, str], ...], hint: str = "") -> Opened:
        """One of several values. options: values and labels."""
        now = str(getattr(self._state.settings, name))
        item = PageItem(name, label, "choice", now, options, hint=hint)
        return Opened(item, lambda value: self._change(name, value if value in dict(options) else now))

    def number(self, name: str, label: str, limits: tuple[int, int], step: float) -> Opened:
        """A whole number within limits."""
        now = int(getattr(self._state.settings, name))
        item = PageItem(name, label, "number", str(now), low=limits[0], high=limits[1], step=step)
        return Opened(item, lambda value: self._change(name, _whole(value, *limits, now)))

    def _change(self, name: str, value: object) -> PageScreen:
        """The menu after a setting was changed."""
        self._state.change(Settings(**{**self._state.settings._asdict(), name: value}))
        return self._menu


def _effects_menu(state: PageState, back: Callable[[], PageScreen], under: PageScreen | None) -> MenuScreen:
    """One switch for each effect."""

    def contents(menu: MenuScreen) -> tuple[Iterable[str], Iterable[Opened]]:
        def turns(kind: EffectKind) -> Callable[[str], PageScreen]:
            def turned(_value: str) -> PageScreen:
                state.change(state.settings.toggled(kind))
                return menu

            return turned

        names = effect_names().items()
        return (), [
            Opened(PageItem(f"effect-{kind}", name, "switch", str(kind not in state.settings.off), hint=tip), turns(kind))
            for kind, (name, tip) in names
        ]

    return MenuScreen(state, tr("Effects"), contents, back, under)


def _unlocked(
    state: PageState, field: str, conditions: dict[str, Condition], names: dict[str, str]
) -> tuple[tuple[tuple[str, str], ...], str]:
    """A choice among the unlocked values of a field of `Settings`, with a line that says how to unlock the next one."""
    earned, now = unlocked(conditions, feats(state.storage.progress.value)), getattr(state.settings, field)
    options = tuple([(name, words) for name, words in names.items() if name in earned or name == now])
    following = next((name for name in conditions if name not in earned), None)
    hint = tr("All of them are unlocked.") if following is None else f"{names[following]}: {conditions[following].text}"
    return options, hint


def _full_screen(state: PageState, menu: MenuScreen) -> PageScreen:
    """Switch full screen on or off."""
    state.full_screen = True
    return menu


def _whole(value: str, low: int, high: int, held: int) -> int:
    """The number in a text, within limits; `held` if the text is no number."""
    return min(max(int(value), low), high) if value.isascii() and value.isdecimal() and len(value) < 5 else held
