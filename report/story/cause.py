"""List and draw the suspects: their slips, and why they are not the cause."""

from dataclasses import dataclass
from typing import Any

from markupsafe import Markup

from measured_report.findings.chapters import Chapter, Chapters
from report.sections.gap import CASES
from report.sections.priority import CUBE
from report.sections.stiffness import FIX, HARDEST
from report.shared import HOLDS, Figure, Quantity, Row, Section, table_of
from report.shared.drawing import (
    INK,
    SHIPPED,
    STIFF,
    Drawing,
    draw_line,
    mark_points,
    name_lines,
    new_figure,
    tick_125,
)

DAMPING = "yes: their kd sets the damping of friction"


@dataclass(frozen=True)
class Suspect:
    """A parameter that may cause the slip, and the runs in which it was changed."""

    name: str
    section: str
    changed: str  # the change in words
    parameter: str = ""  # the column whose range is printed
    cases: tuple[str, ...] = ()
    """The runs.

    If no cases are given, these are all runs that the section compares with a baseline.
    """
    claim: str = "not_the_cause"  # excludes it; empty for the cause itself
    why: str = ""  # the reason, if the claim holds

    def rows(self, chapter: Chapter) -> list[Row]:
        results = chapter.results
        compared = [value.removesuffix("_difference") for value in results.derived]
        return [row for row in results.rows if row.case in (self.cases or compared)]

    def verdict(self, chapter: Chapter) -> str:
        """Return the reason why it is not the cause, or the words for the cause."""
        claims = chapter.section.claims
        holds = {test.name: test.outcome == HOLDS for test in claims}
        opposite = {test.name: test.outcome.is_opposite for test in claims}
        if not self.claim:
            return DAMPING if holds.get("together_they_hold") else "not shown"
        is_excluded = holds.get(self.claim) and holds.get("not_the_cause", True)
        if is_excluded:
            return f"no: {self.why}"
        return "it changes the slip" if opposite.get("not_the_cause") else "not shown"


SUSPECTS = (
    Suspect(
        "pads' friction",
        "friction",
        "lower and higher",
        "pad_mu",
        why="the grip needs little friction",
    ),
    Suspect(
        "contact points",
        "contact_source",
        "their rate, the pads' shape, the engine",
        why="the slip hardly changes",
    ),
    Suspect(
        "solver",
        "solver",
        "iterations, tolerance, cone, step",
        claim="solver_has_converged",
        why="it has converged, and the cone and shorter steps change little",
    ),
    Suspect(
        "contact gap [m]",
        "gap",
        "from none to wide",
        "cube_gap_m",
        CASES,
        "same_contacts_carry",
        "the contacts that it adds carry no force",
    ),
    Suspect(
        "the cube's ke",
        "priority",
        "softer and stiffer",
        "cube_ke",
        CUBE,
        "cube_does_not_count",
        "the pads have priority",
    ),
    Suspect(
        "soft contacts",
        "stiffness",
        "dmax raised",
        "",
        (HARDEST,),
        "not_creep_under_load",
        "stiffer contacts drift more",
    ),
    Suspect(
        "load alone",
        "hold",
        "the arm held still",
        "",
        ("hold",),
        "drift_needs_cycle",
        "without the shake there is no comparable drift",
    ),
    Suspect("pads' ke and kd", "stiffness", "both raised", "pad_ke", (FIX,), ""),
)


def derive(chapters: Chapters) -> Section:
    """Make the table of suspects, and a figure with the slip of each of their runs."""
    lines: list[dict[str, Any]] = []
    slips: dict[str, list[Quantity]] = {}
    for suspect in SUSPECTS:
        if suspect.section not in chapters:
            continue
        chapter = chapters[suspect.section]
        rows = suspect.rows(chapter)
        if all(row.slip_mm.value is None for row in rows):
            continue
        slips[suspect.name.partition(" [")[0]] = [row.slip_mm for row in rows]
        lines.append(
            {
                "suspect": suspect.name,
                "changed": suspect.changed,
                "range": _ends(rows, suspect.parameter),
                "contacts": _ends(rows, "peak_contact_count"),
                "slip": _ends(rows, "slip_mm"),
                "verdict": suspect.verdict(chapter),
            }
        )
    names = [line.pop("suspect") for line in lines]
    columns = {name: [line[name] for line in lines] for name in (lines or [{}])[0]}
    figures = {}
    if "reproduction" in chapters:
        shipped = chapters["reproduction"].results.row["as-shipped"].slip_mm
        cells = [cell for of_suspect in slips.values() for cell in of_suspect]
        figures["runs"] = Figure(
            lambda: _draw(slips, shipped), [*cells, shipped], {"shipped": shipped}
        )
    return Section({"suspects": table_of("suspect", names, columns)}, figures)


def _draw(slips: dict[str, list[Quantity]], shipped: Quantity) -> Drawing:
    drawing, axes = new_figure(7.2, 3.2)
    for line, cells in enumerate(slips.values()):
        is_cause = line == len(slips) - 1
        mark_points(
            axes,
            [(cell.value, line) for cell in cells],
            color=STIFF if is_cause else SHIPPED,
            marker="s" if is_cause else "o",
            alpha=0.6,
        )
    ends = [-0.5, len(slips) - 0.5]
    draw_line(axes, [shipped.value] * 2, ends, color=INK, linewidth=0.8)
    name_lines(axes, slips)
    axes.set(xscale="log", xlabel="slip [mm]")
    tick_125(axes.xaxis)
    return drawing


def _ends(rows: list[Row], column: str) -> Quantity | Markup | str:
    """Return one number, or the smallest and the largest if they are printed differently."""
    cells = [
        row[column] for row in rows if column in row and row[column].value is not None
    ]
    if not cells:
        return ""
    low = min(cells, key=lambda cell: cell.number)
    high = max(cells, key=lambda cell: cell.number)
    if low is high or low.written == high.written:
        return low
    return Markup("{} to {}").format(low.bare, high.bare)
