"""The runs of section stiffness, sorted."""

from collections.abc import Sequence
from dataclasses import dataclass

from measured_report.parts.claim import Outcome, at_least
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results, Row
from report.shared.arithmetic import other_cell, other_value

SHIPPED, FIX = "pad-ke-2.5e3", "pad-ke-2.5e5"


@dataclass(frozen=True)
class Runs:
    """The runs, sorted by what changed and by how they ended."""

    named: Sequence[Row]
    """Those that are no part of the fine sweep."""
    ke_alone: Sequence[Row]
    """kd at its import default."""
    together: Sequence[Row]
    """ke and kd raised together."""

    @property
    def held(self) -> list[Row]:
        """Return those that keep the cube; the scene as shipped is in both series and counts once."""
        return list({row.case: row for row in (*self.ke_alone, *self.together) if is_held(row)}.values())


def is_held(row: Row) -> bool:
    """Tell whether a run keeps the cube. One that comes to its shake too late to go through a cycle of it has shown
    nothing: a hand that trembles takes seconds longer to close and to lift."""
    return row.slip_mm.value is not None and not row.dropped and row.cycle_count.value is not None


def has_slip(results: Results) -> Outcome:
    """Tell whether there is a slip as shipped to bring down, by what counts as one in the first section."""
    return at_least(results.row[SHIPPED].slip_mm, other_value(results, "reproduction", "slip_bound", unit="mm"))


def drift_without_slide(results: Results) -> Quantity:
    """Return the drift of a shaken cube that does not slide: with the left-out acceleration put back into the contact
    rows."""
    return other_cell(results, "contacts", "as-shipped-term-restored", "drift_mm_s", unit="mm/s")
