"""The lint: what it says of the scene as shipped and of the fixed one."""

from experiments.facts.case import AS_SHIPPED, STIFF_PADS, Case
from measured_report.parts.claim import FAILS, Claim, Outcome, all_of, at_least, decided, equal_within, greater
from measured_report.parts.section import Section
from measured_report.values.quantities import Quantity, absent
from measured_report.values.results import Results, Row
from report.shared.arithmetic import Column, cell_or_absent, table_of

order = 130
page = "fix"
label = "lint"

SCENES = ("as-shipped", "fixed")
ROUNDING, ROUNDED = 1e-5, "the same in single precision"
"""Chosen: up to which share of a number two are the same, and why."""
MENDED = ("default-gap", "buffer")
"""Rules of which nothing is found in the fixed scene."""


def derive(results: Results) -> Section:
    findings = [row for row in results.rows if "rule" in row]
    shipped, fixed = ([row for row in findings if row.scene == scene] for scene in SCENES)
    return Section(
        tables={"as_shipped": table_of("rule", [row.rule for row in shipped], COLUMNS, shipped)},
        claims=[
            _pads_decide(results, "names_the_material", shipped, AS_SHIPPED),
            _gap_and_buffers_mended(results, shipped, fixed),
            _names_the_clamp(results, fixed),
        ],
    )


def _pads_decide(results: Results, claim: str, findings: list[Row], case: Case) -> Claim:
    outcomes: list[Outcome] = []
    numbers: dict[str, Quantity] = {}
    for name in ("ke", "kd"):
        finding = _find(findings, "priority", "cube", name)
        numbers |= {name: _cell(finding, "authored"), f"{name}_used": _cell(finding, "used")}
        why = f"{name} authored on the pads of {case.name}"
        pads = results.chosen(f"{claim}_{name}", why, getattr(case, f"pad_{name}"))
        outcomes.append(_same(numbers[f"{name}_used"], pads) if finding else FAILS)
    return Claim(claim, all_of(*outcomes), numbers)


def _same(found: Quantity, expected: Quantity) -> Outcome:
    return equal_within([found, expected], noise=ROUNDING * (expected.value or 0.0), why=ROUNDED)


def _gap_and_buffers_mended(results: Results, shipped: list[Row], fixed: list[Row]) -> Claim:
    """Tell whether only the scene as shipped has them; a list that lost rows can't tell."""
    counts = [results.row[scene].finding_count for scene in SCENES]
    named, still = ({row.rule for row in findings} & set(MENDED) for findings in (shipped, fixed))
    outcome = decided(named == set(MENDED) and not still, *counts)
    if any(count.value != len(findings) for count, findings in zip(counts, (shipped, fixed), strict=True)):
        outcome = Outcome("unknown", "the list of findings is not whole").having_read(*counts)
    return Claim("gap_and_buffers_mended", outcome)


def _names_the_clamp(results: Results, findings: list[Row]) -> Claim:
    found = next((row for row in findings if row.rule == "timeconst"), None)
    timeconst, used = _cell(found, "authored_s", "s"), _cell(found, "used_s", "s")
    kd = results.chosen("fix_kd", "kd authored on the pads with the fix", STIFF_PADS.pad_kd)
    limit = results.value("clamped_kd", "kd of which two substeps are the timeconst, 2 / kd", lambda a: 2 / a, used)
    is_longer = greater(used, timeconst, noise=ROUNDING * (timeconst.value or 0.0), why=ROUNDED)
    outcome = all_of(is_longer, at_least(kd, limit)) if found else FAILS
    return Claim("fix_is_clamped", outcome, {"timeconst": timeconst, "used": used, "kd": kd, "limit": limit})


def _find(findings: list[Row], rule: str, subject: str, parameter: str) -> Row | None:
    wanted = (rule, subject, parameter)
    return next((row for row in findings if (row.rule, row.subject, row.parameter) == wanted), None)


def _cell(finding: Row | None, column: str, unit: str = "1") -> Quantity:
    return cell_or_absent(finding, column, unit, "the lint does not find it")


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
