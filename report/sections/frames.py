"""What moves against what: the displacement as shipped, taken apart into relative poses."""

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
    noise_floor,
)

order = 60
reads = ("noise",)
label = "what moves"


def derive(results: Results) -> Section:
    whole = results.row["cube-in-TCP"].displacement_mm
    left, right = (
        results.row[f"cube-in-{side}-finger"].displacement_mm
        for side in ("left", "right")
    )
    formula = "{} of the cube's displacements against the two fingers, of that against the TCP"
    least = results.value(
        "finger_share",
        formula.format("smaller"),
        PERCENT * combined(min, left, right) / whole,
    )
    most = results.value(
        "finger_share_most",
        formula.format("larger"),
        PERCENT * combined(max, left, right) / whole,
    )
    no_more = at_most(most, 105.0, why="no more than all of it")
    moves = greater(
        whole, 0.0, noise=noise_floor(results, "slip_floor"), why="no motion at all"
    )
    in_fingers = all_of(
        at_least(least, 95.0, why="as good as all of it"), no_more, moves
    )
    claims = [
        Claim(
            "cube_moves_in_fingers",
            in_fingers,
            {"whole": whole, "left": left, "right": right},
        )
    ]
    # Of pairs of the robot's bodies the larger of drift and displacement: what creeps, and what only rests elsewhere.
    rows = [
        results.row[case]
        for case in ("TCP-in-hand", "left-finger-in-hand", "hand-in-link7")
    ]
    formula = "largest drift or displacement between two bodies of the robot"
    cells = (cell for row in rows for cell in (row.total_drift_mm, row.displacement_mm))
    largest = results.value("robot_drift", formula, combined(max, *cells))
    formula += ", of the cube's displacement against the TCP"
    of_cube = results.value("robot_share", formula, PERCENT * largest / whole)
    bound = results.chosen("robot_share_bound", "too little to matter", 5.0, "%")
    still = Claim(
        "robot_is_still",
        at_most(of_cube, bound),
        {"largest": largest, "share": of_cube},
    )
    return Section(claims=[*claims, still])
