"""A rule that a level breaks, as a value: the command line reads it in English, the editor in the player's language."""

from typing import NamedTuple

from game.language import tr


class BrokenRule(NamedTuple):
    """Where a level breaks which rule.

    key: of the file, such as "rings[0].radius"; "" for the whole level.
    rule: English, with the names of values in braces. It is marked by `tr_noop`, so that it is translated.
    values: what the names stand for.
    """

    key: str
    rule: str
    values: dict[str, float | str] = {}  # noqa: RUF012  # nobody changes it

    def __str__(self) -> str:
        """In English, on one line, with the key."""
        return self._with_key(self.rule)

    @property
    def translated(self) -> str:
        """The same in the player's language; the key stays as it is in the file."""
        return self._with_key(tr(self.rule))

    def _with_key(self, rule: str) -> str:
        """A rule with its values, after the key."""
        text = rule.format(**self.values)
        return f"{self.key}: {text}" if self.key else text
