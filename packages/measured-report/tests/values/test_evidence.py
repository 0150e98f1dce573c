"""Evidence: what measurements say of a number, drawn from a truth with parts of hosts, processes and runs."""

from dataclasses import replace

import numpy as np
import pytest

pytest.importorskip("scipy", reason="the extra test has it")

from scipy import stats
from toys import BY_HAND, lay_out

from measured_report.files.config import report, report_in
from measured_report.files.errors import ReportError
from measured_report.records.record import Record
from measured_report.values import cells, evidence
from measured_report.values.evidence import MEAN, Evidence
from measured_report.values.noise import Estimate

BASE = Record(
    **{**BY_HAND, "section": "toy", "identity": None, "units": {}, "rows": []}
)
ROWS = 40
SETTINGS = """
edition = "numpy"
case = "experiments.scene:Case"
repeating = { backend = ["c"] }
pages = [{ name = "index", texts = [] }]
columns = [
    { kind = "cost", pattern = "frame_(ms|ratio)(_p[0-9]+)?|ratio_resolution|frames_per_s|build_s" },
    { trials = "try_count", names = ["hit_count"] },
    { rate_of = "frame_ms", pattern = "frames_per_s" },
    { known_within = "ratio_resolution", pattern = "frame_ratio" },
    { grows_with = "shake_duration_s", resolution = 1e-3, pattern = "slip_mm" },
    { resolution = 1e-4, pattern = "drift_mm_s" },
]
"""


@pytest.fixture(scope="module", autouse=True)
def columns(entered, tmp_path_factory):
    """A report in which columns say how their numbers scatter."""
    lay_out(folder := tmp_path_factory.mktemp("columns"))
    (folder / "report.toml").write_text(SETTINGS)
    with report_in(folder):
        yield


def evidence_of(records: list[Record | None], repeats: evidence.Repeated) -> Evidence:
    """The evidence of one section."""
    return cells.evidence_of({"toy": records}, repeats, report().columns)["toy"]


def repeats_of(rows: list[dict]) -> evidence.Repeated:
    return evidence.repeats_of(rows, report().columns)


def key_of(row: dict) -> evidence.Key:
    return evidence.key_of(row, report().columns)


def estimate(of: Evidence, name: str, row: dict) -> Estimate | None:
    return of.estimate(name, row, report().columns)


def record(rows: list[dict], **machine: str) -> Record:
    return replace(
        BASE, rows=rows, units={}, traces={}, machine={**BASE.machine, **machine}
    )


def measurements(
    count: int,
    seed: int,
    *,
    host: float = 0.0,
    run: float = 0.01,
    column: str = "drift_mm_s",
) -> tuple[np.ndarray, list[Record], Record]:
    """Return truths, so many measurements of them, and a record of 40 runs of the first, of which two are wild."""
    chance = np.random.default_rng(seed)
    truths = chance.uniform(1.0, 3.0, ROWS)
    deviations = run * np.sqrt(
        8.0 / chance.chisquare(8.0, ROWS)
    )  # each row has a noise of its own
    again = []
    for place in range(count):
        parts = chance.normal(0, host, ROWS) + chance.normal(0, deviations)
        rows = [
            {"case": f"c{row}", column: float(number)}
            for row, number in enumerate(truths + parts)
        ]
        again.append(record(rows, gpu_uuid=f"card {place}"))
    runs = truths[0] + chance.normal(0, run, 40)
    runs[:2] += 50 * run
    return (
        truths,
        again,
        record(
            [
                {"case": f"r{n}", "of": "c", column: float(number)}
                for n, number in enumerate(runs)
            ]
        ),
    )


def known(
    again: list[Record], repeats: Record, column: str = "drift_mm_s"
) -> tuple[np.ndarray, np.ndarray]:
    """Return the values that are printed, and how far the truth may be from each."""
    found = evidence_of(again, repeats_of(repeats.rows))
    estimates = [estimate(found, column, row) for row in again[0].rows]
    return np.array([each.value for each in estimates]), np.array(
        [each.noise for each in estimates]
    )


def test_what_repeats_does_so_whatever_its_unit_and_a_cost_does_not():
    """A limit in ms that an engine computes is no time that was taken: its kind says so, not its unit."""
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


@pytest.mark.parametrize("count", [1, 2, 3, 4, 6])
@pytest.mark.parametrize("host", [0.0, 0.02])
def test_the_truth_is_within_the_noise_as_often_as_it_says(count, host):
    if count == 1 and host:
        pytest.skip("one host says nothing of others")
    within = []
    for seed in range(12):
        truths, again, repeats = measurements(count, seed, host=host)
        values, noises = known(again, repeats)
        within.append(abs(values - truths) <= noises)
    assert 0.90 <= np.mean(within) <= 0.99


def test_the_noise_falls_with_each_measurement():
    falls = []
    for seed in range(12):
        _, again, repeats = measurements(6, seed)
        noises = [known(again[:count], repeats)[1] for count in range(2, 7)]
        falls.append(noises[-1] < noises[0])
    assert np.mean(falls) >= 0.95


def test_one_wild_row_changes_nothing_for_the_others_and_is_said_to_be_at_an_edge():
    _, again, repeats = measurements(4, 3)
    plain = known(again, repeats)
    rows = [*again[-1].rows[:-1], {**again[-1].rows[-1], "drift_mm_s": 9.0}]
    wild = [*again[:-1], replace(again[-1], rows=rows)]
    values, noises = known(wild, repeats)
    assert noises[:-1] == pytest.approx(plain[1][:-1], rel=0.1) and values[
        :-1
    ] == pytest.approx(plain[0][:-1])
    found = evidence_of(wild, repeats_of(repeats.rows))
    assert found.edges == {key_of(rows[-1])} and found.edge_share == pytest.approx(
        1 / (ROWS * 4)
    )
    assert values[-1] < 4.0 < 9.0 <= values[-1] + noises[-1] + 1e-9, (
        "the median, and as far as was seen"
    )


def test_a_run_that_one_measurement_loses_or_words_otherwise_is_at_an_edge():
    _, again, _ = measurements(2, 0)
    lost = [
        {**row, "dropped": place == 3, "end": "b" if place == 5 else "a"}
        for place, row in enumerate(again[1].rows)
    ]
    plain = [{**row, "dropped": False, "end": "a"} for row in again[0].rows]
    found = evidence_of(
        [replace(again[0], rows=plain), replace(again[1], rows=lost)], {}
    )
    assert found.edges == {key_of({"case": "c3"}), key_of({"case": "c5"})}


def test_what_was_measured_once_has_the_noise_of_the_runs_of_one_case_and_larger_numbers_more():
    """Eight runs with a deviation of 0.1: t of 2.3646 makes ±0.236 of a run of that size; of five times that ±1.18."""
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
    """Half of a normal distribution's 90 % is 1.645 deviations; a median of 25 is known to √(π/2)/5 of one."""
    row = {
        "case": "x",
        "frame_ms": 8.0,
        "frame_ms_p5": 7.8,
        "frame_ms_p95": 8.3,
        "repeat_count": 25,
        "frames_per_s": 125.0,
    }
    time = estimate(Evidence(), "frame_ms", row)
    assert time.noise == pytest.approx(
        1.96 * (np.pi / 2) ** 0.5 * 0.5 / 3.2897 / 5, rel=1e-4
    )
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
    with pytest.raises(ReportError, match="x has hit_count 9, with try_count 8"):
        estimate(Evidence(), "hit_count", {"case": "x", "hit_count": 9, "try_count": 8})
    share = {"case": "x", "lifted_count": 3, "trial_count": 8}
    assert estimate(Evidence(), "lifted_count", share).noise == 0.0


def test_measurements_that_agree_are_what_they_say_and_a_mean_says_of_what():
    rows = [{"case": "a", "load": 0.25, "slip_mm": 1.0}]
    others = [{"case": "a", "load": 0.25, "slip_mm": 2.0}]
    found = evidence_of([record(rows), record(others), None], {})
    same, mean = (estimate(found, name, rows[0]) for name in ("load", "slip_mm"))
    assert (same.value, same.note) == (
        0.25,
        "2 measurements from 0.25 to 0.25",
    ) and same.noise < 1e-6
    assert (mean.value, mean.note) == (
        1.5,
        f"{MEAN} 2 measurements from 1 to 2",
    ) and mean.samples == [1.0, 2.0, None]


def test_nothing_at_all_has_no_noise_where_all_measurements_say_so():
    one, two = (
        record(
            [{"case": "zero", "drift_mm_s": 0.0}, {"case": "a", "drift_mm_s": drift}]
        )
        for drift in (1, 1.1)
    )
    zero, *_ = one.rows
    assert estimate(evidence_of([one, two], {}), "drift_mm_s", zero).noise == 0.0


def test_an_engine_that_repeats_has_nothing_of_the_noise_of_one_that_does_not():
    quiet, loud = measurements(3, 1, run=0.001)[1], measurements(3, 2, run=1.0)[1]
    both = [
        record(
            [{**row, "backend": "warp"} for row in a.rows]
            + [{**row, "case": f"{row['case']}-v", "backend": "vbd"} for row in b.rows]
        )
        for a, b in zip(quiet, loud, strict=True)
    ]
    found = evidence_of(both, {})
    noises = [
        estimate(found, "drift_mm_s", both[0].rows[place]).noise for place in (9, 49)
    ]
    assert noises[0] < 0.01 < 0.3 < noises[1]


def test_times_stand_beside_those_of_one_kind_of_machine_and_cards_are_known_by_as_many_as_there_are():
    """Cards of 6.066, 6.083 and 6.339 ms have a deviation of 0.1529 ms: ±0.380 ms of their mean, by t of 4.303."""
    times = (6.066, 6.083, 6.339)
    of_cards = [
        record(
            [{"case": "a", "frame_ms": time}, {"case": "b", "frame_ms": 2 * time}],
            gpu_uuid=f"card {time}",
        )
        for time in times
    ]
    found = estimate(evidence_of(of_cards, {}), "frame_ms", of_cards[0].rows[0])
    assert found.is_of_cards and found.value == pytest.approx(np.mean(times))
    assert found.noise == pytest.approx(
        stats.t.ppf(0.975, 2) * stats.sem(times), rel=0.01
    )
    of_one = [
        replace(each, machine={**each.machine, "gpu_uuid": "one"}) for each in of_cards
    ]
    assert not estimate(
        evidence_of(of_one, {}), "frame_ms", of_one[0].rows[0]
    ).is_of_cards
    strange = [
        of_cards[0],
        *(
            replace(each, machine={**each.machine, "gpu": "another"})
            for each in of_cards[1:]
        ),
    ]
    assert estimate(evidence_of(strange, {}), "frame_ms", of_cards[0].rows[0]) is None
    assert evidence_of(
        [
            replace(each, rows=[{"case": "a", "slip_mm": 1.0 + n}])
            for n, each in enumerate(strange)
        ],
        {},
    ).estimates


def test_sections_tell_each_other_how_far_cards_are_apart():
    """Of four sections, each with two cards of its own, 6 % apart, one knows ±38 %, and ±8.3 % by t of four degrees.

    All on the same two cards know no more than one of them.
    """

    def of_two(apart: float, cards: str = "ab") -> list[Record]:
        times = zip(cards, (10 - apart, 10 + apart), strict=True)
        return [record([frame(time)], gpu_uuid=card) for card, time in times]

    def frame(time: float) -> dict[str, object]:
        return {"case": "a", "frame_ms": time}

    def noises(**sections: list[Record]) -> list[float]:
        found = cells.evidence_of(sections, {}, report().columns)
        frames = [
            estimate(found[section], "frame_ms", frame(10.0)) for section in sections
        ]
        return [each.noise for each in frames if each]

    by_t = [stats.t.ppf(0.975, freedom) for freedom in range(1, 5)]
    [alone] = noises(alone=of_two(0.3))
    assert alone == pytest.approx(by_t[0] * 0.3) == pytest.approx(3.81, rel=1e-3)
    for same in ("a", "abcd"):
        assert noises(**dict.fromkeys(same, of_two(0.3)))[0] == alone
    slips = [record([{"case": "a", "slip_mm": 1.0 + n}]) for n in range(2)]
    unlinked = noises(
        slips=slips, **{cards: of_two(0.3, cards) for cards in ("ab", "cd", "ef", "gh")}
    )
    assert unlinked == pytest.approx([by_t[3] * 0.3] * 4, rel=2e-3)
    linked = noises(**{cards: of_two(0.3, cards) for cards in ("ab", "cd", "bc")})
    assert linked[-1] == pytest.approx(by_t[2] * 0.3, rel=2e-3), "four cards"
    near, far = noises(near=of_two(0.01), far=of_two(0.3, "bc"))
    pooled = ((0.01**2 + 0.3**2) / 2) ** 0.5
    assert near == pytest.approx(by_t[1] * pooled, rel=5e-3), (
        "that these are near may be chance"
    )
    assert far == pytest.approx(by_t[1] * 0.3, rel=5e-3), "it takes its own for no less"
    alike = noises(**{cards: of_two(0.001, cards) for cards in ("ab", "cd")})
    assert alike[0] == pytest.approx(by_t[1] * 0.02 * 10 / 2**0.5, rel=5e-3), (
        "and that four are, too"
    )


def test_each_measurement_left_out_says_how_often_one_of_the_same_is_told_as_changed():
    _, again, _ = measurements(5, 4)
    assert evidence_of(again, {}).changed == [(ROWS, 0)] * 5
    rows = [
        {**row, "drift_mm_s": row["drift_mm_s"] + 0.2 * (place < 8)}
        for place, row in enumerate(again[2].rows)
    ]
    changed = evidence_of(
        [*again[:2], replace(again[2], rows=rows), *again[3:]], {}
    ).changed
    assert changed[2] == (ROWS, 8) and sum(count for _, count in changed) == 8
