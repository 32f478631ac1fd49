"""What a game leaves behind: bests and ranks, the ghost of the best run, high scores; and where the next one begins."""

import msgspec
import pygame

from game.autopilot import Autopilot
from game.generated import sequence
from game.levels import classic
from game.rules import Phase, Ruleset, new_game, tick
from game.screens.endless_seeds import seed_of
from game.screens.gallery.sample import sample_state
from game.screens.menus.level_select import next_level
from game.screens.menus.results import ResultsPanel
from game.screens.play.screen import PlayScreen
from game.screens.title import Title
from game.storage import ghost
from game.storage.progress import Best, record_name
from game.storage.scores import ENDLESS, objection
from game.storage.storage import Storage
from physics import direction
from tests.support.windows.sessions import lose


def with_one_brick(game):
    """A game in play with one layer of one brick left, which the ball flies to."""
    ball, wall = game.arena.balls[0], game.arena.rings[1]
    path = [ball.position + ball.velocity * step / 100.0 for step in range(300)]
    touched = next(point for point in path if abs(point) < wall.outer_radius)
    slot = min(range(wall.count), key=lambda slot: abs(wall.radius * direction(wall.angle(slot)) - touched))
    layers = [tuple([0] * len(ring)) for ring in game.arena.layers]
    layers[0], layers[-1] = game.arena.layers[0], game.arena.layers[-1]
    layers[1] = tuple([int(number == slot) for number in range(wall.count)])
    return game._replace(arena=game.arena._replace(layers=tuple(layers)), flight=None)


def test_a_cleared_level_shows_its_results_and_opens_the_next(desk, tmp_path):
    """Its rank and score are kept at once, the next level is open, and Enter there goes on with the same game."""
    desk.press(pygame.K_RETURN)
    play = desk.screen
    desk.press(pygame.K_SPACE)
    play._ticked = play._ticked._replace(game=with_one_brick(play._ticked.game))
    desk.wait(3.0)
    assert isinstance(desk.screen, ResultsPanel)
    storage = Storage(tmp_path)
    (best,) = storage.progress.value.bests
    result = play._ticked.game.results[-1]
    assert (best.level, best.difficulty, best.score, best.rank) == (classic()[0].name, "normal", result.score, result.rank)
    assert storage.progress.value.is_open(1, [level.name for level in classic()])
    desk.press(pygame.K_RETURN, pygame.K_RETURN)
    desk.wait(0.5)
    assert desk.screen is play
    assert play._ticked.game.number == 1


def test_the_best_run_of_a_level_is_raced_as_a_ghost(desk, monkeypatch):
    """Once the player serves, the ghost stands where its recording does, tick by tick from its own first serve."""
    levels, storage = classic()[1:3], desk.shared.storage
    recorded, pilot, game = [], Autopilot(), new_game(classic()[1:3], 5, Ruleset())
    for _ in range(700):
        controls = pilot.controls(game)
        game = tick(game, controls).game
        recorded.append(game)
        storage.games(controls, game)
    storage.level_done(Best(levels[0].name, "normal", 5))
    storage.game_done()
    served = next(number for number, game in enumerate(recorded) if game.phase == Phase.PLAYING)
    monkeypatch.setattr(ghost, "_BUDGET", 60.0)
    desk.screen = PlayScreen(desk.shared, levels)
    desk.wait(0.3)
    assert desk.screen._record.ghost.game is None
    desk.press(pygame.K_SPACE)
    desk.wait(0.4)
    ticks = desk.screen._ticked.game.phase_tick
    assert desk.screen._record.ghost.game.arena == recorded[served + ticks + 1].arena
    plain = pygame.image.tobytes(desk.window.get_surface(), "RGB")
    desk.screen._record.ghost = None
    desk.screen.draw(desk.window.get_surface())
    assert pygame.image.tobytes(desk.window.get_surface(), "RGB") != plain


def test_a_game_on_a_level_of_ones_own_makes_no_high_score(desk):
    """Anybody can make an easy level: it has a best of its own, under what is in it, and opens no level of the game."""
    own = msgspec.structs.replace(classic()[1], ground_radius=classic()[1].ground_radius + 0.5)
    desk.screen = PlayScreen(desk.shared, (own,))
    lose(desk, lambda: desk.press(pygame.K_SPACE))
    assert "Enter your name" not in [entry.label for entry in desk.screen._entries]
    assert record_name(own) != own.name == record_name(classic()[1])


def test_endless_levels_of_a_number_have_a_table_of_their_own(desk, tmp_path):
    """The number is entered with the small keyboard; its levels are those of anybody else; the score's replay proves it."""
    desk.choose("Endless")
    desk.choose("Levels from a number")
    for digit in "42":
        desk.click_on(digit)
    desk.choose("Done")
    assert isinstance(desk.screen, PlayScreen)
    assert desk.screen._ticked.game.levels == sequence(42)
    assert desk.screen._ticked.game.seed == 42
    lose(desk, lambda: desk.press(pygame.K_SPACE))
    desk.press(pygame.K_RETURN)
    desk.choose("Enter your name")
    desk.choose("Done")
    (entry,) = Storage(tmp_path).scores.value.table(ENDLESS)
    assert "(42)" in entry.last
    assert objection(entry, tmp_path / "replays") is None
    assert Storage(tmp_path).progress.value.bests == []
    assert [seed_of(text) for text in ("007", "abc")] == [7, int.from_bytes(b"abc", "little")]


def test_the_title_shows_the_level_that_play_begins(tmp_path):
    """The autopilot plays what the player has reached, by the rules of the campaign."""
    state = sample_state(tmp_path)
    shown = Title(state)._demo._ticked.game
    assert 0 < next_level(state) < len(state.catalogue)
    assert shown.level == state.catalogue[next_level(state)]
    assert shown.ruleset.arcade
