"""A Panda that picks up a cube or a ball and shakes it: does it fail as published, and what helps?"""

from collections.abc import Mapping
from itertools import product
from typing import Any

from matplotlib.figure import Figure as Drawing

from measured_report.parts.claim import HOLDS, Claim, all_of, at_least, at_most
from measured_report.parts.figures import INK, SERIES, is_narrow, new_figure
from measured_report.parts.section import Figure, Section
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row
from report.shared.arithmetic import departure, difference, extreme, share, total
from report.shared.drawing import mark_points, name_lines

OBJECTS = ("cube", "ball")
STEPS = ("2ms", "10ms")
SETTINGS = {"published": "as published", "elliptic": "elliptic cone", "short": "timeconst 4 ms"}
ENGINES = {"c": "MuJoCo C", "newton": "MuJoCo Warp through Newton"}
PUBLISHED_DROP_S = {("cube", "2ms"): 12.052, ("cube", "10ms"): 4.0, ("ball", "2ms"): 6.022, ("ball", "10ms"): 4.0}
"""phys-bench's results for MuJoCo of 2026-01-17: none held (output/mujoco_grasp_shake_*.json)."""
RUNS = tuple(f"{kind}-{step}-{setting}" for kind, step, setting in product(OBJECTS, STEPS, SETTINGS))
END_S = 20.0
Rows = Mapping[str, Row]
Times = Mapping[tuple[str, str], Value]
"""Published times of a drop by object and step."""


def derive(results: Results) -> Section:
    rows = {f"{run}-{engine}": results.row[f"{run}-{engine}"] for run in RUNS for engine in ENGINES}
    held = {kind: results.row[f"{kind}-published-held"] for kind in OBJECTS}
    published = {
        run: results.value(f"published_{'_'.join(run)}", "published, and not measured here", lambda t=time: t, unit="s")
        for run, time in PUBLISHED_DROP_S.items()
    }
    fails, elliptic = _fails_as_published(results, rows), _elliptic_holds(results, rows, "c")
    drops = {kind: rows[f"{kind}-2ms-published-c"].median_drop_s for kind in OBJECTS}
    flags = {"is_held": all_of(fails.outcome, elliptic.outcome) == HOLDS}
    sources = [row.held_count for row in rows.values()]
    return Section(
        figures={"drops": Figure(lambda: _draw(rows, published), sources, drops | flags)},
        claims=[
            fails,
            _ball_creeps_out(results, rows, held, published),
            _cube_is_shaken_out(results, rows, held, published),
            elliptic,
            _elliptic_holds(results, rows, "newton"),
            _shorter_does_not(results, rows),
            _long_step_lifts_nothing(results, rows),
        ],
    )


def _fails_as_published(results: Results, rows: Rows) -> Claim:
    mine = [rows[f"{kind}-{step}-published-{engine}"] for kind, step in PUBLISHED_DROP_S for engine in ENGINES]
    formula = "shakes that a grasp stood as published"
    held = total(results, "published_held", formula, [row.held_count for row in mine])
    count = total(results, "published_shakes", "shakes as published", [row.seed_count for row in mine])
    latest = extreme(results, "published_latest", "last drop as published", max, [row.last_drop_s for row in mine])
    passed = at_most(latest, END_S, why="published: what is held then has passed")
    outcome = all_of(at_most(held, 0.0, why="published: none"), passed)
    return Claim("fails_as_published", outcome, {"count": count, "latest": latest})


def _elliptic_holds(results: Results, rows: Rows, engine: str) -> Claim:
    mine = [rows[f"{kind}-2ms-elliptic-{engine}"] for kind in OBJECTS]
    name, formula = f"elliptic_{engine}", "shakes that an elliptic cone and impratio 10 stood"
    held = total(results, f"{name}_held", formula, [row.held_count for row in mine])
    count = total(results, f"{name}_count", "shakes with them", [row.seed_count for row in mine])
    cube = mine[OBJECTS.index("cube")].held_count
    return Claim(f"{name}_holds", at_least(held, count), {"held": held, "count": count, "cube": cube})


def _shorter_does_not(results: Results, rows: Rows) -> Claim:
    mine = [rows[f"{kind}-2ms-short-{engine}"] for kind in OBJECTS for engine in ENGINES]
    held = total(results, "short_held", "shakes stood with a timeconst of 4 ms", [row.held_count for row in mine])
    count = total(results, "short_count", "shakes with it", [row.seed_count for row in mine])
    most = results.value("short_most", "one less than all of these", lambda number: number - 1, count)
    ball, published = (rows[f"ball-2ms-{setting}-c"].median_drop_s for setting in ("short", "published"))
    outcome = all_of(at_most(held, most), at_least(ball, published))
    return Claim("shorter_does_not", outcome, {"held": held, "count": count})


def _ball_creeps_out(results: Results, rows: Rows, held: Rows, published: Times) -> Claim:
    """Tell whether the creep of a grasp that is not shaken at all says when the ball drops."""
    found, row = held["ball"], rows["ball-2ms-published-c"]
    begin = results.chosen("hold_start", "when the creep began to be watched", 4.5, unit="s")
    formula = "time after which the ball has crept as far as it is from the edge"
    cells = begin, found.margin_mm, found.forecast_creep_mm_s
    when = results.value("ball_passes", formula, lambda start, margin, creep: start + margin / creep, *cells, unit="s")
    formula = "time of the drop less that, in size, of the latter"
    off = departure(results, "ball_drop_off", formula, row.median_drop_s, when)
    formula = "last drop of the ball less the first"
    apart = difference(results, "ball_drop_spread", formula, row.last_drop_s, row.first_drop_s)
    soon = at_most(off, 20.0, why="soon after it has passed the edge, from which it still has to fall")
    then, formula = published["ball", "2ms"], "time of the drop less the published one, in size, of the latter"
    from_published = departure(results, "ball_off", formula, row.median_drop_s, then)
    outcome = all_of(
        soon, at_most(apart, 0.1, why="whatever the shake"), at_most(from_published, 5.0, why="the same time")
    )
    numbers = {"begin": begin, "creep": found.forecast_creep_mm_s, "margin": found.margin_mm, "when": when}
    return Claim("ball_creeps_out", outcome, numbers | {"drop": row.median_drop_s, "published": then})


def _cube_is_shaken_out(results: Results, rows: Rows, held: Rows, published: Times) -> Claim:
    when, drop = held["cube"].forecast_drop_s, rows["cube-2ms-published-c"].median_drop_s
    early = share(results, "cube_drop_share", "time of the drop, of when its creep alone would take it out", drop, when)
    then = published["cube", "2ms"]
    outcome = at_most(early, 80.0, why="well before").having_read(then)
    return Claim("cube_is_shaken_out", outcome, {"when": when, "drop": drop, "published": then})


def _long_step_lifts_nothing(results: Results, rows: Rows) -> Claim:
    mine = [rows[f"{kind}-10ms-{setting}-{engine}"] for kind in OBJECTS for setting in SETTINGS for engine in ENGINES]
    formula = "grasps with a step of 10 ms"
    lifted = total(results, "long_lifted", f"{formula} that lift their object", [row.lifted_count for row in mine])
    count = total(results, "long_count", formula, [row.seed_count for row in mine])
    step = results.chosen("long_step", "as published", 10.0, unit="ms")
    return Claim("long_step_lifts_nothing", at_most(lifted, 0.0, why="not one"), {"count": count, "step": step})


def _draw(rows: Rows, published: Times) -> Drawing:
    """Draw a line from the first drop to the last of each case; what is held ends at the right edge."""
    runs = [run for run in RUNS if "2ms" in run]
    drawing, axes = new_figure(7.2, 1.2 + (0.5 if is_narrow() else 0.4) * len(runs))
    for number, (engine, label) in enumerate(ENGINES.items()):
        style: dict[str, Any] = {"color": SERIES[number], "markevery": 1, "label": label}
        for place, run in enumerate(runs):
            row, height = rows[f"{run}-{engine}"], place + 0.3 * (number - 0.5)
            if row.median_drop_s.value:
                ends = row.first_drop_s.value, row.last_drop_s.value
                axes.plot(ends, [height] * 2, linestyle="-", linewidth=3.0, marker="|", **style)
                style.pop("label", None)
            if row.held_count.value:
                axes.plot([END_S], [height], linestyle="", marker=">", **style)
                style.pop("label", None)
    for kind in OBJECTS:
        place = runs.index(f"{kind}-2ms-published")
        label = "published" if kind == OBJECTS[0] else None
        mark_points(axes, [(published[kind, "2ms"].value, place)], marker="D", color=INK, label=label)
    name_lines(axes, [f"{kind}, 2 ms, {setting}" for kind in OBJECTS for setting in SETTINGS.values()])
    axes.set(xlim=(4.0, 20.5), xlabel="dropped at [s]; held where an arrow ends it")
    drawing.legend(loc="outside upper center", ncols=1 if is_narrow() else 3)
    return drawing
