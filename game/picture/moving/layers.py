"""What moves, in the order of drawing: on the ground, beside the balls and in the air; words come last, from `words`."""

from game.picture.display_list import DisplayList
from game.picture.moving.aims import add_aims
from game.picture.moving.drops import add_drops
from game.picture.moving.gauges import add_gauges
from game.picture.moving.lights import add_lights
from game.picture.moving.marks import add_marks
from game.picture.moving.trails import add_trails
from game.picture.moving.waves import add_waves
from game.picture.moving.wells import add_wells
from game.picture.view import ArenaView
from game.scene import Scene


def add_on_ground(out: DisplayList, scene: Scene, view: ArenaView) -> None:
    """Add what lies on the ground, and the light on it."""
    add_wells(out, scene, view)
    add_waves(out, scene, view)
    add_trails(out, scene, view)
    add_aims(out, scene, view)
    add_lights(out, scene, view)


def add_in_air(out: DisplayList, scene: Scene, view: ArenaView) -> None:
    """Add what is around the balls, what floats, and what lasts."""
    add_marks(out, scene, view)
    add_drops(out, scene, view)
    add_gauges(out, scene, view)
