"""The high scores as lines, and whether each is proved by its replay."""

from game.storage.scores import objection
from game.storage.storage import Storage
from game.system.errors import CheckFailedError
from game.system.output import print_error, print_line
from game.system.wording import quoted


def print_scores(storage: Storage, *, verify: bool) -> None:
    """Print the scores, best first. verify: play every one's replay again; CheckFailedError where one is not proved."""
    for line in storage.problems:
        print_error(f"polar-breakout: {line}")
    failed, scores = 0, sorted(storage.scores.value.entries, key=lambda score: (score.difficulty, -score.score))
    for score in scores:
        line = f"{score.difficulty:6} {score.score:>9,}  {score.name or '-':16}  {score.date:10}  {score.last}"
        if not verify:
            print_line(line)
            continue
        why = "no folder" if storage.games.folder is None else objection(score, storage.games.folder)
        failed += why is not None
        print_line(f"{line}  {'verified' if why is None else quoted(f'NOT VERIFIED: {why}', 200)}")
    if failed:
        raise CheckFailedError(f"{failed} of {len(scores)} scores could not be verified")
