"""The box on the turning table with Newton's other solvers: which of them let it walk, and whether the step is why."""

from collections.abc import Mapping

from measured_report.parts.claim import Claim, all_of, at_least, at_most
from measured_report.parts.section import Section
from measured_report.values.quantities import Quantity, Value, absent
from measured_report.values.results import Results, Row
from report.shared.arithmetic import cell_count, extreme, ratio, table_of

order = 142
page = "cure"
label = "turntable, other solvers"

SOLVERS = {
    "mujoco": "MuJoCo Warp",
    "xpbd": "XPBD",
    "kamino": "Kamino",
    "featherstone": "Featherstone",
    "semi-implicit": "semi-implicit",
    "vbd": "VBD",
}
LONG, SHORT = STEPS = ("2ms", "1ms")
Growths = Mapping[tuple[str, str], Value]
"""By solver and step, of those that keep the box where it belongs."""


def derive(results: Results) -> Section:
    rows = {(solver, step): results.row[f"{solver}-{step}"] for solver in SOLVERS for step in STEPS}
    growths = {}
    for key, row in rows.items():
        if row and row.stays:
            formula = f"growth_per_s of {row.case}, in percent of the distance from the axis"
            growths[key] = results.value("_".join(key), formula, lambda rate: 100 * rate, row.growth_per_s, unit="%/s")
    columns = {
        f"step of {step.replace('ms', ' ms')}": [_shown(rows, growths, (solver, step)) for solver in SOLVERS]
        for step in STEPS
    }
    return Section(
        tables={"solvers": table_of("solver", SOLVERS.values(), columns)},
        claims=[_only_here_it_stays(results, rows, growths)],
    )


def _only_here_it_stays(results: Results, rows: Mapping[tuple[str, str], Row], growths: Growths) -> Claim:
    """Tell whether half the step halves the walk in the other solvers, and not in MuJoCo Warp."""
    formula = "growth with half the step over that with the whole"
    kept = {
        solver: ratio(results, f"{solver}_kept", formula, growths[solver, SHORT], growths[solver, LONG])
        for solver in SOLVERS
        if {(solver, SHORT), (solver, LONG)} <= set(growths)
    }
    mine = kept.pop("mujoco", None) or absent("1", "MuJoCo Warp was not run")
    others = list(kept.values())
    largest = extreme(results, "others_kept", "largest of the others", max, others)
    count = cell_count(results, "other_count", "others", others)
    lost = absent("%/s", "MuJoCo Warp does not hold the box, or was not run")
    numbers: dict[str, Quantity] = {"largest": largest, "count": count}
    for name, step in (("long", LONG), ("short", SHORT)):
        numbers |= {name: rows["mujoco", step].step_ms, f"growth_{name}": growths.get(("mujoco", step)) or lost}
    outcome = all_of(at_least(mine, 0.9, why="about as much"), at_most(largest, 0.6, why="about half"))
    return Claim("only_here_it_stays", outcome, numbers)


def _shown(rows: Mapping[tuple[str, str], Row], growths: Growths, key: tuple[str, str]) -> Quantity | str:
    """What the table shows of a run: its growth, or how the box was lost."""
    row = rows[key]
    if row and not row.stays:
        return "sinks in or lost" if row.end_radius_mm.value is not None else row.end_radius_mm
    return growths.get(key) or absent("%/s", "it was not run")
