"""Cases that each change one thing, against the baseline that was measured with them."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from measured_report.claims.claim import NEAR_NOISE, Claim, Outcome, greater, within
from measured_report.parts.figures import FAINT, INK, SERIES, new_figure, write
from measured_report.parts.section import Figure, Section
from measured_report.values.quantities import Quantity, Value, absent
from measured_report.values.results import Results, Row
from report.names import case_html, name_of
from report.shared.arithmetic import Column, by_case, difference, largest_size, noise_floor, share


@dataclass(frozen=True)
class Variants:
    """The rows of one section, and what each changes in the slip."""

    baseline: Row
    rows: Sequence[Row]
    """Without the baseline."""
    difference: Mapping[str, Quantity]
    """Slip of a case less that of the baseline [mm]."""
    largest: Value
    """The largest of the differences, either way."""
    floor: Quantity
    """How far apart runs of one case are [mm]."""
    numbers: dict[str, Quantity | str]
    """What the wording of a claim can name."""

    @property
    def all_rows(self) -> list[Row]:
        return [self.baseline, *self.rows]


class Differences(dict):
    """By case; that of a case without a row is absent."""

    def __missing__(self, case: str) -> Quantity:
        return absent("mm", f"there is no single row of case {case}")


def variant_section(results: Results, variants: Variants, labels: Mapping[str, str], *claims: Claim) -> Section:
    """Make the section of variants: their table and figure, whether one is the cause or differs from the baseline at
    all, and more claims; ``labels`` says in words which columns are parameters of a case."""
    columns: dict[str, Column] = {
        "changed": lambda row: _changed(row, variants.baseline, labels),
        "slip": "slip_mm",
        "against baseline": lambda row: variants.difference.get(row.case, ""),
        "drift": "drift_mm_s",
    }
    slips = [row.slip_mm for row in variants.all_rows]
    bound = results.chosen("cause_bound", "a cause would change the slip by more", 10.0, unit="%")
    cause = is_small(results, "cause", variants.largest, bound, variants.baseline.slip_mm, variants.floor)
    found = {case_html(case): value for case, value in variants.difference.items()}
    differs = variants.numbers | {"beyond": beyond_noise(found, variants.floor)}
    return Section(
        tables={"cases": by_case(variants.all_rows, columns)},
        figures={"cases": Figure(lambda: _draw_variants(variants), slips, variants.numbers)},
        claims=[
            Claim("not_the_cause", cause, variants.numbers),
            Claim("within_noise", within(variants.largest, variants.floor), differs),
            *claims,
        ],
    )


def variants_of(results: Results, baseline: str) -> Variants:
    """Compare every row of the section with the row of the case ``baseline``."""
    reference, rows = results.row[baseline], [row for row in results.rows if row.case != baseline]
    found = Differences()
    for row in rows:
        formula = f"slip of {row.case} less that of {reference.case}"
        found[row.case] = difference(results, f"{row.case}_difference", formula, row.slip_mm, reference.slip_mm)
    formula = "largest difference in slip from the baseline, either way"
    largest = largest_size(results, "largest_difference", formula, found.values(), unit="mm")
    formula = "largest difference in slip from the baseline, of the baseline's slip"
    of_slip = share(results, "largest_share", formula, largest, reference.slip_mm)
    most = case_html(max(found, key=lambda case: abs(found[case].value or 0.0), default="none"))
    floor = noise_floor(results, "slip_floor")
    numbers = {"largest": largest, "share": of_slip, "most": most, "baseline": reference.slip_mm, "floor": floor}
    return Variants(reference, rows, found, largest, floor, numbers)


def is_small(results: Results, name: str, change: Quantity, bound: Value, slip: Quantity, noise: Quantity) -> Outcome:
    """Tell whether a change of slip [mm] is less than ``bound`` percent of a slip, by more than the noise; more is the
    opposite."""
    formula = f"{bound.written} % of the slip, signs left out"
    limit = results.value(f"{name}_limit", formula, lambda a, b: a / 100 * abs(b), bound, slip, unit="mm")
    return greater(limit, change, noise=noise)


def beyond_noise(differences: Mapping[Markup, Quantity], floor: Quantity) -> Markup:
    """Name the differences that are clearly larger than the noise, either way."""
    there = {name: value for name, value in differences.items() if None not in (value.value, floor.value)}
    beyond = {name: value for name, value in there.items() if abs(value.value) > NEAR_NOISE * floor.value}
    before = [absent("mm", "it is the first"), *beyond.values()]
    return Markup(", ").join(
        Markup("{} by {}").format(name, value.beside(last))
        for last, (name, value) in zip(before, beyond.items(), strict=False)
    )


def _changed(row: Row, baseline: Row, labels: Mapping[str, str]) -> Markup:
    if row is baseline:
        return Markup("nothing: baseline")
    own = {name: label for name, label in labels.items() if name in row}
    changed = {label: row[name] for name, label in own.items() if name not in baseline or row[name] != baseline[name]}
    return Markup(", ").join(Markup("{} {}").format(label, value) for label, value in changed.items())


def _draw_variants(variants: Variants) -> Drawing:
    rows = [row for row in variants.all_rows if row.slip_mm.value is not None]
    names, slips = [name_of(row.case) for row in rows], [row.slip_mm.value for row in rows]
    drawing, (left, right) = new_figure(7.2, 0.9 + 0.3 * len(rows), ncols=2, sharey=True)
    left.barh(names, slips, height=0.6, color=SERIES[0], linewidth=0)
    for place, (row, slip) in enumerate(zip(rows, slips, strict=True)):
        beside = {"xytext": (4, 0), "textcoords": "offset points", "va": "center"}
        left.annotate(write(row.slip_mm), (slip, place), fontsize=9, **beside)
    left.set(xlim=(0.0, 1.25 * max(slips)), xlabel="slip [mm]")
    reference, floor = variants.baseline.slip_mm.value, variants.floor.value
    if reference is not None:
        right.axvline(0.0, color=INK, linewidth=1, linestyle="--", marker="")
        if floor is not None:
            right.axvspan(-floor, floor, color=FAINT, alpha=0.6, linewidth=0, zorder=0)
            above = {"xycoords": ("data", "axes fraction"), "ha": "center", "va": "bottom"}
            right.annotate("noise", (0.0, 1.0), fontsize=8.5, **above)
        right.plot([slip - reference for slip in slips], names, "o", color=SERIES[1], markevery=1, markersize=6)
    right.set_xlabel(f"difference from\n{names[0]} [mm]")
    right.locator_params(axis="x", nbins=4)
    right.tick_params(axis="y", left=False)
    left.invert_yaxis()
    left.grid(visible=False)
    return drawing
