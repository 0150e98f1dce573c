"""A pinched capsule that sinks: does it sink as fast as was published, and as fast as the law says?"""

from collections.abc import Mapping, Sequence

import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing

from measured_report.claims.claims import Claim, all_of, at_least, at_most, greater
from measured_report.parts.figures import INK, SERIES, is_narrow, new_figure
from measured_report.parts.parts import Figure, Section, Table
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.names import case_html, name_of
from report.shared.arithmetic import cell_count, departure, difference, extreme, ratio, share

order = 180
page = "scenes"
label = "pinched capsule"

ENGINES = {"c": "MuJoCo C", "warp": "MuJoCo Warp", "newton": "through Newton"}
VARIANTS = (
    *("recipe", "impratio-1", "impratio-100", "impratio-1000", "pyramidal"),
    *("stiff", "noslip", "condim-6", "within-pads"),
)
PUBLISHED_MM_S = {"recipe": 0.15499, "impratio-1": 1.5, "pyramidal": 2.3, "stiff": 0.05, "noslip": 0.0014}
"""The first from google-deepmind/mujoco pull request 3526, which measured it again, the others from issue 3328."""


def derive(results: Results) -> Section:
    rows = {case: results.row[case] for case in (f"{variant}-{engine}" for engine in ENGINES for variant in VARIANTS)}
    published = {
        variant: results.value(
            f"published_{variant}", "published, and not measured here", lambda rate=rate: rate, unit="mm/s"
        )
        for variant, rate in PUBLISHED_MM_S.items()
    }
    has_noslip = rows["noslip-newton"].creep_mm_s.value is not None  # older releases of MuJoCo Warp have none
    noslip = [_noslip_helps(results, rows)]
    noslip += [_noslip_helps_through_newton(results, rows)] if has_noslip else []
    rates = Figure(
        draw=lambda: _draw(rows, published),
        sources=[row.creep_mm_s for row in rows.values()],
        numbers={"recipe": rows["recipe-c"].creep_mm_s, "noslip": rows["noslip-c"].creep_mm_s},
    )
    return Section(
        tables={"runs": _table(rows, published)},
        figures={"rates": rates},
        claims=[
            _as_published(results, rows, published),
            _follows_law(results, rows),
            _rest_is_jolts(results, rows),
            _impratio_divides(results, rows),
            *noslip,
            _newton_changes_a_mass(results, rows),
        ],
        unmeasured=() if has_noslip else ("noslip_helps_through_newton",),
    )


def _as_published(results: Results, rows: Mapping[str, Row], published: Mapping[str, Value]) -> Claim:
    formula = "rate in MuJoCo C less the published one, in size, of the latter"
    found = [
        departure(results, f"{variant}_from_published", formula, rows[f"{variant}-c"].creep_mm_s, rate)
        for variant, rate in published.items()
    ]
    largest = extreme(results, "published_off", "largest of the departures from what was published", max, found)
    bound = results.chosen("published_bound", "the same rate", 5.0, unit="%")
    numbers = {
        "count": cell_count(results, "published_count", "rates that were published", found),
        "recipe": rows["recipe-c"].creep_mm_s,
        "published": published["recipe"],
        "largest": largest,
    }
    return Claim("as_published", at_most(largest, bound), numbers)


def _follows_law(results: Results, rows: Mapping[str, Row]) -> Claim:
    """Where the law gives a rate at all: with noslip it gives none."""
    there = [row for row in rows.values() if row.predicted_creep_mm_s.value]
    formula = "steady rate less that of the law, in size, of the latter"
    found = [
        departure(results, f"{row.case}_from_law", formula, row.steady_creep_mm_s, row.predicted_creep_mm_s)
        for row in there
    ]
    largest = extreme(results, "law_off", "largest of the departures from the law", max, found)
    bound = results.chosen("law_bound", "the same rate", 1.0, unit="%")
    count = cell_count(results, "law_count", "runs for which the law gives a rate", found)
    numbers = {"count": count, "largest": largest, "rate": rows["within-pads-c"].steady_creep_mm_s}
    return Claim("follows_law", at_most(largest, bound), numbers | {"law": rows["within-pads-c"].predicted_creep_mm_s})


def _rest_is_jolts(results: Results, rows: Mapping[str, Row]) -> Claim:
    """The rate on average is more than the steady one, and for a capsule that ends between the pads it is not."""
    long, short = (
        departure(
            results,
            f"{name}_jolts",
            "rate on average less the steady one, of the latter",
            row.creep_mm_s,
            row.steady_creep_mm_s,
        )
        for name, row in (("long", rows["recipe-c"]), ("within-pads", rows["within-pads-c"]))
    )
    bound = results.chosen("jolt_bound", "no jolts", 0.1, unit="%")
    outcome = all_of(greater(long, short, noise=bound), at_most(short, bound))
    return Claim("rest_is_jolts", outcome, {"long": long, "short": short, "bound": bound})


def _impratio_divides(results: Results, rows: Mapping[str, Row]) -> Claim:
    rates = {impratio: rows[f"impratio-{impratio}-c"].steady_creep_mm_s for impratio in (1, 1000)}
    times = ratio(results, "impratio_gain", "rate at impratio 1, of that at impratio 1000", rates[1], rates[1000])
    low = results.chosen("impratio_low", "in inverse proportion", 990.0)
    high = results.chosen("impratio_high", "in inverse proportion", 1010.0)
    numbers = {"slow": rates[1000], "fast": rates[1], "times": times}
    return Claim("impratio_divides", all_of(at_least(times, low), at_most(times, high)), numbers)


def _noslip_helps(results: Results, rows: Mapping[str, Row]) -> Claim:
    noslip, recipe = rows["noslip-c"].creep_mm_s, rows["recipe-c"].creep_mm_s
    left = share(results, "noslip_share", "rate with noslip, of that without", noslip, recipe)
    bound = results.chosen("noslip_bound", "most of it is gone", 5.0, unit="%")
    return Claim("noslip_helps", at_most(left, bound), {"noslip": noslip, "recipe": recipe, "share": left})


def _noslip_helps_through_newton(results: Results, rows: Mapping[str, Row]) -> Claim:
    noslip, recipe = rows["noslip-newton"].creep_mm_s, rows["recipe-newton"].creep_mm_s
    left = share(results, "newton_noslip_share", "rate with noslip, of that without, through Newton", noslip, recipe)
    return Claim(
        "noslip_helps_through_newton", at_most(left, results.derived["noslip_bound"]), {"noslip": noslip, "share": left}
    )


def _newton_changes_a_mass(results: Results, rows: Mapping[str, Row]) -> Claim:
    """Through Newton the steady rate is another, and so are the pads' inverse masses as the engine has them."""
    plain, newton = rows["within-pads-warp"], rows["within-pads-newton"]
    formula = "steady rate through Newton less that in MuJoCo Warp, in size, of the latter"
    moved = departure(results, "newton_change", formula, newton.steady_creep_mm_s, plain.steady_creep_mm_s)
    bound = results.chosen("newton_bound", "another rate", 1.0, unit="%")
    lost = difference(
        results,
        "newton_inverse_mass_lost",
        "pads' inverse mass in MuJoCo Warp less that through Newton",
        plain.pad_inverse_mass,
        newton.pad_inverse_mass,
    )
    least = results.chosen("mass_bound", "another inverse mass", 0.01)
    numbers = {"moved": moved, "inverse": newton.pad_inverse_mass, "plain_inverse": plain.pad_inverse_mass}
    return Claim("newton_changes_a_mass", all_of(at_least(moved, bound), at_least(lost, least)), numbers)


def _table(rows: Mapping[str, Row], published: Mapping[str, Value]) -> Table:
    columns: dict[str, list] = {"published": [published.get(variant, "") for variant in VARIANTS]}
    columns |= {
        label: [rows[f"{variant}-{engine}"].creep_mm_s for variant in VARIANTS] for engine, label in ENGINES.items()
    }
    columns["steady, in C"] = [rows[f"{variant}-c"].steady_creep_mm_s for variant in VARIANTS]
    columns["law, in C"] = [rows[f"{variant}-c"].predicted_creep_mm_s for variant in VARIANTS]
    columns["pads press with"] = [rows[f"{variant}-c"].normal_force_n for variant in VARIANTS]
    return Table(pd.DataFrame(columns, index=pd.Index(map(case_html, VARIANTS), name="run")))


def _draw(rows: Mapping[str, Row], published: Mapping[str, Value]) -> Drawing:
    drawing, axes = new_figure(7.2, 1.1 + (0.4 if is_narrow() else 0.3) * len(VARIANTS))
    marks = {
        "c": {"marker": "x", "markersize": 6},
        "warp": {"marker": "o", "markersize": 9, "markerfacecolor": "none"},
        "newton": {"marker": "s", "markersize": 7, "markerfacecolor": "none"},
    }
    for number, (engine, label) in enumerate(ENGINES.items()):
        cells = [rows[f"{variant}-{engine}"].creep_mm_s for variant in VARIANTS]
        _mark(axes, cells, label, SERIES[number], **marks[engine])
    _mark(
        axes, [rows[f"{variant}-c"].predicted_creep_mm_s for variant in VARIANTS], "law", INK, marker="|", markersize=15
    )
    _mark(axes, [published.get(variant) for variant in VARIANTS], "published", SERIES[3], marker="D", markersize=4)
    axes.set_xscale("log")
    axes.set_yticks(range(len(VARIANTS)), map(name_of, VARIANTS))
    axes.invert_yaxis()
    axes.set_xlabel("the capsule sinks with [mm/s]")
    drawing.legend(loc="outside upper center", ncols=2 if is_narrow() else 5)
    return drawing


def _mark(axes: Axes, cells: Sequence[Quantity | None], label: str, colour: str, **style) -> None:
    """A mark for each cell that there is and that a logarithmic axis can show, in the line of its place."""
    places = [place for place, cell in enumerate(cells) if cell is not None and cell.value and cell.value > 0.0]
    values = [cells[place].value for place in places]
    axes.plot(values, places, linestyle="", markevery=1, color=colour, label=label, **style)
