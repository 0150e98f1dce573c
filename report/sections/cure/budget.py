"""Compare the predicted and measured parts of the slip, and recommend a remedy."""

import numpy as np

from report.shared import (
    MM_PER_M,
    PERCENT,
    Claim,
    Figure,
    Results,
    Row,
    Section,
    Value,
    all_of,
    at_least,
    at_most,
    cell_count,
    combined,
    rows_with,
    table_of,
)
from report.shared.drawing import (
    SERIES,
    Drawing,
    mark_points,
    name_lines,
    new_figure,
    write,
    write_beside,
)

SHIPPED = "newton-implicitfast-50-shipped-{}-plain-rounded"
STIFF = "newton-implicitfast-50-stiff-{}-plain-rounded"
TERM = "newton-implicitfast-50-shipped-{}-term-rounded"
BEST = "newton-euler-400-shipped-{}-full-kept"
FIRM = "newton-implicitfast-400-stiff-{}-centred-kept"
KF_OFF = "newton-implicitfast-50-shipped-{}-kf-off"  # only in releases that read ``kf``
# Names by case. A case consists of contacts, integrator, impratio, pads, shake, term and
# positions. The shake is inserted later.
NAMES = {
    SHIPPED: "as shipped",
    STIFF: "stiff pads, the fix",
    "newton-implicitfast-50-stiff-{}-term-rounded": "stiff pads and the term",
    TERM: "the term",
    "newton-euler-50-shipped-{}-centred-rounded": "the term centred, Euler",
    "newton-euler-400-shipped-{}-centred-rounded": "the same, high impratio",
    "newton-euler-400-shipped-{}-centred-kept": "the same, positions compensated",
    BEST: "the root cure, in normal rows too",
    FIRM: "stiff pads and the root cure",
    "newton-euler-400-stiff-{}-centred-kept": "the same, Euler",
    KF_OFF: "as shipped, kf off",
}
PARTS = {  # by label: the names that values and columns have for a part
    "the term": ("left_out", "left_out"),
    "step": ("step", "step"),
    "damping": ("damping", "damping"),
    "load": ("creep", "creep"),
    "rounding": ("rounding", "rounding"),
    "sum": ("sum", "predicted"),
    "measured": ("slip", "slip"),
}
SHOWN = (SHIPPED, STIFF, TERM, BEST)  # variants whose parts are listed
SHAKES = {  # label, colour and marker of each shake
    "3cm": ("the shake", SERIES[0], "o"),
    "10cm": ("a wider shake", SERIES[1], "s"),
    "held": ("held still", SERIES[5], "^"),
}
OTHER_CONTACTS = {  # the root cure with other contacts and with another cone
    "mujoco": "mujoco-euler-400-shipped-3cm-full-kept",
    "pyramid": "pyramidal-euler-400-shipped-3cm-full-kept",
}


def derive(results: Results) -> Section:
    def run(case: str, shake: str = "3cm") -> Row:
        return results.row[case.format(shake)]

    # Test whether the cure with stiff pads keeps every cube that stiff pads keep, with
    # less slip.
    slip = run(FIRM).slip_mm
    shipped = run(SHIPPED).slip_mm
    wide = run(FIRM, "10cm")
    amplitude = results.value(
        "amplitude_10cm",
        "rounded to whole mm",
        combined(round, MM_PER_M * wide.shake_amplitude_m),
    )
    share = results.value(
        "held_share",
        "slip of the root cure with stiff pads, relative to the slip as shipped",
        PERCENT * slip / shipped,
    )
    lost = results.derived["limit_lost_firm"]
    kept = results.derived["kept_firm"]
    to_use = all_of(
        at_most(lost, 0, "all cubes are kept"),
        at_most(wide.slip_mm, 0.05, "hardly more slip in a shake three times as wide"),
        at_most(share, 50.0, "less than half"),
    )

    # Test whether the parts add up to the slip.
    least = results.chosen(
        "remainder_least", "not visible in a grasp of this kind", 0.02, "mm"
    )
    most = results.chosen("remainder_share", "the law is not more precise", 5.0, "%")
    runs = [
        row
        for row in rows_with(results, "kind", "pads", "shake")
        if row.kind == "run" and row.slip_mm.value is not None
    ]
    wide_runs = [row for row in runs if (row.pads, row.shake) == ("shipped", "10cm")]

    def counted(name: str, runs: list[Row]) -> tuple[Value, Value]:
        closed = results.value(
            f"{name}closed_count",
            "runs whose remainder is below one of the bounds",
            _closed_count,
            least,
            most,
            *(cell for row in runs for cell in (row.remainder_mm, row.slip_mm)),
        )
        count = cell_count([row.slip_mm for row in runs])
        name = f"{name}kept_count"
        return closed, results.value(name, "runs that keep the cube", count)

    closed, count = counted("", runs)
    far_closed, far = counted("far_", wide_runs)
    others = results.value(
        "others_share",
        "share of the other runs whose remainder is below one of the bounds",
        PERCENT * (closed - far_closed) / (count - far),
    )
    few = results.value(
        "far_share",
        "the same share for shipped pads in the wider shake",
        PERCENT * far_closed / far,
    )
    closes = all_of(
        at_least(closed, 8.0, "too many to be chance"),
        at_least(others, 90.0, "nearly all of them"),
        at_most(few, 60.0, "only some of them"),
    )

    # The parts in the direction of the slip, their sum, and the measured slip.
    columns = {}
    for label, (name, column) in PARTS.items():
        columns[label] = [
            results.value(
                f"{row.case}_{name}",
                f"{column} of {row.case} along the pads, in the direction of its slip",
                _along,
                row[f"{column}_x_mm"],
                row[f"{column}_z_mm"],
                row.slip_x_mm,
                row.slip_z_mm,
                unit="mm",
            )
            for row in map(run, SHOWN)
        ]
    budget = table_of("setup", [NAMES[case] for case in SHOWN], columns)

    cases = [case for case in NAMES if case != KF_OFF or run(case)]
    rows = {shake: [run(case, shake) for case in cases] for shake in SHAKES}
    slips = [row.slip_mm for column in rows.values() for row in column if row]
    use = Figure(lambda: _draw_use([NAMES[case] for case in cases], rows), slips)
    claims = [
        Claim(
            "what_to_use",
            to_use,
            {
                "slip": slip,
                "shipped": shipped,
                "far": wide.slip_mm,
                "amplitude": amplitude,
                "lost": lost,
                "kept": kept,
            },
        ),
        Claim(
            "budget_closes",
            closes,
            {
                "closed": closed,
                "count": count,
                "far_closed": far_closed,
                "far": far,
                "least": least,
                "most": most,
            },
        ),
    ]
    for name, case in OTHER_CONTACTS.items():
        slip = run(case).slip_mm
        near = at_most(slip, 0.1, "nearly as little as with Newton's contacts")
        claims.append(Claim(f"with_{name}", near, {"slip": slip}))
    return Section(tables={"budget": budget}, figures={"use": use}, claims=claims)


def _closed_count(least: float, most: float, *numbers: float) -> int:
    """Count the runs whose remainder is below one of the bounds.

    The arguments alternate between remainders and slips.
    """
    # This uses NumPy, because the noise of this count takes a call for each cell of a
    # thousand runs.
    cells = np.array(numbers)
    bounds = np.maximum(least, 0.01 * most * cells[1::2])
    return np.count_nonzero(cells[::2] <= bounds)


def _along(x: float, z: float, slip_x: float, slip_z: float) -> float:
    length = (slip_x**2 + slip_z**2) ** 0.5
    return (x * slip_x + z * slip_z) / length + 0.0  # turns -0.0 into 0.0


def _draw_use(names: list[str], rows: dict[str, list[Row]]) -> Drawing:
    """Draw the slips of each setup with a marker per shake. A lost cube is a cross."""
    drawing, axes = new_figure(7.2, 1.2 + 0.34 * len(names))
    slips = [row.slip_mm.value or 0.0 for column in rows.values() for row in column]
    edge = 4 * (max(slips) or 1.0)
    for shake, (label, colour, marker) in SHAKES.items():
        shaken = list(enumerate(rows[shake]))
        points = [(row.slip_mm.value, place) for place, row in shaken]
        mark_points(
            axes, points, label=label, color=colour, marker=marker, markersize=7
        )
        lost = [(edge, place) for place, row in shaken if row.plain.get("dropped")]
        mark_points(axes, lost, color=colour, marker="X", markersize=8)
    for place, row in enumerate(rows["3cm"]):
        slip = row.slip_mm
        if slip.value is not None:
            beside = (slip.number, place)
            write_beside(axes, write(slip), beside, (0, 5), ha="center", fontsize=8)
    name_lines(axes, names)
    axes.set(xscale="log", xlabel="slip [mm]")
    axes.margins(y=0.1)
    drawing.legend(loc="outside upper left", ncols=3)
    return drawing
