"""Show the limits of the grasp: the settings at which it holds, creeps, drops or explodes."""

import numpy as np
from markupsafe import Markup

from report.sections.stability import claims
from report.sections.stability.figures import draw_limits, draw_maps
from report.sections.stability.limits import limits
from report.sections.stability.passing import (
    CLASSES,
    DEPTH_LARGEST,
    LIMIT_MARGIN,
    is_stable,
)
from report.shared import HOLDS, Figure, Results, Row, Section, absent

order = 145
page = "limits"
label = "limits"
labels = {
    "friction-#": "friction {}",
    "mass-#kg": "mass {} kg",
    "overlap-pads-as-shipped-#mm": "start {} mm deep in shipped pads",
    "overlap-pads-stiff-#mm": "start {} mm deep in stiff pads",
    "overlap-ground-#mm": "start {} mm deep in the ground",
    "overlap-ground-springy-#mm": "start {} mm deep in springy ground",
    "gravity-0": "no gravity",
    "gravity-9.81": "gravity as on Earth",
    "gravity-98.1": "gravity tenfold",
    "gravity--9.81": "gravity upward",
}


def derive(results: Results) -> Section:
    critical = claims.family(results, "ke-critical")
    default_kd = claims.family(results, "ke-kd-100")
    why = "clearly below or above the limit"
    margin = results.chosen("limit_margin", why, LIMIT_MARGIN, "%")
    why = "depth in stiff pads, relative to the edge of the cube"
    depth = results.chosen("depth_largest", why, DEPTH_LARGEST, "%")
    safe = claims.safe(results, critical, default_kd)
    tests = [
        safe,
        claims.gain_goes(results),
        claims.clamp(results),
        claims.crossover(results, "shake", margin),
        claims.crossover(results, "grip", margin),
        claims.friction(results),
        claims.masses(results),
        claims.size(results, depth),
        claims.overlap(results),
        claims.gravity(results),
        claims.long(results),
    ]
    stiffest = max((row.pad_ke.value for row in default_kd), default=None)
    stiffest_runs = [row for row in default_kd if row.pad_ke.value == stiffest]
    is_so = safe.outcome == HOLDS and not any(map(is_stable, stiffest_runs))
    lines = limits(results, critical, default_kd)
    cells = [
        cell
        for line in lines
        for cell in (line.low, line.high, line.broken)
        if cell.source
    ]
    figures = {
        "maps": _maps(results, critical, default_kd, is_so),
        "limits": Figure(lambda: draw_limits(lines), cells),
    }
    return Section(figures=figures, claims=tests)


def _maps(
    results: Results, critical: list[Row], default_kd: list[Row], is_so: bool
) -> Figure:
    kd = default_kd[0].pad_kd.value if default_kd else np.nan
    panels = [
        (
            "kd = 2√ke",
            critical,
            lambda ke: 0.5 / np.sqrt(ke),
            "timeconst is clamped to 2 dt",
        ),
        (
            "kd at its default",
            default_kd,
            lambda ke: (np.sqrt(kd**2 + 4.0 * ke) - kd) / ke,
            "dt² ke + 2 dt kd > 4",
        ),
    ]
    rows = [*critical, *default_kd]
    counts = []
    for name in CLASSES:
        members = [row for row in rows if row["class"] == name]
        number = claims.count(
            results,
            f"maps_{name}_count",
            f"cells of both maps that are {name}",
            members,
        )
        if members:
            counts.append(Markup("{} {}").format(number, name))
    cells = [absent("s", "it was not measured")]
    if critical and default_kd:
        cells = [row.step_ms for row in rows]
    numbers = {"ends": Markup(", ").join(counts), "is_so": is_so}
    return Figure(lambda: draw_maps(panels), cells, numbers)
