"""The cure at the limits of the grasp, where it could break what holds without it."""

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from itertools import chain
from statistics import median
from typing import Any

from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from measured_report.parts.claim import HOLDS, OPPOSITE, Claim, Outcome, at_least, at_most, greater
from measured_report.parts.figures import INK, new_figure
from measured_report.parts.section import Figure, Section
from measured_report.values.labels import label_of
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row
from report.shared.arithmetic import cell_count, noise_floor, ratio, rows_with, some_html
from report.shared.drawing import CURE, TERM, mark_points

VARIANTS = {"term": "the term", "best": "the whole cure"}
ON_STIFF_PADS = ("firm", "firm-euler")
LABELS = {
    "steps-as-shipped-1": "shipped pads, 1 substep",
    "steps-as-shipped-#": "shipped pads, {} substeps",
    "steps-stiff-1": "stiff pads, 1 substep",
    "steps-stiff-#": "stiff pads, {} substeps",
    "ke-critical-#-#": "pads' ke {}, kd = 2√ke, {} substeps",
    "ke-kd-#-#-#": "pads' ke {1}, kd {0}, {2} substeps",
}
CASE = Markup('<span class="case" title="{}">{}</span>')
"""Variants that runs about other pads are not tried with."""
Runs = Mapping[str, Mapping[str, Row]]
"""Rows by the run, and by what is done in it."""


def derive(results: Results) -> Section:
    runs: dict[str, dict[str, Row]] = defaultdict(dict)
    for row in rows_with(results, "of", "variant", "family", "kept"):
        runs[row.of][row.variant] = row
    whole = {name: found for name, found in runs.items() if {"plain", *VARIANTS} <= set(found)}
    kept = [row.creep_mm_s for found in whole.values() for row in found.values() if row.kept]
    count = _count(results, "run_count", "runs", whole.values())
    firm = {name: found for name, found in runs.items() if {"plain", *ON_STIFF_PADS} <= set(found)}
    breaks = [_breaks_nothing(results, whole, variant) for variant in VARIANTS]
    breaks += [_breaks_nothing(results, firm, variant) for variant in ON_STIFF_PADS]
    less = list(_creeps_less(results, whole))
    term, best = (claim.numbers["gain"] for claim in less)
    numbers: dict[str, Any] = {"count": count, "is_so": at_least(best, 2.0, why="clearly less") == HOLDS}
    numbers["is_so"] = numbers["is_so"] and greater(best, term, noise=2.0, why="a gain that differs") == HOLDS
    numbers["has_lost"] = any(claim.numbers["lost_count"].value for claim in breaks[: len(VARIANTS)])
    return Section(figures={"creep": Figure(lambda: _draw(whole), kept, numbers)}, claims=[*breaks, *less])


def _kept(runs: Runs, *variants: str) -> Runs:
    return {name: found for name, found in runs.items() if all(found[variant].kept for variant in variants)}


def _count(results: Results, name: str, formula: str, runs: Iterable[Mapping[str, Row]]) -> Value:
    return cell_count(results, name, formula, [found["plain"].substeps for found in runs])


def _breaks_nothing(results: Results, runs: Runs, variant: str) -> Claim:
    plain, mine, name = _kept(runs, "plain"), _kept(runs, variant), variant.replace("-", "_")
    lost = [run for run in plain if run not in mine]
    won = [found for run, found in mine.items() if run not in plain]
    count = _count(results, f"kept_{name}", "runs that keep the cube with nothing done", plain.values())
    formula = "of these, runs that lose it this way"
    lost_count = _count(results, f"limit_lost_{name}", formula, [plain[run] for run in lost])
    won_count = _count(results, f"won_{name}", "runs that keep it only this way", won)
    outcome = Outcome("unknown", "no run keeps the cube without it")
    if plain:
        outcome = at_most(lost_count, 0, why="none of them is lost")
    numbers = {"count": count, "lost_count": lost_count, "won": won_count}
    lost_names = some_html([CASE.format(run, label_of(run, LABELS)) for run in lost])
    return Claim(f"{name}_breaks_nothing", outcome.having_read(count), numbers | {"lost": lost_names})


def _creeps_less(results: Results, runs: Runs) -> Iterator[Claim]:
    for variant in VARIANTS:
        both = _kept(runs, "plain", variant)
        creeps = {name: [found[each].creep_mm_s for each in ("plain", variant)] for name, found in both.items()}
        formula = "creep with nothing done over that with it"
        gains = [ratio(results, f"gain_{variant}_{name}", formula, *pair) for name, pair in creeps.items()]
        typical = results.value(f"gain_{variant}", "median of these ratios", lambda *found: median(found), *gains)
        worse = results.value(
            f"worse_{variant}",
            "runs that creep faster with it, by more than the noise",
            lambda noise, *found: sum(b - a > noise for a, b in zip(found[::2], found[1::2], strict=True)),
            noise_floor(results, "drift_floor"),
            *chain.from_iterable(creeps.values()),
        )
        count = _count(results, f"both_{variant}", "runs that keep the cube either way", both.values())
        outcome = at_least(typical, 2.0, why="half the creep")
        if 2 * (worse.value or 0) > (count.value or 0):
            outcome = OPPOSITE.having_read(typical)
        outcome = outcome.having_read(worse)
        yield Claim(f"{variant}_creeps_less", outcome, {"gain": typical, "count": count, "worse": worse})


def _draw(runs: Runs) -> Drawing:
    drawing, axes = new_figure(7.2, 3.6)
    there = [row.creep_mm_s.value for found in runs.values() for row in found.values() if row.kept]
    top = 3.0 * max(there, default=1.0)
    before = [found["plain"].creep_mm_s.value for found in _kept(runs, "plain").values()]
    for variant, colour, marker in (("term", TERM, "o"), ("best", CURE, "^")):
        both = _kept(runs, "plain", variant)
        points = [(found["plain"].creep_mm_s.value, found[variant].creep_mm_s.value) for found in both.values()]
        mark_points(axes, points, color=colour, marker=marker, markersize=4, label=VARIANTS[variant])
        lost = [
            (found["plain"].creep_mm_s.value, top) for name, found in _kept(runs, "plain").items() if name not in both
        ]
        mark_points(axes, lost, color=colour, marker="x", clip_on=False)
    ends = [min((value for value in before if value > 0.0), default=0.1), max(before, default=1.0)]
    axes.plot(ends, ends, color=INK, linewidth=0.8, linestyle="-", marker="", label="no change")
    axes.set(xscale="log", yscale="log", xlabel="creep without [mm/s]", ylabel="creep with it [mm/s]")
    axes.set_ylim(top=top)
    drawing.legend(loc="outside upper left", ncols=3)
    return drawing
