"""What the tracked replicas say: measurements of one edition ring nothing, and changes that were planted do."""

import shutil
from collections.abc import Callable
from dataclasses import replace

import pytest
from conftest import SOURCES, derived, link

from measured_report.changes.alarm import largest, rate_of, settings_text
from measured_report.changes.compare import Comparison, compare
from measured_report.editions.project import Project, own_release
from measured_report.pages.editions import Edition
from measured_report.pages.replicas import replica_files
from measured_report.records.record import Record, write_record
from measured_report.records.replicas import read_replica

pytestmark = pytest.mark.usefixtures("unchanged")
LABEL = "1.4.0"
SECTIONS = ("contact_source", "friction", "gap", "noise", "priority", "stiffness", "upgrade")
SHAKEN = ("slip_mm", "drift_mm_s", "wander_mm", "increment_mean_mm", "increment_last_mm", "friction_velocity_mm_s")


@pytest.fixture(scope="module")
def again() -> dict[str, Record]:
    """The measurement of 1.4.0 that has all sections, and the name of its file."""
    return max(map(read_replica, replica_files(Project(LABEL))), key=len)


@pytest.fixture(scope="module")
def edition(tmp_path_factory, again) -> Edition:
    """1.4.0 as far as it is compared, with its other replicas alone."""
    root = tmp_path_factory.mktemp("project")
    link(root, *SOURCES)
    folder, tracked = root / f"results/newton-{LABEL}", Project(LABEL)
    (folder / "replicas").mkdir(parents=True)
    for path in (path for section in SECTIONS for path in tracked.results.glob(f"{section}.*")):
        shutil.copy(path, folder)
    for path in replica_files(tracked):
        if read_replica(path).keys() != again.keys():
            shutil.copy(path, folder / "replicas")
    return derived(Project(LABEL, root=root, own_release=own_release()))


@pytest.fixture
def measured_as(edition, again) -> Callable[[Callable[[dict], dict]], Comparison]:
    """Compares the edition with that measurement as if it were another release's, changed."""

    def measure(change: Callable[[dict], dict] = dict) -> Comparison:
        after = edition.project.of("1.9.0")
        for section in SECTIONS:
            record = again[section]
            packages = {**record.identity.packages, "newton": "1.9.0"}
            identity = replace(record.identity, packages=packages)
            rows = [change(row) for row in record.rows]
            write_record(after.record_path(section), replace(record, identity=identity, rows=rows))
        return compare(edition, derived(after))

    return measure


def times(factor: float, *names: str, **others: float) -> Callable[[dict], dict]:
    """Multiplies numbers of runs, those of the shake by a factor; what repeats to the last bit as well."""
    factors = dict.fromkeys(names, factor) | others
    return lambda row: {
        name: cell * factors.get(name, 1.0) if isinstance(cell, float) else cell for name, cell in row.items()
    }


def test_measurements_of_one_edition_ring_nothing(editions):
    edition = editions[LABEL]
    found = rate_of(edition)
    assert found["comparisons"] >= 39 and found["rang"] == found["flips"] == 0
    assert found["moves"] <= 0.01 * found["numbers"]
    assert "cannot tell" not in {claim.outcome.said for claim in edition.chapters["friction"].section.claims}
    confirmed = {claim.confirmed for each in edition.chapters.values() for claim in each.section.claims}
    assert "confirmed in 3 of 3 measurements, on 2 kinds of GPU" in confirmed


def test_a_measurement_compared_as_an_upgrade_rings_nothing(measured_as):
    found = measured_as()
    assert found.flips == found.alarms == []
    assert len(found.moves) <= 0.01 * len(found.cells)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        # A whole shake by MuJoCo's C engine, with pads and cube changed so, gives these factors of slip and drift.
        (times(0.99996, *SHAKEN, friction=0.95, cone_use=1 / 0.95), "friction 1 → 0.95"),
        (times(1.0322, *SHAKEN, timeconst_s=1.03), "timeconst 0.02"),
        (times(1.1586, *SHAKEN, timeconst_s=1.15), "timeconst 0.02"),
    ],
)
def test_a_planted_change_rings_and_is_named_first(measured_as, change, said):
    found = measured_as(change)
    assert found.alarms
    assert largest(found)[0].startswith(f"alarm: {said}")


@pytest.mark.parametrize(
    ("option", "value", "factor"),
    # By the C engine the slip is 0.38 % more, 0.56 % less, and the same with another kf or gap, which it does not read.
    [("option-integrator", 0.0, 1.0038), ("option-timestep", 1 / 900, 0.9944), ("default-kf", 850.0, 1.0)]
    + [("default-rigid_gap", 0.2, 1.0)],
    ids=["integrator", "substeps", "kf", "gap"],
)
def test_a_planted_setting_rings(measured_as, option, value, factor):
    def change(row: dict) -> dict:
        return times(factor, *SHAKEN)(row) | ({"value": value} if row["case"] == option else {})

    found = measured_as(change)
    assert found.alarms and settings_text(found.settings).startswith(option)
