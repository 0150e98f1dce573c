"""A pinched capsule that sinks: does it sink as fast as was published, and as fast as the law says?"""

from report.shared import (
    PUBLISHED,
    Claim,
    Column,
    Results,
    Section,
    Value,
    at_most,
    cell_count,
    constant,
    departure,
    extreme,
    table_of,
)

ENGINES = ("c", "warp", "newton")
VARIANTS = {  # labels by variant
    "recipe": "elliptic cone, impratio 10",
    **{f"impratio-{impratio}": f"impratio {impratio}" for impratio in (1, 100, 1000)},
    "pyramidal": "pyramidal cone",
    "stiff": "stiff pads",
    "noslip": "noslip",
    "condim-6": "condim 6",
    "within-pads": "shorter than the pads",
}
PUBLISHED_MM_S = {
    "recipe": 0.15499,
    "impratio-1": 1.5,
    "pyramidal": 2.3,
    "stiff": 0.05,
    "noslip": 0.0014,
}
"""The first from google-deepmind/mujoco pull request 3526, which measured it again, the others from issue 3328."""


def derive(results: Results) -> Section:
    rows = [results.row[f"{variant}-c"] for variant in VARIANTS]
    rates = {
        variant: constant(rate, "mm/s") for variant, rate in PUBLISHED_MM_S.items()
    }
    published = {
        variant: results.value(f"published_{variant}", PUBLISHED, rate)
        for variant, rate in rates.items()
    }
    columns: dict[str, Column] = {"sinks": "creep_mm_s"}
    columns |= {"published": [published.get(variant, "") for variant in VARIANTS]}
    columns |= {
        "once steady": "steady_creep_mm_s",
        "by the law": "predicted_creep_mm_s",
    }
    tables = {"rates": table_of("in MuJoCo C", VARIANTS.values(), columns, rows)}
    return Section(
        tables=tables, claims=[_as_published(results, published), _follows_law(results)]
    )


def _as_published(results: Results, published: dict[str, Value]) -> Claim:
    formula, rows = (
        "rate in MuJoCo C less the published one, in size, of the latter",
        results.row,
    )
    pairs = [
        (variant, rows[f"{variant}-c"].creep_mm_s, rate)
        for variant, rate in published.items()
    ]
    offs = [
        results.value(f"{variant}_from_published", formula, departure(*pair))
        for variant, *pair in pairs
    ]
    largest = results.value(
        "published_off",
        "largest of the departures from what was published",
        extreme(max, offs),
    )
    count = results.value(
        "published_count", "rates that were published", cell_count(offs)
    )
    return Claim(
        "as_published",
        at_most(largest, 5.0, why="the same rate"),
        {"count": count, "largest": largest},
    )


def _follows_law(results: Results) -> Claim:
    """Compare the steady rates with those of the law, which gives none with noslip."""
    rows = [
        results.row[f"{variant}-{engine}"] for engine in ENGINES for variant in VARIANTS
    ]
    pairs = [
        (row.case, row.steady_creep_mm_s, row.predicted_creep_mm_s) for row in rows
    ]
    offs = [
        results.value(
            f"{case}_from_law",
            "steady rate less that of the law, in size, of the latter",
            departure(*pair),
        )
        for case, *pair in pairs
        if pair[1].value
    ]
    largest = results.value(
        "law_off", "largest of the departures from the law", extreme(max, offs)
    )
    count = results.value(
        "law_count", "runs for which the law gives a rate", cell_count(offs)
    )
    return Claim(
        "follows_law",
        at_most(largest, 1.0, why="the same rate"),
        {"count": count, "largest": largest},
    )
