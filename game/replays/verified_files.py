"""Replay files proved one after the other, with a line for each."""

from pathlib import Path

from game.headless import result_line
from game.replays.file import load
from game.replays.verify import verified
from game.system.errors import CheckFailedError
from game.system.output import print_error, print_line
from game.system.wording import quoted_path


def verify_files(files: list[Path]) -> None:
    """Verify every file; CheckFailedError with the first divergence, after all have been looked at."""
    failed: list[str] = []
    for file in files:
        verdict = verified(load(file))
        if verdict.divergence is None:
            print_line(f"verified {file}: {result_line(verdict.game)}")
        else:
            failed.append(f"{quoted_path(file)}: {verdict.divergence}")
            print_error(f"polar-breakout: {failed[-1]}")
    if failed:
        raise CheckFailedError(f"{len(failed)} of {len(files)} replays diverged")
