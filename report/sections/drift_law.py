"""The law of the drift: what the runs of section stiffness drift, beside what the arm's motion says beforehand."""

from collections.abc import Sequence
from dataclasses import dataclass
from statistics import median

from matplotlib.figure import Figure as Drawing

from measured_report.parts.claim import FAILS, HOLDS, Claim, Outcome, all_of, at_least, at_most, beyond
from measured_report.parts.figures import INK, SERIES, new_figure, tick_125
from measured_report.parts.section import Figure, Section, Table
from measured_report.values.quantities import Quantity, Value, absent
from measured_report.values.results import Results, Row
from report.shared import drawing as colours
from report.shared.arithmetic import (
    Column,
    by_case,
    cell_count,
    departure,
    difference,
    extreme,
    is_held,
    largest_size,
    noise_floor,
    other_cell,
    other_value,
    resolved,
    share,
    size_difference,
)
from report.shared.drawing import mark_points

order = 91
page = "cause"
reads = ("noise", "stiffness")
label = "law of the drift"
labels = {
    "pad-ke-2.5e3": "shipped pads",
    "pad-ke-2.5e5": "stiff pads",
    "pad-ke-#": "pads' ke {}, kd with it",
    "sweep-ke-#": "pads' ke {}, kd with it",
    "solimp-dmax-#": "dmax {}",
}

SHIPPED, FIX = "pad-ke-2.5e3", "pad-ke-2.5e5"
PARTS = {"left_out": "the term", "step": "step"}
"""Columns of the large parts, and what they are called."""
SHOWN = ("sweep-ke-412", SHIPPED, "pad-ke-2.5e4", FIX, "solimp-dmax-0.9999")
"""Runs of the table."""
KINDS = {"kept": "positions compensated", "rounded": "positions rounded"}


@dataclass(frozen=True)
class Run:
    """A run that keeps the cube: what the law gives, and what was measured."""

    law: Row
    drift: Quantity
    off: Value
    """Size of their difference, of the law [%]."""

    @property
    def cells(self) -> tuple[Quantity, Quantity]:
        """Return the drift as measured, and as the law gives it."""
        return self.drift, self.law.predicted_drift_mm_s


def derive(results: Results) -> Section:
    bound = results.chosen("law_bound", "one law", 1.5, unit="%")
    rounded = results.others["stiffness"].row if "stiffness" in results.others else {}
    runs = {
        kind: [
            _run(results, row, measured[row.case], kind)
            for row in results.rows
            if row.case in measured and is_held(measured[row.case])
        ]
        for kind, measured in (("kept", results.row), ("rounded", rounded))
    }
    sources = [cell for run in runs["kept"] for cell in run.cells]
    follows = _follows(results, runs["kept"], bound)
    figure = Figure(lambda: _draw(runs["kept"]), sources, {"follows": follows.outcome == HOLDS})
    return Section(
        tables={"parts": _table([run for run in runs["kept"] if run.law.case in SHOWN])},
        figures={"law": figure},
        claims=[_by_hand(results), follows, _rounded_too(results, runs["rounded"], bound)],
    )


def _run(results: Results, law: Row, measured: Row, kind: str) -> Run:
    formula = f"drift measured with {KINDS[kind]}, less that of the law, in size, of the latter"
    cells = measured.drift_mm_s, law.predicted_drift_mm_s
    return Run(law, cells[0], departure(results, f"off_{kind}_{law.case}", formula, *cells))


def _by_hand(results: Results) -> Claim:
    row, dmax = results.row[SHIPPED], other_cell(results, "stiffness", SHIPPED, "dmax", unit="1")
    substep = other_value(results, "stiffness", "substep", unit="s")
    step = results.value("step_ms", "substep in ms", lambda seconds: 1e3 * seconds, substep, unit="ms")
    formula = "response over dmax"
    timeconst = results.value("timeconst_ms", formula, lambda t, d: 1e3 * t / d, row.response_s, dmax, unit="ms")
    formula = "twice the drift that the left-out acceleration makes, over the response"
    g = results.value("g", formula, lambda a, t: 2 * a / t, row.left_out_mm_s, row.response_s, unit="mm/s²")
    formula = "half of dmax · timeconst · ⟨J̇q̇⟩"
    trailing = results.value("trailing", formula, lambda d, t, g: d * t * g / 2e3, dmax, timeconst, g, unit="mm/s")
    back = results.value("back", "half of h · ⟨J̇q̇⟩", lambda h, g: h * g / 2e3, step, g, unit="mm/s")
    rough = difference(results, "rough", "the first less the second", trailing, back)
    off = departure(results, "rough_off", "how far that is from the drift, of the latter", rough, row.drift_mm_s)
    numbers = {"g": g, "dmax": dmax, "timeconst": timeconst, "step": step, "trailing": trailing, "back": back}
    return Claim(
        "by_hand", at_most(off, 5.0, why="nearly all of it"), {**numbers, "rough": rough, "drift": row.drift_mm_s}
    )


def _follows(results: Results, runs: Sequence[Run], bound: Value) -> Claim:
    shipped, fix = results.row[SHIPPED], results.row[FIX]
    responses, formula = [run.law.response_s for run in runs], "longest over shortest response of the friction rows"
    width = results.value("response_range", formula, lambda *s: max(s) / min(s), *responses)
    numbers: dict[str, Quantity] = {**_numbers(results, "kept", runs, bound), "width": width}
    numbers["tried"] = cell_count(results, "tried_count", "runs that were tried", [row.pad_ke for row in results.rows])
    numbers |= {"shipped": shipped.drift_mm_s, "shipped_law": shipped.predicted_drift_mm_s}
    numbers |= {"fix": fix.drift_mm_s, "fix_law": fix.predicted_drift_mm_s}
    fastest = largest_size(results, "drift_most", "fastest of these drifts", [run.drift for run in runs], unit="mm/s")
    formula = "noise of the drift, of the fastest"
    noise = share(results, "drift_noise", formula, noise_floor(results, "drift_floor"), fastest)
    outcome = all_of(at_most(numbers["largest"], bound), resolved(noise, bound)).having_read(width)
    is_wide = at_least(width, 3.0, why="enough to see a law")
    if outcome == HOLDS and is_wide == FAILS:
        reason = "the friction rows of all runs brake too much alike to tell"
        outcome = Outcome("unknown", reason).having_read(width)
        numbers = {name: absent(number.unit, reason) for name, number in numbers.items()}
    inside = {run.law.case for run in runs if at_most(run.off, bound) == HOLDS}
    told = {"is_wide": is_wide == HOLDS, "shipped_follows": SHIPPED in inside, "fix_follows": FIX in inside}
    return Claim("follows", outcome, numbers | told)


def _rounded_too(results: Results, runs: Sequence[Run], bound: Value) -> Claim:
    numbers = _numbers(results, "rounded", runs, bound)
    formula = "size of the difference of drift and law, positions rounded"
    gaps = [size_difference(results, f"gap_{run.law.case}", formula, *run.cells) for run in runs]
    gap = extreme(results, "median_gap", "median of these differences", lambda *found: median(found), gaps)
    # How far beyond the bound a run is, at most: a drift near zero is off by the noise alone.
    far = results.value(
        "rounded_beyond",
        "size of the difference of drift and law, less the bound's share of the law, the largest of all runs",
        lambda share, *found: max(
            abs(drift - given) - 0.01 * share * abs(given) for drift, given in zip(found[::2], found[1::2], strict=True)
        ),
        *(bound, *(cell for run in runs for cell in run.cells)),
        unit="mm/s",
    )
    outcome = at_most(numbers["largest"], bound)
    if outcome == FAILS:
        outcome = beyond(far, noise_floor(results, "drift_floor")).having_read(numbers["largest"], bound)
    return Claim("rounded_too", outcome, numbers | {"gap": gap})


def _numbers(results: Results, kind: str, runs: Sequence[Run], bound: Value) -> dict[str, Value]:
    offs, formula = [run.off for run in runs], f"runs within the bound, {KINDS[kind]}"
    inside = results.value(
        f"inside_{kind}", formula, lambda most, *found: sum(off <= most for off in found), bound, *offs
    )
    count = cell_count(results, f"count_{kind}", f"runs that keep the cube, {KINDS[kind]}", offs)
    largest = extreme(results, f"largest_{kind}", f"largest departure from the law, {KINDS[kind]}", max, offs)
    return {"inside": inside, "count": count, "largest": largest, "bound": bound}


def _table(runs: Sequence[Run]) -> Table:
    rows = [run.law for run in runs]
    parts = {label: f"{name}_mm_s" for name, label in PARTS.items()}
    columns: dict[str, Column] = {"response": "response_s", **parts, "law": "predicted_drift_mm_s"}
    return by_case(rows, columns | {"measured": [run.drift for run in runs]})


def _draw(runs: Sequence[Run]) -> Drawing:
    drawing, axes = new_figure(7.2, 3.2)
    by_response = sorted(runs, key=lambda run: run.law.response_s.value)
    law = [(1e3 * run.law.response_s.value, run.law.predicted_drift_mm_s.value) for run in by_response]
    axes.plot(*zip(*law, strict=True), color=INK, linestyle="-", linewidth=1.0, marker="", label="the law")
    for case, colour, label in (
        ("", SERIES[5], "other pads"),
        (SHIPPED, colours.SHIPPED, "shipped pads"),
        (FIX, colours.STIFF, "stiff pads"),
    ):
        mine = [run for run in runs if (run.law.case if run.law.case in (SHIPPED, FIX) else "") == case]
        points = [(1e3 * run.law.response_s.value, run.drift.value) for run in mine]
        mark_points(axes, points, marker="D" if case else "o", markersize=9 if case else 5, color=colour, label=label)
    axes.set(xscale="log", yscale="log", xlabel="response time T of the friction rows [ms]", ylabel="drift [mm/s]")
    tick_125(axes.xaxis)
    tick_125(axes.yaxis)
    axes.legend()
    return drawing
