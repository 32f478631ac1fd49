"""The languages: every text is translated, plurals follow each language's own rule, and the player's choice holds."""

import polib
import pytest

from game import language
from game.generated import generated
from game.language import CODES, ENGLISH, LANGUAGES, SYSTEM, choose, ntr, system_prefers, tr
from game.levels.names import level_name
from tools.translations.check import FOLDER, Text, problems, texts


@pytest.fixture(autouse=True)
def english():
    """English again at the end, and a system without preferences."""
    yield
    system_prefers(())
    choose(ENGLISH.code)


@pytest.fixture(scope="module")
def wanted():
    """The texts of the game."""
    return texts()


@pytest.mark.parametrize("code", [code for code in CODES if code != ENGLISH.code])
def test_every_text_is_translated(wanted, code):
    """Each catalogue has exactly the texts of the game, with their placeholders, in as many forms as its plurals have."""
    catalogue = polib.pofile(str(FOLDER / f"{code}.po"))
    forms = int(catalogue.metadata["Plural-Forms"].partition("nplurals=")[2].partition(";")[0])
    assert problems(wanted, catalogue, forms) == []


@pytest.mark.parametrize(
    ("entry", "said"),
    [
        (None, "missing"),
        ({"msgid": "gone", "msgstr": "weg"}, "not in the code any more"),
        ({"msgid": "{n} balls", "msgstr": ""}, "not translated"),
        ({"msgid": "{n} balls", "msgstr": "viele Kugeln"}, "other placeholders"),
        ({"msgid": "{n} balls", "msgstr": "{m} Kugeln"}, "other placeholders"),
        ({"msgid": "{n} balls", "msgstr": "{n} Kugeln "}, "other placeholders or edges"),
        ({"msgid": "{n} balls", "msgstr": "{n} Kugeln", "flags": ["fuzzy"]}, "not translated"),
    ],
)
def test_what_is_wrong_with_a_catalogue_is_found(entry, said):
    """Texts that are missing, left over, untranslated or have other placeholders."""
    catalogue = [] if entry is None else [polib.POEntry(**entry)]
    assert any(said in line for line in problems([Text("{n} balls")], catalogue, 2))


def test_the_system_is_asked_unless_the_player_has_chosen():
    """The first language that the game knows of those that the system prefers; English without any."""
    system_prefers(["fr_FR", "cs-CZ", "de"])
    choose(SYSTEM)
    assert tr("Continue") == "Pokračovat"
    choose("de")
    assert tr("Continue") == "Weiter"
    choose("en")
    assert tr("Continue") == "Continue"
    system_prefers(["fr"])
    choose(SYSTEM)
    assert tr("Continue") == "Continue"


def test_plurals_follow_the_language():
    """Czech has a form for one, one for two to four, and one for more."""
    said = {}
    for code in CODES:
        choose(code)
        said[code] = [ntr("{count} layer left", "{count} layers left", count).format(count=count) for count in (1, 2, 5)]
    assert said["cs"] == ["zbývá 1 vrstva", "zbývají 2 vrstvy", "zbývá 5 vrstev"]
    assert said["de"] == ["noch 1 Lage", "noch 2 Lagen", "noch 5 Lagen"]
    assert said["en"] == ["1 layer left", "2 layers left", "5 layers left"]


def test_every_language_can_be_chosen_and_drawn():
    """It has a catalogue, its own name, and letters that the game's font has."""
    pygame = pytest.importorskip("pygame")
    pygame.font.init()
    try:
        font = pygame.font.Font(None, 30)
        for code, name in LANGUAGES:
            catalogue = language.catalogue(code)
            translated = "".join(map(str, getattr(catalogue, "_catalog", {}).values()))
            assert None not in font.metrics("".join(sorted(set(name + translated) - {"\n"})))
    finally:
        pygame.quit()


def test_endless_levels_are_called_in_the_players_language():
    """By their number, which may be followed by that of the seed, as scores have it; other names are texts themselves."""
    names = (generated(5, 2).name, "Endless 3 (42)", "First Wall")
    assert [level_name(name) for name in names] == ["Endless 3", "Endless 3 (42)", "First Wall"]
    choose("de")
    assert [level_name(name) for name in names] == ["Endlos 3", "Endlos 3 (42)", "Erste Mauer"]
