"""The lint: what it says of the scene as shipped and of the fixed one."""

import pandas as pd

from experiments.facts.case import AS_SHIPPED, STIFF_PADS, Case
from measured_report.claims.claims import FAILS, Claim, Outcome, all_of, at_least, decided, equal_within, greater
from measured_report.parts.parts import Section, Table
from measured_report.values.quantities import Quantity, absent
from measured_report.values.results import Results, Row
from report.shared.arithmetic import cell_or_absent

order = 130
page = "fix"
label = "lint"

SCENES = ("as-shipped", "fixed")
NOT_FOUND = "the lint does not find it"
UNITS = ("", "_m", "_s", "_count")
"""Ends of the columns that hold a finding's values, by unit."""
ROUNDING = 1e-5
"""Chosen: up to this share of a number two are the same in single precision."""
MATERIAL = ("ke", "kd")
MENDED = ("default-gap", "buffer")
"""Rules of which nothing is found in the fixed scene."""


def derive(results: Results) -> Section:
    findings = [row for row in results.rows if "rule" in row]
    shipped, fixed = ([row for row in findings if row.scene == scene] for scene in SCENES)
    return Section(
        tables={"as_shipped": _table(shipped), "fixed": _table(fixed)},
        claims=[
            _pads_decide(results, "names_the_material", shipped, AS_SHIPPED),
            _names_the_gap(results, shipped),
            _names_the_buffers(results, shipped),
            _gap_and_buffers_mended(results, shipped, fixed),
            _pads_decide(results, "material_still_unused", fixed, STIFF_PADS),
            _names_the_clamp(results, fixed),
        ],
    )


def _pads_decide(results: Results, claim: str, findings: list[Row], case: Case) -> Claim:
    """Whether the lint says that ke and kd of the cube go unused, and the pads' of that case are used instead."""
    found = {name: _find(findings, "priority", "cube", name) for name in MATERIAL}
    outcomes = []
    for name, finding in found.items():
        pads = results.chosen(
            f"{claim}_{name}", f"{name} authored on the pads of {case.name}", getattr(case, f"pad_{name}")
        )
        outcomes.append(_named(finding) or _same(results, f"{claim}_{name}", _cell(finding, "used"), pads))
    numbers = {name: _cell(finding, "authored") for name, finding in found.items()}
    numbers |= {f"{name}_used": _cell(finding, "used") for name, finding in found.items()}
    return Claim(claim, all_of(*outcomes), numbers)


def _names_the_gap(results: Results, findings: list[Row]) -> Claim:
    found = _find(findings, "default-gap", "cube", "gap")
    gap, total = _cell(found, "authored_m", "m"), _cell(found, "used_m", "m")
    expected = results.value(
        "gap_sum",
        "gap of the cube, and the larger one of those authored on fingers and ground",
        lambda cube: cube + max(AS_SHIPPED.robot_gap_m, AS_SHIPPED.ground_gap_m),
        gap,
        unit="m",
    )
    outcome = _named(found) or _same(results, "gap_sum", total, expected)
    return Claim("names_the_gap", outcome, numbers={"gap": gap, "sum": total})


def _same(results: Results, name: str, found: Quantity, expected: Quantity) -> Outcome:
    rounding = results.chosen(
        f"{name}_rounding", "the same in single precision", ROUNDING * (expected.value or 0.0), unit=found.unit
    )
    return equal_within([found, expected], noise=rounding)


def _names_the_buffers(results: Results, findings: list[Row]) -> Claim:
    bound = results.chosen("room_bound", "many times what is needed", 4.0)
    numbers: dict[str, Quantity] = {"bound": bound}
    outcomes = []
    for name in ("contacts", "constraints"):
        finding = _find(findings, "buffer", name, name)
        size, peak = _cell(finding, "authored_count"), _cell(finding, "used_count")
        formula = f"how many times the most {name} that a world had there is room for"
        room = results.value(f"{name}_room", formula, lambda room, most: room // most, size, peak)
        outcomes.append(_named(finding) or at_least(room, bound))
        numbers |= {f"{name}_size": size, f"{name}_peak": peak, f"{name}_room": room}
    return Claim("names_the_buffers", all_of(*outcomes), numbers)


def _gap_and_buffers_mended(results: Results, shipped: list[Row], fixed: list[Row]) -> Claim:
    """Whether gap and buffers are named as shipped and not in the fixed scene; a list that lost rows can't tell."""
    counts = [results.row[scene].finding_count for scene in SCENES]
    named, still = ({row.rule for row in findings} & set(MENDED) for findings in (shipped, fixed))
    outcome = decided(named == set(MENDED) and not still, *counts)
    if any(count.value != len(findings) for count, findings in zip(counts, (shipped, fixed), strict=True)):
        outcome = Outcome("unknown", "the list of findings is not whole").having_read(*counts)
    return Claim("gap_and_buffers_mended", outcome)


def _names_the_clamp(results: Results, findings: list[Row]) -> Claim:
    found = next((row for row in findings if row.rule == "timeconst"), None)
    timeconst, used = _cell(found, "authored_s", "s"), _cell(found, "used_s", "s")
    rounding = results.chosen(
        "timeconst_rounding", "the same in single precision", ROUNDING * (timeconst.value or 0.0), unit="s"
    )
    kd = results.chosen("fix_kd", "kd authored on the pads with the fix", STIFF_PADS.pad_kd)
    limit = results.value("clamped_kd", "kd of which two substeps are the timeconst, 2 / kd", lambda a: 2 / a, used)
    outcome = _named(found) or all_of(greater(used, timeconst, noise=rounding), at_least(kd, limit))
    numbers = {"timeconst": timeconst, "used": used, "kd": kd, "limit": limit}
    return Claim("fix_is_clamped", outcome, numbers=numbers)


def _named(finding: Row | None) -> Outcome | None:
    """What is not named at all fails."""
    return None if finding else FAILS


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
