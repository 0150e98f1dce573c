"""What the patch for MuJoCo Warp costs: the engine's steps with its option off and on."""

from measured_report.parts.claim import Claim, all_of, at_least, at_most
from measured_report.parts.section import Section
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results
from report.names import worlds_name
from report.shared.arithmetic import Column, resolved, table_of
from report.shared.timing import CURE_WORLDS, cell, ratio_cell, resolution

order = 145
page = "cure"
label = "what the patch costs"


def derive(results: Results) -> Section:
    rows = {way: [results.row.get(f"{way}-{count}") for count in CURE_WORLDS] for way in ("off", "on")}

    def cells(way: str, column: str) -> list[Quantity]:
        return [cell(results, row, column, "the patch") for row in rows[way]]

    formula = "time of the engine's steps with the option on over that with it off, timed in turn, less one"
    extra = [
        results.value(f"extra_{count}", formula, lambda taken: 100 * (taken - 1), ratio_cell(results, row), unit="%")
        for count, row in zip(CURE_WORLDS, rows["on"], strict=True)
    ]
    seen = [resolution(results, f"seen_{count}", row) for count, row in zip(CURE_WORLDS, rows["on"], strict=True)]
    columns: dict[str, Column] = {"off": cells("off", "frame_ms"), "on": cells("on", "frame_ms")}
    columns |= {"more": extra, "known within": seen}
    columns |= {"contacts": cells("off", "contact_count"), "rows": cells("off", "row_count")}
    formula = "by what the acceleration that a contact row asks for changes most, least of all numbers of worlds"
    change = results.value("change", formula, min, *cells("on", "asked_change_m_s2"), unit="m/s²")
    acts = at_least(change, 1e-3, why="more than rounding does")
    formula = "most of all numbers of worlds"
    worst = results.value("worst", formula, max, *extra, unit="%")
    unseen = results.value("unseen", "largest resolution of these", max, *seen, unit="%", is_noise=True)
    bound = results.chosen("bound", "a price that a default may have", 3.0, unit="%")
    little = all_of(at_most(worst, bound), resolved(unseen, 1.0, why="a slowdown that a maintainer asks about"), acts)
    return Section(
        tables={"ways": table_of("in", map(worlds_name, CURE_WORLDS), columns)},
        claims=[
            Claim("costs_little", little, {"worst": worst, "unseen": unseen}),
            _off_launches_nothing(results, cells("off", "kernel_count"), cells("on", "kernel_count")),
            Claim("acts", acts, {"change": change}),
        ],
    )


def _off_launches_nothing(results: Results, off: list[Quantity], on: list[Quantity]) -> Claim:
    """Tell whether a frame has the same kernels as without the patch, and on one more in each step."""
    released = cell(results, results.row.get("released"), "kernel_count", "the released package")
    substeps = cell(results, results.row.get(f"on-{CURE_WORLDS[0]}"), "substeps", "the patch")
    formula = "kernels of a frame with the option off, less those of the released package, most in size"
    more = results.value("more_off", formula, lambda a, *found: max(abs(b - a) for b in found), released, *off)
    formula = "kernels of a frame with the option on, less those with it off and one for each step, most in size"
    beside = results.value("beside", formula, _beside, substeps, *off, *on)
    outcome = all_of(at_most(more, 0, why="the same"), at_most(beside, 0, why="one in each step"))
    numbers = {"released": released, "substeps": substeps, "off": off[0], "on": on[0]}
    return Claim("off_launches_nothing", outcome, numbers)


def _beside(substeps: float, *found: float) -> float:
    half = len(found) // 2
    return max(abs(on - off - substeps) for off, on in zip(found[:half], found[half:], strict=True))
