"""The compiled autopilot steers as the game's own: controls and every bit of the state are compared after every tick."""

import numpy as np
import pytest

from game.autopilot.source_pilot import SourcePilot
from game.levels import chosen
from game.rules import TICK, Phase, new_game, tick
from physics import PERMANENT
from physics.batch import Batch
from tools.autopilot import BatchAutopilot

pytestmark = pytest.mark.deep


class Compared:
    """Counts of what the comparison went through."""

    def __init__(self):
        self.served = self.lost = self.nudged = self.cut = self.stacks = self.permanent = self.ticks = 0


def play(level, seeds, ticks, seen):
    """Games of a level with the game's autopilot, and a batch that takes each of them over at its serves and nudges."""
    games = [new_game((level,), seed) for seed in seeds]
    batch = Batch([game.arena for game in games], dt=TICK, speed=level.ball.speed, ground_radius=level.ground_radius)
    pilots, compiled = [SourcePilot() for _ in seeds], BatchAutopilot(level, len(seeds))
    for _ in range(ticks):
        steps = batch.step(autopilot=compiled)
        for g, before in enumerate(games):
            controls = pilots[g].controls(before)
            after = tick(before, controls)
            games[g] = after.game
            if before.phase != Phase.PLAYING:
                if after.game.arena.balls:
                    batch.put(g, after.game.arena)
                    compiled.forget(g)
                seen.served += after.game.phase == Phase.PLAYING
                continue
            pointer = int(compiled.pointers[g])
            assert controls.pointer == (pointer if pointer >= 0 else None)
            mine = batch.arena(g)
            assert mine.rings == after.step.arena.rings
            assert mine == after.step.arena
            assert steps.lost[g, 0] == (after.game.phase == Phase.SERVING or after.game.lives == 0)
            seen.ticks += 1
            seen.lost += int(steps.lost[g, 0])
            seen.cut += controls.pointer is not None and abs(before.arena.rings[0].spin) > 0.0
            seen.stacks += sum(hit.layers > 0 for hit in after.step.hits)
            seen.permanent += sum(hit.layers == PERMANENT and hit.ring > 0 for hit in after.step.hits)
            if after.game.arena.balls != after.step.arena.balls and after.game.arena.balls:
                batch.put(g, after.game.arena)
                seen.nudged += 1


@pytest.mark.parametrize("level", ["1", "2", "Sunflower"])
def test_a_batch_is_steered_as_a_game(level):
    """x"""
    seen = Compared()
    play(chosen(level)[0], [1, 2, 3], 3000, seen)
    print(vars(seen))
    assert min(seen.ticks, seen.served) > 0
