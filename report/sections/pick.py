"""A Panda that picks up a cube or a ball and shakes it: does it fail as published, and what helps?"""

from collections.abc import Mapping
from itertools import product

import pandas as pd
from matplotlib.figure import Figure as Drawing

from measured_report.claims.claims import Claim, all_of, at_least, at_most, greater
from measured_report.parts.figures import INK, SERIES, is_narrow, new_figure
from measured_report.parts.parts import Figure, Section, Table
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row
from report.names import case_html, name_of
from report.shared.arithmetic import departure, difference, extreme, share

order = 182
page = "scenes"
label = "a Panda's shake"

OBJECTS = ("cube", "ball")
STEPS = ("2ms", "10ms")
SETTINGS = ("published", "elliptic", "short")
ENGINES = {"c": "MuJoCo C", "newton": "MuJoCo Warp through Newton"}
PUBLISHED_DROP_S = {("cube", "2ms"): 12.052, ("cube", "10ms"): 4.0, ("ball", "2ms"): 6.022, ("ball", "10ms"): 4.0}
"""phys-bench's results for MuJoCo of 2026-01-17: none held (output/mujoco_grasp_shake_*.json)."""
RUNS = tuple(f"{kind}-{step}-{setting}" for kind, step, setting in product(OBJECTS, STEPS, SETTINGS))
HELD = tuple(f"{kind}-{setting}" for kind, setting in product(OBJECTS, SETTINGS))
END_S = 20.0


def derive(results: Results) -> Section:
    rows = {f"{run}-{engine}": results.row[f"{run}-{engine}"] for run in RUNS for engine in ENGINES}
    held = {name: results.row[f"{name}-held"] for name in HELD}
    published = {
        run: results.value(
            f"published_{run[0]}_{run[1]}", "published, and not measured here", lambda time=time: time, unit="s"
        )
        for run, time in PUBLISHED_DROP_S.items()
    }
    figure = Figure(
        draw=lambda: _draw(rows, published),
        sources=[row.held_count for row in rows.values()],
        numbers={
            "cube": rows["cube-2ms-published-c"].median_drop_s,
            "ball": rows["ball-2ms-published-c"].median_drop_s,
        },
    )
    return Section(
        tables={"runs": _table(rows), "held": _held_table(held)},
        figures={"drops": figure},
        claims=[
            _fails_as_published(results, rows),
            _ball_drops_when_published(results, rows, published),
            _cube_stays_longer(results, rows, published),
            *(_elliptic_holds(results, rows, engine) for engine in ENGINES),
            _shorter_does_not(results, rows),
            _ball_creeps_out(results, rows, held),
            _cube_is_shaken_out(results, rows, held),
            _creep_is_predicted(results, held),
            _long_step_lifts_nothing(results, rows),
            _implicitfast_shakes_harder(results),
        ],
    )


def _total(results: Results, name: str, formula: str, rows: list[Row], column: str) -> Value:
    return results.value(name, formula, lambda *counts: sum(counts), *(row[column] for row in rows))


def _fails_as_published(results: Results, rows: Mapping[str, Row]) -> Claim:
    """With both steps, in C and through Newton."""
    mine = [rows[f"{kind}-{step}-published-{engine}"] for kind, step in PUBLISHED_DROP_S for engine in ENGINES]
    held = _total(results, "published_held", "shakes that a grasp stood as published", mine, "held_count")
    count = _total(results, "published_count", "shakes as published", mine, "seed_count")
    none = results.chosen("published_bound", "published: none", 0.0)
    latest = extreme(results, "published_latest", "last drop as published", max, [row.last_drop_s for row in mine])
    end = results.chosen("end", "published: what is held then has passed", END_S, unit="s")
    outcome = all_of(at_most(held, none), at_most(latest, end))
    return Claim("fails_as_published", outcome, {"count": count, "latest": latest})


def _ball_drops_when_published(
    results: Results, rows: Mapping[str, Row], published: Mapping[tuple[str, str], Value]
) -> Claim:
    drop, then = rows["ball-2ms-published-c"].median_drop_s, published["ball", "2ms"]
    off = departure(results, "ball_off", "time of the drop less the published one, in size, of the latter", drop, then)
    bound = results.chosen("ball_bound", "the same time", 5.0, unit="%")
    return Claim("ball_drops_when_published", at_most(off, bound), {"drop": drop, "published": then, "off": off})


def _cube_stays_longer(results: Results, rows: Mapping[str, Row], published: Mapping[tuple[str, str], Value]) -> Claim:
    row, then = rows["cube-2ms-published-c"], published["cube", "2ms"]
    noise = difference(
        results, "cube_spread", "last drop of the cube less the first", row.last_drop_s, row.first_drop_s
    )
    outcome = greater(row.median_drop_s, then, noise=noise)
    return Claim("cube_stays_longer", outcome, {"drop": row.median_drop_s, "published": then, "noise": noise})


def _elliptic_holds(results: Results, rows: Mapping[str, Row], engine: str) -> Claim:
    mine = [rows[f"{kind}-2ms-elliptic-{engine}"] for kind in OBJECTS]
    name = f"elliptic_{engine}"
    held = _total(results, f"{name}_held", "shakes that an elliptic cone and impratio 10 stood", mine, "held_count")
    count = _total(results, f"{name}_count", "shakes with them", mine, "seed_count")
    cube = mine[OBJECTS.index("cube")].held_count
    return Claim(f"{name}_holds", at_least(held, count), {"held": held, "count": count, "cube": cube})


def _shorter_does_not(results: Results, rows: Mapping[str, Row]) -> Claim:
    """Some of the shakes end in a drop, and later than as published."""
    mine = [rows[f"{kind}-2ms-short-{engine}"] for kind in OBJECTS for engine in ENGINES]
    held = _total(results, "short_held", "shakes stood with a timeconst of 4 ms", mine, "held_count")
    count = _total(results, "short_count", "shakes with it", mine, "seed_count")
    most = results.value("short_most", "one less than all of these", lambda number: number - 1, count)
    later = at_least(rows["ball-2ms-short-c"].median_drop_s, rows["ball-2ms-published-c"].median_drop_s)
    numbers = {"held": held, "count": count, "ball": rows["ball-2ms-short-c"].median_drop_s}
    numbers |= {"published": rows["ball-2ms-published-c"].median_drop_s}
    return Claim("shorter_does_not", all_of(at_most(held, most), later), numbers)


def _ball_creeps_out(results: Results, rows: Mapping[str, Row], held: Mapping[str, Row]) -> Claim:
    """When the ball drops is told from the creep of a grasp that is not shaken at all."""
    found, row = held["ball-published"], rows["ball-2ms-published-c"]
    start = results.chosen("hold_start", "when the creep began to be watched", 4.5, unit="s")
    formula = "time after which the ball has crept as far as it is from the edge"
    when = results.value(
        "ball_passes",
        formula,
        lambda begin, margin, creep: begin + margin / creep,
        start,
        found.margin_mm,
        found.forecast_creep_mm_s,
        unit="s",
    )
    formula = "time of the drop less that, in size, of the latter"
    off = departure(results, "ball_drop_off", formula, row.median_drop_s, when)
    bound = results.chosen(
        "drop_bound", "soon after it has passed the edge, from which it still has to fall", 20.0, unit="%"
    )
    apart = results.value(
        "ball_drop_spread",
        "last drop of the ball less the first",
        lambda a, b: a - b,
        row.last_drop_s,
        row.first_drop_s,
        unit="s",
    )
    numbers = {"creep": found.forecast_creep_mm_s, "margin": found.margin_mm, "when": when}
    together = results.chosen("together_bound", "whatever the shake", 0.1, unit="s")
    numbers |= {"drop": row.median_drop_s, "off": off, "apart": apart, "count": row.seed_count}
    return Claim("ball_creeps_out", all_of(at_most(off, bound), at_most(apart, together)), numbers)


def _cube_is_shaken_out(results: Results, rows: Mapping[str, Row], held: Mapping[str, Row]) -> Claim:
    when, drop = held["cube-published"].forecast_drop_s, rows["cube-2ms-published-c"].median_drop_s
    early = share(results, "cube_drop_share", "time of the drop, of when its creep alone would take it out", drop, when)
    bound = results.chosen("shaken_out_bound", "well before", 80.0, unit="%")
    return Claim("cube_is_shaken_out", at_most(early, bound), {"when": when, "drop": drop})


def _creep_is_predicted(results: Results, held: Mapping[str, Row]) -> Claim:
    factors = [
        results.value(
            f"{name}_factor",
            "the larger of measured and predicted creep, of the smaller",
            lambda a, b: max(a / b, b / a),
            row.creep_mm_s,
            row.forecast_creep_mm_s,
        )
        for name, row in held.items()
    ]
    largest = extreme(results, "held_factor", "largest factor between measured and predicted creep", max, factors)
    bound = results.chosen("held_bound", "a prediction to go by", 1.5)
    slow, fast = (held[f"ball-{setting}"].creep_mm_s for setting in ("elliptic", "published"))
    return Claim("creep_is_predicted", at_most(largest, bound), {"largest": largest, "slow": slow, "fast": fast})


def _long_step_lifts_nothing(results: Results, rows: Mapping[str, Row]) -> Claim:
    mine = [rows[f"{kind}-10ms-{setting}-{engine}"] for kind in OBJECTS for setting in SETTINGS for engine in ENGINES]
    lifted = _total(results, "long_lifted", "grasps with a step of 10 ms that lift their object", mine, "lifted_count")
    count = _total(results, "long_count", "grasps with a step of 10 ms", mine, "seed_count")
    none = results.chosen("long_bound", "not one", 0.0)
    step = results.chosen("long_step", "as published", 10.0, unit="ms")
    return Claim("long_step_lifts_nothing", at_most(lifted, none), {"count": count, "step": step})


def _implicitfast_shakes_harder(results: Results) -> Claim:
    """With implicitfast the arm lifts with either step, and drops what an elliptic cone holds with Euler."""
    mine = [results.row[f"{kind}-{step}-elliptic-implicitfast"] for kind in OBJECTS for step in STEPS]
    lifted = _total(
        results, "implicitfast_lifted", "grasps with implicitfast that lift their object", mine, "lifted_count"
    )
    held = _total(results, "implicitfast_held", "of these that stand the shake", mine, "held_count")
    count = _total(results, "implicitfast_count", "grasps with implicitfast", mine, "seed_count")
    none = results.chosen("implicitfast_bound", "not one", 0.0)
    outcome = all_of(at_least(lifted, count), at_most(held, none))
    return Claim("implicitfast_shakes_harder", outcome, {"count": count})


def _table(rows: Mapping[str, Row]) -> Table:
    columns: dict[str, list] = {}
    for engine, label in ENGINES.items():
        columns[f"held, {label}"] = [rows[f"{run}-{engine}"].held_count for run in RUNS]
        columns[f"dropped at, {label}"] = [rows[f"{run}-{engine}"].median_drop_s for run in RUNS]
    return Table(pd.DataFrame(columns, index=pd.Index(map(case_html, RUNS), name="run")))


def _held_table(held: Mapping[str, Row]) -> Table:
    columns = {
        "creep": [row.creep_mm_s for row in held.values()],
        "by the law of its contacts": [row.predicted_creep_mm_s for row in held.values()],
        "by parameters and depth": [row.forecast_creep_mm_s for row in held.values()],
        "to the pads' edge": [row.margin_mm for row in held.values()],
        "there at": [row.forecast_drop_s for row in held.values()],
    }
    return Table(pd.DataFrame(columns, index=pd.Index(map(case_html, HELD), name="grasp")))


def _draw(rows: Mapping[str, Row], published: Mapping[tuple[str, str], Value]) -> Drawing:
    """A line from the first drop to the last of each case; what is held ends at the right edge."""
    runs = [run for run in RUNS if "2ms" in run]
    drawing, axes = new_figure(7.2, 1.2 + (0.5 if is_narrow() else 0.4) * len(runs))
    for number, (engine, label) in enumerate(ENGINES.items()):
        shift = 0.3 * (number - 0.5)
        named = False
        for place, run in enumerate(runs):
            row = rows[f"{run}-{engine}"]
            ends = (row.first_drop_s.value, row.last_drop_s.value) if row.median_drop_s.value else ()
            text = None if named else label
            colour = SERIES[number]
            if ends:
                axes.plot(
                    ends,
                    [place + shift] * 2,
                    color=colour,
                    linestyle="-",
                    linewidth=3.0,
                    marker="|",
                    markevery=1,
                    label=text,
                )
            if row.held_count.value:
                axes.plot(
                    [END_S],
                    [place + shift],
                    color=colour,
                    linestyle="",
                    marker=">",
                    markevery=1,
                    label=None if ends else text,
                )
            named = named or bool(ends) or bool(row.held_count.value)
    for kind in OBJECTS:
        place = runs.index(f"{kind}-2ms-published")
        label = "published" if kind == OBJECTS[0] else None
        axes.plot(
            [published[kind, "2ms"].value], [place], linestyle="", marker="D", markevery=1, color=INK, label=label
        )
    axes.set_yticks(range(len(runs)), map(name_of, runs))
    axes.invert_yaxis()
    axes.set_xlim(4.0, 20.5)
    axes.set_xlabel("dropped at [s]; held where an arrow ends it")
    drawing.legend(loc="outside upper center", ncols=1 if is_narrow() else 3)
    return drawing
