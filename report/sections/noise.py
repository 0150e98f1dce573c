"""An A/A test: how far apart runs of one and the same case come out, and what is called a difference for that."""

from collections.abc import Mapping, Sequence
from statistics import fmean

from measured_report.records.columns import column_of
from measured_report.values.noise import CONFIDENCE, PAIRS, tolerance
from report.shared import (
    NEAR_NOISE,
    PERCENT,
    Claim,
    Results,
    Row,
    Section,
    Value,
    all_of,
    at_most,
    combined,
    gathered,
)

order = 20
page = "releases"
label = "the same again"
labels = {"as-shipped": "shipped pads"}

METRICS = {"slip": "slip_mm", "drift": "drift_mm_s"}


def derive(results: Results) -> Section:
    repeats: dict[str, list[Row]] = {}
    for row in results.rows:
        if row.plain.get("of"):
            repeats.setdefault(row.of, []).append(row)
    floors = {metric: _floor(results, repeats, metric) for metric in METRICS}
    results.chosen(
        "pairs", "hundreds of differences are compared with it", 100 * PAIRS, "%"
    )
    results.chosen("confidence", "as is usual", 100 * CONFIDENCE, "%")
    results.chosen(
        "near_noise",
        "measured again, some other pair of runs may differ by that",
        NEAR_NOISE,
    )
    first, shares = next(iter(repeats.values())), {}
    for metric, floor in floors.items():
        mean = gathered(fmean, (row[METRICS[metric]] for row in first))
        share = PERCENT * floor / abs(mean)
        shares[metric] = results.value(
            f"{metric}_floor_share",
            f"noise floor of the {metric}, of the mean {metric} of the first case",
            share,
            is_noise=True,
        )
    numbers = {**floors, "share": shares["slip"], "drift_share": shares["drift"]}
    outcome = all_of(
        *(
            at_most(share, 1.0, why="far less than what is looked for")
            for share in shares.values()
        )
    )
    return Section(claims=[Claim("noise_is_small", outcome, numbers)])


def _floor(
    results: Results, repeats: Mapping[str, Sequence[Row]], metric: str
) -> Value:
    """Say how far apart two runs may come out, or, where all are alike to the last bit, how far rounding moves them."""
    bounds = []
    for case, rows in repeats.items():
        name, cells = (
            f"{case.replace('-', '_')}_{metric}_tolerance",
            [row[METRICS[metric]] for row in rows],
        )
        bounds.append(
            results.value(
                name,
                f"{100 * PAIRS:g} % of all pairs of runs of one case differ by no more, by the spread of those measured",
                gathered(tolerance, cells),
                is_noise=True,
            )
        )
    column = column_of(METRICS[metric])
    least = results.chosen(
        f"{metric}_resolution", "what rounding may do", column.resolution, column.unit
    )
    return results.value(
        f"{metric}_floor",
        "largest of the cases, and at least the resolution",
        combined(max, *bounds, least),
        is_noise=True,
    )
