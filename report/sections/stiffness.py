"""The cause, named; what ke and kd become in the contact that the solver has; and which of them holds the cube."""

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import Any

from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from experiments.facts.case import AS_SHIPPED
from measured_report.parts.figures import INK, SERIES, new_figure, tick_125
from report.shared import (
    FAILS,
    HOLDS,
    PERCENT,
    SETTLES,
    Claim,
    Figure,
    Outcome,
    Results,
    Row,
    Section,
    Sections,
    all_of,
    at_least,
    at_most,
    by_case,
    constant,
    drawing,
    extreme,
    greater,
    is_held,
    noise_floor,
    other_value,
    quantile,
)

order = 90
page = "cause"
reads = ("contacts", "hold", "noise", "reproduction")
first = True
label = "pads' ke and kd"
labels = {
    "pad-ke-2.5e3": "shipped pads",
    "pad-ke-2.5e5": "stiff pads",
    "pad-ke-#-kd-100": "ke {} alone",
    "pad-ke-#": "ke {}, kd with it",
    "solimp-dmax-#": "dmax {}",
}

SHIPPED, FIX, STIFFEST = "pad-ke-2.5e3", "pad-ke-2.5e5", "pad-ke-2.5e6"
HARDEST = "solimp-dmax-0.9999"
SHOWN = (
    SHIPPED,
    "pad-ke-2.5e4",
    FIX,
    STIFFEST,
    *(f"pad-ke-2.5e{n}-kd-100" for n in (4, 5, 6)),
    HARDEST,
)
"""Runs of the table."""
COLUMNS = {
    "timeconst": "timeconst_s",
    "dampratio": "dampratio",
    "penetration": "penetration_mm",
}
COLUMNS |= {"friction used": "cone_use", "slip": "slip_mm"}


def derive(results: Results) -> Section:
    plain = sorted(
        (row for row in results.rows if "pad_dmax" not in row),
        key=lambda row: row.pad_ke.value,
    )
    ke_alone = [row for row in plain if row.pad_kd.value == AS_SHIPPED.pad_kd]
    held = list(filter(is_held, plain))
    substep = results.value(
        "substep",
        "given by the scene: frame time over substeps",
        constant(1 / 60 / AS_SHIPPED.substeps, "s"),
    )
    least = results.value("least_timeconst", "two substeps", 2 * substep)
    clamp = results.value(
        "clamp_kd", "kd at which 2 / kd is two substeps", constant(2, "s") / least
    )
    alone, together = (
        ke_alone_does_not_help(results, ke_alone),
        together_they_hold(results),
    )
    numbers: dict[str, Any] = {
        "is_so": all_of(alone.outcome, together.outcome) == HOLDS,
        "clamp": clamp,
    }
    numbers |= {
        "shipped": results.row[SHIPPED].slip_mm,
        "fix": results.row[FIX].slip_mm,
    }
    sweep = Figure(
        partial(draw_sweep, plain, ke_alone, clamp.value),
        [row.slip_mm for row in held],
        numbers,
    )
    rows = [results.row[case] for case in SHOWN]
    # a cube that was lost has other contacts than those with the pads.
    columns = {
        above: ["" if row.dropped else row[name] for row in rows]
        for above, name in COLUMNS.items()
    }
    columns["reading"] = [_reading(results, row) for row in rows]
    claims = [
        cause(results),
        not_creep_under_load(results),
        ke_is_no_spring(results),
        alone,
        together,
    ]
    return Section(
        tables={"contacts": by_case(rows, columns)},
        figures={"sweep": sweep},
        claims=claims,
    )


def _reading(results: Results, row: Row) -> str:
    """Say what becomes of the cube, beside what would count as a slip and what it slips in shipped pads."""
    shipped, bound = (
        results.row[SHIPPED].slip_mm,
        other_value(results, "reproduction", "slip_bound"),
    )
    if None in (row.slip_mm.value, shipped.value, bound.value) or not is_held(row):
        return "lost" if row.dropped else ""
    if at_most(row.slip_mm, bound) == HOLDS:
        return "holds"
    for words, test, times in (
        ("slips farther", at_least, 1.1),
        ("slips less", at_most, 0.9),
    ):
        if test(row.slip_mm, replace(shipped, value=times * shipped.number)) == HOLDS:
            return words
    return "slips as far"


def has_slip(results: Results) -> Outcome:
    return at_least(
        results.row[SHIPPED].slip_mm, other_value(results, "reproduction", "slip_bound")
    )


BACK = "that the slide ends when it is put back"
CONDITIONS = {  # what the cause takes, in words: section, value and the bound that it keeps
    "that the left-out acceleration gives the slide": (
        "contacts",
        "missing_term_departure",
        "missing_term_bound",
    ),
    BACK: ("contacts", "restored_share", "restored_share_bound"),
    "that friction rows have no position residual": (
        "contacts",
        "friction_residual",
        "friction_residual_bound",
    ),
    "that sliding is the motion": (
        "contacts",
        "slide_departure_as-shipped",
        "slide_departure_bound",
    ),
    "that it takes the load cycle": ("hold", "hold_share", "hold_share_bound"),
}


def cause(results: Results) -> Claim:
    slip = has_slip(results)
    value = Sections(results.others).value
    outcomes = {
        words: at_most(value(name, a), value(name, b))
        for words, (name, a, b) in CONDITIONS.items()
    }
    noise = noise_floor(results, "slip_floor")
    for case in ("as-shipped", "stiff-pads"):
        less, more = (
            value("contacts", f"restored_{case}_{size}_size")
            for size in ("small", "large")
        )
        outcomes[BACK] = all_of(outcomes[BACK], greater(more, less, noise=noise))
    lacking = Markup(", ").join(
        words for words, outcome in outcomes.items() if outcome != HOLDS
    )
    # Without a slip the others need not be known.
    bound = value("reproduction", "slip_bound")
    numbers = {
        "has_slip": slip != FAILS,
        "slip": results.row[SHIPPED].slip_mm,
        "lacking": lacking,
        "bound": bound,
    }
    return Claim("cause", all_of(slip, *outcomes.values()), numbers)


def not_creep_under_load(results: Results) -> Claim:
    shipped, hardest = results.row[SHIPPED], results.row[HARDEST]
    stiffer = results.value(
        "dmax_stiffness_ratio",
        "measured stiffness with dmax raised, over that as shipped",
        hardest.stiffness_n_m / shipped.stiffness_n_m,
    )
    drifts = [
        (f"drift_size_{row.case}", abs(row.drift_mm_s)) for row in (shipped, hardest)
    ]
    before, after = (
        results.value(name, "size of the drift", size) for name, size in drifts
    )
    moves_more = greater(after, before, noise=noise_floor(results, "drift_floor"))
    outcome = all_of(at_least(stiffer, 2.0, why="clearly stiffer"), moves_more)
    numbers = {
        "dmax": hardest.pad_dmax,
        "stiffer": stiffer,
        "before": before,
        "after": after,
    }
    return Claim("not_creep_under_load", outcome, numbers)


def ke_is_no_spring(results: Results) -> Claim:
    soft, stiff = results.row[SHIPPED], results.row[STIFFEST]
    authored = results.value(
        "ke_ratio",
        "largest over smallest authored ke of the named cases",
        stiff.pad_ke / soft.pad_ke,
    )
    measured = results.value(
        "stiffness_ratio",
        "measured stiffness at that largest ke over that at the smallest",
        stiff.stiffness_n_m / soft.stiffness_n_m,
    )
    follows = results.value(
        "stiffness_follows",
        "measured ratio, of the authored",
        PERCENT * measured / authored,
    )
    numbers = {
        "ke": soft.pad_ke,
        "k": soft.stiffness_n_m,
        "times": authored,
        "more": measured,
    }
    return Claim(
        "ke_is_no_spring", at_most(follows, 50.0, why="does not follow"), numbers
    )


def ke_alone_does_not_help(results: Results, rows: Sequence[Row]) -> Claim:
    """Ask it of the runs with kd at its import default."""
    held = list(filter(is_held, rows))
    slips, stiffnesses = [row.slip_mm for row in held], [row.pad_ke for row in held]
    low = results.value(
        "ke_alone_low",
        "slip of the runs with kd at its default, that nine in ten exceed",
        extreme(partial(quantile, 0.1), slips),
    )
    of_shipped = results.value(
        "ke_alone_share",
        "this slip with kd at its default, of the slip as shipped",
        PERCENT * low / results.row[SHIPPED].slip_mm,
    )
    first = results.value(
        "ke_alone_first", "least ke of these runs", extreme(min, stiffnesses)
    )
    last = results.value(
        "ke_alone_last", "largest ke of these runs", extreme(max, stiffnesses)
    )
    numbers = {
        "kd": results.row[SHIPPED].pad_kd,
        "share": of_shipped,
        "low": low,
        "first": first,
        "last": last,
    }
    slip, outcome = has_slip(results), at_least(of_shipped, 80.0, why="no help")
    if slip == FAILS:
        outcome = Outcome(
            "unknown",
            "with shipped pads there is no slip to bring down",
            reads=slip.reads,
        )
        outcome = outcome.having_read(low, of_shipped)
    return Claim("ke_alone_does_not_help", outcome, numbers)


def together_they_hold(results: Results) -> Claim:
    shipped, fix = results.row[SHIPPED], results.row[FIX]
    gain = results.value(
        "improvement",
        "slip as shipped over slip with the fix",
        shipped.slip_mm / fix.slip_mm,
    )
    bound = results.chosen("improvement_bound", *SETTLES)
    numbers = {
        "ke": fix.pad_ke,
        "kd": fix.pad_kd,
        "slipped": shipped.slip_mm,
        "slip": fix.slip_mm,
        "gain": gain,
    }
    return Claim("together_they_hold", at_least(gain, bound), numbers)


def draw_sweep(
    every: Sequence[Row], ke_alone: Sequence[Row], clamp_kd: float
) -> Drawing:
    """Draw slip over ke; a run with no slip to show is a cross on the upper edge."""
    figure, axes = new_figure(7.2, 4.2)
    fine = [
        row for row in every if row.case.startswith("sweep-") and row not in ke_alone
    ]
    series = (
        ("kd at its default", ke_alone, SERIES[5]),
        ("kd = 2√ke, damping ratio 1", fine, SERIES[4]),
    )
    held = [row.slip_mm.value for _, rows, _ in series for row in rows if is_held(row)]
    top = 3.0 * max(held)
    for label, rows, colour in series:
        kept = [(row.pad_ke.value, row.slip_mm.value) for row in rows if is_held(row)]
        axes.plot(*zip(*kept, strict=True), label=label, color=colour, markevery=1)
        lost = [(row.pad_ke.value, top) for row in rows if not is_held(row)]
        drawing.mark_points(
            axes, lost, marker="x", color=colour, clip_on=False, markersize=7
        )
    for case, colour, label in (
        (SHIPPED, drawing.SHIPPED, "shipped pads"),
        (FIX, drawing.STIFF, "stiff pads"),
    ):
        points = [
            (row.pad_ke.value, row.slip_mm.value)
            for row in every
            if row.case == case and is_held(row)
        ]
        drawing.mark_points(
            axes, points, marker="D", markersize=9, color=colour, label=label, zorder=5
        )
    axes.set(
        xscale="log",
        yscale="log",
        xlabel="pad ke",
        ylabel="slip [mm]",
        ylim=(0.6 * min(held), top),
    )
    clamp_ke = (clamp_kd / 2) ** 2
    axes.axvline(clamp_ke, color=INK, linewidth=1.0, linestyle=":")
    place: dict[str, Any] = {
        "xycoords": ("data", "axes fraction"),
        "xytext": (6, 0),
        "textcoords": "offset points",
    }
    axes.annotate("2/kd = 2·dt\n(kd = 2√ke)", (clamp_ke, 0.42), **place)
    tick_125(axes.yaxis)
    figure.legend(loc="outside upper left", ncols=2)
    return figure
