"""The ways to leave something out, as their rows say."""

from collections.abc import Mapping

from measured_report.values.results import Row

REFERENCE, ALL = "untrimmed", "without-all"
Timed = Mapping[tuple[str, str, int], Row]
"""Rows by device, case and number of worlds."""
Runs = Mapping[tuple[str, str], Row]
"""A row of each device and case: the run to the end is the same in those of all numbers of worlds."""


def is_identical(row: Row) -> bool:
    """Whether a run's trajectory is the reference's to the last bit."""
    return row.differing_frame_count.value == 0


def reference_of(runs: Runs, device: str) -> Row | None:
    """Find what slip and trajectory are compared with: the untrimmed scene, or the first that was run to the end."""
    ran = (row for (of_device, _), row in runs.items() if of_device == device and row.slip_mm.value is not None)
    return next(ran, None)
