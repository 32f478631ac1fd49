"""Which file the editor opens, and what becomes of changes that were not saved."""

from pathlib import Path

from game.editor.document import opened
from game.editor.file_watch import WatchedFile
from game.editor.session import EditorSession, begun
from game.levels.own import own_levels_folder
from game.system.errors import BadInputError
from game.system.files import check_target, free_path, write_text
from game.system.output import print_error
from game.system.wording import quoted_path

NEW = """name = "My level"
description = ""
ground_radius = 10.0

[ball]
radius = 0.25
speed = 8.0

[paddles]
radius = 9.2
half_width = 0.2
half_angle = 24.0
top_speed = 46.0
acceleration = 600.0

[[rings]]
radius = 4.0
half_width = 0.3
half_angle = 13.0
count = 12
layers = 1
"""
"""A file that does not exist yet begins with this."""


def file_to_edit(name: Path | None) -> Path:
    """The path of a level file: as given, or in the folder of own levels where only a name is. None: a new file there.

    Raises BadInputError for a path that cannot be written.
    """
    if name is not None and (len(name.parts) > 1 or name.exists() or name.suffix.casefold() == ".toml"):
        check_target(name, "edit", ".toml")
        return name
    folder = own_levels_folder()
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise BadInputError(f"{quoted_path(folder)}: cannot be made; {error.strerror or error}") from None
    path = free_path(folder, "my-level.toml") if name is None else folder / f"{name.name}.toml"
    check_target(path, "edit", ".toml")
    return path


def editing_session(file: WatchedFile) -> EditorSession:
    """The editor's session with a file, or with a new level where there is none; BadInputError as that of `opened`."""
    if not file.path.exists():
        return begun(NEW, "")
    text = file.read()
    try:
        opened(text)
    except BadInputError as error:
        raise BadInputError(f"{quoted_path(file.path)}: {str(error).removeprefix('level: ')}") from None
    return begun(text, text)


def keep_unsaved(session: EditorSession, path: Path) -> None:
    """Write changes that were not saved into a file beside the level's, and say so; the window may be closed at any time."""
    if not session.changed or session.document.text == NEW:
        return
    beside = free_path(path.parent, f"{path.stem}.unsaved.toml")
    try:
        write_text(beside, session.document.text)
    except BadInputError as error:
        print_error(f"polar-breakout: changes not saved: {error}")
        return
    print_error(f"polar-breakout: changes that were not saved are in {quoted_path(beside)}")
