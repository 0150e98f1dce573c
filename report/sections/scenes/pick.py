"""A Panda that picks up a cube or a ball and shakes it: does it fail as published, and what helps?"""

from itertools import product

from report.shared import (
    PERCENT,
    PUBLISHED,
    Claim,
    Column,
    Results,
    Section,
    Table,
    Value,
    all_of,
    at_least,
    at_most,
    constant,
    departure,
    extreme,
    gathered,
    table_of,
)

OBJECTS, STEPS = ("cube", "ball"), ("2ms", "10ms")
SETTINGS = {
    "published": "as published",
    "elliptic": "elliptic cone, impratio 10",
    "short": "timeconst 4 ms",
}
ENGINES = {"c": "MuJoCo C", "newton": "through Newton"}
PUBLISHED_DROP_S = {"cube": 12.052, "ball": 6.022}
"""phys-bench's results for MuJoCo of 2026-01-17, with the short step: none held (output/mujoco_grasp_shake_*.json)."""


def derive(results: Results) -> Section:
    drops = {
        f"published_{kind}_2ms": constant(time, "s")
        for kind, time in PUBLISHED_DROP_S.items()
    }
    cube, ball = (results.value(name, PUBLISHED, time) for name, time in drops.items())
    claims = [_fails_as_published(results), _ball_creeps_out(results, ball)]
    when, drop = (
        results.row["cube-published-held"].forecast_drop_s,
        results.row["cube-2ms-published-c"].median_drop_s,
    )
    early = at_most(
        results.value(
            "cube_drop_share",
            "time of the drop, of when its creep alone would take it out",
            PERCENT * drop / when,
        ),
        80.0,
        why="well before",
    )
    numbers = {"when": when, "drop": drop, "published": cube}
    claims += [Claim("cube_is_shaken_out", early.having_read(cube), numbers)]
    mine, formula = (
        [results.row[f"{kind}-2ms-elliptic-c"] for kind in OBJECTS],
        "shakes with them",
    )
    count = results.value(
        "elliptic_c_count", formula, gathered(sum, [row.seed_count for row in mine])
    )
    held = results.value(
        "elliptic_c_held",
        "shakes that an elliptic cone and impratio 10 stood",
        gathered(sum, [row.held_count for row in mine]),
    )
    claims += [
        Claim("elliptic_holds", at_least(held, count), {"held": held, "count": count})
    ]
    return Section(tables={"drops": _table(results)}, claims=claims)


def _table(results: Results) -> Table:
    tried, columns = list(product(OBJECTS, SETTINGS)), dict[str, Column]()
    for engine, name in ENGINES.items():
        rows = [
            results.row[f"{kind}-2ms-{setting}-{engine}"] for kind, setting in tried
        ]
        columns |= {f"held, {name}": [row.held_count for row in rows]}
        times = [(row.median_drop_s, row.held_count) for row in rows]
        columns |= {
            f"dropped, {name}": [
                time if time.value or not held.value else "never"
                for time, held in times
            ]
        }
    return table_of(
        "object and setting",
        [f"{kind}, {SETTINGS[setting]}" for kind, setting in tried],
        columns,
    )


def _fails_as_published(results: Results) -> Claim:
    mine = [
        results.row[f"{kind}-{step}-published-{engine}"]
        for kind, step, engine in product(OBJECTS, STEPS, ENGINES)
    ]
    held = results.value(
        "published_held",
        "shakes that a grasp stood as published",
        gathered(sum, [row.held_count for row in mine]),
    )
    count = results.value(
        "published_shakes",
        "tries as published",
        gathered(sum, [row.seed_count for row in mine]),
    )
    lifted = [row.lifted_count for row in mine if f"-{STEPS[1]}-" in row.case]
    last = extreme(max, (row.last_drop_s for row in mine))
    latest = results.value("published_latest", "last drop as published", last)
    passed = at_most(latest, 20.0, why="published: what is held then has passed")
    outcome = all_of(at_most(held, 0.0, why="published: none"), passed)
    numbers = {
        "count": count,
        "is_lifted": any(cell.value for cell in lifted),
        "latest": latest,
    }
    return Claim("fails_as_published", outcome.having_read(*lifted), numbers)


def _ball_creeps_out(results: Results, published: Value) -> Claim:
    """Tell whether the creep of a grasp that is not shaken at all says when the ball drops."""
    still, row = results.row["ball-published-held"], results.row["ball-2ms-published-c"]
    begin = results.chosen("hold_start", "when the creep began to be watched", 4.5, "s")
    when = results.value(
        "ball_passes",
        "time after which the ball has crept as far as it is from the edge",
        begin + still.margin_mm / still.forecast_creep_mm_s,
    )
    off = results.value(
        "ball_drop_off",
        "time of the drop less that, in size, of the latter",
        departure(row.median_drop_s, when),
    )
    gap = results.value(
        "ball_drop_spread",
        "last drop of the ball less the first",
        row.last_drop_s - row.first_drop_s,
    )
    soon = at_most(
        off,
        20.0,
        why="soon after it has passed the edge, from which it still has to fall",
    )
    from_published = results.value(
        "ball_off",
        "time of the drop less the published one, in size, of the latter",
        departure(row.median_drop_s, published),
    )
    same = (
        at_most(gap, 0.1, why="whatever the shake"),
        at_most(from_published, 5.0, why="the same time"),
    )
    numbers = {
        "creep": still.forecast_creep_mm_s,
        "margin": still.margin_mm,
        "when": when,
    }
    return Claim(
        "ball_creeps_out",
        all_of(soon, *same),
        numbers | {"drop": row.median_drop_s, "published": published},
    )
