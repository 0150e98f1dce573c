"""A motion the other way, or none: what is said of its size and of where it goes."""

from collections.abc import Callable, Mapping
from dataclasses import replace

from measured_report.editions.project import Project
from measured_report.records.record import load_record
from measured_report.values.results import Results
from report.sections import cure, noise


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
