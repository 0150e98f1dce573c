"""Derive the scatter of repeated runs of one case (an A/A test)."""

from statistics import fmean, stdev

from measured_report.values.noise import SURE
from report.shared import (
    PERCENT,
    VISIBLE,
    Claim,
    Quantity,
    Results,
    Section,
    Value,
    all_of,
    cell_count,
    gathered,
    negligible,
    relevance,
    table_of,
)

order = 20
folded = True
page = "releases"
label = "repeated runs"
labels = {"as-shipped": "shipped pads", "stiff-pads": "stiff pads"}

SHIPPED = "as-shipped"
METRICS = {"slip": "slip_mm", "drift": "drift_mm_s"}


def derive(results: Results) -> Section:
    repeats: dict[str, list] = {SHIPPED: []}
    for row in results.rows:
        if row.plain.get("of"):
            repeats.setdefault(row.of, []).append(row)
    columns: dict[str, list] = {}
    shares = {}
    deviations = {}
    for metric, column in METRICS.items():
        cells = {
            case: [row[column] for row in rows if row[column].value is not None]
            for case, rows in repeats.items()
        }
        scatters = [_scatter(results, metric, *item) for item in cells.items()]
        counts, means, standard_deviations = zip(*scatters, strict=True)
        columns[f"{metric}: runs"] = list(counts)
        columns[f"mean {metric}"] = list(means)
        columns[f"deviation of {metric}"] = list(standard_deviations)
        _, mean, deviation = scatters[0]
        deviations[metric] = deviation
        shares[metric] = results.value(
            f"{metric}_scatter_share",
            f"standard deviation of the {metric} with shipped pads, relative to its"
            " mean",
            PERCENT * deviation / abs(mean),
            is_noise=True,
        )
    results.chosen("confidence", "the usual level", 100 * SURE, "%")
    bound = relevance(results)
    small = all_of(*(negligible(share, bound) for share in shares.values()))
    numbers = {
        **deviations,
        "share": shares["slip"],
        "drift_share": shares["drift"],
        "runs": columns["slip: runs"][0],
        "bound": bound,
        "least": results.chosen("relevance_least", *VISIBLE, "mm"),
    }
    names = [labels.get(case, case) for case in repeats]
    return Section(
        tables={"scatter": table_of("case", names, columns)},
        claims=[Claim("noise_is_small", small, numbers)],
    )


def _scatter(
    results: Results, metric: str, case: str, cells: list[Quantity]
) -> tuple[Value, Value, Value]:
    """Return how many runs a case has, and their mean and standard deviation."""
    name = f"{case.replace('-', '_')}_{metric}"
    unit = results.columns[METRICS[metric]].unit
    count = results.value(f"{name}_count", "runs of the case", cell_count(cells))
    mean = results.value(
        f"{name}_mean", "mean of these runs", gathered(fmean, cells, unit)
    )
    deviation = results.value(
        f"{name}_deviation",
        "standard deviation between these runs",
        gathered(stdev, cells, unit),
        is_noise=True,
    )
    return count, mean, deviation
