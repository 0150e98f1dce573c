"""The slip's causes taken out one by one and together: what is predicted, what is measured, and what to use."""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise, product

import numpy as np
from matplotlib.figure import Figure as Drawing

from measured_report.parts.claim import HOLDS, Claim, all_of, at_least, at_most, decided, greater
from measured_report.parts.figures import FAINT, INK, is_narrow, new_figure
from measured_report.parts.section import Figure, Section, Table
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row
from report.sections.cure.variants import (
    BEST,
    GRASP_MM,
    SHIPPED,
    STEPS,
    STIFF,
    STIFF_TERM,
    TERM,
    Variant,
    use_table,
    what_to_use,
)
from report.shared import drawing as colours
from report.shared.arithmetic import cell_count, noise_floor, rows_with, share, table_of
from report.shared.drawing import mark_points

PARTS = {"left_out": "the term", "step": "step", "damping": "damping", "creep": "load", "rounding": "rounding"}
"""Columns of the parts of the slip that are predicted from the arm's motion, and what they are called."""
SHOWN = (SHIPPED, STIFF, TERM, BEST)
"""Ways whose parts are shown."""
PADS = {"shipped": "shipped pads", "stiff": "stiff pads"}
OTHER_CONTACTS = {
    "mujoco": "mujoco-euler-400-shipped-3cm-full-kept",
    "pyramid": "pyramidal-euler-400-shipped-3cm-full-kept",
}
"""The whole cure with other contacts than Newton's and with another cone."""
Bounds = tuple[Value, Value]
"""Remainders up to which the budget closes: in mm, and in percent of the slip."""
COUNTED: dict[str, tuple[str, Callable[..., bool]]] = {
    "closed": ("remainder is below either bound", lambda rest, slip, least, most: rest <= max(least, most * slip)),
    "relative": ("remainder is below its share of the slip", lambda rest, slip, least, most: rest <= most * slip),
    "little": ("slip is no more than twice the absolute bound", lambda rest, slip, least, most: slip <= 2.0 * least),
    "alike": (
        "slip and predicted slip differ in size by no more than either bound",
        lambda predicted, slip, least, most: abs(predicted - slip) <= max(least, most * slip),
    ),
}
"""Runs that are counted, told of remainder or prediction, slip and both bounds [mm, mm, mm, share of the slip]."""


def derive(results: Results) -> Section:
    least = results.chosen("remainder_least", "what a grasp of this kind does not show", 0.02, unit="mm")
    most = results.chosen("remainder_share", "as good as the law", 5.0, unit="%")
    shaken = BEST.row(results, "10cm").shake_amplitude_m
    far = results.value("amplitude_10cm", "in whole mm", lambda m: round(1e3 * m), shaken, unit="mm")
    runs = [row for row in rows_with(results, "kind", "pads", "shake") if row.kind == "run"]
    kept = [row for row in runs if row.slip_mm.value is not None and row.slip_mm.value < GRASP_MM]
    closes = _budget_closes(results, kept, (least, most))
    numbers = {name: closes.numbers[name] for name in ("count", "closed", "least", "most")}
    numbers["alike"] = _count_of(results, "alike", kept, (least, most))
    budget = Figure(
        draw=lambda: _draw_budget(kept, least.value, 0.01 * most.value),
        sources=[cell for row in kept for cell in (row.slip_mm, row.predicted_slip_mm)],
        numbers=numbers | {"closes": closes.outcome == HOLDS},
    )
    return Section(
        tables={"use": use_table(results), "budget": _budget_table(results)},
        figures={"budget": budget},
        claims=[
            what_to_use(results, far),
            _each_takes_its_part(results),
            closes,
            _term_uncovers_step(results),
            _stiff_pads_with_term(results),
            *_with_other_contacts(results),
        ],
    )


def _each_takes_its_part(results: Results) -> Claim:
    noise = noise_floor(results, "slip_floor")
    slips = {name: variant.row(results, "3cm").slip_mm for name, variant in {"shipped": SHIPPED, **STEPS}.items()}
    idle = [after for before, after in pairwise(slips) if greater(slips[before], slips[after], noise=noise) != HOLDS]
    numbers = dict(zip(("shipped", "term", "centred", "impratio", "kept", "best"), slips.values(), strict=True))
    outcome = decided(not idle, *slips.values(), noise)
    listed = " and ".join(filter(None, [", ".join(idle[:-1]), *idle[-1:]]))
    return Claim("each_takes_its_part", outcome, {**numbers, "idle": listed})


def _budget_closes(results: Results, kept: Sequence[Row], bounds: Bounds) -> Claim:
    slips = [row.slip_mm for row in kept]
    numbers = {"count": cell_count(results, "kept_count", "runs that keep the cube", slips)}
    numbers |= {name: _count_of(results, name, kept, bounds) for name in ("closed", "relative", "little")}
    closed, count = numbers["closed"], numbers["count"]
    part = share(results, "closed_share", "of the runs that keep the cube, those of them", closed, count)
    numbers |= {"share": part, "least": bounds[0], "most": bounds[1]}
    outcome = all_of(at_least(closed, 8.0, why="not by chance"), at_least(part, 80.0, why="by far the most of them"))
    return Claim("budget_closes", outcome, numbers)


def _term_uncovers_step(results: Results) -> Claim:
    """Tell whether the error of the step goes against what the term would have added, and shows without it."""
    plain, term = (variant.row(results, "3cm") for variant in (SHIPPED, TERM))
    turned = results.value(
        "turned",
        "cosine of the angle between the slip with the term put back and that as shipped, along the pads",
        lambda ax, az, bx, bz: (ax * bx + az * bz) / ((ax**2 + az**2) * (bx**2 + bz**2)) ** 0.5,
        *(cell for row in (plain, term) for cell in (row.slip_x_mm, row.slip_z_mm)),
    )
    step = _parts_of(results, TERM)["step"]
    formula = "predicted error of the step, along the way that the cube went with the term put back, of the slip then"
    part, noise = share(results, "step_share", formula, step, term.slip_mm), noise_floor(results, "slip_floor")
    known = part
    if part.noise is None and None not in (part.value, noise.value) and term.slip_mm.value:
        # A share is known no better than the effect that it is of.
        known = replace(part, noise=abs(part.value / term.slip_mm.value) * noise.value)
    outcome = all_of(
        greater(term.slip_mm, 0.0, noise=noise, why="there is something to explain"),
        at_least(known, 50.0, why="most of it"),
        at_most(known, 110.0, why="no more than there is"),
        at_most(turned, -0.5, why="about the other way"),
    )
    return Claim("term_uncovers_step", outcome, {"term": term.slip_mm, "step": step})


def _stiff_pads_with_term(results: Results) -> Claim:
    """Tell whether stiff pads lose by the term because the error of the step alone is more than both together."""
    plain, term = (variant.row(results, "3cm").slip_mm for variant in (STIFF, STIFF_TERM))
    row, noise = STIFF.row(results, "3cm"), noise_floor(results, "slip_floor")
    step = row.step_x_mm, row.step_z_mm
    formula = "size of the error of the step along the pads, predicted for stiff pads"
    alone = results.value("stiff_step", formula, math.hypot, *step, unit="mm")
    both = results.value(
        "stiff_both",
        "the same, with the term",
        lambda ax, az, bx, bz: math.hypot(ax + bx, az + bz),
        *(*step, row.left_out_x_mm, row.left_out_z_mm),
        unit="mm",
    )
    outcome = all_of(greater(term, plain, noise=noise), greater(alone, both, noise=noise))
    return Claim("stiff_pads_with_term", outcome, {"plain": plain, "term": term, "step": alone, "both": both})


def _with_other_contacts(results: Results) -> Iterator[Claim]:
    for name, case in OTHER_CONTACTS.items():
        slip, why = results.row[case].slip_mm, "as good as with Newton's contacts, or nearly"
        yield Claim(f"with_{name}", at_most(slip, 0.1, why=why), {"slip": slip})


def _count_of(results: Results, what: str, runs: Sequence[Row], bounds: Bounds) -> Value:
    words, is_so = COUNTED[what]
    column = "predicted_slip_mm" if what == "alike" else "remainder_mm"

    def count(least: float, most: float, *found: float) -> int:
        pairs = zip(found[::2], found[1::2], strict=True)
        return sum(is_so(value, slip, least, 0.01 * most) for value, slip in pairs)

    cells = (cell for row in runs for cell in (row[column], row.slip_mm))
    return results.value(f"{what}_count", f"runs whose {words}", count, *bounds, *cells)


def _parts_of(results: Results, variant: Variant) -> dict[str, Value]:
    """Derive the parts of a variant at 3 cm along the way of its cube, their sum, and how far it went."""

    def along(x: float, z: float, slip_x: float, slip_z: float) -> float:
        return (x * slip_x + z * slip_z) / (slip_x**2 + slip_z**2) ** 0.5 + 0.0  # no negative zero

    row, parts = variant.row(results, "3cm"), {}
    for name, column in {**{name: name for name in PARTS}, "sum": "predicted", "slip": "slip"}.items():
        key, formula = f"{row.case}_{name}", f"{column} of {row.case} along the pads, in the direction of its slip"
        cells = row[f"{column}_x_mm"], row[f"{column}_z_mm"], row.slip_x_mm, row.slip_z_mm
        parts[name] = results.derived.get(key) or results.value(key, formula, along, *cells, unit="mm")
    return parts


def _budget_table(results: Results) -> Table:
    parts = [_parts_of(results, variant) for variant in SHOWN]
    shown = {label: name for name, label in PARTS.items()} | {"sum": "sum", "measured": "slip"}
    columns = {label: [found[name] for found in parts] for label, name in shown.items()}
    return table_of("what is done", [variant.name for variant in SHOWN], columns)


def _draw_budget(runs: Sequence[Row], least: float, most: float) -> Drawing:
    drawing, axes = new_figure(7.2, 4.4)
    line = np.geomspace(0.002, GRASP_MM, 60)
    low, high = np.minimum(line - least, line / (1.0 + most)), np.maximum(line + least, line / (1.0 - most))
    axes.fill_between(line, np.maximum(low, 1e-4), high, color=FAINT, linewidth=0.0, alpha=0.6)
    axes.plot(line, line, color=INK, linewidth=0.8, marker="")
    looks = {"shipped": (colours.SHIPPED, "o"), "stiff": (colours.STIFF, "s")}
    for (pads, (colour, marker)), is_far in product(looks.items(), (False, True)):
        mine = [row for row in runs if row.pads == pads and (row.shake == "10cm") == is_far]
        points = [(row.predicted_slip_mm.value, row.slip_mm.value) for row in mine]
        look = {"markersize": 4, "markerfacecolor": colour if is_far else "none", "markeredgewidth": 0.8}
        label = f"{PADS[pads]}, {'the widest shake' if is_far else 'other runs'}"
        mark_points(axes, points, color=colour, marker=marker, label=label, **look)
    axes.set(xscale="log", yscale="log", xlabel="slip predicted [mm]", ylabel="slip measured [mm]")
    axes.set(xlim=(0.002, 20.0), ylim=(0.002, 20.0))
    drawing.legend(loc="outside upper center", ncols=1 if is_narrow() else 2)
    return drawing
