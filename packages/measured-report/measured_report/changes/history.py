"""History: a number or a claim over all editions, with the noise, and what each does against the edition before."""

from dataclasses import dataclass

from measured_report.changes.flips import flips
from measured_report.changes.moves import Move
from measured_report.changes.query import Answer, Query
from measured_report.editions.status import aligned
from measured_report.pages.editions import Chapters, Releases
from measured_report.records.columns import column_of
from measured_report.values.noise import NOISE, noisiest
from measured_report.values.quantities import Quantity


@dataclass(frozen=True)
class Point:
    """Hold an answer of one edition."""

    release: str
    answer: Answer
    noise: float | None
    """Difference between two runs; None where nobody knows, or where it is no number."""
    said: str
    mark: str = ""
    """Against the answer before: better, worse, moved or flipped; empty where it is the same, or first."""


def points(releases: Releases, query: Query) -> list[Point]:
    """Return what the editions answer that can, oldest first."""
    column = query.column
    widest = noisiest(chapters[NOISE].results.floors for chapters in releases.values() if NOISE in chapters)
    found: list[Point] = []
    for release, chapters in releases.items():
        answer, claim = query.answer(chapters), query.claim(chapters)
        if claim and answer is not None:
            mark = "flipped" if found and found[-1].answer != answer else ""
            found.append(Point(release, answer, None, claim.outcome.said, mark))
        elif answer is not None:
            noise, number = getattr(query.quantity(chapters), "noise", None), float(answer)
            if noise is None and column in widest:  # this edition has not measured it
                noise = max(widest[column].at(number), column_of(column).resolution)
            least = max(noise or 0.0, found[-1].noise or 0.0) if found else 0.0
            mark = Move(column, found[-1].answer, answer, least).mark if found else ""
            found.append(Point(release, answer, noise, f"{answer:.4g}" + (f" ± {noise:.2g}" if noise else ""), mark))
    return found


def history(releases: Releases, query: Query) -> str:
    """Return a line for each edition that answers or says why it can't, oldest first."""
    found = {point.release: point for point in points(releases, query)}
    lines = [
        (release, found[release].said, found[release].mark) if release in found else (release, "cannot tell", why)
        for release, chapters in releases.items()
        if (why := _reason(query, chapters)) or release in found
    ]
    return "\n".join([query.text, aligned(lines) or "no edition can tell"])


def _reason(query: Query, chapters: Chapters) -> str:
    """Say why an edition that was asked has no answer; empty where it has one, or was not asked."""
    claim, number = query.claim(chapters), query.quantity(chapters)
    if claim:
        return claim.outcome.reason
    return number.reason if isinstance(number, Quantity) and number.source else ""


def flip_history(releases: Releases, shown: str) -> str:
    """Return a line for each claim that flips, with what each edition says to it; none where that can't compare."""
    lines = []
    for flip in (flip for flip in flips(releases, shown) if flip.is_decided):
        said = {release: claim.outcome.said for names, claim in flip.said for release in names}
        lines.append((flip.claim, *(said.get(release, "") for release in releases)))
    return "\n".join(["claims that flip", aligned([("", *releases), *lines])]) if lines else "no claim flips"
