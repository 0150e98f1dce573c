"""Pads for each time step: the rule, the slip that the law predicts, and the price."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial

from report.sections import step_cost
from report.shared import (
    FRAME_RATE,
    HOLDS,
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
    Table,
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
    greater,
    is_held,
    quantile,
    table_of,
    worlds_name,
)
from report.shared.drawing import (
    CURE,
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
PADS = {"shipped": "shipped pads", "stiff": "stiff pads"}
CRITICAL = ("kd-0.125", "kd-0.25", "kd-0.5", RULE, "kd-2")
"""Pads with a damping ratio of 1, in the order of their kd."""
COMPARED = ("shipped", "stiff", *CRITICAL)
SHARES = {
    "kd-0.125": "⅛/step",
    "kd-0.25": "¼/step",
    "kd-0.5": "½/step",
    RULE: "1/step",
    "kd-2": "2/step",
}
FIRMER = ("ke-2", "ke-4", "ke-16")
"""Pads with the kd of the rule and a larger ke, in the order of ke."""
SETTINGS = {
    NEWTON: "Newton's contacts, elliptic cone",
    "newton-pyramidal": "Newton's contacts, pyramidal cone",
    "mujoco-elliptic": "MuJoCo's contacts, elliptic cone",
    "mujoco-pyramidal": "MuJoCo's contacts, pyramidal cone",
}
GENTLE = "ke-0.0625"
"""Pads with the kd of the rule and a sixteenth of its ke, for the pyramidal cone."""
RULES = {setting: GENTLE if "pyramidal" in setting else RULE for setting in SETTINGS}
"""The pads that are recommended for each source of contacts."""
MOST_SUBSTEPS = 32  # chosen: with more substeps, rounding decides the slip
ELLIPTIC = (NEWTON, "mujoco-elliptic")
PYRAMIDAL = "newton-pyramidal"
SHIPPED_SUBSTEPS = 16
FRAME_MS = constant(1e3 / FRAME_RATE, "ms")
FOLLOWED = 0.9  # chosen: the share of the runs that have to follow the law
REMEDIES = {
    (NEWTON, "shipped"): ("shipped pads", SHIPPED, "o"),
    (NEWTON, "stiff"): ("the same stiff pads", SERIES[5], "s"),
    (NEWTON, RULE): ("the rule", STIFF, "D"),
    ("cure", "shipped"): ("root cure, shipped pads", CURE, "o"),
    ("rk4", RULE): ("RK4, the rule", SERIES[5], "^"),
    ("c", RULE): ("MuJoCo C, the rule", SERIES[4], "v"),
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

    def step(self, substeps: int) -> Quantity:
        """Return the length of a step [ms], which follows from the number of substeps."""
        name = f"step_{substeps}"
        count = self.row(NEWTON, RULE, substeps).substeps
        return self.results.derived.get(name) or self.results.value(
            name, "length of a frame divided by its substeps", FRAME_MS / count
        )

    def slip(self, setting: str, pads: str, substeps: int) -> Quantity:
        return self.row(setting, pads, substeps).slip_mm

    def resolved(self, setting: str = NEWTON) -> list[int]:
        """Return the numbers of substeps whose step is short enough for the shake."""
        return [count for count in self.substeps(setting) if count > 1]

    def usual(self, setting: str = NEWTON) -> list[int]:
        """Return those of them at which rounding does not decide the slip."""
        return [count for count in self.resolved(setting) if count <= MOST_SUBSTEPS]


def derive(results: Results) -> Section:
    """Derive the rule, its claims, and the tables of slips and run times."""
    rows = RowsBy(results, results.rows, "setting", "pads", "substeps")
    ladder = Ladder(results, rows)
    laws = {
        key: _predicted(results, rows[key], "_".join(map(str, key)))
        for key in rows
        if key[0] in ELLIPTIC and key[1] in COMPARED
    }
    claims = [
        _shipped(results, ladder),
        _is_best(results, ladder),
        _halves(results, ladder),
        _finest(ladder),
        _pyramid(ladder),
        _fixed_pads(ladder),
        _follows(results, ladder, laws),
        _margin(results, ladder),
        _fine(results, ladder),
    ]
    return Section(
        tables={"rule": _table(results, ladder, laws), "grid": _grid(ladder)},
        figures={"steps": _figure(ladder)},
        claims=claims,
    )


def _claim(name: str, outcome: Outcome, numbers: Mapping[str, Quantity]) -> Claim:
    """Return a claim whose test reads all of its numbers."""
    return Claim(name, outcome.having_read(*numbers.values()), numbers)


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
    counts = ladder.usual()
    ratios = []
    for count in counts:
        slips = [
            ladder.slip(NEWTON, pads, count)
            for pads in COMPARED
            if is_held(ladder.row(NEWTON, pads, count))
        ]
        ratios.append(ladder.slip(NEWTON, RULE, count) / combined(min, *slips))
    worst = results.value(
        "rule_worst",
        "largest ratio of the slip by the rule to the smallest slip of all pads at the"
        " same step",
        combined(max, *ratios),
    )
    slips = [ladder.slip(NEWTON, RULE, count) for count in counts]
    compared = results.value(
        "rule_count", "steps that were compared", cell_count(slips)
    )
    outcome = at_most(worst, 1.2, "hardly any difference in a grasp")
    return _claim("is_best", outcome, {"worst": worst, "count": compared})


def _halves(results: Results, ladder: Ladder) -> Claim:
    """Test whether half the step halves the slip, with pads that follow the rule."""
    counts = ladder.usual()
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
    first, last = (ladder.row(NEWTON, RULE, count) for count in (counts[0], counts[-1]))
    return _claim(
        "halves",
        at_least(least, 1.6, "nearly half"),
        {
            "long": ladder.step(counts[0]),
            "short": ladder.step(counts[-1]),
            "before": first.slip_mm,
            "after": last.slip_mm,
        },
    )


def _shipped(results: Results, ladder: Ladder) -> Claim:
    """Test whether shipped pads slip as little as the pads of the rule at the shipped step."""
    shipped = ladder.row(NEWTON, "shipped", SHIPPED_SUBSTEPS)
    rule = ladder.row(NEWTON, RULE, SHIPPED_SUBSTEPS)
    ratio = results.value(
        "shipped_ratio",
        "slip with shipped pads divided by the slip with the pads of the rule, at the shipped step",
        shipped.slip_mm / rule.slip_mm,
    )
    return _claim(
        "shipped_is_enough",
        at_most(ratio, 1.5, "no reason to change the pads"),
        {
            "shipped": shipped.slip_mm,
            "rule": rule.slip_mm,
            "step": ladder.step(SHIPPED_SUBSTEPS),
        },
    )


def _finest(ladder: Ladder) -> Claim:
    """Test whether the shortest step is worse than the next one."""
    *_, next_count, count = ladder.substeps()
    before = ladder.row(NEWTON, RULE, next_count)
    last = ladder.row(NEWTON, RULE, count)
    return _claim(
        "finest",
        greater(last.slip_mm, before.slip_mm),
        {
            "short": ladder.step(count),
            "next": ladder.step(next_count),
            "after": last.slip_mm,
            "before": before.slip_mm,
        },
    )


def _pyramid(ladder: Ladder) -> Claim:
    """Test whether a pyramidal cone needs a smaller ke at a long step."""
    count = ladder.resolved("newton-pyramidal")[0]
    rule = ladder.row("newton-pyramidal", RULE, count)
    gentle = ladder.row("newton-pyramidal", GENTLE, count)
    return _claim(
        "pyramid",
        greater(rule.slip_mm, gentle.slip_mm),
        {
            "step": ladder.step(count),
            "rule": rule.slip_mm,
            "gentle": gentle.slip_mm,
        },
    )


def _fixed_pads(ladder: Ladder) -> Claim:
    """Test whether a shorter step makes the slip larger if the pads stay the same."""
    rows = [
        ladder.row(NEWTON, "stiff", n) for n in (SHIPPED_SUBSTEPS, 4 * SHIPPED_SUBSTEPS)
    ]
    shipped, short = rows
    return _claim(
        "fixed_pads",
        greater(short.slip_mm, shipped.slip_mm),
        {
            "ke": shipped.pad_ke,
            "kd": shipped.pad_kd,
            "step": ladder.step(SHIPPED_SUBSTEPS),
            "short": ladder.step(4 * SHIPPED_SUBSTEPS),
            "before": shipped.slip_mm,
            "after": short.slip_mm,
        },
    )


def _follows(results: Results, ladder: Ladder, laws: dict) -> Claim:
    """Test whether the law predicts the slip of these runs."""
    compared = {
        (setting, pads, count): law
        for (setting, pads, count), law in laws.items()
        if law.value is not None and count in ladder.usual(setting)
    }
    offs = [
        results.value(
            "off_" + "_".join(map(str, key)),
            "absolute difference between the slip and the law, relative to the slip",
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
    return _claim(
        "follows",
        at_most(most, 10.0, "a prediction that one can use").having_read(*slips),
        {
            "most": most,
            "long": ladder.step(ladder.usual()[0]),
            "short": ladder.step(ladder.usual()[-1]),
            "count": results.value(
                "law_count", "runs that were compared", cell_count(slips)
            ),
            "least_slip": results.value(
                "law_least", "smallest slip of these runs", combined(min, *slips)
            ),
            "most_slip": results.value(
                "law_most", "largest slip of these runs", combined(max, *slips)
            ),
        },
    )


def _margin(results: Results, ladder: Ladder) -> Claim:
    """Test how far ke can be raised above the rule before the cube is lost."""
    counts = ladder.resolved()
    held = {
        pads: [is_held(ladder.row(NEWTON, pads, count)) for count in counts]
        for pads in (RULE, *FIRMER)
    }
    firm = [pads for pads in FIRMER if all(held[pads])]
    lost = [pads for pads in FIRMER if not all(held[pads])]

    def factor(name: str, pads: Sequence[str], formula: str) -> Quantity:
        if not pads:
            return absent("1", "no such ke was tried")
        cell = (
            ladder.row(NEWTON, pads[0], counts[0]).pad_ke
            / ladder.row(NEWTON, RULE, counts[0]).pad_ke
        )
        return results.value(name, formula, cell)

    rows = [ladder.row(NEWTON, RULE, count) for count in counts]
    outcome = decided(all(held[RULE]), *(row.substeps for row in rows))
    outcome = outcome.having_read(*(row.slip_mm for row in rows))
    return _claim(
        "margin",
        outcome,
        {
            "safe": factor(
                "ke_safe",
                firm[-1:],
                "largest ke relative to the rule with which every run keeps the cube",
            ),
            "lost": factor(
                "ke_lost",
                lost[:1],
                "smallest ke relative to the rule with which a run loses it",
            ),
            "long": ladder.step(counts[0]),
            "short": ladder.step(counts[-1]),
        },
    )


def _fine(results: Results, ladder: Ladder) -> Claim:
    """Find the longest step at which the rule ends the creep, and its price."""
    others = Sections(results.others)
    bound = results.chosen(
        "fine_bound", "a tenth of a slip that can be seen", 0.1, "mm"
    )
    counts = [
        count
        for count in ladder.substeps()
        if at_most(ladder.slip(NEWTON, RULE, count), bound) == HOLDS
    ]
    slips = [ladder.slip(NEWTON, RULE, count) for count in ladder.substeps()]
    if not counts:
        names = ("substeps", "step", "ke", "kd", "slip", "ratio")
        outcome = all_of(*(at_most(slip, bound) for slip in slips))
        return Claim("fine", outcome, dict.fromkeys(names, "") | {"bound": bound})
    row = ladder.row(NEWTON, RULE, counts[0])
    unmeasured = absent("1", "section step_cost was not measured")
    ratio = step_cost.ratios(others).get(counts[0], unmeasured)
    return _claim(
        "fine",
        all_of(
            at_most(row.slip_mm, bound),
            at_most(ratio, 10.0, "a price that may be worth it"),
        ),
        {
            "substeps": row.substeps,
            "step": ladder.step(counts[0]),
            "ke": row.pad_ke,
            "kd": row.pad_kd,
            "slip": row.slip_mm,
            "bound": bound,
            "ratio": ratio,
        },
    )


def _table(results: Results, ladder: Ladder, laws: dict) -> Table:
    """Make a table of the pads, slips and run times for each step."""
    others = Sections(results.others)
    counts = ladder.substeps()
    rows = [ladder.row(NEWTON, RULE, count) for count in counts]
    columns: dict[str, list] = {
        "substeps": [row.substeps for row in rows],
        "kd": [row.pad_kd for row in rows],
        "ke": [row.pad_ke for row in rows],
        "slip": [_slip_or_lost(row) for row in rows],
        "by the law": [laws[NEWTON, RULE, count] for count in counts],
    }
    for pads in ("stiff", "shipped"):
        columns[PADS[pads]] = [
            _slip_or_lost(ladder.row(NEWTON, pads, count)) for count in counts
        ]
    for worlds in (TIMED_WORLDS[0], TIMED_WORLDS[-1]):
        ratios = step_cost.ratios(others, worlds=worlds)
        columns[f"time, {worlds_name(worlds)}"] = [
            ratios.get(count, "") for count in counts
        ]
    steps = [row.substep_ms for row in rows]
    shipped = ladder.row(NEWTON, RULE, SHIPPED_SUBSTEPS).substeps
    return table_of("step", steps, columns, substeps=shipped)


def _grid(ladder: Ladder) -> Table:
    """Make a table of the slip for each step and kd, with a damping ratio of 1."""
    counts = ladder.substeps()
    steps = [ladder.row(NEWTON, RULE, count).substep_ms for count in counts]
    columns = {
        f"kd = {name}": [
            _slip_or_lost(ladder.row(NEWTON, pads, count)) for count in counts
        ]
        for pads, name in SHARES.items()
    }
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
        axes.plot(steps, slips, color=colour, marker=marker, linestyle="-", markevery=1)
        write_beside(
            axes,
            name,
            (steps[-1], slips[-1]),
            (-6, 0),
            color=colour,
            ha="right",
            va="center",
            fontsize=9,
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
