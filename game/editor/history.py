"""Undo and redo: the documents before and after the one that is edited."""

from typing import NamedTuple

from game.editor.document import Document

_LONGEST = 500
"""Changes that can be undone."""


class EditHistory(NamedTuple):
    """The document being edited, with those that undo and redo lead to.

    past, future: the nearest of them last.
    """

    present: Document
    past: tuple[Document, ...] = ()
    future: tuple[Document, ...] = ()

    def changed(self, document: Document) -> "EditHistory":
        """The history after a change; one that changes no letter leaves it as it is."""
        if document.text == self.present.text:
            return self
        return EditHistory(document, (*self.past, self.present)[-_LONGEST:])

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
