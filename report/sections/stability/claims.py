"""Test the claims of section stability. Each claim is about a family of runs."""

import math
from collections.abc import Callable, Iterable
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


def count(results: Results, name: str, formula: str, rows: list[Row]) -> Value:
    return results.value(name, formula, cell_count([row.step_ms for row in rows]))


def _end(
    choose: Callable,
    results: Results,
    name: str,
    formula: str,
    rows: Iterable[Row],
    column: str,
) -> Value:
    cells = [row[column] for row in rows]
    return results.value(name, formula, extreme(choose, cells))


# These functions return the smallest and the largest number of a column, which is
# missing if there are no rows.
least = partial(_end, min)
most = partial(_end, max)


def family_claim(
    results: Results, name: str, rows: list[Row], also: Outcome = HOLDS, **numbers: Any
) -> Claim:
    """Test whether all rows with a criterion pass and ``also`` holds."""
    judged = [row for row in rows if passes(row) is not None]
    failed = list(filterfalse(passes, judged))
    numbers["count"] = count(
        results, f"{name}_count", f"runs of {name} that have a criterion", judged
    )
    failures = count(
        results, f"{name}_failed", f"runs of {name} that do not pass", failed
    )
    named = [Markup("{} {}").format(case_html(row), row["class"]) for row in failed]
    numbers |= {"failed_count": failures, "failed": some_html(named)}
    outcome = all_of(
        at_most(failures, 0, "all runs pass"),
        decided(True, *(cell for row in rows for cell in judged_by(row))),
        also,
    )
    if not rows:
        outcome = Outcome("unknown", "they were not measured")
    return Claim(name, outcome, numbers)


def safe(results: Results, critical: list[Row], default_kd: list[Row]) -> Claim:
    """Test whether stiff pads are far above the smallest ke that holds at every step.

    That ke is measured with a damping ratio of 1. With kd at its default, the largest ke
    that holds at the shipped step is derived as well.
    """
    unstable = [row.pad_ke.value for row in filterfalse(is_stable, critical)]
    lowest = max(unstable, default=0.0)
    safe = [row for row in critical if row.pad_ke.value > lowest]
    safe_ke = least(
        results, "safe_ke", "smallest ke above which every step holds", safe, "pad_ke"
    )
    step = most(
        results, "largest_step_tried", "largest step of these runs", safe, "step_ms"
    )
    stiff = results.value(
        "stiff_ke", "given: ke of the stiff pads", constant(STIFF_PADS.pad_ke)
    )
    margin = results.value(
        "safe_margin", "ke of the stiff pads over safe_ke", stiff / safe_ke
    )
    bound = results.chosen("safe_margin_bound", "room to spare", 10.0)

    at_shipped = [
        row for row in default_kd if row.substeps.value == AS_SHIPPED.substeps
    ]
    stiffer = [row for row in at_shipped if row.pad_ke.value > AS_SHIPPED.pad_ke]
    broken = filterfalse(is_stable, stiffer)
    first = least(
        results,
        "kd_100_breaks",
        "smallest ke above the shipped one that does not hold",
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
        "kd_100_margin", "kd_100_ke over the shipped ke", limit / shipped
    )
    numbers = {
        "least": safe_ke,
        "step": step,
        "stiff": stiff,
        "margin": margin,
        "bound": bound,
        "limit": limit,
        "default_margin": default_margin,
    }
    if not critical:
        unmeasured = Outcome("unknown", "the grid was not measured")
        return Claim("safe_settings", unmeasured, numbers)
    # The claim also reads the runs that lose the cube, because they determine the
    # limits.
    outcome = at_least(margin, bound).having_read(
        *(row.pad_ke for row in (*critical, *at_shipped))
    )
    return Claim("safe_settings", outcome, numbers)


def gain_goes(results: Results) -> Claim:
    """Test whether stiff pads lose their gain between the shipped step and the longest.

    The gain is a ratio of creeps. Drifts are not used, because they vary at the longest
    step.
    """
    rows = {(row.pads, row.substeps.value): row for row in family(results, "steps")}
    creeps = {
        key: replace(row.creep_mm_s, noise=row.creep_floor_mm_s.value)
        for key, row in rows.items()
    }
    counts = [
        number
        for pads, number in sorted(rows, reverse=True)
        if pads == "stiff" and number <= AS_SHIPPED.substeps
    ]
    gains = [
        results.value(
            f"step_gain_{number}",
            f"creep with shipped pads divided by the creep with stiff ones, {number} substeps",
            creeps["as-shipped", number] / creeps["stiff", number],
        )
        for number in counts
        if ("as-shipped", number) in rows
    ]
    first = gains[0]
    twice = gains[1]
    longest = gains[-1]
    outcome = all_of(
        at_least(first, 4.0, "a clear gain"),
        at_most(longest, 2.0, "hardly a gain"),
        decreases([first, twice, longest], by=0.1, why="the same gain"),
    )
    step = rows["stiff", counts[-1]].step_ms
    numbers = {"shipped": first, "twice": twice, "longest": longest, "step": step}
    return Claim("gain_goes", outcome, numbers)


def clamp(results: Results) -> Claim:
    """Test whether runs without the clamp fail with shorter timeconsts only."""
    rows = family(results, "clamp")
    holding = filter(is_stable, rows)
    failing = filterfalse(is_stable, rows)
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
        "smallest timeconst over dt that holds",
        holding,
        "timeconst_steps",
    )
    bound = constant(1 / (8**0.5 - 2))
    predicted = results.value(
        "clamp_predicted", "explicit bound at damping ratio 1: 1 / (√8 - 2)", bound
    )
    never, always = (
        Markup(", ").join(
            name
            for mode, name in (("off", "the clamp off"), ("direct", "a direct solref"))
            if {is_stable(row) for row in rows if row.clamp == mode} == {holds}
        )
        for holds in (False, True)
    )
    is_sharp = not (never or always) and None not in (first.value, last.value)
    is_sharp = is_sharp and first.value < last.value
    numbers: dict[str, Any] = {
        "first": first if is_sharp else "",
        "last": last if is_sharp else "",
        "predicted": predicted,
        "never": never,
        "always": always,
    }
    return Claim("clamp_off", decided(is_sharp, first, last), numbers)


# Friction of the pads in these families, as in experiments/stability/families.py. With
# 0.0187 the shipped grip can hold 1.4 times the weight of the cube at rest.
MU = {"shake": 0.0187, "grip": 0.1}


def crossover(results: Results, name: str, margin: Value) -> Claim:
    rows = family(results, name)
    loaded = [row for row in rows if row.load.value is not None]
    dropped = [row for row in loaded if row["class"] == "dropped"]
    holding = filter(is_stable, loaded)
    kept = most(results, f"{name}_kept", "largest load that holds", holding, "load")
    lost = least(results, f"{name}_lost", "smallest load that drops", dropped, "load")
    kept_over, lost_over = (
        results.value(
            f"{name}_{kind}_over",
            f"{load.formula}, as an excess over the limit",
            PERCENT * (load - 1.0),
        )
        for kind, load in (("kept", kept), ("lost", lost))
    )
    return family_claim(
        results,
        f"{name}_crossover",
        rows,
        decided(True, kept, lost),
        mu=results.value(
            f"{name}_mu", "given: friction coefficient of the pads", constant(MU[name])
        ),
        margin=margin,
        kept=kept_over,
        lost=lost_over,
    )


def friction(results: Results) -> Claim:
    rows = family(results, "friction")
    held = list(filter(is_stable, rows))
    kept = least(results, "friction_kept", "smallest μ that holds", held, "pad_mu")
    largest = most(results, "friction_most", "largest μ that holds", held, "pad_mu")
    lost = filterfalse(is_stable, rows)
    most(results, "friction_lost", "largest μ that does not hold", lost, "pad_mu")
    also = _is_contiguous(rows, "pad_mu", kept, largest)
    return family_claim(
        results, "friction_extremes", rows, also, kept=kept, most=largest
    )


def masses(results: Results) -> Claim:
    rows = family(results, "mass")
    column = "cube_mass_kg"
    held = list(filter(is_stable, rows))
    light = least(results, "mass_least", "smallest mass that is held", held, column)
    heavy = most(results, "mass_most", "largest mass that is held", held, column)
    also = _is_contiguous(rows, column, light, heavy)
    return family_claim(results, "masses", rows, also, light=light, heavy=heavy)


def _is_contiguous(rows: list[Row], column: str, *ends: Value) -> Outcome:
    """Test whether every run between the two ends holds."""
    rows = sorted(rows, key=lambda row: row[column].value)
    return contiguous([is_stable(row) for row in rows], *ends)


def size(results: Results, bound: Value) -> Claim:
    rows = family(results, "size")
    ends = {}
    for grip, name in (("as-shipped", "shipped"), ("scaled", "scaled")):
        passing = [row for row in rows if row.grip == grip and passes(row)]
        end = least(
            results,
            f"size_{name}",
            f"smallest edge that passes, grip {grip.replace('-', ' ')}",
            passing,
            "cube_edge_mm",
        )
        ends[grip] = end
    shipped, scaled = ends.values()
    small_ones_fail = None not in (shipped.value, scaled.value) and all(
        passes(row) or row.cube_edge_mm.value < ends[row.grip].value for row in rows
    )
    return family_claim(
        results,
        "sizes",
        rows,
        small_ones_fail=small_ones_fail,
        bound=bound,
        shipped=shipped,
        scaled=scaled,
    )


def overlap(results: Results) -> Claim:
    rows = family(results, "overlap")
    shares = [
        results.value(
            f"exit_share_{row.case}",
            "exit speed relative to the speed from an undamped spring",
            PERCENT * row.exit_speed_mm_s / row.exit_bound_mm_s,
        )
        for row in rows
    ]
    largest = results.value("exit_share_most", "largest share", extreme(max, shares))
    deepest = most(results, "overlap_deepest", "deepest start", rows, "overlap_mm")
    also = at_most(largest, 100.0, "no faster than an undamped spring")
    return family_claim(results, "overlaps", rows, also, deepest=deepest, most=largest)


def gravity(results: Results) -> Claim:
    rows = family(results, "gravity")
    tried = Markup(", ").join(row.gravity_m_s2.bare for row in rows)
    lost = Markup(", ").join(
        Markup("{} ({})").format(row.gravity_m_s2, row["class"])
        for row in filterfalse(is_stable, rows)
    )
    return family_claim(results, "gravities", rows, tried=tried, lost=lost)


def long(results: Results) -> Claim:
    rows = family(results, "long")
    row = rows[0] if rows else results.row["long"]
    first = cell_or_absent(row, "increment_first_mm_per_cycle")
    last = cell_or_absent(row, "increment_last_mm_per_cycle")
    bound = results.chosen("long_growth_bound", "hardly faster", GROWTH_LARGEST)
    growth = results.value(
        "long_growth",
        "creep per cycle in the last tenth divided by the creep in the first",
        last / first,
    )
    is_lost = not all(map(is_stable, rows))
    return family_claim(
        results,
        "long_run",
        rows,
        HOLDS if is_lost else at_most(growth, bound),
        duration=cell_or_absent(row, "shake_duration_s"),
        first=first,
        last=last,
        ends=row["class"] if row else "",
        is_lost=is_lost,
        bound=bound,
    )
