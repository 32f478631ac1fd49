"""A best run that the desktop has stored: its files, also for a browser, and the game tick by tick."""

import base64

from game.autopilot import Autopilot
from game.rules import Phase, Ruleset, new_game, tick
from game.storage.progress import Best, record_name
from game.storage.storage import Storage


def stored_run(folder, levels, ticks=1300, *, name=None):
    """Store a game that the autopilot has begun as the best run of the first level; the games after its first serve.

    name: under which the best is stored, instead of the level's.
    """
    storage, pilot, game = Storage(folder), Autopilot(), new_game(levels, 5, Ruleset())
    played = []
    for _ in range(ticks):
        controls = pilot.controls(game)
        game = tick(game, controls).game
        storage.games(controls, game)
        if played or game.phase == Phase.PLAYING:
            played.append(game)
    storage.level_done(Best(name or record_name(levels[0]), "normal", 5))
    storage.game_done()
    return played


STORE = """files => new Promise((done, failed) => {
  const asked = indexedDB.open("/kept", 21);
  asked.onerror = () => failed(asked.error);
  asked.onsuccess = () => {
    const change = asked.result.transaction("FILE_DATA", "readwrite"), store = change.objectStore("FILE_DATA");
    const timestamp = new Date();
    store.put({ timestamp, mode: 0o40777 }, "/kept/replays");
    for (const [name, text] of files) {
      const contents = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
      store.put({ timestamp, mode: 0o100666, contents }, `/kept/${name}`);
    }
    change.oncomplete = () => {
      asked.result.close();
      done(files.length);
    };
  };
})"""
"""Puts files into the browser's store, where the page reads them when it is opened again. Argument: names and Base64."""


def for_browser(folder):
    """The files of a folder as `STORE` wants them."""
    files = [path for path in folder.rglob("*") if path.is_file()]
    return [[path.relative_to(folder).as_posix(), base64.b64encode(path.read_bytes()).decode()] for path in files]
