"""A motion the other way, or none: what is said of its size and of where it goes."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from statistics import fmean

from measured_report.editions.project import Project
from measured_report.records.record import load_record
from measured_report.values.results import Results
from report.sections import cure, drift_law, noise


def results_of(section: str, change: Callable[[dict], Mapping] = dict, others: Mapping = {}) -> Results:
    path = Project("1.4.0").record_path(section)
    record = load_record(path)
    return Results(replace(record, rows=[{**row, **change(row)} for row in record.rows]), path, others)


def claims_with(change: Callable[[dict], Mapping]) -> dict:
    noise.derive(found := results_of("noise"))
    return {claim.name: claim for claim in cure.derive(results_of("cure", change, {"noise": found})).claims}


def test_a_box_that_walks_inward_does_not_walk_outward_whatever_the_law_gives():
    turned = ("growth_per_s", "predicted_growth_per_s")
    found = claims_with(lambda row: {column: -row[column] for column in turned if row.get(column)})
    assert found["follows_law"].outcome.name == "fails"


def test_a_ball_that_nothing_turns_aside_is_not_said_to_be_turned():
    rows = results_of("cure").record.rows
    runs = [row for row in rows if row.get("motion") == "pivot" and row["variant"] == "plain"]
    aside = {row["backend"]: row["sideways_mm"] for row in runs}
    found = claims_with(lambda row: {"sideways_mm": aside[row["backend"]]} if row.get("motion") == "pivot" else {})
    assert found["spinning_ball_goes_straight"].outcome.name == "fails"


def test_noise_is_a_share_of_the_size_of_a_drift():
    backward = results_of("noise", lambda row: {"drift_mm_s": -row["drift_mm_s"]} if row.get("of") else {})
    noise.derive(backward)
    assert backward.derived["drift_floor_share"].value > 0.0


def follows_the_law(noisier: float, faster: float) -> str:
    """What is said of the law where runs of one case are so many times as far apart, and all drift so much faster."""
    runs: dict[str, list[float]] = {}
    for row in results_of("noise").record.rows:
        runs.setdefault(row.get("of", ""), []).append(row.get("drift_mm_s", 0.0))

    def apart(row: dict) -> Mapping:
        mean = fmean(runs[row.get("of", "")])
        return {"drift_mm_s": mean + noisier * (row["drift_mm_s"] - mean)} if "of" in row else {}

    noise.derive(found := results_of("noise", apart))
    drifts = results_of("drift_law", lambda row: {"drift_mm_s": faster * (row["drift_mm_s"] or 0.0)}, {"noise": found})
    return next(claim for claim in drift_law.derive(drifts).claims if claim.name == "follows").outcome.said


def test_what_noise_takes_off_a_law_tells_nothing_of_it():
    found = [follows_the_law(*each) for each in ((1.0, 1.0), (1.0, 1.1), (20.0, 1.1), (20.0, 2.0))]
    assert found == ["holds", "fails", "cannot tell", "fails"]
