"""The level editor opened from the game; unsaved changes are written when the window is closed."""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from game.screens.app_state import AppState
from game.screens.base import Screen

if TYPE_CHECKING:
    from game.editor.window.screen import Editor


class OpenEditors:
    """The editors that were opened in a session, with their unsaved changes."""

    def __init__(self) -> None:
        """None yet."""
        self._editors: list[tuple[Editor, Path]] = []

    def opened(self, state: AppState, back: Callable[[], Screen | None], path: Path | None) -> Screen:
        """The editor with a level file, None for a new one among the player's own levels. back: where it leads back to.

        Raises BadInputError for a file that is no level, or cannot be written.
        """
        from game.editor.command import editing_session, file_to_edit  # noqa: PLC0415  # only where it is needed
        from game.editor.file_watch import WatchedFile  # noqa: PLC0415
        from game.editor.window.screen import Editor  # noqa: PLC0415

        path = file_to_edit(None) if path is None else path
        file = WatchedFile(path)
        editor = Editor(state, editing_session(file), file, back)
        self._editors.append((editor, path))
        return editor

    def keep_unsaved(self) -> None:
        """Write changes that were not saved into files beside the levels'."""
        from game.editor.command import keep_unsaved  # noqa: PLC0415  # only where it is needed

        for editor, path in self._editors:
            if not editor.discarded:
                keep_unsaved(editor.session, path)
