"""Where the grasp holds, creeps, drops and explodes: maps, the largest stable step, and what is safe."""

from collections.abc import Sequence

import numpy as np
from markupsafe import Markup

from report.sections.stability import claims, limits
from report.sections.stability.claims import count, family
from report.sections.stability.figures import draw_limits, draw_maps
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
    critical, default_kd = family(results, "ke-critical"), family(results, "ke-kd-100")
    margin = results.chosen(
        "limit_margin", "well below the limit, or well above", LIMIT_MARGIN, "%"
    )
    depth = results.chosen(
        "depth_largest", "depth in stiff pads, of the edge", DEPTH_LARGEST, "%"
    )
    safe = claims.safe(results, critical, default_kd)
    stiffest = max((row.pad_ke.value for row in default_kd), default=None)
    is_so = safe.outcome == HOLDS and not any(
        is_stable(row) for row in default_kd if row.pad_ke.value == stiffest
    )
    tests = [safe, claims.gain_goes(results), claims.clamp(results)]
    tests += [
        *(claims.crossover(results, name, margin) for name in ("shake", "grip")),
        claims.friction(results),
    ]
    tests += [
        claims.masses(results),
        claims.size(results, depth),
        claims.overlap(results),
        claims.gravity(results),
    ]
    tests += [claims.long(results)]
    lines = limits.limits(
        results, {claim.name: claim for claim in tests}, critical, default_kd
    )
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
    results: Results, critical: Sequence[Row], default_kd: Sequence[Row], is_so: bool
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
    mine = {name: [row for row in rows if row["class"] == name] for name in CLASSES}
    formula = "cells of both maps that are"
    ends = [
        (count(results, f"maps_{name}_count", f"{formula} {name}", found), name)
        for name, found in mine.items()
    ]
    counts = Markup(", ").join(
        Markup("{} {}").format(*end) for end in ends if end[0].value
    )
    cells = (
        [row.step_ms for row in rows]
        if critical and default_kd
        else [absent("s", "it was not measured")]
    )
    return Figure(lambda: draw_maps(panels), cells, {"ends": counts, "is_so": is_so})
