"""The report's pictures: SVG without a size of its own, in colours that the page decides."""

import cmath
import io
import math
import re
from collections.abc import Sequence
from html import escape
from typing import Any

import matplotlib as mpl
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Polygon

from tools.crosscheck.comparisons.convergence import Curve
from tools.crosscheck.pymunk_model.facets import arc_points
from tools.crosscheck.results.measurements import Measurement, Samples

_COLOURS = {"ink": "#010101", "muted": "#020202", "ours": "#030303", "theirs": "#040404", "fill": "#050505", "paper": "#060606"}
"""Stand-ins that no picture uses otherwise; in the page each becomes a CSS variable of that name."""

_STYLE: dict[Any, Any] = {
    "svg.fonttype": "none",
    "font.family": "sans-serif",
    "font.size": 10,
    "text.color": _COLOURS["ink"],
    "axes.edgecolor": _COLOURS["muted"],
    "axes.labelcolor": _COLOURS["ink"],
    "xtick.color": _COLOURS["muted"],
    "ytick.color": _COLOURS["muted"],
    "xtick.labelcolor": _COLOURS["ink"],
    "ytick.labelcolor": _COLOURS["ink"],
    "axes.spines.top": False,
    "axes.spines.right": False,
    "legend.frameon": False,
}
_SMALLEST, _LARGEST = -17.0, 0.5
_BINS = 175


def error_histogram(name: str, exact: Samples | None, faceted: Samples | None) -> str:
    """The errors of one feature's normals, exact shapes and facets, each with its bounds. name: unique on the page."""
    with mpl.rc_context(_STYLE):
        figure = Figure(figsize=(4.4, 2.7), layout="constrained")
        axes = figure.add_subplot()
        for samples, colour, label in ((exact, "ours", "exact shape"), (faceted, "theirs", "chain of chords")):
            if samples is None or not samples.errors:
                continue
            logs = [max(math.log10(error), _SMALLEST) if error > 0.0 else _SMALLEST for error in samples.errors]
            look: dict[str, Any] = {
                "histtype": "stepfilled" if colour == "ours" else "step",
                "color": _COLOURS[colour],
                "linewidth": 1.3,
            }
            axes.hist(logs, bins=_BINS, range=(_SMALLEST, _LARGEST), label=label, **look)
            low, high = math.log10(min(samples.bounds)), math.log10(max(samples.bounds))
            axes.axvspan(low, high, color=_COLOURS[colour], alpha=0.25, linewidth=0)
            axes.axvline(high, color=_COLOURS[colour], linestyle="--", linewidth=1.5, label=f"bound, {10**high:.1e}")
        axes.set_xlim(_SMALLEST, _LARGEST)
        axes.set_yscale("log")
        axes.set_ylim(bottom=0.7)
        axes.set_xticks(range(-16, 1, 4), [f"1e{power}" if power else "1" for power in range(-16, 1, 4)])
        axes.set_xlabel("angle between the two normals, rad")
        axes.set_ylabel("contacts")
        axes.legend(loc="center", bbox_to_anchor=(0.5, 0.6), fontsize=9)
        return _svg(figure, name)


def convergence_plot(curves: Sequence[Curve]) -> str:
    """Error over facets, both logarithmic, with the slope that geometry asks for."""
    with mpl.rc_context(_STYLE):
        figure = Figure(figsize=(5.2, 3.9), layout="constrained")
        axes = figure.add_subplot()
        for curve, marker in zip(curves, "os^v", strict=False):
            colour = _COLOURS["ours" if curve.expected == -1.0 else "theirs"]
            label = f"{curve.name} [{curve.unit}]: slope {curve.slope:.3f}"
            axes.loglog(curve.facets, curve.errors, marker=marker, color=colour, linewidth=1.2, markersize=5, label=label)
            ideal = [curve.errors[0] * (n / curve.facets[0]) ** curve.expected for n in curve.facets]
            axes.loglog(curve.facets, ideal, color=_COLOURS["muted"], linestyle=":", linewidth=1)
        axes.set_xticks(curves[0].facets, [str(n) for n in curves[0].facets])
        axes.minorticks_off()
        axes.set_xlabel("facets per arc")
        axes.set_ylabel("difference between the engines")
        axes.legend(loc="lower left", fontsize=9)
        return _svg(figure, "convergence")


def situation_picture(name: str, measurement: Measurement, facets: int) -> str:
    """The ring with the ball, and the contact enlarged with both engines' normals (or velocities). name: unique on the page."""
    where = measurement.situation
    with mpl.rc_context(_STYLE):
        figure = Figure(figsize=(4.6, 2.3), layout="constrained")
        whole, close = figure.subplots(1, 2)
        for axes in (whole, close):
            _draw_ring(axes, measurement, facets if axes is close else 64)
            axes.set_aspect("equal")
            axes.axis("off")
        outer = where.geometry.radius + where.geometry.half_width
        reach = max(outer, abs(where.position) + where.ball_radius) * 1.08
        whole.set(xlim=(-reach, reach), ylim=(-reach, reach))
        whole.add_patch(Circle((where.position.real, where.position.imag), where.ball_radius, color=_COLOURS["ours"]))
        view = 2.6 * where.ball_radius
        x, y = where.position.real, where.position.imag
        close.set(xlim=(x - view, x + view), ylim=(y - view, y + view))
        close.add_patch(Circle((x, y), where.ball_radius, fill=False, edgecolor=_COLOURS["ink"], linewidth=1.2))
        whole.add_patch(Polygon(_box(x, y, view), closed=True, fill=False, edgecolor=_COLOURS["muted"], linewidth=0.8))
        _draw_arrows(close, measurement)
        return _svg(figure, name)


def _draw_arrows(axes: Axes, measurement: Measurement) -> None:
    """Both engines' answers, from the ball's centre."""
    compared, where = measurement
    longest = max(abs(compared.ours), abs(compared.pymunks))
    if not longest:
        return
    scale = 1.9 * where.ball_radius / longest
    for vector, colour, width in ((compared.ours, "ours", 5.0), (compared.pymunks, "theirs", 1.8)):
        tip = where.position + vector * scale
        arrow = {
            "arrowstyle": "-|>",
            "color": _COLOURS[colour],
            "linewidth": width,
            "shrinkA": 0,
            "shrinkB": 0,
            "mutation_scale": 13,
        }
        start = (where.position.real, where.position.imag)
        axes.annotate("", xy=(tip.real, tip.imag), xytext=start, arrowprops=arrow)


def _draw_ring(axes: Axes, measurement: Measurement, facets: int) -> None:
    """Every sector of the ring, as the facets that pymunk has of it; dotted, where the slot is empty."""
    where = measurement.situation
    geometry = where.geometry
    for slot in range(geometry.count):
        middle = where.angle + slot * math.tau / geometry.count
        inner = arc_points(geometry.radius - geometry.half_width, middle, geometry.half_angle, facets)
        outer = arc_points(geometry.radius + geometry.half_width, middle, geometry.half_angle, facets)
        hit = slot == where.slot
        look: dict[str, Any] = {"edgecolor": _COLOURS["ink" if hit else "muted"], "linewidth": 1.2 if hit else 0.6}
        look |= {"facecolor": _COLOURS["fill"]} if where.alive[slot] else {"facecolor": "none", "linestyle": ":"}
        axes.add_patch(Polygon([*inner, *reversed(outer)], closed=True, **look))
    axes.plot(0.0, 0.0, marker="+", color=_COLOURS["muted"])


def _box(x: float, y: float, half: float) -> list[tuple[float, float]]:
    corners = [cmath.rect(half * math.sqrt(2.0), math.pi / 4.0 + k * math.pi / 2.0) for k in range(4)]
    return [(x + corner.real, y + corner.imag) for corner in corners]


def _svg(figure: Figure, name: str) -> str:
    """The picture as an element for the page: sized by the page, its ids its own, its colours the page's."""
    text = io.StringIO()
    with mpl.rc_context({"svg.hashsalt": name}):
        figure.savefig(
            text, format="svg", transparent=True, metadata={"Date": None, "Creator": None, "Format": None, "Type": None}
        )
    svg = text.getvalue()
    svg = svg[svg.index("<svg") :]
    prefix = name.replace(" ", "-") + "-"
    svg = re.sub(r'\bid="', f'id="{prefix}', svg)
    svg = re.sub(r'(url\(#|href="#)', rf"\g<1>{prefix}", svg)
    svg = re.sub(
        r'<svg [^>]*viewBox="([^"]*)"[^>]*>', rf'<svg viewBox="\1" role="img" aria-label="{escape(name)}">', svg, count=1
    )
    svg = svg.replace("xlink:href", "href")
    for variable, colour in _COLOURS.items():
        svg = svg.replace(colour, f"var(--{variable})")
    return svg
