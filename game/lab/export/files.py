"""The bytes of a scene's picture as PNG, SVG or GIF."""

import io
from collections.abc import Callable
from typing import Literal

import pygame

from game.lab.drawing.formula_type import FormulaType
from game.lab.export.gif import Frame, can_animate, gif_of
from game.lab.export.slide import Slide, SlideStyle, painted, slide_of
from game.lab.export.svg import svg_of
from game.lab.session.pan_zoom import PanZoom
from game.lab.session.reveal import Reveal, shown_picture, step_name
from game.lab.session.session import Session, at_tick
from game.system.errors import EnvironmentMissingError

FileKind = Literal["png", "svg", "gif"]
_STEP_MILLISECONDS, _LAST_MILLISECONDS = 1500, 4000
"""For which a step of a reveal stands, and the whole picture at its end."""
_FRAMES, _FRAME_MILLISECONDS = 48, 80
"""Of a scene that runs: so many pictures of its whole run, at equal distances, and for how long each stands."""
_RUN_SHARE = 2
"""By which the width and the height of a run's pictures are divided, which are many."""


def file_of(kind: FileKind, style: SlideStyle, session: Session, reveal: Reveal, pan_zoom: PanZoom) -> bytes:
    """What is shown of a scene, as a file: for GIF all its steps, or its whole run if it has no steps.

    EnvironmentMissingError for a GIF without Pillow.
    """
    if kind == "gif":
        if not can_animate():
            raise EnvironmentMissingError("a GIF needs Pillow: pip install pillow")
        return gif_of(_frames(style, session, pan_zoom))
    picture = shown_picture(reveal, session.picture)
    slide = slide_of(style, session.scene, picture, pan_zoom, step_name(reveal, session.picture))
    if kind == "png":
        return png_of(painted(slide, style.letters))
    return svg_of(slide, _sets(style)).encode()


def png_of(surface: pygame.Surface) -> bytes:
    """A surface as a PNG file."""
    file = io.BytesIO()
    pygame.image.save(surface, file, "picture.png")
    return file.getvalue()


def _frames(style: SlideStyle, session: Session, pan_zoom: PanZoom) -> list[Frame]:
    """The steps of a picture, or the run of a scene without steps; a single picture where there is neither."""
    picture, scene = session.picture, session.scene

    def frame(slide: Slide, milliseconds: int) -> Frame:
        """A picture of the animation."""
        return Frame(painted(slide, style.letters), milliseconds)

    if session.runs and not picture.steps:
        ticks = [round(session.last * k / (_FRAMES - 1)) for k in range(_FRAMES)]
        pictures = [at_tick(session, tick).picture for tick in ticks]
        small = style._replace(size=(style.size[0] // _RUN_SHARE, style.size[1] // _RUN_SHARE))
        return [frame(slide_of(small, scene, one, pan_zoom), _FRAME_MILLISECONDS) for one in pictures]
    reveals = [Reveal(count) for count in range(1, len(picture.steps))]
    steps = [slide_of(style, scene, shown_picture(one, picture), pan_zoom, step_name(one, picture)) for one in reveals]
    last = frame(slide_of(style, scene, picture, pan_zoom), _LAST_MILLISECONDS)
    return [*[frame(slide, _STEP_MILLISECONDS) for slide in steps], last]


def _sets(style: SlideStyle) -> Callable[[str], bool]:
    """Whether the labels' letters set a text as a formula."""
    labels = style.letters.labels
    return labels.sets if isinstance(labels, FormulaType) else _never


def _never(_: str) -> bool:
    """For letters that set nothing."""
    return False
