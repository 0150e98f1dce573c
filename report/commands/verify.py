"""Measure the headline on this machine and compare it with the tracked one, without storing it."""

import argparse
import json
from collections.abc import Iterator, Mapping
from itertools import product
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from measured_report.commands.options import refuse_unmeasured, shared
from measured_report.editions.environment import python_of
from measured_report.editions.project import Project
from measured_report.editions.status import expected_packages
from measured_report.files.errors import ReportError
from measured_report.findings.editions import Edition, derive_edition
from measured_report.measuring.machine import measuring_device
from measured_report.measuring.measure import running
from measured_report.parts.claim import at_most
from measured_report.values.quantities import Quantity
from measured_report.values.results import Row

OPTIONS = shared("edition", "device")
PROGRAM = "experiments.simulation.headline"  # the program that measures the headline
SECTION = "reproduction"
# Suffixes of tracked cases: measured on the device of the record, and on its CPU.
SUFFIXES = ("", "-warp-cpu")
LINE = "{:12}{:>12}{:>14}{:>14}   {:10}{}"  # format of a row in the printed table
WORDS = {
    "holds": "agrees",
    "cannot tell": "cannot tell: measure again",
    "fails": "differs",
}


def run(project: Project, arguments: argparse.Namespace) -> int:
    """Print both results and whether they agree. Return 1 if they differ."""
    refuse_unmeasured(project, arguments.release.spec)
    accelerators = project.report.accelerator.accelerators
    device = measuring_device(
        arguments.device or ("cuda" if accelerators() else "cpu"),
        project.profile,
    )
    python = python_of(arguments.release, expected_packages(project), project.root)
    with TemporaryDirectory() as folder:
        path = Path(folder) / "headline.json"
        with running(project, python, PROGRAM, device, "--json", str(path)):
            edition = derive_edition(project)
        measured = json.loads(path.read_text(encoding="utf-8"))
    text, agrees = verify(edition, measured)
    print(text)
    return int(not agrees)


def verify(edition: Edition, measured: Mapping[str, Any]) -> tuple[str, bool]:
    """Return the text of the comparison, and whether all runs agree with the tracked ones."""
    comparisons = list(comparisons_of(edition, measured))
    machine = measured["machine"]["gpu"] or measured["machine"]["cpu"]
    lines = [
        f"newton {edition.project.release} on {machine}: measured in"
        f" {measured['measure_s']:.0f} s, after {measured['compile_s']:.0f} s for"
        " kernels\n",
        LINE.format("slip", "here", "tracked", "difference", "bound", "").rstrip(),
        *(line for line, _ in comparisons),
        "\nbound: a larger difference is more than noise and rounding",
    ]
    state = edition.chapters[SECTION].state
    if state.notes:
        lines.append(f"the tracked results are stale: {state.words}")
    return "\n".join(lines), all(agrees for _, agrees in comparisons)


def comparisons_of(
    edition: Edition, measured: Mapping[str, Any]
) -> Iterator[tuple[str, bool]]:
    """Yield a line for each measured run, with the tracked run of its case and whether
    both agree.
    """
    release = edition.project.release
    chapters = edition.chapters
    if SECTION not in chapters:
        raise ReportError(
            f"newton {release} has no results of {SECTION} to compare with:"
            f" make rerun SECTION={SECTION} measures them"
        )
    results = chapters[SECTION].results
    bound = results.derived["engine_bound"]
    for row, suffix in product(measured["rows"], SUFFIXES):
        tracked = results.row[row["case"] + suffix]
        if not tracked:
            continue
        record = results.record
        processor = record.machine["cpu"] if suffix else record.processor
        slip = Quantity(
            row["slip_mm"],
            "mm",
            "",
            row.get("slip_mm_reason", ""),
            noise=_noise_of_one(tracked),
        )
        difference = abs(slip - tracked.slip_mm)
        outcome = at_most(difference, bound)
        agrees = outcome.name != "fails"
        words = WORDS[outcome.answer]
        if difference.reason:
            # Two runs without a slip agree if they lack it for the same reason.
            lack, tracked_lack = (
                cells.get("slip_mm_reason", "") for cells in (row, tracked.plain)
            )
            agrees = slip.value == tracked.slip_mm.value and lack == tracked_lack
            words = f"{'agrees' if agrees else 'differs'} ({difference.reason})"
        # These are more digits than on a page, so that equal results can be recognized.
        cells = [
            str(number) if number.value is None else f"{number.value:.6f} mm"
            for number in (slip, tracked.slip_mm, difference)
        ]
        words = f"{words}; on {processor}"
        yield LINE.format(row["case"], *cells, f"{bound}", words), agrees


def _noise_of_one(tracked: Row) -> float:
    """Return the noise of the slip in one further run of a tracked case [mm]."""
    estimate = tracked.estimate("slip_mm")
    return estimate._replace(count=1).noise if estimate else 0.0
