"""The corpus: a fixed list, rebuilt bit for bit, gone on with where it stopped, and what its manifest says."""

import json
from pathlib import Path

import pytest

from tools.crosscheck.corpus import build
from tools.crosscheck.corpus.build import MANIFEST, built_corpus, corpus_sources
from tools.crosscheck.corpus.part import PartJob, finished_part, made_part
from tools.crosscheck.games.sources import AIMED, RANDOM, Source
from tools.crosscheck.results.measurements import ContactVerdict
from tools.crosscheck.run import Job, check_game

SMALL = [Source(None, AIMED, 1, 60), Source(None, "4", 2, 1500), Source(None, RANDOM, 3, 400)]


@pytest.fixture(autouse=True)
def _few_games_in_this_process(monkeypatch):
    def answers(function, jobs, _):
        yield from enumerate(map(function, jobs))

    monkeypatch.setattr(build, "results_of", answers)
    monkeypatch.setattr(build, "corpus_sources", lambda: SMALL)


def built(folder, most=None):
    return built_corpus(folder, most, 8, 1, lambda *_: None)


def test_the_list_is_long_enough_and_always_the_same():
    """Levels, players, random arenas and aimed contacts, mixed, no game twice."""
    sources = corpus_sources()
    assert sources == corpus_sources()
    assert len(sources) == len(set(sources)) > 400
    first = {(source.level if source.level in {AIMED, RANDOM} else "level", source.player) for source in sources[:60]}
    levels = {("level", player) for player in ("autopilot", "mouse", "keys")}
    assert first == levels | {(AIMED, "autopilot"), (RANDOM, "autopilot")}


def test_every_contact_has_a_line(tmp_path: Path):
    """As many as the manifest counts; what they say is what the check of the game alone says."""
    corpus = built(tmp_path)
    assert corpus.agrees
    assert [part["options"] for part in corpus.manifest["games"]] == [source.options() for source in SMALL]
    for source, part in zip(SMALL, corpus.manifest["games"], strict=True):
        lines = [json.loads(line) for line in (tmp_path / part["file"]).read_text().splitlines()]
        rows = check_game(Job(source, 8, recorded=True)).rows
        assert len(lines) == part["contacts"] == rows.contacts
        for line, record in zip(lines, rows.records, strict=True):
            assert complex(*line["game"]["normal"]) == record.normal
            assert line["game"]["time"] == record.situation.time
            assert line["pymunk"]["verdict"] == record.verdict.name.lower()
            assert line["pymunk"]["errors"]["normal_exact"][0] < 1e-12
    totals = corpus.manifest["totals"]
    assert totals["contacts"] == sum(part["contacts"] for part in corpus.manifest["games"]) > 100
    assert totals["unexplained"] == corpus.manifest["verdicts"][ContactVerdict.UNEXPLAINED.name.lower()] == 0
    assert json.loads((tmp_path / MANIFEST).read_text()) == corpus.manifest


def test_it_is_rebuilt_bit_for_bit(tmp_path: Path):
    """Every file of two runs is the same."""
    for name in ("one", "two"):
        built(tmp_path / name)
    files = sorted(path.name for path in (tmp_path / "one").iterdir())
    assert len(files) == 2 * len(SMALL) + 1
    for name in files:
        assert (tmp_path / "one" / name).read_bytes() == (tmp_path / "two" / name).read_bytes()


def test_it_goes_on_where_it_stopped(tmp_path: Path, monkeypatch):
    """After Ctrl-C the manifest has what there is and says that it is not all; the next run checks only the rest."""
    whole = built(tmp_path / "whole")

    def interrupted(function, jobs, _):
        yield 0, function(jobs[0])
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(build, "results_of", interrupted)
        stopped = built(tmp_path / "part")
    assert (stopped.complete, stopped.agrees, stopped.manifest["totals"]["games"]) == (False, False, 1)

    checked = []
    monkeypatch.setattr(build, "made_part", lambda job: checked.append(job.number) or made_part(job))
    corpus = built(tmp_path / "part")
    assert checked == [1, 2]
    assert corpus.manifest == whole.manifest


@pytest.mark.parametrize(
    "spoil",
    [
        lambda folder: (folder / "0001.jsonl").write_text("{}\n"),
        lambda folder: (folder / "0001.json").write_text("not JSON"),
        lambda folder: (folder / "0001.json").write_text("[]"),
        lambda folder: (folder / "0001.jsonl").unlink(),
    ],
    ids=["another content", "no JSON", "no object", "no file"],
)
def test_what_is_damaged_is_made_again(tmp_path: Path, spoil):
    """A file that is not what its summary says, or a summary that is none, counts as not there."""
    whole = built(tmp_path)
    spoil(tmp_path)
    assert finished_part(PartJob(1, SMALL[1], 8, str(tmp_path), whole.manifest["code"])) is None
    assert built(tmp_path).manifest == whole.manifest


def test_another_program_begins_anew(tmp_path: Path, monkeypatch):
    """What an earlier version of the code has written proves nothing about this one."""
    built(tmp_path)
    monkeypatch.setattr(build, "code_hash", lambda: "another")
    job = PartJob(0, SMALL[0], 8, str(tmp_path), "another")
    assert finished_part(job) is None
    built(tmp_path)
    assert finished_part(job) is not None


def test_a_part_of_the_list_is_a_corpus_of_its_own(tmp_path: Path):
    """--games limits it; its hash is another."""
    part, whole = built(tmp_path / "part", most=2), built(tmp_path / "whole")
    assert part.complete
    assert part.manifest["totals"]["games"] == part.manifest["listed"] == 2
    assert part.manifest["games_sha256"] != whole.manifest["games_sha256"]
    assert part.manifest["games"] == whole.manifest["games"][:2]
