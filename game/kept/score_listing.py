"""The high scores as lines, and whether each is proved by its replay."""

from game.kept.scores import objection
from game.kept.store import Kept
from game.system.errors import CheckFailedError
from game.system.output import say, tell
from game.system.wording import quoted


def tell_scores(kept: Kept, *, verify: bool) -> None:
    """Print the scores, best first. verify: play every one's replay again; CheckFailedError where one is not proved."""
    for line in kept.problems:
        say(f"polar-breakout: {line}")
    failed, scores = 0, sorted(kept.scores.value.entries, key=lambda score: (score.difficulty, -score.score))
    for score in scores:
        line = f"{score.difficulty:6} {score.score:>9,}  {score.name or '-':16}  {score.date:10}  {score.last}"
        if not verify:
            tell(line)
            continue
        why = "no folder" if kept.games.folder is None else objection(score, kept.games.folder)
        failed += why is not None
        tell(f"{line}  {'verified' if why is None else quoted(f'NOT VERIFIED: {why}', 200)}")
    if failed:
        raise CheckFailedError(f"{failed} of {len(scores)} scores could not be verified")
