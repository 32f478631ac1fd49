"""What the page and the game's Python say to each other, once a frame, in JSON."""

import msgspec

from game.web.client.functions.grading import GradingRequest


class KeyChange(msgspec.Struct, tag="key"):
    """A key went down or up. code: where it is; key: what is written on it, both as the browser names them."""

    code: str
    key: str
    down: bool


class LayoutKnown(msgspec.Struct, tag="layout"):
    """What is written on the keys, as far as the browser tells. written: characters by the code of the key."""

    written: dict[str, str]


class PointerChange(msgspec.Struct, tag="pointer"):
    """A mouse, a pen or a finger. phase: "down", "move", "up" or "cancel"; buttons: that are held, as bits."""

    phase: str
    id: int
    touch: bool
    x: float
    y: float
    buttons: int = 0


class WheelTurn(msgspec.Struct, tag="wheel"):
    """The wheel turned at a pixel. steps: above 0 away from the player."""

    steps: float
    x: float
    y: float


class PadState(msgspec.Struct, tag="pad"):
    """A gamepad in the browser's standard layout.

    buttons: how far each is pressed, 0 to 1. axes: -1 to 1, down positive. pad: 0 for the first gamepad.
    """

    buttons: list[float]
    axes: list[float]
    pad: int = 0


class WentAway(msgspec.Struct, tag="away"):
    """The page is hidden or has lost the keyboard."""


class Chosen(msgspec.Struct, tag="choose"):
    """A control of the page was used. id: of the item; value: of a choice, a switch or a text."""

    id: str
    value: str = ""


class FileGiven(msgspec.Struct, tag="file"):
    """A file was dropped on the page, or picked."""

    name: str
    data: bytes


class LinkOpened(msgspec.Struct, tag="link"):
    """The fragment of the page's address, decoded, without its sign."""

    fragment: str


class CodeTyped(msgspec.Struct, tag="code"):
    """The text in the editor is another one."""

    text: str


class Graded(msgspec.Struct, tag="graded"):
    """What became of a `GradingRequest`.

    number: of the request. reply: a `GradingReply` in JSON; "" where the worker had to be ended. function, call: what it did
    not answer then: the number of its call, from 1 on; "" and 1 for the text itself, "" and 0 where the worker has failed.
    """

    number: int
    reply: str = ""
    function: str = ""
    call: int = 0


PageSignal = (
    KeyChange
    | LayoutKnown
    | PointerChange
    | WheelTurn
    | PadState
    | WentAway
    | Chosen
    | FileGiven
    | LinkOpened
    | CodeTyped
    | Graded
)


class FrameRequest(msgspec.Struct):
    """A frame is wanted. seconds: since the last one. width, height: pixels of the canvas. density: of them per CSS pixel."""

    seconds: float
    width: int
    height: int
    signals: list[PageSignal] = []
    density: float = 1.0


class PageItem(msgspec.Struct, frozen=True):
    """A control of the page.

    kind: "button", "choice", "switch", "number", "text", or "buttons": several of them in a row; or what is only read: "words",
    "heading", "pair". value: of a choice, a switch, a number or a text. options: of a choice: values and words; of buttons:
    values, words, and names for a screen reader. hint: what it does; the second column of a pair. disabled: whether it cannot
    be used. low, high, step: of a number. picture: a list of primitives before the words, 48 pixels wide and high.
    """

    id: str
    label: str
    kind: str = "button"
    value: str = ""
    options: tuple[tuple[str, ...], ...] = ()
    hint: str = ""
    disabled: bool = False
    low: float = 0.0
    high: float = 0.0
    step: float = 0.0
    picture: tuple[float, ...] = ()


class PageMenu(msgspec.Struct, frozen=True):
    """A panel with controls.

    lines: of text above them. side: beside the picture, which stays in use; else over it. editor: whether the editor is above.
    focus: id of the control that has the keyboard when the menu opens; "" for the first one. uncaptured: if every key is sent
    to Python, the codes of those that are not; None if controls use keys as usual.
    """

    title: str
    lines: tuple[str, ...] = ()
    items: tuple[PageItem, ...] = ()
    side: bool = False
    editor: bool = False
    focus: str = ""
    uncaptured: tuple[str, ...] | None = None


class PageWords(msgspec.Struct, frozen=True):
    """The words around a scene of the lab; all are empty without a scene.

    scene: its title. step: above the picture. cited: the line of code that decides. scale: text size, relative to the page's
    text beside the controls. step, formula, note: HTML with formulas in MathML.
    """

    scene: str = ""
    step: str = ""
    formula: tuple[str, ...] = ()
    cited: str = ""
    note: str = ""
    scale: float = 1.0


class Download(msgspec.Struct, frozen=True):
    """A file for the player."""

    name: str
    data: bytes


class FrameReply(msgspec.Struct, omit_defaults=True):
    """The reply to a `FrameRequest`; the two lists of primitives are sent beside it.

    backdrop: whether the backdrop is a new one. texts: of the frame's list; backdrop_texts: of the backdrop's.
    colours: of the page's controls, by name. menu, toolbar: if they have changed.
    menu_closed: whether the menu was closed. sounds: number of the sound, gains of the left and the right ear.
    announcement: a sentence for a screen reader. described: the picture in words. fragment: of the page's address.
    keep: whether the stored files have changed. download: a file for the player. notification: a line to show for a moment.
    language: code of the texts' language. code: a text that replaces the editor's. grading: a text to be graded.
    full_screen: whether to switch full screen on or off. second_engine: whether to load it.
    words: around the picture, if they have changed. music: gains of its layers, if they have changed. limit: seconds within
    which the next reply has to come, since the player's own functions may hang; 0 for no limit.
    """

    backdrop: bool = False
    texts: list[str] = []
    backdrop_texts: list[str] = []
    colours: dict[str, str] = {}
    menu: PageMenu | None = None
    menu_closed: bool = False
    toolbar: tuple[PageItem, ...] | None = None
    sounds: list[tuple[int, float, float]] = []
    announcement: str = ""
    described: str = ""
    fragment: str | None = None
    keep: bool = False
    download: Download | None = None
    notification: str = ""
    full_screen: bool = False
    language: str = ""
    code: str | None = None
    grading: GradingRequest | None = None
    music: tuple[float, ...] | None = None
    limit: float = 0.0
    words: PageWords | None = None
    second_engine: bool = False
