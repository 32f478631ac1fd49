"""Screens one after the other, played by posted events on the dummy driver."""

import pygame

from game.drawing.palette import DARK, LIGHT
from game.levels import classic
from game.loop import app
from game.loop.session_seed import game_seed
from game.replays.state_hash import state_hash
from game.rules import Phase, new_game, tick
from game.screens.menus.help.panel import Help
from game.screens.menus.results import ResultsPanel
from game.screens.menus.settings.panel import SettingsPanel
from game.screens.play import buttons as play_buttons
from game.screens.play.screen import PlayScreen
from game.screens.title import Title
from game.screens.toolkit.menu import Menu
from tests.support.windows.dummy_window import FRAME, SIZE


def test_a_whole_evening(desk, ticks):
    """Keys alone lead from the title through serve, steering, pause and restart back to the title and out."""
    desk.press(pygame.K_RETURN)
    desk.wait(0.2)
    assert ticks[-1][1].phase == Phase.SERVING
    desk.press(pygame.K_SPACE)
    desk.hold(pygame.K_RIGHT)
    desk.wait(0.3)
    desk.release(pygame.K_RIGHT)
    assert ticks[-1][1].phase == Phase.PLAYING
    assert ticks[-1][1].arena.rings[0].spin > 0.0
    desk.press(pygame.K_p)
    assert isinstance(desk.screen, Menu)
    stopped = len(ticks)
    desk.wait(1.0)
    assert len(ticks) == stopped
    desk.press(pygame.K_p)
    desk.wait(1.0)
    assert len(ticks) > stopped
    desk.press(pygame.K_r, pygame.K_r)
    assert isinstance(desk.screen, PlayScreen)
    desk.wait(0.1)
    assert ticks[-1][1].tick < 30
    desk.press(pygame.K_ESCAPE)
    desk.choose("Main menu")
    assert isinstance(desk.screen, Title)
    desk.press(pygame.K_ESCAPE, pygame.K_RETURN)
    assert isinstance(desk.screen, Title)
    desk.press(pygame.K_ESCAPE)
    desk.choose("Quit")
    assert desk.screen is None


def test_what_is_recorded_plays_again(playing, ticks):
    """The recorder's controls, given to the rules alone, lead to the state of the game on the screen."""
    playing.move((400, 100))
    playing.wait(0.4)
    playing.press(pygame.K_SPACE)
    playing.hold(pygame.K_a)
    playing.wait(0.5)
    playing.release(pygame.K_a)
    playing.move((100, 350))
    playing.wait(1.0)
    game = new_game(classic(), 7)
    for controls, after in ticks:
        game = tick(game, controls).game
        assert after.tick == game.tick
    assert state_hash(game) == state_hash(ticks[-1][1])
    assert {controls.turn for controls, _ in ticks} == {0, -1}
    assert any(controls.pointer is not None for controls, _ in ticks)


def test_escape_twice_loses_nothing(playing, ticks):
    """Esc pauses the game, and Esc again goes on."""
    playing.press(pygame.K_SPACE)
    playing.wait(0.1)
    playing.press(pygame.K_ESCAPE, pygame.K_ESCAPE)
    assert isinstance(playing.screen, PlayScreen)
    before = len(ticks)
    playing.wait(1.0)
    assert len(ticks) > before


def test_restart_asks_first(playing, ticks):
    """R opens a question; Esc and Enter there go on with the game."""
    playing.press(pygame.K_SPACE)
    playing.wait(0.2)
    for answer in (pygame.K_ESCAPE, pygame.K_RETURN):
        before = ticks[-1][1].tick
        playing.press(pygame.K_r)
        assert isinstance(playing.screen, Menu)
        playing.press(answer)
        playing.wait(1.0)
        assert ticks[-1][1].tick > before


def test_losing_the_focus_pauses_and_lets_go(playing, ticks):
    """A window that loses the focus pauses the game, and a key that was held counts as released."""
    playing.hold(pygame.K_RIGHT)
    playing.wait(0.2)
    playing.post(pygame.WINDOWFOCUSLOST)
    assert isinstance(playing.screen, Menu)
    playing.press(pygame.K_RETURN)
    playing.wait(0.2)
    assert ticks[-1][0].turn == 0


def test_after_a_pause_there_is_a_moment_to_get_ready(playing, ticks):
    """With a ball in play no tick runs in the first half second after a pause; before a serve ticks run at once."""
    playing.press(pygame.K_p, pygame.K_p)
    before = len(ticks)
    playing.wait(0.1)
    assert len(ticks) > before
    playing.press(pygame.K_SPACE)
    playing.press(pygame.K_p, pygame.K_p)
    before = len(ticks)
    playing.wait(0.3)
    assert len(ticks) == before
    playing.wait(0.6)
    assert len(ticks) > before


def test_help_opens_over_everything_and_closes_again(desk):
    """H and F1 open it over the title, a game and its pause, and close it; so do Esc and Enter."""
    for kind, leads_on in ((Title, pygame.K_RETURN), (PlayScreen, pygame.K_p), (Menu, None)):
        assert isinstance(desk.screen, kind)
        keys = (pygame.K_h, pygame.K_F1) if kind is not Menu else (pygame.K_h,)
        for opens, closes in zip(keys, (pygame.K_ESCAPE, pygame.K_RETURN), strict=False):
            desk.press(opens)
            assert isinstance(desk.screen, Help)
            desk.press(closes)
            assert isinstance(desk.screen, kind)
            desk.press(opens, opens)
            assert isinstance(desk.screen, kind)
        if leads_on is not None:
            desk.press(leads_on)


def test_the_buttons_beside_the_arena_are_keys(playing, ticks):
    """Pause, help and settings open with a click beside the arena; the same click serves no ball."""
    boxes = play_buttons.button_boxes(playing.screen._layout(SIZE))
    for box, kind in zip(boxes, (Menu, Help, SettingsPanel), strict=True):
        playing.move(box.center)
        playing.click(box.center)
        assert type(playing.screen) is kind
        playing.click(playing.screen._form_layout(SIZE).close.center)
        assert isinstance(playing.screen, PlayScreen)
    playing.wait(0.1)
    assert {controls.serve for controls, _ in ticks} == {False}


def test_menus_answer_to_the_mouse(playing):
    """Moving over an entry selects it, a click on it chooses it, and a click elsewhere does nothing."""
    playing.press(pygame.K_p)
    playing.click((1, 1))
    assert isinstance(playing.screen, Menu)
    playing.move(playing.box("Restart").center)
    playing.wait(FRAME)
    assert playing.screen._focus == (2, 0)
    playing.click_on("Main menu")
    assert isinstance(playing.screen, Title)


def test_a_still_screen_is_drawn_once(playing, monkeypatch):
    """A panel is not drawn again in the frames after the first; a key, another size and a picture lost draw it again."""
    playing.press(pygame.K_p)
    drawn = []
    monkeypatch.setattr(Menu, "draw", lambda _, surface: drawn.append(surface.get_size()))
    playing.wait(0.5)
    assert drawn == []
    playing.press(pygame.K_DOWN)
    playing.wait(0.5)
    assert len(drawn) == 1
    playing.post(pygame.WINDOWEXPOSED)
    playing.wait(0.5)
    assert len(drawn) == 2
    playing.window.size = (700, 500)
    playing.wait(0.5)
    assert drawn[2:] == [(700, 500)]


def test_nothing_moves_while_the_player_is_in_another_window(desk, monkeypatch):
    """The demonstration stands still while the window has no focus, at few frames a second, and goes on with it."""
    seconds, rates = [], []
    real = desk.screen.advance
    monkeypatch.setattr(desk.screen, "advance", lambda time, size: seconds.append(time) or real(time, size))
    events = iter([pygame.WINDOWFOCUSLOST, None, None, pygame.WINDOWFOCUSGAINED, None, pygame.QUIT])

    class Pace:
        def wait(self, rate):
            rates.append(rate)
            if (kind := next(events, None)) is not None:
                pygame.event.post(pygame.Event(kind))

    monkeypatch.setattr(app, "FramePace", Pace)
    app.run(desk.window, desk.shared, desk.screen)
    assert [time == 0.0 for time in seconds] == [False, False, True, True, True, False]
    assert rates[:6] == [30, 10, 10, 10, 30, 30]


def test_the_title_plays_by_itself(desk):
    """The demonstration scores, and after its end another one begins."""
    desk.wait(6.0)
    assert desk.screen._demo._ticked.game.score > 0
    first = desk.screen._demo
    for _ in range(4000):
        desk.screen.advance(0.25, SIZE)
        if desk.screen._demo is not first:
            break
    assert desk.screen._demo is not first


def test_losing_every_ball_ends_the_game(playing, ticks):
    """Serving without steering loses all balls. Keys pressed meanwhile choose nothing; "This level again" begins anew."""
    for _ in range(4000):
        if not isinstance(playing.screen, PlayScreen):
            break
        playing.hold(pygame.K_SPACE)
        playing.hold(pygame.K_RIGHT)
        playing.wait(FRAME)
    assert ticks[-1][1].phase == Phase.OVER
    assert ticks[-1][1].phase_tick >= 200
    assert isinstance(playing.screen, ResultsPanel)
    playing.wait(5.0)
    playing.choose("This level again")
    playing.wait(0.1)
    assert ticks[-1][1].tick < 30


def test_switches_work_on_every_screen(desk):
    """M, T and E switch sound, colours and effects on the title, in a game and in its pause menu; T has three colours."""
    for opens in (None, pygame.K_RETURN, pygame.K_p):
        if opens is not None:
            desk.press(opens)
        desk.press(pygame.K_m, pygame.K_t, pygame.K_e)
        chosen = desk.shared.settings
        assert (chosen.sound, chosen.theme, chosen.effects) == (False, LIGHT, False)
        assert desk.shared.theme is LIGHT
        desk.press(pygame.K_m, pygame.K_t, pygame.K_t, pygame.K_e)
        chosen = desk.shared.settings
        assert (chosen.sound, chosen.theme, chosen.effects) == (True, DARK, True)


def test_a_stall_runs_at_most_60_ticks(playing, ticks):
    """A frame that took an hour runs at most 60 ticks."""
    before = len(ticks)
    playing.screen = app.frame(playing.window, playing.shared, playing.screen, 3600.0)
    assert len(ticks) - before <= 60


def test_a_clock_that_jumps_back_runs_nothing_and_breaks_nothing(playing, ticks):
    """A frame of negative length runs no tick, and the game goes on afterwards."""
    playing.press(pygame.K_SPACE, pygame.K_MINUS)
    before = len(ticks)
    playing.screen = app.frame(playing.window, playing.shared, playing.screen, -7200.0)
    assert len(ticks) == before
    playing.wait(0.5)
    assert len(ticks) >= before + 110


def test_a_key_shows_in_the_next_frame(playing):
    """The picture after a key press differs from the one without it."""
    playing.wait(0.2)
    surface = playing.window.get_surface()

    def paddles():
        return playing.screen._ticked.game.arena.rings[0].phase

    before, still = pygame.image.tobytes(surface, "RGB"), paddles()
    playing.hold(pygame.K_RIGHT)
    playing.wait(FRAME)
    assert paddles() != still
    assert pygame.image.tobytes(surface, "RGB") != before


def test_every_game_of_a_session_has_a_seed_of_its_own(playing, ticks):
    """The first one the session's, the others made of it and their number: the same again in another session; all recorded."""
    for _ in range(2):
        playing.wait(FRAME)
        playing.press(pygame.K_r)
        playing.choose("From the first level")
    playing.wait(FRAME)
    seeds = list(dict.fromkeys([game.seed for _, game in ticks]))
    assert seeds == [game_seed(playing.shared.seed, number) for number in range(3)]
    assert seeds == [7, 3825955368494240696, 4910021442178799501]
