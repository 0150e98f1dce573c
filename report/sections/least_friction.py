"""With how little friction does a grasp hold, as against Coulomb's law?"""

from collections.abc import Mapping

import pandas as pd
from matplotlib.figure import Figure as Drawing

from measured_report.claims.claims import Claim, all_of, at_least, at_most, decided
from measured_report.parts.figures import INK, SERIES, is_narrow, new_figure, tick_125
from measured_report.parts.parts import Figure, Section, Table
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row
from report.names import case_html, name_of
from report.shared.arithmetic import cell_count, departure, extreme

order = 181
page = "scenes"
label = "least friction"

SETTINGS = (
    *("published-euler", "published-implicitfast", "pyramidal-impratio-10"),
    *("elliptic-impratio-1", "elliptic-impratio-10", "elliptic-impratio-100", "elliptic-noslip", "elliptic-euler"),
)
TRIED = ("0.90", "0.98", "1.00", "1.02", "1.10")
"""Multiples of m g / N; with none of them either integrator held the cube, as was published."""
STILL = tuple(setting for setting in SETTINGS if "euler" not in setting)
"""Settings with which the arm stands still."""


def derive(results: Results) -> Section:
    rows = {setting: results.row[setting] for setting in SETTINGS}
    figure = Figure(
        draw=lambda: _draw(rows),
        sources=[row.least_factor for row in rows.values()],
        numbers={
            "pyramidal": rows["published-implicitfast"].least_factor,
            "elliptic": rows["elliptic-impratio-10"].least_factor,
            "euler": rows["published-euler"].least_factor,
        },
    )
    return Section(
        tables={"settings": _table(rows)},
        figures={"factors": figure},
        claims=[
            _as_published(results),
            _by_coulomb(results, rows),
            _pyramid_asks_for_more(results, rows),
            _impratio_changes_nothing(results, rows),
            _euler_shakes(results, rows),
        ],
    )


def _as_published(results: Results) -> Claim:
    """Whether the fingers press as hard, and the cube slips in each of the runs in which it was published to."""
    runs = [results.row[f"published-{name}-{factor}"] for name in ("euler", "implicitfast") for factor in TRIED]
    slips = [run.slip_mm for run in runs]
    least = results.value("least_slip", "least slip with a published friction", min, *slips, unit="mm")
    lost = results.chosen("slipped_bound", "published: this counts as slipped", 5.0, unit="mm")
    count = cell_count(results, "tried_count", "published frictions that were tried", slips)
    force = results.row["published-euler"].grip_force_n
    published = results.value("published_force", "published, and not measured here", lambda: 6.96, unit="N")
    off = departure(
        results, "force_off", "force of the fingers less the published one, of the latter", force, published
    )
    same = results.chosen("force_bound", "the same force", 5.0, unit="%")
    numbers = {"count": count, "force": force, "published": published, "least": least, "lost": lost}
    return Claim("as_published", all_of(at_most(off, same), at_least(least, lost)), numbers)


def _by_coulomb(results: Results, rows: Mapping[str, Row]) -> Claim:
    formula = "least friction that holds less that of Coulomb's law for where the cube is held, of the latter"
    found = [
        departure(results, f"{name}_off", formula, rows[name].least_factor, rows[name].coulomb_factor) for name in STILL
    ]
    largest = extreme(results, "coulomb_off", "largest of the departures from Coulomb's law", max, found)
    bound = results.chosen("coulomb_bound", "the same friction", 5.0, unit="%")
    elliptic = rows["elliptic-impratio-1"]
    factor, law = (
        results.value(
            name, f"{name.replace('_', ' ')} of m g / N, with an elliptic cone", lambda a: 100 * (a - 1), cell, unit="%"
        )
        for name, cell in (("least_excess", elliptic.least_factor), ("coulomb_excess", elliptic.coulomb_factor))
    )
    numbers = {"largest": largest, "factor": factor, "law": law}
    return Claim("by_coulomb", at_most(largest, bound), numbers)


def _pyramid_asks_for_more(results: Results, rows: Mapping[str, Row]) -> Claim:
    pyramid, elliptic = rows["published-implicitfast"].least_factor, rows["elliptic-impratio-1"].least_factor
    more = results.value(
        "pyramid_more",
        "least friction with a pyramidal cone, beyond that with an elliptic one",
        lambda a, b: 100 * (a / b - 1),
        pyramid,
        elliptic,
        unit="%",
    )
    bound = results.chosen("pyramid_bound", "more than the search resolves", 1.0, unit="%")
    return Claim(
        "pyramid_asks_for_more", at_least(more, bound), {"pyramid": pyramid, "elliptic": elliptic, "more": more}
    )


def _impratio_changes_nothing(results: Results, rows: Mapping[str, Row]) -> Claim:
    plain = rows["elliptic-impratio-1"].least_factor
    others = [rows[name].least_factor for name in ("elliptic-impratio-10", "elliptic-impratio-100", "elliptic-noslip")]
    formula = "least friction less that with impratio 1, in size, of the latter"
    found = [departure(results, f"helps_{index}", formula, other, plain) for index, other in enumerate(others)]
    largest = extreme(results, "helps_most", "largest change by impratio or noslip", max, found)
    bound = results.chosen("helps_bound", "no more than the search resolves", 1.0, unit="%")
    return Claim("impratio_changes_nothing", at_most(largest, bound), {"largest": largest, "plain": plain})


def _euler_shakes(results: Results, rows: Mapping[str, Row]) -> Claim:
    euler, implicit = rows["published-euler"], rows["published-implicitfast"]
    times = results.value(
        "euler_times",
        "least friction with Euler, of that with implicitfast",
        lambda a, b: a / b,
        euler.least_factor,
        implicit.least_factor,
    )
    bound = results.chosen("euler_bound", "several times as much", 2.0)
    still = decided(
        None not in (euler.rms_speed_mm_s.value, implicit.rms_speed_mm_s.value)
        and euler.rms_speed_mm_s.value > 10.0 * implicit.rms_speed_mm_s.value,
        euler.rms_speed_mm_s,
        implicit.rms_speed_mm_s,
    )
    numbers = {"euler": euler.least_factor, "implicit": implicit.least_factor, "times": times}
    numbers |= {"speed": euler.rms_speed_mm_s, "still": implicit.rms_speed_mm_s}
    return Claim("euler_shakes", all_of(at_least(times, bound), still), numbers)


def _table(rows: Mapping[str, Row]) -> Table:
    columns: dict[str, list[Value]] = {
        "least friction": [row.least_factor for row in rows.values()],
        "by Coulomb's law": [row.coulomb_factor for row in rows.values()],
        "fingers press with": [row.grip_force_n for row in rows.values()],
        "cube's speed, held": [row.rms_speed_mm_s for row in rows.values()],
    }
    return Table(pd.DataFrame(columns, index=pd.Index(map(case_html, SETTINGS), name="setting")))


def _draw(rows: Mapping[str, Row]) -> Drawing:
    drawing, axes = new_figure(7.2, 1.1 + (0.4 if is_narrow() else 0.3) * len(SETTINGS))
    for column, label, colour, marker in (
        ("least_factor", "least that holds", SERIES[0], "o"),
        ("coulomb_factor", "by Coulomb's law, where the cube is held", INK, "|"),
    ):
        places = [place for place, name in enumerate(SETTINGS) if rows[name][column].value is not None]
        values = [rows[SETTINGS[place]][column].value for place in places]
        axes.plot(
            values,
            places,
            linestyle="",
            marker=marker,
            markersize=10,
            markerfacecolor="none",
            markevery=1,
            color=colour,
            label=label,
        )
    axes.axvline(1.0, color=INK, linewidth=0.8, marker="", linestyle=":")
    axes.set_xscale("log")
    tick_125(axes.xaxis)
    axes.set_yticks(range(len(SETTINGS)), map(name_of, SETTINGS))
    axes.invert_yaxis()
    axes.set_xlabel("friction, over m g / N")
    drawing.legend(loc="outside upper center", ncols=1 if is_narrow() else 2)
    return drawing
