"""The front page: the cube in the grasp, for where there is no clip."""

from measured_report.pages.editions import Chapters
from measured_report.parts.section import Figure, Section
from report.story.figures import draw_still
from report.story.found import CASES, Found


def derive(chapters: Chapters) -> Section:
    if "reproduction" not in chapters:
        return Section()
    found = Found(chapters)
    traces = {case: found.trace("reproduction", case) for case in CASES}
    slips = {case: found.cell("reproduction", case, "slip_mm", "mm") for case in CASES}
    numbers = dict(zip(("shipped", "stiff"), slips.values(), strict=True))
    still = Figure(lambda: draw_still(traces, slips), [*traces.values(), *slips.values()], numbers)
    return Section(figures={"still": still})
