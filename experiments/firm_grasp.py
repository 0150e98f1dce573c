"""A hand that swings a capsule, with steps from short to too long: up to which it holds, and how far it slips."""

from collections.abc import Callable, Mapping
from functools import partial
from math import log1p, sqrt

from tqdm import tqdm

from experiments.scenes.hand import LOST_M, SECONDS, WEIGHT_N, Grasp, Swung, swing
from measured_report.measuring.measurement import Conditions, Measurement, absent

NEEDS_GPU = False
"""Read by ``measured_report.editions.devices``: a small scene, which a CPU measures in minutes."""
SETTINGS = (
    Grasp("implicitfast"),
    Grasp("euler", integrator="Euler"),
    Grasp("rk4", integrator="RK4"),
    Grasp("pyramidal", cone="pyramidal", impratio=1.0),
    Grasp("own-timeconst", timeconst_s=0.02),
    Grasp("term", contact_bias=True),
    Grasp("warp", engine="warp"),
    Grasp("through-newton", engine="newton"),
)
STEPS_MS = {"full": (0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0), "quick": (2.0, 8.0, 32.0, 64.0)}
TOLERANCE = {"full": 0.01, "quick": 0.1}
"""To which the largest step that holds is looked for, between two of these."""


def measure(conditions: Conditions) -> Measurement:
    """A row for each setting and step, and one for each setting with the largest step that holds."""
    rows: list[dict[str, object]] = []
    for grasp in tqdm(SETTINGS, desc="firm grasp", unit="setting", delay=3.0):
        run = partial(swung_with, grasp, conditions)
        runs = {step_ms: run(step_ms) for step_ms in STEPS_MS[conditions.profile]}
        for step_ms, swung in runs.items():
            row = {"case": f"{step_ms:g}ms-{grasp.name}"} | described(grasp) | {"step_ms": step_ms}
            rows.append(row | run_columns(step_ms, swung))
        found = largest_columns(runs, run, TOLERANCE[conditions.profile])
        rows.append({"case": grasp.name} | described(grasp) | found | {"lost_mm": 1e3 * LOST_M})
    return Measurement(rows)


def swung_with(grasp: Grasp, conditions: Conditions, step_ms: float) -> Swung:
    """One run."""
    return swing(grasp, 1e-3 * step_ms, SECONDS[conditions.profile], conditions.device)


def described(grasp: Grasp) -> dict[str, object]:
    """What a setting sets."""
    row: dict[str, object] = {"backend": grasp.engine, "integrator": grasp.integrator, "cone": grasp.cone}
    row |= {"impratio": grasp.impratio, "timeconst_s": grasp.timeconst_s, "contact_bias": grasp.contact_bias}
    return row


def run_columns(step_ms: float, swung: Swung) -> dict[str, object]:
    """Whether the capsule was held, why not, and how far it moved in the hand, measured and by the law."""
    row: dict[str, object] = {"is_held": swung.failure is None, "failure": swung.failure}
    if swung.failure:
        names = ("slip_mm", "predicted_slip_mm", "normal_force_n", "loaded_contact_count")
        return row | absent(names, f"{swung.failure} with a step of {step_ms:g} ms")
    row |= {"weight_n": WEIGHT_N, "slip_mm": 1e3 * swung.slip_m, "predicted_slip_mm": 1e3 * swung.law_slip_m}
    return row | {"normal_force_n": swung.contacts.normal_n, "loaded_contact_count": swung.contacts.count}


def largest_columns(runs: Mapping[float, Swung], run: Callable[[float], Swung], tolerance: float) -> dict[str, object]:
    """The largest step that holds, closed in upon from the last one tried that does, and what the law says of it.

    By the law the logarithm of the distance from the axis grows in proportion with the step, wherever two of them are
    more than the timeconst.
    """
    names = ("largest_step_ms", "failing_step_ms", "predicted_largest_step_ms")
    low = max((step for step, swung in runs.items() if not swung.failure), default=None)
    if low is None:
        return absent(names, "no step that was tried holds it")
    high = min((step for step in runs if step > low), default=None)
    if high is None:
        return absent(names, f"the longest step that was tried holds it, {low:g} ms")
    held = runs[low]
    while high / low > 1.0 + tolerance:
        middle = sqrt(low * high)
        tried = run(middle)
        if tried.failure:
            high = middle
        else:
            low, held = middle, tried
    predicted = low * log1p(LOST_M / held.radius_m) / log1p(held.law_slip_m / held.radius_m)
    return dict(zip(names, (low, high, predicted), strict=True))
