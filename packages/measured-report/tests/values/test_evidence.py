"""Test evidence with measurements that are drawn around known true values."""

from dataclasses import replace

import numpy as np
import pytest
from scipy import stats
from toys import BY_HAND, lay_out

from measured_report.files.columns import Schema
from measured_report.files.config import Config, report, report_in
from measured_report.files.settings import Columns
from measured_report.records.record import Record
from measured_report.values import evidence
from measured_report.values.body import Body, _changed, body_of
from measured_report.values.evidence import HOST_SHARE, Evidence
from measured_report.values.noise import Estimate

BASE = Record(
    **{**BY_HAND, "section": "toy", "identity": None, "units": {}, "rows": []}
)
ROWS = 40
DRIFT = "drift_mm_s"
TIME = "frame_ms"
SETTINGS = """
edition = "numpy"
case = "experiments.scene:Case"
noise_section = "noise"
repeating = { backend = ["c"] }
pages = [{ name = "index", texts = [] }]
columns = [
    { kind = "cost", pattern = "frame_(ms|ratio)(_p[0-9]+)?|ratio_resolution|frames_per_s|build_s" },
    { kind = "failure", names = ["dropped"] },
    { trials = "try_count", names = ["hit_count"] },
    { rate_of = "frame_ms", pattern = "frames_per_s" },
    { known_within = "ratio_resolution", pattern = "frame_ratio" },
    { grows_with = "shake_duration_s", resolution = 1e-3, pattern = "slip_mm" },
    { resolution = 1e-4, pattern = "drift_mm_s" },
]
"""


@pytest.fixture(scope="module", autouse=True)
def columns(entered, tmp_path_factory):
    """Enter a report whose columns define how their numbers scatter."""
    lay_out(folder := tmp_path_factory.mktemp("columns"))
    (folder / "report.toml").write_text(SETTINGS)
    with report_in(folder):
        yield


def body(**editions: list[Record | None]) -> Body:
    """Return the measured numbers of one section by edition."""
    measured = {(edition, "toy"): records for edition, records in editions.items()}
    return body_of(measured, report().columns)


def evidence_of(records: list[Record | None]) -> Evidence:
    return body(a=records).sections["a", "toy"]


def repeats_of(rows: list[dict]) -> evidence.Repeated:
    return evidence.repeats_of(rows, report().columns)


def key_of(row: dict) -> evidence.RowKey:
    return evidence.key_of(row, report().columns)


def estimate(of: Evidence, name: str, row: dict) -> Estimate | None:
    return of.estimate(name, row, report().columns)


def record(rows: list[dict], **machine: str) -> Record:
    machine = {**BASE.machine, **machine}
    return replace(BASE, rows=rows, units={}, traces={}, machine=machine)


def measured(
    truths: np.ndarray,
    deviations: np.ndarray,
    count: int,
    chance: np.random.Generator,
    *,
    column: str = DRIFT,
    host: float = 0.0,
) -> list[Record]:
    """Draw this many measurements.

    The numbers of one measurement share the relative error of its host.
    """
    records = []
    for _ in range(count):
        numbers = chance.normal(truths, deviations) * (1 + chance.normal(0, host))
        rows = [
            {"case": f"c{row}", column: float(number)}
            for row, number in enumerate(numbers)
        ]
        records.append(record(rows))
    return records


def drawn(
    seed: int, *counts: int, column: str = DRIFT, host: float = 0.0
) -> tuple[list[np.ndarray], list[list[Record]]]:
    """Return the true values and the measurements of editions measured this many times.

    The rows scatter equally in all editions, and each has its own deviation.
    """
    chance = np.random.default_rng(seed)
    deviations = 0.01 * np.sqrt(8.0 / chance.chisquare(8.0, ROWS))
    truths = [chance.uniform(1.0, 3.0, ROWS) for _ in counts]
    records = [
        measured(each, deviations, count, chance, column=column, host=host)
        for each, count in zip(truths, counts, strict=True)
    ]
    return truths, records


def known(
    of: Evidence, shown: Record, column: str = DRIFT
) -> tuple[np.ndarray, np.ndarray]:
    """Return the printed values, and their distances from the true values."""
    estimates = [estimate(of, column, row) for row in shown.rows]
    values = np.array([each.value for each in estimates])
    return values, np.array([each.noise for each in estimates])


def with_row(of: Record, row: int, **cells: object) -> Record:
    """Return a record with other cells in one of its rows."""
    rows = list(of.rows)
    rows[row] = {**rows[row], **cells}
    return replace(of, rows=rows)


@pytest.mark.parametrize("counts", [(1, 3), (2, 1), (3,), (5, 1, 1), (8,)])
def test_the_truth_is_within_the_noise_as_often_as_it_says(counts):
    inside = []
    for seed in range(8):
        truths, editions = drawn(seed, *counts)
        names = "abc"[: len(counts)]
        found = body(**dict(zip(names, editions, strict=True)))
        for name, truth, records in zip(names, truths, editions, strict=True):
            values, noises = known(found.sections[name, "toy"], records[0])
            inside.append(abs(values - truth) <= noises)
    assert 0.92 <= np.mean(inside) <= 0.98


@pytest.mark.parametrize("host", [0.0, 0.02, 0.05])
def test_left_out_times_lie_within_the_noise_of_the_others(host):
    """Return the calibration that the site prints for times whose hosts differ by this
    much.
    """
    inside = 0
    total = 0
    for seed in range(30):
        _, editions = drawn(seed, 6, 2, 1, column=TIME, host=host)
        found = body(a=editions[0], b=editions[1], c=editions[2])
        counts = found.calibration["times"]
        assert found.calibration["physics"] == (0, 0)
        inside += counts[0]
        total += counts[1]
    assert total == 30 * ROWS * 8
    assert 0.93 <= inside / total <= 0.975


def test_the_interval_of_a_time_measured_once_includes_the_host():
    """Test runs that scatter by 1 % and hosts that differ by 3 %, which one measurement
    cannot show.
    """
    inside = []
    noises = []
    for seed in range(60):
        truths, editions = drawn(seed, 6, 1, column=TIME, host=0.03)
        found = body(a=editions[0], b=editions[1]).sections["b", "toy"]
        values, noise = known(found, editions[1][0], TIME)
        inside.append(abs(values - truths[1]) <= noise)
        noises.append(np.median(noise / values))
    assert 0.85 <= np.mean(inside) <= 0.98
    assert np.median(noises) == pytest.approx(1.96 * 0.03, rel=0.3)


def test_what_was_measured_once_has_the_scatter_of_its_column_elsewhere():
    _, editions = drawn(5, 6, 1)
    found = body(a=editions[0], b=editions[1])
    once = found.sections["b", "toy"]
    again = found.sections["a", "toy"]
    assert once.scatters == again.scatters
    row = editions[1][0].rows[3]
    single = estimate(once, DRIFT, row)
    several = estimate(again, DRIFT, editions[0][0].rows[3])
    assert (single.count, several.count) == (1, 6)
    assert single.freedom == several.freedom
    assert single.variance == pytest.approx(several.variance, rel=0.3)
    new = {"case": "of no other edition", DRIFT: 2.0}
    [scatter] = once.scatters.values()
    of_column = scatter.level * 2.0**scatter.slope
    assert estimate(once, DRIFT, new).variance == pytest.approx(of_column)


def test_a_row_that_is_wild_in_one_edition_is_wild_in_the_others():
    chance = np.random.default_rng(2)
    deviations = np.full(ROWS, 0.01)
    deviations[7] = 1.0
    truths = np.full(ROWS, 2.0)
    editions = [measured(truths, deviations, count, chance) for count in (5, 1)]
    found = body(a=editions[0], b=editions[1]).sections["b", "toy"]
    _, noises = known(found, editions[1][0])
    assert noises[7] > 1.0
    assert max(np.delete(noises, 7)) < 0.05


def test_a_section_with_one_row_scatters_as_its_column_does_in_others():
    _, [records, [single]] = drawn(5, 6, 1)
    lone = replace(single, rows=single.rows[:1])
    measured_sections = {("a", "toy"): records, ("a", "other"): [lone]}
    found = body_of(measured_sections, report().columns).sections["a", "other"]
    _, [noise] = known(found, lone)
    assert 0.015 < noise < 0.06


def test_the_noise_falls_with_each_measurement():
    falls = []
    for seed in range(12):
        _, [records] = drawn(seed, 6)
        of_counts = [
            known(evidence_of(records[:count]), records[0])[1] for count in range(2, 7)
        ]
        falls.append(of_counts[-1] < of_counts[0])
    assert np.mean(falls) >= 0.95


def test_one_contradicting_measurement_of_eight_is_noted_and_hardly_moves_the_mean():
    _, [records] = drawn(3, 8)
    shown = records[0].rows[4]
    before = estimate(evidence_of(records), DRIFT, shown)
    wild = [*records[:7], with_row(records[7], 4, drift_mm_s=900.0)]
    found = evidence_of(wild)
    after = estimate(found, DRIFT, shown)
    assert abs(after.value - before.value) < after.noise
    assert after.noise < 4 * before.noise
    assert after.dissent == 1
    assert after.note.endswith(" to 900; 7 of them agree")
    others = [key for key in found.numbers if key[0] != key_of(shown)]
    assert all(found.numbers[key].dissent == 0 for key in others)
    assert not found.edges
    assert found.odd_rows == pytest.approx((1 + 0.02) / 8)


@pytest.mark.parametrize("cell", [{"end": "b"}, {"dropped": True}])
def test_one_run_of_eight_that_ends_otherwise_drops_that_measurement_of_that_row(cell):
    _, [records] = drawn(3, 8)
    ended = [
        replace(each, rows=[{**row, "end": "a", "dropped": False} for row in each.rows])
        for each in records
    ]
    others = [*ended[:7], with_row(ended[7], 4, **cell)]
    found = evidence_of(others)
    totals = {key[0][0]: several.total for key, several in found.numbers.items()}
    assert totals.pop("c4") == 7
    assert set(totals.values()) == {8}
    assert not found.edges
    assert found.odd_rows == pytest.approx((1 + 0.02) / 8)
    assert "7 measurements" in estimate(found, DRIFT, ended[0].rows[4]).note


def test_a_row_that_ends_otherwise_in_three_of_eight_is_decided_by_chance():
    _, [records] = drawn(3, 8)
    ended = [
        with_row(each, 4, end="ab"[index > 4]) for index, each in enumerate(records)
    ]
    ended = [with_row(ended[0], 4, drift_mm_s=9.0), *ended[1:]]
    found = evidence_of(ended)
    row = ended[0].rows[4]
    assert found.edges == {key_of(row)}
    chaotic = estimate(found, DRIFT, row)
    assert chaotic.is_edge
    assert chaotic.note.startswith("chance decides how this run ends: 8 measurements")
    assert chaotic.noise == pytest.approx(9.0 - chaotic.value), "as far as was seen"


def test_measurements_left_out_say_how_often_a_change_is_listed_by_mistake():
    _, [records] = drawn(5, 5)
    assert evidence_of(records).changed == [(ROWS, 0)] * 5
    for row in range(8):
        moved = records[2].rows[row][DRIFT] + 0.2
        records[2] = with_row(records[2], row, drift_mm_s=moved)
    found = evidence_of(records)
    assert found.changed[2] == (ROWS, 8)
    assert sum(count for _, count in found.changed) == 8


def test_calibration_counts_what_lies_within_the_noise_of_the_others():
    """Test three rows that agree within 1 %, and then one measurement that is ten times
    as large.
    """
    rows = [[1.0, 1.01, 0.99, 1.0], [2.0, 2.02, 1.98, 2.0], [3.0, 3.03, 2.97, 3.0]]

    def calibration(column: str) -> dict[str, tuple[int, int]]:
        numbers = np.transpose(rows).tolist()
        cells = [
            [{"case": f"c{row}", column: cell} for row, cell in enumerate(each)]
            for each in numbers
        ]
        return body(a=list(map(record, cells))).calibration

    for column, kind in (
        (DRIFT, "physics"),
        (TIME, "times"),
        ("frame_ratio", "ratios"),
    ):
        nothing = {"physics": (0, 0), "times": (0, 0), "ratios": (0, 0)}
        assert calibration(column) == {**nothing, kind: (12, 12)}
    rows[1][3] = 20.0
    assert calibration(DRIFT)["physics"] == (11, 12)


def test_the_scatter_between_hosts_is_that_of_all_times_together():
    """Test two hosts, 3 % below and above the mean.

    Their variance has one degree of freedom, and the usual one of 3 % has four.
    """
    sides = [
        record([{"case": f"c{row}", TIME: scale * (row + 1)} for row in range(9)])
        for scale in (9.7, 10.3)
    ]
    variance, freedom = evidence_of(sides).host
    logs = np.log([0.97, 1.03])
    assert variance == pytest.approx(0.8 * HOST_SHARE**2 + 0.2 * logs.var(ddof=1))
    assert freedom == 5.0
    slips = [record([{"case": f"c{row}", DRIFT: 1.0} for row in range(9)])] * 2
    assert evidence_of(slips).host == (HOST_SHARE**2, 4.0)


def test_times_on_a_cpu_do_not_count_for_the_scatter_between_hosts_with_cards():
    """Test a section on a CPU, whose times differ by a factor of 1.7."""

    def section(device: str, *scales: float) -> list[Record]:
        return [
            record(
                [{"case": f"c{row}", TIME: 10.0 * scale} for row in range(9)],
                device=device,
            )
            for scale in scales
        ]

    cards = section("cuda", 0.97, 1.03)
    alone = body_of({("a", "toy"): cards}, report().columns)
    both = body_of(
        {("a", "toy"): cards, ("a", "grasp"): section("cpu", 1.0, 1.7)},
        report().columns,
    )
    assert both.sections["a", "toy"].host == alone.sections["a", "toy"].host
    assert both.sections["a", "grasp"].host > both.sections["a", "toy"].host


def test_columns_measured_more_often_elsewhere_count_for_the_scatter_of_hosts():
    """Test one column of four that was measured six times in another edition and never
    shifts.
    """
    columns = [TIME, "frame_ms_p25", "frame_ms_p50", "frame_ms_p75"]

    def with_shift(scale: float) -> Record:
        cells = {TIME: 10.0} | dict.fromkeys(columns[1:], 10.0 * scale)
        return record([{"case": f"c{row}", **cells} for row in range(4)])

    sides = [with_shift(0.97), with_shift(1.03)]
    others = [record([{"case": f"c{row}", TIME: 10.0} for row in range(4)])] * 6
    variance, freedom = body(a=sides, b=others).sections["a", "toy"].host
    logs = np.log([0.97, 1.03])
    weight = 4 / (4 + 1 + 5)
    squares = ((logs - logs.mean()) ** 2).sum()
    assert variance == pytest.approx(
        weight * HOST_SHARE**2 + (1 - weight) * squares / 6
    )
    assert freedom == 9.0


def test_rows_of_a_case_are_compared_one_by_one_outside_the_section_on_noise():
    """Test that `of` may name the solver or the case of a row."""
    _, [records] = drawn(5, 4)
    named = [
        replace(each, rows=[{**row, "of": "a solver"} for row in each.rows])
        for each in records
    ]
    found = evidence_of(named)
    assert len(found.numbers) == ROWS
    assert {key[0][0] for key in found.numbers} == {f"c{row}" for row in range(ROWS)}


def test_the_noise_of_trials_is_theirs_alone():
    rows = [
        {"case": f"c{row}", "hit_count": 3 + row, "try_count": 20} for row in range(4)
    ]
    found = evidence_of([record(rows)] * 3)
    assert not [key for key in found.numbers if key[1] == "hit_count"]
    assert not [key for key in found.scatters if key[0] == "hit_count"]


def test_a_change_that_is_certain_counts_as_a_false_alarm():
    """Test that a probability of 0 becomes the smallest possible number."""
    chances = [((row,), np.array([0.0 if row < 3 else 0.5])) for row in range(12)]
    assert _changed(chances, 0.02) == [(12, 3)]


def test_runs_of_one_case_are_compared_by_their_mean():
    """Test that the scatter of three measurements determines the precision of their
    means.
    """
    chance = np.random.default_rng(3)
    again = []
    for _ in range(3):
        runs = chance.normal(2.0, 0.1, 10) + chance.normal(0, 0.05)
        rows = [
            {"case": f"{case}-{run}", "of": case, DRIFT: float(number)}
            for case in "abc"
            for run, number in enumerate(runs)
        ]
        again.append(record(rows))
    found = body_of({("x", "noise"): again}, report().columns).sections["x", "noise"]
    mean = found.means()["a", DRIFT]
    samples = [np.mean([row[DRIFT] for row in each.rows[:10]]) for each in again]
    assert mean.samples == pytest.approx(samples)
    assert mean.value == pytest.approx(np.mean(samples))
    assert mean.count == 3
    one = body_of({("x", "noise"): again[:1]}, report().columns).sections["x", "noise"]
    single = one.means()["a", DRIFT]
    numbers = [row[DRIFT] for row in again[0].rows[:10]]
    assert single.error == pytest.approx(stats.sem(numbers))


def test_what_repeats_does_so_whatever_its_unit_and_a_cost_does_not():
    """Test that a limit in ms that an engine computes does not count as a measured
    time. Its kind decides this, not its unit.
    """
    runs = [
        {"case": f"r{n}", "of": "a", "limit_ms": 2.0 + n, "frame_ms": 2.0 + n}
        for n in range(9)
    ]
    found, row = (
        Evidence(repeats=repeats_of(runs)),
        {"case": "a", "backend": "c", "limit_ms": 4.0, "frame_ms": 4.0},
    )
    assert (
        estimate(found, "limit_ms", row).variance
        == 0.0
        < estimate(found, "frame_ms", row).variance
    )
    assert estimate(found, "limit_ms", {**row, "backend": "warp"}).variance > 0.0


def test_what_was_measured_once_has_the_noise_of_the_runs_of_one_case_and_larger_numbers_more():
    """Test eight runs with a deviation of 0.1.

    With t = 2.3646 the noise of one such run is ±0.236, and that of a run five times as
    large ±1.18.
    """
    runs = [
        {
            "of": "c",
            "case": f"r{n}",
            "drift_mm_s": 2.0 + 0.1 * (7 / 8) ** 0.5 * (-1) ** n,
        }
        for n in range(8)
    ]
    found = Evidence(repeats=repeats_of(runs))
    noises = [
        estimate(found, "drift_mm_s", {"case": "x", "drift_mm_s": size}).noise
        for size in (0.5, 2.0, 10.0)
    ]
    expected = stats.t.ppf(0.975, 7) * 0.1
    assert noises == pytest.approx([expected, expected, 5 * expected], rel=1e-3)
    [mean] = found.means().values()
    assert mean.value == pytest.approx(2.0) and mean.noise == pytest.approx(
        expected / 8**0.5, rel=1e-3
    )


SOLVERS = {"rk45": 3000.0, "dop853": 800.0, "lsoda": 1.6, "radau": 12.0}


def timed(
    chance: np.random.Generator, truths: dict[str, float], share: float = 0.04
) -> Record:
    """Return the times of solvers, each measured once and repeated five times."""
    times = {
        case: truth * chance.normal(1.0, share, 6) for case, truth in truths.items()
    }
    rows = [{"case": case, TIME: float(runs[0])} for case, runs in times.items()]
    rows += [
        {"case": f"{case}-{n}", "of": case, TIME: float(time)}
        for case, runs in times.items()
        for n, time in enumerate(runs[1:])
    ]
    return record(rows)


@pytest.mark.parametrize("count", [2, 4])
def test_each_row_has_the_noise_of_its_own_repeats(count):
    """A time of 1.6 ms is known to some 10 %, although another one varies by 120 ms."""
    truths = dict([*SOLVERS.items()][:1] + [*SOLVERS.items()][1 - count :])
    one = timed(np.random.default_rng(1), truths)
    found = evidence_of([one])
    for row in one.rows[:count]:
        known = estimate(found, TIME, row)
        runs = [other[TIME] for other in one.rows if row["case"] in other.values()]
        assert known.value == pytest.approx(np.mean(runs))
        assert (known.count, len(known.samples)) == (6, 6)
        expected = np.hypot(0.04 / 6**0.5, HOST_SHARE) * row[TIME]
        assert 0.5 * expected < known.error < 2 * expected
        assert known.noise < 0.15 * row[TIME]


def test_the_own_noise_of_rows_covers_their_truth_and_separates_unlike_ones():
    chance = np.random.default_rng(2)
    inside, apart = [], []
    for _ in range(100):
        one = timed(chance, SOLVERS)
        found = evidence_of([one])
        known = [estimate(found, TIME, row) for row in one.rows[:4]]
        inside += [
            abs(each.value - truth) <= each.noise
            for each, truth in zip(known, SOLVERS.values(), strict=True)
        ]
        apart.append(known[0].value - known[3].value > known[0].noise + known[3].noise)
    assert np.mean(inside) > 0.94
    assert all(apart)


def test_runs_of_one_measurement_do_not_count_as_measurements():
    """Hosts differ by 10 %, as the three measurements of another edition show."""
    chance = np.random.default_rng(4)
    hosts = [1.0, 1.1, 0.9]
    several = [
        timed(chance, {case: host * time for case, time in SOLVERS.items()}, 0.001)
        for host in hosts
    ]
    once = timed(chance, SOLVERS, 0.001)
    sections = body(a=several, b=[once]).sections
    row = several[0].rows[0]
    mean = estimate(sections["a", "toy"], TIME, row)
    assert mean.count == 3
    assert mean.error / row[TIME] == pytest.approx(0.1 / 3**0.5, rel=0.4)
    single = estimate(sections["b", "toy"], TIME, once.rows[0])
    assert single.count == 1
    assert single.error / once.rows[0][TIME] == pytest.approx(0.1, rel=0.4)


def test_repeats_that_agree_by_chance_are_shrunk_towards_their_column():
    rows = [
        {
            "case": f"{case}-{n}" if n else case,
            TIME: time,
            **({"of": case} if n else {}),
        }
        for case, times in {
            "a": [10.0, 10.4, 9.6],
            "b": [20.0, 20.9, 19.2],
            "c": [5.0, 5.02],
            "d": [7.0],
        }.items()
        for n, time in enumerate(times)
    ]
    found = evidence_of([record(rows)])
    shares = {
        row["case"]: estimate(found, TIME, row).error / row[TIME]
        for row in rows
        if "of" not in row
    }
    own = 0.02 / 5.01 / 2  # the error of a mean of two runs that differ by 0.02
    assert shares["c"] > np.hypot(2 * own, HOST_SHARE)
    assert shares["d"] > shares["a"], "it ran once"
    assert shares["d"] == pytest.approx(np.hypot(0.04, HOST_SHARE), rel=0.4)


def test_a_row_that_names_no_case_of_its_section_repeats_nothing():
    rows = [{"case": f"r{n}", "of": "family", DRIFT: 1.0 + n} for n in range(8)]
    found = evidence_of([record(rows)])
    assert not found.scatters
    assert estimate(found, DRIFT, rows[0]) is None


def test_the_noise_of_a_cost_is_in_proportion_and_that_of_a_slip_is_not_smaller():
    """The noisy runs are of another size: 3 s with ±4 %, and 3 m."""
    numbers = np.random.default_rng(3).normal(3000.0, 120.0, 40)
    runs = [
        {"case": f"r{n}", "of": "slow", TIME: float(x), "slip_mm": float(x)}
        for n, x in enumerate(numbers)
    ]
    found = Evidence(repeats=repeats_of(runs))
    row = {"case": "x", TIME: 1.6, "slip_mm": 1.6}
    assert estimate(found, TIME, row).noise == pytest.approx(0.04 * 2.02 * 1.6, rel=0.2)
    assert estimate(found, "slip_mm", row).noise > 200.0


def test_runs_part_as_they_go_on():
    runs = [
        {
            "of": "c",
            "case": f"r{n}",
            "slip_mm": 6.0 + 0.1 * (-1) ** n,
            "shake_duration_s": 12.0,
        }
        for n in range(8)
    ]
    found = Evidence(repeats=repeats_of(runs))
    one, long = (
        {"case": "x", "slip_mm": 3.0, "shake_duration_s": seconds}
        for seconds in (12.0, 60.0)
    )
    assert estimate(found, "slip_mm", long).noise == pytest.approx(
        5 * estimate(found, "slip_mm", one).noise
    )


def test_a_row_itself_says_how_well_a_time_a_ratio_and_a_count_are_known():
    """Test that 90 % of a normal distribution is within 1.645 deviations, and that a
    median of 25 has √(π/2)/5 of one deviation.
    """
    row = {
        "case": "x",
        "frame_ms": 8.0,
        "frame_ms_p5": 7.8,
        "frame_ms_p95": 8.3,
        "repeat_count": 25,
        "frames_per_s": 125.0,
    }
    time = estimate(Evidence(), "frame_ms", row)
    median = (np.pi / 2) ** 0.5 * 0.5 / 3.2897 / 5
    by_hand = stats.t.ppf(0.975, 4) * np.hypot(median, 0.03 * 8.0)
    assert time.noise == pytest.approx(by_hand, rel=1e-4), "hosts differ by 3 %"
    assert estimate(Evidence(), "frames_per_s", row).noise == pytest.approx(
        time.noise * 125 / 8
    )
    ratio = {
        "case": "x",
        "frame_ratio": 0.5,
        "ratio_resolution": 0.01,
        "frame_ratio_p5": 0.4,
        "frame_ratio_p95": 0.6,
    }
    assert estimate(Evidence(), "frame_ratio", ratio).noise == pytest.approx(0.005), (
        "timed in turn"
    )
    in_c = {
        "case": "x",
        "backend": "c",
        "slip_mm": 6.0,
        "build_s": 2.0,
        "row_count": 8,
        "pad_ke": 2.5e5,
        "load": None,
    }
    known = {
        name: estimate(Evidence(), name, in_c)
        for name in in_c
        if name not in ("case", "backend")
    }
    noises = {name: each and each.noise for name, each in known.items()}
    assert noises == {
        "slip_mm": pytest.approx(0.006),
        "build_s": None,
        "row_count": 0.0,
        "pad_ke": 0.0,
        "load": None,
    }
    impossible = {"case": "x", "hit_count": 9, "try_count": 8}
    assert estimate(Evidence(), "hit_count", impossible) is None
    problem = report().columns.trials_problem("hit_count", impossible)
    assert problem == "x has hit_count 9, with try_count 8"
    share = {"case": "x", "lifted_count": 3, "trial_count": 8}
    assert estimate(Evidence(), "lifted_count", share).noise == 0.0


def test_measurements_that_agree_are_what_they_say_and_a_mean_says_of_what():
    rows = [{"case": "a", "load": 0.25, "slip_mm": 1.0}]
    others = [{"case": "a", "load": 0.25, "slip_mm": 2.0}]
    found = evidence_of([record(rows), record(others), None])
    same, mean = (estimate(found, name, rows[0]) for name in ("load", "slip_mm"))
    assert (same.value, same.note) == (
        0.25,
        "2 measurements from 0.25 to 0.25",
    ) and same.noise < 1e-6
    assert (mean.value, mean.note) == (
        1.5,
        "mean of 2 measurements from 1 to 2",
    ) and mean.samples == [1.0, 2.0, None]


def test_a_count_that_varies_elsewhere_is_not_exact_if_it_was_measured_once():
    """Test counts of 16 and 26, and of 8 and 8, beside one measurement of each."""
    several = [
        record([{"case": "a", "row_count": a}, {"case": "b", "row_count": 8}])
        for a in (16, 26)
    ]
    once = [
        record([{"case": case, "row_count": 20} for case in "abc"]),
    ]
    evidence = body(a=several, b=once).sections["b", "toy"]
    noise = {
        row["case"]: estimate(evidence, "row_count", row).noise for row in once[0].rows
    }
    assert noise["a"] > 10, "one of two measurements differs by 10"
    assert noise["b"] == noise["c"] == 0


def test_nothing_at_all_has_no_noise_where_all_measurements_say_so():
    one, two = (
        record(
            [{"case": "zero", "drift_mm_s": 0.0}, {"case": "a", "drift_mm_s": drift}]
        )
        for drift in (1, 1.1)
    )
    zero, *_ = one.rows
    assert estimate(evidence_of([one, two]), "drift_mm_s", zero).noise == 0.0


def test_an_engine_that_repeats_has_nothing_of_the_noise_of_one_that_does_not():
    chance = np.random.default_rng(1)
    truths = np.full(ROWS, 2.0)
    quiet = measured(truths, np.full(ROWS, 0.001), 3, chance)
    loud = measured(truths, np.full(ROWS, 1.0), 3, chance)
    both = []
    for a, b in zip(quiet, loud, strict=True):
        warp = [{**row, "backend": "warp"} for row in a.rows]
        vbd = [{**row, "case": f"{row['case']}-v", "backend": "vbd"} for row in b.rows]
        both.append(record([*warp, *vbd]))
    _, noises = known(evidence_of(both), both[0])
    assert max(noises[:ROWS]) < 0.01
    assert min(noises[ROWS:]) > 0.3


def test_times_of_another_kind_of_machine_say_nothing_of_a_time():
    _, [records] = drawn(1, 3, column=TIME)
    strange = [records[0], *(record(each.rows, cpu="another") for each in records[1:])]
    found = evidence_of(strange)
    assert estimate(found, TIME, records[0].rows[0]) is None
    slips = [
        record([{"case": f"c{n}", DRIFT: 1.0 + n + 0.1 * index} for n in range(4)])
        for index, _ in enumerate(strange)
    ]
    slips[1:] = [record(each.rows, cpu="another") for each in slips[1:]]
    assert estimate(evidence_of(slips), DRIFT, slips[0].rows[0]).count == 3


def test_only_costs_in_time_depend_on_the_host():
    names = ("run_us", "run_ms", "heap_bytes", "heap_mb", "step_count")
    schema = Schema(Config(columns=[Columns(names=names, kind="cost")]), {})
    absolute = [evidence.is_absolute(schema[name]) for name in names]
    assert absolute == [True, True, False, False, False]
