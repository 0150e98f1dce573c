"""An A/A test: how far apart runs of one case come out."""

from statistics import fmean

from measured_report.values.noise import CONFIDENCE, PAIRS, tolerance
from report.shared import (
    NEAR_NOISE,
    PERCENT,
    Claim,
    Results,
    Row,
    Section,
    all_of,
    at_most,
    combined,
    gathered,
)

order = 20
page = "releases"
label = "the same again"
labels = {"as-shipped": "shipped pads"}


def derive(results: Results) -> Section:
    repeats: dict[str, list[Row]] = {}
    for row in results.rows:
        if row.plain.get("of"):
            repeats.setdefault(row.of, []).append(row)
    first = next(iter(repeats.values()))
    results.chosen(
        "pairs", "hundreds of differences are compared with it", 100 * PAIRS, "%"
    )
    results.chosen("confidence", "as is usual", 100 * CONFIDENCE, "%")
    results.chosen(
        "near_noise",
        "measured again, some other pair of runs may differ by that",
        NEAR_NOISE,
    )
    floors = {}
    shares = {}
    for metric, name in (("slip", "slip_mm"), ("drift", "drift_mm_s")):
        tolerances = [
            results.value(
                f"{case.replace('-', '_')}_{metric}_tolerance",
                f"{100 * PAIRS:g} % of all pairs of runs of one case differ by no more,"
                " by the spread of those measured",
                gathered(tolerance, [row[name] for row in rows]),
                is_noise=True,
            )
            for case, rows in repeats.items()
        ]
        # Where all runs are alike to the last bit, rounding moves them.
        column = results.columns[name]
        least = results.chosen(
            f"{metric}_resolution",
            "what rounding may do",
            column.resolution,
            column.unit,
        )
        floors[metric] = results.value(
            f"{metric}_floor",
            "largest of the cases, and at least the resolution",
            combined(max, *tolerances, least),
            is_noise=True,
        )
        mean = gathered(fmean, (row[name] for row in first))
        shares[metric] = results.value(
            f"{metric}_floor_share",
            f"noise floor of the {metric}, of the mean {metric} of the first case",
            PERCENT * floors[metric] / abs(mean),
            is_noise=True,
        )
    why = "far less than what is looked for"
    outcome = all_of(*(at_most(share, 1.0, why) for share in shares.values()))
    numbers = {**floors, "share": shares["slip"], "drift_share": shares["drift"]}
    return Section(claims=[Claim("noise_is_small", outcome, numbers)])
