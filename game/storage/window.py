"""Where the window was, and how large, so that the next one opens there."""

from typing import Annotated

import msgspec
from msgspec import Meta

VERSION = 1

_Pixel = Annotated[int, Meta(ge=-100_000, le=100_000)]
_Length = Annotated[int, Meta(ge=0, le=100_000)]


class WindowBox(msgspec.Struct, frozen=True):
    """A window that was not in full screen, in the desktop's units. width 0: none was kept."""

    version: int = VERSION
    left: _Pixel = 0
    top: _Pixel = 0
    width: _Length = 0
    height: _Length = 0
