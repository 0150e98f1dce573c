"""Claims of section stability about steps and stiffness."""

from collections.abc import Sequence

import numpy as np

from report.claims import Claim, Outcome, all_of, at_least, at_most
from report.quantities import Value
from report.results import Results, Row
from report.sections._common import SHIPPED_SUBSTEPS, extreme, friction_rows_differ, ratio
from report.sections._stability import count, family, family_claim, is_stable

SHIPPED_KE, STIFF_KE = 2.5e3, 2.5e5
CLAMPED_MS = 1e3
"""Over kd: half a timeconst of 2 / kd, the step [ms] from which the clamp is at work."""


def safe(results: Results, critical: Sequence[Row], default_kd: Sequence[Row]) -> Claim:
    """From which ke on every step holds with damping ratio 1, and up to which ke the default kd does as shipped."""
    kes = sorted({row.pad_ke.value for row in critical})
    unstable = [row.pad_ke.value for row in critical if not is_stable(row)]
    safe = [row for row in critical if row.pad_ke.value > max(unstable, default=0.0)]
    least = extreme(results, "safe_ke", "least ke from which on every step holds", min, [row.pad_ke for row in safe])
    stiff = results.value("stiff_ke", "given: ke of the stiff pads", lambda: STIFF_KE)
    margin = ratio(results, "safe_margin", "ke of the stiff pads over that ke", stiff, least)
    largest_step = extreme(
        results, "largest_step_tried", "largest step of these runs", max, [row.step_ms for row in safe]
    )
    at_shipped = [row for row in default_kd if row.substeps.value == SHIPPED_SUBSTEPS]
    broken = [row.pad_ke.value for row in at_shipped if not is_stable(row) and row.pad_ke.value > SHIPPED_KE]
    kept = [row for row in at_shipped if is_stable(row) and row.pad_ke.value < min(broken, default=np.inf)]
    creep = extreme(results, "safe_creep", "largest creep of these runs", max, [row.creep_mm_s for row in safe])
    limit = extreme(
        results, "kd_100_ke", "largest ke that holds at the shipped step", max, [row.pad_ke for row in kept]
    )
    shipped = results.value("shipped_ke", "given: ke as shipped", lambda: SHIPPED_KE)
    default_margin = ratio(results, "kd_100_margin", "that ke over the shipped one", limit, shipped)
    bound = results.chosen("safe_margin_bound", "room to spare", 10.0)
    outcome = at_least(margin, bound) if kes else Outcome("unknown", "the grid was not measured")
    return Claim(
        "safe_settings",
        outcome,
        holds="Raise kd with ke, kd = 2√ke, and leave the clamp on: from ke {least} up, no run drops the cube or "
        "explodes, at any step up to {step}; how fast it creeps, up to {creep}, is another matter. The stiff pads, ke "
        "{stiff}, are {margin} times above where that begins. With kd left at its default the shipped step stands ke "
        "up to {limit}, {default_margin} times that of the pads as shipped.",
        fails="With kd = 2√ke every run keeps the cube from ke {least} up, and the stiff pads, ke {stiff}, are only "
        "{margin} times above that; {bound} times was aimed for. With kd left at its default the shipped step stands "
        "ke up to {limit}.",
        unknown="Which settings are safe cannot be told.",
        numbers={
            "least": least,
            "step": largest_step,
            "creep": creep,
            "stiff": stiff,
            "margin": margin,
            "limit": limit,
            "default_margin": default_margin,
            "bound": bound,
        },
    )


def steps(results: Results) -> Claim:
    rows = family(results, "steps")
    stable = count(results, "steps_stable", "of them, runs that keep the cube", [row for row in rows if is_stable(row)])
    stiff = [row for row in rows if row.pads == "stiff"]
    step = extreme(
        results,
        "stiff_step",
        "largest step at which stiff pads pass",
        max,
        [row.step_ms for row in stiff if row.passes],
    )
    return family_claim(
        results,
        "steps",
        rows,
        holds="At each of {count} combinations of step and pads the cube stays in the grasp, and its drift is within a "
        "factor of two of that with the smallest step.",
        fails="The step ladder does not pass throughout: of {count} runs {stable} keep the cube, but {failed_count} do "
        "not pass, for they "
        + ("" if all(map(is_stable, rows)) else "lose it or ")
        + "drift more than twice, or less than half, as much as with the smallest step: {failed}. "
        + _why_drift_changes(results, rows),
        numbers={"stable": stable, "step": step, "exponent": _step_exponent(results, stiff)},
    )


def _why_drift_changes(results: Results, rows: Sequence[Row]) -> str:
    """What goes with the step: the clamped timeconst of the normal rows, or that of the friction rows."""
    if friction_rows_differ(results.others.get("contacts")):
        return (
            "With stiff pads the drift goes about with the power {exponent} of the step. Friction rows have a time "
            "constant of their own here, below two substeps, and the clamp makes two substeps of it."
        )
    failed = [row for row in rows if row.passes is False]
    if all(row.step_ms.value > CLAMPED_MS / row.pad_kd.value for row in failed):
        return (
            "Stiff pads pass up to a step of {step}; beyond half their timeconst the clamp gives them a longer one "
            "with every longer step."
        )
    return "With stiff pads the drift goes about with the power {exponent} of the step."


def _step_exponent(results: Results, rows: Sequence[Row]) -> Value:
    """Of those that drift the way they do with long steps: where hardly anything slides, the sign may be another."""
    drifting = [row for row in rows if is_stable(row) and row.drift_mm_s.value > 0.0]
    half = len(drifting)
    return results.value(
        "steps_exponent",
        "slope of a line through the logarithms of drift and step, stiff pads, runs with a drift above zero",
        lambda *found: np.polyfit(np.log(found[half:]), np.log(found[:half]), 1)[0] if half > 1 else np.nan,
        *(row.drift_mm_s for row in drifting),
        *(row.step_ms for row in drifting),
    )


def plateau(results: Results, rows: Sequence[Row]) -> Claim:
    clamped = [row for row in rows if row.clamped]
    return family_claim(
        results,
        "clamp_plateau",
        clamped,
        holds="Where the clamp is at work, in {count} runs, ke makes no difference: all with the same step sink "
        "equally deep into the cube, within a factor of two of their median.",
        fails="The clamp does not make all its runs alike: of {count} runs {failed_count} are lost or sink more than a "
        "factor of two more or less deep than the median with the same step: {failed}.",
        explanation="That is the plateau that the clamp predicts: with a timeconst of two steps at the least the "
        "reference stiffness cannot exceed 1 / (4 dt²).",
    )


def boundary(results: Results, rows: Sequence[Row]) -> Claim:
    return family_claim(
        results,
        "explicit_boundary",
        rows,
        holds="With kd at its default, theory says where it ends: all {count} runs that are farther than a factor of "
        "two from dt² ke + 2 dt kd = 4 end on the side that the bound puts them.",
        fails="With kd at its default, the bound dt² ke + 2 dt kd = 4 is off by more than a factor of two: of {count} "
        "runs that are farther from it than that, {failed_count} end on the wrong side: {failed}.",
        explanation="It is the bound of a semi-implicit Euler step for a spring and a damper on a unit mass, which is "
        "what ke and kd are here.",
    )


def clamp(results: Results) -> Claim:
    rows = family(results, "clamp")
    failing = [row.timeconst_steps for row in rows if not is_stable(row)]
    holding = [row.timeconst_steps for row in rows if is_stable(row)]
    first = extreme(results, "clamp_fails_at", "largest timeconst over dt that fails", max, failing)
    last = extreme(results, "clamp_holds_at", "least timeconst over dt that holds", min, holding)
    predicted = results.value(
        "clamp_predicted", "explicit bound at damping ratio 1: 1 / (√8 - 2)", lambda: 1 / (8**0.5 - 2)
    )
    own = " With the clamp off the friction rows' own time constant is not raised to two substeps either."
    own = own if friction_rows_differ(results.others.get("contacts")) else ""
    return family_claim(
        results,
        "clamp_off",
        rows,
        holds="Without the clamp stiff contacts do fail, as expected: with the clamp off as well as with a direct, "
        "negative solref the cube stays down to a timeconst of {last} steps and is lost from {first} steps on. The "
        "explicit bound puts the limit at {predicted}.",
        fails="Without the clamp the cube should stay down to some timeconst and be lost below it, with the clamp off "
        "as well as with a direct, negative solref. It does not do both everywhere: {failed}." + own,
        numbers={"first": first, "last": last, "predicted": predicted},
    )


def largest_step(results: Results, ratios: Sequence[Value]) -> Claim:
    low = extreme(results, "step_ratio_least", "least ratio of measured to predicted largest step", min, ratios)
    high = extreme(results, "step_ratio_most", "largest of these ratios", max, ratios)
    two = results.chosen("step_ratio_bound", "within a factor of two", 2.0)
    inverse = results.value("step_ratio_inverse", "one over the least ratio", lambda ratio: 1 / ratio, low)
    return Claim(
        "largest_step",
        all_of(at_most(high, two), at_most(inverse, two)),
        holds="The step at which runs with the default kd begin to fail, found by bisection, is {low} to {high} times "
        "what the explicit bound predicts, whatever ke.",
        fails="The step at which runs with the default kd begin to fail, found by bisection, is {low} to {high} times "
        "what the explicit bound predicts: theory and measurement disagree by more than a factor of two.",
        unknown="How the largest step that holds compares with theory cannot be told.",
        numbers={"low": low, "high": high},
    )


def predict_step(results: Results, row: Row) -> tuple[Value, Value]:
    """The step at which theory says that a run begins to fail, and where it did over that.

    The second is there if a step was seen to hold and a larger one to fail.
    """
    name = f"{row.of}_{row.pad_ke.value:.3g}".replace("+", "")
    predicted = results.value(
        f"predicted_step_{name}",
        "step at which dt² ke + 2 dt kd is 4",
        lambda ke, kd: 1e3 * ((kd**2 + 4 * ke) ** 0.5 - kd) / ke,
        row.pad_ke,
        row.pad_kd,
        unit="ms",
    )
    found = results.value(
        f"step_ratio_{name}",
        "geometric mean of the largest step that holds and the least that fails, over the predicted",
        lambda found, failing, predicted: (found * failing) ** 0.5 / predicted,
        row.largest_step_ms,
        row.failing_step_ms,
        predicted,
    )
    return predicted, found
