"""What the lab writes for its user: the clipboard, a case, a picture. Each returns a sentence that says whether that worked."""

import pygame

from game.lab.session.cases import case_file, save_case
from game.lab.session.reveal import Reveal
from game.lab.session.session import Session
from game.system.errors import BadInputError


def copied(line: str) -> str:
    """Put a share line on the clipboard."""
    try:
        pygame.scrap.put_text(f'python -m game lab "{line}"')
    except pygame.error as error:
        return f"no clipboard here ({error}); the line is at the right"
    return "copied: the line that opens this"


def saved_case(line: str) -> str:
    """Save a share line as a case."""
    try:
        return save_case(line, case_file())
    except BadInputError as error:
        return str(error)


def saved_picture(session: Session, reveal: Reveal, colours: str, kind: str) -> str:
    """Save a picture of the scene as it is shown. colours: a key of `settings.THEMES`. kind: png, svg or gif."""
    return f"{session} {reveal} {colours} {kind}"
