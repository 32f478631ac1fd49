"""The controls beside the arena as rows of items, part by part."""

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

from game.drawing.palette import Colour, Theme, layer_colour
from game.editor import fields
from game.editor import session as editing
from game.editor.changes import redo_words, undo_words
from game.editor.fields import Field, PanelPart
from game.editor.session import EditorSession, value_of
from game.editor.symmetry import FOLDS
from game.editor.window.commands import CHANGES, COMMANDS, LAYERS, TINTS
from game.effects.pops import POWER_NAMES
from game.language import tr, tr_noop
from game.level_format.specs import DROP_KINDS, DropKind, GroundPattern, Palette
from game.rules import PowerUp
from game.screens.base import Screen
from game.screens.toolkit.items.basic import ButtonItem, ChoiceItem, Heading, Item, Space, Switch, TextItem
from game.screens.toolkit.items.chips import Chip, ChipsItem
from game.screens.toolkit.items.label import LabelItem
from game.screens.toolkit.items.number import NumberItem
from game.screens.toolkit.layout import Column, Row
from game.screens.toolkit.side_panel import Typing
from physics import PERMANENT

PARTS = tuple(PanelPart)
PALETTES: dict[Palette, str] = {
    "classic": tr_noop("Classic"),
    "ember": tr_noop("Ember"),
    "ocean": tr_noop("Ocean"),
    "forest": tr_noop("Forest"),
    "violet": tr_noop("Violet"),
    "ice": tr_noop("Ice"),
    "gold": tr_noop("Gold"),
    "dusk": tr_noop("Dusk"),
}
GROUNDS: dict[GroundPattern, str] = {
    "plain": tr_noop("Plain"),
    "rings": tr_noop("Rings"),
    "rays": tr_noop("Rays"),
    "dots": tr_noop("Dots"),
    "spiral": tr_noop("Spiral"),
}
_WIDE_TAB, _ABOVE_FOOT = 3.2, 0.3
"""Least width of the head of a part, and space above the common buttons; units of text."""


class EditorControls(NamedTuple):
    """What the controls show. theme: with the level's palette. typing: the number that is being typed; None if none is."""

    session: EditorSession
    part: PanelPart
    theme: Theme
    typing: Typing | None
    narrow: bool


class EditorCallbacks(NamedTuple):
    """The functions that the controls call.

    put: takes a changed session. command: runs one of `COMMANDS`, and returns the next screen. show: shows another part.
    edit: begins to type a number, or puts the caret at a distance from its field's left edge, pixels. enter: opens a panel for
    a text.
    """

    put: Callable[[EditorSession], None]
    command: Callable[[str], Screen | None]
    show: Callable[[PanelPart], None]
    edit: Callable[[Field, float | None], None]
    enter: Callable[[Field], Screen | None]


def controls(state: EditorControls, callbacks: EditorCallbacks) -> Column:
    """The whole column: at the top the level's name and the names of the parts, then the shown part, then common buttons."""
    session = state.session
    names = tuple([Chip(tr(part.value)) for part in PARTS])
    parts = ChipsItem(names, PARTS.index(state.part), lambda index: callbacks.show(PARTS[index]), least=_WIDE_TAB)
    title = Heading(session.document.level.name, tr("not saved") if session.changed else "")
    undo, redo = undo_words(session.history), redo_words(session.history)
    foot: list[Row] = [
        (Space(_ABOVE_FOOT),),
        (_long_button("undo", callbacks, tr("Undo: {change}").format(change=undo) if undo else tr("Nothing to undo")),),
        (_long_button("redo", callbacks, tr("Redo: {change}").format(change=redo) if redo else tr("Nothing to redo")),),
        *_buttons(("test", "save"), callbacks),
        *_buttons(("help", "leave"), callbacks),
    ]
    return Column(((title,), (parts,)), _BODIES[state.part](state, callbacks), tuple(foot))


def _bricks(state: EditorControls, callbacks: EditorCallbacks) -> tuple[Row, ...]:
    """The brush, how a stroke is repeated, and what is done with all bricks of a ring."""
    session, brush = state.session, state.session.brush
    layers = tuple([Chip(_layers_label(number), _layers_colour(state.theme, number, brush.tint or 0)) for number in LAYERS])
    tints = tuple([Chip(*("=",) if tint is None else (str(tint), layer_colour(state.theme, tint + 1))) for tint in TINTS])
    folds = tuple([Chip(f"×{fold}") for fold in FOLDS])
    fold = FOLDS.index(session.symmetry.fold)

    def fold_chosen(index: int) -> None:
        callbacks.put(session._replace(symmetry=session.symmetry._replace(fold=FOLDS[index])))

    fold_tip = tr("A stroke is repeated so often around the ring.")
    mirror = Switch(
        tr("Mirror"),
        session.symmetry.mirrored,
        lambda: callbacks.put(CHANGES["mirror"](session)),
        _tip("M", tr("A stroke is repeated at the other side of the vertical middle.")),
    )
    return (
        (LabelItem(tr(fields.LAYERS.label)),),
        (
            ChipsItem(
                layers,
                LAYERS.index(brush.layers),
                lambda index: callbacks.put(editing.brushed(session, LAYERS[index])),
                tr(fields.LAYERS.meaning),
            ),
        ),
        (LabelItem(tr(fields.TINT.label)),),
        (
            ChipsItem(
                tints,
                TINTS.index(brush.tint),
                lambda index: callbacks.put(editing.tinted(session, TINTS[index])),
                _tip("T", tr(fields.TINT.meaning)),
            ),
        ),
        (LabelItem(tr("Around the ring")),),
        (ChipsItem(folds, fold, fold_chosen, _tip("R", fold_tip), least=1.8),),
        (mirror,),
        *_buttons(("fill", "take"), callbacks),
        *_buttons(("copy", "paste"), callbacks),
    )


def _ring(state: EditorControls, callbacks: EditorCallbacks) -> tuple[Row, ...]:
    """Which ring, and its numbers."""
    session = state.session
    outward = editing.rings_outward(session)
    names = tuple([tr("{number} of {count}").format(number=number + 1, count=len(outward)) for number in range(len(outward))])
    tip = tr("From the innermost ring outward.")
    choice = ChoiceItem(
        tr("Ring"),
        names,
        outward.index(session.ring),
        lambda index: callbacks.put(editing.with_ring(session, outward[index])),
        _tip("Page up", tip),
    )
    return ((choice,), *_field_rows(fields.RING_FIELDS, state, callbacks), *_buttons(("add", "remove"), callbacks))


def _wells(state: EditorControls, callbacks: EditorCallbacks) -> tuple[Row, ...]:
    """Which gravity well, and its numbers."""
    session, count = state.session, len(state.session.document.level.wells)
    if not count:
        words = tr("A gravity well bends the flight of balls. There is none yet: click where one shall be, or add it here.")
        return (TextItem(words, faint=True),), *_buttons(("add-well",), callbacks)
    names = tuple([tr("{number} of {count}").format(number=number + 1, count=count) for number in range(count)])
    choice = ChoiceItem(tr("Well"), names, session.well, lambda index: callbacks.put(session._replace(well=index, message="")))
    return ((choice,), *_field_rows(fields.WELL_FIELDS, state, callbacks), *_buttons(("add-well", "remove-well"), callbacks))


def _paddles(state: EditorControls, callbacks: EditorCallbacks) -> tuple[Row, ...]:
    """Ball and paddles."""
    ball, paddles = (_field_rows(some, state, callbacks) for some in (fields.BALL_FIELDS, fields.PADDLE_FIELDS))
    return ((Heading(tr("Ball")),), *ball, (Heading(tr("Paddles")),), *paddles)


def _drops(state: EditorControls, callbacks: EditorCallbacks) -> tuple[Row, ...]:
    """Power-ups that broken bricks leave."""
    session, kinds = state.session, value_of(state.session, fields.KINDS)
    switches: list[Row] = []
    for kind in DROP_KINDS:
        words = tr(POWER_NAMES[PowerUp[kind.upper()]])
        tip = fields.KINDS.tip(fields.KINDS.path())
        turned = partial(_turn_kind, kind, session, callbacks)
        switches.append((Switch(words[:1].upper() + words[1:], kind in kinds, turned, tip),))
    return (*_field_rows((fields.CHANCE,), state, callbacks), *switches)


def _turn_kind(kind: DropKind, session: EditorSession, callbacks: EditorCallbacks) -> None:
    """Switch one power-up on or off."""
    kinds = value_of(session, fields.KINDS)
    after: list[str] = [other for other in DROP_KINDS if (other in kinds) != (other == kind)]
    none = session._replace(message=tr("At least one power-up; where there shall be none, let the chance be 0."))
    callbacks.put(editing.entered(session, fields.KINDS, after) if after else none)


def _level(state: EditorControls, callbacks: EditorCallbacks) -> tuple[Row, ...]:
    """Its texts, its size, its look."""
    session = state.session
    description = value_of(session, fields.DESCRIPTION)
    texts: list[Row] = [(_text_button(field, state, callbacks),) for field in (fields.NAME, fields.CHAPTER, fields.DESCRIPTION)]
    texts += [(TextItem(description, 1.0, faint=True),)] if description else []
    choices = [
        (_name_choice(field, names, state, callbacks),)
        for field, names in ((fields.PALETTE, PALETTES), (fields.GROUND, GROUNDS))
    ]
    return (*texts, *_field_rows((fields.GROUND_RADIUS,), state, callbacks), *choices)


_BODIES: dict[PanelPart, Callable[[EditorControls, EditorCallbacks], tuple[Row, ...]]] = {
    PanelPart.BRICKS: _bricks,
    PanelPart.RING: _ring,
    PanelPart.WELLS: _wells,
    PanelPart.PADDLES: _paddles,
    PanelPart.DROPS: _drops,
    PanelPart.LEVEL: _level,
}


def _field_rows(some: tuple[Field, ...], state: EditorControls, callbacks: EditorCallbacks) -> list[Row]:
    """A row for each of some keys: a number, or a switch."""
    return [(_switch(field, state, callbacks) if not field.step else _number(field, state, callbacks),) for field in some]


def _number(field: Field, state: EditorControls, callbacks: EditorCallbacks) -> NumberItem:
    """A number of the level."""
    session, typing = state.session, state.typing
    return NumberItem(
        tr(field.label),
        number_text(session, field) or tr("usual"),
        lambda steps: callbacks.put(editing.stepped(session, field, steps)),
        lambda pixels: callbacks.edit(field, pixels),
        field.tip(editing.path_of(session, field)),
        typing.field if typing is not None and typing.name == field else None,
    )


def number_text(session: EditorSession, field: Field) -> str:
    """A number as it is typed; "" if the file leaves it out."""
    value = value_of(session, field)
    return "" if value is None else f"{value:.10g}"


def _switch(field: Field, state: EditorControls, callbacks: EditorCallbacks) -> Switch:
    """A key that is true or false."""
    session, on = state.session, value_of(state.session, field)
    return Switch(
        tr(field.label),
        on,
        lambda: callbacks.put(editing.entered(session, field, not on)),
        field.tip(editing.path_of(session, field)),
    )


def _text_button(field: Field, state: EditorControls, callbacks: EditorCallbacks) -> ButtonItem:
    """A text of the level, which is entered on a panel of its own."""
    note = "" if field == fields.DESCRIPTION else value_of(state.session, field)
    return ButtonItem(tr(field.label), lambda: callbacks.enter(field), tip=field.tip(field.path()), note=note, framed=True)


def _name_choice(
    field: Field, names: dict[Palette, str] | dict[GroundPattern, str], state: EditorControls, callbacks: EditorCallbacks
) -> ChoiceItem:
    """A choice among the format's names."""
    known: list[str] = list(names)
    words, index = tuple([tr(name) for name in names.values()]), known.index(value_of(state.session, field))

    def choose(other: int) -> None:
        callbacks.put(editing.entered(state.session, field, known[other], field.path()))

    return ChoiceItem(tr(field.label), words, index, choose, field.tip(field.path()))


def _buttons(names: tuple[str, ...], callbacks: EditorCallbacks) -> list[Row]:
    """Rows of buttons for some commands."""
    items: list[Item] = [
        ButtonItem(
            tr(COMMANDS[name].label),
            partial(callbacks.command, name),
            tip=_tip(tr(COMMANDS[name].key), tr(COMMANDS[name].tip)),
            centred=True,
        )
        for name in names
    ]
    return [tuple(items)]


def _long_button(name: str, callbacks: EditorCallbacks, label: str) -> ButtonItem:
    """A button with a label of its own, and the command's key."""
    return ButtonItem(label, lambda: callbacks.command(name), note=tr(COMMANDS[name].key), framed=True)


def _tip(key: str, meaning: str) -> str:
    """The tip of a control with a key."""
    return f"{meaning} ({key})" if meaning else key


def _layers_label(layers: int | None) -> str:
    """The label of a brush's chip."""
    return "=" if layers is None else "-" if layers == PERMANENT else str(layers)


def _layers_colour(theme: Theme, layers: int | None, tint: int) -> Colour | None:
    """The colour, seen from above, of what a brush paints."""
    if layers is None:
        return None
    if layers > 0:
        return layer_colour(theme, layers + tint)
    return theme.ground if layers == 0 else theme.steel
