"""The slip's causes taken out one by one and together: what is predicted, what is measured, and what to use."""

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise, product
from typing import Any

from markupsafe import Markup
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing

from measured_report.claims.claim import HOLDS, Claim, Outcome, all_of, at_least, at_most, decreases, greater
from measured_report.parts.figures import INK, SERIES, new_figure
from measured_report.parts.section import Figure, Section, Table
from measured_report.values.quantities import Quantity, Value, absent
from measured_report.values.results import Results, Row
from report.names import some_html
from report.sections.cure.ways import ADDS, BEST, GRASP_MM, STEPS, WAYS, Way, cost_table, use_table, what_to_use
from report.shared.arithmetic import cell_count, departure, extreme, noise_floor, ratio, share, table_of
from report.shared.drawing import mark_cells, name_lines

order = 149  # after all of its page, which it reads
page = "cure"
label = "the cure"
leads = True

PARTS = {"left_out": "the term", "step": "step", "damping": "damping", "creep": "load", "rounding": "rounding"}
"""Columns of the parts of the slip that are predicted from the arm's motion, and what they are called."""
HATCHES = ("", "///", "...", "xxx", "\\\\\\")
PADS = {"shipped": "shipped pads", "stiff": "stiff pads"}
SHAKES = {"held": "held still", "3cm": "30 mm", "10cm": "100 mm"}
OTHER_CONTACTS = {
    "mujoco": ("mujoco-euler-400-shipped-3cm-full-kept", "contacts that MuJoCo finds"),
    "pyramid": ("pyramidal-euler-400-shipped-3cm-full-kept", "a pyramidal cone"),
}
"""All remedies with other contacts than Newton's and with another cone."""
Slips = Mapping[str, Quantity]
"""At 3 cm, by the name of the way."""
Parts = Mapping[str, Mapping[str, Value]]
"""By the name of the way."""


def derive(results: Results) -> Section:
    least = results.chosen("remainder_least", "what a grasp of this kind does not show", 0.02, unit="mm")
    most = results.chosen("remainder_share", "as good as the law", 5.0, unit="%")
    grasp = results.chosen("grasp_bound", "farther from where it was, a cube is out of the grasp", GRASP_MM, unit="mm")
    near, far = (
        results.value(f"amplitude_{shake}", "in whole mm", lambda m: round(1e3 * m), row.shake_amplitude_m, unit="mm")
        for shake, row in ((shake, BEST.row(results, shake)) for shake in ("3cm", "10cm"))
    )
    parts = {way.name: _parts_of(results, way) for way in WAYS}
    slips = {way.name: way.row(results, "3cm").slip_mm for way in WAYS}
    numbers = {"shipped": slips["shipped pads"], "term": slips["the term"], "best": slips[BEST.name], "amplitude": near}
    numbers |= {name: parts["shipped pads"][name] for name in ("left_out", "sum")}
    return Section(
        tables={
            "use": use_table(results),
            "cost": cost_table(results),
            "budget": _budget_table(results, parts, near),
            "closing": _closing_table(results, least, most),
        },
        figures={"budget": Figure(lambda: _draw_budget(results, parts), list(slips.values()), numbers)},
        claims=[
            what_to_use(results, far, grasp),
            _budget_closes(results, least, most),
            *_remedies_hold(results, slips, far, grasp),
            _term_uncovers_step(results, parts["the term"]),
            *_stiff_pads(results, slips),
            _with_other_contacts(results),
            _pyramid_yields(results),
            _lacks_the_sway(results, far),
        ],
    )


def _way(name: str) -> Way:
    return next(way for way in WAYS if way.name == name)


def _budget_closes(results: Results, least: Value, most: Value) -> Claim:
    kept = _kept_runs(results)
    closed = _closed_count(results, "closed_count", kept, least, most)
    count = _run_count(results, "kept_count", kept)
    part = share(results, "closed_share", "of the runs that keep the cube, those of them", closed, count)
    outcome = all_of(at_least(closed, 8.0, why="not by chance"), at_least(part, 80.0, why="by far the most of them"))
    numbers = {"closed": closed, "count": count, "share": part, "least": least, "most": most}
    return Claim("budget_closes", outcome, numbers)


def _remedies_hold(results: Results, slips: Slips, far: Value, grasp: Value) -> Iterator[Claim]:
    """Tell how little the cube slips with the term alone, with one remedy after the other, and with all of them."""
    noise = noise_floor(results, "slip_floor")
    shipped, term, best, stiff = (slips[name] for name in ("shipped pads", "the term", BEST.name, "stiff pads"))
    gains = greater(shipped, term, noise=noise)
    outcome = all_of(at_most(term, 0.6, why="a tenth of the slip as shipped"), gains)
    yield Claim("term_alone", outcome, {"shipped": shipped, "term": term})

    steps = {step: slips[name] for step, name in STEPS.items()}
    idle = [
        Markup.escape(name.removeprefix(ADDS))
        for before, name in pairwise(STEPS.values())
        if greater(slips[before], slips[name], noise=noise) != HOLDS
    ]
    falls = decreases(list(steps.values()), noise=noise)
    yield Claim("each_takes_its_part", falls, {**steps, "idle": some_html(idle)})

    is_little = at_most(best, 0.03, why="what a grasp of this kind does not show")
    outcome = all_of(is_little, greater(shipped, best, noise=noise))
    yield Claim("best_holds", outcome, {"best": best, "shipped": shipped})
    yield Claim("stiff_pads_hold_better", greater(term, stiff, noise=noise), {"term": term, "stiff": stiff})

    best, shipped = (way.row(results, "10cm").slip_mm for way in (BEST, _way("shipped pads")))
    outcome = at_most(best, 0.1, why="a tenth of a millimetre at a shake three times as wide")
    if at_least(shipped, grasp) != HOLDS:
        outcome = Outcome("unknown", "the scene with shipped pads keeps the cube there").having_read(shipped)
        best = absent("mm", outcome.reason)
    yield Claim("best_holds_farther", outcome, {"best": best, "amplitude": far})


def _term_uncovers_step(results: Results, parts: Mapping[str, Value]) -> Claim:
    """The error of the step goes against what the term would have added, so that it shows once that is gone."""
    plain, term = (_way(name).row(results, "3cm") for name in ("shipped pads", "the term"))
    turned = results.value(
        "turned",
        "cosine of the angle between the slip with the term put back and that as shipped, along the pads",
        lambda ax, az, bx, bz: (ax * bx + az * bz) / ((ax**2 + az**2) * (bx**2 + bz**2)) ** 0.5,
        *(cell for row in (plain, term) for cell in (row.slip_x_mm, row.slip_z_mm)),
    )
    formula = "predicted error of the step, along the way that the cube went with the term put back, of the slip then"
    part = share(results, "step_share", formula, parts["step"], term.slip_mm)
    outcome = all_of(at_most(turned, -0.5, why="about the other way"), at_least(part, 50.0, why="most of it"))
    return Claim("term_uncovers_step", outcome, {"term": term.slip_mm, "step": parts["step"], "share": part})


def _stiff_pads(results: Results, slips: Slips) -> Iterator[Claim]:
    """Tell whether stiff pads lose by the term, and why they can: the error of the step alone is more than what it and
    the term come to."""
    plain, term, noise = slips["stiff pads"], slips["stiff pads, the term"], noise_floor(results, "slip_floor")
    yield Claim("stiff_pads_with_term", greater(term, plain, noise=noise), {"plain": plain, "term": term})

    def size(*cells: float) -> float:
        """Compute the length of the sum of vectors, each given as x and z."""
        return math.hypot(sum(cells[::2]), sum(cells[1::2]))

    row = _way("stiff pads").row(results, "3cm")
    of_term, of_step = ((row[f"{name}_x_mm"], row[f"{name}_z_mm"]) for name in ("left_out", "step"))
    sizes = {
        name: results.value(f"stiff_{name}", f"size of {words} along the pads, predicted", size, *cells, unit="mm")
        for name, words, cells in (
            ("term", "the term", of_term),
            ("step", "the error of the step", of_step),
            ("both", "both together", of_term + of_step),
        )
    }
    outcome = greater(sizes["step"], sizes["both"], noise=noise).having_read(sizes["term"])
    yield Claim("step_alone_is_more", outcome, sizes)


def _with_other_contacts(results: Results) -> Claim:
    slips = {name: results.row[case].slip_mm for name, (case, _) in OTHER_CONTACTS.items()}
    bound, why = 0.1, "as good as with Newton's contacts, or nearly"
    named = zip(slips.values(), OTHER_CONTACTS.values(), strict=True)
    worse = [Markup.escape(words) for slip, (_, words) in named if at_most(slip, bound, why) != HOLDS]
    largest = results.value("other_slip", "larger of both", max, *slips.values(), unit="mm")
    return Claim("with_other_contacts", at_most(largest, bound, why), slips | {"worse": some_html(worse)})


def _pyramid_yields(results: Results) -> Claim:
    """What the pyramidal cone leaves is load alone, on rows that are softer the less deep the contacts are."""
    row = results.row[OTHER_CONTACTS["pyramid"][0]]
    cells = row.creep_x_mm, row.creep_z_mm
    load = results.value("pyramid_load", "size of the part of load", math.hypot, *cells, unit="mm")
    off = departure(results, "pyramid_load_off", "slip less that part, in size, of the slip", load, row.slip_mm)
    outcome = at_most(off, 15.0, why="that part and no other")
    return Claim("pyramid_yields", outcome, {"slip": row.slip_mm, "load": load})


def _kept_runs(results: Results) -> list[Row]:
    """Select the combinations that have a slip to show and keep the cube."""
    runs = [row for row in results.rows if row.kind == "run" and row.slip_mm.value is not None]
    return [row for row in runs if row.slip_mm.value < GRASP_MM]


def _closed_count(results: Results, name: str, runs: Sequence[Row], least: Value, most: Value) -> Value:
    """Count the runs whose remainder is below ``least`` [mm], or below ``most`` of the slip [%]."""
    return results.value(
        name,
        "runs whose remainder is below either bound",
        lambda absolute, relative, *found: sum(
            remainder <= max(absolute, 0.01 * relative * slip)
            for remainder, slip in zip(found[::2], found[1::2], strict=True)
        ),
        *(least, most),
        *(cell for row in runs for cell in (row.remainder_mm, row.slip_mm)),
    )


def _run_count(results: Results, name: str, runs: Sequence[Row]) -> Value:
    return cell_count(results, name, "runs that keep the cube", [row.slip_mm for row in runs])


def _parts_of(results: Results, way: Way) -> dict[str, Value]:
    """Derive the parts of a way at 3 cm along the direction in which its cube went, their sum, and how far it went."""

    def along(x: float, z: float, slip_x: float, slip_z: float) -> float:
        return (x * slip_x + z * slip_z) / (slip_x**2 + slip_z**2) ** 0.5 + 0.0  # no negative zero

    row, parts = way.row(results, "3cm"), {}
    for name, column in {**{name: name for name in PARTS}, "sum": "predicted", "slip": "slip"}.items():
        formula = f"{column} of {row.case} along the pads, in the direction in which the cube went there"
        cells = row[f"{column}_x_mm"], row[f"{column}_z_mm"], row.slip_x_mm, row.slip_z_mm
        parts[name] = results.value(f"{row.case}_{name}", formula, along, *cells, unit="mm")
    return parts


def _budget_table(results: Results, parts: Parts, amplitude: Value) -> Table:
    shown = {label: name for name, label in PARTS.items()} | {"sum": "sum", "measured": "slip"}
    columns = {label: [parts[way.name][name] for way in WAYS] for label, name in shown.items()}
    columns["remainder"] = [way.row(results, "3cm").remainder_mm for way in WAYS]
    return table_of("what is done", [way.name for way in WAYS], columns, amplitude=amplitude)


def _closing_table(results: Results, least: Value, most: Value) -> Table:
    """Count for each kind of run how many keep the cube, and of how many of these the budget closes."""
    kept = _kept_runs(results)
    columns: dict[str, list[Value]] = {}
    for pads, shake in product(PADS, SHAKES):
        runs, name = [row for row in kept if (row.pads, row.shake) == (pads, shake)], f"{pads}_{shake}"
        remainders, slips = [row.remainder_mm for row in runs], [row.slip_mm for row in runs]
        for above, value in {
            "keep the cube": _run_count(results, f"kept_{name}", runs),
            "budget closes": _closed_count(results, f"closed_{name}", runs, least, most),
            "largest remainder": extreme(results, f"remainder_{name}", "largest remainder", max, remainders),
            "largest slip": extreme(results, f"slip_{name}", "largest slip", max, slips),
        }.items():
            columns.setdefault(above, []).append(value)
    return table_of("runs", [f"{pads}, {shake}" for pads, shake in product(PADS.values(), SHAKES.values())], columns)


def _lacks_the_sway(results: Results, amplitude: Value) -> Claim:
    """Tell whether what the budget leaves of the widest shake is a matter of soft pads, in which the cube sways."""
    soft, stiff = (results.derived[f"remainder_{pads}_10cm"] for pads in PADS)
    formula = "largest remainder with shipped pads over that with stiff ones"
    more = ratio(results, "remainder_ratio", formula, soft, stiff)
    numbers = {"soft": soft, "stiff": stiff, "amplitude": amplitude}
    return Claim("lacks_the_sway", at_least(more, 3.0, why="clearly more"), numbers)


def _draw_budget(results: Results, parts: Parts) -> Drawing:
    """All ways on the left, and those with a remedy once more on a scale of their own on the right."""
    drawing, (whole, close) = new_figure(7.2, 4.6, ncols=2, sharey=True)
    for axes in (whole, close):
        _stack(axes, parts)
        axes.axvline(0.0, color=INK, linewidth=0.8, marker="")
        axes.grid(visible=False, axis="y")
        axes.set_xlabel("along the way of the cube [mm]")
    values = [abs(value.value) for way in WAYS[1:] for value in parts[way.name].values() if value.value is not None]
    reach = 1.1 * max(values, default=1.0)
    close.set_xlim(-reach, reach)
    name_lines(whole, [way.name for way in WAYS])
    whole.set_title("whole")
    close.set_title("close")
    drawing.legend(*whole.get_legend_handles_labels(), loc="outside upper center", ncols=4)
    return drawing


def _stack(axes: Axes, parts: Parts) -> None:
    """What goes along the cube's way is stacked to the right of zero, what goes against it to the left."""
    ends = {(way.name, sign): 0.0 for way in WAYS for sign in (True, False)}
    for number, (name, label) in enumerate(PARTS.items()):
        sizes, starts = [], []
        for way in WAYS:
            size = parts[way.name][name].value or 0.0
            sizes.append(size)
            starts.append(ends[way.name, size > 0.0])
            ends[way.name, size > 0.0] += size
        fill: dict[str, Any] = {"color": SERIES[number], "hatch": HATCHES[number], "linewidth": 0}
        axes.barh(range(len(WAYS)), sizes, 0.6, left=starts, label=label, **fill)
    for name, label, marker, size in (("sum", "sum of the parts", "|", 15), ("slip", "measured", "o", 5)):
        mark_cells(axes, [parts[way.name][name] for way in WAYS], INK, label, marker=marker, markersize=size)
