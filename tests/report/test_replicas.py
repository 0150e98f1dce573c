"""Test that repeated measurements do not raise an alarm, and that planted changes of
packages do. ``plants.tgz`` contains the deciding sections of release 1.4.0 on an H200.
Each set was measured with one change in the installed packages, which the version of
mujoco-warp identifies.
"""

import shutil
import tarfile
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path

import pytest
from conftest import SOURCES
from toys import IS_WEEKLY, derived, link

from measured_report.changes.alarm import (
    false_alarm_counts,
    largest,
    sensitivity,
    settings_text,
    summary,
)
from measured_report.changes.compare import Comparison, compare
from measured_report.editions.project import Project, own_release
from measured_report.editions.status import records_of
from measured_report.findings.editions import Edition
from measured_report.findings.replicas import alike, replica_files
from measured_report.records.record import Record, read_record, sealed, write_record
from measured_report.records.replicas import read_replica

pytestmark = pytest.mark.usefixtures("unchanged")
LABEL = "1.4.0"
Cell = tuple[str, str, str]
SECTIONS = ("contact_source", "defaults", "noise", "reproduction", "speed", "upgrade")
UNCHANGED = "3.10.0.16"


@pytest.fixture(scope="module")
def plants() -> Mapping[str, Mapping[str, Record]]:
    """Return the records of planted changes, by the version of mujoco-warp and by
    section.
    """
    found: dict[str, dict[str, Record]] = {}
    with tarfile.open(Path(__file__).with_name("plants.tgz")) as archive:
        for member in (member for member in archive if member.name.endswith(".json")):
            _, folder, name = member.name.split("/")
            # These records are older than seals.
            text = archive.extractfile(member).read().decode().rstrip()
            text = sealed(text.removesuffix("}").rstrip())
            record = read_record(text.encode(), Path(name))
            found.setdefault(folder.rpartition("-")[2], {})[record.section] = replace(
                record, traces={}
            )
    return found


@pytest.fixture(scope="module")
def edition(tmp_path_factory) -> Edition:
    """Return the compared sections of 1.4.0 with its replicas."""
    root = tmp_path_factory.mktemp("project")
    link(root, *SOURCES)
    folder, tracked = root / f"results/newton-{LABEL}", Project(LABEL)
    (folder / "replicas").mkdir(parents=True)
    for path in (
        path for section in SECTIONS for path in tracked.results.glob(f"{section}.*")
    ):
        shutil.copy(path, folder)
    for path in replica_files(tracked):
        shutil.copy(path, folder / "replicas")
    return derived(Project(LABEL, root=root, own_release=own_release()))


@pytest.fixture
def measured_as(edition) -> Callable[..., Comparison]:
    """Compare the edition with changed records, as if these were of another release."""

    def measure(
        records: Mapping[str, Record],
        changes: Mapping[tuple[str, str, str], float] | None = None,
    ) -> Comparison:
        after = edition.project.of("1.9.0")
        for section in (section for section in SECTIONS if section in records):
            record, rows = (
                records[section],
                [dict(row) for row in records[section].rows],
            )
            for (name, case, column), factor in (changes or {}).items():
                for row in rows if name == section else ():
                    row.update(
                        {column: factor * row[column]} if row["case"] == case else {}
                    )
            identity = replace(
                record.identity,
                packages={**record.identity.packages, "newton": "1.9.0"},
            )
            write_record(
                after.record_path(section),
                replace(record, identity=identity, rows=rows, traces={}),
            )
        found = compare(edition, derived(after))
        shutil.rmtree(after.results)
        return found

    return measure


def test_each_measurement_left_out_is_told_as_the_same(editions):
    found = false_alarm_counts(editions[LABEL])
    assert found["comparisons"] >= 100 and found["told"] <= 0.03 * found["comparisons"]
    assert found["moves"] <= 0.001 * found["numbers"]
    claims = [
        claim
        for each in editions[LABEL].chapters.values()
        for claim in each.section.claims
    ]
    assert any(
        claim.confirmed.endswith("measurements, on 2 kinds of GPU") for claim in claims
    )


def test_the_same_release_on_another_card_rings_nothing(measured_as, plants):
    found = measured_as(plants[UNCHANGED])
    assert not found.is_alarm and found.moves == []
    assert summary(found).startswith("0 of ") and largest(found) == []


@pytest.mark.parametrize(
    ("plant", "first"),
    [
        ("4", "alarm: friction 1 → 0.95"),
        ("5", "alarm: timeconst 0.02"),
        ("6", "alarm: timeconst 0.02"),
    ],
    ids=["friction -5 %", "timeconst +15 %", "timeconst +3 %"],
)
def test_what_the_engine_is_given_rings_and_is_named_first(
    measured_as, plants, plant, first
):
    found = measured_as(plants[f"3.10.0.{plant}"])
    assert found.alarms and largest(found)[0].startswith(first)


@pytest.mark.parametrize(
    ("plant", "setting"),
    [("7", "option-integrator"), ("8", "option-timestep")],
    ids=["Euler", "15 substeps"],
)
def test_a_planted_setting_rings_and_is_named_first(
    measured_as, plants, plant, setting
):
    found = measured_as(plants[f"3.10.0.{plant}"])
    assert found.alarms and settings_text(found.settings).startswith(setting)


@pytest.mark.parametrize(
    "plant", ["12", "13", "15"], ids=["armature +1 %", "gravity 9.80", "timeconst +3 %"]
)
def test_what_is_hidden_in_the_kernels_is_told_as_changed(measured_as, plants, plant):
    """Test a change that no setting shows.

    The slip is among the first three changes, even if it does not matter.
    """
    found = measured_as(plants[f"3.10.0.{plant}"])
    assert len(
        found.moves
    ) >= 50 and "numbers changed; changes above their threshold: " in summary(found)
    assert (
        any("slip " in line for line in largest(found)[:3])
        and settings_text(found.settings) == "unchanged"
    )


@pytest.mark.parametrize(
    "case", ["as-shipped", "stiff-pads"] if IS_WEEKLY else ["as-shipped"]
)
def test_the_least_change_that_would_have_rung_is_that_which_rings(
    measured_as, plants, case
):
    cell, same = ("upgrade", case, "slip_mm"), measured_as(plants[UNCHANGED])
    assert sensitivity(same)["upgrade"] < 0.05
    [before] = {each.before for each in same.cells if each.name == ".".join(cell)}
    [now] = {
        row["slip_mm"]
        for row in plants[UNCHANGED]["upgrade"].rows
        if row["case"] == case
    }
    for share, rings in ((1.048, False), (1.052, True), (0.952, False), (0.948, True)):
        found = measured_as(plants[UNCHANGED], {cell: share * before / now})
        # A smaller slip is an improvement. It is listed, but does not raise an alarm.
        large = found.alarms if share > 1.0 else found.improvements
        assert [move.name for move in large] == [".".join(cell)] * rings
        assert found.alarms == [] or share > 1.0


def test_a_replica_that_is_left_out_rings_nothing(edition, measured_as):
    """Test a replica, which is one of the measurements that it is compared with."""
    tracked = {record.section: record for record in records_of(edition.project)}
    for path in replica_files(edition.project)[:: 1 if IS_WEEKLY else 3]:
        records = alike(tracked, read_replica(path))
        if records.keys() >= {"noise", "upgrade"}:
            found = measured_as(records)
            assert found.alarms == found.flips == [] and len(
                found.moves
            ) <= 0.002 * len(found.cells)
