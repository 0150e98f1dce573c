"""Test units, ranges and words of columns, cells that a record must not contain, and
the replicas of a record.
"""

from dataclasses import MISSING, replace

import current_columns as columns
import pytest
from current_columns import (
    Schema,
    column_of,
    is_unit,
    number_problem,
    plain,
    text_problem,
    units_of,
)

from measured_report.files.atomic import RecordError
from measured_report.files.config import Config
from measured_report.files.errors import ReportError
from measured_report.files.settings import Columns
from measured_report.files.units import unlike
from measured_report.records.record import read_record, record_text
from measured_report.records.replicas import mismatch

SIGNED = {
    "way_mm": ("mm", 1e10),
    "way_m": ("m", 1e7),
    "way_mm_s": ("mm/s", 1e10),
    "way_m_s": ("m/s", 1e7),
}
SIGNED |= {
    "way_m_s2": ("m/s²", 1e18),
    "turn_mrad_s": ("mrad/s", 1e18),
    "pull_n": ("N", 1e12),
    "ratio": ("1", 1e18),
}
SIGNED |= {"spring_n_m": ("N/m", 1e18), "share_percent": ("%", 1e18)}
SIGNED |= {"pause_us": ("µs", 1e18), "pause_ns": ("ns", 1e18)}
SIGNED |= {"heap_mb": ("MB", 1e18), "heap_gb": ("GB", 1e18)}
UNSIGNED = {
    "way_mm_per_cycle": ("mm/cycle", 1e18),
    "pause_s": ("s", 1e8),
    "pause_ms": ("ms", 1e9),
}
UNSIGNED |= {
    "pause_ms_per_s": ("ms/s", 1e18),
    "turns_per_s": ("1/s", 1e18),
    "tone_hz": ("Hz", 1e4),
}
UNSIGNED |= {
    "load_kg": ("kg", 1e9),
    "load_kg_m3": ("kg/m³", 1e18),
    "heap_bytes": ("B", 1e18),
}


@pytest.mark.parametrize("name", SIGNED | UNSIGNED)
def test_a_unit_says_the_range_that_is_believed_and_whether_there_is_less_than_nothing(
    name,
):
    unit, largest = (SIGNED | UNSIGNED)[name]
    assert column_of(name).unit == column_of(f"{name}_p95").unit == unit
    assert number_problem(name, largest) == number_problem(name, 0) == ""
    assert number_problem(name, largest * 1.001).endswith(
        f"to {largest:g}"
    ) and number_problem(name, float("nan"))
    assert (number_problem(name, -largest) == "") == (
        name in SIGNED
    ) and number_problem(name, -largest * 1.001)


def test_units_that_differ_by_a_prefix_are_of_one_kind():
    for pair in (["ms", "s"], ["mm/s", "m/s"], ["N/m", "N/mm"], ["kPa", "MPa"]):
        assert unlike([pair[0], "K", pair[1]]) == pair
    for units in (
        ["ms", "m"],
        ["m/s", "m/s²"],
        ["min", "h"],
        ["mol", "m"],
        ["mm", "mm"],
        ["kg", "K"],
        ["1", "mm"],
        [],
    ):
        assert unlike(units) == [], units


def test_units_are_combined_from_known_symbols():
    symbols = ("mm/s²", "kN·m", "°C", "%", "dB", "µs", "1/s", "min")
    assert all(map(is_unit, symbols)) and not any(
        map(is_unit, ("furlong", "mm/", "", "s4", "xm"))
    )
    names = {
        "way_of_arm_mm": "way of arm",
        "pause_ms_per_s": "pause",
        "ratio": "ratio",
        "part_count": "part count",
    }
    assert {name: column_of(name).words for name in names} == names


def test_texts_and_cells_have_their_limits_and_a_parameter_counts_where_it_is_not_its_default(
    monkeypatch,
):
    assert text_problem("a" * 4096) == "" and "longer than 4096" in text_problem(
        "a" * 4097
    )
    assert (
        "U+202E" in text_problem("\u202e")
        and columns.name_problem("a\nb")
        and not columns.name_problem("a b")
    )
    assert plain(None, "a") is None and plain(2, "a") == 2
    with pytest.raises(
        ReportError,
        match=r"column a contains \[1.0\]: use numbers, text, True or False",
    ):
        plain([1.0], "a")
    rows = [
        {"case": "a", "on": True, "way_mm": 1},
        {"pull_n": 2.0, "pause_s_reason": "b"},
    ]
    assert units_of(rows) == {"way_mm": "mm", "pull_n": "N", "pause_s": "s"}
    slips = [
        columns.number_of("slip_mm", {"slip_mm": 1.0, "dropped": is_lost})
        for is_lost in (True, False)
    ]
    assert slips == [None, 1.0]
    schema = Schema(Config(), {"mu": 0.5, "gap_mm": 0.0, "name": MISSING})
    assert schema.changed_parameters(
        {"mu": 0.5, "gap_mm": 1.0, "name": "a", "way_mm": 2.0}
    ) == {"gap_mm": 1.0}


WRONG = {
    "way_mm is 100000000000.0, outside of the range -1e": [1.0, 1e11],
    "way_mm is -1000": [1.0, -1e11],
}
WRONG |= {
    "contains values that are not numbers": [1.0, "far"],
    "is null without a way_mm_reason": [1.0, None],
    "": [-1e10, 1e10, None],
}


@pytest.mark.parametrize(("said", "cells"), WRONG.items())
def test_a_column_holds_numbers_of_its_range_in_nine_digits(toy, said, cells):
    rows = [
        {"case": "a", "way_mm": cell, "ratio": 1 / 3, "part_count": 10**10 + 1}
        for cell in cells
    ]
    rows[-1] |= {} if said else {"way_mm_reason": "it fell"}
    content = record_text(toy.record(rows)).encode()
    if not said:
        assert read_record(content, toy.record_path).rows == [
            {**row, "ratio": 0.333333333} for row in rows
        ]
        return
    with pytest.raises(RecordError, match=said):
        read_record(content, toy.record_path)


def test_a_replica_has_nine_in_ten_of_the_numbers(toy):
    tracked = toy.record([{"case": str(n), "way_mm": 1.0} for n in range(10)])
    counts = {10: "", 9: "", 8: "too many of its numbers are missing", 20: ""}
    for count, said in counts.items():
        rows = [
            {"case": str(n), "on": True, **({"way_mm": 2.0} if n < count else {})}
            for n in range(20)
        ]
        assert mismatch(tracked, replace(tracked, rows=rows)) == said


@pytest.mark.parametrize(
    ("column", "possible", "impossible"),
    [("hit_share", (0.0, 0.5, 1.0), (-0.1, 1.1)), ("hit_count", (0, 4), (-1, 5))],
)
def test_a_share_is_at_most_one_and_a_count_at_most_that_of_its_trials(
    column, possible, impossible
):
    trials = Columns(trials="try_count", names=[column])
    schema = Schema(Config(columns=[trials]), {})
    for value in (*possible, *impossible):
        row = {"case": "one", "try_count": 4, column: value}
        is_possible = value in possible
        assert (schema.trials_problem(column, row) == "") == is_possible, value
        assert schema.number_of(column, row) == (value if is_possible else None)
    unknown = {"case": "one", "try_count": 0, column: 9}
    assert schema.trials_problem(column, unknown) == ""
