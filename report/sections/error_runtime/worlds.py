"""One core of C against many worlds in Warp."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from markupsafe import Markup

from measured_report.parts.claim import HOLDS, Claim, all_of, contiguous, greater
from measured_report.parts.section import Figure
from measured_report.values.quantities import Value
from measured_report.values.results import Row
from report.sections.error_runtime.figures import draw_worlds
from report.sections.error_runtime.runs import ENGINES, Points
from report.shared.arithmetic import ratio
from report.shared.timing import compared, resolution, worlds_name


def derive_worlds(points: Points) -> tuple[Figure, Claim]:
    """Derive the figure of speed against the number of worlds, and from how many worlds on Warp beats one core."""
    results, rows = points.results, points.worlds
    # From the times that it took in turn with each number of worlds: alone a core may run at another pace.
    formula = "simulated seconds of one world per second, MuJoCo C on one core, median of all comparisons"
    pairs = [quantity for row in rows for quantity in (row.time_ratio, row.ms_per_s)]
    one_core = results.value("one_core_rate", formula, _rate_of_one, *pairs, unit="world-s/s")
    formula, unit = "simulated seconds of all worlds together per second", one_core.unit
    rates = [
        results.value(f"rate_{row.case}", formula, lambda n, time: 1e3 * n / time, row.worlds, row.ms_per_s, unit=unit)
        for row in rows
    ]
    crossover = results.value(
        "crossover_worlds",
        "least number of worlds with which Warp is as fast as C, interpolated in logarithms between measured ones",
        lambda core, *cells: crossing(core, cells[::2], cells[1::2]),
        one_core,
        *(quantity for row, rate in zip(rows, rates, strict=True) for quantity in (row.worlds, rate)),
    )
    engine = ENGINES[rows[0].backend]
    said = (Markup("{}: {}").format(worlds_name(row.worlds.value), rate) for row, rate in zip(rows, rates, strict=True))
    worst = resolution(results, "worlds_resolution", compared(rows))
    claim = _crossover_claim(points, engine, one_core, rates, crossover)
    claim = replace(claim, outcome=claim.outcome.having_read(worst))
    numbers = {"rates": Markup("; ").join(said), "resolution": worst, "crossover": crossover, "engine": engine}
    figure = Figure(
        draw=lambda: draw_worlds(rows, rates, one_core, crossover, engine),
        sources=[*rates, one_core],
        numbers=numbers | {"is_overtaken": claim.outcome == HOLDS},
    )
    return figure, claim


def _rate_of_one(*cells: float) -> float:
    return float(np.median([1e3 * ratio / time for ratio, time in zip(cells[::2], cells[1::2], strict=True)]))


def crossing(level: float, worlds: Sequence[float], rates: Sequence[float]) -> float:
    """Find the worlds with which a rising line first reaches ``level``; NaN when it does not, or starts above it."""
    above = [rate >= level for rate in rates]
    if True not in above or above[0] or min(rates) <= 0.0:
        return float("nan")
    after = above.index(True)
    pair = slice(after - 1, after + 1)
    return int(np.ceil(np.exp(np.interp(np.log(level), np.log(rates[pair]), np.log(worlds[pair]))) - 1e-9))


def _crossover_claim(points: Points, engine: str, one_core: Value, rates: Sequence[Value], crossover: Value) -> Claim:
    results, (first, last), ends = points.results, (rates[0], rates[-1]), (points.worlds[0], points.worlds[-1])
    advantage = ratio(
        results, "one_core_advantage", "speed of C on one core over that of Warp with one world", one_core, first
    )
    formula = "speed of Warp with the most worlds over that of C on one core"
    gain = ratio(results, "worlds_gain", formula, last, one_core)
    seen = [_rate_seen(points, *each) for each in zip(("first", "last"), ends, (first, last), strict=True)]
    is_ahead = [None not in (rate.value, one_core.value) and rate.value >= one_core.value for rate in rates]
    outcome = all_of(
        greater(one_core, first, noise=seen[0]),
        greater(last, one_core, noise=seen[1]),
        contiguous(is_ahead, *rates, one_core),
    )
    numbers = {"advantage": advantage, "engine": engine, "crossover": crossover, "gain": gain}
    return Claim("crossover", outcome, numbers | {"most": ends[1].worlds})


def _rate_seen(points: Points, name: str, row: Row, rate: Value) -> Value:
    """Derive what difference to the speed of one core would be seen with these worlds [world-s/s]."""
    formula = "resolution of the ratio of its time to that of one core, of the speed with these worlds"
    sources = rate, row.ratio_resolution
    return points.results.value(
        f"{name}_rate_seen", formula, lambda rate, seen: rate * seen, *sources, unit=rate.unit, is_noise=True
    )
