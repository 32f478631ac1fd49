"""Two players, together and against each other."""

import pygame

from game.input.actions import OwnKeys
from game.input.keys import Action
from game.levels import classic
from game.rules import paddle_rings
from tests.support.windows.sessions import lose


def test_two_players_steer_the_same_paddles(desk):
    """With two players A and D are the second one's keys, the arrows stay the first one's; both are in the recording."""
    told = []
    desk.shared.recorder = lambda controls, _: told.append((controls.turn, controls.second_turn))
    desk.choose("Levels")
    desk.choose("Players")
    desk.choose(classic()[0].name)
    for key in (pygame.K_d, pygame.K_RIGHT, pygame.K_a):
        desk.hold(key)
        desk.wait(0.1)
    assert list(dict.fromkeys(told))[-3:] == [(0, 1), (1, 1), (1, -1)]
    desk.release(pygame.K_a)
    desk.wait(0.1)
    assert told[-1] == (1, 1)


def test_two_players_against_each_other_have_a_paddle_each(desk):
    """The second keys of Left and Right turn the upper paddle alone; the results name the winner, no score is entered."""
    desk.choose("Levels")
    desk.choose("Players")
    desk.choose("Players")
    desk.choose(classic()[0].name)
    game = desk.screen._ticked.game
    assert game.ruleset.versus
    lower, upper = (game.arena.rings[ring].angle(0) for ring in paddle_rings(game))
    own = ((Action.RIGHT, (pygame.KSCAN_RIGHT, pygame.KSCAN_K)),)
    desk.shared.change(desk.shared.settings._replace(own_keys=OwnKeys(own)))
    desk.hold(pygame.K_k)
    desk.wait(0.2)
    desk.release(pygame.K_k)
    desk.shared.change(desk.shared.settings._replace(own_keys=OwnKeys()))
    game = desk.screen._ticked.game
    assert game.arena.rings[paddle_rings(game)[0]].angle(0) == lower
    assert game.arena.rings[paddle_rings(game)[1]].angle(0) != upper
    lose(desk, lambda: desk.press(pygame.K_SPACE))
    desk.press(pygame.K_RETURN)
    sides = desk.screen._under._ticked.game.sides
    loser, verdicts = int(sides[1].lives == 0), ("Player 2 wins", "Player 1 wins")
    assert desk.screen._title == verdicts[loser]
    assert desk.screen._line.startswith(f"Player {loser + 1} lost the last ball")
    assert [figure.words(figure.amount) for figure in desk.screen._figures[:2]] == [
        f"{side.score:,}  ({side.lives} {'life' if side.lives == 1 else 'lives'})" for side in sides
    ]
    assert "Enter your name" not in [entry.label for entry in desk.screen._entries]
