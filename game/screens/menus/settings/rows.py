"""What can be set: the rows of every part of the settings, what each means, and what using it does."""

from collections.abc import Callable
from typing import NamedTuple

from game.effects import MOVING, PLAIN, EffectKind
from game.input.key_names import key_name
from game.input.keys import Action
from game.language import tr
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.earned import feats
from game.screens.menus.settings.access_rows import access_rows
from game.screens.menus.settings.ball_preview import ball_preview
from game.screens.menus.settings.control_rows import WIDE_TEXT, control_rows
from game.screens.toolkit.items.basic import ChoiceItem, Heading, Item, Switch, TextItem
from game.screens.toolkit.items.slider import Slider
from game.screens.toolkit.layout import Row
from game.settings.effect_names import effect_names
from game.settings.values import LOUDEST, VOLUME_STEP, Settings
from game.unlocks import BALLS, TRAILS, Condition, ball_names, trail_names, unlocked


class SettingsPart(NamedTuple):
    """A part of the settings. name: in the player's language; rows: as they are now, on a panel."""

    name: Callable[[], str]
    rows: Callable[[AppState, Screen], tuple[Row, ...]]


def _switch(state: AppState, label: str, field: str, tip: str) -> Switch:
    """A setting that is on or off. field: of `Settings`."""
    on = bool(getattr(state.settings, field))

    def turned() -> None:
        state.change(Settings(**{**state.settings._asdict(), field: not on}))

    return Switch(label, on, turned, tip, (tr("off"), tr("on")))


def _picture(state: AppState, _panel: Screen) -> tuple[Row, ...]:
    """Colours and motion."""
    names = {"dark": tr("Dark"), "light": tr("Light"), "contrast": tr("High contrast")}
    keys = list(names)

    def choose(index: int) -> None:
        state.change(state.settings._replace(colours=keys[index]))

    def switch_full_screen() -> None:
        state.wants_full_screen = not state.full_screen

    colours = ChoiceItem(
        tr("Colours"),
        tuple(names.values()),
        keys.index(state.settings.colours),
        choose,
        tr("{key} changes them at any time.").format(key=key_name(Action.THEME)),
    )
    screen = Switch(
        tr("Full screen"),
        state.full_screen,
        switch_full_screen,
        tr("{key} changes it at any time.").format(key=key_name(Action.FULL_SCREEN)),
        (tr("off"), tr("on")),
    )
    motion = tr("No shake, flashes, waves or hit-stop, the camera cuts instead of gliding, and the title stands still.")
    return (
        (colours,),
        (screen,),
        (_switch(state, tr("Reduced motion"), "reduced_motion", motion),),
        (_switch(state, tr("Ghost"), "ghost", tr("Pale outlines replay your best run of the level while you play.")),),
        (_unlockable(state, tr("Ball"), "ball", BALLS, ball_names()),),
        (_unlockable(state, tr("Trail"), "trail", TRAILS, trail_names()),),
        (ball_preview(),),
    )


def _unlockable(state: AppState, label: str, field: str, conditions: dict[str, Condition], names: dict[str, str]) -> Item:
    """A choice among what the player has earned, or words on how to earn some. field: of `Settings`; what it holds stays."""
    now = str(getattr(state.settings, field))
    earned = unlocked(conditions, feats(state.storage.progress.value))
    open_ones = [name for name in conditions if name in earned or name == now]
    following = next((name for name in conditions if name not in earned), None)
    tip = tr("All of them are unlocked.") if following is None else f"{names[following]}: {conditions[following].text}"
    if len(open_ones) == 1:
        return TextItem(tr("{what}: {name}. To unlock: {how}").format(what=label, name=names[now], how=tip))

    def choose(index: int) -> None:
        state.change(Settings(**{**state.settings._asdict(), field: open_ones[index]}))

    return ChoiceItem(label, tuple([names[name] for name in open_ones]), open_ones.index(now), choose, tip)


def _effects(state: AppState, _panel: Screen) -> tuple[Row, ...]:
    """One switch for all, and one for each, in two columns where there is room."""
    tip = tr("Everything listed below except the trail; {key} turns it off and on at any time.").format(
        key=key_name(Action.EFFECTS)
    )
    items = [_effect(state, kind, *words) for kind, words in effect_names().items()]
    columns = 1 if state.text_scale > WIDE_TEXT else 2
    rows: list[Row] = [tuple(items[first : first + columns]) for first in range(0, len(items), columns)]
    return ((_switch(state, tr("Effects"), "effects", tip),), (Heading(tr("One by one")),), *rows)


def _effect(state: AppState, kind: EffectKind, label: str, tip: str) -> Switch:
    """The switch of one effect. It is overruled where it is wanted but not seen all the same."""
    settings, why = state.settings, ""
    on = kind not in settings.off
    if on and not settings.effects and kind not in PLAIN:
        why = tr("Off now, since effects are off.")
    elif on and settings.reduced_motion and kind in MOVING:
        why = tr("Off now, since motion is reduced.")
    words = (tr("off"), tr("on"))
    return Switch(label, on, lambda: state.change(state.settings.toggled(kind)), f"{tip} {why}".strip(), words, bool(why))


def _sound(state: AppState, _panel: Screen) -> tuple[Row, ...]:
    """Loudness of all sounds, and of the music beside them."""

    def step_music(steps: int) -> None:
        put_music(state.settings.music / LOUDEST + steps * VOLUME_STEP / LOUDEST)

    def put_music(level: float) -> None:
        state.change(state.settings._replace(music=round(min(max(level, 0.0), 1.0) * LOUDEST)))

    def step(steps: int) -> None:
        state.change(state.settings.louder(steps))

    def put(level: float) -> None:
        state.change(state.settings._replace(volume=round(level * LOUDEST)))

    volume, music = state.settings.volume, state.settings.music
    music_tip = tr("The music's volume; more instruments join with every brick in a row and with a level's last bricks.")
    tip = tr("Left and right change it; so do {less} and {more} at any time.").format(
        less=key_name(Action.LESS), more=key_name(Action.MORE)
    )
    return (
        (_switch(state, tr("Sound"), "sound", tr("{key} turns it off and on at any time.").format(key=key_name(Action.MUTE))),),
        (Slider(tr("Volume"), volume / LOUDEST, f"{volume} %", step, put, tip),),
        (Slider(tr("Music"), music / LOUDEST, f"{music} %", step_music, put_music, music_tip),),
    )


PARTS = (
    SettingsPart(lambda: tr("Picture"), _picture),
    SettingsPart(lambda: tr("Effects"), _effects),
    SettingsPart(lambda: tr("Sound"), _sound),
    SettingsPart(lambda: tr("Keys"), control_rows),
    SettingsPart(lambda: tr("Accessibility"), access_rows),
)
