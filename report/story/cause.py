"""List the suspects: their changes, the slips, and the reasons why they are not the cause."""

from markupsafe import Markup

from measured_report.findings.chapters import Chapters
from report.sections.gap import CASES
from report.sections.priority import CUBE
from report.sections.stiffness import FIX, HARDEST
from report.shared import HOLDS, Quantity, Row, Section, table_of

SUSPECTS = {  # the change, its section and cases, and the claim that excludes it with a reason
    "friction": (
        "of pads and cube, lower and higher",
        "friction",
        (),
        "not_the_cause",
        "the grip needs little friction",
    ),
    "contact points": (
        "their rate, the pads' shape, the engine",
        "contact_source",
        (),
        "not_the_cause",
        "the slip hardly changes",
    ),
    "solver": (
        "iterations, tolerance, cone, step",
        "solver",
        (),
        "solver_has_converged",
        "it has converged",
    ),
    "contact gap": (
        "from none to wide",
        "gap",
        CASES,
        "same_contacts_carry",
        "the contacts that it adds carry no force",
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
        "stiffer contacts drift more",
    ),
    "load alone": (
        "the arm held still",
        "hold",
        ("hold",),
        "drift_needs_cycle",
        "without the shake there is no comparable drift",
    ),
    "pads' ke and kd": ("both raised", "stiffness", (FIX,), "", ""),
}


def derive(chapters: Chapters) -> Section:
    """Make the table of suspects.

    A suspect without cases has all cases that its section compares with a baseline.
    """
    names = []
    columns: dict[str, list] = {
        "changed": [],
        "slip": [],
        "drift": [],
        "why it is not the cause": [],
    }
    for name, (changed, section, cases, claim, why) in SUSPECTS.items():
        if section not in chapters:
            continue
        results = chapters[section].results
        compared = [value.removesuffix("_difference") for value in results.derived]
        rows = [row for row in results.rows if row.case in (cases or compared)]
        if all(row.slip_mm.value is None for row in rows):
            continue
        claims = chapters[section].section.claims
        holds = {test.name: test.outcome == HOLDS for test in claims}
        if not claim:
            why = "it is the cause" if holds.get("together_they_hold") else ""
        elif not (holds.get(claim) and holds.get("not_the_cause", True)):
            why = ""
        names.append(name)
        columns["changed"].append(changed)
        columns["slip"].append(_ends(rows, "slip_mm"))
        columns["drift"].append(_ends(rows, "drift_mm_s"))
        columns["why it is not the cause"].append(why)
    return Section(tables={"suspects": table_of("suspect", names, columns)})


def _ends(rows: list[Row], column: str) -> Quantity | Markup | str:
    """Return one number, or the smallest and the largest if they are printed differently."""
    cells = [row[column] for row in rows if row[column].value is not None]
    if not cells:
        return ""
    low = min(cells, key=lambda cell: cell.number)
    high = max(cells, key=lambda cell: cell.number)
    if low is high or low.written == high.written:
        return low
    return Markup("{} to {}").format(low.bare, high.bare)
