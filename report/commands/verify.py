"""Measure the headline again here, and compare it with the tracked one; keep nothing."""

import argparse
from collections.abc import Iterator, Mapping
from itertools import product
from typing import Any

from measured_report.commands.options import refuse_unmeasured, shared
from measured_report.editions.project import Project
from measured_report.files.errors import ReportError
from measured_report.findings.editions import Edition, derive_edition
from measured_report.measuring.accelerator import accelerator
from measured_report.measuring.machine import measuring_device
from measured_report.measuring.measure import measure_headline
from measured_report.parts.claim import within
from measured_report.values.quantities import Quantity

OPTIONS = shared("edition", "device")
PROGRAM = "experiments.simulation.headline"  # what measures it
SECTION = "reproduction"
SUFFIXES = (
    "",
    "-warp-cpu",
)  # of tracked cases: on the device of the record, and on its CPU
WORDS = {
    "holds": "agrees",
    "cannot tell": "near the bound: measure again",
    "the opposite": "differs",
}


def run(project: Project, arguments: argparse.Namespace) -> int:
    """Print both and whether they agree within the noise; 1 when they differ."""
    refuse_unmeasured(project, arguments.release.asked)
    device = measuring_device(
        arguments.device or ("cuda" if accelerator().accelerators() else "cpu"),
        project.profile,
    )
    found = measure_headline(
        project, arguments.release, device, PROGRAM, lambda: derive_edition(project)
    )
    text, agrees = verify(*found)
    print(text)
    return int(not agrees)


def verify(edition: Edition, measured: Mapping[str, Any]) -> tuple[str, bool]:
    """Return what was found, in lines, and whether it agrees with what is tracked."""
    comparisons = list(repeats_of(edition, measured))
    machine, chapter = (
        measured["machine"]["gpu"] or measured["machine"]["cpu"],
        edition.chapters[SECTION],
    )
    where, seconds = (
        f"newton {edition.project.release} on {machine}",
        (measured["measure_s"], measured["compile_s"]),
    )
    lines = [
        "{}: measured in {:.0f} s, after {:.0f} s for kernels\n".format(where, *seconds)
    ]
    lines += [
        "{:12}{:>12}{:>14}{:>14}   {:22}".format(
            "slip", "here", "tracked", "difference", "bound"
        ).rstrip()
    ]
    lines += [line for line, _ in comparisons]
    lines += [
        "\nnoise: of runs on the same processor; devices: chosen for others, whose noise is not known"
    ]
    if chapter.state.notes:
        lines += [f"the tracked ones are stale: {chapter.state.words}"]
    return "\n".join(lines), all(agrees for _, agrees in comparisons)


def repeats_of(
    edition: Edition, measured: Mapping[str, Any]
) -> Iterator[tuple[str, bool]]:
    """Compare what PROGRAM measured with each tracked run of the same cases on the same engine, of the same release."""
    if SECTION not in edition.chapters or "noise" not in edition.chapters:
        raise ReportError(
            f"newton {edition.project.release} has no results of {SECTION} and noise to compare with"
        )
    results, noise = (
        edition.chapters[SECTION].results,
        edition.chapters["noise"].results,
    )
    here = measured["machine"][
        "gpu" if measured["machine"]["device"] == "cuda" else "cpu"
    ]
    for row, suffix in product(measured["rows"], SUFFIXES):
        if tracked := results.row[row["case"] + suffix]:
            processor = (
                results.record.machine["cpu"] if suffix else results.record.processor
            )
            is_same = (
                here == processor == noise.record.processor
            )  # for which the noise is known
            bound = (
                noise.derived["slip_floor"]
                if is_same
                else results.derived["engine_bound"]
            )
            slip = Quantity(row["slip_mm"], "mm", "", row.get("slip_mm_reason", ""))
            difference = abs(slip - tracked.slip_mm)
            outcome = within(difference, bound)
            # A run that fails where the tracked one did not differs.
            words = (
                f"differs ({difference.reason})"
                if difference.reason
                else WORDS[outcome.answer]
            )
            # More digits than a page prints: anyone sees whether two are the same to the last.
            numbers = (slip, tracked.slip_mm, difference)
            cells = [
                str(number) if number.value is None else f"{number.value:.6f} mm"
                for number in numbers
            ]
            cells += [f"{bound} ({'noise' if is_same else 'devices'})"]
            line = (
                f"{row['case']:12}"
                + "{:>12}{:>14}{:>14}   {:22}".format(*cells)
                + f"{words}; on {processor}"
            )
            yield line, outcome.name != "fails" and not difference.reason
