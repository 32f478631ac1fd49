"""How the page starts: from the memory that a visit before it has stored, or from the beginning."""

import hashlib

import numpy as np
import pytest

from game.sound.notes import every_note
from game.sound.synth import waveform
from game.web.client.sounds import RATE

COPIED, IMPORTED = "memory copied", "game imported"
STORED = """async change => {
  const [name] = (await caches.keys()).filter(one => one.startsWith("polar-breakout memory "));
  if (!name) return "";
  const cache = await caches.open(name), [key] = await cache.keys(), held = await cache.match(key);
  const bytes = new Uint8Array(await held.arrayBuffer());
  if (change === "torn") await cache.put(key, new Response(bytes.subarray(0, bytes.length / 2), { headers: held.headers }));
  if (change === "unusable") {
    bytes.fill(0, 0, 4);
    const digest = [...new Uint8Array(await crypto.subtle.digest("SHA-256", bytes))];
    const headers = { "X-Digest": digest.map(byte => byte.toString(16).padStart(2, "0")).join("") };
    await cache.put(key, new Response(bytes, { headers }));
  }
  return name;
}"""
"""The name of the cache that has the snapshot; what is in it is changed first, where that is wanted."""
NO_ROOM = "Cache.prototype.put = () => Promise.reject(new DOMException('full', 'QuotaExceededError'));"
FORBIDDEN = "Object.defineProperty(self, 'caches', { get() { throw new DOMException('no', 'SecurityError'); } });"


def started(page):
    """Open the page and play a little. Returns the steps of its start, the game's hash, and a random number."""
    page.open()
    page.use("play")
    page.wait(lambda: page.standing().get("phase") == "SERVING")
    return page.timeline(), (page.standing()["hash"], page.ask("random"))


def test_a_second_visit_copies_the_memory_and_its_games_differ(open_page):
    """Python is not started again; after copying a snapshot, games and random numbers differ all the same."""
    with open_page() as page:
        assert IMPORTED in page.timeline()
        assert page.tab.evaluate("[progress.value, progress.hidden]") == [1, True]
        assert page.ask("snapshot") is True
        (first, one), (second, other) = started(page), started(page)
        assert COPIED in first
        assert COPIED in second
        assert IMPORTED not in first + second
        assert [here for here, there in zip(one, other, strict=True) if here == there] == []


@pytest.mark.parametrize(("change", "starts"), [("torn", 1), ("unusable", 2)])
def test_a_snapshot_that_cannot_be_used_is_discarded_and_stored_anew(open_page, change, starts):
    """Half of it, which its digest shows before it is used; and one that is not a snapshot, which the runtime refuses."""
    with open_page() as page:
        page.ask("snapshot")
        assert page.tab.evaluate(STORED, change)
        steps, _hash = started(page)
        assert IMPORTED in steps
        assert steps.count("runtime ready") == starts
        assert page.ask("snapshot") is True
        assert COPIED in started(page)[0]


def test_a_new_version_of_the_site_replaces_the_snapshot(open_page, site, monkeypatch):
    """The old one is not asked for, and goes."""
    with open_page() as page:
        page.ask("snapshot")
        before = page.tab.evaluate(STORED, "")
        version = before.rpartition(" ")[2].encode()
        monkeypatch.setitem(site, "snapshot.js", site["snapshot.js"].replace(version, b"0" * len(version)))
        assert IMPORTED in started(page)[0]
        assert page.ask("snapshot") is True
        assert page.tab.evaluate("caches.keys()") == [before.replace(version.decode(), "0" * len(version))]


@pytest.mark.parametrize("hindered", [NO_ROOM, FORBIDDEN], ids=["full", "forbidden"])
def test_without_room_or_leave_to_store_it_every_visit_is_a_first_one(open_page, hindered):
    """No error, no word: what the player has lost is a second."""
    with open_page(lambda page: page.begin_with("snapshot.js", hindered)) as page:
        assert page.ask("snapshot") is False
        assert IMPORTED in started(page)[0]


def test_the_page_unpacks_the_very_samples(page):
    """Their digest, by the page's own code."""
    samples = page.tab.evaluate("""async () => {
      const { undifferenced } = await import("./archives.js");
      const answer = await fetch("sounds.packed");
      const bytes = await new Response(answer.body.pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
      const digest = await crypto.subtle.digest("SHA-256", undifferenced(new Uint8Array(bytes)).buffer);
      return [...new Uint8Array(digest)];
    }""")
    waves = np.concatenate([waveform(note, RATE) for note in every_note()])
    assert bytes(samples) == hashlib.sha256(np.rint(np.clip(waves, -1.0, 1.0) * 32767).astype("<i2").tobytes()).digest()
