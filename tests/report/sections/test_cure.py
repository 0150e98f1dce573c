"""The cure: what is chosen among all recorded combinations, and when an explanation or a price is said."""

from collections.abc import Callable, Mapping
from dataclasses import replace

import pytest

from measured_report.editions.project import Project
from measured_report.parts.claim import FAILS, HOLDS, Claim
from measured_report.parts.section import Section
from measured_report.records.record import load_record
from measured_report.values.results import Results
from report.sections import cure, cure_cost, noise
from report.sections.cure.variants import FIRM, Variant

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


def at(variant: Variant, **cells: float) -> Change:
    return lambda row: cells if row["case"] == variant.case.format("3cm") else {}


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


def test_the_budget_says_both_tolerances(claims):
    kept = [(row["remainder_mm"], row["slip_mm"]) for row in rows() if row["slip_mm"] and row["slip_mm"] < 80.0]
    numbers = {name: quantity.value for name, quantity in claims["budget_closes"].numbers.items()}
    assert numbers["count"] == len(kept)
    assert numbers["closed"] == sum(rest <= max(0.02, 0.05 * slip) for rest, slip in kept)


def test_a_price_is_seen_beyond_the_noise_alone():
    def told(ratio: float) -> Claim:
        results = results_of("cure_cost", lambda row: {"frame_ratio": ratio} if row["case"] == "best" else {}, {})
        return next(claim for claim in cure_cost.derive(results).claims if claim.name == "best_costs_nothing")

    assert (told(1.0).outcome, told(1.2).outcome) == (HOLDS, FAILS)
    assert told(1.2).numbers["worst"].value > told(1.0).numbers["unseen"].value
