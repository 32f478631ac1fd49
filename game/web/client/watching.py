"""A recorded game on the page: watched at any speed, verified, downloaded."""

from game import effects
from game.drawing.camera import unit_of
from game.effects import Effects
from game.input.actions import Action
from game.input.signals import FocusLost, Pressed, Signal
from game.language import grouped, tr
from game.loop.fixed_step import LONGEST_FRAME
from game.overlay.readings import readings
from game.picture.figures import Corners, add_figures
from game.replays.file import Recording
from game.replays.playback import Playback
from game.replays.verify import verified
from game.rules import TICK, Ticked
from game.scene import scene_at, still
from game.web.client.menus import Screens
from game.web.client.messages import Download, PageItem, PageMenu
from game.web.client.state import PageScreen, PageState, Pictures

_SPEEDS = (("0.25", "¼ x"), ("1", "1 x"), ("4", "4 x"), ("16", "16 x"))
_SECOND = round(1.0 / TICK)


class ReplayOnPage:
    """Shows a recording; its clock counts ticks, with a fraction, to draw moments between two."""

    fragment = ""

    def __init__(self, state: PageState, screens: Screens, name: str, data: bytes, recording: Recording) -> None:
        """name, data: of the file. recording: what it holds."""
        self._state, self._screens, self._name, self._data, self._recording = state, screens, name, data, recording
        self._frames = Playback(recording)
        self._at, self._speed, self._playing = 0.0, "1", True
        self._effects = Effects()
        self._ticked: Ticked = still(self._frames.game(0))
        self._verdict = ""

    @property
    def menu(self) -> PageMenu:
        """The controls of the recording."""
        seconds = int(self._at) // _SECOND
        items = (
            PageItem("play", tr("Stop") if self._playing else tr("Play")),
            PageItem("second", tr("Second"), "number", str(seconds), high=self._frames.ticks // _SECOND, step=1.0),
            PageItem("speed", tr("Speed"), "choice", self._speed, _SPEEDS),
            PageItem("verify", tr("Verify"), hint=tr("Plays it again and compares every hash.")),
            PageItem("download", tr("Download")),
            PageItem("title", tr("Main menu")),
        )
        return PageMenu(self._name, (self._verdict,) if self._verdict else (), items, side=True)

    @property
    def toolbar(self) -> tuple[PageItem, ...]:
        """The view."""
        return (PageItem("view", tr("View from above") if self._state.view.goal else tr("View in 3D")),)

    @property
    def described(self) -> str:
        """Where it stands."""
        shown = readings(self._ticked.game)
        return tr("A recorded game of {level}. Score {score}.").format(level=shown.level_name, score=shown.score)

    def answer(self, signal: Signal, size: tuple[int, int]) -> PageScreen:
        """Play, stop, step, leave."""
        match signal:
            case Pressed(Action.BACK):
                return self._screens.title()
            case Pressed(Action.SERVE | Action.PAUSE):
                self._playing = not self._playing
            case Pressed(Action.LESS | Action.MORE as action):
                speeds = list(dict(_SPEEDS))
                faster = speeds.index(self._speed) + (1 if action is Action.MORE else -1)
                self._speed = speeds[min(max(faster, 0), len(speeds) - 1)]
            case Pressed(action):
                self._move(action)
            case FocusLost():
                self._playing = False
        self._state.view = self._state.view.after(signal, unit_of(size))
        return self

    def choose(self, item: str, value: str) -> PageScreen:
        """What a control does."""
        match item:
            case "title":
                return self._screens.title()
            case "play":
                self._playing = not self._playing
            case "second" if value.isascii() and value.isdecimal() and len(value) < 6:
                self._seek(int(value) * _SECOND)
            case "speed" if value in dict(_SPEEDS):
                self._speed = value
            case "view":
                self._state.view = self._state.view.after(Pressed(Action.TIP), 1.0)
            case "verify":
                self._verdict = verdict(self._recording)
            case "download":
                self._state.download = Download(self._name, self._data)
        return self

    def advance(self, seconds: float, size: tuple[int, int]) -> PageScreen:
        """Let it run."""
        state = self._state
        state.view = state.view.later(seconds, smooth=not state.settings.reduced_motion)
        if self._playing:
            goal = min(self._at + min(seconds, LONGEST_FRAME) / TICK * float(self._speed), float(self._frames.ticks))
            camera = state.layout(size, self._ticked.game.level.ground_radius).camera
            for number in range(int(self._at), int(goal)):
                self._ticked = self._frames.ticked(number)
                self._effects = effects.after(self._effects, self._ticked, state.settings.shown)
                state.play_sounds(self._ticked, camera)
            self._at = goal
            self._playing = self._at < self._frames.ticks
        return self

    def draw(self, out: Pictures, size: tuple[int, int]) -> None:
        """The arena and the figures."""
        seen, unit = self._state.layout(size, self._ticked.game.level.ground_radius), self._state.text_unit(size)
        self._state.draw_scene(out, scene_at(self._ticked, self._at % 1.0, self._effects), seen.camera, size)
        shown = readings(self._ticked.game, self._effects.streak, badge=tr("replay"))
        add_figures(out.frame, shown, Corners(seen, self._state.theme, unit))

    def _move(self, action: Action) -> None:
        """Go where a key leads."""
        match action:
            case Action.STEP:
                self._step(1)
            case Action.STEP_BACK:
                self._step(-1)
            case Action.LEFT:
                self._seek(int(self._at) - _SECOND)
            case Action.RIGHT:
                self._seek(int(self._at) + _SECOND)
            case Action.START:
                self._seek(0)
            case Action.END:
                self._seek(self._frames.ticks)

    def _step(self, ticks: int) -> None:
        """Stopped, some ticks later."""
        self._playing = False
        self._seek(int(self._at) + ticks)

    def _seek(self, number: int) -> None:
        """At a tick, with no effect to be seen."""
        number = min(max(number, 0), self._frames.ticks)
        self._at = float(number)
        self._effects = Effects() if number else effects.at_start(self._state.settings.shown)
        self._ticked = self._frames.ticked(number - 1) if number else still(self._frames.game(0))


def verdict(recording: Recording) -> str:
    """Whether a recording plays again to the same hashes, in words."""
    found = verified(recording)
    if found.divergence is not None:
        return str(found.divergence)
    return tr("{ticks} ticks, every hash agrees").format(ticks=grouped(found.game.tick))
