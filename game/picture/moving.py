"""What moves over the arena: waves, trails, aims, lights, drops, balls, words; the same for both views."""

import cmath
import math
from itertools import pairwise

from game.drawing.arcade.signs import chip, power_colour
from game.drawing.camera import Camera
from game.drawing.light_colour import light_colour
from game.drawing.palette import Colour, Theme, layer_colour, mixed
from game.effects import Burst
from game.effects.bursts import Matter, lifetime
from game.effects.waves import WaveTone
from game.picture.display_list import DisplayList
from game.rules import TICK
from game.rules.drops import DROP_RADIUS
from game.scene import Aim, Scene, Well
from physics import Ball

_AROUND = tuple([cmath.rect(1.0, math.tau * k / 64) for k in range(65)])
_WAVE, _FAINTEST = 0.014, 0.06
"""Width of a new wave in ground radii, and the strength below which none is drawn."""
_TRAIL, _TRAIL_STRENGTH = 0.85, 0.5
"""Half a trail's width at the ball in the ball's radii, and how strong its colour is there."""
_AIM_REACH, _AIM_DOTS, _AIM_HEAD = 2.4, 6, 0.2
"""World units to the tip of an aim's arrow, dots of its line, and half the width of its head."""
_LIGHT, _BALL_LIGHT = 0.45, 0.28
"""Strength of the lights of what was struck, and of balls."""
_PIECES, _PIECE = 9, 0.016
"""Shards of a burst, and the size of one in ground radii."""
_GOLDEN = math.pi * (3.0 - math.sqrt(5.0))
_RISE = 0.9
"""World units that words rise in their life."""
_LEAST_CHIP = 0.55
"""Radius of a drop's chip, at least, in units of text."""
_GAUGE_RADIUS, _GAUGE_WIDTH, _GAUGE_CHIP = 1.042, 0.011, 0.03
_GAUGE_FIRST, _GAUGE_PITCH, _GAUGE_SPAN, _GAUGE_ROOM = (math.radians(angle) for angle in (150.0, 34.0, 23.0, 4.5))
"""Arcs of what lasts: their radius, width and icon in ground radii, and their angles on the screen."""


def add_on_ground(out: DisplayList, scene: Scene, camera: Camera, theme: Theme) -> None:
    """Add what lies on the ground."""
    for well in scene.wells:
        _add_well(out, well, scene.clock, camera, theme)
    _add_waves(out, scene, camera, theme)
    _add_trails(out, scene, camera, theme)
    for aim in (*scene.held_aims, *([] if scene.aim is None else [scene.aim])):
        _add_aim(out, aim, camera, theme.accent)
    if theme.glow > 0.0:
        _add_lights(out, scene, camera, theme)


def add_in_air(out: DisplayList, scene: Scene, camera: Camera, theme: Theme, unit: float) -> None:
    """Add what flies, and the words, but for the balls."""
    for burst in scene.bursts:
        _add_burst(out, burst, scene.ground_radius, camera, theme)
    for drop in scene.drops:
        radius = max(DROP_RADIUS * scene.ground_radius * camera.scale_at(drop.position), _LEAST_CHIP * unit)
        height = 0.0 if camera.flat else DROP_RADIUS * scene.ground_radius
        add_chip(out, drop.kind, camera.project(drop.position, height), radius, theme)
    _add_gauges(out, scene, camera, theme, unit)


def add_ball(out: DisplayList, ball: Ball, camera: Camera, theme: Theme) -> None:
    """Add a ball: a shaded disc with a shadow."""
    pixel = camera.project(ball.position, 0.0 if camera.flat else ball.radius)
    radius = max(ball.radius * camera.scale_at(ball.position, ball.radius), 1.5)
    foot = camera.project(ball.position)
    out.disc(foot + complex(0.18, 0.22) * radius, radius * 1.02, (0, 0, 0), 0.35)
    out.disc(pixel, radius, mixed(theme.ball, (20, 30, 70), 0.35))
    out.disc(pixel - complex(0.14, 0.16) * radius, radius * 0.8, mixed(theme.ball, (20, 30, 70), 0.1))
    out.disc(pixel - complex(0.26, 0.3) * radius, radius * 0.42, theme.ball)


def add_words(out: DisplayList, scene: Scene, camera: Camera, theme: Theme, unit: float) -> None:
    """Add the words that rise where something happened."""
    for pop in scene.pops:
        pixel = camera.project(pop.position) - 1j * _RISE * pop.age * camera.scale
        colour = theme.danger if pop.bad else mixed(theme.text, theme.accent, pop.weight)
        fading = min(1.0, 2.0 * (1.0 - pop.age))
        spring = 1.0 + 0.9 * math.exp(-24.0 * pop.age) * math.sin(min(24.0 * pop.age, math.pi))
        size = unit * (1.3 if pop.bad else 0.9 + 0.8 * pop.weight) * spring
        out.text(pop.text, size, pixel + 1.5j, theme.ground, opacity=fading, bold=1.0)
        out.text(pop.text, size, pixel, colour, opacity=fading, bold=1.0)


def add_chip(out: DisplayList, kind: int, pixel: complex, radius: float, theme: Theme) -> None:
    """Add a power-up's chip with its sign."""
    for outline, colour in chip(kind, theme):  # type: ignore[arg-type]  # a power-up is an integer
        out.polygon([pixel + point.conjugate() * radius for point in outline], colour)


def _add_waves(out: DisplayList, scene: Scene, camera: Camera, theme: Theme) -> None:
    """Add circles that run over the ground, fainter and fainter."""
    colours = {WaveTone.START: theme.rim, WaveTone.GOOD: theme.accent, WaveTone.BAD: theme.danger}
    for wave in scene.waves:
        strength = 1.0 - wave.share
        if wave.age >= 0 and strength >= _FAINTEST:
            width = max(_WAVE * scene.ground_radius * camera.scale * (1.0 - 0.6 * wave.share), 1.0)
            circle = [camera.project(point * max(wave.radius, 0.0)) for point in _AROUND]
            out.line(circle, width, colours[wave.tone], strength)


def _add_trails(out: DisplayList, scene: Scene, camera: Camera, theme: Theme) -> None:
    """Add tails that grow and brighten towards their balls, warmer with every brick in a row."""
    if not scene.balls:
        return
    hottest = mixed(theme.trail, theme.accent, scene.heat)
    width = 2.0 * _TRAIL * scene.balls[0].radius * camera.scale
    for trail in scene.trails:
        pixels = [camera.project(point) for point in trail]
        for index, piece in enumerate(pairwise(pixels), 2):
            share = index / (len(pixels) + 1)
            out.line(piece, max(width * share, 1.0), mixed(theme.ground, hottest, _TRAIL_STRENGTH * share))


def _add_aim(out: DisplayList, aim: Aim, camera: Camera, colour: Colour) -> None:
    """Add a line of dots that ends in an arrow's head."""
    for k in range(_AIM_DOTS):
        point = aim.origin + aim.direction * (0.5 + (_AIM_REACH - 1.05) * k / (_AIM_DOTS - 1))
        out.disc(camera.project(point), max(0.055 * camera.scale_at(point), 1.5), colour)
    tip, width = _AIM_REACH, _AIM_HEAD
    head = (complex(tip), complex(tip - 1.7 * width, width), complex(tip - 1.25 * width), complex(tip - 1.7 * width, -width))
    out.polygon([camera.project(aim.origin + corner * aim.direction) for corner in head], colour)


def _add_lights(out: DisplayList, scene: Scene, camera: Camera, theme: Theme) -> None:
    """Add the light of what was struck and of the balls."""
    flatness = math.cos(camera.tilt)
    for light in scene.lights:
        reach = light.reach * scene.ground_radius * camera.scale_at(light.position)
        out.glow(camera.project(light.position), (reach, reach * flatness), light_colour(light, theme), _LIGHT * light.now)
    if scene.shining:
        warm = mixed(theme.trail, theme.accent, scene.heat)
        for ball in scene.balls:
            reach = 4.2 * ball.radius * camera.scale_at(ball.position)
            out.glow(camera.project(ball.position), (reach, reach * flatness), warm, _BALL_LIGHT * (0.5 + 0.5 * scene.heat))


def _add_burst(out: DisplayList, burst: Burst, ground_radius: float, camera: Camera, theme: Theme) -> None:
    """Add pieces that fly off: squares that turn, slow down, come down, and shrink.

    The desktop's debris is computed in arrays; these pieces follow the same burst, in the same colours, with less arithmetic.
    """
    share = burst.age / lifetime(burst.matter)
    if share >= 1.0:
        return
    colour = _burst_colour(burst, theme)
    begin = cmath.rect(burst.origin.radius, burst.origin.angle)
    time, spread = burst.age * TICK, 0.16 * ground_radius
    for k in range(_PIECES):
        chance = (burst.seed * 0.618034 + k * 0.754878) % 1.0
        away = cmath.rect(1.0, _GOLDEN * k + burst.seed % 7) * (0.3 + chance) + burst.direction * 0.8
        point = begin + away * spread * (1.0 - math.exp(-3.0 * time))
        height = 0.0 if camera.flat else max(0.06 + (0.5 + chance) * time - 1.6 * time * time, 0.0) * ground_radius * 0.6
        half = _PIECE * ground_radius * (0.5 + 0.5 * chance) * min(1.0, 2.0 * (1.0 - share)) * camera.scale
        turn = cmath.rect(half, 9.0 * time * (chance - 0.4) + k)
        pixel = camera.project(point, height)
        out.polygon((pixel + turn, pixel + 1j * turn, pixel - turn, pixel - 1j * turn), colour, 0.95)


def _burst_colour(burst: Burst, theme: Theme) -> Colour:
    """The colour of what a burst is made of."""
    if burst.matter is Matter.BRICK:
        return layer_colour(theme, burst.layer)
    return {Matter.BALL: theme.danger, Matter.STEEL: theme.accent, Matter.PADDLE: theme.paddle_top}[burst.matter]


def _add_well(out: DisplayList, well: Well, clock: float, camera: Camera, theme: Theme) -> None:
    """Add a gravity well: rings that shrink into what pulls, and grow out of what pushes."""
    colour = theme.trail if well.strength > 0.0 else theme.danger
    moved = clock * 0.28 % 1.0
    for number in range(4):
        share = (number + (1.0 - moved if well.strength > 0.0 else moved)) / 4.0
        shade = mixed(theme.ground, colour, 0.75 - 0.45 * share)
        for arm in range(3):
            start = math.tau * arm / 3.0 + 2.0 * (1.0 - share)
            angles = [start + math.tau / 3.0 * 0.65 * k / 8.0 for k in range(9)]
            line = [camera.project(well.position + cmath.rect(share * well.reach, angle)) for angle in angles]
            out.line(line, max(0.022 * well.reach * camera.scale, 1.0), shade)
    out.disc(camera.project(well.position), max(0.07 * well.reach * camera.scale_at(well.position), 2.0), colour)


def _add_gauges(out: DisplayList, scene: Scene, camera: Camera, theme: Theme, unit: float) -> None:
    """Add an icon and an arc for every power-up that lasts; and how much is left of what a growing wall guards."""
    ground = scene.ground_radius
    radius = max(_GAUGE_CHIP * ground * camera.scale, 0.5 * unit)
    empty = mixed(theme.rim, theme.background, 0.55)
    for index, power in enumerate(scene.powers):
        angle = _GAUGE_FIRST + index * _GAUGE_PITCH
        begin, left = angle + _GAUGE_ROOM, power.share_left
        colour = theme.danger if left < 0.25 else power_colour(power.kind, theme)
        _add_arc(out, scene, camera, (begin, begin + _GAUGE_SPAN), empty)
        _add_arc(out, scene, camera, (begin, begin + _GAUGE_SPAN * left), colour)
        point = cmath.rect(ground * _GAUGE_RADIUS, angle) / camera.turning
        add_chip(out, power.kind, camera.project(point), radius, theme)
    if scene.core is not None:
        begin, span = math.radians(60.0), math.radians(50.0)
        _add_arc(out, scene, camera, (begin - span, begin), empty)
        _add_arc(out, scene, camera, (begin - span * scene.core, begin), theme.danger)


def _add_arc(out: DisplayList, scene: Scene, camera: Camera, ends: tuple[float, float], colour: Colour) -> None:
    """Add an arc beyond the rim. ends: angles on the screen."""
    radius = scene.ground_radius * _GAUGE_RADIUS
    angles = [ends[0] + (ends[1] - ends[0]) * k / 16.0 for k in range(17)]
    line = [camera.project(cmath.rect(radius, angle) / camera.turning) for angle in angles]
    out.line(line, max(_GAUGE_WIDTH * scene.ground_radius * camera.scale, 2.0), colour)
