"""The cure: what is chosen among all recorded combinations, and when an explanation or a price is said."""

from collections.abc import Callable, Mapping
from dataclasses import replace

import pytest

from measured_report.editions.project import Project
from measured_report.parts.claim import HOLDS, Claim
from measured_report.parts.section import Section
from measured_report.records.record import load_record
from measured_report.values.results import Results
from report.sections import cure, noise
from report.sections.cure.budget import FIRM

Change = Callable[[dict], Mapping]


def results_of(section: str, change: Change, others: Mapping[str, Results]) -> Results:
    path = Project("1.4.0").record_path(section)
    record = load_record(path)
    return Results(replace(record, rows=[{**row, **change(row)} for row in record.rows]), path, others)


def section_with(*changes: Change) -> Section:
    """Derive section cure with some of its rows changed."""
    others = {"noise": results_of("noise", lambda row: {}, {})}
    noise.derive(others["noise"])
    return cure.derive(
        results_of("cure", lambda row: dict(pair for each in changes for pair in each(row).items()), others)
    )


def claims_with(*changes: Change) -> dict[str, Claim]:
    return {claim.name: claim for claim in section_with(*changes).claims}


def rows() -> list[Mapping]:
    """Load the rows of the combinations."""
    return [row for row in load_record(Project("1.4.0").record_path("cure")).rows if row.get("kind") == "run"]


@pytest.fixture(scope="module")
def claims() -> dict[str, Claim]:
    return claims_with()


def at(variant: str, **cells: float) -> Change:
    return lambda row: cells if row["case"] == variant.format("3cm") else {}


def at_limits(variant: str, *, kept: bool) -> Change:
    return lambda row: {"kept": kept} if row.get("variant") == variant and "family" in row else {}


def test_the_cure_on_stiff_pads_is_recommended(claims):
    assert claims["what_to_use"].outcome == HOLDS
    slip = next(row["slip_mm"] for row in rows() if at(FIRM, found=1.0)(row))
    assert claims["what_to_use"].numbers["slip"].value == slip


@pytest.mark.parametrize(
    "change", [at_limits("firm", kept=False), at(FIRM, slip_mm=20.0)], ids=["it loses cubes", "it slips"]
)
def test_it_is_not_recommended_where(change):
    assert claims_with(change)["what_to_use"].outcome != HOLDS
