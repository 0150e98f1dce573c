"""Divide the displacement in the scene as shipped into motions between pairs of bodies."""

from report.shared import (
    PERCENT,
    Claim,
    Results,
    Section,
    all_of,
    at_least,
    at_most,
    combined,
    greater,
)

order = 60
folded = True
label = "moving bodies"


def derive(results: Results) -> Section:
    whole = results.row["cube-in-TCP"].displacement_mm
    left = results.row["cube-in-left-finger"].displacement_mm
    right = results.row["cube-in-right-finger"].displacement_mm
    shares = (
        "displacement of the cube relative to a finger, divided by its displacement relative to the"
        " TCP"
    )
    least = results.value(
        "finger_share",
        f"smaller {shares}",
        PERCENT * combined(min, left, right) / whole,
    )
    most = results.value(
        "finger_share_most",
        f"larger {shares}",
        PERCENT * combined(max, left, right) / whole,
    )
    in_fingers = all_of(
        at_least(least, 95.0, "nearly all of it"),
        at_most(most, 105.0, "no more than all of it"),
        greater(whole, 0.0, "no motion at all"),
    )
    # The drift is nonzero if a pair creeps. The displacement is also nonzero if the
    # pair only comes to rest at another place.
    pairs = ("TCP-in-hand", "left-finger-in-hand", "hand-in-link7")
    rows = [results.row[case] for case in pairs]
    cells = (cell for row in rows for cell in (row.total_drift_mm, row.displacement_mm))
    formula = "largest drift or displacement between two bodies of the robot"
    largest = results.value("robot_drift", formula, combined(max, *cells))
    share = results.value(
        "robot_share",
        f"{formula}, divided by the displacement of the cube relative to the TCP",
        PERCENT * largest / whole,
    )
    return Section(
        claims=[
            Claim(
                "cube_moves_in_fingers",
                in_fingers,
                {"whole": whole, "left": left, "right": right},
            ),
            Claim(
                "robot_is_still",
                at_most(share, 5.0, "too little to matter"),
                {"largest": largest, "share": share},
            ),
        ]
    )
