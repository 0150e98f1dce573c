"""The runs that are shown moving: what they come to, so that a picture and the page say the same."""

from measured_report.parts.claim import Claim, at_least, at_most, greater
from measured_report.parts.section import Section
from measured_report.values.results import Results
from report.shared.arithmetic import noise_floor, table_of

order = 25
reads = ("noise",)
label = "see it move"
labels = {
    "as-shipped": "shipped pads",
    "as-shipped-10cm": "shipped pads, 10 cm",
    "stiff-pads-10cm": "stiff pads, 10 cm",
    "hold-#s": "arm held still, {} s",
}

NAMES = {
    "as-shipped": "shipped pads",
    "stiff-pads": "stiff pads",
    "as-shipped-10cm": "shipped pads, shaken farther",
    "stiff-pads-10cm": "stiff pads, shaken farther",
    "hold-60s": "shipped pads, held still",
}
COLUMNS = {
    "amplitude": "shake_amplitude_m",
    "time": "shake_duration_s",
    "slip at the end": "slip_mm",
    "out of the grasp after": "left_grasp_s",
}


def derive(results: Results) -> Section:
    shipped, stiff = results.row["as-shipped"], results.row["stiff-pads"]
    moves = Claim(
        "stiff_pads_move_less",
        greater(shipped.slip_mm, stiff.slip_mm, noise=noise_floor(results, "slip_floor")),
        {"duration": shipped.shake_duration_s, "shipped": shipped.slip_mm, "stiff": stiff.slip_mm},
    )
    runs = table_of("run", NAMES.values(), COLUMNS, [results.row[case] for case in NAMES])
    return Section(tables={"runs": runs}, claims=[moves, *_shaken_farther(results)])


def _shaken_farther(results: Results) -> list[Claim]:
    shipped, stiff = results.row["as-shipped-10cm"], results.row["stiff-pads-10cm"]
    metres, edge = shipped.shake_amplitude_m, shipped.cube_edge_m
    numbers = {"amplitude": results.value("amplitude", "in whole mm", lambda m: round(1e3 * m), metres, unit="mm")}
    reach = results.value("reach", "edge of the cube", lambda m: 1e3 * m, edge, unit="mm")
    falls, holds = at_least(shipped.slip_mm, reach), at_most(stiff.slip_mm, reach)
    return [
        Claim("falls_when_shaken_farther", falls, numbers | {"shipped": shipped.slip_mm}),
        Claim("stiff_pads_hold_when_shaken_farther", holds, {"stiff": stiff.slip_mm}),
    ]
