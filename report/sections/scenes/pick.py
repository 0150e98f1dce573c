"""Compare a Panda that lifts and shakes a cube or a ball with published failures."""

from itertools import product

from report.shared import (
    AS_PUBLISHED,
    PERCENT,
    Claim,
    Results,
    Section,
    all_of,
    at_least,
    at_most,
    constant,
    departure,
    extreme,
    gathered,
    table_of,
)

OBJECTS = ("cube", "ball")
SETTINGS = {
    "published": "as published",
    "elliptic": "elliptic cone, impratio 10",
    "short": "timeconst 4 ms",
}
ENGINES = {"c": "MuJoCo C", "newton": "through Newton"}
# From the results of phys-bench for MuJoCo of 2026-01-17, with the short step, in which
# no grasp held (output/mujoco_grasp_shake_*.json).
PUBLISHED_DROP_S = {"cube": 12.052, "ball": 6.022}


def derive(results: Results) -> Section:
    cube_published, ball_published = (
        results.value(f"published_{kind}_2ms", AS_PUBLISHED, constant(time, "s"))
        for kind, time in PUBLISHED_DROP_S.items()
    )
    published = [
        results.row[f"{kind}-{step}-published-{engine}"]
        for kind in OBJECTS
        for step in ("2ms", "10ms")
        for engine in ENGINES
    ]
    held = results.value(
        "published_held",
        "shakes that a grasp survives with the published settings",
        gathered(sum, [row.held_count for row in published]),
    )
    count = results.value(
        "published_shakes",
        "runs with the published settings",
        gathered(sum, [row.seed_count for row in published]),
    )
    latest = results.value(
        "published_latest",
        "time of the last drop with the published settings",
        extreme(max, (row.last_drop_s for row in published)),
    )
    lifted = [row.lifted_count for row in published if "-10ms-" in row.case]
    fails = all_of(
        at_most(held, 0.0, "as published, no grasp holds"),
        at_most(
            latest, 20.0, "in the published test, an object held for so long has passed"
        ),
    )

    # Test whether the creep in a grasp that is not shaken predicts when the ball drops.
    still = results.row["ball-published-held"]
    ball = results.row["ball-2ms-published-c"]
    begin = results.chosen(
        "hold_start", "the time at which the creep is first recorded", 4.5, "s"
    )
    passes = results.value(
        "ball_passes",
        "time at which the ball has crept to the edge of the pads",
        begin + still.margin_mm / still.forecast_creep_mm_s,
    )
    drop_off = results.value(
        "ball_drop_off",
        "absolute difference between the time of the drop and this time, relative to"
        " the latter",
        departure(ball.median_drop_s, passes),
    )
    gap = results.value(
        "ball_drop_spread",
        "time of the last drop of the ball minus the time of the first",
        ball.last_drop_s - ball.first_drop_s,
    )
    ball_off = results.value(
        "ball_off",
        "absolute difference between the time of the drop and the published one,"
        " relative to the latter",
        departure(ball.median_drop_s, ball_published),
    )
    soon = "a drop follows soon after the ball has crept to the edge"
    creeps_out = all_of(
        at_most(drop_off, 20.0, soon),
        at_most(gap, 0.1, "the same time in every shake"),
        at_most(ball_off, 5.0, "the same time"),
    )

    when = results.row["cube-published-held"].forecast_drop_s
    drop = results.row["cube-2ms-published-c"].median_drop_s
    share = results.value(
        "cube_drop_share",
        "time of the drop divided by the time at which creep without a shake would move the cube out",
        PERCENT * drop / when,
    )
    shaken_out = at_most(share, 80.0, "well before that time").having_read(
        cube_published
    )

    elliptic = [results.row[f"{kind}-2ms-elliptic-c"] for kind in OBJECTS]
    elliptic_count = results.value(
        "elliptic_c_count",
        "runs with an elliptic cone and impratio 10",
        gathered(sum, [row.seed_count for row in elliptic]),
    )
    elliptic_held = results.value(
        "elliptic_c_held",
        "shakes that a grasp survives with an elliptic cone and impratio 10",
        gathered(sum, [row.held_count for row in elliptic]),
    )

    through_newton = results.row["cube-2ms-elliptic-newton"]

    tried = list(product(OBJECTS, SETTINGS))
    columns: dict[str, list] = {}
    for engine, name in ENGINES.items():
        rows = [
            results.row[f"{kind}-2ms-{setting}-{engine}"] for kind, setting in tried
        ]
        columns[f"shakes survived, {name}"] = [row.held_count for row in rows]
        columns[f"time of the drop, {name}"] = [
            row.median_drop_s
            if row.median_drop_s.value or not row.held_count.value
            else "never"
            for row in rows
        ]
    names = [f"{kind}, {SETTINGS[setting]}" for kind, setting in tried]
    return Section(
        tables={"drops": table_of("object and setting", names, columns)},
        claims=[
            Claim(
                "fails_as_published",
                fails.having_read(*lifted),
                {
                    "count": count,
                    "is_lifted": any(cell.value for cell in lifted),
                    "latest": latest,
                },
            ),
            Claim(
                "ball_creeps_out",
                creeps_out,
                {
                    "creep": still.forecast_creep_mm_s,
                    "margin": still.margin_mm,
                    "when": passes,
                    "drop": ball.median_drop_s,
                    "published": ball_published,
                },
            ),
            Claim(
                "cube_is_shaken_out",
                shaken_out,
                {"when": when, "drop": drop, "published": cube_published},
            ),
            Claim(
                "elliptic_holds",
                at_least(elliptic_held, elliptic_count),
                {"held": elliptic_held, "count": elliptic_count},
            ),
            Claim(
                "newton_holds",
                at_least(through_newton.held_count, through_newton.seed_count),
                {
                    "held": through_newton.held_count,
                    "count": through_newton.seed_count,
                },
            ),
        ],
    )
