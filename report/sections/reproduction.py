"""The shake test as shipped: does the cube slip, on which engine, and what does a stiffer pad change?"""

import numpy as np
import pandas as pd
from matplotlib.figure import Figure as Drawing

from report.claims import Claim, at_least, at_most
from report.figures import INK, new_figure
from report.parts import Figure, Section, Table
from report.quantities import Value
from report.results import Results, Row, Trace

order = 10

ENGINES = {"warp": "MuJoCo Warp", "mujoco": "MuJoCo C"}
AXES = {"x_mm": "x", "y_mm": "y", "z_mm": "z"}
"""Columns of a trace that hold the displacement in the axes of the TCP frame."""
BATCH_COST_BOUND = {"cuda": 2.0, "cpu": 3.0}
"""Most that a batch may cost against one world, by the device that it runs on."""


def derive(results: Results) -> Section:
    shipped, stiff, hold = results.row["as-shipped"], results.row["stiff-pads"], results.row["hold"]
    traces = {name: results.trace(name) for name in ("as-shipped", "stiff-pads", "hold")}
    claims = [
        _slips(results, shipped),
        _steady(results, shipped, traces["as-shipped"]),
        _needs_shaking(results, shipped, hold),
        _same_on_both_engines(results, shipped, stiff),
        _stiff_pads_hold(results, shipped, stiff),
        _batch_is_cheap(results),
    ]
    displacement = Figure(
        draw=lambda: _draw_displacement(traces),
        caption="Displacement of the cube in the TCP frame since the shake began, by axis.",
        alt=f"Displacement over time in three panels. As shipped the cube moves {shipped.slip_mm} in all, "
        f"with stiff pads {stiff.slip_mm}, with the arm held still {hold.slip_mm}.",
        sources=list(traces.values()),
    )
    shaken = {name: traces[name] for name in ("as-shipped", "stiff-pads")}
    increments = Figure(
        draw=lambda: _draw_increments(shaken, shipped.shake_frequency_hz.value),
        caption="How far each cycle moves the cube along the shake's main axis, from and to the same phase.",
        alt=f"Increment by cycle. As shipped the mean is {shipped.increment_mean_mm}, with stiff pads "
        f"{stiff.increment_mean_mm}.",
        sources=list(shaken.values()),
    )
    return Section(
        tables={"cases": _table(results)},
        figures={"displacement": displacement, "increments": increments},
        claims=claims,
    )


def _slips(results: Results, shipped: Row) -> Claim:
    bound = results.value("slip_bound", "chosen: a slip that can be seen", lambda: 1.0, unit="mm")
    return Claim(
        "slips",
        at_least(shipped.slip_mm, bound),
        holds="As shipped, the cube slips {slip} in {duration} of shaking and drifts at {drift}.",
        fails="As shipped, the cube does not slip visibly: {slip} in {duration} of shaking; {bound} would count.",
        unknown="Whether the cube slips as shipped cannot be told.",
        numbers={
            "slip": shipped.slip_mm,
            "duration": shipped.shake_duration_s,
            "drift": shipped.drift_mm_s,
            "bound": bound,
        },
    )


def _steady(results: Results, shipped: Row, trace: Trace) -> Claim:
    def scatter(frame: pd.DataFrame, frequency_hz: float) -> float:
        later = _cycle_increments(frame, frequency_hz)[1:]
        return 100 * np.abs(later / later.mean() - 1).max() if len(later) > 1 else np.nan

    value = results.value(
        "increment_scatter",
        "largest departure of a cycle's increment from their mean, of the mean, after the first cycle",
        scatter,
        trace,
        shipped.shake_frequency_hz,
        unit="%",
    )
    bound = results.value("increment_scatter_bound", "chosen: steps this equal count as steady", lambda: 10.0, unit="%")
    return Claim(
        "drift_is_steady",
        at_most(value, bound),
        holds="After the first cycle every cycle adds the same step, {mean} on average, to within {scatter}.",
        fails="The cycles do not all add the same step: after the first they depart by up to {scatter} "
        "from their mean.",
        unknown="Whether every cycle adds the same step cannot be told.",
        numbers={"mean": shipped.increment_mean_mm, "scatter": value},
        explanation="The cube is not settling, which would come to an end: each cycle does the same again.",
    )


def _needs_shaking(results: Results, shipped: Row, hold: Row) -> Claim:
    share = results.value(
        "hold_share",
        "slip with the arm held still, of the slip as shipped",
        lambda still, shaken: 100 * still / shaken,
        hold.slip_mm,
        shipped.slip_mm,
        unit="%",
    )
    bound = results.value("hold_share_bound", "chosen: no comparable slip", lambda: 10.0, unit="%")
    return Claim(
        "needs_shaking",
        at_most(share, bound),
        holds="With the arm held still the cube moves {still} in the same time, {share} of that.",
        fails="With the arm held still the cube moves as well: {still} in the same time, {share} of that.",
        unknown="Whether the cube slips with the arm held still cannot be told.",
        numbers={"still": hold.slip_mm, "share": share},
        explanation="It takes the changing load of the shake to move the cube, not time alone.",
    )


def _same_on_both_engines(results: Results, shipped: Row, stiff: Row) -> Claim:
    shipped_c, stiff_c = results.row["as-shipped-mujoco-c"], results.row["stiff-pads-mujoco-c"]
    difference = results.value(
        "engine_difference",
        "larger of the differences in slip between MuJoCo Warp and MuJoCo C, as shipped and with stiff pads",
        lambda a, a_c, b, b_c: max(abs(a - a_c), abs(b - b_c)),
        shipped.slip_mm,
        shipped_c.slip_mm,
        stiff.slip_mm,
        stiff_c.slip_mm,
        unit="mm",
    )
    bound = results.value("engine_bound", "chosen: the calibration's tolerance", lambda: 0.03, unit="mm")
    return Claim(
        "same_on_both_engines",
        at_most(difference, bound),
        holds="The slip does not come from MuJoCo Warp: MuJoCo's C engine gives {slip_c} and {stiff_c}, "
        "at most {difference} away.",
        fails="The engines disagree: MuJoCo's C engine gives {slip_c} and {stiff_c}, up to {difference} away.",
        unknown="Whether MuJoCo's C engine gives the same slip cannot be told.",
        numbers={"slip_c": shipped_c.slip_mm, "stiff_c": stiff_c.slip_mm, "difference": difference},
    )


def _stiff_pads_hold(results: Results, shipped: Row, stiff: Row) -> Claim:
    gain = _ratio(results, "stiff_gain", "slip as shipped over slip with stiff pads", shipped.slip_mm, stiff.slip_mm)
    bound = results.value("stiff_gain_bound", "chosen: a change that settles the matter", lambda: 10.0)
    return Claim(
        "stiff_pads_hold",
        at_least(gain, bound),
        holds="Stiffer pads, and nothing else changed, bring the slip down to {slip}, {gain} times less.",
        fails="Stiffer pads alone do not settle it: the slip is then {slip}, and as shipped it is {gain} times that.",
        unknown="Whether stiffer pads hold the cube cannot be told.",
        numbers={"slip": stiff.slip_mm, "gain": gain},
    )


def _batch_is_cheap(results: Results) -> Claim:
    one, many = sorted(
        (row for row in results.rows if row.case.startswith("batch-")), key=lambda row: row.world_count.value
    )
    cost = _ratio(results, "batch_cost", "wall time of a batch over that of one world", many.wall_s, one.wall_s)
    device = results.record.machine["device"]
    bound = results.value("batch_cost_bound", f"chosen, for {device}", lambda: BATCH_COST_BOUND[device])
    return Claim(
        "batch_is_cheap",
        at_most(cost, bound),
        holds="A batch of {worlds} worlds costs {cost} times as much as one world, within the {bound} times aimed for.",
        fails="A batch of {worlds} worlds costs {cost} times as much as one world, "
        "more than the {bound} times aimed for.",
        unknown="What a batch costs against one world cannot be told.",
        numbers={"worlds": many.world_count, "cost": cost, "bound": bound},
    )


def _ratio(results: Results, name: str, formula: str, a: Value, b: Value) -> Value:
    return results.value(name, formula, lambda above, below: above / below, a, b)


def _table(results: Results) -> Table:
    rows = [row for row in results.rows if "slip_mm" in row]
    columns = {
        "engine": [ENGINES[row.backend] for row in rows],
        "slip": [row.slip_mm for row in rows],
        "drift": [row.drift_mm_s for row in rows],
        "per cycle": [row.increment_mean_mm for row in rows],
        "oscillation": [row.oscillation_mm for row in rows],
        "wander": [row.wander_mm for row in rows],
        "cube height": [row.cube_height_m for row in rows],
        "dropped": [row.dropped for row in rows],
    }
    index = pd.Index([row.case for row in rows], name="case")
    return Table(pd.DataFrame(columns, index=index), "The cases, each run to the end and measured alike.")


def _cycle_increments(frame: pd.DataFrame, frequency_hz: float) -> np.ndarray:
    """Change [mm] along the shake's main axis over each whole cycle, at the phase of the first frame."""
    count = int(np.floor(frame["time_s"].iloc[-1] * frequency_hz + 1e-9))
    return np.diff(np.interp(np.arange(count + 1) / frequency_hz, frame["time_s"], frame["along_mm"]))


def _draw_displacement(traces: dict[str, Trace]) -> Drawing:
    there = {name: trace.value for name, trace in traces.items() if trace.value is not None}
    drawing, panels = new_figure(7.2, 3.2, ncols=len(there), sharey=True, squeeze=False)
    for axes, (name, frame) in zip(panels[0], there.items(), strict=True):
        for start, (column, axis) in enumerate(AXES.items()):
            axes.plot(frame["time_s"], frame[column], label=axis, markevery=(30 * start, 90))
        axes.set_title(name)
    panels[0][0].set_ylabel("displacement [mm]")
    drawing.supxlabel("time since the shake began [s]", fontsize=10)
    drawing.legend(*panels[0][0].get_legend_handles_labels(), loc="outside upper right", ncols=len(AXES))
    return drawing


def _draw_increments(traces: dict[str, Trace], frequency_hz: float) -> Drawing:
    drawing, axes = new_figure(7.2, 3.0)
    for name, trace in traces.items():
        if trace.value is not None:
            increments = _cycle_increments(trace.value, frequency_hz)
            axes.plot(range(1, len(increments) + 1), increments, label=name, markevery=1)
    axes.axhline(0.0, color=INK, linewidth=0.8)
    axes.xaxis.get_major_locator().set_params(integer=True)
    axes.set_xlabel("shake cycle")
    axes.set_ylabel("increment [mm]")
    axes.legend()
    return drawing
