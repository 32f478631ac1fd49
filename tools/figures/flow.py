"""The flow of the program, and who may import whom, as boxes and arrows."""

from tools.figures.sheet import FAINT, INK, SECTOR, Sheet

_GAME, _PHYSICS, _TOOLS = "#dfe4fb", SECTOR, "#f6e3cf"


def flow() -> Sheet:
    """One tick, from the player's hand to the picture."""
    sheet = Sheet(0j, 12.25 + 6.9j, 740)
    top = (
        ("keys, mouse,\nautopilot", "game/input\ngame/autopilot/", _GAME),
        ("rules", "game/rules/", _GAME),
        ("one tick\nof the arena", "physics/step.py", _PHYSICS),
        ("hits", "in the order\nof time", _PHYSICS),
    )
    for k, (words, where, fill) in enumerate(top):
        low = complex(0.3 + 3.05 * k, 5.1)
        sheet.box(low, low + 2.35 + 1.1j, words, fill=fill, size=15)
        sheet.text(low + 1.175 - 0.37j, where, size=11.5, colour=FAINT)
        if k:
            sheet.arrow(low - 0.7 + 0.55j, low + 0.55j)
    sheet.text(2.95 + 6.45j, "controls", size=11.5)
    sheet.text(6.0 + 6.45j, "advance", size=11.5)
    bottom = (
        ("broad phase", "broad_phase.py", "which ring,\nwhich sector?"),
        ("time of impact", "time_of_impact.py", "when is the\nfirst touch?"),
        ("narrow phase", "narrow_phase.py", "a face or an end?\nWhich normal?"),
        ("response", "response.py", "with what velocity\ndoes it leave?"),
    )
    sheet.line(7.575 + 4.45j, 7.575 + 3.86j, colour=INK, width=1.2, dashed=True)
    sheet.box(0.15 + 1.75j, 11.97 + 3.86j, "", fill="#eaf6f4")
    for k, (words, where, question) in enumerate(bottom):
        low = complex(0.3 + 3.05 * k, 2.85)
        sheet.box(low, low + 2.35 + 0.75j, words, fill=_PHYSICS, size=14)
        sheet.text(low + 1.175 - 0.24j, where, size=11.5, colour=FAINT)
        sheet.text(low + 1.175 - 0.68j, question, size=11.5)
        if k:
            sheet.arrow(low - 0.7 + 0.375j, low + 0.375j)
    last = (("rules", "a brick breaks"), ("events", "what happened"), ("picture, sound", "game/drawing, game/sound"))
    for k, (words, where) in enumerate(last):
        low = complex(0.3 + 3.05 * k + 3.05, 0.6)
        sheet.box(low, low + 2.35 + 0.7j, words, fill=_GAME, size=15)
        sheet.text(low + 1.175 - 0.27j, where, size=11.5, colour=FAINT)
        if k:
            sheet.arrow(low - 0.7 + 0.35j, low + 0.35j)
    sheet.line(11.8 + 5.65j, 12.13 + 5.65j, 12.13 + 1.58j, 2.0 + 1.58j, 2.0 + 0.95j, width=2.2)
    sheet.arrow(2.0 + 0.95j, 3.35 + 0.95j)
    return sheet


def imports() -> Sheet:
    """Every arrow is "may import"; there is none upward."""
    sheet = Sheet(0j, 12.2 + 7.0j, 740)
    sheet.box(0.3 + 5.9j, 3.1 + 6.7j, "tests", size=16)
    sheet.box(4.0 + 5.9j, 11.9 + 6.7j, "tools: crosscheck, fuzz, measure, figures", fill=_TOOLS, size=15)
    sheet.box(4.0 + 2.15j, 11.9 + 5.1j, "", fill="#eef1fd")
    sheet.text(4.2 + 4.85j, "game", size=15, align="left")
    sheet.box(7.0 + 3.75j, 11.7 + 4.65j, "app, screens, drawing, effects,\noverlay, sound, lab/window", fill=_GAME, size=12)
    sheet.text(5.5 + 4.2j, "with pygame", size=12, colour=FAINT)
    sheet.box(7.0 + 2.3j, 11.7 + 3.2j, "rules, levels, replays, autopilot,\nheadless, lab scenes", fill=_GAME, size=12)
    sheet.text(5.5 + 2.75j, "without pygame", size=12, colour=FAINT)
    sheet.box(4.0 + 0.4j, 11.9 + 1.35j, "physics: no dependency", fill=_PHYSICS, size=15)
    sheet.arrow(9.35 + 3.75j, 9.35 + 3.2j)
    sheet.arrow(9.35 + 2.3j, 9.35 + 1.35j)
    sheet.arrow(4.5 + 5.9j, 4.5 + 5.1j)
    sheet.line(11.9 + 6.3j, 12.08 + 6.3j, 12.08 + 0.875j, width=2.2)
    sheet.arrow(12.08 + 0.875j, 11.9 + 0.875j)
    sheet.arrow(3.1 + 6.3j, 4.0 + 6.3j)
    sheet.line(1.7 + 5.9j, 1.7 + 0.875j, width=2.2)
    sheet.arrow(1.7 + 3.6j, 4.0 + 3.6j)
    sheet.arrow(1.7 + 0.875j, 4.0 + 0.875j)
    sheet.text(0.85 + 3.2j, "may\nimport", size=12, colour=FAINT)
    return sheet
