"""What the parts of section stability share: its rows by family, and claims about a family."""

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from functools import partial
from itertools import filterfalse
from typing import Any

from markupsafe import Markup

from experiments.facts.case import AS_SHIPPED, STIFF_PADS
from report.sections.stability.passing import (
    GROWTH_LARGEST,
    is_stable,
    judged_by,
    passes,
)
from report.shared import (
    HOLDS,
    PERCENT,
    Claim,
    Outcome,
    Results,
    Row,
    Value,
    all_of,
    at_least,
    at_most,
    case_html,
    cell_count,
    cell_or_absent,
    constant,
    contiguous,
    decided,
    decreases,
    extreme,
    some_html,
)


def family(results: Results, name: str) -> list[Row]:
    return [row for row in results.rows if row["family"] == name]


def count(results: Results, name: str, formula: str, rows: Sequence[Row]) -> Value:
    return results.value(name, formula, cell_count([row.step_ms for row in rows]))


def _end(
    choose: Callable,
    results: Results,
    name: str,
    formula: str,
    rows: Iterable[Row],
    column: str,
) -> Value:
    return results.value(name, formula, extreme(choose, [row[column] for row in rows]))


least, most = (
    partial(_end, min),
    partial(_end, max),
)  # derive the end of a column; without a number when there is none


def family_claim(
    results: Results,
    name: str,
    rows: Sequence[Row],
    also: Outcome = HOLDS,
    **numbers: Any,
) -> Claim:
    """Claim that all rows of a family of which something is asked pass, and ``also``; ``failed`` names others."""
    judged = [row for row in rows if passes(row) is not None]
    failed = [row for row in judged if not passes(row)]
    failed_count = count(
        results, f"{name}_failed", f"runs of {name} that do not pass", failed
    )
    counts: dict[str, Any] = {
        "count": count(
            results,
            f"{name}_count",
            f"runs of {name} of which something is asked",
            judged,
        ),
        "failed_count": failed_count,
    }
    counts |= {
        "failed": some_html(
            [Markup("{} {}").format(case_html(row), row["class"]) for row in failed]
        )
    }
    cells = [cell for row in rows for cell in judged_by(row)]
    outcome = all_of(
        at_most(failed_count, 0, why="all of them pass"), decided(True, *cells), also
    )
    return Claim(
        name,
        outcome if rows else Outcome("unknown", "they were not measured"),
        counts | numbers,
    )


UNCLAMPED = {"off": "clamp off", "direct": "direct solref"}  # ways around the clamp


def safe(results: Results, critical: Sequence[Row], default_kd: Sequence[Row]) -> Claim:
    """Find from which ke every step holds with damping ratio 1, and up to which the default kd holds as shipped."""
    unstable = [row.pad_ke.value for row in critical if not is_stable(row)]
    safe = [row for row in critical if row.pad_ke.value > max(unstable, default=0.0)]
    safe_ke = least(
        results, "safe_ke", "least ke from which on every step holds", safe, "pad_ke"
    )
    step = most(
        results, "largest_step_tried", "largest step of these runs", safe, "step_ms"
    )
    stiff = results.value(
        "stiff_ke", "given: ke of the stiff pads", constant(STIFF_PADS.pad_ke)
    )
    margin = results.value(
        "safe_margin", "ke of the stiff pads over that ke", stiff / safe_ke
    )
    at_shipped = [
        row for row in default_kd if row.substeps.value == AS_SHIPPED.substeps
    ]
    broken = [
        row
        for row in at_shipped
        if not is_stable(row) and row.pad_ke.value > AS_SHIPPED.pad_ke
    ]
    first = least(
        results,
        "kd_100_breaks",
        "least ke above the shipped one that does not hold",
        broken,
        "pad_ke",
    )
    below = math.inf if first.value is None else first.value
    stable = [row for row in at_shipped if is_stable(row) and row.pad_ke.value < below]
    limit = most(
        results,
        "kd_100_ke",
        "largest ke that holds at the shipped step",
        stable,
        "pad_ke",
    )
    shipped = results.value(
        "shipped_ke", "given: ke as shipped", constant(AS_SHIPPED.pad_ke)
    )
    default_margin = results.value(
        "kd_100_margin", "that ke over the shipped one", limit / shipped
    )
    bound = results.chosen("safe_margin_bound", "room to spare", 10.0)
    numbers = {
        "least": safe_ke,
        "step": step,
        "stiff": stiff,
        "margin": margin,
        "bound": bound,
    }
    numbers |= {"limit": limit, "breaks": first, "default_margin": default_margin}
    outcome = (
        at_least(margin, bound)
        if critical
        else Outcome("unknown", "the grid was not measured")
    )
    return Claim("safe_settings", outcome, numbers)


def gain_goes(results: Results) -> Claim:
    """Return what stiff pads gain against shipped ones, from the shipped step to the longest."""
    runs = {(row.pads, row.substeps.value): row for row in family(results, "steps")}
    counts = [
        number
        for pads, number in runs
        if pads == "stiff" and number <= AS_SHIPPED.substeps
    ]
    gains = []
    for number in sorted(counts, reverse=True):
        if ("as-shipped", number) in runs:
            # Of the creep, whose repeats are compared; the drift, along one axis, varies at the longest step.
            rows = (runs[pads, number] for pads in ("as-shipped", "stiff"))
            soft, stiff = (
                replace(row.creep_mm_s, noise=row.creep_floor_mm_s.value)
                for row in rows
            )
            gains.append(
                results.value(
                    f"step_gain_{number}",
                    f"creep in shipped pads over that in stiff ones, {number} substeps",
                    soft / stiff,
                )
            )
    falls = decreases([gains[0], gains[1], gains[-1]], noise=0.1, why="the same gain")
    ends = all_of(
        at_least(gains[0], 4.0, why="a gain to take back"),
        at_most(gains[-1], 2.0, why="a gain"),
    )
    numbers = {
        "shipped": gains[0],
        "twice": gains[1],
        "longest": gains[-1],
        "step": runs["stiff", min(counts)].step_ms,
    }
    return Claim("gain_goes", all_of(ends, falls), numbers)


def clamp(results: Results) -> Claim:
    rows = family(results, "clamp")
    failing, holding = (
        [row for row in rows if is_stable(row) == holds] for holds in (False, True)
    )
    first = most(
        results,
        "clamp_fails_at",
        "largest timeconst over dt that fails",
        failing,
        "timeconst_steps",
    )
    last = least(
        results,
        "clamp_holds_at",
        "least timeconst over dt that holds",
        holding,
        "timeconst_steps",
    )
    predicted = results.value(
        "clamp_predicted",
        "explicit bound at damping ratio 1: 1 / (√8 - 2)",
        constant(1 / (8**0.5 - 2)),
    )
    ends = {
        way: {is_stable(row) for row in rows if row.clamp == way} for way in UNCLAMPED
    }
    ways = (
        [UNCLAMPED[way] for way, flags in ends.items() if flags == {holds}]
        for holds in (False, True)
    )
    never, always = map(Markup(", ").join, ways)
    is_one = (
        not (never or always)
        and None not in (first.value, last.value)
        and first.value < last.value
    )
    numbers: dict[str, Any] = {
        "first": first,
        "last": last,
        "predicted": predicted,
        "never": never,
        "always": always,
    }
    if not is_one:
        numbers |= {"first": "", "last": ""}  # of which it then says nothing
    return Claim("clamp_off", decided(is_one, first, last), numbers)


MU = {
    "shake": 0.0187,
    "grip": 0.1,
}  # friction of the pads, shaken harder and gripped less until the cube is lost


def crossover(results: Results, name: str, margin: Value) -> Claim:
    rows = [row for row in family(results, name) if row.load.value is not None]
    dropped = [row for row in rows if row["class"] == "dropped"]
    kept = most(
        results,
        f"{name}_kept",
        "largest load that holds",
        filter(is_stable, rows),
        "load",
    )
    lost = least(results, f"{name}_lost", "least load that drops", dropped, "load")
    over = {}
    for kind, load in (("kept", kept), ("lost", lost)):
        over[kind] = results.value(
            f"{name}_{kind}_over",
            f"{load.formula}, over the limit",
            PERCENT * (load - 1.0),
        )
    mu = results.value(
        f"{name}_mu", "given: friction coefficient of the pads", constant(MU[name])
    )
    also = decided(True, kept, lost)
    return family_claim(
        results,
        f"{name}_crossover",
        family(results, name),
        also,
        mu=mu,
        margin=margin,
        **over,
    )


def friction(results: Results) -> Claim:
    rows, formula = family(results, "friction"), "{} μ that holds"
    kept, largest, also = _range(
        results, rows, "pad_mu", "friction", formula, low="kept"
    )
    lost = most(
        results,
        "friction_lost",
        "largest μ that does not hold",
        filterfalse(is_stable, rows),
        "pad_mu",
    )
    return family_claim(
        results, "friction_extremes", rows, also, kept=kept, most=largest, lost=lost
    )


def masses(results: Results) -> Claim:
    rows, formula = family(results, "mass"), "{} mass that is held"
    light, heavy, also = _range(results, rows, "cube_mass_kg", "mass", formula)
    return family_claim(results, "masses", rows, also, light=light, heavy=heavy)


def _range(
    results: Results,
    rows: Sequence[Row],
    column: str,
    name: str,
    formula: str,
    low: str = "least",
) -> tuple[Value, Value, Outcome]:
    """Derive the least and the most with which a run holds, and whether each between them does."""
    flags, held = (
        map(is_stable, sorted(rows, key=lambda row: row[column].value)),
        list(filter(is_stable, rows)),
    )
    first = least(results, f"{name}_{low}", formula.format("least"), held, column)
    last = most(results, f"{name}_most", formula.format("largest"), held, column)
    return first, last, contiguous([*flags], first, last)


def size(results: Results, bound: Value) -> Claim:
    rows = family(results, "size")
    passing = list(filter(passes, rows))
    by_grip = {
        grip: [row for row in passing if row.grip == grip]
        for grip in ("as-shipped", "scaled")
    }
    formula = "least edge that passes, grip"
    shipped = least(
        results,
        "size_shipped",
        f"{formula} as shipped",
        by_grip["as-shipped"],
        "cube_edge_mm",
    )
    scaled = least(
        results, "size_scaled", f"{formula} scaled", by_grip["scaled"], "cube_edge_mm"
    )
    smallest = {"as-shipped": shipped.value, "scaled": scaled.value}
    lost = [row for row in rows if row not in passing]
    small = None not in smallest.values() and all(
        row.cube_edge_mm.value < smallest[row.grip] for row in lost
    )
    return family_claim(
        results,
        "sizes",
        rows,
        small_ones_fail=small,
        bound=bound,
        shipped=shipped,
        scaled=scaled,
    )


def overlap(results: Results) -> Claim:
    rows = family(results, "overlap")
    speeds = [(row.case, row.exit_speed_mm_s, row.exit_bound_mm_s) for row in rows]
    shares = [
        results.value(
            f"exit_share_{case}",
            "exit speed over that of an undamped spring",
            PERCENT * speed / bound,
        )
        for case, speed, bound in speeds
    ]
    largest = results.value("exit_share_most", "largest share", extreme(max, shares))
    deepest = most(results, "overlap_deepest", "deepest start", rows, "overlap_mm")
    also = at_most(largest, 100.0, why="no faster than an undamped spring")
    return family_claim(results, "overlaps", rows, also, deepest=deepest, most=largest)


def gravity(results: Results) -> Claim:
    pulled = family(results, "gravity")
    lost = [row for row in pulled if not is_stable(row)]
    tried = Markup(", ").join(row.gravity_m_s2.bare for row in pulled)
    text = Markup(", ").join(
        Markup("{} ({})").format(row.gravity_m_s2, row["class"]) for row in lost
    )
    return family_claim(results, "gravities", pulled, tried=tried, lost=text)


def long(results: Results) -> Claim:
    rows = family(results, "long")
    columns = (
        "shake_duration_s",
        "increment_first_mm_per_cycle",
        "increment_last_mm_per_cycle",
    )
    duration, first, last = (
        cell_or_absent(rows[0] if rows else None, column) for column in columns
    )
    bound = results.chosen("long_growth_bound", "hardly more", GROWTH_LARGEST)
    growth = results.value(
        "long_growth",
        "creep per cycle in the last tenth over that in the first",
        last / first,
    )
    is_lost, ends = not all(map(is_stable, rows)), rows[0]["class"] if rows else ""
    also = HOLDS if is_lost else at_most(growth, bound)
    numbers = {
        "duration": duration,
        "first": first,
        "last": last,
        "ends": ends,
        "is_lost": is_lost,
        "bound": bound,
    }
    return family_claim(results, "long_run", rows, also, **numbers)
