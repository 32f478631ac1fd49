"""What the tests of the lab share: a scene that counts, and the lab in a window."""

import pytest

from game.lab.kit.parameters import defaults
from game.lab.session import session
from game.lab.session.share import SharedScene
from game.lab.window.screen import Lab
from tests.support.lab_scenes import counting_scene
from tests.support.windows.lab_desk import LabDesk


@pytest.fixture
def run():
    """A scene that counts its ticks, at its start."""
    scene = counting_scene(limit=100)
    return session.opened(SharedScene(scene, defaults(scene.parameters)))


@pytest.fixture
def desk():
    """The lab at case 2."""
    found = LabDesk()
    yield found
    found.close()


@pytest.fixture
def unseen(monkeypatch):
    """Draws no pictures of the lab: they take most of the time of tests that are not about them."""
    monkeypatch.setattr(Lab, "draw", lambda _lab, _surface: None)
