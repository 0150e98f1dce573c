"""Measure it yourself: what the engine in the page is held against, and what Newton's model for MuJoCo C loses."""

from measured_report.parts.claim import Claim, all_of, at_most, decided
from measured_report.parts.section import Section
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results
from report.shared.arithmetic import by_case, cell_or_absent

order = 26
page = "lab"
label = "measure it"
labels = {
    "as-shipped": "shipped pads",
    "as-shipped-10cm": "shipped pads, 10 cm",
    "stiff-pads-10cm": "stiff pads, 10 cm",
    "term": "term put back",
    "whole-cure": "the whole cure",
    "cone-pyramidal": "pyramidal cone",
    "hold": "arm held still",
}

COLUMNS = {"slip": "slip_mm", "drift": "drift_mm_s", "friction used": "cone_use", "class": "class"}
MIDPHASE = "impratio-1-midphase"
NEARBY = "as-shipped-nearby"


def derive(results: Results) -> Section:
    shown = [row for row in results.rows if "slip_mm" in row and row.case not in (MIDPHASE, NEARBY)]
    return Section(tables={"runs": by_case(shown, COLUMNS)}, claims=[_repeats(results), _loses_contacts(results)])


def _repeats(results: Results) -> Claim:
    slips = [_cell(results, case, "slip_mm", "mm") for case in ("as-shipped", NEARBY)]
    formula = "slip as shipped, less that of a start hardly aside, in size"
    apart = results.value("apart", formula, lambda a, b: abs(a - b), *slips, unit="mm", is_noise=True)
    offset = results.value(
        "offset", "in µm", lambda m: 1e6 * m, _cell(results, NEARBY, "cube_offset_m", "m"), unit="µm"
    )
    outcome = at_most(apart, 0.001, why="a slip is written in µm")
    return Claim("repeats", outcome, {"apart": apart, "offset": offset})


def _loses_contacts(results: Results) -> Claim:
    off, on = results.row["impratio-1"], results.row[MIDPHASE]
    slip = _cell(results, "impratio-1", "slip_mm", "mm")
    kept, lost = decided(bool(off) and not off.dropped, slip), decided(bool(on) and on.dropped, slip)
    return Claim("loses_contacts", all_of(kept, lost))


def _cell(results: Results, case: str, column: str, unit: str) -> Quantity:
    return cell_or_absent(results.row[case], column, unit)
