"""Makes the report on a target: its size, its findings and its predicted creep."""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

import mujoco
import numpy as np

from newton_lint.changes import Changes
from newton_lint.findings import SEVERITIES, Finding, number, sentence
from newton_lint.grips import SLIP_MM_S, grips
from newton_lint.ledger import MOST_DOFS, Run, runs_of
from newton_lint.motion import motions, symptoms
from newton_lint.pairs import masks_of, read
from newton_lint.prediction import Load, Prediction, predictions
from newton_lint.rules import faults, lint
from newton_lint.scene import Engine, Scene
from newton_lint.settings import is_ignored
from newton_lint.source import Element, Source
from newton_lint.target import NEWTONS, Target, TargetError, newtons
from newton_lint.trials import Trials

SHORTEST_S = 1e-6
LONGEST_S = 1.0
"""Range of the time step."""
# Numbers above this have infinite squares.
HUGE = 1e100
KEYS = ("rule", "shape", "against", "parameter", "value", "used", "unit")
MUJOCO_C = Engine()
# Fields of the model with these prefixes are checked for such numbers.
NUMBERS = ("geom_", "pair_", "body_", "dof_", "actuator_gain", "actuator_bias")


@dataclass(frozen=True)
class Request:
    """Options of the command other than the targets."""

    engine: Engine = field(default_factory=Engine)
    load: Load = field(default_factory=Load)
    below_mm_s: float = SLIP_MM_S
    """The creep of a body is a finding if it is at least this fast."""
    ignore: Collection[str] = ()
    step: bool = True
    """Whether to step the scene in MuJoCo C."""


@dataclass(frozen=True)
class Report:
    """The report on a target."""

    target: str
    dt_s: float
    shape_count: int
    pair_count: int
    load: Load
    findings: Sequence[Finding]
    creep: Sequence[Prediction]
    newton: str | None = None
    """The release of Newton that read the target, or None."""
    runs: Sequence[Run] = ()
    source: Source | None = None
    """The files that a fix may change."""

    def worst(self) -> int:
        """Return the index in ``SEVERITIES`` of the worst finding, or -1."""
        return max(
            (SEVERITIES.index(finding.severity) for finding in self.findings),
            default=-1,
        )


def report_of(target: Target, request: Request) -> Report:
    """Lint a target.

    Raises:
        TargetError: MuJoCo aborts, or Newton is needed but missing.
    """
    try:
        return _report_of(target, request)
    except mujoco.FatalError as error:
        raise TargetError(
            f"{target.name}: MuJoCo aborts with: {' '.join(str(error).split())}"
        ) from error


def _report_of(target: Target, request: Request) -> Report:
    if target.newton_model is not None:
        return newtons(target.name, NEWTONS, "report_of", target, request)
    scene = scene_of(target, request.engine)
    report = report_on(scene, target, request)
    if request.engine.name == "newton" and target.path:
        more = _newton_findings(target, request, report.findings)
        return replace(report, findings=[*report.findings, *more])
    return report


def report_on(
    scene: Scene, target: Target, request: Request, more: Sequence[Finding] = ()
) -> Report:
    """Lint a scene.

    Args:
        more: Findings of other rules.
    """
    model = scene.model
    runs = runs_of(model, target.data) if request.step else []

    holding = partial(
        grips,
        acceleration_m_s2=request.load.acceleration_m_s2,
        below_mm_s=request.below_mm_s,
    )

    def judge(scene: Scene, runs: Sequence[Run]):
        findings = [finding for group, _ in faults(scene, runs) for finding in group]
        return findings, symptoms(scene, runs, holding)

    trials = Trials(scene, runs, judge)
    findings = [*more, *lint(trials)]
    # Creep is undefined if the engine refuses the scene or throws bodies off.
    refused = any(finding.rule in ("engine", "stiff") for finding in findings)
    findings += motions(trials)
    limits = []
    if request.step and model.nv > MOST_DOFS:
        message = (
            "The scene has $value degrees of freedom and is not stepped, because the"
            f" limit is {number(MOST_DOFS)}"
        )
        limits.append(("unstepped", "", "nv", model.nv, message))
    if (count := len(read(model))) < np.count_nonzero(masks_of(model)):
        message = (
            "Only $value of the shapes are read, because there are too many pairs;"
            " every other shape has the same contact parameters as one of these"
        )
        limits.append(("unread", "", "pairs", count, message))
    findings += [Finding(*limit, severity="note") for limit in limits]
    return Report(
        target=target.name,
        dt_s=scene.option.timestep_s,
        shape_count=scene.colliding,
        pair_count=len(scene.contacts),
        load=request.load,
        findings=[
            finding
            for finding in findings
            if not is_ignored(finding, scene.source, request.ignore)
        ],
        creep=[] if refused else predictions(scene, request.load),
        runs=runs,
        source=scene.source,
    )


def _newton_findings(
    target: Target, request: Request, findings: Sequence[Finding]
) -> Iterator[Finding]:
    """Yield findings in the file as Newton imports it, by rules with no finding yet."""
    rules = {finding.rule for finding in findings}
    imported = replace(
        target, newton_model=newtons(target.name, NEWTONS, "imported", target.path)
    )
    report = newtons(target.name, NEWTONS, "report_of", imported, request)
    assert (
        target.model is not None
    )  # Files that only Newton reads are not handled here.
    gravity = target.model.opt.gravity[2]
    imported_gravity = float(np.ravel(imported.newton_model.gravity.numpy())[2])
    if not np.isclose(gravity, imported_gravity, rtol=1e-3):
        yield Finding(
            "importer",
            "",
            "gravity",
            gravity,
            "The scene has a gravity of $value m/s², but Newton's importer"
            " reads $used m/s²",
            used=imported_gravity,
        )
    if target.model.npair:
        message = (
            "Newton's own contacts do not read the $value <pair> elements of the scene"
            " (newton#3644)"
        )
        yield Finding("importer", "", "pairs", float(target.model.npair), message)
    yield from (finding for finding in report.findings if finding.rule not in rules)


def scene_of(target: Target, engine: Engine = MUJOCO_C) -> Scene:
    """Return the scene of a target, or raise TargetError if it cannot be simulated."""
    if target.model is None:
        raise TargetError(f"{target.name}: expected a MuJoCo model, got a Newton model")
    step = engine.timestep_s or target.model.opt.timestep
    # A run of 2 s needs at least one step, and must end in an acceptable time.
    if not SHORTEST_S <= step <= LONGEST_S:
        raise TargetError(
            f"{target.name}: the time step is {step:g} s: use {SHORTEST_S:g} to"
            f" {LONGEST_S:g} s"
        )
    numbers = {
        name: getattr(target.model, name)
        for name in dir(target.model)
        if name.startswith(NUMBERS)
    }
    for name in ("impratio", "gravity", "timestep"):
        numbers[name] = np.asarray(getattr(target.model.opt, name))
    for name, values in numbers.items():
        if values.dtype == np.float64 and not (np.abs(values) <= HUGE).all():
            raise TargetError(
                f"{target.name}: {name} is not finite or exceeds {HUGE:g}: use smaller"
                " numbers"
            )
    return Scene(
        engine.configured(target.model),
        Source.of(target.path, target.model, target.texts),
        engine,
        target.texts,
    )


def as_json(report: Report) -> dict[str, Any]:
    """Return the object that ``--json`` prints; docs/lint.md documents it."""
    return {
        "schema": 2,
        **{
            name: getattr(report, name)
            for name in ("target", "newton", "dt_s", "shape_count", "pair_count")
        },
        "findings": [_finding_json(finding) for finding in report.findings],
        "creep": [vars(report.load) | vars(prediction) for prediction in report.creep],
        "hold": None,
    }


def _finding_json(finding: Finding) -> dict[str, Any]:
    cures = [
        vars(cure) | {"changes": _changes_json(cure.changes), "text": str(cure)}
        for cure in finding.cures
    ]
    return {
        **{name: getattr(finding, name) for name in KEYS},
        "message": sentence([finding]),
        "severity": finding.severity,
        **_location(finding.element),
        "advice": finding.advice or None,
        "changes": cures[0]["changes"] if cures else [],
        "cures": cures,
    }


def _changes_json(changes: Changes) -> list[dict[str, Any]]:
    return [
        {
            "subject": change.subject,
            "kind": change.kind,
            "attributes": dict(change.attributes),
            **_location(change.element),
        }
        for change in changes
    ]


def _location(element: Element | None) -> dict[str, Any]:
    return {
        "file": str(element.file) if element else None,
        "line": element.line if element else None,
    }
