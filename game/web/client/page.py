"""Where the page enters: one object that gets a request for every frame and answers with pictures and words."""

import gc
import random
from array import array
from pathlib import Path

import msgspec

from game.drawing.camera import layout
from game.drawing.palette import Theme
from game.generated import sequence
from game.input.actions import Action
from game.input.keys import BINDINGS, KEYS, KeyTable
from game.input.signals import Pressed, Signal
from game.lab.kit.second_engine import Engine
from game.lab.session.session import state_hash as hash_of_session
from game.language import current, system_prefers
from game.levels import Level, classic, parse
from game.overlay import toast
from game.overlay.toast import Toast
from game.picture.display_list import DisplayList
from game.picture.toast import add_toast
from game.replays.file import decoded
from game.replays.state_hash import state_hash
from game.rules import paddle_ring
from game.screens.endless_seeds import LONGEST_SEED, seed_of
from game.settings.file import SettingsFile
from game.settings.keys import changed
from game.settings.values import Settings
from game.sound.music.mood import SILENT
from game.storage.storage import Storage
from game.student.own_physics import OwnPhysics
from game.system.errors import BadInputError
from game.web.client.controls_menu import KeyQuestion
from game.web.client.devices import PageDevices
from game.web.client.functions.panel import OwnFunctionsPanel
from game.web.client.functions.text import FunctionsText
from game.web.client.keys import position_at
from game.web.client.lab.screen import LabOnPage
from game.web.client.menu_screen import MenuScreen
from game.web.client.menus import Screens, title
from game.web.client.messages import (
    Chosen,
    CodeTyped,
    FileGiven,
    FrameReply,
    FrameRequest,
    Graded,
    KeyChange,
    LinkOpened,
    PadState,
    PageSignal,
    PageWords,
    PointerChange,
    WheelTurn,
)
from game.web.client.playing import GameOnPage
from game.web.client.settings_menu import settings_menu
from game.web.client.sounds import Sounds
from game.web.client.state import PageScreen, PageState, Pictures
from game.web.client.watching import ReplayOnPage, verdict

_REPLAY, _LEVEL, _FUNCTIONS = ".polar", ".toml", ".py"
_MOST_DIGITS = 5
_SPEEDS = (Action.LESS, Action.MORE)
_LIMIT = 8.0
"""Seconds for a frame in which the player's own functions may be asked: a loop in Python ends long before by itself."""
LAB_KEYS = KeyTable(BINDINGS)
"""What keys mean in the lab: what its help says, whatever the player has chosen for the game."""
_FIRST_SCENE = "case-1"
"""Beside the editor: the scene of the simplest function with a picture."""


class Page:
    """The game as the page sees it. numbers, backdrop: the lists of primitives of the last frame."""

    def __init__(self, sounds: bytes, folder: str, *, calm: bool, languages: str = "", touch: bool = False) -> None:
        """Start the page. sounds: a `SoundIndex`. folder: of stored files, "" for none.

        calm: whether the system prefers reduced motion, the default of that setting. languages: that the browser prefers,
        separated by commas. touch: whether the device is used by touch, until another input comes.
        """
        stored = Path(folder) if folder else None
        settings_file = None if stored is None else SettingsFile(stored / "settings.json")
        settings = None if settings_file is None else settings_file.load()
        if settings is None or settings == Settings():
            settings = Settings(reduced_motion=calm)
        system_prefers(languages.split(","))
        storage, chance = Storage(stored), random.SystemRandom()
        self._state = PageState(Sounds(sounds), stored, storage, settings_file, settings, lambda: chance.getrandbits(32))
        self._state.functions, self._state.touched = OwnFunctionsPanel(stored), touch
        self._state.use(settings)
        self._state.choose_difficulty(storage.progress.value.last_difficulty)
        self._screens = Screens(self._title, self._game, self._replay, self._lab, self._flight, self._settings, self._endless)
        self._screen: PageScreen = self._title()
        self._devices = PageDevices()
        self._pictures = Pictures(DisplayList(), DisplayList())
        self._shown: FrameReply = FrameReply()
        self._shown_backdrop: object = None
        self._size = (1, 1)
        self._music = SILENT
        if stored is None:
            self._state.notifications.append("nothing can be stored here: scores and replays last until the page is closed")
        else:
            self._state.notify_problems()
        gc.collect()
        gc.freeze()

    @property
    def numbers(self) -> "array[float]":
        """The list of the last frame."""
        return self._pictures.frame.numbers

    @property
    def backdrop(self) -> "array[float]":
        """The backdrop's list."""
        return self._pictures.backdrop.numbers

    def frame(self, request: str) -> str:
        """Answer a `FrameRequest` with a `FrameReply`, both in JSON."""
        asked = msgspec.json.decode(request, type=FrameRequest)
        size = (max(asked.width, 1), max(asked.height, 1))
        self._state.density = min(max(asked.density, 0.5), 4.0)
        for signal in asked.signals:
            self._hear(signal, size)
        self._screen = self._screen.advance(asked.seconds, size)
        self._state.toast = toast.later(self._state.toast, asked.seconds)
        self._music = self._state.music.advance(asked.seconds, self._state.settings)
        self._pictures.frame = DisplayList()
        self._screen.draw(self._pictures, size)
        self._draw_toast(size)
        return msgspec.json.encode(self._reply(size)).decode()

    def verify(self, data: bytes) -> str:
        """What playing a replay again shows: its verdict in one line."""
        try:
            return verdict(decoded(data, "replay"))
        except BadInputError as error:
            return str(error)

    def second_engine(self, engine: Engine) -> None:
        """Take the lab's second engine, which was loaded."""
        self._state.engine = engine
        if isinstance(self._screen, LabOnPage):
            self._screen.use_engine(engine)

    def probe(self) -> str:
        """How the game or the lab's scene stands, for tests: in JSON. {} where there is neither."""
        screen = self._screen
        if isinstance(screen, LabOnPage):
            return msgspec.json.encode(
                {
                    "line": screen.line,
                    "hash": hash_of_session(screen.session),
                    "panes": screen.panes,
                    "engine": "" if self._state.engine is None else self._state.engine.name,
                }
            ).decode()
        if not isinstance(screen, GameOnPage):
            return "{}"
        game = screen.game
        standing = {
            "level": game.level.name,
            "tick": game.tick,
            "score": game.score,
            "lives": game.lives,
            "phase": game.phase.name,
            "paddle": paddle_ring(game).phase,
            "results": len(game.results),
            "hash": state_hash(game),
            "since_serve": game.phase_tick,
            "captions": screen.captions,
            "ghost": "" if screen.ghost is None else state_hash(screen.ghost),
        }
        return msgspec.json.encode(standing).decode()

    def _hear(self, message: PageSignal, size: tuple[int, int]) -> None:
        """Let the screen answer a message."""
        match message:
            case Chosen(id=item, value=value):
                self._screen = self._screen.choose(item, value)
            case CodeTyped(text=text):
                self._state.functions.typed(text)
            case Graded():
                line = self._state.functions.graded(message)
                if line and isinstance(self._screen, LabOnPage):
                    self._screen.open(line)
            case FileGiven(name=name, data=data):
                self._open_file(name, data)
            case LinkOpened(fragment=fragment):
                self._open_link(fragment)
            case _:
                self._use(message, size)

    def _use(self, message: PageSignal, size: tuple[int, int]) -> None:
        """Let the screen answer a device."""
        self._devices.learn(message)
        match message:
            case PointerChange() | WheelTurn() if isinstance(self._screen, LabOnPage):
                self._screen.point(message, size)
            case KeyChange() | PadState() if isinstance(self._screen, KeyQuestion):
                self._answer_question(message, self._screen)
            case _:
                if isinstance(message, PointerChange):
                    self._state.touched = message.touch
                keys = LAB_KEYS if isinstance(self._screen, LabOnPage) else KEYS
                for signal in self._devices.signals(message, size, orbits=bool(self._state.view.goal), keys=keys):
                    if isinstance(self._screen, LabOnPage) or not self._changed_setting(signal):
                        self._screen = self._screen.answer(signal, size)

    def _changed_setting(self, signal: Signal) -> bool:
        """Whether a signal was of a key that changes a setting, which it does on every screen; some change a replay's speed."""
        if not isinstance(signal, Pressed) or (isinstance(self._screen, ReplayOnPage) and signal.action in _SPEEDS):
            return False
        if signal.action is Action.FULL_SCREEN:
            self._state.full_screen = True
        now = changed(self._state.settings, signal.action)
        if now is None:
            return False
        self._state.change(now.settings)
        self._state.toast = Toast(now.words, now.level)
        self._state.announcements.append(now.words)
        if isinstance(self._screen, MenuScreen):
            self._screen.refresh()
        return True

    def _answer_question(self, message: KeyChange | PadState, screen: KeyQuestion) -> None:
        """Give an action a key or a button."""
        if isinstance(message, PadState):
            for button in self._devices.pressed_buttons(message)[:1]:
                self._screen = screen.button(button)
        elif message.down:
            self._screen = screen.key(position_at(message.code, message.key))

    def _draw_toast(self, size: tuple[int, int]) -> None:
        """Draw the words about a key, over any screen but the lab."""
        state = self._state
        if state.toast is not None and not isinstance(self._screen, LabOnPage):
            add_toast(self._pictures.frame, state.toast, layout(size, 1.0), state.theme, state.text_unit(size))

    def _open_file(self, name: str, data: bytes) -> None:
        """A replay is shown, a level is played, functions are edited; anything else is refused in one line."""
        try:
            if name.lower().endswith(_REPLAY):
                self._screen = self._replay(name, data)
            elif name.lower().endswith(_LEVEL):
                level = parse(data, name)
                self._state.own[name] = level
                self._screen = self._game((level,))
            elif name.lower().endswith(_FUNCTIONS):
                self._edit(_text(name, data))
            else:
                self._state.notifications.append(
                    f"{name}: expected a replay ({_REPLAY}), a level ({_LEVEL}) or functions ({_FUNCTIONS})"
                )
        except BadInputError as error:
            self._state.notifications.append(str(error))

    def _open_link(self, fragment: str) -> None:
        """What the address names: level/3, classic/3, lab/ and a share line, or functions. The rest is refused in one line."""
        kind, _, rest = fragment.partition("/")
        if not fragment or fragment == self._screen.fragment:
            return
        try:
            levels = {"level": self._state.levels, "classic": classic()}.get(kind)
            number = int(rest) if rest.isascii() and rest.isdecimal() and len(rest) < _MOST_DIGITS else 0
            if levels is not None and 1 <= number <= len(levels):
                self._screen = self._game(levels[number - 1 :])
            elif kind == "endless" and rest:
                self._screen = self._endless(seed_of(rest[:LONGEST_SEED]))
            elif kind == "lab":
                self._screen = self._lab(rest)
            elif fragment == "functions":
                self._edit(None)
            else:
                self._state.notifications.append(
                    f"#{fragment[:80]}: expected #level/NUMBER, #classic/NUMBER, #endless/NUMBER, #lab/SCENE or #functions"
                )
        except BadInputError as error:
            self._state.notifications.append(str(error))

    def _reply(self, size: tuple[int, int]) -> FrameReply:
        """What has changed since the last frame."""
        state, screen, before = self._state, self._screen, self._shown
        menu, toolbar, colours = screen.menu, screen.toolbar, _colours(state.theme)
        resized = size != self._size
        words = screen.words if isinstance(screen, LabOnPage) else PageWords()
        new_backdrop = self._pictures.backdrop is not self._shown_backdrop or resized
        reply = FrameReply(
            backdrop=new_backdrop,
            texts=self._pictures.frame.texts,
            backdrop_texts=self._pictures.backdrop.texts if new_backdrop else [],
            colours=colours if colours != before.colours else {},
            menu=menu if menu != before.menu else None,
            menu_closed=menu is None and before.menu is not None,
            toolbar=toolbar if toolbar != before.toolbar else None,
            sounds=[_at_volume(sound, state.settings) for sound in state.started],
            announcement=" ".join(state.announcements),
            described=screen.described,
            fragment=screen.fragment if screen.fragment != before.fragment else None,
            keep=state.changed,
            download=state.download,
            full_screen=state.full_screen,
            notification=" ".join(state.notifications),
            music=self._music if self._music != before.music else None,
            limit=0.0 if state.functions.running is None else _LIMIT,
            code=state.functions.fresh,
            grading=state.functions.request,
            second_engine=state.asks_engine,
            words=words if words != before.words else None,
            language=current() if current() != before.language else "",
        )
        self._size, self._shown_backdrop = size, self._pictures.backdrop
        self._shown = FrameReply(
            colours=colours,
            menu=menu,
            toolbar=toolbar,
            fragment=screen.fragment,
            language=current(),
            music=self._music,
            words=words,
        )
        state.functions.fresh = state.functions.request = None
        state.asks_engine = False
        state.started, state.announcements, state.notifications, state.changed, state.download = [], [], [], False, None
        state.full_screen = False
        return reply

    def _title(self) -> PageScreen:
        """The title."""
        return title(self._state, self._screens)

    def _game(self, levels: tuple[Level, ...]) -> PageScreen:
        """A new game."""
        return GameOnPage(self._state, self._screens, levels)

    def _replay(self, name: str, data: bytes) -> PageScreen:
        """A recorded game; BadInputError for a broken one."""
        return ReplayOnPage(self._state, self._screens, name, data, decoded(data, name))

    def _flight(self, functions: FunctionsText) -> PageScreen:
        """A new game of all levels on the player's own functions."""
        return GameOnPage(self._state, self._screens, self._state.levels, OwnPhysics(functions))

    def _settings(self) -> PageScreen:
        """The settings, opened from the title."""
        return settings_menu(self._state, self._title)

    def _endless(self, seed: int) -> PageScreen:
        """A new game of the levels made from a seed."""
        return GameOnPage(self._state, self._screens, sequence(seed), endless=seed)

    def _edit(self, text: str | None) -> None:
        """The lab with the editor open. text: for the editor; None for what it holds."""
        if not isinstance(self._screen, LabOnPage):
            self._screen = self._lab(_FIRST_SCENE)
        self._state.functions.open(text)

    def _lab(self, line: str) -> PageScreen:
        """The lab. line: a share line, "" for the first scene."""
        return LabOnPage(self._state, self._screens, line)


def _text(name: str, data: bytes) -> str:
    """The text of a file; BadInputError for what is none."""
    try:
        return data.decode()
    except UnicodeDecodeError:
        raise BadInputError(f"{name}: expected text in UTF-8") from None


def _colours(theme: Theme) -> dict[str, str]:
    """The colours of the page's own controls."""
    named = {
        "background": theme.background,
        "panel": theme.panel,
        "edge": theme.panel_edge,
        "text": theme.text,
        "faint": theme.faint,
        "accent": theme.accent,
    }
    return {name: f"#{red:02x}{green:02x}{blue:02x}" for name, (red, green, blue) in named.items()}


def _at_volume(sound: tuple[int, float, float], settings: Settings) -> tuple[int, float, float]:
    """A sound as loud as the player wants it."""
    number, left, right = sound
    share = settings.volume / 100.0
    return number, left * share, right * share
