"""Claims of section stability about steps and stiffness."""

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from markupsafe import Markup

from experiments.facts.case import AS_SHIPPED, STIFF_PADS
from measured_report.parts.claim import Claim, Outcome, all_of, at_least, at_most, decided, decreases
from measured_report.values.quantities import Quantity, Value, absent
from measured_report.values.results import Results, Row
from report.sections.stability.families import count, family, family_claim, least, most
from report.sections.stability.passing import is_stable, passed
from report.shared.arithmetic import friction_rows_differ, ratio

UNCLAMPED = {"off": "clamp off", "direct": "direct solref"}
"""Ways around the clamp."""


def safe(results: Results, critical: Sequence[Row], default_kd: Sequence[Row]) -> Claim:
    """Find from which ke on every step holds with damping ratio 1, and up to which ke the default kd does as
    shipped."""
    unstable = [row.pad_ke.value for row in critical if not is_stable(row)]
    safe = [row for row in critical if row.pad_ke.value > max(unstable, default=0.0)]
    safe_ke = least(results, "safe_ke", "least ke from which on every step holds", safe, "pad_ke")
    step = most(results, "largest_step_tried", "largest step of these runs", safe, "step_ms")
    stiff = results.value("stiff_ke", "given: ke of the stiff pads", lambda: STIFF_PADS.pad_ke)
    margin = ratio(results, "safe_margin", "ke of the stiff pads over that ke", stiff, safe_ke)
    at_shipped = [row for row in default_kd if row.substeps.value == AS_SHIPPED.substeps]
    broken = [row.pad_ke.value for row in at_shipped if not is_stable(row) and row.pad_ke.value > AS_SHIPPED.pad_ke]
    kept = [row for row in at_shipped if is_stable(row) and row.pad_ke.value < min(broken, default=math.inf)]
    limit = most(results, "kd_100_ke", "largest ke that holds at the shipped step", kept, "pad_ke")
    shipped = results.value("shipped_ke", "given: ke as shipped", lambda: AS_SHIPPED.pad_ke)
    default_margin = ratio(results, "kd_100_margin", "that ke over the shipped one", limit, shipped)
    bound = results.chosen("safe_margin_bound", "room to spare", 10.0)
    numbers = {"least": safe_ke, "step": step, "stiff": stiff, "margin": margin, "bound": bound}
    numbers |= {"limit": limit, "default_margin": default_margin}
    outcome = at_least(margin, bound) if critical else Outcome("unknown", "the grid was not measured")
    return Claim("safe_settings", outcome, numbers)


def steps(results: Results, near: Value) -> Claim:
    rows = family(results, "steps")
    stable = [row for row in rows if is_stable(row)]
    kept = passed(rows)
    stiff = [row for row in kept if row.pads == "stiff"]
    step = most(results, "stiff_step", "largest step at which stiff pads pass", stiff, "step_ms")
    lost = [row for row in rows if row not in kept]
    numbers: dict[str, Any] = {
        **{"near": near, "step": step, "some_are_lost": len(stable) < len(rows)},
        "stable": count(results, "steps_stable", "of them, runs that keep the cube", stable),
        "friction_rows_differ": friction_rows_differ(results.others.get("contacts")),
        "failed_are_stiff": all(row.pads == "stiff" and row.step_ms.value > (step.value or 0.0) for row in lost),
    }
    return family_claim(results, "steps", rows, **numbers)


def gain_goes(results: Results) -> Claim:
    """Return what stiff pads gain against shipped ones, from the shipped step to the longest."""
    runs = {(row.pads, row.substeps.value): row for row in family(results, "steps")}
    counts = [number for pads, number in runs if pads == "stiff" and number <= AS_SHIPPED.substeps]
    gains = []
    for number in sorted(counts, reverse=True):
        if ("as-shipped", number) in runs:
            # Of the creep, whose repeats are compared; the drift, along one axis, varies at the longest step.
            creeps = (_creep(runs[pads, number]) for pads in ("as-shipped", "stiff"))
            formula = f"creep in shipped pads over that in stiff ones, {number} substeps"
            gains.append(ratio(results, f"step_gain_{number}", formula, *creeps))
    if len(gains) < 2:
        lack = "it was not measured with longer steps"
        numbers = dict.fromkeys(("shipped", "twice", "longest", "step"), absent("1", lack))
        return Claim("gain_goes", Outcome("unknown", lack), numbers)
    falls = decreases([gains[0], gains[1], gains[-1]], noise=0.1, why="the same gain")
    ends = all_of(at_least(gains[0], 4.0, why="a gain to take back"), at_most(gains[-1], 2.0, why="a gain"))
    numbers = {"shipped": gains[0], "twice": gains[1], "longest": gains[-1], "step": runs["stiff", min(counts)].step_ms}
    return Claim("gain_goes", all_of(ends, falls), numbers)


def _creep(row: Row) -> Quantity:
    return replace(row.creep_mm_s, noise=row.creep_floor_mm_s.value)


def clamp(results: Results) -> Claim:
    rows = family(results, "clamp")
    failing, holding = ([row for row in rows if is_stable(row) == holds] for holds in (False, True))
    first = most(results, "clamp_fails_at", "largest timeconst over dt that fails", failing, "timeconst_steps")
    last = least(results, "clamp_holds_at", "least timeconst over dt that holds", holding, "timeconst_steps")
    parted = first.value is None or last.value is None or first.value < last.value
    formula = "explicit bound at damping ratio 1: 1 / (√8 - 2)"
    predicted = results.value("clamp_predicted", formula, lambda: 1 / (8**0.5 - 2))
    ends = {way: {is_stable(row) for row in rows if row.clamp == way} for way in UNCLAMPED}
    never, always = (
        Markup(", ").join(UNCLAMPED[way] for way, found in ends.items() if found == {kept}) for kept in (False, True)
    )
    numbers = {"first": first, "last": last, "predicted": predicted, "never": never, "always": always}
    return family_claim(results, "clamp_off", rows, decided(parted, first, last), **numbers)
