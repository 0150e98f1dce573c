"""The runs that are shown moving: what they come to, so that a picture and the page say the same."""

import pandas as pd

from report.claims import FAILS, HOLDS, Claim, Outcome, greater
from report.parts import Section, Table
from report.results import Results, Row
from report.sections._common import noise_floor

order = 25

NAMES = {
    "as-shipped": "as shipped",
    "stiff-pads": "stiff pads",
    "as-shipped-10cm": "as shipped, shaken farther",
    "stiff-pads-10cm": "stiff pads, shaken farther",
    "hold-60s": "as shipped, held still",
}


def derive(results: Results) -> Section:
    shipped, stiff = results.row["as-shipped"], results.row["stiff-pads"]
    far, far_stiff = results.row["as-shipped-10cm"], results.row["stiff-pads-10cm"]
    moves = Claim(
        "stiff_pads_move_less",
        greater(shipped.slip_mm, stiff.slip_mm, noise=noise_floor(results, "slip_floor")),
        holds="In {duration} of shaking the cube moves {shipped} in the grasp as shipped, and {stiff} with stiff pads.",
        fails="In {duration} of shaking the cube moves {shipped} in the grasp as shipped, and no less, {stiff}, with "
        "stiff pads.",
        unknown="Whether the cube moves less with stiff pads cannot be told.",
        numbers={"duration": shipped.shake_duration_s, "shipped": shipped.slip_mm, "stiff": stiff.slip_mm},
    )
    falls = Claim(
        "only_stiff_pads_hold_when_shaken_farther",
        _only_stiff_pads_hold(far, far_stiff),
        holds="Shaken {amplitude} to either side, it falls out of the grasp after {fall} as shipped; with stiff pads "
        "it stays, and moves {stiff}.",
        fails="Shaken {amplitude} to either side, the cube {end} as shipped, and with stiff pads it {end_stiff}.",
        unknown="Whether the cube falls when it is shaken farther cannot be told.",
        numbers={
            "amplitude": far.shake_amplitude_m,
            "fall": far.left_grasp_s,
            "stiff": far_stiff.slip_mm,
            "end": _end(far),
            "end_stiff": _end(far_stiff),
        },
    )
    return Section(tables={"runs": _table(results)}, claims=[moves, falls])


def _only_stiff_pads_hold(shipped: Row, stiff: Row) -> Outcome:
    for row in (shipped, stiff):
        if row.dropped is None:
            return Outcome("unknown", row.failure)
    return HOLDS if shipped.dropped and not stiff.dropped else FAILS


def _end(row: Row) -> str:
    return "falls out of the grasp" if row.dropped else "stays in the grasp"


def _table(results: Results) -> Table:
    rows = [results.row[case] for case in NAMES]
    columns = {
        "amplitude": [row.shake_amplitude_m for row in rows],
        "time": [row.shake_duration_s for row in rows],
        "slip at the end": [row.slip_mm for row in rows],
        "leaves the grasp after": [row.left_grasp_s for row in rows],
    }
    return Table(pd.DataFrame(columns, index=pd.Index(NAMES.values(), name="run")), "The runs that are shown.")
