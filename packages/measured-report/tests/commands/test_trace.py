"""Test the provenance of a number, from the page back to rows, cases and command."""

from measured_report.commands.trace import provenance
from measured_report.findings.editions import editions_of

ROWS = (
    {
        "case": "soft",
        "frame_count": 900,
        "slip_mm": 6.0,
        "slip_mm_p5": 5.9,
        "slip_mm_p95": 6.2,
        "dropped": False,
    },
    {
        "case": "stiff",
        "frame_count": 900,
        "slip_mm": 0.3,
        "pad_ke": 2.5e5,
        "dropped": False,
    },
)


def text(toy, name: str) -> str:
    return provenance(toy.project, editions_of(toy.project), name)


def test_a_value_leads_to_page_rows_settings_and_command(toy):
    toy.measure(ROWS)
    toy.build()
    lines = [line.strip() for line in text(toy, "toy.gain").splitlines()]
    assert lines[0] == "toy.gain: 20 (20.0), noise unknown", "stiff has no percentiles"
    for line in (
        "formula     soft over stiff",
        "printed on  cause.html#toy",
        "decides     toy.helps: holds",
        "from newton-1.4.0/toy.json",
        "row 1, case stiff (the scene as shipped, except pad_ke 250000.0): slip_mm = 0.30 mm (0.3), noise unknown",
        "measured on A processor, 2026-01-02 03:04 UTC, newton 1.4.0, commit abc",
        "repeat with make rerun SECTION=toy DEVICE=cpu",
    ):
        assert line in lines
    assert any(
        line.startswith("row 0, case soft (the scene as shipped): ")
        and ", noise 0." in line
        for line in lines
    )


def test_a_number_is_found_by_its_pointer_and_by_section_case_and_column(toy):
    toy.build()
    pointed, of_row = (
        text(toy, "newton-1.4.0/toy.json#/rows/1/slip_mm"),
        text(toy, "toy.stiff.slip_mm"),
    )
    assert "printed on  cause.html#toy-way" in pointed, "in the caption of a figure"
    assert "row 1, case stiff" in pointed
    assert (
        text(toy, "values.json#/toy/gain").partition(": ")[2]
        == text(toy, "toy.gain").partition(": ")[2]
    )
    assert of_row.startswith("toy.stiff.slip_mm: 0.31 mm (0.3124)")
    assert of_row.splitlines()[1:] == pointed.splitlines()[1:]
