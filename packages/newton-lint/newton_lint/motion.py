"""Finds faults in the motion of a stepped scene, with changes that mend them."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

from newton_lint.failures import ITERATED, bouncing, jittering, overlapping, unstable
from newton_lint.findings import Finding
from newton_lint.grips import grips
from newton_lint.ledger import Run
from newton_lint.resting import fallen, wandering
from newton_lint.scene import Scene
from newton_lint.starting import ill_posed, leaving, misled, torn
from newton_lint.trials import Symptom, Trials
from newton_lint.yielding import (
    crowded,
    depths,
    equalities,
    limits,
    passing,
    sagging,
    servos,
)

Rule = Callable[[Scene, Run], Iterable[Symptom]]
"""Yields the symptoms of a run."""
CAUSES = ("overlap", "apart", "keyframe", "degrees")
"""Rules on starts that jam or jerk the scene."""
EFFECTS = (
    "depth",
    "equality",
    "limit",
    "servo",
    "tunnel",
    "slip",
    "jitter",
    "bounce",
    "sag",
)
"""Rules whose findings follow from such a start."""


def symptoms(
    scene: Scene, runs: Sequence[Run], holding: Rule = grips
) -> list[tuple[int, Symptom]]:
    """Return the symptoms in the runs of a scene, each with the index of its run.

    Args:
        holding: The rule on grips, with the loads that they have to bear.
    """
    always = (unstable, overlapping, misled, torn)
    settled = (
        sagging,
        leaving,
        passing,
        crowded,
        depths,
        limits,
        equalities,
        servos,
        holding,
        bouncing,
        jittering,
        wandering,
        fallen,
    )
    symptoms = []
    for index, run in enumerate(runs):
        # The scene is probably never used from such a start.
        is_idle = run.start.name == "the start" and (
            scene.model.nkey > 0 or ill_posed(scene, run)
        )
        for rule in always if run.bad else (*always, *settled):
            symptoms += [
                (index, _noted(symptom, is_idle)) for symptom in rule(scene, run)
            ]
    return symptoms


def motions(trials: Trials) -> list[Finding]:
    """Return the findings on the runs of a scene."""
    findings: dict[tuple, Finding] = {}
    for number in range(len(trials.runs)):
        # Findings of all starts are merged, and the worst one of a kind is kept.
        items = [
            finding
            for index, symptom in trials.judged[1]
            if index == number
            and (finding := trials.finding_of(symptom, index)) is not None
        ]
        for item in _without_effects(items):
            key = (item.rule, item.shape, item.against)
            findings[key] = max(findings.get(key, item), item, key=_weight)
    # One change that mends several findings of a rule is printed with the worst one.
    reported: set[tuple] = set()
    for key in sorted(findings, key=lambda key: _weight(findings[key]), reverse=True):
        item = findings[key]
        changes = item.rule, item.cures[:1] and item.cures[0].changes
        if item.cures and changes in reported:
            findings[key] = replace(item, severity="note")
        reported.add(changes)
    return list(findings.values())


def _weight(finding: Finding) -> tuple[bool, float]:
    return finding.severity != "note", finding.value


def _noted(symptom: Symptom, is_note: bool) -> Symptom:
    """Return a symptom, as a note if this is requested and its rule permits it."""
    if not is_note or symptom.finding.rule in ITERATED:
        return symptom
    return replace(symptom, finding=replace(symptom.finding, severity="note"))


def _without_effects(items: Sequence[Finding]) -> list[Finding]:
    """Return the findings of a run; those that are effects of others become notes."""
    # Overlaps that the solver leaves are not faults of the initial positions, and
    # effects of a jam are not faults of their own.
    unsolved = any(
        name == "iterations"
        for item in items
        if item.rule in ITERATED
        for cure in item.cures
        for change in cure.changes
        for name, _ in change.attributes
    )
    # A start that jams or jerks the scene has effects that are not faults of their own.
    jerked = any(item.rule in CAUSES and item.severity != "note" for item in items)
    notes = ("overlap",) * unsolved + EFFECTS * jerked
    return [
        replace(item, severity="note") if item.rule in notes else item for item in items
    ]
