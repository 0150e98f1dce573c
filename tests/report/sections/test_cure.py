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
from report.sections.cure.variants import FIRM, FIRM_EULER, TERM, Variant

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


def test_only_what_loses_no_cube_is_compared_with(claims):
    slips_less = at(FIRM_EULER, slip_mm=0.0001)
    slip = next(row["slip_mm"] for row in rows() if at(FIRM, found=1.0)(row))
    assert claims["what_to_use"].numbers["slip"].value == slip
    assert claims["what_to_use"].outcome == HOLDS == claims_with(slips_less)["what_to_use"].outcome
    assert claims_with(slips_less, at_limits("firm-euler", kept=True))["what_to_use"].outcome != HOLDS


@pytest.mark.parametrize(
    "change",
    [at_limits("firm", kept=False), at(TERM, slip_mm=0.001), at(FIRM, slip_mm=20.0)],
    ids=["it loses cubes", "the term slips less", "it slips"],
)
def test_it_is_not_recommended_where(change):
    assert claims_with(change)["what_to_use"].outcome != HOLDS


@pytest.mark.parametrize("times", [0.05, 20.0])
def test_an_explanation_covers_most_of_its_effect_and_no_more_than_there_is(claims, times):
    row = next(row for row in rows() if at(TERM, found=1.0)(row))
    scaled = {name: times * row[name] for name in ("step_x_mm", "step_z_mm")}
    assert claims["term_uncovers_step"].outcome == HOLDS
    assert claims_with(at(TERM, **scaled))["term_uncovers_step"].outcome == FAILS


def test_the_budget_says_both_tolerances(claims):
    kept = [(row["remainder_mm"], row["slip_mm"]) for row in rows() if row["slip_mm"] and row["slip_mm"] < 80.0]
    numbers = {name: quantity.value for name, quantity in claims["budget_closes"].numbers.items()}
    assert numbers["count"] == len(kept)
    assert numbers["closed"] == sum(rest <= max(0.02, 0.05 * slip) for rest, slip in kept)
    assert numbers["relative"] == sum(rest <= 0.05 * slip for rest, slip in kept)
    assert numbers["little"] == sum(slip <= 0.04 for _, slip in kept)


def test_a_price_is_seen_beyond_the_noise_alone():
    def told(ratio: float) -> Claim:
        results = results_of("cure_cost", lambda row: {"frame_ratio": ratio} if row["case"] == "term" else {}, {})
        return next(claim for claim in cure_cost.derive(results).claims if claim.name == "term_costs_nothing")

    assert (told(1.0).outcome, told(1.2).outcome) == (HOLDS, FAILS)
    assert told(1.2).numbers["worst"].value > told(1.0).numbers["unseen"].value
