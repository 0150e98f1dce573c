"""Compare control experiments: straight and rotating shakes, both Jacobians, and an arm
held still.
"""

from report.shared import (
    PERCENT,
    Claim,
    Quantity,
    Results,
    Row,
    Section,
    all_of,
    at_least,
    at_most,
    departure,
    extreme,
    largest_size,
)


def derive(results: Results) -> Section:
    def rows_of(motion: str) -> list[Row]:
        """Return the runs of a motion in both engines."""
        cases = [f"control-{motion}-plain-{engine}" for engine in ("warp", "c")]
        return [results.row[case] for case in cases]

    def drifts(motion: str) -> list[Quantity]:
        return [row.drift_mm_s for row in rows_of(motion)]

    slow = (0.001, "a millimetre in a quarter of an hour")  # [mm/s]
    slower = "smaller drift of the two engines"
    still = results.value(
        "straight_drift",
        "largest absolute drift in the straight shake",
        largest_size(drifts("straight")),
    )
    turning = results.value("turning_drift", slower, extreme(min, drifts("turning")))
    offs = [
        results.value(
            f"{row.case}_off",
            "absolute difference between the growth of the distance from the axis and"
            " the growth that the law predicts, relative to the latter",
            departure(row.growth_per_s, row.predicted_growth_per_s),
        )
        for row in rows_of("turning")
    ]
    off = results.value(
        "turning_off", "largest of these differences", extreme(max, offs)
    )
    only_turning = all_of(
        at_most(still, *slow),
        at_least(turning, 1.0, "a visible creep"),
        at_most(off, 1.0, "the same creep"),
    )

    # The walls carry a cube along an arc, on two slides, on a hinge, or on two hinges
    # that keep them upright.
    slides = results.value(
        "slides_drift",
        "largest absolute drift on two slides",
        largest_size(drifts("two-slides")),
    )
    hinge = results.value("hinge_drift", slower, extreme(min, drifts("hinge")))
    hinges = results.value("hinges_drift", slower, extreme(min, drifts("two-hinges")))
    apart = results.value(
        "hinges_off",
        "absolute difference between two hinges and one, relative to one hinge",
        departure(hinges, hinge),
    )
    joints_turn = all_of(
        at_most(slides, *slow),
        at_least(hinge, 0.1, "six millimetres a minute"),
        at_most(apart, 5.0, "the same creep, whether the walls turn or not"),
    )

    dense = results.row["jacobian-dense"]
    sparse = results.row["jacobian-sparse"]
    jacobian_off = results.value(
        "jacobian_off",
        "absolute difference of the slips, relative to the dense Jacobian",
        departure(sparse.slip_mm, dense.slip_mm),
    )
    version = results.record.identity.packages["mujoco"]

    # Test the creep in a minute with the arm held still.
    rounded, kept, best = (results.row[case] for case in ("rounded", "kept", "best"))
    gain = results.value(
        "kept_gain",
        "slip with rounded positions divided by the slip with compensated ones",
        rounded.slip_mm / kept.slip_mm,
    )
    rest = results.value(
        "best_share",
        "slip with the cure, relative to the slip with rounded positions",
        PERCENT * best.slip_mm / rounded.slip_mm,
    )
    helps = all_of(
        at_most(kept.increment_final_mm, 0.02, "about a millimetre in a minute"),
        at_least(gain, 2.0, "less than half"),
        at_most(rest, 50.0, "less than half"),
    )
    return Section(
        claims=[
            Claim(
                "only_turning_creeps",
                only_turning,
                {"still": still, "turning": turning, "off": off},
            ),
            Claim(
                "joints_turn",
                joints_turn,
                {"still": slides, "turning": hinge, "upright": hinges},
            ),
            Claim(
                "sparse_is_dense",
                at_most(
                    jacobian_off,
                    5.0,
                    "wrong accelerations would change the slip by more",
                ),
                {
                    "dense": dense.slip_mm,
                    "sparse": sparse.slip_mm,
                    "duration": dense.shake_duration_s,
                    "version": version,
                    "has_fault": version == "4.0.0",
                },
            ),
            Claim(
                "compensation_helps",
                helps,
                {
                    "slip": rounded.slip_mm,
                    "slip_kept": kept.slip_mm,
                    "best": best.slip_mm,
                    "duration": rounded.shake_duration_s,
                },
            ),
        ]
    )
