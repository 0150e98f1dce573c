"""The suspects, one at a time: what was changed, what the cube then does, and why it is not that."""

from markupsafe import Markup

from measured_report.findings.chapters import Chapters
from report.sections.gap import CASES
from report.sections.priority import CUBE
from report.sections.stiffness import FIX, HARDEST
from report.shared import HOLDS, Quantity, Row, Section, table_of

SUSPECTS = {  # what was changed; section, cases, and the claim by which it is not that, in words
    "friction": (
        "of pads and cube, less and more",
        "friction",
        (),
        "not_the_cause",
        "the grip needs little of it",
    ),
    "contact points": (
        "how often, of which shapes, by whom",
        "contact_source",
        (),
        "not_the_cause",
        "all slip alike",
    ),
    "solver": (
        "iterations, tolerance, cone, step",
        "solver",
        (),
        "solver_has_converged",
        "it has converged",
    ),
    "contact gap": (
        "none to wide",
        "gap",
        CASES,
        "same_contacts_carry",
        "what it adds carries nothing",
    ),
    "the cube's ke": (
        "softer and stiffer",
        "priority",
        CUBE,
        "cube_does_not_count",
        "the pads have priority",
    ),
    "soft contacts": (
        "dmax raised",
        "stiffness",
        (HARDEST,),
        "not_creep_under_load",
        "stiffer ones drift no less",
    ),
    "load alone": (
        "the arm held still",
        "hold",
        ("hold",),
        "drift_needs_cycle",
        "it takes the shake",
    ),
    "pads' ke and kd": ("both raised", "stiffness", (FIX,), "", ""),
}


def derive(chapters: Chapters) -> Section:
    """Make the table of suspects.

    Where a suspect names no cases, they are those compared with a baseline.
    """
    names = []
    columns: dict[str, list] = {"changed": [], "slip": [], "drift": [], "why not": []}
    for name, (changed, section, cases, claim, why) in SUSPECTS.items():
        if section not in chapters:
            continue
        results = chapters[section].results
        compared = [each.removesuffix("_difference") for each in results.derived]
        rows = [row for row in results.rows if row.case in (cases or compared)]
        if all(row.slip_mm.value is None for row in rows):
            continue
        claims = chapters[section].section.claims
        held = {each.name: each.outcome == HOLDS for each in claims}
        if not claim:
            why = "it is this" if held.get("together_they_hold") else ""
        elif not (held.get(claim) and held.get("not_the_cause", True)):
            why = ""
        names.append(name)
        columns["changed"].append(changed)
        columns["slip"].append(_ends(rows, "slip_mm"))
        columns["drift"].append(_ends(rows, "drift_mm_s"))
        columns["why not"].append(why)
    return Section(tables={"suspects": table_of("suspect", names, columns)})


def _ends(rows: list[Row], column: str) -> Quantity | Markup | str:
    """Write one number, or the least and the largest if these do not read the same."""
    cells = [row[column] for row in rows if row[column].value is not None]
    if not cells:
        return ""
    low = min(cells, key=lambda cell: cell.number)
    high = max(cells, key=lambda cell: cell.number)
    if low is high or low.written == high.written:
        return low
    return Markup("{} to {}").format(low.bare, high.bare)
