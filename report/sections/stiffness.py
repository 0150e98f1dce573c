"""Test the cause of the slip, and show the contact parameters for each ke and kd."""

from dataclasses import replace
from functools import partial

from markupsafe import Markup

from experiments.facts.case import AS_SHIPPED
from report.shared import (
    FAILS,
    HOLDS,
    PERCENT,
    SETTLES,
    SLIP_BOUND,
    SUBSTEP_S,
    Claim,
    Figure,
    Outcome,
    Quantity,
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
    quantile,
)
from report.shared.drawing import INK, SERIES, Drawing, new_figure, tick_125

order = 90
page = "cause"
reads = ("contacts", "hold", "reproduction")
first = True
label = "pads' ke and kd"
labels = {
    "pad-ke-2.5e3": "shipped pads",
    "pad-ke-2.5e5": "stiff pads",
    "pad-ke-#-kd-100": "ke {} alone",
    "pad-ke-#": "ke {}, kd raised as well",
    "solimp-dmax-#": "dmax {}",
}

SHIPPED = "pad-ke-2.5e3"
FIX = "pad-ke-2.5e5"
STIFFEST = "pad-ke-2.5e6"
HARDEST = "solimp-dmax-0.9999"
SHOWN = (
    SHIPPED,
    "pad-ke-2.5e4",
    FIX,
    STIFFEST,
    *(f"pad-ke-2.5e{n}-kd-100" for n in (4, 5, 6)),
    HARDEST,
)
"""Runs that the table lists."""
COLUMNS = {
    "timeconst": "timeconst_s",
    "dampratio": "dampratio",
    "penetration": "penetration_mm",
    "friction used": "cone_use",
    "slip": "slip_mm",
}
RESTORED = "that the contacts stop sliding when it is restored"
CONDITIONS = {  # of the cause: the section, its value and the bound that it must keep
    "that the missing acceleration predicts the slide": (
        "contacts",
        "missing_term_departure",
        "missing_term_bound",
    ),
    RESTORED: ("contacts", "restored_share", "restored_share_bound"),
    "that friction rows have no position residual": (
        "contacts",
        "friction_residual",
        "friction_residual_bound",
    ),
    "that the slide explains the motion of the cube": (
        "contacts",
        "slide_departure_as-shipped",
        "slide_departure_bound",
    ),
    "that the shake causes the drift": ("hold", "hold_share", "hold_share_bound"),
}


def derive(results: Results) -> Section:
    shipped = results.row[SHIPPED]
    fix = results.row[FIX]
    stiffest = results.row[STIFFEST]
    hardest = results.row[HARDEST]
    other = Sections(results.others).value
    bound = results.chosen("slip_bound", *SLIP_BOUND)
    slips = at_least(shipped.slip_mm, bound)

    tests = {
        words: at_most(other(section, value), other(section, most))
        for words, (section, value, most) in CONDITIONS.items()
    }
    for case in ("as-shipped", "stiff-pads"):
        more = other("contacts", f"restored_{case}_large_size")
        less = other("contacts", f"restored_{case}_small_size")
        tests[RESTORED] = all_of(tests[RESTORED], greater(more, less))
    lacking = Markup(", ").join(words for words, test in tests.items() if test != HOLDS)

    stiffer = results.value(
        "dmax_stiffness_ratio",
        "measured stiffness with raised dmax divided by the stiffness as shipped",
        hardest.stiffness_n_m / shipped.stiffness_n_m,
    )
    before, after = (
        results.value(f"drift_size_{row.case}", "absolute drift", abs(row.drift_mm_s))
        for row in (shipped, hardest)
    )
    not_load = all_of(
        at_least(stiffer, 2.0, "clearly stiffer"),
        greater(after, before),
    )

    authored = results.value(
        "ke_ratio",
        "largest over smallest authored ke of the named cases",
        stiffest.pad_ke / shipped.pad_ke,
    )
    measured = results.value(
        "stiffness_ratio",
        "measured stiffness at the largest ke divided by the stiffness at the smallest",
        stiffest.stiffness_n_m / shipped.stiffness_n_m,
    )
    follows = results.value(
        "stiffness_follows",
        "measured ratio relative to the authored one",
        PERCENT * measured / authored,
    )

    # The runs with kd at its import default.
    plain = [row for row in results.rows if "pad_dmax" not in row]
    plain.sort(key=lambda row: row.pad_ke.value)
    ke_alone = [row for row in plain if row.pad_kd.value == AS_SHIPPED.pad_kd]
    held = list(filter(is_held, ke_alone))
    low = results.value(
        "ke_alone_low",
        "slip that nine in ten of the runs with kd at its default exceed",
        extreme(partial(quantile, 0.1), [row.slip_mm for row in held]),
    )
    share = results.value(
        "ke_alone_share",
        "this slip relative to the slip as shipped",
        PERCENT * low / shipped.slip_mm,
    )
    stiffnesses = [row.pad_ke for row in held]
    least = results.value(
        "ke_alone_first", "smallest ke of these runs", extreme(min, stiffnesses)
    )
    most = results.value(
        "ke_alone_last", "largest ke of these runs", extreme(max, stiffnesses)
    )
    no_help = at_least(share, 80.0, "no help")
    if slips != HOLDS:
        reason = slips.reason or "with shipped pads there is no slip to reduce"
        no_help = Outcome("unknown", reason, reads=slips.reads)
        no_help = no_help.having_read(low, share)
    gain = results.value(
        "improvement",
        "slip as shipped over slip with the fix",
        shipped.slip_mm / fix.slip_mm,
    )
    together = at_least(gain, *SETTLES)

    substep = results.value(
        "substep",
        "given by the scene: frame time over substeps",
        SUBSTEP_S,
    )
    shortest = results.value("least_timeconst", "two substeps", 2 * substep)
    clamp = results.value(
        "clamp_kd", "kd at which 2 / kd is two substeps", constant(2, "s") / shortest
    )
    sweep = Figure(
        partial(_draw_sweep, plain, ke_alone, clamp.value),
        [row.slip_mm for row in plain if is_held(row)],
        {
            "is_so": all_of(no_help, together) == HOLDS,
            "clamp": clamp,
            "shipped": shipped.slip_mm,
            "fix": fix.slip_mm,
        },
    )
    rows = [results.row[case] for case in SHOWN]
    columns = {  # the contacts of a lost cube are not those with the pads
        heading: ["" if row.dropped else row[name] for row in rows]
        for heading, name in COLUMNS.items()
    }
    columns["result"] = [_result(row, shipped.slip_mm, bound) for row in rows]
    return Section(
        tables={"contacts": by_case(rows, columns)},
        figures={"sweep": sweep},
        claims=[
            Claim(
                "cause",
                all_of(slips, *tests.values()),
                {  # if there is no slip, the other conditions may be unknown
                    "has_slip": slips != FAILS,
                    "slip": shipped.slip_mm,
                    "lacking": lacking,
                    "bound": bound,
                },
            ),
            Claim(
                "not_creep_under_load",
                not_load,
                {
                    "dmax": hardest.pad_dmax,
                    "stiffer": stiffer,
                    "before": before,
                    "after": after,
                },
            ),
            Claim(
                "ke_is_no_spring",
                at_most(follows, 50.0, "does not follow"),
                {
                    "ke": shipped.pad_ke,
                    "k": shipped.stiffness_n_m,
                    "times": authored,
                    "more": measured,
                },
            ),
            Claim(
                "ke_alone_does_not_help",
                no_help,
                {
                    "kd": shipped.pad_kd,
                    "share": share,
                    "low": low,
                    "first": least,
                    "last": most,
                },
            ),
            Claim(
                "together_they_hold",
                together,
                {
                    "ke": fix.pad_ke,
                    "kd": fix.pad_kd,
                    "slipped": shipped.slip_mm,
                    "slip": fix.slip_mm,
                },
            ),
        ],
    )


def _result(row: Row, shipped: Quantity, bound: Quantity) -> str:
    """Return how a run compares with shipped pads, such as "slips less"."""
    if None in (row.slip_mm.value, shipped.value, bound.value) or not is_held(row):
        return "lost" if row.dropped else ""
    if at_most(row.slip_mm, bound) == HOLDS:
        return "holds"
    more = at_least(row.slip_mm, replace(shipped, value=1.1 * shipped.number))
    less = at_most(row.slip_mm, replace(shipped, value=0.9 * shipped.number))
    if HOLDS in (more, less):
        return "slips farther" if more == HOLDS else "slips less"
    return "slips as far" if more == less == FAILS else "cannot tell"


def _draw_sweep(rows: list[Row], ke_alone: list[Row], clamp_kd: float) -> Drawing:
    """Draw slip over ke, with runs that lose the cube as crosses on the upper edge."""
    figure, axes = new_figure(7.2, 4.2)
    sweep = [row for row in rows if row.case.startswith("sweep-")]
    fine = [row for row in sweep if row not in ke_alone]
    slips = [row.slip_mm.value for row in ke_alone + fine if is_held(row)]
    top = 3.0 * max(slips)
    for label, sweep_rows, colour in (
        ("kd at its default", ke_alone, SERIES[5]),
        ("kd = 2√ke, damping ratio 1", fine, SERIES[4]),
    ):
        kept = [
            (row.pad_ke.value, row.slip_mm.value) for row in sweep_rows if is_held(row)
        ]
        axes.plot(*zip(*kept, strict=True), label=label, color=colour, markevery=1)
        lost = [(row.pad_ke.value, top) for row in sweep_rows if not is_held(row)]
        drawing.mark_points(
            axes, lost, color=colour, marker="x", clip_on=False, markersize=7
        )
    for case, colour, label in (
        (SHIPPED, drawing.SHIPPED, "shipped pads"),
        (FIX, drawing.STIFF, "stiff pads"),
    ):
        points = [
            (row.pad_ke.value, row.slip_mm.value)
            for row in rows
            if row.case == case and is_held(row)
        ]
        drawing.mark_points(
            axes,
            points,
            color=colour,
            label=label,
            marker="D",
            markersize=9,
            zorder=5,
        )
    axes.set(
        xscale="log",
        yscale="log",
        xlabel="pad ke",
        ylabel="slip [mm]",
        ylim=(0.6 * min(slips), top),
    )
    clamp_ke = (clamp_kd / 2) ** 2
    axes.axvline(clamp_ke, color=INK, linewidth=1.0, linestyle=":")
    drawing.write_beside(
        axes,
        "2/kd = 2·dt\n(kd = 2√ke)",
        (clamp_ke, 0.42),
        (6, 0),
        xycoords=("data", "axes fraction"),
    )
    tick_125(axes.yaxis)
    figure.legend(loc="outside upper left", ncols=2)
    return figure
