"""The provenance of a number, from the page back to rows, cases and command."""

import pytest

from measured_report.commands.trace import Provenance
from measured_report.files.errors import UsageError
from measured_report.pages.editions import editions_of
from measured_report.pages.prose import Templates
from measured_report.records.columns import changed_parameters

ROWS = (
    {"case": "soft", "frame_count": 900, "slip_mm": 6.0, "slip_mm_p5": 5.9, "slip_mm_p95": 6.2, "dropped": False},
    {"case": "stiff", "frame_count": 900, "slip_mm": 0.3, "pad_ke": 2.5e5, "dropped": False},
)


def provenance(toy) -> Provenance:
    templates = Templates(toy.project.templates)
    return Provenance(toy.project, editions_of(toy.project, templates), templates)


def test_a_value_leads_to_page_rows_settings_and_command(toy):
    toy.measure(ROWS)
    lines = [line.strip() for line in provenance(toy).text("toy.gain").splitlines()]
    assert lines[0].startswith("toy.gain: 20") and lines[0].endswith("(20.0)")
    for line in (
        "is          soft over stiff",
        "printed at  evidence.html#toy",
        "decides     toy.helps: holds",
        "from newton-1.4.0/toy.json",
        "row 0, case soft",
        "the scene as shipped",
        "row 1, case stiff",
        "the scene as shipped, but for pad_ke 250000.0",
        "measured on A processor, 2026-01-02 03:04 UTC, newton 1.4.0, commit abc",
        "again by    make rerun SECTION=toy DEVICE=cpu",
    ):
        assert line in lines
    assert any(line.startswith("slip_mm = 6.0 mm, noise") and line.endswith("(its frames)") for line in lines)
    assert "noise       not known, by that of what it is made of" in lines, "stiff has no percentiles"


def test_a_number_is_found_by_its_pointer_and_by_section_case_and_column(toy):
    text = provenance(toy).text
    pointed, of_row = text("newton-1.4.0/toy.json#/rows/1/slip_mm"), text("toy.stiff.slip_mm")
    assert "printed at  evidence.html#toy-way" in pointed, "in the caption of a figure"
    assert "row 1, case stiff" in pointed
    assert text("values.json#/toy/gain").partition(": ")[2] == text("toy.gain").partition(": ")[2]
    assert of_row.startswith("toy.stiff.slip_mm: 0.31 mm (0.3124)")
    assert of_row.splitlines()[1:] == pointed.splitlines()[1:]


@pytest.mark.parametrize(
    ("names", "near"),
    [
        (["toy.gian", "toy", "toi.gain", "other.gain"], r"toy\.gain"),
        (
            ["toy.stif.slip_mm", "toy.stiff.slip", "tpy.stiff.slip_mm", "toy.stiff.slip_mm_reason"],
            r"toy\.stiff\.slip_mm",
        ),
    ],
)
def test_an_unknown_value_names_those_near_it_in_one_line(toy, names, near):
    for name in names:
        with pytest.raises(UsageError, match=f"near it: .*{near}") as refused:
            provenance(toy).text(name)
        assert "\n" not in str(refused.value)


@pytest.mark.parametrize(
    "name", ["toy.stiff.dropped", "newton-1.4.0/toy.json#/rows/1/dropped", "newton-1.4.0/toy.json#/rows/7/slip_mm"]
)
def test_what_is_no_number_has_no_way(toy, name):
    with pytest.raises(UsageError, match="is no value of newton"):
        provenance(toy).text(name)


def test_what_differs_from_the_scene_as_shipped():
    row = {"case": "x", "backend": "warp", "cube_gap_m": 0.1, "shake_amplitude_m": 0.0, "slip_mm": 1.0}
    assert changed_parameters(row) == {"shake_amplitude_m": 0.0}
