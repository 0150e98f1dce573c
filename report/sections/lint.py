"""The lint: what it says of the scene as shipped and of the fixed one."""

import pandas as pd

from report.claims import FAILS, HOLDS, Claim
from report.parts import Section, Table
from report.quantities import Quantity
from report.results import Results, Row

order = 130

SCENES = {"as-shipped": "as shipped", "fixed": "with the fix"}
UNITS = ("", "_m", "_s", "_count")
"""Ends of the columns that hold a finding's values, by unit."""


def derive(results: Results) -> Section:
    findings = [row for row in results.rows if "rule" in row]
    shipped, fixed = ([row for row in findings if row.scene == scene] for scene in SCENES)
    return Section(
        tables={scene: _table(rows, scene) for scene, rows in zip(SCENES, (shipped, fixed), strict=True)},
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
        holds="In the scene as shipped the lint says why the cube's material has no effect on the grasp: its authored "
        "ke {ke} and kd {kd} never reach the solver, which uses the pads' {ke_used} and {kd_used} instead.",
        fails="The lint does not say of the scene as shipped that the cube's authored ke and kd go unused.",
        numbers={"ke": ke.authored, "kd": kd.authored, "ke_used": ke.used, "kd_used": kd.used} if ke and kd else {},
        explanation="It takes the finished model and no simulation to see that: of two geoms with different priority, "
        "only the material of the higher counts, and nothing is said about the other's.",
    )


def _names_the_gap(findings: list[Row]) -> Claim:
    found = _find(findings, "default-gap", "cube", "gap")
    return Claim(
        "names_the_gap",
        HOLDS if found else FAILS,
        holds="It also names the cube's gap, {gap}, which nobody set: with a neighbour's it makes {sum}.",
        fails="It does not name the cube's gap.",
        numbers={"gap": found.authored_m, "sum": found.used_m} if found else {},
    )


def _names_the_buffers(findings: list[Row]) -> Claim:
    sizes = {name: _find(findings, "buffer", name, name) for name in ("contacts", "constraints")}
    there = all(sizes.values())
    numbers = {f"{name}_size": row.authored_count for name, row in sizes.items()} if there else {}
    numbers |= {f"{name}_peak": row.used_count for name, row in sizes.items()} if there else {}
    return Claim(
        "names_the_buffers",
        HOLDS if there else FAILS,
        holds="The buffers have room for {contacts_size} contacts and {constraints_size} constraints in a world that "
        "never had more than {contacts_peak} and {constraints_peak}.",
        fails="It has nothing to say about the buffers for contacts and for constraints.",
        numbers=numbers,
    )


def _gap_and_buffers_mended(results: Results, findings: list[Row]) -> Claim:
    shipped, fixed = (results.row[scene].finding_count for scene in SCENES)
    mended = not any(row.rule in ("default-gap", "buffer") for row in findings)
    return Claim(
        "gap_and_buffers_mended",
        HOLDS if mended else FAILS,
        holds="In the fixed scene gap and buffers are in order. Findings: {fixed}, as shipped {shipped}.",
        fails="In the fixed scene gap or buffers are still not in order. Findings: {fixed}, as shipped {shipped}.",
        numbers={"fixed": fixed, "shipped": shipped},
        explanation="What the cube and the ground say about their material still goes unused, because the pads keep "
        "their priority. The fix does not change that; it gives the pads, which decide, a material to decide with.",
    )


def _names_the_clamp(findings: list[Row]) -> Claim:
    found = next((row for row in findings if row.rule == "timeconst"), None)
    return Claim(
        "fix_is_clamped",
        HOLDS if found else FAILS,
        holds="The pads' timeconst in the fixed scene, {timeconst}, is shorter than the engine allows: it clamps it to "
        "two substeps, {used}.",
        fails="No timeconst in the fixed scene is below the two substeps that the engine would clamp it to.",
        numbers={"timeconst": found.authored_s, "used": found.used_s} if found else {},
        explanation="At this step a larger kd changes nothing.",
    )


def _find(findings: list[Row], rule: str, subject: str, parameter: str) -> Row | None:
    wanted = (rule, subject, parameter)
    return next((row for row in findings if (row.rule, row.subject, row.parameter) == wanted), None)


def _table(findings: list[Row], scene: str) -> Table:
    columns = {
        "of": ["" if row.rule == "buffer" else row.subject for row in findings],
        "against": [row.against for row in findings],
        "pairs": [row.pair_count if row.against else None for row in findings],
        "parameter": [row.parameter for row in findings],
        "authored": [_value(row, "authored") for row in findings],
        "used": [_value(row, "used") for row in findings],
    }
    index = pd.Index([row.rule for row in findings], name="rule")
    frame = pd.DataFrame(columns, index=index, dtype=object)
    return Table(frame, f"What the lint says of the scene {SCENES[scene]}.")


def _value(row: Row, name: str) -> Quantity:
    return next(row[name + unit] for unit in UNITS if name + unit in row)
