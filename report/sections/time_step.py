"""Pads for each time step: the rule, the slip that the law predicts, and the price."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

from report.shared import (
    HOLDS,
    MM_PER_M,
    MS_PER_S,
    TIMED_WORLDS,
    Claim,
    Figure,
    Outcome,
    Quantity,
    Results,
    Row,
    RowsBy,
    Section,
    Sections,
    Value,
    absent,
    all_of,
    at_least,
    at_most,
    cell_count,
    combined,
    constant,
    decided,
    departure,
    extreme,
    greater,
    is_held,
    quantile,
    table_of,
    worlds_name,
)
from report.shared.drawing import (
    CURE,
    INK,
    SERIES,
    SHIPPED,
    STIFF,
    Drawing,
    new_figure,
    tick_at,
    write_beside,
)

order = 128
page = "step"
reads = ("drift_law", "step_cost")
first = True
label = "time step"

NEWTON = "newton-elliptic"
RULE = "kd-1"
PADS = {"shipped": "shipped pads", "stiff": "the same stiff pads", RULE: "the rule"}
CRITICAL = ("kd-0.125", "kd-0.25", "kd-0.5", RULE, "kd-2")
"""Pads with a damping ratio of 1, in the order of their kd."""
FIRMER = ("ke-4", "ke-16", "ke-64")
"""Pads with the kd of the rule and a larger ke, in the order of ke."""
SETTINGS = {
    NEWTON: "Newton's contacts, elliptic cone",
    "newton-pyramidal": "Newton's contacts, pyramidal cone",
    "mujoco-elliptic": "MuJoCo's contacts, elliptic cone",
    "mujoco-pyramidal": "MuJoCo's contacts, pyramidal cone",
}
LONGEST_MS = 10.0  # chosen: longer steps do not resolve the shake
SHIPPED_SUBSTEPS = 16
FOLLOWED = 0.9  # chosen: the share of the runs that have to follow the law
REMEDIES = {
    (NEWTON, "shipped"): ("shipped pads", SHIPPED, "o"),
    (NEWTON, "stiff"): ("the same stiff pads", SERIES[4], "s"),
    (NEWTON, RULE): ("the rule", STIFF, "D"),
    ("cure", "shipped"): ("the root cure", CURE, "o"),
    ("rk4", RULE): ("RK4, the rule", SERIES[5], "^"),
    ("c", RULE): ("MuJoCo C, the rule", SERIES[3], "v"),
}
"""Name, colour and marker of each line in the figure, by setting and pads."""


@dataclass(frozen=True)
class Ladder:
    """The rows of a record by setting, pads and number of substeps."""

    results: Results
    rows: RowsBy

    def substeps(self, setting: str = NEWTON, pads: str = RULE) -> list[int]:
        """Return the numbers of substeps that were measured, the longest step first."""
        return sorted(
            count for kind, name, count in self.rows if (kind, name) == (setting, pads)
        )

    def row(self, setting: str, pads: str, substeps: int) -> Row:
        return self.rows[setting, pads, substeps]

    def slip(self, setting: str, pads: str, substeps: int) -> Quantity:
        return self.row(setting, pads, substeps).slip_mm

    def resolved(self, setting: str = NEWTON) -> list[int]:
        """Return the numbers of substeps whose step is short enough for the shake."""
        return [
            count
            for count in self.substeps(setting)
            if self.row(setting, RULE, count).plain["substep_ms"] <= LONGEST_MS
        ]


def derive(results: Results) -> Section:
    rows = RowsBy(results, results.rows, "setting", "pads", "substeps")
    ladder = Ladder(results, rows)
    laws = {
        key: _predicted(results, rows[key], "_".join(map(str, key)))
        for key in rows
        if key[0] in SETTINGS
    }
    claims = [
        _is_best(results, ladder),
        _halves(results, ladder),
        _fixed_pads(ladder),
        _follows(results, ladder, laws),
        _margin(results, ladder),
        _fine(results, ladder),
    ]
    return Section(
        tables={"rule": _table(results, ladder, laws)},
        figures={"steps": _figure(ladder)},
        claims=claims,
    )


def _predicted(results: Results, row: Row, name: str) -> Value | Quantity:
    """Derive the slip of a run that the law of the drift predicts."""
    if not is_held(row) or "timeconst_s" not in row:
        return absent("mm", "the cube is lost")
    others = Sections(results.others)
    own = row.plain["friction_timeconst_s"] or 0.0
    timeconst = row.friction_timeconst_s if own > 0.0 else row.timeconst_s
    step = row.substep_ms / MS_PER_S
    response = row.dmax * combined(max, timeconst, 2 * step)
    return results.value(
        f"law_{name}",
        "duration of the shake times the drift that the law predicts: half of the mean of"
        " J̇q̇ times the response time minus the step",
        0.5 * others.value("drift_law", "g") * (response - step) * row.shake_duration_s,
    )


def _is_best(results: Results, ladder: Ladder) -> Claim:
    """Test whether no other damping keeps the cube better than the rule."""
    ratios = []
    for count in ladder.resolved():
        slips = [
            ladder.slip(NEWTON, pads, count)
            for pads in ("shipped", "stiff", *CRITICAL)
            if pads != RULE and is_held(ladder.row(NEWTON, pads, count))
        ]
        ratios.append(ladder.slip(NEWTON, RULE, count) / combined(min, *slips))
    worst = results.value(
        "rule_worst",
        "largest ratio of the slip by the rule to the smallest slip of other pads at the"
        " same step",
        combined(max, *ratios),
    )
    numbers = {"worst": worst, "count": results.value(
        "rule_count", "steps that were compared", cell_count(ladder.row(NEWTON, RULE, count).slip_mm for count in ladder.resolved())
    )}
    return Claim("is_best", at_most(worst, 1.1, "practically the best"), numbers)


def _halves(results: Results, ladder: Ladder) -> Claim:
    """Test whether half the step halves the slip, with pads that follow the rule."""
    counts = ladder.resolved()
    ratios = [
        ladder.slip(NEWTON, RULE, count) / ladder.slip(NEWTON, RULE, 2 * count)
        for count in counts
        if 2 * count in counts
    ]
    least = results.value(
        "halving_least",
        "smallest ratio of the slips at a step and at half of it, with the rule",
        combined(min, *ratios),
    )
    most = results.value(
        "halving_most", "largest such ratio", combined(max, *ratios)
    )
    first, last = (ladder.row(NEWTON, RULE, count) for count in (counts[0], counts[-1]))
    return Claim(
        "halves",
        at_least(least, 1.6, "nearly half").having_read(most),
        {
            "least": least,
            "most": most,
            "long": first.substep_ms,
            "short": last.substep_ms,
            "before": first.slip_mm,
            "after": last.slip_mm,
        },
    )


def _fixed_pads(ladder: Ladder) -> Claim:
    """Test whether a shorter step makes the slip larger if the pads stay the same."""
    rows = [ladder.row(NEWTON, "stiff", n) for n in (SHIPPED_SUBSTEPS, 4 * SHIPPED_SUBSTEPS)]
    shipped, short = rows
    rule = ladder.row(NEWTON, RULE, 4 * SHIPPED_SUBSTEPS)
    return Claim(
        "fixed_pads",
        greater(short.slip_mm, shipped.slip_mm).having_read(rule.slip_mm),
        {
            "ke": shipped.pad_ke,
            "kd": shipped.pad_kd,
            "step": shipped.substep_ms,
            "short": short.substep_ms,
            "before": shipped.slip_mm,
            "after": short.slip_mm,
            "rule": rule.slip_mm,
        },
    )


def _follows(results: Results, ladder: Ladder, laws: dict) -> Claim:
    """Test whether the law predicts the slip of these runs."""
    compared = {
        (setting, pads, count): law
        for (setting, pads, count), law in laws.items()
        if pads in ("shipped", "stiff", *CRITICAL)
        and count in ladder.resolved(setting)
        and law.value is not None
    }
    offs = [
        results.value(
            "off_" + "_".join(map(str, key)),
            "absolute difference between the slip and that of the law, relative to the slip",
            departure(law, ladder.slip(*key)),
        )
        for key, law in compared.items()
    ]
    most = results.value(
        "law_off",
        "largest difference from the law among the closest nine in ten runs",
        combined(partial(quantile, FOLLOWED), *offs),
    )
    slips = [ladder.slip(*key) for key in compared]
    return Claim(
        "follows",
        at_most(most, 10.0, "a prediction that one can use").having_read(*slips),
        {
            "most": most,
            "count": results.value("law_count", "runs that were compared", cell_count(slips)),
            "least_slip": results.value("law_least", "smallest slip of these runs", combined(min, *slips)),
            "most_slip": results.value("law_most", "largest slip of these runs", combined(max, *slips)),
        },
    )


def _margin(results: Results, ladder: Ladder) -> Claim:
    """Test how far ke can be raised above the rule before the cube is lost."""
    counts = ladder.resolved()
    held = {
        pads: [is_held(ladder.row(NEWTON, pads, count)) for count in counts]
        for pads in (RULE, *FIRMER)
    }
    ends = []
    firm = [pads for pads in FIRMER if all(held[pads])]
    lost = [pads for pads in FIRMER if not all(held[pads])]

    def factor(name: str, pads: Sequence[str], formula: str) -> Quantity:
        if not pads:
            return absent("1", "no such ke was tried")
        cell = ladder.row(NEWTON, pads[0], counts[0]).pad_ke / ladder.row(NEWTON, RULE, counts[0]).pad_ke
        return results.value(name, formula, cell)

    outcome = decided(
        all(held[RULE]), *(ladder.row(NEWTON, RULE, count).slip_mm for count in counts)
    )
    return Claim(
        "margin",
        outcome,
        {
            "safe": factor("ke_safe", firm[-1:], "largest ke relative to the rule with which every run keeps the cube"),
            "lost": factor("ke_lost", lost[:1], "smallest ke relative to the rule with which a run loses it"),
            "long": ladder.row(NEWTON, RULE, counts[0]).substep_ms,
            "short": ladder.row(NEWTON, RULE, counts[-1]).substep_ms,
        },
    )


def _fine(results: Results, ladder: Ladder) -> Claim:
    """Find the longest step at which the rule ends the creep, and its price."""
    others = Sections(results.others)
    bound = others.value("newton_solvers", "ended_bound")
    counts = [
        count
        for count in ladder.substeps()
        if at_most(ladder.slip(NEWTON, RULE, count), bound) == HOLDS
    ]
    if not counts:
        none = Outcome("fails", reads=frozenset())
        return Claim("fine", none, {})
    row = ladder.row(NEWTON, RULE, counts[0])
    ratio = others.cell("step_cost", f"stiff/substeps-{counts[0]}", "frame_ratio")
    return Claim(
        "fine",
        at_most(row.slip_mm, bound).having_read(ratio),
        {
            "substeps": row.substeps,
            "step": row.substep_ms,
            "ke": row.pad_ke,
            "kd": row.pad_kd,
            "slip": row.slip_mm,
            "bound": bound,
            "ratio": ratio,
        },
    )


def _table(results: Results, ladder: Ladder, laws: dict) -> object:
    """Make a table of the pads, slips and run times for each step."""
    others = Sections(results.others)
    counts = ladder.substeps()
    rows = [ladder.row(NEWTON, RULE, count) for count in counts]
    columns: dict[str, list] = {
        "substeps of a frame": [row.substeps for row in rows],
        "kd": [row.pad_kd for row in rows],
        "ke": [row.pad_ke for row in rows],
        "slip, these pads": [_slip_or_lost(row) for row in rows],
        "slip by the law": [laws[NEWTON, RULE, count] for count in counts],
    }
    for pads in ("stiff", "shipped"):
        columns[f"slip, {PADS[pads]}"] = [
            _slip_or_lost(ladder.row(NEWTON, pads, count)) for count in counts
        ]
    times = RowsBy(results, others.rows("step_cost"), "setting", "substeps", "worlds")
    for worlds in (TIMED_WORLDS[0], TIMED_WORLDS[-1]):
        columns[f"run time, {worlds_name(worlds)}"] = [
            times["stiff", count, worlds].frame_ratio
            if ("stiff", count, worlds) in times
            else ""
            for count in counts
        ]
    steps = [row.substep_ms for row in rows]
    return table_of("step", steps, columns)


def _slip_or_lost(row: Row) -> Quantity | str:
    return "lost" if row.plain.get("dropped") else row.slip_mm


def _figure(ladder: Ladder) -> Figure:
    """Draw the slip of each remedy against the step."""
    lines = {}
    for key in REMEDIES:
        rows = [ladder.row(*key, count) for count in ladder.substeps(*key)]
        lines[key] = [row for row in rows if is_held(row)]
    cells = [row.slip_mm for rows in lines.values() for row in rows]
    return Figure(lambda: _draw(lines), cells)


def _draw(lines: dict[tuple[str, str], list[Row]]) -> Drawing:
    drawing, axes = new_figure(7.2, 4.2)
    for key, rows in lines.items():
        if not rows:
            continue
        name, colour, marker = REMEDIES[key]
        steps = [row.substep_ms.number for row in rows]
        slips = [row.slip_mm.number for row in rows]
        axes.plot(
            steps, slips, color=colour, marker=marker, linestyle="-", markevery=1
        )
        write_beside(
            axes, name, (steps[-1], slips[-1]), (-6, 0), color=colour, ha="right", va="center", fontsize=9
        )
    axes.set(
        xscale="log",
        yscale="log",
        xlabel="time step [ms]",
        ylabel="slip in the whole shake [mm]",
    )
    axes.set_xlim(left=0.02)
    tick_at(axes.xaxis, [0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0])
    return drawing
