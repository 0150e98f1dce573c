"""Compare the shake test with shipped and with stiff pads on each engine and device."""

from collections.abc import Callable
from functools import partial

import numpy as np
import pandas as pd
from markupsafe import Markup, escape

from experiments.facts.case import AS_SHIPPED
from experiments.facts.classes import cycle_increments
from report.shared import (
    CASES,
    DEVICES,
    FRAME_RATE,
    MM_PER_M,
    SLIP_BOUND,
    Claim,
    Results,
    Section,
    Table,
    Value,
    all_of,
    at_least,
    at_most,
    cell_count,
    combined,
    constant,
    decided,
    departure,
    spread,
    table_of,
)

order = 10
folded = True
label = "the shake test"
labels = {
    "as-shipped": "shipped pads",
    "hold": "arm held still",
    "as-shipped-mujoco-c": "shipped pads, MuJoCo C",
    "stiff-pads-mujoco-c": "stiff pads, MuJoCo C",
    "as-shipped-warp-cpu": "shipped pads, Warp on the CPU",
    "stiff-pads-warp-cpu": "stiff pads, Warp on the CPU",
}

OTHER_ENGINES = {
    "-warp-cpu": "MuJoCo Warp on the CPU",
    "-mujoco-c": "MuJoCo's C engine",
}
MASS_KG = AS_SHIPPED.cube_density_kg_m3 * AS_SHIPPED.cube_edge_m**3
SCENE = {  # settings of the scene, with units
    "cube_edge": (round(1e3 * AS_SHIPPED.cube_edge_m), "mm"),
    "cube_weight": (round(9.81 * MASS_KG, 4), "N"),
    "cube_mass": (round(1e3 * MASS_KG), "g"),
    "cube_friction": (AS_SHIPPED.cube_mu, "1"),
    "pad_friction": (AS_SHIPPED.pad_mu, "1"),
    "pad_ke": (AS_SHIPPED.pad_ke, "1"),
    "pad_kd": (AS_SHIPPED.pad_kd, "1"),
    "frame_rate": (FRAME_RATE, "1/s"),
    "substeps": (AS_SHIPPED.substeps, "1"),
    "iterations": (AS_SHIPPED.iterations, "1"),
    "impratio": (AS_SHIPPED.impratio, "1"),
}


def derive(results: Results) -> Section:
    shipped = results.row["as-shipped"]
    stiff = results.row["stiff-pads"]
    amplitude = shipped.shake_amplitude_m
    frequency = shipped.shake_frequency_hz
    for name, setting in SCENE.items():
        results.value(name, "set in the scene", constant(*setting))
    results.value(
        "amplitude", "rounded to whole mm", combined(round, MM_PER_M * amplitude)
    )
    results.value("frequency", "rounded to a whole number", combined(round, frequency))

    bound = results.chosen("slip_bound", *SLIP_BOUND)
    slips = at_least(shipped.slip_mm, bound)
    gain = results.value(
        "stiff_gain",
        "slip as shipped over slip with stiff pads",
        shipped.slip_mm / stiff.slip_mm,
    )
    stiff_hold = all_of(
        at_least(gain, 2.0, "less than half of the slip"),
        at_most(stiff.slip_mm, bound),
    )

    # Both halves have the same even number of cycles, because odd and even cycles
    # differ.
    early = _increment(results, "earlier", lambda later: later[: _half(later)])
    late = _increment(
        results, "later", lambda later: later[len(later) - _half(later) :]
    )
    trace = results.trace("as-shipped")
    count = results.value(
        "steady_cycle_count",
        "largest even number of cycles that fits twice into the cycles after the first",
        lambda *run: _half(_later_increments(*run)),
        trace,
        frequency,
    )
    change = results.value(
        "increment_change",
        "absolute difference between the two halves, relative to the earlier one",
        departure(late, early),
    )
    steady = (10.0, "increments that differ by less count as steady")
    # The path of the shake repeats every two cycles, so that odd and even cycles may
    # differ.
    even = _increment(results, "even", lambda later: later[::2])
    odd = _increment(results, "odd", lambda later: later[1::2])
    apart = results.value(
        "increment_parity",
        "absolute difference between odd and even increments, relative to the even"
        " ones",
        departure(odd, even),
    )
    differ = at_least(apart, *steady)

    places = {"": f"MuJoCo Warp on the {DEVICES[results.record.machine['device']]}"}
    for suffix, name in OTHER_ENGINES.items():
        if f"as-shipped{suffix}" in results.row:
            places[suffix] = name
    differences = [
        results.value(
            f"engine_difference_{pads}",
            f"largest minus smallest slip over all engines and devices, with {pads}"
            " pads",
            spread([results.row[f"{case}{suffix}"].slip_mm for suffix in places]),
        )
        for case, pads in (("as-shipped", "shipped"), ("stiff-pads", "stiff"))
    ]
    difference = results.value(
        "engine_difference",
        "larger of the two differences between engines and devices, with shipped and"
        " with stiff pads",
        combined(max, *differences),
    )
    rounding = results.chosen(
        "engine_bound", "noise and rounding cause less", 0.02, "mm"
    )
    runs = [row for row in results.rows if "dropped" in row]
    lost = [row.shake_amplitude_m for row in runs if row.plain["dropped"]]
    lost_count = results.value(
        "lost_count", "runs that lose the cube", cell_count(lost)
    )
    run_count = results.value(
        "run_count",
        "runs of this section",
        cell_count(row.shake_amplitude_m for row in runs),
    )
    is_lost = decided(bool(runs) and len(lost) == len(runs), lost_count, run_count)
    *first, last = map(escape, places.values())
    listed = Markup(" and ").join([Markup(", ").join(first), last] if first else [last])
    return Section(
        tables={"axes": _axes(results)},
        claims=[
            Claim(
                "slips",
                slips,
                {
                    "slip": shipped.slip_mm,
                    "duration": shipped.shake_duration_s,
                    "bound": bound,
                },
            ),
            Claim("cube_is_lost", is_lost, {"lost": lost_count, "count": run_count}),
            Claim(
                "drift_is_steady",
                at_most(change, *steady),
                {"early": early, "late": late, "change": change, "count": count},
            ),
            Claim("every_second_adds_more", differ, {"even": even, "odd": odd}),
            Claim(
                "same_on_both_engines",
                at_most(difference, rounding),
                {"difference": difference, "places": listed, "bound": rounding},
                effect=slips,
            ),
            Claim(
                "stiff_pads_hold",
                stiff_hold,
                {"slip": stiff.slip_mm, "before": shipped.slip_mm, "gain": gain},
            ),
        ],
    )


def _axes(results: Results) -> Table:
    """Make a table of the drift along each axis of the hand, and of the motion in a cycle."""
    columns: dict[str, list] = {
        f"drift along {axis}": [
            results.value(
                f"drift_{axis}_{case.replace('-', '_')}",
                f"slope of the displacement along {axis} of the hand over the shake",
                partial(_slope, axis),
                results.trace(case),
                unit="mm/s",
            )
            for case in CASES
        ]
        for axis in "xyz"
    }
    columns["motion within a cycle"] = [
        results.row[case].oscillation_mm for case in CASES
    ]
    return table_of("pads", CASES.values(), columns)


def _slope(axis: str, frame: pd.DataFrame) -> float:
    return float(np.polyfit(frame["time_s"], frame[f"{axis}_mm"], 1)[0])


def _increment(results: Results, name: str, part: Callable) -> Value:
    """Derive the mean of some of the increments after the first cycle."""

    def mean(frame: pd.DataFrame, frequency_hz: float) -> float:
        increments = part(_later_increments(frame, frequency_hz))
        return float(increments.mean()) if len(increments) else np.nan

    return results.value(
        f"increment_{name}",
        f"mean increment of the {name} cycles after the first",
        mean,
        results.trace("as-shipped"),
        results.row["as-shipped"].shake_frequency_hz,
        unit="mm",
    )


def _half(later: np.ndarray) -> int:
    """Return the largest even number of increments that fits twice into the given ones."""
    return len(later) // 4 * 2


def _later_increments(frame: pd.DataFrame, frequency_hz: float) -> np.ndarray:
    """Return the increments of all cycles except the first, which starts from rest."""
    time_s = frame["time_s"].to_numpy()
    along_mm = frame["along_mm"].to_numpy()
    return cycle_increments(time_s, along_mm, frequency_hz)[1:]
