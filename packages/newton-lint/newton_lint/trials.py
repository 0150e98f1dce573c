"""Tries changes: steps the changed scene from all starts for 2 s, and judges it."""

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import mujoco
from mujoco import MjModel

from newton_lint.changes import Changes, applied
from newton_lint.findings import Cure, Finding, Remedy, number
from newton_lint.fix import Unwritable, edited
from newton_lint.law import M
from newton_lint.ledger import SPAN_S, Run, run_of
from newton_lint.scene import Scene
from newton_lint.source import Element
from newton_lint.target import compiled

THROWN_M_S = 0.5
"""Contacts cannot give a resting or falling body this speed."""
MENDS = 0.5
"""A change is recommended if it leaves less than this share of the value."""
GOOD = 0.2
"""After a change that leaves less than this share, no further ones are tried."""
BUDGET_S = 2.0
"""Changes are tried for this processor time per scene."""
MOST_CURES = 2
# Contacts may become this many times as deep, and this much deeper [m].
DEEPER = 1.1
DEEPER_M = 5e-5
# Motions may become this many times as fast, and this much faster [m/s or rad/s].
FASTER = 1.2
FASTER_M_S = 5e-3
SLOWER = 1.8
"""A change may multiply the solver's effort for a simulated second by at most this."""
SHALLOW_M = 2e-3
"""A body whose contacts are below this depth no longer falls through."""
FALLS_M_S = 3.0
"""A body falls if it reaches this speed."""
FREES = (
    "lost",
    "stiff",
    "thrown",
    "unstable",
    "damping",
    "jitter",
    "tunnel",
    "bounce",
    "solver",
)
"""Rules on simulations that take little effort only because they are wrong."""
MOVING = ("friction", "bounce", "thrown")
"""Rules whose changes make bodies faster, as intended by the parameters."""
SINKING = ("tunnel", "slides", "through", "damping")
"""Rules on bodies that may touch something only after the change."""
WRITTEN = ("lost", "pyramid", "solref-format", "stiff", "one-sided")
"""Rules whose changes make contacts as soft as they are written."""
LEADING = ("equality", "keyframe", "limit", "servo", "apart", "degrees")
"""Rules whose changes lead to other motions, with other impacts on the way."""
Read = Callable[[Run], float]
"""Returns a reading of a run, in the unit of a finding."""


@dataclass(frozen=True)
class Symptom:
    """A finding in a run, with the reading behind it and changes that may mend it."""

    finding: Finding
    read: Read
    ways: Sequence[Changes]
    needs_cure: bool = False
    """Whether to report it only if one of the changes mends it."""
    effect: str = ""
    """The effect of the changes in words, with {} for the reading after them."""
    unit: str = ""
    """The unit of the reading, if it differs from that of the finding."""
    why: str = ""
    """The likely cause, which is printed only if changing it helps."""


Judge = Callable[
    [Scene, Sequence[Run]], tuple[list[Finding], list[tuple[int, Symptom]]]
]
"""Returns the faults in the parameters of a scene and, by run, in its motion."""


@dataclass
class Trials:
    """The runs of a scene or of a variant of it, and the variants that were tried."""

    scene: Scene
    runs: Sequence[Run]
    judge: Judge = lambda *_: ([], [])
    known: Collection[str] = ()
    """Rules with findings on the scene that this is a variant of."""
    spent_s: float = 0.0
    variants: dict[Changes, "Trials | None"] = field(default_factory=dict)

    @cached_property
    def judged(self) -> tuple[list[Finding], list[tuple[int, Symptom]]]:
        return self.judge(self.scene, self.runs)

    @cached_property
    def worst(self) -> dict[str, float]:
        """Return the largest value of each rule."""
        findings, symptoms = self.judged
        values = [
            (abs(finding.value), finding.rule)
            for finding in (*findings, *(symptom.finding for _, symptom in symptoms))
        ]
        return {rule: value for value, rule in sorted(values)}

    @cached_property
    def faults(self) -> list[Finding]:
        """Return the warnings and errors of a variant."""
        findings, symptoms = self.judged
        inner = Trials(self.scene, self.runs)
        certain = [
            symptom.finding
            for index, symptom in symptoms
            # A symptom that counts only if something mends it is tried on top of the
            # changes.
            if not symptom.needs_cure
            or symptom.finding.rule in self.known
            or inner.finding_of(symptom, index)
        ]
        return [item for item in (*findings, *certain) if item.severity != "note"]

    def model(self, changes: Changes) -> MjModel | None:
        """Return the changed model, or None if it cannot be made."""
        scene = self.scene
        if model := applied(scene.model, changes):
            return model
        root = scene.source.root
        if root is None:
            return None
        try:
            # Attributes that only the compiler reads need a changed file.
            texts = dict(scene.texts)
            texts |= edited(changes, scene.source, texts)
            return scene.engine.configured(compiled(root.file, texts))
        except (Unwritable, ValueError, mujoco.FatalError):
            return None

    def variant(self, changes: Changes) -> "Trials | None":
        """Return the trials of a changed scene, or None if it cannot be stepped."""
        if changes not in self.variants:
            # A variant of a run that stopped early cannot be compared with it.
            long = all(run.time_s > 0.99 * SPAN_S or run.bad for run in self.runs)
            model = None
            if changes and long and self.spent_s < BUDGET_S:
                model = self.model(changes)
            self.variants[changes] = self._stepped(model) if model else None
        return self.variants[changes]

    def _stepped(self, model: MjModel) -> "Trials":
        runs = [run_of(model, run.start) for run in self.runs]
        self.spent_s += sum(run.spent_s for run in runs)
        return Trials(replace(self.scene, model=model), runs, self.judge, self.worst)

    def refuses(self, variant: "Trials", finding: Finding) -> bool:
        """Return whether a variant does harm or has a worse fault of another kind."""
        if any(run.bad or run.time_s < 0.99 * SPAN_S for run in variant.runs):
            return True
        if harm(self.runs, variant.runs, [finding.rule]):
            return True
        return any(
            fault.rule != finding.rule
            and abs(fault.value) > DEEPER * self.worst.get(fault.rule, 0.0)
            and (fault.severity == "error" or finding.severity != "error")
            for fault in variant.faults
        )

    def drawback(self, variant: "Trials", finding: Finding) -> str:
        """Return the harm of changes whose rule is meant to make bodies faster."""
        is_meant = finding.rule in MOVING
        reasons = map(faster, self.runs, variant.runs) if is_meant else ()
        return next(filter(None, reasons), "")

    def finding_of(self, symptom: Symptom, index: int) -> Finding | None:
        """Return the finding of a symptom in a run with the changes that mend it."""
        finding = symptom.finding
        # Notes are seldom read, so no changes are tried for them.
        ways = symptom.ways if finding.severity != "note" else ()
        before = symptom.read(self.runs[index])
        cures: list[Cure] = []
        was_tried = False
        for changes in ways:
            if (variant := self.variant(changes)) is None:
                continue
            was_tried = True
            if self.refuses(variant, finding):
                continue
            after = symptom.read(variant.runs[index])
            # The negation also refuses NaN.
            if not after < MENDS * before:
                continue
            unit = symptom.unit or finding.unit
            drawback = self.drawback(variant, finding)
            cures.append(Cure(changes, before, after, unit, symptom.effect, drawback))
            if after <= GOOD * before or len(cures) == MOST_CURES:
                break
        if symptom.needs_cure and not cures:
            return None
        if symptom.why and (cures or finding.severity == "note"):
            message = f"{finding.message} because {symptom.why}"
            finding = replace(finding, message=message)
        if was_tried and not cures and not finding.hint:
            finding = replace(finding, hint="None of the tried changes helps.")
        # Changes that mend it well come first; the sort keeps the order of the rule.
        cures.sort(key=lambda cure: (cure.after or 0.0) > GOOD * before)
        element = finding.element or self.scene.place(finding.shape)
        return replace(finding, cures=tuple(cures), element=element)

    def advised(self, group: Sequence[Finding], remedy: Remedy) -> list[Finding]:
        """Return equal findings with the changes that do no harm from any start."""
        finding = group[0]
        scene = self.scene
        cures: list[Cure] = []
        hints = [effect for changes, effect in remedy if not changes]
        for changes, effect in remedy if finding.severity != "note" else ():
            if not changes or len(cures) == MOST_CURES:
                continue
            drawback = ""
            if self.runs:
                variant = self.variant(changes)
                if variant is None or self.refuses(variant, finding):
                    continue
                if any(
                    (item.rule, item.shape) == (finding.rule, finding.shape)
                    and abs(item.value) > MENDS * abs(finding.value)
                    for item in variant.judged[0]
                ):
                    continue
                drawback = self.drawback(variant, finding)
            cures.append(Cure(changes, effect=effect, drawback=drawback))
        all_changes = [change for changes, _ in remedy for change in changes]

        def place(finding: Finding) -> Element | None:
            places = [
                change.element
                for change in all_changes
                if len(group) == 1
                or any(scene.names[geom] == finding.shape for geom in change.ids)
            ]
            own = [finding.element, *places, scene.place(finding.shape)]
            return next(filter(None, own), None)

        return [
            replace(
                finding,
                cures=tuple(cures),
                hint=" ".join(hints),
                element=place(finding),
            )
            for finding in group
        ]


def harm(before: Sequence[Run], after: Sequence[Run], rules: Collection[str]) -> str:
    """Return the harm that a change for these rules does, or an empty string."""
    for old, new in zip(before, after, strict=True):
        if new.bad:
            start = new.start.name
            return f"the simulation blows up after {new.time_s:.3g} s from {start}"
        if not old.bad and (reason := _motion_harm(old, new, rules)):
            return reason
    if {*FREES} & {*rules}:
        return ""
    old_effort = sum(run.effort for run in before)
    new_effort = sum(run.effort for run in after)
    if new_effort <= SLOWER * old_effort:
        return ""
    ratio = number(new_effort / old_effort, 2)
    return f"a simulated second costs {ratio} times as much"


def _motion_harm(old: Run, new: Run, rules: Collection[str]) -> str:
    """Describe how contacts get deeper or bodies faster, or return an empty string."""
    old_thrown = old.thrown_m_s.max(initial=0.0)
    new_thrown = new.thrown_m_s.max(initial=0.0)
    if new_thrown > max(FASTER * old_thrown, THROWN_M_S):
        speed = number(new_thrown)
        return f"contacts throw a body at {speed} m/s from {new.start.name}"
    # A body that flew or fell touched nothing, so it may rest in a contact now.
    lies = old_thrown > THROWN_M_S > 2.0 * new_thrown and new.deepest_m <= old.deepest_m
    lies |= bool({*WRITTEN} & {*rules}) and new.deepest_m < SHALLOW_M
    old_fall = old.speeds_m_s.max(initial=0.0)
    new_fall = new.speeds_m_s.max(initial=0.0)
    lies |= old_fall > FALLS_M_S > 2.0 * new_fall and new.late_m < SHALLOW_M
    for name, reading in (
        ("deepest contact", "deepest_m"),
        ("deepest contact at the end", "late_m"),
    ):
        old_depth = getattr(old, reading)
        new_depth = getattr(new, reading)
        deeper = new_depth > DEEPER * old_depth + DEEPER_M
        exempt = (*SINKING, *(LEADING if reading == "deepest_m" else ()))
        if deeper and not lies and not {*exempt} & {*rules}:
            return (
                f"the {name} goes from {number(M * old_depth)} to {number(M * new_depth)} mm"
                f" from {new.start.name}"
            )
    return "" if {*MOVING} & {*rules} else faster(old, new)


def faster(old: Run, new: Run) -> str:
    """Describe how the motion at the end gets faster, or return an empty string."""
    if new.speed <= FASTER * old.speed + FASTER_M_S:
        return ""
    return (
        f"the fastest speed at the end goes from {number(old.speed)} to"
        f" {number(new.speed)} m/s or rad/s"
    )
