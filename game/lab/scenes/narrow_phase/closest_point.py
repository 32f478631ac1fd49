"""The closest point on a line, and on a segment."""

from game.lab import source
from game.lab.kit import handles
from game.lab.kit.cited_line import CitedLine, code_line
from game.lab.kit.marks import two_decimals
from game.lab.kit.parameters import Given, Point
from game.lab.kit.picture import Line, Mark, Picture, PointMark, Prediction, Role, Stroke, Toggle, in_steps, one_step
from game.lab.kit.scene import Claim, LabScene, Preset, ViewBox
from physics import closest_point_on_line, dot, length

_SAMPLES = 64


def _picture(given: Given) -> Picture:
    """The segment, the endless line through A and B, and the closest point of each."""
    a, b, p = given.point("A"), given.point("B"), given.point("P")
    q, foot = closest_point_on_line(a, b, p), source.foot_on_line(a, b, p)
    line: list[Mark] = []
    if foot is not None:
        far = (b - a) * (100.0 / length(b - a))
        line.append(Line((a - far, b + far), Role.FAINT, None, Stroke.DASHED))
        if foot != q:
            line.append(Line((p, foot), Role.SOURCE, Toggle.CLOSEST, Stroke.DASHED))
            line.append(PointMark(foot, Role.SOURCE, Toggle.CLOSEST, "on the line"))
    situation: list[Mark] = [
        Line((a, b), Role.SECTOR, None, Stroke.THICK),
        PointMark(a, Role.PLAIN, label="A"),
        PointMark(b, Role.PLAIN, label="B"),
        PointMark(p, Role.BALL, label="p"),
    ]
    nearest: list[Mark] = [Line((p, q), Role.OURS, Toggle.GAP), PointMark(q, Role.OURS, Toggle.CLOSEST, "q")]
    along, square = dot(p - a, b - a), dot(b - a, b - a)
    ratio = f"t = {along:.2f} / {square:.2f}" + (f" = {along / square:.3f}" if square else ", which is undefined")
    steps = (
        one_step("a segment AB and a point p", situation),
        one_step("the foot on the endless line", line, ["q = A + t (B - A),   t = (p - A) · (B - A) / |B - A|²", ratio]),
        one_step(
            "q, the closest point of the segment",
            nearest,
            [f"q = {two_decimals(q)},   |p - q| = {length(p - q):.3f}"],
            Prediction("q", None, q),
        ),
    )
    if foot is None:
        note = "A = B: there is no line, and the source's formula divides by zero. The segment is a point, and q is that point."
    elif foot != q:
        note = f"The foot on the endless line, {two_decimals(foot)}, is not on the segment: q is clamped to the end."
    else:
        note = ""
    return in_steps(steps, _cited(along, square), note)


def _check(given: Given) -> tuple[Claim, ...]:
    """q is closest by definition, and does not depend on the order of A and B."""
    a, b, p = given.point("A"), given.point("B"), given.point("P")
    q = closest_point_on_line(a, b, p)
    nearest = min([length(p - (a + (b - a) * (k / _SAMPLES))) for k in range(_SAMPLES + 1)])
    foot = source.foot_on_line(a, b, p)
    inside = foot is not None and 0.0 <= dot(foot - a, b - a) <= dot(b - a, b - a)
    return (
        Claim("q lies on the segment", abs(length(a - q) + length(q - b) - length(b - a)) < 1e-9),
        Claim("no point of the segment is nearer to p than q", length(p - q) <= nearest + 1e-12),
        Claim("exchanging A and B changes nothing", length(q - closest_point_on_line(b, a, p)) < 1e-9),
        Claim("q is the foot on the line if that lies on the segment", not inside or foot is None or length(q - foot) < 1e-9),
        Claim("if the foot is not on the segment, q is A or B", inside or length(q - a) < 1e-9 or length(q - b) < 1e-9),
    )


def _cited(along: float, square: float) -> CitedLine:
    """The line that says where q is."""
    if along <= 0.0:
        return code_line(closest_point_on_line, "if along <= 0.0:")
    return code_line(closest_point_on_line, "if along >= square:" if along >= square else "return a + ab * (along / square)")


SCENE = LabScene(
    name="closest-point",
    title="The closest point on a line, and on a segment",
    idea="An end of a sector is a segment, not a line: clamping the foot of the perpendicular to it is what makes the corners.",
    functions=("closest_point_on_line",),
    parameters=(
        Point("A", "A", -10.0, 10.0, -3 - 1j, meaning="one end"),
        Point("B", "B", -10.0, 10.0, 2 + 1j, meaning="the other end"),
        Point("P", "p", -10.0, 10.0, 4 + 3.5j, meaning="the ball's centre"),
    ),
    handles=(handles.point("P", "p"), handles.point("A", "A"), handles.point("B", "B")),
    view_box=ViewBox(0.5 + 1j, 5.5 + 4.5j),
    shows=_picture,
    check=_check,
    rows=(3,),
    presets=(
        Preset("beside the segment", "P=-1,2.5"),
        Preset("beyond B: the corner", "P=4,3.5"),
        Preset("on the line, beyond A", "P=-5.5,-2"),
        Preset("a segment without length", "A=1,1&B=1,1&P=3,2"),
    ),
)
