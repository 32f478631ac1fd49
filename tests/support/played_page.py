"""The page's Python in the hands of a test, without a browser."""

import json

from game.web.client.page import Page
from game.web.client.playing import GameOnPage


class PlayedPage:
    """A page in the hands of a test."""

    def __init__(self, folder="", *, changes=True, **options):
        """folder: of stored files. changes: whether the sound is turned off, which is stored."""
        self.page = Page(b'{"rate": 1, "sounds": []}', str(folder), calm=True, **options)
        if changes:
            self.change(sound=False, music=0)

    def frame(self, *signals, seconds=0.0):
        """The reply to some signals."""
        request = {"seconds": seconds, "width": 1280, "height": 800, "signals": signals}
        return json.loads(self.page.frame(json.dumps(request)))

    def choose(self, item, value=""):
        """The reply after a control was used."""
        return self.frame({"type": "choose", "id": item, "value": value})

    def go(self, fragment):
        """The reply after a link was opened."""
        return self.frame({"type": "link", "fragment": fragment})

    def key(self, code, key="", *, down=True):
        """Press or release a key."""
        return self.frame({"type": "key", "code": code, "key": key or code, "down": down})

    def fingers(self, *moves):
        """Move fingers. moves: phase, number, x, y."""
        for phase, number, x, y in moves:
            self.frame({"type": "pointer", "phase": phase, "id": number, "touch": True, "x": x, "y": y})

    def change(self, **settings):
        """Other settings."""
        self.page._state.change(self.page._state.settings._replace(**settings))

    @property
    def game(self):
        """The game that is played."""
        assert isinstance(self.page._screen, GameOnPage)
        return self.page._screen.game

    @property
    def view(self):
        """The view of the arena."""
        return self.page._state.view
