"""The controls of a scene on the page, and what a typed value makes of it."""

from collections.abc import Sequence

from game.lab.kit.parameters import Clamped, Count, Parameter, Point, clamped, plain
from game.lab.kit.picture import Picture, Toggle
from game.lab.kit.scene import EngineUse, LabScene
from game.lab.session import session as sessions
from game.lab.session.reveal import Reveal
from game.lab.session.session import PACES, Session
from game.lab.session.share import preset
from game.web.client.messages import PageItem


def scene_items(
    session: Session, scenes: Sequence[LabScene], picture: Picture, shown: frozenset[Toggle]
) -> tuple[PageItem, ...]:
    """The scene's values and what can be done with it. scenes: to choose from. shown: the toggles that are on."""
    scene = session.scene
    presets = (("", "-"), *[(one.line, one.label) for one in scene.presets])
    return (
        PageItem("scene", "Scene", "choice", scene.name, tuple([(one.name, one.title) for one in scenes])),
        PageItem("values", "Values worth a look", "choice", "", presets),
        *([] if not session.runs else _run_items(session)),
        *[item for parameter in scene.parameters for item in _value_items(parameter, session.given.values[parameter.name])],
        *_toggle_items(scene, picture, shown),
        PageItem("defaults", "Defaults"),
        PageItem("whole", "Whole scene"),
        PageItem("present", "Present", hint="For a lecture room: large text, step by step."),
        PageItem("course", "The course", hint="Questions and exercises about the slides."),
        PageItem("functions", "Your own functions", hint="An editor; graded in place."),
        PageItem("title", "Title"),
    )


def step_items(reveal: Reveal, picture: Picture) -> tuple[PageItem, ...]:
    """What reveals the picture step by step."""
    if not picture.steps:
        return ()
    if reveal.seen is None:
        return (PageItem("reveal", "Step by step"),)
    return (
        PageItem("page_down", "Next step"),
        PageItem("undo_step", "Step back", disabled=reveal.shown(picture) <= 1),
        PageItem("predict", "Guess first", "switch", str(reveal.predicts), hint="Drag your answer, then see it."),
        PageItem("reveal", "All at once"),
    )


def presenting_items(reveal: Reveal, picture: Picture) -> tuple[PageItem, ...]:
    """The buttons in a lecture room."""
    backs = [PageItem("page_up", "Back")]
    onward = "Next step" if picture.steps and reveal.seen is not None else "Next scene"
    return PageItem("page_down", onward), *backs, PageItem("present", "End")


def with_value(session: Session, item: str, value: str) -> Session:
    """The session after a control of `scene_items` was set: a value, those of a preset, or the pace."""
    kind, _, name = item.partition(":")
    match kind:
        case "values" if value:
            return sessions.changed(session, Clamped(preset(session.scene, value, session.given.engine), ()))
        case "value":
            return sessions.changed(session, _typed(session, name, value))
        case "pace" if value.isdecimal():
            return sessions.paced(session, int(value) - session.pace)
        case _:
            return session


def _run_items(session: Session) -> list[PageItem]:
    """The controls of a scene that runs."""
    paces = tuple([(str(number), f"1/{1.0 / pace:g}" if pace < 1.0 else "real time") for number, pace in enumerate(PACES)])
    return [
        PageItem("play", "Stop" if session.playing else "Run"),
        PageItem("forward", "Step"),
        PageItem("back", "Back"),
        PageItem("restart", "Restart"),
        PageItem("pace", "Pace", "choice", str(session.pace), paces),
    ]


def _value_items(parameter: Parameter, value: complex) -> list[PageItem]:
    """The fields of a parameter: one, or two for a point."""
    low, high = float(parameter.low), float(parameter.high)
    step = 1.0 if isinstance(parameter, Count) else parameter.step
    if isinstance(parameter, Point):
        parts = (("x", value.real), ("y", value.imag))
        return [
            PageItem(
                f"value:{parameter.name}.{axis}",
                f"{parameter.label} {axis}",
                "number",
                plain(number),
                hint=parameter.meaning,
                low=low,
                high=high,
            )
            for axis, number in parts
        ]
    unit = getattr(parameter, "unit", "")
    label = f"{parameter.label} ({unit})" if unit else parameter.label
    number = plain(value.real)
    return [PageItem(f"value:{parameter.name}", label, "number", number, hint=parameter.meaning, low=low, high=high, step=step)]


def _toggle_items(scene: LabScene, picture: Picture, shown: frozenset[Toggle]) -> list[PageItem]:
    """A switch for everything that can be hidden, and for pymunk's answer, also while pymunk is not loaded yet."""
    asked = {Toggle.PYMUNK} if scene.engine_use is EngineUse.TOGGLE else set[Toggle]()
    return [
        PageItem(f"toggle:{toggle.value}", toggle.value, "switch", str(toggle in shown))
        for toggle in Toggle
        if toggle in asked | picture.toggles
    ]


def _typed(session: Session, name: str, value: str) -> Clamped:
    """The values after one was typed; a note says where it is no number."""
    try:
        number = float(value)
    except ValueError:
        return Clamped(session.given, (f"'{value[:40]}' is not a number",))
    parameter, _, axis = name.partition(".")
    before = session.given.values.get(parameter, 0j)
    if axis:
        return clamped(
            session.scene.parameters,
            session.given,
            {parameter: complex(number, before.imag) if axis == "x" else complex(before.real, number)},
        )
    return clamped(session.scene.parameters, session.given, {parameter: number})
