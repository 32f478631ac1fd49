"""Replay files: round trips, the format, and every way a file can be wrong."""

import hashlib
import struct
import tracemalloc
import zlib
from itertools import product
from pathlib import Path

import msgspec
import pytest

from game.autopilot import Autopilot
from game.levels import classic
from game.replays import file as replay
from game.replays.file import BLOCK, MAX_TICKS, Recorder, Recording, controls_of, decoded, load, played, save
from game.replays.state_hash import FIELDS, field_checks, fields, state_hash
from game.replays.verify import verified
from game.rules import LIVES, POINTER_STEPS, SOURCE_RULES, Controls, Difficulty, Ruleset, new_game, tick
from game.system.errors import BadInputError
from physics import PHYSICS_VERSION
from tests.support.games.players import KeyPlayer, MousePlayer
from tests.support.games.recordings import TICKS, recorded

HEADER = b"polar-breakout replay 3\n"


@pytest.fixture(scope="module")
def mouse():
    """A recording of a game played with the mouse."""
    return recorded(MousePlayer(3))[0]


@pytest.fixture(scope="module")
def file_bytes(mouse, tmp_path_factory):
    """The same as a file's bytes."""
    path = tmp_path_factory.mktemp("replay") / "game.polar"
    save(mouse, path)
    return path.read_bytes()


def packed(body: bytes) -> bytes:
    """A file around a body, its checksum right."""
    return HEADER + hashlib.sha256(body).digest() + body


def altered(recording: Recording, **fields) -> bytes:
    """A well-formed file around a recording with some fields changed."""
    changed = {name: getattr(recording, name) for name in recording.__struct_fields__} | fields
    return packed(zlib.compress(msgspec.msgpack.encode(changed)))


@pytest.mark.parametrize("player", [MousePlayer(5), KeyPlayer(5)])
def test_a_recording_plays_the_same_game(player, tmp_path: Path):
    """Saved, loaded and played again, a game ends in the same state, by the same controls."""
    recording, end = recorded(player)
    save(recording, tmp_path / "game.polar")
    loaded = load(tmp_path / "game.polar")
    assert loaded == recording
    assert [done.game for done in played(loaded)][-1] == end
    assert verified(loaded).divergence is None
    assert state_hash(verified(loaded).game) == state_hash(end)
    assert [path.name for path in tmp_path.iterdir()] == ["game.polar"]


@pytest.mark.parametrize("ticks", [0, 1, BLOCK - 1, BLOCK, BLOCK + 1, 2 * BLOCK])
def test_recordings_of_any_length_verify(ticks, tmp_path: Path):
    """An empty recording, and those that end at, before and after a block, are whole."""
    recording, _ = recorded(KeyPlayer(1), ticks)
    save(recording, tmp_path / "game.polar")
    verdict = verified(load(tmp_path / "game.polar"))
    assert verdict.divergence is None
    assert verdict.game.tick == ticks


def test_runs_hold_any_controls():
    """Controls of every kind, and longer runs than one run can count, come back as they went in."""
    levels = classic()
    game = new_game(levels, 0)
    plan = [
        *[Controls(*one) for one in product((-1, 0, 1), (None, 0, POINTER_STEPS - 1), (False, True), (False, True))],
        *[Controls(0, None, False, False, *one) for one in product((0, 7, 65535), (-1, 1), (None, 0, 9))],
        *[Controls(1)] * 70_000,
        Controls(),
    ]
    recorder = Recorder(levels, 0)
    for controls in plan:
        recorder.add(controls, game)
    assert list(controls_of(recorder.recording())) == plan
    assert len(recorder.recording().runs) == 10 * (36 + 18 + 2 + 1)


def test_a_recorder_stops_at_the_longest_recording():
    """Ticks beyond an hour are left out, so that what is written can be read."""
    recorder = Recorder(classic(), 0)
    recorder.ticks = MAX_TICKS
    recorder.add(Controls(), new_game(classic(), 0))
    assert recorder.ticks == MAX_TICKS


def test_every_truncation_is_refused(file_bytes):
    """A file cut off anywhere is refused in one line."""
    for length in range(len(file_bytes)):
        with pytest.raises(BadInputError, match=r"^x: [^\n]+$"):
            decoded(file_bytes[:length], "x")


def test_every_flipped_bit_is_refused(file_bytes):
    """A file with any single bit flipped is refused in one line."""
    for place in range(len(file_bytes)):
        for bit in range(8):
            flipped = bytearray(file_bytes)
            flipped[place] ^= 1 << bit
            with pytest.raises(BadInputError, match=r"^x: [^\n]+$"):
                decoded(bytes(flipped), "x")


def test_foreign_and_newer_files_are_named(mouse, file_bytes):
    """Trailing junk, other files, newer formats and another physics are each told apart."""
    body = file_bytes[len(HEADER) + 32 :]
    newer = altered(mouse, physics_version=PHYSICS_VERSION + 1)
    for data, reason in (
        (b"", "not a replay"),
        (b"polar-breakout replay \n", "not a replay"),
        (b"polar-breakout replay 4\n" + file_bytes[len(HEADER) :], "format 4; this game reads formats 1 to 3"),
        (file_bytes + b"x", "checksum"),
        (packed(body + b"x"), "something follows"),
        (packed(body[:-9]), "cut off"),
        (packed(b"not zlib"), "not a zlib stream"),
        (packed(zlib.compress(b"\xc1")), "damaged replay"),
        (packed(zlib.compress(b"\x90")), "Expected `object`"),
        (newer, f"physics {PHYSICS_VERSION} and would play it differently"),
    ):
        with pytest.raises(BadInputError, match=reason):
            decoded(data, "x")


def test_a_file_too_large_is_refused(tmp_path: Path):
    """Without looking at what is in it."""
    file = tmp_path / "large.polar"
    file.write_bytes(HEADER + bytes(25 * 2**20))
    with pytest.raises(BadInputError, match=r"large\.polar: replay too large; expected at most 24 MB"):
        load(file)


def older(recording: Recording, version: int, flag: int = 0) -> bytes:
    """A file of an older format, five bytes a run and no ruleset. flag: set in the first run."""
    runs = [
        struct.pack("<HBH", ticks, flags & 31, pointer)
        for ticks, flags, pointer, _, _ in struct.iter_unpack("<5H", recording.runs)
    ]
    runs[0] = runs[0][:2] + bytes([runs[0][2] | flag]) + runs[0][3:]
    fields = {name: getattr(recording, name) for name in recording.__struct_fields__ if name != "ruleset"} | {
        "runs": b"".join(runs)
    }
    body = zlib.compress(msgspec.msgpack.encode(fields))
    return b"polar-breakout replay %d\n" % version + hashlib.sha256(body).digest() + body


def test_the_formats_before_are_read(mouse):
    """As games under the source's rules. In format 1 no ball could be given up; a run that does so is not of that format."""
    assert decoded(older(mouse, 1), "x") == decoded(older(mouse, 2), "x") == mouse
    assert mouse.ruleset == SOURCE_RULES
    assert any(controls.give_up for controls in controls_of(decoded(older(mouse, 2, 16), "x")))
    for version, flag in ((1, 16), (2, 32)):
        with pytest.raises(BadInputError, match="runs: unknown action"):
            decoded(older(mouse, version, flag), "x")


def test_an_arcade_game_plays_again(tmp_path: Path):
    """With its difficulty, its chance and all that power-ups did; the same inputs under other rules are another game."""
    ruleset, levels = Ruleset(Difficulty.EASY), classic()[3:]
    game, pilot, recorder = new_game(levels, 11, ruleset), Autopilot(), Recorder(levels, 11, ruleset)
    for _ in range(6000):
        controls = pilot.controls(game)
        game = tick(game, controls).game
        recorder.add(controls, game)
    assert game.statistics.game.drops_caught > 0
    save(recorder.recording(), tmp_path / "game.polar")
    loaded = load(tmp_path / "game.polar")
    assert verified(loaded) == (game, None)
    assert verified(msgspec.structs.replace(loaded, ruleset=Ruleset(Difficulty.HARD))).divergence is not None
    with pytest.raises(BadInputError, match="ruleset"):
        decoded(altered(loaded, ruleset=(7, True)), "x")


def test_a_game_with_a_ball_given_up_plays_again(tmp_path: Path):
    """The life it costs is lost in the recording, too."""
    levels = classic()
    game, recorder = new_game(levels, 5), Recorder(levels, 5)
    for number in range(300):
        controls = Controls(serve=number == 10, give_up=number == 200)
        game = tick(game, controls).game
        recorder.add(controls, game)
    assert game.lives == LIVES - 1
    save(recorder.recording(), tmp_path / "game.polar")
    loaded = load(tmp_path / "game.polar")
    assert [controls.give_up for controls in controls_of(loaded)].index(True) == 200
    assert verified(loaded) == (game, None)


def test_contradictions_are_refused(mouse):
    """Fields that do not fit together are refused, each by its name."""
    ticks, runs = mouse.ticks, mouse.runs
    other = list(classic()[1:])
    impossible = msgspec.structs.replace(mouse.levels[0], ground_radius=5.0)
    for wrong, reason in (
        ({"levels": other}, "levels_hash: another level"),
        ({"levels": [impossible]}, r"levels\[0\]: paddles.radius: .*beyond ground_radius 5"),
        ({"levels": []}, "levels"),
        ({"seed": -1}, "seed"),
        ({"seed": 1.5}, "seed"),
        ({"ticks": ticks + 1}, "runs: 1500 where 1501 ticks need 1501"),
        ({"ticks": 10**18}, "ticks"),
        ({"runs": runs[:-1]}, "runs: cut off"),
        ({"runs": b"\0\0" + runs[2:]}, "runs: unknown action"),
        ({"runs": runs[:2] + b"\x43" + runs[3:]}, "runs: unknown action 67 at tick 0"),
        ({"runs": runs[:2] + b"\xc1" + runs[3:]}, "runs: unknown action 193"),
        ({"runs": runs[:3] + b"\x02" + runs[4:]}, "runs: unknown action 5"),
        ({"runs": runs[:6] + b"\x02" + runs[7:]}, "runs: unknown action"),
        ({"hashes": mouse.hashes[:-32]}, "hashes"),
        ({"trace": mouse.trace + b"x"}, "trace"),
        ({"surprise": 1}, "unknown field `surprise`"),
        ({"game_version": "x" * 1000}, "game_version"),
    ):
        with pytest.raises(BadInputError, match=reason):
            decoded(altered(mouse, **wrong), "x")


def test_a_bomb_is_refused_before_it_is_unpacked():
    """A small file that unpacks to a gigabyte is refused with less than 100 MB in use."""
    maker = zlib.compressobj(9)
    first, again = [maker.compress(b"\0" * 2**20) + maker.flush(zlib.Z_FULL_FLUSH) for _ in range(2)]
    bomb = first + 1023 * again  # after a full flush the same megabyte is the same bytes
    tracemalloc.start()
    with pytest.raises(BadInputError, match="larger than 32 MB"):
        decoded(packed(bomb), "x")
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 100 * 2**20


def test_many_runs_stay_small():
    """The longest game with a new action at every tick is decoded with less than 100 MB in use."""
    levels = classic()
    recording = msgspec.structs.replace(
        Recorder(levels, 1).recording(),
        ticks=MAX_TICKS,
        runs=b"\x01\x00\x41\x00\x00\x00\x00\x00\x00\x00" * MAX_TICKS,
        hashes=bytes(MAX_TICKS // BLOCK * 32),
        trace=bytes(MAX_TICKS * len(FIELDS)),
    )
    data = altered(recording)
    tracemalloc.start()
    assert decoded(data, "x").ticks == MAX_TICKS
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 100 * 2**20


@pytest.mark.parametrize("place", [1, 59, 60, 61, 700, TICKS])
def test_a_divergence_is_located(mouse, place):
    """A trace and hashes made with other velocities from some tick on are found out: block, tick and field."""
    velocities = FIELDS.index("ball velocities")
    trace = bytearray(mouse.trace)
    hashes = bytearray(mouse.hashes)
    for number in range(place, TICKS + 1):
        trace[velocities * TICKS + number - 1] ^= 0x55
    for block in range((place - 1) // BLOCK, len(hashes) // 32):
        hashes[block * 32] ^= 1
    found = verified(msgspec.structs.replace(mouse, trace=bytes(trace), hashes=bytes(hashes))).divergence
    assert found == ((place - 1) // BLOCK, place, "ball velocities")
    assert f"tick {place} " in str(found)


def test_a_wrong_hash_alone_is_told_apart(mouse):
    """Where only a recorded hash is wrong, the block is named and no tick is invented."""
    hashes = bytearray(mouse.hashes)
    hashes[5 * 32] ^= 1
    found = verified(msgspec.structs.replace(mouse, hashes=bytes(hashes))).divergence
    assert found == (5, None, None)
    assert "ticks 301-360" in str(found)


def test_another_input_diverges(mouse):
    """A recording whose first run turns the other way is reported as diverged at its first tick, in the paddles."""
    runs = bytearray(mouse.runs)
    runs[2] = (runs[2] & ~3) | 2 if runs[2] & 3 == 1 else (runs[2] & ~3) | 1
    found = verified(decoded(altered(mouse, runs=bytes(runs)), "x")).divergence
    assert (found.block, found.tick) == (0, 1)


def test_every_bit_of_the_state_is_in_the_hash():
    """A change in the last bit of any number of the state changes the state hash and one byte of the trace's field."""
    game = recorded(MousePlayer(3), 400)[1]
    ball = game.arena.balls[0]
    nearby = ball.position.real * (1 + 2.0**-52)
    moved = ball._replace(position=complex(nearby, ball.position.imag))
    ring = game.arena.rings[1]._replace(phase=game.arena.rings[1].phase * (1 + 2.0**-52))
    for other, field in (
        (game._replace(arena=game.arena._replace(balls=(moved,))), "ball positions"),
        (game._replace(arena=game.arena._replace(rings=(game.arena.rings[0], ring, *game.arena.rings[2:]))), "brick rings"),
        (game._replace(score=game.score + 1), "score and lives"),
        (game._replace(draws=game.draws + 1), "phase and chance"),
    ):
        assert state_hash(other) != state_hash(game)
        differing = [FIELDS[k] for k, (a, b) in enumerate(zip(field_checks(game), field_checks(other), strict=True)) if a != b]
        assert differing == [field]


def test_a_replay_that_cannot_be_written_is_named(mouse, tmp_path: Path):
    """Writing into a folder that does not exist is one line, and leaves nothing behind."""
    with pytest.raises(BadInputError, match="cannot write replay"):
        save(mouse, tmp_path / "none" / "game.polar")
    with pytest.raises(BadInputError, match="cannot write replay"):
        save(mouse, tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_a_string_that_is_not_utf_8_is_refused(mouse):
    """Its checksum may be right all the same."""
    body = msgspec.msgpack.encode(mouse).replace(b"Carousel", b"\xff\xfe\x80ousel")
    with pytest.raises(BadInputError, match=r"^x: damaged replay; [^\n]*utf-8[^\n]*$"):
        decoded(packed(zlib.compress(body)), "x")


def test_max_ticks_fit_the_largest_file():
    """An hour of the busiest game is smaller than what the reader accepts."""
    busiest = MAX_TICKS * (len(fields(Ruleset())) + 10) + MAX_TICKS // BLOCK * 32
    assert busiest < min(replay._MAX_BODY_SIZE, replay._MAX_FILE_SIZE)
