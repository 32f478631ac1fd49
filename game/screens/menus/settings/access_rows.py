"""The accessibility settings: language, size of text, colours, captions, speed, play with one button."""

from collections.abc import Callable

from game.drawing.colour_vision import VISION_NAMES, VISIONS
from game.language import LANGUAGES, SYSTEM, tr
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.toolkit.items.basic import ChoiceItem, Switch
from game.screens.toolkit.items.slider import Slider
from game.screens.toolkit.layout import Row
from game.settings.values import SPEEDS, TEXT_SIZES, Settings

_STEP = 5
"""Per cent."""


def access_rows(state: AppState, _panel: Screen) -> tuple[Row, ...]:
    """All rows of the tab."""
    settings = state.settings
    captions = tr("Important sounds in words at the upper right, with where they come from.")
    one_button = tr("In play the paddles turn by themselves; any key, click or tap reverses them and serves.")
    return (
        (_language(state),),
        (_text_size(state),),
        (_vision(state),),
        (_switch(state, tr("Captions"), captions, settings._replace(captions=not settings.captions), on=settings.captions),),
        (_speed(state),),
        (
            _switch(
                state,
                tr("One button"),
                one_button,
                settings._replace(one_button=not settings.one_button),
                on=settings.one_button,
            ),
        ),
    )


def _switch(state: AppState, label: str, tip: str, other: Settings, *, on: bool) -> Switch:
    """A setting that is on or off. other: the settings after it is turned."""
    return Switch(label, on, lambda: state.change(other), tip, (tr("off"), tr("on")))


def _text_size(state: AppState) -> Slider:
    """How large text is."""
    tip = tr("In menus and in play, 100 to 200 %.")

    def put(value: int) -> None:
        state.change(state.settings._replace(text_size=value))

    return _amount(tr("Text size"), state.settings.text_size, TEXT_SIZES, put, tip)


def _speed(state: AppState) -> Slider:
    """How fast the game is."""
    tip = tr("50 to 100 %; scores made below 100 % are marked.")

    def put(value: int) -> None:
        state.change(state.settings._replace(speed=value))

    return _amount(tr("Game speed"), state.settings.speed, SPEEDS, put, tip)


def _language(state: AppState) -> ChoiceItem:
    """The choice of the language, each by the name that its speakers use."""
    codes = [SYSTEM, *[language.code for language in LANGUAGES]]
    names = (tr("system language"), *[language.name for language in LANGUAGES])

    def choose(index: int) -> None:
        state.change(state.settings._replace(language=codes[index]))

    return ChoiceItem(_label(tr("Language"), "Language"), names, codes.index(state.settings.language), choose)


def _label(own: str, english: str) -> str:
    """A label with its English translation, so that it can be found in a language that the player cannot read."""
    return own if own == english else f"{own} ({english})"


def _vision(state: AppState) -> ChoiceItem:
    """Which colours the player sees."""

    def choose(index: int) -> None:
        state.change(state.settings._replace(vision=VISIONS[index]))

    names = tuple([tr(VISION_NAMES[vision]) for vision in VISIONS])
    tip = tr("Colours of bricks and paddles that can be told apart with a colour vision deficiency.")
    return ChoiceItem(tr("Colour vision"), names, VISIONS.index(state.settings.vision), choose, tip)


def _amount(label: str, value: int, limits: tuple[int, int], put: Callable[[int], None], tip: str) -> Slider:
    """An amount in per cent. limits: the least and the most. put: makes it another."""
    least, most = limits

    def step(steps: int) -> None:
        put(min(max(value + steps * _STEP, least), most))

    def put_share(share: float) -> None:
        put(least + _STEP * round(share * (most - least) / _STEP))

    return Slider(label, (value - least) / (most - least), tr("{percent} %").format(percent=value), step, put_share, tip)
