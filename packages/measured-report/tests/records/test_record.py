"""Test that records and traces are read completely or refused."""

import json
from dataclasses import replace

import numpy as np
import pytest
from current_columns import column_of, number_problem, units_of
from damage import unsealed

from measured_report.files.atomic import RecordError
from measured_report.files.config import report
from measured_report.measuring.run import plausible_row
from measured_report.records import traces
from measured_report.records.record import load_record, trace_path, write_record
from measured_report.records.traces import load_trace, packed


def test_a_record_comes_back_as_it_was_written_and_its_file_keeps_the_contract(toy):
    record, data = load_record(toy.record_path), json.loads(toy.record_path.read_text())
    assert replace(record, traces={}) == toy.record()
    assert record.traces["stiff"].row_count == 2
    assert set(data) == {
        "schema",
        "section",
        "identity",
        "machine",
        "measured",
        "units",
        "traces",
        "rows",
        "seal",
    }
    assert {"code", "config", "packages"} <= set(data["identity"])
    assert (data["schema"], data["units"]) == (1, {"slip_mm": "mm"})
    assert data["rows"][0] == {"case": "soft", "slip_mm": 6.3617, "dropped": False}


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("6.3617", "9.3617"),
        ("A processor", "Another"),
        ('"seal": "', '"seal": "0'),
        ('"\n}', '"}'),
        ("1.5", "1.50"),
    ]
    + [("\n}\n", ',\n "carried": []\n}\n')],
)
def test_a_record_that_was_changed_by_hand_or_has_no_seal_is_damaged(toy, old, new):
    text = toy.record_path.read_text()
    toy.record_path.write_text(text.replace(old, new))
    with pytest.raises(
        RecordError,
        match=r"^newton-1\.4\.0/toy\.json is not a valid record: it was changed after it was sealed$",
    ):
        load_record(toy.record_path)
    toy.record_path.write_text(unsealed(text))
    with pytest.raises(RecordError, match=r"is not a valid record: it has no seal$"):
        load_record(toy.record_path)
    assert toy.state().kind == "damaged"


@pytest.mark.parametrize("number", [float("nan"), float("inf"), np.float32(1.0), [1.0]])
def test_what_is_no_plain_finite_number_is_not_written(toy, number):
    before = toy.record_path.read_bytes()
    with pytest.raises(RecordError, match="newton-1"):
        write_record(
            toy.record_path,
            toy.record([{"case": "soft", "slip_mm": number}], units={"slip_mm": "mm"}),
        )
    assert toy.record_path.read_bytes() == before
    assert not list(toy.record_path.parent.glob(".*"))


def test_a_missing_number_needs_its_reason(toy):
    row = {"case": "soft", "slip_mm": None, "slip_mm_reason": "non-finite in frame 12"}
    write_record(toy.record_path, toy.record([row]))
    assert load_record(toy.record_path).units == {"slip_mm": "mm"}
    del row["slip_mm_reason"]
    with pytest.raises(RecordError, match="slip_mm"):
        write_record(
            toy.record_path, replace(toy.record([row]), units={"slip_mm": "mm"})
        )


@pytest.mark.parametrize(
    ("column", "unit"),
    [
        ("slip_mm", "mm"),
        ("drift_mm_s", "mm/s"),
        ("left_out_x_m_s", "m/s"),
        ("grasp_error_mm_per_cycle", "mm/cycle"),
    ]
    + [
        ("cube_height_m", "m"),
        ("normal_force_n", "N"),
        ("wall_s", "s"),
        ("frame_ms", "ms"),
        ("ms_per_s", "ms/s"),
    ]
    + [
        ("ms_per_s_p95", "ms/s"),
        ("frames_per_s", "1/s"),
        ("shake_frequency_hz", "Hz"),
        ("frame_count", "1"),
    ]
    + [
        ("cube_density_kg_m3", "kg/m³"),
        ("cube_mass_kg", "kg"),
        ("heap_bytes", "B"),
        ("pad_mu", "1"),
    ],
)
def test_a_column_says_its_unit(column, unit):
    assert column_of(column).unit == unit


def test_numbers_have_units_signs_and_reasons():
    rows = [
        {"case": "a", "dropped": True, "slip_mm": 1},
        {"case": "b", "gap_m": None, "gap_m_reason": "none"},
    ]
    assert units_of(rows) == {"slip_mm": "mm", "gap_m": "m"}
    assert (
        number_problem("growth_per_s", -0.003)
        == number_problem("left_out_z_m_s", -0.1)
        == ""
    )
    assert "range 0 to" in number_problem("cycles_per_s", -1.0)
    row = {"case": "freed", "growth_mm": float("nan"), "slip_mm": 6.36, "passes": True}
    assert plausible_row(row, report().columns) == row | {
        "growth_mm": None,
        "growth_mm_reason": "the measurement gave nan",
    }


def test_traces_are_the_same_bytes_for_the_same_numbers_and_go_with_their_cases(toy):
    path = trace_path(toy.record_path, "stiff")
    before = path.read_bytes()
    toy.measure()
    assert path.read_bytes() == before
    assert load_trace(path)["x_mm"].tolist() == [0.0, 0.3]
    write_record(
        toy.record_path,
        toy.record(),
        {"soft": packed(toy.record_path, "soft", {"x_mm": [1.0]})},
    )
    assert [path.name for path in toy.record_path.parent.glob("*.gz")] == [
        "toy.soft.csv.gz"
    ]
    with pytest.raises(RecordError):
        trace_path(toy.record_path, "../soft")


def test_a_trace_has_at_most_so_many_columns_and_cells(toy, monkeypatch):
    """Test that a trace can be as large as each limit, including its header."""

    def trace(width: int, length: int) -> dict[str, list[float]]:
        return {f"x{number}_mm": [0.0] * length for number in range(width)}

    seal, _ = packed(toy.record_path, "stiff", trace(traces.COLUMN_LIMIT, 1))
    assert seal.row_count == 1
    with pytest.raises(RecordError, match="more than 1000 columns"):
        packed(toy.record_path, "stiff", trace(1001, 1))
    monkeypatch.setattr(traces, "CELL_LIMIT", 12)
    packed(toy.record_path, "stiff", trace(3, 3))
    with pytest.raises(RecordError, match="more than 12 cells"):
        packed(toy.record_path, "stiff", trace(3, 4))
