"""The ways to leave something out, as their rows say."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from measured_report.values.results import Row

REFERENCE, ALL = "untrimmed", "without-all"


def is_identical(row: Row) -> bool:
    """Whether a run's trajectory is the reference's to the last bit."""
    return row.differing_frame_count.value == 0


def was_compared(row: Row) -> bool:
    return "differing_frame_count" in row


@dataclass(frozen=True)
class Variant:
    """One way to leave something out, on one device."""

    device: str
    case: str
    rows: Sequence[Row]
    """One for each number of worlds."""

    @property
    def name(self) -> str:
        return f"{self.device}_{self.case.replace('-', '_')}"

    @property
    def run(self) -> Row:
        """The run to the end, which is the same in the rows of all numbers of worlds."""
        return self.rows[0]

    def at(self, worlds: int) -> Row | None:
        return next((row for row in self.rows if row.worlds.value == worlds), None)


Variants = Mapping[tuple[str, str], Variant]
"""By device and case."""


def row_of(variants: Variants, device: str, case: str, worlds: int = 1) -> Row | None:
    variant = variants.get((device, case))
    return variant.at(worlds) if variant else None


def reference_of(variants: Variants, device: str) -> Variant | None:
    """Find what slip and trajectory are compared with: the untrimmed scene, or the first that was run to the end."""
    of_device = (variant for variant in variants.values() if variant.device == device)
    return next((variant for variant in of_device if variant.run.slip_mm.value is not None), None)
