"""History: a number or a claim over all editions, with the noise, and whether each is better or worse than the last."""

from collections.abc import Mapping
from typing import Any

from report.bisect import Question
from report.deriving.releases import Headline
from report.editions import Edition
from report.noise import NOISE, is_beyond, noise_floors, verdict
from report.sections.upgrade.tables import HEADLINES


def history(editions: Mapping[str, Edition], question: Question) -> str:
    """A line for each edition that answers, oldest first."""
    column = question.text.rpartition(".")[2]
    records = [edition.chapters[NOISE].results.record for edition in editions.values() if NOISE in edition.chapters]
    floor = noise_floors(records).get(column)
    lines = [(question.text, "", "")]
    before: Any = None
    for release, edition in editions.items():
        answer: Any = question.answer(edition)
        if answer is None:
            continue
        if isinstance(answer, str):
            lines.append((release, answer, "flipped" if before not in (None, answer) else ""))
        else:
            noise = floor.at(answer, answer if before is None else before) if floor else None
            moved = before is not None and is_beyond(noise or 0.0, before, answer)
            mark = (verdict(column, before, answer) or "moved") if moved else ""
            lines.append((release, f"{answer:.4g}" + (f" ± {noise:.2g}" if noise is not None else ""), mark))
        before = answer
    widths = [max(len(line[place]) for line in lines[1:] or lines) for place in range(3)]
    return "\n".join([lines[0][0], *("  ".join(map(str.ljust, line, widths)).rstrip() for line in lines[1:])])


def headline_questions() -> list[Question]:
    """The numbers that say most, in the order of the page."""
    return [Question(_place(headline), is_claim=False) for headline in HEADLINES]


def _place(headline: Headline) -> str:
    return f"{headline.section}.{headline.case}.{headline.column}"
