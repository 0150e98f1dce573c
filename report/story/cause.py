"""The suspects, one at a time: what was changed, what the cube then does, and why it is not that."""

from collections.abc import Sequence

from markupsafe import Markup

from measured_report.findings.chapters import Chapters
from report.sections.gap import CASES
from report.sections.priority import CUBE
from report.sections.stiffness import FIX, HARDEST
from report.shared import HOLDS, Quantity, Row, Section, Sections, table_of

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

COLUMNS = {"slip": "slip_mm", "drift": "drift_mm_s"}


def derive(chapters: Chapters) -> Section:
    """Derive the table; of a section with no cases named it has those that are compared with a baseline."""
    sections, lines = (
        Sections({name: chapter.results for name, chapter in chapters.items()}),
        [],
    )
    for name, (changed, section, cases, claim, why) in SUSPECTS.items():
        results, rows = sections.results.get(section), list[Row]()
        if results:
            compared = {name.removesuffix("_difference") for name in results.derived}
            rows = [row for row in results.rows if row.case in (cases or compared)]
        if any(row.slip_mm.value is not None for row in rows):
            held = {
                each.name: each.outcome == HOLDS
                for each in chapters[section].section.claims
            }
            is_out = held.get(claim) and held.get("not_the_cause", True)
            reason = (
                why
                if is_out
                else "it is this"
                if not claim and held.get("together_they_hold")
                else ""
            )
            lines.append(
                (
                    name,
                    changed,
                    *(_ends(rows, column) for column in COLUMNS.values()),
                    reason,
                )
            )
    names, *cells = zip(*lines, strict=True) if lines else ([] for _ in range(5))
    columns = dict(zip(("changed", *COLUMNS, "why not"), cells, strict=True))
    return Section(tables={"suspects": table_of("suspect", names, columns)})


def _ends(rows: Sequence[Row], column: str) -> Quantity | Markup | str:
    """Write one number, or the least and the largest of several where these do not read the same."""
    cells = [row[column] for row in rows if row[column].value is not None]
    low, high = (
        choose(cells, key=lambda cell: cell.number, default=None)
        for choose in (min, max)
    )
    return (
        (low or "")
        if low is high or low.written == high.written
        else Markup("{} to {}").format(low.bare, high.bare)
    )
