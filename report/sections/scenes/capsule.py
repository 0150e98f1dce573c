"""Compare the sinking of a pinched capsule with published rates and with the law."""

from report.shared import (
    AS_PUBLISHED,
    Claim,
    Results,
    Section,
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
    "impratio-1": "impratio 1",
    "impratio-100": "impratio 100",
    "impratio-1000": "impratio 1000",
    "pyramidal": "pyramidal cone",
    "stiff": "stiff pads",
    "noslip": "noslip",
    "condim-6": "condim 6",
    "within-pads": "shorter than the pads",
}
# The first rate is from google-deepmind/mujoco pull request 3526, which measured it
# again, and the others are from issue 3328.
PUBLISHED_MM_S = {
    "recipe": 0.15499,
    "impratio-1": 1.5,
    "pyramidal": 2.3,
    "stiff": 0.05,
    "noslip": 0.0014,
}


def derive(results: Results) -> Section:
    published = {
        variant: results.value(
            f"published_{variant}", AS_PUBLISHED, constant(rate, "mm/s")
        )
        for variant, rate in PUBLISHED_MM_S.items()
    }
    offs = [
        results.value(
            f"{variant}_from_published",
            "absolute difference between the rate in MuJoCo C and the published one,"
            " relative to the latter",
            departure(results.row[f"{variant}-c"].creep_mm_s, rate),
        )
        for variant, rate in published.items()
    ]
    published_off = results.value(
        "published_off",
        "largest difference from a published rate",
        extreme(max, offs),
    )
    published_count = results.value(
        "published_count", "number of published rates", cell_count(offs)
    )

    # The law does not cover noslip.
    rows = [
        results.row[f"{variant}-{engine}"] for engine in ENGINES for variant in VARIANTS
    ]
    departures = [
        results.value(
            f"{row.case}_from_law",
            "absolute difference between the steady rate and the rate of the law, relative"
            " to the latter",
            departure(row.steady_creep_mm_s, row.predicted_creep_mm_s),
        )
        for row in rows
        if row.predicted_creep_mm_s.value
    ]
    law_off = results.value(
        "law_off", "largest difference from the law", extreme(max, departures)
    )
    law_count = results.value(
        "law_count", "runs for which the law gives a rate", cell_count(departures)
    )
    columns = {
        "sinks": "creep_mm_s",
        "published": [published.get(variant, "") for variant in VARIANTS],
        "steady rate": "steady_creep_mm_s",
        "predicted by the law": "predicted_creep_mm_s",
    }
    in_c = [results.row[f"{variant}-c"] for variant in VARIANTS]
    rates = table_of("in MuJoCo C", VARIANTS.values(), columns, in_c)
    return Section(
        tables={"rates": rates},
        claims=[
            Claim(
                "as_published",
                at_most(published_off, 5.0, "the same rate"),
                {"count": published_count, "largest": published_off},
            ),
            Claim(
                "follows_law",
                at_most(law_off, 1.0, "the same rate"),
                {"count": law_count, "largest": law_off},
            ),
        ],
    )
