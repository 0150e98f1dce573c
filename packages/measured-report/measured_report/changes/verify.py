"""The headline measured again, beside what is tracked of it: do they agree to within the noise?"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from measured_report import ReportError
from measured_report.claims.claims import Outcome, within
from measured_report.deriving.editions import Edition
from measured_report.values.quantities import Quantity, absent

SECTION = "reproduction"
PLACES = ("", "-warp-cpu")
"""How names of the tracked cases end, by where the same engine ran: on the device of the record, and on its CPU."""
WORDS = {"holds": "agrees", "cannot tell": "near the bound: measure again", "the opposite": "differs"}


@dataclass(frozen=True)
class Comparison:
    """One case, measured here and tracked."""

    case: str
    here: Quantity
    tracked: Quantity
    place: str
    """The processor that the tracked one was measured on."""
    bound: Quantity
    is_same_place: bool
    """Whether that is the processor here, for which the noise is known."""

    @property
    def difference(self) -> Quantity:
        """Its size."""
        reasons = [each.reason for each in (self.here, self.tracked) if each.value is None]
        return absent("mm", reasons[0]) if reasons else Quantity(abs(self.here.value - self.tracked.value), "mm", "")

    @property
    def outcome(self) -> Outcome:
        return within(self.difference, self.bound)

    @property
    def agrees(self) -> bool:
        """Whether nothing says that they differ; a run that fails where the tracked one did not differs."""
        return self.outcome.name != "fails" and self.difference.value is not None

    @property
    def text(self) -> str:
        said = WORDS[self.outcome.said] if self.difference.value is not None else f"differs ({self.difference.reason})"
        kind = "noise" if self.is_same_place else "devices"
        cells = (self.case, _exact(self.here), _exact(self.tracked), _exact(self.difference), f"{self.bound} ({kind})")
        return "{:12}{:>12}{:>14}{:>14}   {:22}".format(*cells) + f"{said}; on {self.place}"


def compared(edition: Edition, found: Mapping[str, Any]) -> list[Comparison]:
    """What was measured, beside each tracked run of the same cases on the same engine.

    Args:
        edition: The tracked results of the same release.
        found: What ``experiments.simulation.headline`` writes.

    Raises:
        ReportError: The release has no such results.
    """
    if SECTION not in edition.chapters or "noise" not in edition.chapters:
        raise ReportError(f"newton {edition.project.release} has no results of {SECTION} and noise to compare with")
    results, noise = edition.chapters[SECTION].results, edition.chapters["noise"].results
    here = found["machine"][("gpu" if found["machine"]["device"] == "cuda" else "cpu")]
    comparisons = []
    for row in found["rows"]:
        for ending in PLACES:
            tracked = results.row[row["case"] + ending]
            if tracked:
                place = results.record.machine["cpu"] if ending else results.record.processor
                is_same = here == place == noise.record.processor
                bound = noise.derived["slip_floor"] if is_same else results.derived["engine_bound"]
                slip = Quantity(row["slip_mm"], "mm", "", row.get("slip_mm_reason", ""))
                comparisons.append(Comparison(row["case"], slip, tracked.slip_mm, place, bound, is_same))
    return comparisons


def text_of(edition: Edition, found: Mapping[str, Any], comparisons: Sequence[Comparison]) -> str:
    """What was found, in lines."""
    return "\n".join(_lines(edition, found, comparisons))


def _lines(edition: Edition, found: Mapping[str, Any], comparisons: Sequence[Comparison]) -> Iterator[str]:
    machine, chapter = found["machine"], edition.chapters[SECTION]
    values = chapter.results.derived
    where = f"newton {edition.project.release} on {machine['gpu'] or machine['cpu']}"
    yield f"{where}: measured in {found['measure_s']:.0f} s, after {found['compile_s']:.0f} s for kernels\n"
    yield "{:12}{:>12}{:>14}{:>14}   {:22}".format("slip", "here", "tracked", "difference", "bound").rstrip()
    yield from (comparison.text for comparison in comparisons)
    shipped, stiff = (row["slip_mm"] for row in found["rows"])
    if shipped and stiff:
        yield f"\nwith stiff pads the slip is {shipped / stiff:.1f} times less; tracked: {values['stiff_gain']}"
    if any(comparison.is_same_place for comparison in comparisons):
        noise = edition.chapters["noise"].results
        runs = f"{len(noise.rows)} runs on this processor"
        yield f"noise: {noise.derived['slip_floor']}, by {runs} (noise.slip_floor)"
    if not all(comparison.is_same_place for comparison in comparisons):
        yield f"devices: {values['engine_bound']}, chosen for other devices, whose noise is not known"
        yield f"  (reproduction.engine_bound); the tracked ones are {values['engine_difference']} apart"
    if chapter.state.notes:
        yield f"the tracked ones are stale: {chapter.state.words}"


def _exact(quantity: Quantity) -> str:
    """With more digits than a page prints, so that anyone sees whether two are the same to the last."""
    return str(quantity) if quantity.value is None else f"{quantity.value:.6f} mm"
