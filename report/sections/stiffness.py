"""The cause, named; what ke and kd become in the contact that the solver has; and which of them holds the cube."""

from collections.abc import Sequence
from dataclasses import dataclass
from statistics import median

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing

from report.claims import FAILS, HOLDS, Claim, Outcome, all_of, at_least, at_most, greater
from report.figures import INK, SERIES, new_figure, tick_125
from report.parts import Figure, Section, Table
from report.quantities import Quantity, Value
from report.results import Results, Row
from report.sections._common import noise_floor, other_cell, other_value

order = 90

SHIPPED, FIX = "pad-ke-2.5e3", "pad-ke-2.5e5"
STIFFEST, ALONE = "pad-ke-2.5e6", ("pad-ke-2.5e6-kd-100", "pad-ke-2.5e5-kd-100")
HARDEST = "solimp-dmax-0.9999"
DRIVEN = (
    "So what drives the slide is not a force that the rows yield to, but the acceleration J̇·q̇ that contact rows "
    "leave out and that was measured above. In the engine's source the rows of equality constraints allow for it. The "
    "pads follow their arcs and the cube is left behind a little in every cycle."
)
ENDS = {"dropped": "v", "not finite": "x", "overflow": "P"}
"""How a run can end with no slip to show, and its mark."""


@dataclass(frozen=True)
class Runs:
    """The runs, sorted by what changed and by how they ended."""

    named: Sequence[Row]
    """Those that are no part of the fine sweep."""
    ke_alone: Sequence[Row]
    """kd at its import default."""
    together: Sequence[Row]
    """ke and kd raised together."""

    @property
    def held(self) -> list[Row]:
        """Those that keep the cube; the scene as shipped is in both series and counts once."""
        return list({row.case: row for row in (*self.ke_alone, *self.together) if _is_held(row)}.values())


def derive(results: Results) -> Section:
    plain = [row for row in results.rows if "pad_dmax" not in row]
    default_kd = results.row[SHIPPED].pad_kd.value
    runs = Runs(
        named=[row for row in results.rows if not row.case.startswith("sweep-")],
        ke_alone=_by_ke(row for row in plain if row.pad_kd.value == default_kd),
        together=_by_ke(row for row in plain if row.pad_kd.value != default_kd or row.case == SHIPPED),
    )
    substep = results.value("substep", "given by the scene: frame time over substeps", lambda: 1 / 60 / 16, unit="s")
    least = results.value("least_timeconst", "two substeps", lambda step: 2 * step, substep, unit="s")
    clamp = results.value("clamp_kd", "kd at which 2 / kd is two substeps", lambda shortest: 2 / shortest, least)
    proportional = _drift_follows_timeconst(results, runs, least)
    sweep = Figure(
        draw=lambda: _draw_sweep(runs, clamp.value),
        caption="Slip over pad stiffness, kd left alone and kd raised along. On the upper edge: runs with no slip to "
        "show.",
        alt=f"As shipped the slip is {results.row[SHIPPED].slip_mm}, with ke and kd raised together "
        f"{results.row[FIX].slip_mm}. A line marks the stiffness from which kd is beyond {clamp}.",
        sources=[row.slip_mm for row in results.rows],
    )
    law = Figure(
        draw=lambda: _draw_law(runs, results),
        caption="Drift, less that of the held arm, over the response time of the friction rows (their own timeconst "
        "where they have one, and none below two substeps). The line has slope one.",
        alt="Drift over response time on logarithmic axes: a mark for each run that held the cube, by whether ke, kd "
        "or dmax was changed, and a line of slope one.",
        sources=[row.drift_mm_s for row in runs.held],
    )
    return Section(
        tables={"cases": _table(results, runs.named)},
        figures={"sweep": sweep, "law": law},
        claims=[
            _cause(results, proportional),
            proportional,
            _not_creep_under_load(results, proportional),
            _ke_is_no_spring(results),
            _ke_alone_does_not_help(results, runs),
            _stiff_contact_still_slips(results),
            _ke_alone_fails(results, runs),
            _together_they_hold(results),
            _flat_below_clamp(results, runs, clamp),
        ],
    )


def _by_ke(rows) -> list[Row]:
    return sorted(rows, key=lambda row: row.pad_ke.value)


def _is_held(row: Row) -> bool:
    return row.slip_mm.value is not None and not row.dropped


def _cause(results: Results, proportional: Claim) -> Claim:
    residual = other_value(results, "contacts", "friction_residual", unit="mm")
    departure = other_value(results, "contacts", "slide_departure_as-shipped", unit="%")
    share = other_value(results, "hold", "hold_share", unit="%")
    missing = other_value(results, "contacts", "missing_term_departure", unit="%")
    slip = results.row[SHIPPED].slip_mm
    outcomes = [
        at_least(slip, other_value(results, "reproduction", "slip_bound", unit="mm")),
        at_most(missing, other_value(results, "contacts", "missing_term_bound", unit="%")),
        at_most(residual, other_value(results, "contacts", "friction_residual_bound", unit="mm")),
        at_most(departure, other_value(results, "contacts", "slide_departure_bound", unit="%")),
        at_most(share, other_value(results, "hold", "hold_share_bound", unit="%")),
        proportional.outcome,
    ]
    fails = (
        "What was found does not make the friction rows the cause of the slip of {slip}: their largest position "
        "residual is {residual}, their velocity is {departure} off the motion measured and {missing} off what a "
        "left-out acceleration gives, and without the load cycle the drift is {share} of what it is with it, in size."
    )
    if outcomes[0] == FAILS:  # then the others need not be known, and a number that is not there is no finding
        fails = "As shipped the slip is {slip}: there is none to explain in this release."
    return Claim(
        "cause",
        all_of(*outcomes),
        holds="The cube walks out because the contact rows leave out an acceleration of the moving arm, and their "
        "friction is a brake and not a spring: it slides until it balances that acceleration. The friction rows carry "
        "no position residual ({residual}), so what has slid is never brought back; how fast it slides goes with the "
        "contact's timeconst, which Newton makes from the pads' kd; and it needs the load cycle: without it the drift "
        "is {share} of what it is with it, in size.",
        fails=fails,
        unknown="The cause cannot be named from what has been measured.",
        numbers={"slip": slip, "residual": residual, "departure": departure, "share": share, "missing": missing},
    )


def _drift_follows_timeconst(results: Results, runs: Runs, least: Value) -> Claim:
    hold = _hold_drift(results)
    rows = [*runs.held, *(row for row in runs.named if "pad_dmax" in row and _is_held(row))]
    times = [
        results.value(
            f"response_{row.case}",
            "dmax times the timeconst of the friction rows, their own where they have one, and two substeps where it "
            "is less than that",
            lambda dmax, normal, own, shortest: dmax * max(own or normal, shortest),
            row.dmax,
            row.timeconst_s,
            row.friction_timeconst_s,
            least,
            unit="s",
        )
        for row in rows
    ]
    rates = [
        results.value(
            f"rate_{row.case}",
            "drift less that of the held arm, over dmax times timeconst",
            lambda drift, still, time: (drift - still) / time,
            row.drift_mm_s,
            hold,
            time,
            unit="mm/s²",
        )
        for row, time in zip(rows, times, strict=True)
    ]
    spread = results.value(
        "rate_spread",
        "largest departure of these rates from their median, of the median",
        lambda *found: 100 * max(abs(rate / median(found) - 1) for rate in found),
        *rates,
        unit="%",
    )
    ratio = results.value(
        "response_range", "longest over shortest dmax times timeconst", lambda *found: max(found) / min(found), *times
    )
    bound = results.chosen("rate_spread_bound", "one law", 15.0, unit="%")
    wide = results.chosen("response_range_bound", "enough to see a law", 3.0)
    outcome, unknown = at_most(spread, bound), "Whether the drift is proportional to dmax · timeconst cannot be told."
    if ratio.value is not None and ratio.value < wide.value:
        outcome = Outcome("unknown", "to see whether it is proportional would take a wider range")
        unknown = (
            "In all of these runs the friction rows brake alike: their dmax · timeconst changes only {ratio} times. "
            "The drift, less the creep of the held arm, is within {spread} of one common ratio to it."
        )
    return Claim(
        "drift_follows_timeconst",
        outcome,
        holds="The drift is proportional to dmax · timeconst: less the creep of the held arm, no run that keeps the "
        "cube departs by more than {spread} from one common ratio, while dmax · timeconst changes {ratio} times.",
        fails="The drift is not quite proportional to dmax · timeconst: less the creep of the held arm, runs depart by "
        "up to {spread} from one common ratio, while dmax · timeconst changes {ratio} times.",
        unknown=unknown,
        numbers={"spread": spread, "ratio": ratio},
        explanation="That is what a brake does. A friction row asks for the acceleration −b·v with b = 2 / (dmax · "
        "timeconst), so a steady disturbance a ends in a steady velocity a / b.",
    )


def _hold_drift(results: Results) -> Quantity:
    return other_cell(results, "hold", "hold", "drift_mm_s", unit="mm/s")


def _not_creep_under_load(results: Results, proportional: Claim) -> Claim:
    shipped, hardest = results.row[SHIPPED], results.row[HARDEST]
    before, after = _give(results, shipped), _give(results, hardest)
    ratio = results.value(
        "softness_ratio",
        "(1 - dmax) / dmax as shipped, over the same with dmax raised: how many times less the rows give way",
        lambda soft, hard: (soft / (1 - soft)) / (hard / (1 - hard)),
        before,
        after,
    )
    return Claim(
        "not_creep_under_load",
        greater(hardest.drift_mm_s, shipped.drift_mm_s, noise=noise_floor(results, "drift_floor")),
        holds="The rows do not give way under the load. With 1 − dmax brought down from {soft} to {hard} they are "
        "{ratio} times harder to push, and the drift does not fall: it goes from {before} to {after}.",
        fails="With 1 − dmax brought down from {soft} to {hard}, which makes the rows {ratio} times harder to push, "
        "the drift falls from {before} to {after}.",
        unknown="Whether the rows give way under the load cannot be told.",
        numbers={
            "soft": before,
            "hard": after,
            "ratio": ratio,
            "before": shipped.drift_mm_s,
            "after": hardest.drift_mm_s,
        },
        explanation=DRIVEN if proportional.outcome == HOLDS else "",
    )


def _give(results: Results, row: Row) -> Value:
    name = f"give_{row.case}"
    return results.derived.get(name) or results.value(name, "1 - dmax", lambda dmax: 1 - dmax, row.dmax)


def _ke_is_no_spring(results: Results) -> Claim:
    soft, stiff = results.row[SHIPPED], results.row[STIFFEST]
    authored = results.value(
        "ke_ratio",
        "largest over smallest authored ke of the named cases",
        lambda a, b: a / b,
        stiff.pad_ke,
        soft.pad_ke,
    )
    measured = results.value(
        "stiffness_ratio",
        "measured stiffness at that largest ke over that at the smallest",
        lambda a, b: a / b,
        _stiffness(results, stiff),
        _stiffness(results, soft),
    )
    share = results.value(
        "stiffness_follows", "measured ratio, of the authored", lambda a, b: 100 * a / b, measured, authored, unit="%"
    )
    bound = results.chosen("stiffness_follows_bound", "does not follow", 50.0, unit="%")
    return Claim(
        "ke_is_no_spring",
        at_most(share, bound),
        holds="ke is not a stiffness in N/m at the pad. The authored {ke} measures {k}, force over penetration of a "
        "loaded contact; with ke and kd raised together, ke {times} times as large gives a contact {more} times as "
        "stiff.",
        fails="ke does act as a stiffness here: authored {times} times as large, it gives a contact {more} times as "
        "stiff, from {k} at ke {ke}.",
        unknown="What ke does to the stiffness of the contact cannot be told.",
        numbers={"ke": soft.pad_ke, "k": _stiffness(results, soft), "times": authored, "more": measured},
        explanation="On this path Newton turns ke and kd into a solref: timeconst = 2 / kd and dampratio = kd / "
        "(2√ke), the spring and damper of a unit mass. The solver scales them with the inertia that it sees at the "
        "contact, and takes no timeconst below two substeps.",
    )


def _stiffness(results: Results, row: Row) -> Value:
    name = f"stiffness_{row.case}"
    return results.derived.get(name) or results.value(
        name,
        "normal force over penetration of a loaded contact, mean",
        lambda found: found,
        row.stiffness_n_m,
        unit="N/m",
    )


def _ke_alone_does_not_help(results: Results, runs: Runs) -> Claim:
    held = [row for row in runs.ke_alone if _is_held(row)]
    slips = [row.slip_mm for row in held]
    low = results.value("ke_alone_least", "least slip of the runs with kd at its default", min, *slips, unit="mm")
    high = results.value("ke_alone_most", "largest slip of these runs", max, *slips, unit="mm")
    share = results.value(
        "ke_alone_share",
        "least slip with kd at its default, of the slip as shipped",
        lambda least, shipped: 100 * least / shipped,
        low,
        results.row[SHIPPED].slip_mm,
        unit="%",
    )
    bound = results.chosen("ke_alone_bound", "no help", 80.0, unit="%")
    return Claim(
        "ke_alone_does_not_help",
        at_least(share, bound),
        holds="Raising ke alone does not help: with kd left at {kd}, the slip stays between {low} and {high} in every "
        "run that keeps the cube, for ke from {first} to {last}.",
        fails="Raising ke alone does help, as far as {share} of the slip as shipped: with kd left at {kd}, the slip "
        "comes down to {low} in the runs that keep the cube, for ke from {first} to {last}.",
        unknown="Whether raising ke alone helps cannot be told.",
        numbers={
            "kd": results.row[SHIPPED].pad_kd,
            "share": share,
            "low": low,
            "high": high,
            "first": held[0].pad_ke,
            "last": held[-1].pad_ke,
        },
    )


def _stiff_contact_still_slips(results: Results) -> Claim:
    kept = [results.row[case] for case in ALONE if not results.row[case].dropped]
    alone = kept[0] if kept else results.row[ALONE[0]]
    fix, shipped = results.row[FIX], results.row[SHIPPED]
    ratio = results.value(
        "alone_over_fix",
        "measured stiffness with the largest named ke at the default kd that keeps the cube, over that with the fix",
        lambda a, b: a / b,
        _stiffness(results, alone),
        _stiffness(results, fix),
    )
    share = results.value(
        "alone_slip_share",
        "slip of that run, of the slip as shipped",
        lambda a, b: 100 * a / b,
        alone.slip_mm,
        shipped.slip_mm,
        unit="%",
    )
    one = results.value("alone_over_fix_bound", "at least as stiff", lambda: 1.0)
    lost = Outcome("unknown", "that run loses the cube, so its loaded contacts are not those of the grasp")
    return Claim(
        "stiff_contact_still_slips",
        lost if alone.dropped else all_of(at_least(ratio, one), at_least(share, results.derived["ke_alone_bound"])),
        holds="A stiff contact alone is no help: at ke {ke} and the default kd the contact is {ratio} times as stiff "
        "as with the fix, and the cube slips {slip}.",
        fails="At ke {ke} and the default kd the contact is {ratio} times as stiff as with the fix, and the cube slips "
        "{slip}.",
        unknown="Whether a stiff contact slips all the same cannot be told.",
        numbers={"ke": alone.pad_ke, "ratio": ratio, "slip": alone.slip_mm},
    )


def _ke_alone_fails(results: Results, runs: Runs) -> Claim:
    lost = [row for row in runs.ke_alone if not _is_held(row)]
    count = results.value("ke_alone_lost", "runs with kd at its default that fail or drop the cube", lambda: len(lost))
    none = results.value("ke_alone_lost_bound", "at least one", lambda: 1)
    first = lost[0].pad_ke if lost else count
    return Claim(
        "ke_alone_fails",
        at_least(count, none),
        holds="Pushed further it breaks: {count} of {all} runs with kd left alone lose the cube or do not finish, the "
        "first at ke {first}, where the damping ratio would be {dampratio}.",
        fails="No run with kd left alone fails or drops the cube.",
        unknown="Whether runs with kd left alone fail cannot be told.",
        numbers={
            "count": count,
            "all": results.value("ke_alone_count", "runs with kd at its default", lambda: len(runs.ke_alone)),
            "first": first,
            "dampratio": results.value(
                "lost_dampratio",
                "kd / (2 sqrt(ke)) of the first that is lost",
                lambda ke, kd: kd / (2 * np.sqrt(ke)),
                first,
                results.row[SHIPPED].pad_kd,
            ),
        },
    )


def _together_they_hold(results: Results) -> Claim:
    shipped, fix = results.row[SHIPPED], results.row[FIX]
    gain = results.value(
        "together_gain", "slip as shipped over slip with the fix", lambda a, b: a / b, shipped.slip_mm, fix.slip_mm
    )
    bound = results.chosen("together_bound", "a change that settles the matter", 10.0)
    return Claim(
        "together_they_hold",
        at_least(gain, bound),
        holds="Raising kd along with it does: at ke {ke} and kd {kd} timeconst falls from {before} to {after} and the "
        "slip from {slipped} to {slip}, {gain} times less.",
        fails="With kd raised along with it, at ke {ke} and kd {kd}, timeconst falls from {before} to {after} and the "
        "slip goes from {slipped} to {slip}.",
        unknown="Whether raising ke and kd together holds the cube cannot be told.",
        numbers={
            "ke": fix.pad_ke,
            "kd": fix.pad_kd,
            "before": shipped.timeconst_s,
            "after": fix.timeconst_s,
            "slipped": shipped.slip_mm,
            "slip": fix.slip_mm,
            "gain": gain,
        },
        explanation="ke has to follow only to keep the damping ratio near one.",
    )


def _flat_below_clamp(results: Results, runs: Runs, clamp: Value) -> Claim:
    slips = [row.slip_mm for row in runs.together if _is_held(row) and row.pad_kd.value >= clamp.value]
    spread = results.value(
        "clamped_spread",
        "largest less smallest slip of the runs with both raised and kd beyond the clamp",
        lambda *found: max(found) - min(found),
        *slips,
        unit="mm",
    )
    floor = noise_floor(results, "slip_floor")
    return Claim(
        "flat_below_clamp",
        at_most(spread, floor),
        holds="From kd {clamp} on nothing more is gained: 2 / kd is then below two substeps, the solver uses two "
        "substeps instead, and the slips of all runs beyond differ by {spread}, no more than identical runs do.",
        fails="Beyond kd {clamp}, where 2 / kd is below two substeps, the slip still changes, by {spread}; identical "
        "runs differ by up to {floor}.",
        unknown="Whether anything is gained beyond kd {clamp}, where 2 / kd is two substeps, cannot be told.",
        numbers={"clamp": clamp, "spread": spread, "floor": floor},
    )


def _table(results: Results, rows: Sequence[Row]) -> Table:
    columns = {
        "ke": [row.pad_ke for row in rows],
        "kd": [row.pad_kd for row in rows],
        "1 − dmax": [_give(results, row) for row in rows],
        "cube": ["held" if _is_held(row) else "lost" for row in rows],
        "slip": [row.slip_mm for row in rows],
        "drift": [row.drift_mm_s for row in rows],
        "timeconst": [row.timeconst_s for row in rows],
        "dampratio": [row.dampratio for row in rows],
        "depth": [row.penetration_mm for row in rows],
        "force": [row.normal_force_n for row in rows],
        "stiffness": [_stiffness(results, row) for row in rows],
    }
    for name in list(columns)[4:]:  # the contacts of a cube that was lost are with the ground
        columns[name] = [cell if _is_held(row) else "" for row, cell in zip(rows, columns[name], strict=True)]
    index = pd.Index([row.case for row in rows], name="case")
    return Table(
        pd.DataFrame(columns, index=index),
        "What is authored (ke, kd, dmax), how the cube fares, the solref that the contact has, mean penetration "
        "(depth) and total normal force, and the stiffness: force over penetration of one loaded contact.",
    )


def _draw_sweep(runs: Runs, clamp_kd: float) -> Drawing:
    drawing, axes = new_figure(7.2, 4.2)
    series = (("kd at its default", runs.ke_alone), ("kd = 2√ke, damping ratio 1", _critical(runs.together)))
    held = [row.slip_mm.value for _, rows in series for row in rows if _is_held(row)]
    top = 3.0 * max(held)
    for label, rows in series:
        kept = [row for row in rows if _is_held(row)]
        axes.plot([r.pad_ke.value for r in kept], [r.slip_mm.value for r in kept], label=label, markevery=1)
    for end, mark in ENDS.items():
        for number, (_, rows) in enumerate(series):
            found = [row.pad_ke.value for row in rows if not _is_held(row) and _end(row) == end]
            axes.plot(found, [top] * len(found), mark, color=SERIES[number], clip_on=False, markersize=7, markevery=1)
        if any(_end(row) == end for _, rows in series for row in rows if not _is_held(row)):
            axes.plot([], [], mark, color=INK, markersize=7, markevery=1, label=end)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_ylim(0.6 * min(held), top)
    _mark_clamp(axes, (clamp_kd / 2) ** 2)
    axes.set_xlabel("pad ke")
    axes.set_ylabel("slip [mm]")
    tick_125(axes.yaxis)
    drawing.legend(loc="outside upper left", ncols=3)
    return drawing


def _critical(rows: Sequence[Row]) -> list[Row]:
    """Those of the fine sweep, whose damping ratio is exactly one."""
    return [row for row in rows if row.case.startswith("sweep-")]


def _end(row: Row) -> str:
    """Why a run has no slip to show, in a word or two."""
    if row.dropped:
        return "dropped"
    return "overflow" if "overflow" in (row.failure or "") else "not finite"


def _mark_clamp(axes: Axes, ke: float) -> None:
    axes.axvline(ke, color=INK, linewidth=1.0, linestyle=":")
    axes.annotate(
        "2/kd = 2·dt\n(kd = 2√ke)",
        (ke, 0.42),
        xycoords=("data", "axes fraction"),
        xytext=(6, 0),
        textcoords="offset points",
    )


def _draw_law(runs: Runs, results: Results) -> Drawing:
    drawing, axes = new_figure(7.2, 3.6)
    hold = _hold_drift(results).value or 0.0
    groups = {
        "kd at its default": [row for row in runs.ke_alone if _is_held(row)],
        "ke and kd raised together": [row for row in runs.together if _is_held(row)],
        "dmax raised": [row for row in runs.named if "pad_dmax" in row and _is_held(row)],
    }
    times = {row.case: results.derived[f"response_{row.case}"].value for rows in groups.values() for row in rows}
    rates = [results.derived[f"rate_{case}"].value for case in times]
    for number, (label, rows) in enumerate(groups.items()):
        axes.plot(
            [1e3 * times[row.case] for row in rows],
            [row.drift_mm_s.value - hold for row in rows],
            linestyle="",
            label=label,
            markevery=1,
            zorder=3 - number,
        )
    ends = np.array([min(times.values()), max(times.values())])
    if None not in rates:
        axes.plot(1e3 * ends, median(rates) * ends, color=INK, linestyle="-", linewidth=1.0, marker="")
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("dmax · timeconst [ms]")
    axes.set_ylabel("drift less creep [mm/s]")
    tick_125(axes.xaxis)
    tick_125(axes.yaxis)
    axes.legend()
    return drawing
