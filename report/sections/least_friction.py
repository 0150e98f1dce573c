"""With how little friction does a grasp hold, as against Coulomb's law?"""

from collections.abc import Mapping

from matplotlib.figure import Figure as Drawing

from measured_report.parts.claim import HOLDS, Claim, all_of, at_least, at_most, decided
from measured_report.parts.figures import INK, SERIES, is_narrow, new_figure, tick_125
from measured_report.parts.section import Figure, Section
from measured_report.values.results import Results, Row
from report.names import name_of
from report.shared.arithmetic import cell_count, departure, excess, extreme, ratio
from report.shared.drawing import mark_cells, name_lines

order = 181
page = "scenes"
label = "least friction"

SETTINGS: tuple[str, ...] = (
    "published-euler",
    "published-implicitfast",
    "pyramidal-impratio-10",
    "elliptic-impratio-1",
)
SETTINGS += ("elliptic-impratio-10", "elliptic-impratio-100", "elliptic-noslip", "elliptic-euler")
TRIED = ("0.90", "0.98", "1.00", "1.02", "1.10")
"""Multiples of m g / N; with none of them either integrator held the cube, as was published."""
STILL = tuple(setting for setting in SETTINGS if "euler" not in setting)
"""Settings with which the arm stands still."""


def derive(results: Results) -> Section:
    rows = {setting: results.row[setting] for setting in SETTINGS}
    shown = {"pyramidal": "published-implicitfast", "elliptic": "elliptic-impratio-10", "euler": "published-euler"}
    numbers = {name: rows[setting].least_factor for name, setting in shown.items()}
    coulomb, shakes = _by_coulomb(results, rows), _euler_shakes(results, rows)
    flags = {"is_law": all_of(coulomb.outcome, shakes.outcome) == HOLDS}
    factors = Figure(lambda: _draw(rows), [row.least_factor for row in rows.values()], numbers | flags)
    return Section(
        figures={"factors": factors},
        claims=[
            _as_published(results),
            coulomb,
            _pyramid_asks_for_more(results, rows),
            _impratio_changes_nothing(results, rows),
            shakes,
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
    formula = "force of the fingers less the published one, of the latter"
    off = departure(results, "force_off", formula, force, published)
    numbers = {"count": count, "force": force, "published": published, "least": least, "lost": lost}
    return Claim("as_published", all_of(at_most(off, 5.0, why="the same force"), at_least(least, lost)), numbers)


def _by_coulomb(results: Results, rows: Mapping[str, Row]) -> Claim:
    formula = "least friction that holds less that of Coulomb's law for where the cube is held, of the latter"
    pairs = {name: (rows[name].least_factor, rows[name].coulomb_factor) for name in STILL}
    found = [departure(results, f"{name}_off", formula, *pair) for name, pair in pairs.items()]
    largest = extreme(results, "coulomb_off", "largest of the departures from Coulomb's law", max, found)
    names, formula = ("least", "coulomb"), "{} excess of m g / N, with an elliptic cone"
    factor, law = (
        results.value(f"{name}_excess", formula.format(name), lambda a: 100 * (a - 1), cell, unit="%")
        for name, cell in zip(names, pairs["elliptic-impratio-1"], strict=True)
    )
    numbers = {"largest": largest, "factor": factor, "law": law}
    return Claim("by_coulomb", at_most(largest, 5.0, why="the same friction"), numbers)


def _pyramid_asks_for_more(results: Results, rows: Mapping[str, Row]) -> Claim:
    pyramid, elliptic = rows["published-implicitfast"].least_factor, rows["elliptic-impratio-1"].least_factor
    formula = "least friction with a pyramidal cone, beyond that with an elliptic one"
    more = excess(results, "pyramid_more", formula, pyramid, elliptic)
    numbers = {"pyramid": pyramid, "elliptic": elliptic, "more": more}
    return Claim("pyramid_asks_for_more", at_least(more, 1.0, why="more than the search resolves"), numbers)


def _impratio_changes_nothing(results: Results, rows: Mapping[str, Row]) -> Claim:
    plain = rows["elliptic-impratio-1"].least_factor
    others = [rows[name].least_factor for name in ("elliptic-impratio-10", "elliptic-impratio-100", "elliptic-noslip")]
    formula = "least friction less that with impratio 1, in size, of the latter"
    found = [departure(results, f"helps_{index}", formula, other, plain) for index, other in enumerate(others)]
    largest = extreme(results, "helps_most", "largest change by impratio or noslip", max, found)
    outcome = at_most(largest, 1.0, why="no more than the search resolves")
    return Claim("impratio_changes_nothing", outcome, {"largest": largest, "plain": plain})


def _euler_shakes(results: Results, rows: Mapping[str, Row]) -> Claim:
    euler, implicit = rows["published-euler"], rows["published-implicitfast"]
    formula = "least friction with Euler, of that with implicitfast"
    times = ratio(results, "euler_times", formula, euler.least_factor, implicit.least_factor)
    speed, still = euler.rms_speed_mm_s, implicit.rms_speed_mm_s
    shakes = decided(None not in (speed.value, still.value) and speed.value > 10.0 * still.value, speed, still)
    numbers = {"euler": euler.least_factor, "implicit": implicit.least_factor, "times": times}
    outcome = all_of(at_least(times, 2.0, why="several times as much"), shakes)
    return Claim("euler_shakes", outcome, {**numbers, "speed": speed, "still": still})


def _draw(rows: Mapping[str, Row]) -> Drawing:
    drawing, axes = new_figure(7.2, 1.1 + (0.4 if is_narrow() else 0.3) * len(SETTINGS))
    least, law = ([rows[name][column] for name in SETTINGS] for column in ("least_factor", "coulomb_factor"))
    style = {"markersize": 10, "markerfacecolor": "none"}
    mark_cells(axes, least, SERIES[0], "least that holds", marker="o", **style)
    mark_cells(axes, law, INK, "by Coulomb's law, where the cube is held", marker="|", **style)
    axes.axvline(1.0, color=INK, linewidth=0.8, marker="", linestyle=":")
    axes.set_xscale("log")
    tick_125(axes.xaxis)
    name_lines(axes, map(name_of, SETTINGS))
    axes.set_xlabel("friction, over m g / N")
    drawing.legend(loc="outside upper center", ncols=1 if is_narrow() else 2)
    return drawing
