"""An A/A test: how far apart runs of one and the same case come out, and what is called a difference for that."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from statistics import fmean

import numpy as np
from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from measured_report.parts.claim import HOLDS, NEAR_NOISE, Claim, all_of, at_least, at_most, within
from measured_report.parts.figures import INK, new_figure
from measured_report.parts.section import Figure, Section
from measured_report.records.columns import column_of
from measured_report.values.labels import label_of
from measured_report.values.noise import CONFIDENCE, PAIRS, tolerance
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.shared.arithmetic import cell_count, extreme, share, size_difference, spread, table_of
from report.shared.drawing import SHIPPED, STIFF, mark_points

order = 20
page = "method"
label = "the same again"
labels = {"as-shipped": "shipped pads"}

METRICS, UNITS = {"slip": "slip_mm", "drift": "drift_mm_s"}, {"slip": "mm", "drift": "mm/s"}
SMALL = "far less than what is looked for"
SWITCHES = {
    "plain": "as shipped",
    "sorted": "Newton's contacts sorted",
    "ordered": "MuJoCo Warp asked to order its contacts and rows",
    "all": "MuJoCo Warp asked to order its sums as well",
}
SO = {"sorted": SWITCHES["sorted"], "ordered": f"{SWITCHES['sorted']} and {SWITCHES['ordered']}"}
SO |= {"all": "all that both offer"}
"""The same in a sentence."""


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
        return f"{label_of(self.case, labels)}, {'in a batch' if self.kind == 'batch' else 'alone'}"

    def cells(self, metric: str) -> list[Quantity]:
        return [row[METRICS[metric]] for row in self.rows]


def derive(results: Results) -> Section:
    twice = {case: results.row[case] for case in SWITCHES}
    repeated = [row for row in results.rows if row.case not in SWITCHES]
    keys = dict.fromkeys((row.of, row.kind) for row in repeated)
    groups = [Group(*key, [row for row in repeated if (row.of, row.kind) == key]) for key in keys]
    floors = {metric: _floor(results, groups, metric) for metric in METRICS}
    means, spreads = (
        {metric: [find(results, group, metric) for group in groups] for metric in METRICS} for find in (_mean, _spread)
    )
    alike = _batch_or_alone(results, groups, means, spreads)
    labelled = list(zip([group.label for group in groups], spreads["slip"], strict=True))
    numbers = {"groups": labelled, "is_alike": alike.outcome == HOLDS}
    runs = Figure(lambda: _draw_runs(groups), [slip for group in groups for slip in group.cells("slip")], numbers)
    results.chosen("pairs", "hundreds of differences are compared with it", 100 * PAIRS, unit="%")
    results.chosen("confidence", "as is usual", 100 * CONFIDENCE, unit="%")
    results.chosen("near_noise", "measured again, some other pair of runs may differ by that", NEAR_NOISE)
    counts = [cell_count(results, f"{group.name}_count", "number of runs", group.cells("slip")) for group in groups]
    columns = {"runs": counts}
    for metric in METRICS:
        columns |= {f"mean {metric}": means[metric], f"{metric} spread": spreads[metric]}
    exact = [_plain_differs(twice["plain"]), _some_switch_repeats(results, twice)] if twice["plain"] else []
    return Section(
        tables={"groups": table_of("case", [group.label for group in groups], columns)},
        figures={"runs": runs},
        claims=[_noise_is_small(results, groups, floors), alike, *exact],
        unmeasured=() if exact else ("plain_differs", "some_way_repeats"),  # as in releases that were measured before
    )


def _of_case(groups: Sequence[Group], case: str, metric: str) -> list[Quantity]:
    return [cell for group in groups if group.case == case for cell in group.cells(metric)]


def _floor(results: Results, groups: Sequence[Group], metric: str) -> Value:
    """Say how far apart two runs of one case may come out in ``metric``, or the least resolved.

    On a CPU all runs are alike to the last bit, but a change that only rounds differently is no finding there either.
    """
    unit = UNITS[metric]
    formula = f"{100 * PAIRS:g} % of all pairs of runs of one case differ by no more, by the spread of those measured"
    bounds = []
    for case in dict.fromkeys(group.case for group in groups):
        name, cells = f"{case.replace('-', '_')}_{metric}_tolerance", _of_case(groups, case, metric)
        bounds.append(results.value(name, formula, lambda *cell: tolerance(cell), *cells, unit=unit, is_noise=True))
    resolution = column_of(METRICS[metric]).resolution
    least = results.chosen(f"{metric}_resolution", "what rounding may do", resolution, unit=unit)
    formula = "largest of the cases, and at least the resolution"
    return results.value(f"{metric}_floor", formula, max, *bounds, least, unit=unit, is_noise=True)


def _spread(results: Results, group: Group, metric: str) -> Value:
    name, cells = f"{group.name}_{metric}_spread", group.cells(metric)
    return spread(results, name, "largest minus smallest", cells, unit=UNITS[metric], is_noise=True)


def _mean(results: Results, group: Group, metric: str) -> Value:
    name, cells = f"{group.name}_{metric}_mean", group.cells(metric)
    return results.value(name, "mean", lambda *cell: fmean(cell), *cells, unit=UNITS[metric])


def _noise_is_small(results: Results, groups: Sequence[Group], floors: Mapping[str, Value]) -> Claim:
    def of_mean(floor: float, *found: float) -> float:
        return 100 * floor / fmean(found)

    shares = {}
    for metric, floor in floors.items():
        formula = f"noise floor of the {metric}, of the mean {metric} of the first case"
        cells = floor, *_of_case(groups, groups[0].case, metric)
        name = f"{metric}_floor_share"
        shares[metric] = results.value(name, formula, of_mean, *cells, unit="%", is_noise=True)
    numbers = {**floors, "share": shares["slip"], "drift_share": shares["drift"]}
    return Claim("noise_is_small", all_of(*(at_most(share, 1.0, why=SMALL) for share in shares.values())), numbers)


def _batch_or_alone(results: Results, groups: Sequence[Group], means: Mapping, spreads: Mapping) -> Claim:
    kinds = [group.kind for group in groups]
    places = kinds.index("batch"), kinds.index("alone")
    batch, alone = (means["slip"][place] for place in places)
    formula = "difference between the mean slip in a batch and alone"
    apart = size_difference(results, "alone_difference", formula, batch, alone)
    of_slip = share(results, "alone_share", "that difference, of the mean slip in a batch", apart, batch)
    formula, pair = "larger of the spreads in a batch and alone", (spreads["slip"][place] for place in places)
    kind_spread = results.value("within_spread", formula, max, *pair, unit="mm", is_noise=True)
    outcome = all_of(within(apart, kind_spread), at_most(of_slip, 1.0, why=SMALL))
    return Claim("batch_or_alone", outcome, {"difference": apart, "within": kind_spread, "share": of_slip})


def _plain_differs(plain: Row) -> Claim:
    differing, spread = plain.differing_world_count, plain.run_spread_mm
    is_seen = at_least(spread, 1e-6, why="to be seen in the slip")
    outcome = all_of(at_least(differing, 1, why="one of them is enough"), is_seen)
    return Claim("plain_differs", outcome, {"differing": differing, "worlds": plain.worlds, "spread": spread})


def _some_switch_repeats(results: Results, rows: Mapping[str, Row]) -> Claim:
    counts = {switch: rows[switch].differing_world_count for switch in SO}
    exact = next((switch for switch, count in counts.items() if count.value == 0), "")
    formula = "least number of worlds that differ, of all ways"
    least = extreme(results, "differing_least", formula, min, list(counts.values()))
    tried = Markup("; ").join(SWITCHES[switch] for switch, count in counts.items() if count.value is not None)
    numbers = {"way": SO.get(exact, ""), "tried": tried, "worlds": rows["plain"].worlds, "least": least}
    return Claim("some_way_repeats", at_most(least, 0, why="the same to the last bit"), numbers)


def _draw_runs(groups: Sequence[Group]) -> Drawing:
    drawing, axes = new_figure(7.2, 0.7 + 0.55 * len(groups))
    for place, group in enumerate(groups):
        slips = np.array([cell.value for cell in group.cells("slip") if cell.value is not None])
        of_case = [cell.value for cell in _of_case(groups, group.case, "slip") if cell.value is not None]
        # Dots of one group take turns in height, so that equal slips are still seen as many.
        heights = place + 0.09 * (np.arange(len(slips)) % 5 - 2)
        colour, marker = SHIPPED if group.case == "as-shipped" else STIFF, "o" if group.kind == "batch" else "^"
        style = {"markersize": 5, "markerfacecolor": "none", "color": colour, "marker": marker}
        mark_points(axes, zip(slips - np.mean(of_case), heights, strict=True), **style)
        axes.vlines(slips.mean() - np.mean(of_case), place - 0.3, place + 0.3, color=INK, linewidth=1.2)
    axes.set_yticks(range(len(groups)), [group.label for group in groups])
    axes.set_ylim(len(groups) - 0.5, -0.5)
    axes.grid(axis="y", visible=False)
    axes.set_xlabel("slip, less the mean of its case [mm]")
    return drawing
