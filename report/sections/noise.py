"""An A/A test: how far apart runs of one and the same case come out, and what is called a difference for that."""

from collections.abc import Sequence
from dataclasses import dataclass
from statistics import fmean

import numpy as np
import pandas as pd
from matplotlib.figure import Figure as Drawing

from measured_report.claims.claims import NEAR_NOISE, Claim, all_of, at_most, within
from measured_report.parts.figures import INK, SERIES, new_figure
from measured_report.parts.parts import Figure, Section, Table
from measured_report.records.columns import column_of
from measured_report.values.noise import CONFIDENCE, PAIRS, tolerance
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.names import name_of
from report.shared.arithmetic import cell_count, share, spread

order = 20
page = "method"
label = "the same again"


@dataclass(frozen=True)
class Group:
    """Runs of one case, all in a batch or all alone."""

    case: str
    kind: str
    rows: Sequence[Row]

    @property
    def name(self) -> str:
        return f"{self.case.replace('-', '_')}_{self.kind}"

    @property
    def label(self) -> str:
        return f"{name_of(self.case)}, {'in a batch' if self.kind == 'batch' else 'alone'}"

    @property
    def slips(self) -> list[Quantity]:
        return [row.slip_mm for row in self.rows]

    @property
    def drifts(self) -> list[Quantity]:
        return [row.drift_mm_s for row in self.rows]


def derive(results: Results) -> Section:
    groups = _groups(results.rows)
    slip_floor = _floor(results, "slip", "mm", {group.case: _of_case(groups, group.case, "slips") for group in groups})
    drift_floor = _floor(
        results, "drift", "mm/s", {group.case: _of_case(groups, group.case, "drifts") for group in groups}
    )
    spreads = {group.name: _spread(results, f"{group.name}_slip_spread", group.slips, "mm") for group in groups}
    mean = {group.name: _mean(results, f"{group.name}_slip_mean", group.slips, "mm") for group in groups}
    runs = Figure(
        draw=lambda: _draw_runs(groups),
        sources=[slip for group in groups for slip in group.slips],
        numbers={"groups": [(group.label, spreads[group.name]) for group in groups]},
    )
    results.chosen("pairs", "hundreds of differences are compared with it", 100 * PAIRS, unit="%")
    results.chosen("confidence", "as is usual", 100 * CONFIDENCE, unit="%")
    results.chosen("near_noise", "measured again, some other pair of runs may differ by that", NEAR_NOISE)
    return Section(
        tables={"groups": _table(results, groups, mean, spreads)},
        figures={"runs": runs},
        claims=[
            _noise_is_small(results, groups, slip_floor, drift_floor),
            _batch_or_alone(results, groups, mean, spreads),
        ],
    )


def _groups(rows: Sequence[Row]) -> list[Group]:
    keys = dict.fromkeys((row.of, row.kind) for row in rows)
    return [Group(case, kind, [row for row in rows if (row.of, row.kind) == (case, kind)]) for case, kind in keys]


def _of_case(groups: Sequence[Group], case: str, column: str) -> list[Quantity]:
    return [cell for group in groups if group.case == case for cell in getattr(group, column)]


def _floor(results: Results, metric: str, unit: str, cells: dict[str, list[Quantity]]) -> Value:
    """How far apart two runs of one case may come out in ``metric``, or the least resolved.

    On a CPU all runs are alike to the last bit, but a change that only rounds differently is no finding there either.
    """
    formula = f"{100 * PAIRS:g} % of all pairs of runs of one case differ by no more, by the spread of those measured"
    bounds = [
        results.value(
            f"{case.replace('-', '_')}_{metric}_tolerance",
            formula,
            lambda *cell: tolerance(cell),
            *of_case,
            unit=unit,
            is_noise=True,
        )
        for case, of_case in cells.items()
    ]
    column = {"slip": "slip_mm", "drift": "drift_mm_s"}[metric]
    least = results.chosen(f"{metric}_resolution", "what rounding may do", column_of(column).resolution, unit=unit)
    formula = "largest of the cases, and at least the resolution"
    return results.value(f"{metric}_floor", formula, max, *bounds, least, unit=unit, is_noise=True)


def _spread(results: Results, name: str, cells: Sequence[Quantity], unit: str) -> Value:
    return spread(results, name, "largest minus smallest", cells, unit=unit, is_noise=True)


def _mean(results: Results, name: str, cells: Sequence[Quantity], unit: str) -> Value:
    return results.value(name, "mean", lambda *cell: fmean(cell), *cells, unit=unit)


def _noise_is_small(results: Results, groups: Sequence[Group], slip_floor: Value, drift_floor: Value) -> Claim:
    shares = {
        metric: results.value(
            f"{metric}_floor_share",
            f"noise floor of the {metric}, of the mean {metric} of the first case",
            lambda floor, *found: 100 * floor / fmean(found),
            floor,
            *_of_case(groups, groups[0].case, f"{metric}s"),
            unit="%",
            is_noise=True,
        )
        for metric, floor in (("slip", slip_floor), ("drift", drift_floor))
    }
    bound = results.chosen("slip_floor_share_bound", "far less than what is looked for", 1.0, unit="%")
    return Claim(
        "noise_is_small",
        all_of(*(at_most(share, bound) for share in shares.values())),
        numbers={"slip": slip_floor, "share": shares["slip"], "drift": drift_floor, "drift_share": shares["drift"]},
    )


def _batch_or_alone(
    results: Results, groups: Sequence[Group], mean: dict[str, Value], spreads: dict[str, Value]
) -> Claim:
    """Of the first case, which is there both ways."""
    batch, alone = (next(group.name for group in groups if group.kind == kind) for kind in ("batch", "alone"))
    difference = results.value(
        "alone_difference",
        "difference between the mean slip in a batch and alone",
        lambda a, b: abs(a - b),
        mean[batch],
        mean[alone],
        unit="mm",
    )
    of_slip = share(results, "alone_share", "that difference, of the mean slip in a batch", difference, mean[batch])
    kind_spread = results.value(
        "within_spread",
        "larger of the spreads in a batch and alone",
        max,
        spreads[batch],
        spreads[alone],
        unit="mm",
        is_noise=True,
    )
    bound = results.chosen("alone_share_bound", "far less than what is looked for", 1.0, unit="%")
    return Claim(
        "batch_or_alone",
        all_of(within(difference, kind_spread), at_most(of_slip, bound)),
        numbers={"difference": difference, "within": kind_spread, "share": of_slip},
    )


def _table(results: Results, groups: Sequence[Group], mean: dict[str, Value], spreads: dict[str, Value]) -> Table:
    columns = {
        "runs": [cell_count(results, f"{group.name}_count", "number of runs", group.slips) for group in groups],
        "mean slip": [mean[group.name] for group in groups],
        "slip spread": [spreads[group.name] for group in groups],
        "mean drift": [_mean(results, f"{group.name}_drift_mean", group.drifts, "mm/s") for group in groups],
        "drift spread": [_spread(results, f"{group.name}_drift_spread", group.drifts, "mm/s") for group in groups],
    }
    index = pd.Index([group.label for group in groups], name="case")
    return Table(pd.DataFrame(columns, index=index))


def _draw_runs(groups: Sequence[Group]) -> Drawing:
    drawing, axes = new_figure(7.2, 0.7 + 0.55 * len(groups))
    for place, group in enumerate(groups):
        slips = np.array([cell.value for cell in group.slips if cell.value is not None])
        of_case = [cell.value for cell in _of_case(groups, group.case, "slips") if cell.value is not None]
        # Dots of one group take turns in height, so that equal slips are still seen as many.
        heights = place + 0.09 * (np.arange(len(slips)) % 5 - 2)
        batch = group.kind == "batch"
        axes.plot(
            slips - np.mean(of_case),
            heights,
            linestyle="",
            marker="o" if batch else "^",
            markevery=1,  # the style marks only some
            markersize=5,
            markerfacecolor="none",
            color=SERIES[0] if batch else SERIES[1],
        )
        axes.vlines(slips.mean() - np.mean(of_case), place - 0.3, place + 0.3, color=INK, linewidth=1.2)
    axes.set_yticks(range(len(groups)), [group.label for group in groups])
    axes.set_ylim(len(groups) - 0.5, -0.5)
    axes.grid(axis="y", visible=False)
    axes.set_xlabel("slip, less the mean of its case [mm]")
    return drawing
