"""The lint: what it says of the scene as shipped."""

from experiments.facts.case import AS_SHIPPED
from measured_report.parts.claim import FAILS, Claim, Outcome, all_of, equal_within
from measured_report.parts.section import Section
from measured_report.values.quantities import Quantity, absent
from measured_report.values.results import Results, Row
from report.shared.arithmetic import Column, cell_or_absent, table_of

order = 130
page = "fix"
label = "lint"

ROUNDING, ROUNDED = 1e-5, "the same in single precision"
"""Chosen: up to which share of a number two are the same, and why."""


def derive(results: Results) -> Section:
    shipped = [row for row in results.rows if "rule" in row and row.scene == "as-shipped"]
    table = table_of("rule", [row.rule for row in shipped], COLUMNS, shipped)
    return Section(tables={"as_shipped": table}, claims=[_pads_decide(results, shipped)])


def _pads_decide(results: Results, findings: list[Row]) -> Claim:
    outcomes: list[Outcome] = []
    numbers: dict[str, Quantity] = {}
    for name in ("ke", "kd"):
        wanted = ("priority", "cube", name)
        finding = next((row for row in findings if (row.rule, row.subject, row.parameter) == wanted), None)
        for above, column in ((name, "authored"), (f"{name}_used", "used")):
            numbers[above] = cell_or_absent(finding, column, "1", "the lint does not find it")
        why = f"{name} authored on the pads of as-shipped"
        pads = results.chosen(f"names_the_material_{name}", why, getattr(AS_SHIPPED, f"pad_{name}"))
        used, noise = numbers[f"{name}_used"], ROUNDING * (pads.value or 0.0)
        outcomes.append(equal_within([used, pads], noise=noise, why=ROUNDED) if finding else FAILS)
    return Claim("names_the_material", all_of(*outcomes), numbers)


def _value(row: Row, name: str) -> Quantity:
    """Look up the cell of a column that has one of several units, whichever a row has."""
    lost = absent("1", "it was not kept")
    return next((row[name + unit] for unit in ("", "_m", "_s", "_count") if name + unit in row), lost)


COLUMNS: dict[str, Column] = {
    "of": lambda row: "" if row.rule == "buffer" else row.subject,
    "parameter": "parameter",
    "authored": lambda row: _value(row, "authored"),
    "used": lambda row: _value(row, "used"),
}
