"""The shake test as shipped: does the cube slip, on which engine, and what does a stiffer pad change?"""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import pandas as pd
from markupsafe import Markup, escape

from experiments.facts.case import AS_SHIPPED
from experiments.facts.classes import cycle_increments
from report.shared import (
    DEVICES,
    MM_PER_M,
    Claim,
    Quantity,
    Results,
    Section,
    Series,
    Value,
    all_of,
    at_least,
    at_most,
    combined,
    constant,
    departure,
    spread,
)

order = 10
label = "the shake test"
labels = {
    "as-shipped": "shipped pads",
    "hold": "arm held still",
    "as-shipped-mujoco-c": "shipped pads, MuJoCo C",
    "stiff-pads-mujoco-c": "stiff pads, MuJoCo C",
    "as-shipped-warp-cpu": "shipped pads, Warp on the CPU",
    "stiff-pads-warp-cpu": "stiff pads, Warp on the CPU",
}

OTHER_PLACES = {
    "-warp-cpu": "MuJoCo Warp on the CPU",
    "-mujoco-c": "MuJoCo's C engine",
}  # by how cases end
FRAME_RATE = 60
SCENE: tuple[
    tuple[str, float, str], ...
] = (  # name, value and unit of what the scene sets
    ("cube_edge", round(1e3 * AS_SHIPPED.cube_edge_m), "mm"),
    (
        "cube_weight",
        round(9.81 * AS_SHIPPED.cube_density_kg_m3 * AS_SHIPPED.cube_edge_m**3, 2),
        "N",
    ),
    (
        "cube_mass",
        round(1e3 * AS_SHIPPED.cube_density_kg_m3 * AS_SHIPPED.cube_edge_m**3),
        "g",
    ),
    ("cube_friction", AS_SHIPPED.cube_mu, "1"),
    ("pad_friction", AS_SHIPPED.pad_mu, "1"),
    ("pad_ke", AS_SHIPPED.pad_ke, "1"),
    ("pad_kd", AS_SHIPPED.pad_kd, "1"),
    ("frame_rate", FRAME_RATE, "1/s"),
    ("substeps", AS_SHIPPED.substeps, "1"),
    ("iterations", AS_SHIPPED.iterations, "1"),
    ("impratio", AS_SHIPPED.impratio, "1"),
)


def derive(results: Results) -> Section:
    shipped, stiff = results.row["as-shipped"], results.row["stiff-pads"]
    for name, value, unit in SCENE:
        results.value(name, "set in the scene", constant(value, unit))
    results.value(
        "amplitude",
        "in whole mm",
        combined(round, MM_PER_M * shipped.shake_amplitude_m),
    )
    results.value(
        "frequency", "as a whole number", combined(round, shipped.shake_frequency_hz)
    )
    bound = results.chosen("slip_bound", "a slip that can be seen", 1.0, "mm")
    numbers = {
        "slip": shipped.slip_mm,
        "duration": shipped.shake_duration_s,
        "bound": bound,
    }
    slips = Claim("slips", at_least(shipped.slip_mm, bound), numbers)
    cells = results.trace("as-shipped"), shipped.shake_frequency_hz
    claims = [
        slips,
        _steady(results, cells),
        _every_second(results, cells),
        _same_on_both_engines(results, slips),
    ]
    gain = results.value(
        "stiff_gain",
        "slip as shipped over slip with stiff pads",
        shipped.slip_mm / stiff.slip_mm,
    )
    less = at_least(gain, results.chosen("stiff_least", "less than half", 2.0))
    numbers = {"slip": stiff.slip_mm, "before": shipped.slip_mm, "gain": gain}
    return Section(
        claims=[
            *claims,
            Claim(
                "stiff_pads_hold", all_of(less, at_most(stiff.slip_mm, bound)), numbers
            ),
        ]
    )


def _increment(results: Results, name: str, part: Callable, cells: Sequence) -> Value:
    """Derive the mean of a part of the increments after the first cycle, which starts the shake from rest."""

    def mean(*found: Any) -> float:
        increments = part(_cycle_increments(*found)[1:])
        return float(increments.mean()) if len(increments) else np.nan

    return results.value(
        f"increment_{name}",
        f"mean increment of cycles after the first, the {name} ones",
        mean,
        *cells,
        unit="mm",
    )


def _steady(results: Results, cells: Sequence[Series | Quantity]) -> Claim:
    """Compare as many early and late cycles after the first, an even number of each, since odd and even differ."""

    def half(later: np.ndarray) -> int:
        return len(later) // 4 * 2

    ends = {
        "earlier": lambda later: later[: half(later)],
        "later": lambda later: later[len(later) - half(later) :],
    }
    early, late = (
        _increment(results, name, part, cells) for name, part in ends.items()
    )
    count = results.value(
        "steady_cycle_count",
        "largest even number of cycles of which there are two sets after the first cycle",
        lambda *found: half(_cycle_increments(*found)[1:]),
        *cells,
    )
    change = results.value(
        "increment_change",
        "size of the difference between the two halves, of the earlier",
        departure(late, early),
    )
    bound = results.chosen(
        "increment_change_bound", "steps this equal count as steady", 10.0, "%"
    )
    numbers = {
        "early": early,
        "late": late,
        "change": change,
        "count": count,
        "bound": bound,
    }
    return Claim("drift_is_steady", at_most(change, bound), numbers)


def _every_second(results: Results, cells: Sequence[Series | Quantity]) -> Claim:
    """Tell whether the motion repeats after two cycles and not after one."""
    even, odd = (
        _increment(results, name, lambda later, at=at: later[at::2], cells)
        for at, name in enumerate(("even", "odd"))
    )
    apart = results.value(
        "increment_parity",
        "size of the difference between both, of what even cycles add",
        departure(odd, even),
    )
    outcome = at_least(
        apart, 10.0, why="more than steps that count as steady differ by"
    )
    return Claim("every_second_adds_more", outcome, {"even": even, "odd": odd})


def _same_on_both_engines(results: Results, slips: Claim) -> Claim:
    places = {"": f"MuJoCo Warp on the {DEVICES[results.record.machine['device']]}"}
    places |= {
        suffix: name
        for suffix, name in OTHER_PLACES.items()
        if f"as-shipped{suffix}" in results.row
    }

    def apart(case: str, pads: str) -> Value:
        cells = [results.row[f"{case}{suffix}"].slip_mm for suffix in places]
        return results.value(
            f"engine_difference_{pads}",
            f"largest less smallest slip of all engines and devices, with {pads} pads",
            spread(cells),
        )

    shipped, stiff = apart("as-shipped", "shipped"), apart("stiff-pads", "stiff")
    difference = results.value(
        "engine_difference",
        "the larger of the two differences between engines and devices, as shipped and with stiff pads",
        combined(max, shipped, stiff),
    )
    bound = results.chosen(
        "engine_bound", "what is left is noise and rounding", 0.02, "mm"
    )
    *first, last = places.values()
    listed = (
        Markup("{} and {}").format(Markup(", ").join(first), last)
        if first
        else escape(last)
    )
    numbers = {"difference": difference, "places": listed, "bound": bound}
    return Claim(
        "same_on_both_engines",
        at_most(difference, bound),
        numbers,
        effect=slips.outcome,
    )


def _cycle_increments(frame: pd.DataFrame, frequency_hz: float) -> np.ndarray:
    return cycle_increments(
        frame["time_s"].to_numpy(), frame["along_mm"].to_numpy(), frequency_hz
    )
