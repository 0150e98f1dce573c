"""The law of the drift: what the runs of section stiffness drift, beside what the arm's motion says beforehand."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from statistics import median

from matplotlib.figure import Figure as Drawing

from measured_report.claims.claim import FAILS, HOLDS, Claim, Outcome, at_least, at_most, beyond
from measured_report.parts.figures import INK, new_figure
from measured_report.parts.section import Figure, Section, Table
from measured_report.values.quantities import Quantity, Value, absent
from measured_report.values.results import Results, Row
from report.sections.stiffness.runs import FIX, SHIPPED, is_held
from report.shared.arithmetic import Column, by_case, cell_count, departure, extreme, noise_floor, size_difference

order = 91
page = "cause"
label = "law of the drift"

PARTS = {"left_out": "the term", "step": "step", "damping": "damping", "creep": "load"}
"""Columns of the parts, and what they are called."""
SHOWN = ("sweep-ke-412", SHIPPED, "pad-ke-2.5e4", FIX, "pad-ke-2.5e6", "pad-ke-2.5e6-kd-100", "solimp-dmax-0.9999")
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
        """The drift as measured, and as the law gives it."""
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
    sources = [cell for found in runs.values() for run in found for cell in run.cells]
    return Section(
        tables={"parts": _table([run for run in runs["kept"] if run.law.case in SHOWN])},
        figures={"law": Figure(lambda: _draw(runs, bound), sources, {"bound": bound})},
        claims=[_follows(results, runs["kept"], bound), _rounded_too(results, runs["rounded"], bound)],
    )


def _run(results: Results, law: Row, measured: Row, kind: str) -> Run:
    formula = f"drift measured with {KINDS[kind]}, less that of the law, in size, of the latter"
    cells = measured.drift_mm_s, law.predicted_drift_mm_s
    return Run(law, cells[0], departure(results, f"off_{kind}_{law.case}", formula, *cells))


def _follows(results: Results, runs: Sequence[Run], bound: Value) -> Claim:
    shipped, fix = results.row[SHIPPED], results.row[FIX]
    responses, formula = [run.law.response_s for run in runs], "longest over shortest response of the friction rows"
    width = results.value("response_range", formula, lambda *s: max(s) / min(s), *responses)
    numbers: dict[str, Quantity] = {**_numbers(results, "kept", runs, bound), "width": width}
    numbers |= {"shipped": shipped.drift_mm_s, "shipped_law": shipped.predicted_drift_mm_s}
    numbers |= {"fix": fix.drift_mm_s, "fix_law": fix.predicted_drift_mm_s}
    outcome, is_wide = at_most(numbers["largest"], bound), at_least(width, 3.0, why="enough to see a law")
    outcome = outcome.having_read(width)
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
    """Count the runs and those within the bound, and find how far off the farthest is."""
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


def _draw(runs: Mapping[str, Sequence[Run]], bound: Value) -> Drawing:
    drawing, axes = new_figure(7.2, 3.2)
    for kind in reversed(KINDS):
        ke = [run.law.pad_ke.value for run in runs[kind]]
        offs = [100 * (run.drift.value / run.law.predicted_drift_mm_s.value - 1) for run in runs[kind]]
        axes.plot(ke, offs, linestyle="", label=KINDS[kind], markevery=1)
    axes.axhspan(-bound.value, bound.value, color=INK, alpha=0.1, linewidth=0)
    axes.axhline(0.0, color=INK, linewidth=0.8, marker="")
    axes.set(xscale="log", xlabel="pad ke", ylabel="drift less that of the law [%]")
    drawing.legend(loc="outside upper center", ncols=2)
    return drawing
