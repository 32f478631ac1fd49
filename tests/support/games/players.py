"""Players for recorded games, who meet the ball more surely and serve later than those of the cross-check."""

from tools.crosscheck.games import players


class MousePlayer(players.MousePlayer):
    """Moves the pointer after the ball, late, shakily and in jumps, and serves when it feels like it."""

    longest_pause = 600

    def most_shake(self, game):  # noqa: ARG002  # the same on every level
        return 0.125


class KeyPlayer(players.KeyPlayer):
    """Presses the arrow keys towards the ball, with a reaction time, and now and then the wrong one."""

    def controls(self, game):
        return super().controls(game)._replace(serve=game.tick % 170 == 0)
