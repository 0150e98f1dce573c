"""The runs that are shown moving: what they come to, so that a picture and the page say the same."""

import pandas as pd

from measured_report.claims.claims import Claim, at_least, at_most, greater
from measured_report.parts.parts import Section, Table
from measured_report.values.results import Results
from report.shared.arithmetic import noise_floor

order = 25
label = "see it move"

NAMES = {
    "as-shipped": "shipped pads",
    "stiff-pads": "stiff pads",
    "as-shipped-10cm": "shipped pads, shaken farther",
    "stiff-pads-10cm": "stiff pads, shaken farther",
    "hold-60s": "shipped pads, held still",
}


def derive(results: Results) -> Section:
    shipped, stiff = results.row["as-shipped"], results.row["stiff-pads"]
    moves = Claim(
        "stiff_pads_move_less",
        greater(shipped.slip_mm, stiff.slip_mm, noise=noise_floor(results, "slip_floor")),
        {"duration": shipped.shake_duration_s, "shipped": shipped.slip_mm, "stiff": stiff.slip_mm},
    )
    return Section(tables={"runs": _table(results)}, claims=[moves, *_shaken_farther(results)])


def _shaken_farther(results: Results) -> list[Claim]:
    shipped, stiff = results.row["as-shipped-10cm"], results.row["stiff-pads-10cm"]
    bound = results.chosen("grasp_bound", "farther from where it was, a cube is out of the grasp", 80.0, unit="mm")
    metres = shipped.shake_amplitude_m
    numbers = {"amplitude": results.value("amplitude", "in whole mm", lambda m: round(1e3 * m), metres, unit="mm")}
    return [
        Claim("falls_when_shaken_farther", at_least(shipped.slip_mm, bound), numbers | {"shipped": shipped.slip_mm}),
        Claim("stiff_pads_hold_when_shaken_farther", at_most(stiff.slip_mm, bound), numbers | {"stiff": stiff.slip_mm}),
    ]


def _table(results: Results) -> Table:
    rows = [results.row[case] for case in NAMES]
    columns = {
        "amplitude": [row.shake_amplitude_m for row in rows],
        "time": [row.shake_duration_s for row in rows],
        "slip at the end": [row.slip_mm for row in rows],
        "out of the grasp after": [row.left_grasp_s for row in rows],
    }
    return Table(pd.DataFrame(columns, index=pd.Index(NAMES.values(), name="run")))
