"""What is judged from kept numbers, by hand: when a run passes, what is on a front, and what goes one way only."""

from collections.abc import Callable, Sequence

import numpy as np
import pandas as pd
import pytest

from measured_report.values.results import Results, Row
from report.sections.error_runtime.fronts import front, pareto_front
from report.sections.hold import is_monotonic, seconds_back
from report.sections.stability.passing import explicit_margin, passed, passing

Made = Callable[[Sequence[dict]], list[Row]]


@pytest.fixture
def made(toy) -> Made:
    """Rows as a section sees them, of cells; None is for a number that does not exist."""

    def rows(cells: Sequence[dict]) -> list[Row]:
        whole = []
        for index, row in enumerate(cells):
            reasons = {f"{name}_reason": "it does not exist" for name, value in row.items() if value is None}
            whole.append({"case": str(index), "failure": None} | row | reasons)
        return Results(toy.record(whole), toy.record_path).rows

    return rows


@pytest.fixture
def verdicts(made) -> Callable[..., list[bool | None]]:
    def judge(family: str, *cells: dict) -> list[bool | None]:
        return passing(made([{"family": family, "finite": cell["class"] != "non-finite"} | cell for cell in cells]))

    return judge


def test_steps_pass_near_the_drift_of_the_smallest(verdicts):
    drifts = {1: 2.1, 2: 2.0, 4: 0.5, 8: 0.49, 128: 1.0}
    cells = [{"class": "creeping", "pads": "stiff", "substeps": n, "drift_mm_s": drift} for n, drift in drifts.items()]
    cells.append({"class": "dropped", "pads": "stiff", "substeps": 16, "drift_mm_s": None})
    assert verdicts("steps", *cells) == [False, True, True, False, True, False]


def test_steps_are_judged_by_the_smallest_of_the_same_pads(verdicts):
    cells = [("stiff", 16, 1.0), ("stiff", 32, 1.0), ("as-shipped", 16, 9.0), ("as-shipped", 32, None)]
    columns = ("pads", "substeps", "drift_mm_s")
    kinds = ("creeping", "creeping", "creeping", "dropped")
    rows = [{"class": kind} | dict(zip(columns, cell, strict=True)) for kind, cell in zip(kinds, cells, strict=True)]
    assert verdicts("steps", *rows) == [True, True, False, False]


def test_clamped_cells_pass_near_the_plateau_of_their_step(verdicts):
    cells = [{"class": "creeping", "clamped": True, "substeps": 16, "penetration_mm": d} for d in (1.0, 1.0, 2.1, 0.4)]
    cells += [{"class": kind, "clamped": False, "substeps": 16} for kind in ("dropped", "non-finite")]
    cells += [{"class": "creeping", "clamped": True, "substeps": 32, "penetration_mm": 9.0}]
    cells += [{"class": "dropped", "clamped": True, "substeps": 32, "penetration_mm": None}]
    assert verdicts("ke-critical", *cells) == [True, True, False, False, True, False, True, False]


def test_the_explicit_bound():
    # dt = 0.01: 1e-4 * 1e4 + 0.02 * 100 = 3.
    assert explicit_margin(1e4, 100.0, 0.01) == pytest.approx(0.75)
    # kd = 0: dt² ke = 4 at ke = 4 * 960². With kd = 100: at ke = 4 * 960² - 2 * 960 * 100.
    assert explicit_margin(4 * 960.0**2, 0.0, 1 / 960) == pytest.approx(1.0)
    assert explicit_margin(4 * 960.0**2 - 2 * 960.0 * 100.0, 100.0, 1 / 960) == pytest.approx(1.0)


def test_the_default_kd_passes_as_the_explicit_bound_says(verdicts):
    cells = [(1e6, "creeping"), (1.1e6, "dropped"), (3e6, "dropped"), (9e6, "exploded"), (8e6, "creeping")]
    cells += [(1e1, "dropped")]
    rows = [{"class": kind, "pad_ke": ke, "pad_kd": 100.0, "step_ms": 1e3 / 960} for ke, kind in cells]
    rows.append({"class": "creeping", "pad_ke": 1.1e6, "pad_kd": 100.0, "step_ms": 1e3 / 7680})
    assert verdicts("ke-kd-100", *rows) == [True, False, None, True, False, None, True]


def test_without_the_clamp_failure_has_to_be_found(verdicts):
    kinds = {"off": ("creeping", "exploded"), "direct": ("creeping", "holding")}
    cells = [{"class": kind, "clamp": clamp} for clamp, both in kinds.items() for kind in both]
    assert verdicts("clamp", *cells) == [True, True, False, False]


@pytest.mark.parametrize("family", ["shake", "grip"])
def test_loads_pass_as_friction_says(verdicts, family):
    cells = [(0.89, "creeping"), (0.89, "dropped"), (1.0, "dropped"), (1.11, "dropped"), (1.11, "creeping")]
    cells.append((None, "exploded"))
    expected = [True, False, None, True, False, False]
    assert verdicts(family, *({"class": kind, "load": load} for load, kind in cells)) == expected


def test_without_friction_the_cube_has_to_fall(verdicts):
    cells = [(0.0, "dropped"), (0.0, "holding"), (1.0, "dropped"), (1.0, "non-finite")]
    assert verdicts("friction", *({"class": kind, "pad_mu": mu} for mu, kind in cells)) == [True, False, True, False]


def test_any_mass_passes_that_stays_finite(verdicts):
    assert verdicts("mass", {"class": "dropped"}, {"class": "non-finite"}) == [True, False]


def test_sizes_pass_up_to_a_hundredth_of_the_edge(verdicts):
    depths = [("creeping", 0.39), ("creeping", 0.4), ("dropped", None)]
    cells = [{"class": kind, "cube_edge_mm": 40.0, "penetration_mm": depth} for kind, depth in depths]
    assert verdicts("size", *cells) == [True, False, False]


def test_what_starts_too_deep_passes_up_to_the_speed_of_a_spring(verdicts):
    cells = [("creeping", 5.0), ("creeping", 5.1), ("dropped", 1.0)]
    rows = [{"class": kind, "exit_speed_mm_s": speed, "exit_bound_mm_s": 5.0} for kind, speed in cells]
    assert verdicts("overlap", *rows) == [True, False, False]


def test_a_freed_cube_must_not_gain_energy(verdicts):
    cells = [{"class": "creeping", "freed": False}, {"class": "non-finite", "freed": True}]
    speeds = [(10.0, 10.04), (10.0, 10.06), (0.0, 0.0), (0.0, 0.1)]  # 10² grows by a hundredth at 10.0499
    names = ("freed_speed_first_mm_s", "freed_speed_last_mm_s")
    cells += [{"class": "dropped", "freed": True} | dict(zip(names, pair, strict=True)) for pair in speeds]
    assert verdicts("gravity", *cells) == [True, False, True, False, True, False]


def test_an_overflow_must_name_its_buffer(verdicts):
    said = "the contact buffer overflowed in frame 0"
    cells = [
        {"class": "creeping", "case": "buffers-ample"},
        {"class": "overflow", "case": "buffers-contact-8", "failure": said},
        {"class": "overflow", "case": "buffers-constraint-12", "failure": said},
        {"class": "creeping", "case": "buffers-contact-4"},
    ]
    assert verdicts("buffers", *cells) == [True, True, False, False]


def test_a_long_run_must_not_speed_up(verdicts):
    cells = [("creeping", 1.0, 1.1), ("creeping", 1.0, 1.2), ("dropped", None, None)]
    names = ("class", "increment_first_mm_per_cycle", "increment_last_mm_per_cycle")
    for cell, expected in zip(cells, (True, False, False), strict=True):
        assert verdicts("long", dict(zip(names, cell, strict=True))) == [expected]


def test_what_was_not_measured_is_not_judged(made):
    assert passing([]) == passed([]) == []


def test_a_stable_run_that_lacks_its_number_is_not_judged(verdicts):
    cells = [("creeping", None), ("creeping", 1.0), ("creeping", 2.0)]
    rows = [{"class": kind, "cube_edge_mm": 400.0, "penetration_mm": depth} for kind, depth in cells]
    assert verdicts("size", *rows) == [None, True, True]


def test_steps_of_opposite_drift_or_none_do_not_pass(verdicts):
    cells = [{"class": "creeping", "pads": "stiff", "substeps": n, "drift_mm_s": d} for n, d in ((1, -1.0), (2, 0.0))]
    assert verdicts("steps", *cells, cells[1] | {"substeps": 4}) == [False, False, False]


def test_those_that_pass(made):
    rows = made([{"family": "mass", "class": "", "finite": finite} for finite in (True, False, True)])
    assert passed(rows) == [rows[0], rows[2]]


def test_the_front_is_what_nothing_beats():
    error = np.array([1.0, 2.0, 3.0, 2.0, 4.0, 1.0])
    cost = np.array([9.0, 5.0, 5.0, 5.0, 1.0, 10.0])
    assert pareto_front(error, cost).tolist() == [True, True, False, True, True, False]


def test_fronts_compare_what_is_alike_and_counts(made):
    cells = [("good", 1.0, 2.0, "c", True), ("beaten", 2.0, 3.0, "c", True), ("failed", 0.1, None, "c", False)]
    cells += [("other backend", 4.0, 4.0, "warp", True), ("lost", None, 1.0, "c", True)]
    columns = ("case", "error_mm", "ms_per_s", "backend", "valid")
    rows = made([dict(zip(columns, cell, strict=True)) for cell in cells])
    assert front(rows, "error_mm") == {"good"}
    assert front(rows, "error_mm", ("backend",)) == {"good", "other backend"}
    assert front([], "error_mm") == frozenset()


def frame(x_mm: np.ndarray, z_mm: np.ndarray) -> pd.DataFrame:
    return pd.DataFrame({"time_s": np.arange(len(x_mm)) / 60, "x_mm": x_mm, "y_mm": 0.0 * x_mm, "z_mm": z_mm})


def test_a_creep_is_monotonic_that_goes_one_way_in_every_second():
    seconds = np.arange(241) / 60
    down = -2.0 * seconds
    shaken = 0.5 * np.sin(2 * np.pi * seconds)  # back where it was after every second
    assert is_monotonic(frame(shaken, down))
    back = np.interp(seconds, [0, 3, 4], [0, -6, -4])
    assert not is_monotonic(frame(shaken, back))
    paused = np.interp(seconds, [0, 1, 2, 3, 4], [0, 1, 1, 2, 3])
    assert not is_monotonic(frame(0.0 * seconds, paused))
    assert [seconds_back(frame(0.0 * seconds, down), least) for least in (0.0, 1.9, 2.1)] == [0, 0, 4]
