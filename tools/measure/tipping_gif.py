"""The pictures of the camera tipping over, for the README: `python -m tools.measure.tipping_gif FOLDER`.

Any program makes an animation of them, as `magick -delay 8 FOLDER/*.png +dither -colors 80 -layers optimize docs/tip.gif`.
"""

from game.system.start import prepare

PROGRAM = "python -m tools.measure.tipping_gif"

if __name__ == "__main__":
    prepare(PROGRAM)  # before what takes time to load

import io
import math
import sys
from pathlib import Path
from typing import Annotated

import pygame
import typer

from game.autopilot import Autopilot
from game.drawing.camera import layout
from game.drawing.canvas import Canvas
from game.drawing.painter import Painter
from game.drawing.palette import DARK
from game.drawing.text import Type
from game.effects import Effects, after
from game.input.view import Viewpoint
from game.levels import built_in
from game.rules import new_game, tick
from game.scene import scene_at, still
from game.system.command_line import run
from game.system.errors import BadInputError
from game.system.files import write_atomically
from game.system.wording import quoted_path

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)

_LEVEL, _SEED, _SERVED = 9, 3, 1300
_TICKS_A_FRAME = 20
_PAUSE, _TIP, _ORBIT = 6, 11, 13
"""Frames from above, on the way, and tipped."""


def main() -> None:
    """Run the command line and exit."""
    sys.exit(run(app, PROGRAM))


@app.command()
def tipping(
    folder: Annotated[Path, typer.Argument(help="Where to write 000.png and so on.")],
    width: Annotated[int, typer.Option(min=16, max=4096, help="Pixels.")] = 480,
    height: Annotated[int, typer.Option(min=16, max=4096, help="Pixels.")] = 320,
) -> None:
    """Write a picture for every frame: from above, tipping over, orbiting a little, and back."""
    if not folder.is_dir():
        raise BadInputError(f"{quoted_path(folder)}: there is no such folder")
    done, pilot, effects = still(new_game(built_in()[_LEVEL:], _SEED)), Autopilot(), Effects()
    painter, type_ = Painter(), Type()
    surface = pygame.Surface((width, height), 0, 32)
    for number in range(-_SERVED // _TICKS_A_FRAME, len(_views())):
        for _ in range(_TICKS_A_FRAME):
            done = tick(done.game, pilot.controls(done.game))
            effects = after(effects, done)
        if number >= 0:
            seen = _views()[number].seen(layout((width, height), done.game.level.ground_radius))
            painter.paint(Canvas(surface, seen.camera, DARK, type_, seen.unit), scene_at(done, 1.0, effects)._replace(pops=()))
            picture = io.BytesIO()
            pygame.image.save(surface, picture, "picture.png")
            write_atomically(folder / f"{number:03}.png", picture.getvalue())


def _views() -> list[Viewpoint]:
    """Where every frame is seen from."""
    above = [Viewpoint()] * _PAUSE
    over = [Viewpoint(1.0, (step + 1.0) / _TIP) for step in range(_TIP)]
    around = [Viewpoint(1.0, 1.0, 0.35 * math.sin(math.tau * (step + 1.0) / _ORBIT)) for step in range(_ORBIT)]
    return [*above, *over, *around, *reversed(over)]


if __name__ == "__main__":
    main()
