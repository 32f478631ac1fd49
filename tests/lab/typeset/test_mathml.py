"""Formulas for browsers: the desktop's TeX translated to MathML."""

import re
from xml.etree import ElementTree as ET

import pytest

from game.lab.registry import scenes
from game.lab.session import session as sessions
from game.lab.typeset.mathml import mathml_line

NUMBER = re.compile(r"\d+(?:\.\d+)?")


@pytest.mark.parametrize("scene", scenes(), ids=lambda scene: scene.name)
def test_every_formula_is_whole(scene):
    """It is well-formed, has all numbers of the line in their order, and contains no TeX."""
    for line in sessions.fresh(scene, None).picture.formula:
        root = ET.fromstring(f"<p>{mathml_line(line)}</p>")  # noqa: S314  # ours
        words = " ".join(root.itertext())
        assert NUMBER.findall(words) == NUMBER.findall(line.replace("²", " 2 ").replace("³", " 3 ")), line
        assert not re.search(r"[\\{}$^]|circ", words.replace("^", "", line.count("q"))), line


def test_a_quotient_an_index_and_a_prime_have_their_elements():
    """Shown by the reset to the fixed speed, and by a change along the normal."""
    v, v_res = (
        '<mi mathvariant="normal" class="vector">v</mi>',
        '<mi mathvariant="normal" class="vector">v</mi><mtext>res</mtext>',
    )
    reset = mathml_line("v := v_0 v_res / |v_res|")
    assert reset.startswith(f"<math>{v}</math> <math>")
    assert f'<mfrac displaystyle="true"><msub>{v_res}</msub><mrow>' in reset
    assert f"<msubsup>{v}<mi>n</mi><mo>\u2032</mo></msubsup>" in mathml_line("Δv'_n")


def test_a_line_can_be_broken_before_relations_and_between_words():
    """Words are text, brackets stay together, and a comma is not separated from what it follows."""
    assert mathml_line("so: broad phase with paddles") == "so: broad phase with paddles"
    parts = re.split(r"(?<=</math>) ", mathml_line("|p| = 9.12,   |p| - r = 8.32"))
    assert len(parts) == 3
    assert ",\u2003 <math>" in parts[1]
    assert "</math>\u2060," in parts[1]
