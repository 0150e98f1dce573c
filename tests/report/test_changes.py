"""What the tracked editions have differently, and what the same edition measured again does not."""

import random
from collections.abc import Callable, Mapping
from dataclasses import replace
from statistics import fmean

import pytest
from conftest import SOURCES, compared, link

from measured_report.changes.alarm import LINES
from measured_report.changes.compare import Comparison, compare
from measured_report.commands.upgrade import verdict
from measured_report.editions.project import Project, own_release
from measured_report.files.root import ROOT
from measured_report.records.columns import column_of
from measured_report.records.record import Record, load_record, write_record

pytestmark = pytest.mark.usefixtures("unchanged")
LABEL = "1.4.0"
SECTIONS = ("contact_source", "noise", "reproduction", "upgrade")
AMOUNTS = ("shake_duration_s", "cycle_count", "frame_count", "shake_amplitude_m", "shake_frequency_hz")


@pytest.fixture(scope="module")
def pairs(editions) -> list[Comparison]:
    return [compare(editions[LABEL], editions[other]) for other in editions if other != LABEL]


def test_each_better_or_worse_compares_like_with_like_and_exceeds_noise_and_resolution(pairs, editions):
    count = 0
    for found in pairs:
        for move in (move for move in found.moves if move.direction):
            count += 1
            if isinstance(move.before, bool):  # dropped or not
                continue
            rows = [
                editions[release].chapters[move.section].results.record.rows[quantity_row(move, side)]
                for release, side in zip(found.releases, move.sides, strict=True)
            ]
            assert column_of(move.column).unit.endswith("/s") or all(
                rows[0].get(name) == rows[1].get(name) for name in AMOUNTS
            ), move.name
            apart = abs(move.before - move.after)
            assert apart > column_of(move.column).resolution, move.name
            assert apart > move.noise if move.chance is None else move.chance < 0.001, move.name
    assert count > 300


def quantity_row(move, side) -> int:
    return int(side.source.split("/")[-2])


def test_options_that_are_small_beside_others_are_listed(pairs, editions):
    [found] = (each for each in pairs if [*each.releases] == ["1.4.0", "1.8.0"])
    settings = [move for move in found.settings if move.section == "upgrade" and None not in (move.before, move.after)]
    assert {move.name: (move.before, move.after) for move in settings} == {
        "upgrade.option-sleep_tolerance.value": (pytest.approx(1e-4), pytest.approx(1e-3)),
        "upgrade.sum-dof_damping.value": (0.0, pytest.approx(0.621)),
    }
    lines = verdict(found, editions["1.4.0"], editions["1.8.0"])
    assert "sleep_tolerance 0.0001 → 0.001" in lines[1] and "dof_damping 0 → 0.621" in lines[1]
    assert len(lines) <= 7 + LINES


def test_the_same_measured_again_raises_no_alarm(tmp_path):
    """For each tracked edition: its runs are drawn anew from its repeats, and all else scatters as they."""
    link(tmp_path, *SOURCES)
    tracked_noise = (ROOT / "results").glob("newton-*/noise.json")
    releases = sorted(path.parent.name.removeprefix("newton-") for path in tracked_noise)
    for seed, release in enumerate(releases):
        draw = random.Random(seed)
        tracked = {name: load_record(ROOT / f"results/newton-{release}/{name}.json") for name in SECTIONS}
        sides = [Project(release, profile, tmp_path, own_release()) for profile in ("full", "quick")]
        for side in sides:
            scattered = repeats_drawn(tracked["noise"], draw)
            for name, record in tracked.items():
                write_record(side.record_path(name), replace(record, rows=[*map(scattered, record.rows)], traces={}))
        found = compared(*sides)
        assert not found.is_alarm, (release, seed, [f.text for f in found.flips], [m.text for m in found.alarms])


def repeats_drawn(noise: Record, draw: random.Random) -> Callable[[Mapping], dict]:
    """What a row may be when it is measured again."""
    runs: dict[str, list[Mapping]] = {}
    for row in (row for row in noise.rows if "of" in row):
        runs.setdefault(row["of"], []).append(row)
    of_all = set(noise.units).intersection(*(row for rows in runs.values() for row in rows))
    measured = [name for name in of_all if not column_of(name).kinds and not name.endswith("_count")]
    means = {(case, name): fmean(row[name] for row in rows) for case, rows in runs.items() for name in measured}

    def scattered(row: Mapping) -> dict:
        if row.get("device") == "cpu" or row.get("backend") == "mujoco":  # which repeats to the last bit
            return dict(row)
        case = row.get("of", row["case"])
        like = case if case in runs else draw.choice(list(runs))
        again = draw.choice(runs[like])
        shares = {name: again[name] / means[like, name] for name in measured}
        new = dict(row)
        for name, cell in row.items():
            about = column_of(name)
            if not isinstance(cell, float) or about.kinds or name.endswith("_count"):
                continue
            if case in runs and name in measured:
                new[name] = again[name]
            else:  # of what was never repeated nobody knows: it scatters as the drift, which scatters most but one
                new[name] = cell * shares.get(name, shares["drift_mm_s"])
        return new

    return scattered
