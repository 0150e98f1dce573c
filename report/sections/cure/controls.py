"""Controls: a straight shake, a grasp that only turns, either form of the Jacobian in C, and an arm held still."""

from report.shared import (
    PERCENT,
    Claim,
    Results,
    Section,
    all_of,
    at_least,
    at_most,
    departure,
    extreme,
    largest_size,
)

ENGINES = ("warp", "c")


def derive(results: Results) -> Section:
    claims = [_only_turning_creeps(results), _joints_turn(results)]
    return Section(
        claims=[*claims, _sparse_is_dense(results), _compensation_helps(results)]
    )


def _only_turning_creeps(results: Results) -> Claim:
    straight, turning = (
        [results.row[f"control-{motion}-plain-{engine}"] for engine in ENGINES]
        for motion in ("straight", "turning")
    )
    still = results.value(
        "straight_drift",
        "largest drift of the straight shake, in size",
        largest_size([row.drift_mm_s for row in straight]),
    )
    bound = results.chosen(
        "straight_drift_bound", "a millimetre in a quarter of an hour", 0.001, "mm/s"
    )
    slower = extreme(min, (row.drift_mm_s for row in turning))
    slowest = results.value("turning_drift", "the slower of both engines", slower)
    pairs = [
        (row.case, row.growth_per_s, row.predicted_growth_per_s) for row in turning
    ]
    offs = [
        results.value(
            f"{case}_off",
            "growth of the distance from the axis less that of the law, in size, of the latter",
            departure(*pair),
        )
        for case, *pair in pairs
    ]
    off = results.value("turning_off", "largest of these", extreme(max, offs))
    tests = [
        at_most(still, bound),
        at_least(slowest, 1.0, why="a creep that anyone would see"),
    ]
    outcome = all_of(*tests, at_most(off, 1.0, why="the same creep"))
    return Claim(
        "only_turning_creeps",
        outcome,
        {"bound": bound, "still": still, "turning": slowest, "off": off},
    )


def _joints_turn(results: Results) -> Claim:
    """Tell whether a cube that walls carry along an arc creeps on hinges, turn the walls or not, and not on slides."""
    slides, hinge, both = (
        [
            results.row[f"control-{motion}-plain-{engine}"].drift_mm_s
            for engine in ENGINES
        ]
        for motion in ("two-slides", "hinge", "two-hinges")
    )
    still = results.value(
        "slides_drift", "largest drift on two slides, in size", largest_size(slides)
    )
    turning = results.value(
        "hinge_drift", "the slower of both engines", extreme(min, hinge)
    )
    upright = results.value(
        "hinges_drift", "the slower of both engines", extreme(min, both)
    )
    bound = results.chosen(
        "arc_drift_bound", "a millimetre in a quarter of an hour", 0.001, "mm/s"
    )
    apart = results.value(
        "hinges_off",
        "how far both are apart, of the first",
        departure(upright, turning),
    )
    tests = [
        at_most(still, bound),
        at_least(turning, 0.1, why="six millimetres a minute"),
    ]
    outcome = all_of(
        *tests,
        at_most(
            apart, 5.0, why="the same creep, where the walls turn and where they do not"
        ),
    )
    return Claim(
        "joints_turn",
        outcome,
        {"still": still, "turning": turning, "upright": upright, "bound": bound},
    )


def _sparse_is_dense(results: Results) -> Claim:
    dense, sparse = (
        results.row[f"jacobian-{form}"].slip_mm for form in ("dense", "sparse")
    )
    apart = results.value(
        "jacobian_off",
        "how far the slips are apart, of the first",
        departure(sparse, dense),
    )
    outcome = at_most(apart, 5.0, why="wrong accelerations would change it by more")
    version = results.record.identity.packages["mujoco"]
    numbers = {
        "dense": dense,
        "sparse": sparse,
        "duration": results.row["jacobian-dense"].shake_duration_s,
    }
    return Claim(
        "sparse_is_dense",
        outcome,
        numbers | {"version": version, "has_fault": version == "4.0.0"},
    )


def _compensation_helps(results: Results) -> Claim:
    """Tell what creeps in a minute with the arm held still, with compensated positions and with the root cure."""
    before, after, best = (results.row[case] for case in ("rounded", "kept", "best"))
    bound = results.chosen("creep_bound", "a millimetre or so in a minute", 0.02, "mm")
    gain = results.value(
        "kept_gain",
        "slip with positions rounded over that with compensated ones",
        before.slip_mm / after.slip_mm,
    )
    share = PERCENT * best.slip_mm / before.slip_mm
    rest = results.value("best_share", "of the former slip, that with the cure", share)
    less = (
        at_least(gain, 2.0, why="less by half"),
        at_most(rest, 50.0, why="less by half"),
    )
    outcome = all_of(at_most(after.increment_final_mm, bound), *less)
    numbers = {"slip": before.slip_mm, "slip_kept": after.slip_mm, "best": best.slip_mm}
    return Claim(
        "compensation_helps", outcome, numbers | {"duration": before.shake_duration_s}
    )
