"""Cases that each change one thing, against the baseline that was measured with them."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

from measured_report.parts.claim import Claim, Outcome, at_least, greater
from measured_report.parts.section import Section
from measured_report.values.quantities import Quantity, Value, absent
from measured_report.values.results import Results, Row
from report.shared.arithmetic import (
    by_case,
    cases_html,
    difference,
    largest_size,
    noise_floor,
    other_value,
    resolved,
    share,
)


@dataclass(frozen=True)
class Variants:
    """The rows of one section, and what each changes in the slip."""

    baseline: Row
    rows: Sequence[Row]
    """Without the baseline."""
    difference: Mapping[str, Quantity]
    """Slip of a case less that of the baseline [mm]."""
    largest: Value
    """The largest of the differences, either way."""
    floor: Quantity
    """How far apart runs of one case are [mm]."""
    slips: Outcome
    """Whether the baseline slips at all, so that there is something to explain."""
    seen: Outcome
    """Whether a change that matters would be seen beside the noise."""
    numbers: dict[str, Quantity | str]
    """What the wording of a claim can name."""

    @property
    def all_rows(self) -> list[Row]:
        return [self.baseline, *self.rows]


class Differences(dict):
    """By case; that of a case without a row is absent."""

    def __missing__(self, case: str) -> Quantity:
        return absent("mm", f"there is no single row of case {case}")


def variant_section(results: Results, variants: Variants, *claims: Claim) -> Section:
    """Make the section of variants: their table, whether one is the cause, and more claims."""
    bound = results.chosen("cause_bound", "a cause would change the slip by more", 10.0, unit="%")
    cause = is_small(results, "cause", variants.largest, bound, variants.baseline.slip_mm, variants.floor)
    changes = [variants.difference[row.case] for row in variants.rows]
    limit = results.derived["cause_limit"]
    readings = [reading(change, variants.floor, limit) for change in changes]
    columns = {"slip": "slip_mm", "change": ["", *changes], "reading": ["as shipped", *readings]}
    table = by_case(variants.all_rows, columns)
    return Section(tables={"cases": table}, claims=[Claim("not_the_cause", cause, variants.numbers), *claims])


def reading(change: Quantity, floor: Quantity, limit: Quantity) -> str:
    """Say what a change of slip is, beside the noise and what a cause would change."""
    if None in (change.value, floor.value, limit.value):
        return ""
    if abs(change.number) <= max(floor.number, change.noise or 0.0):
        return "no difference"
    if abs(change.number) < limit.number:
        return "too little for a cause"
    return "slips less" if change.number < 0 else "slips farther"


def variants_of(results: Results, baseline: str, apart: Collection[str] = ()) -> Variants:
    """Compare every row of the section, but for the cases ``apart``, with the row of the case ``baseline``."""
    reference, rows = results.row[baseline], [row for row in results.rows if row.case not in (baseline, *apart)]
    found = Differences()
    for row in rows:
        formula = f"slip of {row.case} less that of {reference.case}"
        found[row.case] = difference(results, f"{row.case}_difference", formula, row.slip_mm, reference.slip_mm)
    formula = "largest difference in slip from the baseline, either way"
    largest = largest_size(results, "largest_difference", formula, found.values(), unit="mm")
    formula = "largest difference in slip from the baseline, of the baseline's slip"
    of_slip = share(results, "largest_share", formula, largest, reference.slip_mm)
    farthest = sorted(rows, key=lambda row: -abs(found[row.case].value or 0.0))[:1]
    floor = noise_floor(results, "slip_floor")
    slips = at_least(reference.slip_mm, other_value(results, "reproduction", "slip_bound", unit="mm"))
    formula = "noise of the slip, of the baseline's slip"
    seen = resolved(share(results, "floor_share", formula, floor, reference.slip_mm), 5.0, why="no change to speak of")
    numbers: dict[str, Quantity | str] = {
        "largest": largest,
        "share": of_slip,
        "most": cases_html(farthest),
        "baseline": reference.slip_mm,
        "floor": floor,
    }
    return Variants(reference, rows, found, largest, floor, slips, seen, numbers)


def is_small(results: Results, name: str, change: Quantity, bound: Value, slip: Quantity, noise: Quantity) -> Outcome:
    """Tell whether a change of slip [mm] is less than ``bound`` percent of a slip, by more than the noise; more is the
    opposite."""
    formula = f"{bound.written} % of the slip, signs left out"
    limit = results.value(f"{name}_limit", formula, lambda a, b: a / 100 * abs(b), bound, slip, unit="mm")
    return greater(limit, change, noise=noise)
