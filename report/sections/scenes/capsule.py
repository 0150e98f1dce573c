"""A pinched capsule that sinks: does it sink as fast as was published, and as fast as the law says?"""

from collections.abc import Iterator, Mapping

from matplotlib.figure import Figure as Drawing

from measured_report.parts.claim import HOLDS, Claim, all_of, at_least, at_most
from measured_report.parts.figures import INK, SERIES, is_narrow, new_figure
from measured_report.parts.section import Figure, Section
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row
from report.shared.arithmetic import cell_count, departure, difference, extreme, ratio, share
from report.shared.drawing import mark_cells, name_lines

ENGINES = ("c", "warp", "newton")
VARIANTS = {
    "recipe": "elliptic cone, impratio 10",
    **{f"impratio-{impratio}": f"impratio {impratio}" for impratio in (1, 100, 1000)},
    "pyramidal": "pyramidal cone",
    "stiff": "stiff pads",
    "noslip": "noslip",
    "condim-6": "condim 6",
    "within-pads": "shorter than the pads",
}
"""Labels by variant."""
PUBLISHED_MM_S = {"recipe": 0.15499, "impratio-1": 1.5, "pyramidal": 2.3, "stiff": 0.05, "noslip": 0.0014}
"""The first from google-deepmind/mujoco pull request 3526, which measured it again, the others from issue 3328."""
Rows = Mapping[str, Row]


def derive(results: Results) -> Section:
    rows = {case: results.row[case] for case in (f"{variant}-{engine}" for engine in ENGINES for variant in VARIANTS)}
    formula = "published, and not measured here"
    published = {
        variant: results.value(f"published_{variant}", formula, lambda rate=rate: rate, unit="mm/s")
        for variant, rate in PUBLISHED_MM_S.items()
    }
    has_noslip = rows["noslip-newton"].creep_mm_s.value is not None  # older releases of MuJoCo Warp have none
    as_published, follows_law = _rates_agree(results, rows, published)
    rates = Figure(
        draw=lambda: _draw(rows, published),
        sources=[rows[f"{variant}-c"].creep_mm_s for variant in VARIANTS],
        numbers={name: rows[f"{name}-c"].creep_mm_s for name in ("recipe", "noslip")}
        | {"is_law": follows_law.outcome == HOLDS},
    )
    return Section(
        figures={"rates": rates},
        claims=[
            as_published,
            follows_law,
            _impratio_divides(results, rows),
            *_noslip_helps(results, rows, has_noslip),
            _newton_changes_a_mass(results, rows),
        ],
        unmeasured=() if has_noslip else ("noslip_helps_through_newton",),
    )


def _rates_agree(results: Results, rows: Rows, published: Mapping[str, Value]) -> Iterator[Claim]:
    """Compare the rates with those that were published, and with the law, which gives none with noslip."""
    formula = "rate in MuJoCo C less the published one, in size, of the latter"
    found = [
        departure(results, f"{variant}_from_published", formula, rows[f"{variant}-c"].creep_mm_s, rate)
        for variant, rate in published.items()
    ]
    largest = extreme(results, "published_off", "largest of the departures from what was published", max, found)
    count = cell_count(results, "published_count", "rates that were published", found)
    numbers = {"count": count, "largest": largest}
    numbers |= {"recipe": rows["recipe-c"].creep_mm_s, "published": published["recipe"]}
    yield Claim("as_published", at_most(largest, 5.0, why="the same rate"), numbers)

    formula = "steady rate less that of the law, in size, of the latter"
    found = [
        departure(results, f"{row.case}_from_law", formula, row.steady_creep_mm_s, row.predicted_creep_mm_s)
        for row in rows.values()
        if row.predicted_creep_mm_s.value
    ]
    largest = extreme(results, "law_off", "largest of the departures from the law", max, found)
    count = cell_count(results, "law_count", "runs for which the law gives a rate", found)
    numbers = {"count": count, "largest": largest}
    yield Claim("follows_law", at_most(largest, 1.0, why="the same rate"), numbers)


def _impratio_divides(results: Results, rows: Rows) -> Claim:
    fast, slow = (rows[f"impratio-{impratio}-c"].steady_creep_mm_s for impratio in (1, 1000))
    times = ratio(results, "impratio_gain", "rate at impratio 1, of that at impratio 1000", fast, slow)
    why = "in inverse proportion"
    outcome = all_of(at_least(times, 990.0, why), at_most(times, 1010.0, why))
    return Claim("impratio_divides", outcome, {"slow": slow, "fast": fast, "times": times})


def _noslip_helps(results: Results, rows: Rows, has_newton: bool) -> Iterator[Claim]:
    for engine, name, where in (("c", "", ""), ("newton", "newton_", ", through Newton"))[: 1 + has_newton]:
        noslip, recipe = (rows[f"{variant}-{engine}"].creep_mm_s for variant in ("noslip", "recipe"))
        left = share(results, f"{name}noslip_share", f"rate with noslip, of that without{where}", noslip, recipe)
        claim = "noslip_helps_through_newton" if where else "noslip_helps"
        numbers = {"noslip": noslip, "share": left, "recipe": recipe}
        yield Claim(claim, at_most(left, 5.0, why="most of it is gone"), numbers)


def _newton_changes_a_mass(results: Results, rows: Rows) -> Claim:
    plain, newton = rows["within-pads-warp"], rows["within-pads-newton"]
    formula = "steady rate through Newton less that in MuJoCo Warp, in size, of the latter"
    moved = departure(results, "newton_change", formula, newton.steady_creep_mm_s, plain.steady_creep_mm_s)
    formula, masses = "pads' inverse mass in MuJoCo Warp less that through Newton", (plain, newton)
    lost = difference(results, "newton_inverse_mass_lost", formula, *(row.pad_inverse_mass for row in masses))
    numbers = {"moved": moved, "inverse": newton.pad_inverse_mass, "plain_inverse": plain.pad_inverse_mass}
    outcome = all_of(at_least(moved, 1.0, why="another rate"), at_least(lost, 0.01, why="another inverse mass"))
    return Claim("newton_changes_a_mass", outcome, numbers)


def _draw(rows: Rows, published: Mapping[str, Value]) -> Drawing:
    drawing, axes = new_figure(7.2, 1.1 + (0.4 if is_narrow() else 0.3) * len(VARIANTS))
    axes.set(xscale="log", xlabel="the capsule sinks with [mm/s]")
    for column, colour, label, style in (
        ("creep_mm_s", SERIES[0], "measured", {"marker": "o", "markersize": 9, "markerfacecolor": "none"}),
        ("predicted_creep_mm_s", INK, "law", {"marker": "|", "markersize": 15}),
    ):
        mark_cells(axes, [rows[f"{variant}-c"][column] for variant in VARIANTS], colour, label, **style)
    mark_cells(axes, list(map(published.get, VARIANTS)), SERIES[4], "published", marker="D", markersize=4)
    name_lines(axes, VARIANTS.values())
    drawing.legend(loc="outside upper center", ncols=3)
    return drawing
