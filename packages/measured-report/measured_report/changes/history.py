"""History: numbers and claims over all editions, with the noise, and what each does against the edition before."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from measured_report.changes.question import Answer, Question
from measured_report.changes.releases import Turn, turns
from measured_report.claims.claims import NEAR_NOISE
from measured_report.deriving.chapters import Chapters, Releases
from measured_report.records.columns import column_of
from measured_report.values.noise import NOISE, Floor, is_beyond, noisiest, verdict

FLIPPED, MOVED = "flipped", "moved"


@dataclass(frozen=True)
class Point:
    """What one edition answers."""

    release: str
    answer: Answer
    noise: float | None
    """How far apart two runs of it come out; None where nobody knows, or where it is no number."""
    said: str
    """In words."""
    mark: str = ""
    """What it is against the answer before: better, worse, moved or flipped; empty where it is the same, or first."""

    @property
    def ends(self) -> tuple[float, float]:
        """The number less its noise, and with it."""
        off = self.noise or 0.0
        return float(self.answer) - off, float(self.answer) + off


def points(releases: Releases, question: Question) -> list[Point]:
    """The editions that answer, oldest first."""
    column = question.text.rpartition(".")[2]
    noisiest = _floors(releases).get(column)
    found: list[Point] = []
    for release, chapters in releases.items():
        answer = question.answer(chapters)
        if answer is not None:
            floor = _floors({release: chapters}).get(column, noisiest)
            noise = (
                None if isinstance(answer, str) or not floor else max(floor.at(answer), column_of(column).resolution)
            )
            point = Point(release, answer, noise, _said(question, chapters, answer, noise))
            found.append(replace(point, mark=_mark(column, found[-1], point)) if found else point)
    return found


def _floors(releases: Releases) -> dict[str, Floor]:
    """By column, of the edition that is noisiest."""
    return noisiest(chapters[NOISE].results.floors for chapters in releases.values() if NOISE in chapters)


def _mark(column: str, before: Point, after: Point) -> str:
    if isinstance(before.answer, str) or isinstance(after.answer, str):
        return FLIPPED if before.answer != after.answer else ""
    noise = NEAR_NOISE * max(before.noise or 0.0, after.noise or 0.0)
    is_moved = is_beyond(noise, before.answer, after.answer)
    return (verdict(column, before.answer, after.answer) or MOVED) if is_moved else ""


@dataclass(frozen=True)
class Flip:
    """A claim that one edition upholds and another doesn't."""

    turn: Turn

    @property
    def name(self) -> str:
        """As CLAIM= says it."""
        return f"{self.turn.section}.{self.turn.name}"

    @property
    def said(self) -> dict[str, str]:
        """What each edition says to it, by label; those whose answer can't be compared are not there."""
        return {release: claim.outcome.said for names, claim in self.turn.said for release in names}


def flips(releases: Releases, shown: str) -> list[Flip]:
    """All of them, as the edition ``shown`` words them."""
    return [Flip(turn) for turn in turns(releases, shown) if turn.is_decided]


def history(releases: Releases, question: Question) -> str:
    """A line for each edition that answers, oldest first."""
    lines = [(point.release, point.said, point.mark) for point in points(releases, question)]
    return "\n".join([question.text, *(_aligned(lines) or ["no edition can tell"])])


def _said(question: Question, chapters: Chapters, answer: Answer, noise: float | None) -> str:
    if question.is_claim:
        return question.claim(chapters).outcome.said
    return f"{answer:.4g}" + (f" ± {noise:.2g}" if noise is not None else "")


def flip_history(releases: Releases, shown: str) -> str:
    """A line for each claim that flips, with what each edition says to it."""
    lines = [(flip.name, *(flip.said.get(release, "") for release in releases)) for flip in flips(releases, shown)]
    return "\n".join(["claims that flip", *_aligned([("", *releases), *lines])]) if lines else "no claim flips"


def _aligned(lines: Sequence[Sequence[str]]) -> list[str]:
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
    return ["  ".join(map(str.ljust, line, widths)).rstrip() for line in lines]
