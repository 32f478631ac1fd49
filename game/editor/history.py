"""Undo and redo: the documents before and after the one that is edited."""

from typing import NamedTuple

from game.editor.document import Document, Path

_LONGEST = 500
"""Changes that can be undone."""


class EditHistory(NamedTuple):
    """The edited document, with the documents that undo and redo return to.

    past, future: the nearest ones last. stepped: path of the number that the last change stepped; None after any other change.
    """

    present: Document
    past: tuple[Document, ...] = ()
    future: tuple[Document, ...] = ()
    stepped: Path | None = None

    def changed(self, document: Document, stepped: Path | None = None) -> "EditHistory":
        """The history after a change; if the text stays the same, so does the history.

        stepped: path of the number that is stepped. Steps of the same number in a row are undone together.
        """
        if document.text == self.present.text:
            return self
        if stepped is None or stepped != self.stepped or not self.past:
            return EditHistory(document, (*self.past, self.present)[-_LONGEST:], (), stepped)
        if document.level == self.past[-1].level:
            return EditHistory(self.past[-1], self.past[:-1])
        return EditHistory(document, self.past, (), stepped)

    def undone(self) -> "EditHistory":
        """The history one change back; itself where there is none."""
        if not self.past:
            return self
        return EditHistory(self.past[-1], self.past[:-1], (*self.future, self.present))

    def redone(self) -> "EditHistory":
        """The history one undone change forth; itself where there is none."""
        if not self.future:
            return self
        return EditHistory(self.future[-1], (*self.past, self.present), self.future[:-1])
