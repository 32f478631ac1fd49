"""Finished games in the user's folder."""

import hashlib

import pytest

from game.levels import classic
from game.replays.file import load
from game.rules import Controls, Phase, new_game, tick
from game.storage import games as kept
from game.storage import stored_file
from game.storage.games import GameFiles, StoredGame


@pytest.fixture(autouse=True)
def short(monkeypatch):
    """Games of a few ticks are worth keeping."""
    monkeypatch.setattr(kept, "_SHORTEST", 0.02)


def play(games, ticks, *, closed=True):
    """A game of some ticks."""
    game = new_game(classic(), 1)
    for _ in range(ticks):
        game = tick(game, Controls()).game
        games(Controls(), game)
    if closed:
        games.close()


def refused(_path, _data):
    """A disk that is full."""
    raise OSError(28, "No space left on device")


def test_of_games_that_nobody_keeps_the_last_twenty_stay(tmp_path):
    """Of 24 the first two stay, one kept by the player and one that a score refers to, and the newest twenty of the others."""
    needed = set()
    games = GameFiles(tmp_path, lambda: needed)
    for number in range(24):
        play(games, 5 + number)
        if number == 0:
            games.change(StoredGame(games.last.file, "The first", kept=True))
        if number == 1:
            needed.add(games.last.file)
    assert games.problem is None
    lengths = {load(path).ticks for path in games.paths()}
    assert lengths == {5, 6, *range(9, 29)}
    assert [game.title for game in GameFiles(tmp_path).listed() if game.title] == ["The first"]


def test_a_game_is_kept_at_its_end(tmp_path):
    """Its file is there with the tick that ends it, before another game begins; the list has its score and its hash."""
    games = GameFiles(tmp_path)
    game = new_game(classic()[:1], 1)._replace(lives=1)
    while game.phase != Phase.OVER:
        controls = Controls(serve=game.phase == Phase.SERVING, give_up=game.tick > 20)
        game = tick(game, controls).game
        games(controls, game)
    (listed,) = GameFiles(tmp_path).listed()
    assert (listed.score, listed.ticks, listed.won) == (game.score, game.tick, False)
    assert hashlib.sha256((tmp_path / listed.file).read_bytes()).hexdigest() == listed.sha256
    play(games, 4)
    assert len(games.paths()) == 1


def test_two_windows_whose_games_end_in_the_same_second_keep_both(tmp_path, monkeypatch):
    """Each has its own file, and both are in the list of a third."""
    monkeypatch.setattr(kept.time, "strftime", lambda _: "2026-01-01 00-00-00")
    first, second = GameFiles(tmp_path), GameFiles(tmp_path)
    play(first, 5)
    play(second, 6)
    assert sorted(game.ticks for game in GameFiles(tmp_path).listed()) == [5, 6]
    assert {load(path).ticks for path in first.paths()} == {5, 6}


def test_a_game_that_could_not_be_listed_is_listed_with_the_next(tmp_path, monkeypatch):
    """All are there with their own lengths once the list can be written again."""
    games = GameFiles(tmp_path)
    play(games, 7)
    with monkeypatch.context() as full:
        full.setattr(stored_file, "write_atomically", refused)
        play(games, 5)
    assert "not saved" in games.problem
    play(games, 6)
    assert sorted(game.ticks for game in GameFiles(tmp_path).listed()) == [5, 6, 7]


def test_what_is_no_game_does_not_break_the_list(tmp_path):
    """A link to nothing and a folder of that ending are left out and left alone; what a killed session left is removed."""
    (tmp_path / "gone.polar").symlink_to("nothing")
    (tmp_path / "folder.polar").mkdir()
    (tmp_path / ".polar-breakout-00.tmp").write_bytes(b"half a ga")
    (tmp_path / "of-old.polar").write_bytes(b"a game")
    games = GameFiles(tmp_path)
    play(games, 5)
    assert [game.file for game in games.listed()][1:] == ["of-old.polar"]
    assert (tmp_path / "gone.polar").is_symlink()
    assert not (tmp_path / ".polar-breakout-00.tmp").exists()


def test_games_are_renamed_copied_and_deleted(tmp_path):
    """A copy is named after the title and takes no other's place; a deleted game is gone from folder and list."""
    games, share = GameFiles(tmp_path / "replays"), tmp_path / "share"
    play(games, 5)
    titled = StoredGame(games.last.file, "../Best: yet", kept=True, ticks=5)
    games.change(titled)
    copies = [games.export(titled, share) for _ in range(2)]
    assert [path.name for path in copies] == ["Best yet.polar", "Best yet-2.polar"]
    assert all(load(path).ticks == 5 for path in copies)
    assert games.delete(titled) is None
    assert games.listed() == []
    assert games.delete(StoredGame("../share/Best yet.polar")) is not None
    assert copies[0].exists()


def test_short_games_are_not_kept_but_recorded_where_that_was_asked_for(tmp_path, monkeypatch):
    """Below the shortest length the folder is not even made; the file of `--record` has every game."""
    monkeypatch.setattr(kept, "_SHORTEST", 5.0)
    games = GameFiles(tmp_path / "replays", record=tmp_path / "mine.polar")
    play(games, 1199)
    assert not (tmp_path / "replays").exists()
    assert load(tmp_path / "mine.polar").ticks == 1199
    play(games, 1200)
    assert len(games.paths()) == 1


def test_play_goes_on_where_nothing_can_be_kept(tmp_path):
    """A folder that cannot be made is a problem to be told, not an error."""
    (tmp_path / "data").write_text("a file where the folder should be")
    games = GameFiles(tmp_path / "data" / "replays")
    play(games, 5)
    assert games.problem is not None
    assert games.last is None
