"""The fuzzer passes the physics, and fails every physics that was broken on purpose."""

import math
import os
import re
import signal
import subprocess
import sys

import mpmath
import pytest

from game.system.command_line import run
from physics import Arena, Ball, Impact, Ring, advance, time_of_impact
from tests.support.children import Terminal
from tests.support.paths import ROOT
from tools.fuzz import campaign, impacts
from tools.fuzz.arenas import TICK, random_case, with_lost_balls_back
from tools.fuzz.checks import first_fault
from tools.fuzz.commands import app
from tools.fuzz.impacts import check_impacts, random_impact
from tools.fuzz.oracle import first_overlap, ring_gap, slot_gap

NAME = "python -m tools.fuzz"


def fuzz(*arguments):
    """The exit code of the command line."""
    return run(app, NAME, [str(argument) for argument in arguments])


def sabotaged(monkeypatch, change):
    """The campaign plays an `advance` whose result goes through `change`."""
    monkeypatch.setattr(campaign, "advance", lambda arena, dt, speed, *last: change(arena, advance(arena, dt, speed, *last)))


def test_a_campaign_goes_on_where_another_stopped(monkeypatch):
    """The tallies from a later case on are those of one campaign, and of a cluster's larger jobs."""
    monkeypatch.setattr(campaign, "CASES_PER_TALLY", 2)
    monkeypatch.setattr(campaign, "play", lambda _, index: campaign.CampaignTally(1, 10, index))
    whole = list(campaign.tallies(5, 200, 1))
    assert [tally.hits for tally in whole] == [1, 5, 9, 13, 17, 21, 25, 29, 33, 37]
    assert list(campaign.tallies(5, 140, 1, first=6)) == whole[3:]
    monkeypatch.setattr(campaign, "results", lambda function, jobs, _: map(function, jobs))
    monkeypatch.setattr(campaign, "sure", lambda answers: (answer for answer in answers))
    assert list(campaign.tallies(5, 200, "tcp://far:1")) == whole


def test_a_campaign_finds_nothing(capsys):
    """`python -m tools.fuzz --steps 10000000` is the same at length."""
    assert fuzz("--steps", 4000, "--seed", 11) == 0
    line = capsys.readouterr().out
    assert re.match(r"seed 11: \d+ cases, \d+ ball-steps, \d+ hits, \d+ dropped .* 0 failed; done\n$", line)


def test_the_seed_decides_everything(capsys):
    """Two workers find what is found one case after the other, for cases are numbered; another seed finds other numbers."""
    tallies = [campaign.play(5, index) for index in range(10)]
    counted = f"10 cases, {sum(tally.steps for tally in tallies)} ball-steps, {sum(tally.hits for tally in tallies)} hits"
    assert fuzz("--steps", 1, "--seed", 5, "--workers", 2) == 0
    assert counted in capsys.readouterr().out
    assert fuzz("--steps", 1, "--seed", 6) == 0
    assert counted not in capsys.readouterr().out


@pytest.mark.parametrize(
    "arguments",
    [
        ("--steps", "0"),
        ("--steps", "many"),
        ("--steps", "-5"),
        ("--seed", "-1"),
        ("--workers", "0"),
        ("--impacts", "0"),
        ("--unknown",),
        ("--steps",),
        ("surplus",),
        ("--case", "1"),
        ("--case", "1:x"),
        ("--case", ":"),
        ("--case", "-1:2"),
        ("--case", "1:2:3"),
        ("--case", "\u0663:1"),
    ],
)
def test_bad_flags_are_one_line_and_exit_code_2(arguments, capsys):
    """No traceback, no usage page."""
    assert fuzz(*arguments) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.startswith(f"{NAME}: ")
    assert said.err.count("\n") == 1


def test_without_mpmath_the_impacts_cannot_be_checked(monkeypatch, capsys):
    """Exit code 3, and what to install."""
    monkeypatch.setitem(sys.modules, "mpmath", None)
    assert fuzz("--impacts", 10) == 3
    assert capsys.readouterr().err == f"{NAME}: --impacts needs mpmath: pip install mpmath\n"


def test_impacts_are_checked_from_the_command_line(capsys):
    """A small number of what `--impacts 100000` does."""
    assert fuzz("--impacts", 300, "--seed", 5) == 0
    assert re.match(r"seed 5: 300 times of impact, \d+ of them touches, 0 wrong; done\n", capsys.readouterr().out)


def push_deeper(_before, step):
    """Every ball that hit something ends a little deeper."""
    if not step.hits:
        return step
    balls = list(step.arena.balls)
    hit = step.hits[-1]
    balls[hit.ball] = Ball(hit.contact.point, balls[hit.ball].velocity, balls[hit.ball].radius)
    return step._replace(arena=step.arena._replace(balls=tuple(balls)))


def ignore_contacts(before, step):
    """Balls fly on as if nothing were there."""
    balls = tuple(ball.moved(TICK) for ball in before.balls)
    return step._replace(arena=step.arena._replace(balls=balls, layers=before.layers), hits=())


def forget_a_layer(before, step):
    """Hits break nothing."""
    return step._replace(arena=step.arena._replace(layers=before.layers))


def invent_a_break(_before, step):
    """A brick disappears that nothing hit."""
    layers = [list(row) for row in step.arena.layers]
    for row in layers:
        if any(row):
            row[row.index(max(row, key=abs))] = 0
            break
    return step._replace(arena=step.arena._replace(layers=tuple(tuple(row) for row in layers)))


def speed_up(_before, step):
    """A billionth faster at every tick."""
    balls = tuple(ball._replace(velocity=ball.velocity * (1.0 + 1e-9)) for ball in step.arena.balls)
    return step._replace(arena=step.arena._replace(balls=balls))


def lose_a_number(_before, step):
    """A nan among the coordinates."""
    first = tuple.__new__(Ball, (complex(math.nan, 0.0), *step.arena.balls[0][1:]))
    return step._replace(arena=step.arena._replace(balls=(first, *step.arena.balls[1:])))


def hold_a_ring(before, step):
    """Rings do not turn."""
    return step._replace(arena=step.arena._replace(rings=before.rings))


def hit_late(_before, step):
    """Hits are reported a millionth of a tick late."""
    hits = tuple(hit._replace(time=hit.time + 1e-6 * TICK) for hit in step.hits)
    return step._replace(hits=hits)


def report_one_twice(_before, step):
    """A hit without contact: the last one once more, at the tick's end."""
    if not step.hits or step.dropped:
        return step
    again = step.hits[-1]._replace(time=TICK)
    return step._replace(hits=(*step.hits, again))


def turn_normals(_before, step):
    """Normals point the wrong way."""
    hits = tuple(hit._replace(contact=hit.contact._replace(normal=-hit.contact.normal)) for hit in step.hits)
    return step._replace(hits=hits)


def bounce_askew(_before, step):
    """Balls leave in another direction, by a millionth."""
    hits = tuple(hit._replace(after=hit.after * (1.0 + 1e-6j)) for hit in step.hits)
    return step._replace(hits=hits)


def leap(_before, step):
    """A ball is a millionth farther than it flew."""
    first = step.arena.balls[0]
    moved = first._replace(position=first.position + first.velocity * (1e-6 * TICK))
    return step._replace(arena=step.arena._replace(balls=(moved, *step.arena.balls[1:])))


def free_without_need(_before, step):
    """A ball is said to have been put somewhere else."""
    return step._replace(freed=1)


def shuffle_hits(_before, step):
    """Hits in the wrong order."""
    return step._replace(hits=step.hits[::-1])


def stop_working(_before, _step):
    """An exception."""
    raise ZeroDivisionError("nobody expected this")


SABOTAGES = {
    push_deeper: "ball .*(is at|overlaps)",
    ignore_contacts: "ball . flies into ring|overlaps",
    forget_a_layer: "layers changed without a hit",
    invent_a_break: "layers changed without a hit",
    speed_up: "has speed",
    lose_a_number: "is not finite",
    hold_a_ring: "did not turn",
    hit_late: "ball . flies into ring|a hit without contact|is at",
    report_one_twice: "a hit without contact|wrong layers|an empty slot",
    turn_normals: "not where ball and sector meet|does not leave",
    bounce_askew: "should leave with velocity",
    leap: "its hits lead to",
    free_without_need: "freed that overlapped nothing",
    shuffle_hits: "not in the order of time|flies into",
    stop_working: "ZeroDivisionError: nobody expected this",
}


@pytest.mark.parametrize("change", SABOTAGES, ids=lambda change: change.__name__)
def test_a_broken_advance_is_caught(change, monkeypatch, capsys):
    """Exit code 1, what is wrong, the command that shows it again, and an arena that fails in one tick."""
    sabotaged(monkeypatch, change)
    assert fuzz("--steps", 30_000, "--seed", 2) == 1
    out = capsys.readouterr().out
    case = re.search(r"^case 2:(\d+) fails at tick (\d+): (.*)$", out, re.MULTILINE)
    assert re.search(SABOTAGES[change], case[3])
    assert f"again: python -m tools.fuzz --case 2:{case[1]}\n" in out
    assert fuzz("--case", f"2:{case[1]}") == 1
    assert f"case 2:{case[1]} fails at tick {case[2]}" in capsys.readouterr().out
    arena = re.search(r"^arena = (.*)$", out, re.MULTILINE)[1]
    names = {"Arena": Arena, "Ball": Ball, "Ring": Ring, "nan": math.nan}
    speed = float(re.search(r"advance\(arena, \S+, (\S+)\)", out)[1])
    assert campaign.checked_tick(eval(arena, names), speed)[0] is not None  # noqa: S307  # our own output


def longer(flight):
    """The same flight, said to be free for two ticks more than it is."""
    arena, seconds, turning = flight
    return arena, seconds + 2.0 * TICK, turning


def test_a_flight_that_is_looked_after_too_rarely_is_caught(monkeypatch, capsys):
    """Where a step says that its balls touch nothing for longer than is so; the tick alone would not show it."""
    sabotaged(monkeypatch, lambda _before, step: step._replace(flight=None if step.flight is None else longer(step.flight)))
    assert fuzz("--steps", 30_000, "--seed", 2) == 1
    out = capsys.readouterr().out
    case = re.search(r"^case 2:(\d+) fails at tick \d+: (.*)$", out, re.MULTILINE)
    assert case[2] == campaign.SPARED
    assert out.endswith(f"again: python -m tools.fuzz --case 2:{case[1]}\n")
    assert fuzz("--case", f"2:{case[1]}") == 1


def test_the_smallest_arena_keeps_only_what_fails(monkeypatch):
    """One ball and one ring are enough to fly through a wall."""
    sabotaged(monkeypatch, ignore_contacts)
    failures = [failure for index in range(10) for failure in campaign.play(2, index).failures]
    for failure in failures:
        least = campaign.smallest(failure)
        assert (len(least.arena.balls), len(least.arena.rings)) == (1, 1)
        assert campaign.checked_tick(least.arena, least.speed)[0] is not None


def test_a_case_that_is_fine_is_fine_again(capsys):
    """`--case` plays one case."""
    assert fuzz("--case", "7:3") == 0
    assert capsys.readouterr().out.startswith("case 7:3: 1 cases, ")


def late(found):
    """A time of impact that is a nanosecond late."""
    return found and Impact(found.time + 1e-9, found.slot, found.contact)


@pytest.mark.parametrize(
    "answer",
    [
        late,
        lambda _found: None,
        lambda found: found and found._replace(slot=found.slot + 1),
        lambda found: found and found._replace(time=-1.0),
    ],
)
def test_a_wrong_time_of_impact_is_caught(answer, monkeypatch, capsys):
    """Late, missing, of another sector, or outside of the time asked for."""
    monkeypatch.setattr(impacts, "time_of_impact", lambda *given: answer(time_of_impact(*given)))
    assert fuzz("--impacts", 400, "--seed", 1) == 1
    assert "  impact 1:" in capsys.readouterr().out


def test_an_overlap_between_two_ticks_is_seen():
    """Tunnelling leaves no trace at the ends of a tick: the oracle samples the way."""
    wall = Ring(5.0, 0.1, math.pi, 1)
    through = Ball(4.0 + 0j, 2.0 / TICK + 0j, 0.25)
    assert ring_gap(through.position, 0.25, wall, 0.0) > 0.0
    assert ring_gap(through.moved(TICK).position, 0.25, wall, TICK) > 0.0
    assert first_overlap(through, wall, 0.0, TICK, None, 1e-9) == pytest.approx(0.65 / 2.0 * TICK, rel=1e-2)


@pytest.mark.parametrize("seed", range(40))
def test_the_two_oracles_agree_on_gaps(seed):
    """Floats against 50 digits, one sector or all of them."""
    ball, ring, dt, alive = random_impact(1, seed)
    for time_, slot in ((0.0, 0), (dt / 3.0, ring.count - 1), (dt, ring.count // 2)):
        p = ball.position + ball.velocity * time_
        exact = impacts.exact_gap(impacts.ImpactCase(ball, ring, dt, alive), time_, slot, mpmath)
        if exact + ball.radius > 0:
            assert slot_gap(p, ball.radius, ring, time_, slot) == pytest.approx(float(exact), abs=1e-12)
    assert check_impacts(1, [seed], mpmath)[1] == []


def test_lost_balls_come_back_to_free_places():
    """The play goes on, and never begins with an overlap."""
    for index in range(30):
        arena, speed, chance = random_case(9, index)
        gone = arena._replace(balls=tuple(ball._replace(position=1e3 + 0j) for ball in arena.balls))
        for start in (arena, with_lost_balls_back(gone, speed, chance)):
            assert first_fault(start, advance(start, 0.0, speed), 0.0, speed) is None
            assert all(abs(ball.position) < 1e3 for ball in start.balls)


@pytest.fixture
def terminal():
    """A terminal for a child's progress bar."""
    opened = Terminal()
    yield opened
    opened.close()


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no SIGINT to send")
@pytest.mark.parametrize(
    "arguments", [("--steps", "100000000"), ("--steps", "100000000", "--workers", "2"), ("--impacts", "100000000")]
)
def test_ctrl_c_stops_with_a_summary(children, terminal, arguments):
    """Interrupted once the progress bar counts, it says what was done so far, and the exit code speaks of it."""
    command = [sys.executable, "-m", "tools.fuzz", *arguments]
    environment = os.environ | {"TERM": "xterm", "COLUMNS": "120"}
    process = children.start(
        command, cwd=ROOT, env=environment, stdout=subprocess.PIPE, stderr=terminal.theirs, text=True, encoding="utf-8"
    )
    terminal.given()
    terminal.read_until(r"\b[1-9]\d*/100")
    process.send_signal(signal.SIGINT)
    err = terminal.read_to_the_end()
    out = process.stdout.read()
    assert process.wait() == 130, err
    assert re.search(r"stopped by a signal(; --first \d+ goes on)?\n$", out)
    assert err.splitlines()[-1].endswith("python -m tools.fuzz: interrupted")
    assert "Traceback" not in err


def test_times_of_impact_are_shared_by_workers(capsys):
    """However many there are, the same cases are checked."""
    for workers in ("1", "2"):
        assert run(app, "fuzz", ["--impacts", "450", "--workers", workers]) == 0
    first, again = capsys.readouterr().out.splitlines()
    assert first == again
    assert first.startswith("seed 1: 450 times of impact, ")


@pytest.mark.parametrize(
    ("arguments", "option"),
    [
        (["--case", "1:1", "--impacts", "5"], "--impacts: does nothing beside --case"),
        (["--case", "1:1", "--seed", "5"], "--seed: does nothing beside --case"),
        (["--impacts", "5", "--steps", "5"], "--steps: does nothing beside --impacts"),
        (["--case", "x" * 5000], "expected two whole numbers"),
    ],
)
def test_options_that_would_do_nothing_are_refused(capsys, arguments, option):
    """In one line, before any work."""
    assert run(app, "fuzz", arguments) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert option in err
    assert err.count("\n") == 1
    assert len(err) < 200
