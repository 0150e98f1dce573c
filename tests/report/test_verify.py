"""Test ``make verify``, which measures the headline again."""

from dataclasses import replace

import pytest

from measured_report.editions.project import Project, own_release
from measured_report.files.errors import ReportError
from measured_report.findings.editions import Edition
from measured_report.records.record import load_record
from report.commands.verify import comparisons_of, verify

TRACKED = {
    row["case"]: row
    for row in load_record(Project(own_release()).record_path("reproduction")).rows
}
SHIPPED, STIFF = (TRACKED[case]["slip_mm"] for case in ("as-shipped", "stiff-pads"))
"""Tracked slips [mm], from the GPU on which the noise was measured."""
GPU = {"device": "cuda", "gpu": "NVIDIA H200", "cpu": "A processor"}
CPU = {"device": "cpu", "gpu": None, "cpu": "A processor"}


@pytest.fixture(scope="module")
def edition(editions) -> Edition:
    return editions[own_release()]


def found(machine: dict, shipped: float | None, stiff: float = STIFF) -> dict:
    rows = [
        {"case": "as-shipped", "slip_mm": shipped},
        {"case": "stiff-pads", "slip_mm": stiff},
    ]
    if shipped is None:
        rows[0]["slip_mm_reason"] = "it broke down"
    return {"machine": machine, "rows": rows, "compile_s": 1.0, "measure_s": 20.0}


@pytest.mark.parametrize(
    ("machine", "shipped", "said", "agrees"),
    [
        (GPU, SHIPPED, "0.02 mm agrees; on NVIDIA H200", True),
        (GPU, SHIPPED + 0.018, "cannot tell: measure again; on NVIDIA H200", True),
        (GPU, SHIPPED + 0.1, "differs; on NVIDIA H200", False),
        (CPU, SHIPPED, "agrees; on NVIDIA H200", True),
        (CPU, SHIPPED + 0.1, "differs; on NVIDIA H200", False),
        (CPU, None, "differs (it broke down); on NVIDIA H200", False),
    ],
)
def test_what_is_measured_again_agrees_up_to_a_bound_and_is_known_within_one_run(
    edition, machine, shipped, said, agrees
):
    repeats = list(comparisons_of(edition, found(machine, shipped)))
    first, first_agrees = next(
        repeat for repeat in repeats if repeat[0].endswith("on NVIDIA H200")
    )
    assert said.split() == first.split()[-len(said.split()) :]
    assert first_agrees is agrees
    text, all_agree = verify(edition, found(machine, shipped))
    assert all_agree is all(agrees for _, agrees in repeats)
    assert "more than noise and rounding" in text


def test_a_release_that_was_not_measured_so_is_refused(edition):
    with pytest.raises(ReportError, match="no results of reproduction to compare"):
        verify(replace(edition, chapters={}), found(CPU, SHIPPED))


@pytest.mark.parametrize(
    ("tracked_reason", "words", "agrees"),
    [("it broke down", "agrees (", True), ("the cube fell", "differs (", False)],
)
def test_two_runs_without_a_slip_agree_if_they_lack_it_for_the_same_reason(
    edition, tracked_reason, words, agrees
):
    """Test a run that breaks down on this machine.

    The tracked run breaks down as well, or its cube falls.
    """
    chapter = edition.chapters["reproduction"]
    rows = [
        {**row, "slip_mm": None, "slip_mm_reason": tracked_reason}
        if row["case"] == "as-shipped"
        else row
        for row in chapter.results.record.rows
    ]
    record = replace(chapter.results.record, rows=rows)
    results = replace(chapter.results, record=record)
    lost = replace(
        edition, chapters={"reproduction": replace(chapter, results=results)}
    )
    line, line_agrees = next(comparisons_of(lost, found(GPU, None)))
    assert words in line
    assert line_agrees is agrees
