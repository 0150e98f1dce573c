"""The lint: what it says of the scene as shipped and of the fixed one."""

import pandas as pd

from report.claims import FAILS, HOLDS, Claim
from report.deriving.arithmetic import cell_or_absent
from report.parts import Section, Table
from report.quantities import Quantity, absent
from report.results import Results, Row

order = 130
page = "fix"

SCENES = ("as-shipped", "fixed")
NOT_FOUND = "the lint does not find it"
UNITS = ("", "_m", "_s", "_count")
"""Ends of the columns that hold a finding's values, by unit."""


def derive(results: Results) -> Section:
    findings = [row for row in results.rows if "rule" in row]
    shipped, fixed = ([row for row in findings if row.scene == scene] for scene in SCENES)
    return Section(
        tables={"as_shipped": _table(shipped), "fixed": _table(fixed)},
        claims=[
            _names_the_material(shipped),
            _names_the_gap(shipped),
            _names_the_buffers(shipped),
            _gap_and_buffers_mended(results, fixed),
            _names_the_clamp(fixed),
        ],
    )


def _names_the_material(findings: list[Row]) -> Claim:
    ke, kd = (_find(findings, "priority", "cube", name) for name in ("ke", "kd"))
    return Claim(
        "names_the_material",
        HOLDS if ke and kd else FAILS,
        numbers={
            "ke": _cell(ke, "authored"),
            "kd": _cell(kd, "authored"),
            "ke_used": _cell(ke, "used"),
            "kd_used": _cell(kd, "used"),
        },
    )


def _names_the_gap(findings: list[Row]) -> Claim:
    found = _find(findings, "default-gap", "cube", "gap")
    return Claim(
        "names_the_gap",
        HOLDS if found else FAILS,
        numbers={"gap": _cell(found, "authored_m", "m"), "sum": _cell(found, "used_m", "m")},
    )


def _names_the_buffers(findings: list[Row]) -> Claim:
    sizes = {name: _find(findings, "buffer", name, name) for name in ("contacts", "constraints")}
    numbers = {f"{name}_size": _cell(row, "authored_count") for name, row in sizes.items()}
    numbers |= {f"{name}_peak": _cell(row, "used_count") for name, row in sizes.items()}
    return Claim("names_the_buffers", HOLDS if all(sizes.values()) else FAILS, numbers)


def _gap_and_buffers_mended(results: Results, findings: list[Row]) -> Claim:
    shipped, fixed = (results.row[scene].finding_count for scene in SCENES)
    mended = not any(row.rule in ("default-gap", "buffer") for row in findings)
    return Claim(
        "gap_and_buffers_mended",
        HOLDS if mended else FAILS,
        numbers={"fixed": fixed, "shipped": shipped},
    )


def _names_the_clamp(findings: list[Row]) -> Claim:
    found = next((row for row in findings if row.rule == "timeconst"), None)
    return Claim(
        "fix_is_clamped",
        HOLDS if found else FAILS,
        numbers={"timeconst": _cell(found, "authored_s", "s"), "used": _cell(found, "used_s", "s")},
    )


def _find(findings: list[Row], rule: str, subject: str, parameter: str) -> Row | None:
    wanted = (rule, subject, parameter)
    return next((row for row in findings if (row.rule, row.subject, row.parameter) == wanted), None)


def _cell(finding: Row | None, column: str, unit: str = "1") -> Quantity:
    return cell_or_absent(finding, column, unit, NOT_FOUND)


def _table(findings: list[Row]) -> Table:
    columns = {
        "of": ["" if row.rule == "buffer" else row.subject for row in findings],
        "against": [row.against for row in findings],
        "pairs": [row.pair_count if row.against else None for row in findings],
        "parameter": [row.parameter for row in findings],
        "authored": [_value(row, "authored") for row in findings],
        "used": [_value(row, "used") for row in findings],
    }
    index = pd.Index([row.rule for row in findings], name="rule")
    return Table(pd.DataFrame(columns, index=index, dtype=object))


def _value(row: Row, name: str) -> Quantity:
    return next((row[name + unit] for unit in UNITS if name + unit in row), absent("1", "it was not kept"))
