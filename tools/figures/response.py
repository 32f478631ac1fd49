"""The collision response in three steps: the relative velocity, its two parts, the bounce."""

from physics import collision_response, dot
from tools.figures.sheet import CHANGE, FAINT, INK, NORMAL, SECTOR, VELOCITY, Sheet

_NORMAL, _TANGENT = 1j, 1 + 0j
_BEFORE, _SURFACE, _FRICTION = 2.4 - 2.2j, -0.8 - 0.5j, 0.6
_STEP = 7.4
"""How far the panels are apart."""


def response_symbols() -> Sheet:
    """Every velocity of the source's pages "Collision response", to one scale."""
    sheet = Sheet(-3.9 - 2.75j, 18.7 + 3.1j, 1000)
    relative = _BEFORE - _SURFACE
    normal = _NORMAL * dot(relative, _NORMAL)
    along = relative - normal
    bounce = -2.0 * normal
    grip = -along * (_FRICTION * min(abs(normal), abs(along)) / abs(along))
    result = _BEFORE + bounce + grip
    after = collision_response(_BEFORE, _NORMAL, _SURFACE, _FRICTION, abs(_BEFORE))
    for k, title in enumerate(("1  the relative velocity", "2  its two parts", "3  the bounce")):
        at = complex(k * _STEP)
        sheet.line(at - 3.4, at + 3.4, colour=INK, width=1.4)
        sheet.box(at - 3.4 - 0.55j, at + 3.4 - 0.02j, "", fill=SECTOR)
        sheet.text(at + 2.7j, title, size=17)
        foot = at if k == 0 else at - 2.6
        sheet.arrow(foot, foot + _NORMAL, colour=NORMAL, width=3.0)
        sheet.text(foot - 0.3 + 0.75j, r"$\mathbf{n}$", colour=NORMAL)

    sheet.arrow(0j, _BEFORE, colour=VELOCITY)
    sheet.text(_BEFORE * 0.6 + 0.35 + 0.2j, r"$\mathbf{v}$", colour=VELOCITY)
    sheet.arrow(0j, _SURFACE, colour=INK)
    sheet.text(_SURFACE - 0.45 + 0.2j, r"$\mathbf{v}_p$")
    sheet.arrow(_SURFACE, _BEFORE, colour=CHANGE)
    sheet.text((_SURFACE + _BEFORE) / 2 - 0.8 - 0.55j, r"$\Delta\mathbf{v} = \mathbf{v} - \mathbf{v}_p$", colour=CHANGE)

    at = complex(_STEP) - 1.6
    sheet.arrow(at, at + relative, colour=CHANGE)
    sheet.text(at + relative * 0.62 + 0.55 + 0.3j, r"$\Delta\mathbf{v}$", colour=CHANGE)
    sheet.arrow(at, at + along, colour=INK)
    sheet.text(at + along * 0.6 + 0.38j, r"$\Delta\mathbf{v}_t$")
    sheet.arrow(at, at + normal, colour=INK)
    sheet.text(at + normal * 0.6 - 0.55, r"$\Delta\mathbf{v}_n$")
    sheet.line(at + along, at + relative, at + normal, colour=FAINT, dashed=True)
    return _with_bounce(sheet, bounce, grip, result, after)


def _with_bounce(sheet: Sheet, bounce: complex, grip: complex, result: complex, after: complex) -> Sheet:
    """The third panel: the two changes added to v, and the result brought to the ball's speed."""
    at = complex(2.0 * _STEP) - 1.6
    sheet.arrow(at, at + _BEFORE, colour=VELOCITY, width=1.6)
    sheet.text(at + _BEFORE * 0.5 - 0.4 - 0.2j, r"$\mathbf{v}$", colour=VELOCITY)
    sheet.arrow(at + _BEFORE, at + _BEFORE + bounce, colour=CHANGE)
    sheet.text(at + _BEFORE + bounce * 0.3 + 0.6, r"$\Delta\mathbf{v}_n'$", colour=CHANGE)
    sheet.arrow(at + _BEFORE + bounce, at + result, colour=CHANGE)
    sheet.text(at + _BEFORE + bounce + grip / 2 - 0.45j, r"$\Delta\mathbf{v}_t'$", colour=CHANGE)
    sheet.arrow(at, at + after, colour=VELOCITY, width=2.2)
    sheet.text(
        at + after + 0.25 - 0.1j,
        r"$\mathbf{v}$ := $v_0\,\mathbf{v}_{res}\,/\,|\mathbf{v}_{res}|$",
        colour=VELOCITY,
        align="left",
    )
    sheet.arrow(at, at + result, colour=INK, width=3.0)
    sheet.text(at + result * 0.6 - 0.65 + 0.25j, r"$\mathbf{v}_{res}$")
    return sheet
