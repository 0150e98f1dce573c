"""Verifying the headline: it is measured again and compared with what is tracked; do they agree within the noise?"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from measured_report.files.errors import ReportError
from measured_report.pages.editions import Edition
from measured_report.parts.claim import within
from measured_report.values.quantities import Quantity, absent

PROGRAM = "experiments.simulation.headline"
"""What measures it."""
SECTION = "reproduction"
SUFFIXES = ("", "-warp-cpu")
"""Of names of the tracked cases, by where the same engine ran: on the device of the record, and on its CPU."""
WORDS = {"holds": "agrees", "cannot tell": "near the bound: measure again", "the opposite": "differs"}


@dataclass(frozen=True)
class Repeat:
    """A case measured here, beside what is tracked of it."""

    case: str
    here: Quantity
    tracked: Quantity
    processor: str
    """What the tracked one was measured on."""
    bound: Quantity
    is_same_processor: bool
    """Whether that is the processor here, for which the noise is known."""

    @property
    def difference(self) -> Quantity:
        reasons = [each.reason for each in (self.here, self.tracked) if each.value is None]
        return absent("mm", reasons[0]) if reasons else Quantity(abs(self.here.value - self.tracked.value), "mm", "")

    @property
    def agrees(self) -> bool:
        """Tell whether nothing says that they differ; a run that fails where the tracked one did not differs."""
        return within(self.difference, self.bound).name != "fails" and self.difference.value is not None

    @property
    def text(self) -> str:
        lost, outcome = self.difference.reason, within(self.difference, self.bound)
        said = f"differs ({lost})" if lost else WORDS[outcome.said]
        kind = "noise" if self.is_same_processor else "devices"
        cells = (self.case, _exact(self.here), _exact(self.tracked), _exact(self.difference), f"{self.bound} ({kind})")
        return "{:12}{:>12}{:>14}{:>14}   {:22}".format(*cells) + f"{said}; on {self.processor}"


def verify(edition: Edition, found: Mapping[str, Any]) -> tuple[str, bool]:
    """Return what was found, in lines, and whether it agrees with what is tracked."""
    repeats = repeats_of(edition, found)
    return "\n".join(_lines(edition, found, repeats)), all(repeat.agrees for repeat in repeats)


def repeats_of(edition: Edition, found: Mapping[str, Any]) -> list[Repeat]:
    """Pair what PROGRAM measured with each tracked run of the same cases on the same engine, of the same release."""
    if SECTION not in edition.chapters or "noise" not in edition.chapters:
        raise ReportError(f"newton {edition.project.release} has no results of {SECTION} and noise to compare with")
    results, noise = edition.chapters[SECTION].results, edition.chapters["noise"].results
    here = found["machine"]["gpu" if found["machine"]["device"] == "cuda" else "cpu"]
    repeats = []
    for row in found["rows"]:
        for suffix in SUFFIXES:
            if tracked := results.row[row["case"] + suffix]:
                processor = results.record.machine["cpu"] if suffix else results.record.processor
                is_same = here == processor == noise.record.processor
                bound = noise.derived["slip_floor"] if is_same else results.derived["engine_bound"]
                slip = Quantity(row["slip_mm"], "mm", "", row.get("slip_mm_reason", ""))
                repeats.append(Repeat(row["case"], slip, tracked.slip_mm, processor, bound, is_same))
    return repeats


def _lines(edition: Edition, found: Mapping[str, Any], repeats: Sequence[Repeat]) -> Iterator[str]:
    machine, chapter = found["machine"]["gpu"] or found["machine"]["cpu"], edition.chapters[SECTION]
    where = f"newton {edition.project.release} on {machine}"
    yield f"{where}: measured in {found['measure_s']:.0f} s, after {found['compile_s']:.0f} s for kernels\n"
    yield "{:12}{:>12}{:>14}{:>14}   {:22}".format("slip", "here", "tracked", "difference", "bound").rstrip()
    yield from (repeat.text for repeat in repeats)
    yield "\nnoise: of runs on the same processor; devices: chosen for others, whose noise is not known"
    if chapter.state.notes:
        yield f"the tracked ones are stale: {chapter.state.words}"


def _exact(quantity: Quantity) -> str:
    """Write a number with more digits than a page prints: anyone sees whether two are the same to the last."""
    return str(quantity) if quantity.value is None else f"{quantity.value:.6f} mm"
