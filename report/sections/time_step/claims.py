"""Test the claims about pads at each time step."""

from collections.abc import Mapping, Sequence
from functools import partial

from experiments.facts.case import AS_SHIPPED
from report.sections import step_cost
from report.sections.time_step.ladder import (
    COMPARED,
    FIRMER,
    GENTLE,
    NEWTON,
    PYRAMIDAL,
    RULE,
    Ladder,
)
from report.shared import (
    HOLDS,
    Claim,
    Outcome,
    Quantity,
    Results,
    Sections,
    absent,
    all_of,
    at_least,
    at_most,
    cell_count,
    combined,
    decided,
    departure,
    greater,
    is_held,
    quantile,
)

FOLLOWED = 0.9  # chosen: the share of the runs that have to follow the law
SHORT_SUBSTEPS = 4 * AS_SHIPPED.substeps


def _claim(name: str, outcome: Outcome, numbers: Mapping[str, Quantity]) -> Claim:
    """Return a claim whose test reads all of its numbers."""
    return Claim(name, outcome.having_read(*numbers.values()), numbers)


def is_best(results: Results, ladder: Ladder) -> Claim:
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
    return _claim(
        "is_best",
        outcome,
        {
            "worst": worst,
            "count": compared,
            "long": ladder.step(counts[0]),
            "short": ladder.step(counts[-1]),
        },
    )


def halves(results: Results, ladder: Ladder) -> Claim:
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


def shipped(results: Results, ladder: Ladder) -> Claim:
    """Test whether shipped pads slip as little as the pads of the rule at the shipped step."""
    shipped = ladder.row(NEWTON, "shipped", AS_SHIPPED.substeps)
    rule = ladder.row(NEWTON, RULE, AS_SHIPPED.substeps)
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
            "step": ladder.step(AS_SHIPPED.substeps),
        },
    )


def finest(ladder: Ladder) -> Claim:
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


def pyramid(ladder: Ladder) -> Claim:
    """Test whether a pyramidal cone needs a smaller ke at a long step."""
    count = ladder.resolved(PYRAMIDAL)[0]
    rule = ladder.row(PYRAMIDAL, RULE, count)
    gentle = ladder.row(PYRAMIDAL, GENTLE, count)
    return _claim(
        "pyramid",
        greater(rule.slip_mm, gentle.slip_mm),
        {
            "step": ladder.step(count),
            "rule": rule.slip_mm,
            "gentle": gentle.slip_mm,
        },
    )


def fixed_pads(ladder: Ladder) -> Claim:
    """Test whether a shorter step makes the slip larger if the pads stay the same."""
    rows = [
        ladder.row(NEWTON, "stiff", n) for n in (AS_SHIPPED.substeps, SHORT_SUBSTEPS)
    ]
    shipped, short = rows
    return _claim(
        "fixed_pads",
        greater(short.slip_mm, shipped.slip_mm),
        {
            "ke": shipped.pad_ke,
            "kd": shipped.pad_kd,
            "step": ladder.step(AS_SHIPPED.substeps),
            "short": ladder.step(SHORT_SUBSTEPS),
            "before": shipped.slip_mm,
            "after": short.slip_mm,
        },
    )


def follows(results: Results, ladder: Ladder, laws: dict) -> Claim:
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
        at_most(most, 10.0, "a useful prediction").having_read(*slips),
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


def margin(results: Results, ladder: Ladder) -> Claim:
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


def fine(results: Results, ladder: Ladder, shipped_is_enough: Claim) -> Claim:
    """Find the longest step at which pads end the creep, and its run time."""
    others = Sections(results.others)
    bound = results.chosen(
        "fine_bound", "a tenth of a slip that can be seen", 0.1, "mm"
    )
    # Shipped pads need no change if they slip as little as the pads of the rule.
    pads = "shipped" if shipped_is_enough.outcome == HOLDS else RULE
    slips = {count: ladder.slip(NEWTON, pads, count) for count in ladder.substeps()}
    counts = [count for count, slip in slips.items() if at_most(slip, bound) == HOLDS]
    if not counts:
        names = ("substeps", "step", "ke", "kd", "slip", "ratio")
        outcome = all_of(*(at_most(slip, bound) for slip in slips.values()))
        return Claim("fine", outcome, dict.fromkeys(names, "") | {"bound": bound})
    row = ladder.row(NEWTON, pads, counts[0])
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
