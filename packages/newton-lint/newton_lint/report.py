"""What is said of a target: its size, what was found in it and the creep to expect."""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import mujoco
import numpy as np

from newton_lint.findings import SEVERITIES, Finding
from newton_lint.grip import SLIP_MM_S, gripped
from newton_lint.prediction import Load, Prediction, predictions
from newton_lint.rules import lint
from newton_lint.scene import Engine, Scene
from newton_lint.settings import is_ignored
from newton_lint.settle import Hold, Work, settled_hold, weigh
from newton_lint.source import Element, Source
from newton_lint.step_rules import stepped
from newton_lint.stepped import Run, runs_of
from newton_lint.target import NEWTONS, Target, TargetError, newtons

OF_CONTACTS = ("timeconst", "solimp", "dampratio", "one-sided", "friction")
"""Rules of which it decides whether anything touches at the start, in a keyframe or soon after."""
# Numbers whose squares are infinite, and what is looked at for them.
HUGE = 1e100
NUMBERS = ("geom_", "pair_", "body_", "dof_", "actuator_gain", "actuator_bias")


@dataclass(frozen=True)
class Request:
    """Options of the command besides the targets."""

    engine: Engine = field(default_factory=Engine)
    load: Load = field(default_factory=Load)
    work: Work | None = None
    below_mm_s: float | None = None
    """Creep from which what is held is a finding."""
    ignore: Collection[str] = ()
    step: bool = True
    """Whether the scene is stepped in MuJoCo C."""


@dataclass(frozen=True)
class Report:
    """A report on a target."""

    target: str
    dt_s: float
    shape_count: int
    pair_count: int
    load: Load
    findings: Sequence[Finding]
    creep: Sequence[Prediction]
    newton: str | None = None
    """The release of Newton that read it; None where none did."""
    hold: Hold | None = None
    source: Source | None = None
    """Of files that a fix may write."""

    def worst(self) -> int:
        """Return the index in ``SEVERITIES`` of the worst finding; -1 where there is none."""
        return max(
            (SEVERITIES.index(finding.severity) for finding in self.findings),
            default=-1,
        )


def report_of(target: Target, request: Request) -> Report:
    """Lint a target; a TargetError where there is no body to be held, MuJoCo stops, or Newton is needed and missing."""
    try:
        return _report_of(target, request)
    except mujoco.FatalError as error:
        raise TargetError(
            f"{target.name}: MuJoCo stops at it: {' '.join(str(error).split())}"
        ) from error


def _report_of(target: Target, request: Request) -> Report:
    if target.newton_model is not None:
        return newtons(target.name, NEWTONS, "report_of", target, request)
    scene = scene_of(target, request.engine)
    findings = lint(scene)
    # Nothing creeps in an engine that does not take the scene, nor what it throws off.
    refused = any(finding.rule in ("engine", "stiff") for finding in findings)
    work = None if refused else request.work
    hold = settled_hold(scene, target, work) if work else None
    if hold:
        findings += hold.findings(scene, request.below_mm_s or SLIP_MM_S)
    runs = runs_of(scene.model, target) if request.step else []
    for run in runs:
        weigh(scene, run.data)
    findings += stepped(scene, runs) if request.step else []
    findings = _noted(scene, runs, findings)
    if not refused:
        findings += gripped(scene, runs, work.body if work else "")
    if work and not hold:
        findings.append(
            Finding(
                "slides",
                work.body,
                "settle",
                work.settle_s,
                "passed and nothing touched it: a keyframe, or a function that returns model and data, has to grip it",
                unit="s",
                severity="error",
            )
        )
    if request.engine.name == "newton" and target.path:
        findings += list(_newton_findings(target, request, findings))
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
        hold=hold,
        source=scene.source,
    )


def _noted(
    scene: Scene, runs: Sequence[Run], findings: Sequence[Finding]
) -> list[Finding]:
    """Return findings, those of parameters of what touches nothing as notes: it may be no part of what is done."""
    touched = {scene.names[geom] for run in runs for pair in run.first for geom in pair}
    touched |= {
        scene.names[geom]
        for run in runs
        for geom in run.data.contact.geom.ravel().tolist()
        if geom >= 0
    }
    may_touch = not runs or any(run.bad for run in runs)

    def is_idle(finding: Finding) -> bool:
        touches = finding.shape in touched and not (
            finding.against and touched.isdisjoint(finding.against)
        )
        return (
            finding.severity == "warning"
            and finding.rule in OF_CONTACTS
            and not (may_touch or touches)
        )

    return [
        replace(finding, severity="note") if is_idle(finding) else finding
        for finding in findings
    ]


def _newton_findings(
    target: Target, request: Request, findings: Sequence[Finding]
) -> Iterator[Finding]:
    """Yield what rules besides those that MuJoCo's model broke find in the file as Newton reads it."""
    rules = {finding.rule for finding in findings}
    imported = replace(
        target, newton_model=newtons(target.name, NEWTONS, "imported", target.path)
    )
    report = newtons(target.name, NEWTONS, "report_of", imported, request)
    assert target.model is not None  # what Newton alone reads is no target of this
    gravity = target.model.opt.gravity[2]
    taken = float(np.ravel(imported.newton_model.gravity.numpy())[2])
    if not np.isclose(gravity, taken, rtol=1e-3):
        message = (
            f"m/s² is what the scene says, and Newton's importer takes {taken:.4g}"
        )
        yield Finding("importer", "", "gravity", gravity, message, used=taken)
    if target.model.npair:
        message = "are not read by Newton's own contacts (newton#3644)"
        yield Finding("importer", "", "pairs", float(target.model.npair), message)
    yield from (finding for finding in report.findings if finding.rule not in rules)


def scene_of(target: Target, engine: Engine | None = None) -> Scene:
    engine = engine or Engine()
    if target.model is None:
        raise TargetError(f"{target.name}: is no model of MuJoCo's")
    if (
        target.model.opt.timestep > 10.0
    ):  # mj_step takes any, and the number of steps would round to none
        raise TargetError(
            f"{target.name}: a time step of {target.model.opt.timestep:g} s is too long to simulate"
        )
    numbers = {
        name: getattr(target.model, name)
        for name in dir(target.model)
        if name.startswith(NUMBERS)
    }
    numbers = {
        name: values for name, values in numbers.items() if values.dtype == np.float64
    }
    numbers |= {
        name: np.atleast_1d(getattr(target.model.opt, name))
        for name in ("impratio", "gravity", "timestep")
    }
    for name, values in numbers.items():
        if (
            np.abs(values[np.isfinite(values)]).max(initial=0.0) > HUGE
            or not np.isfinite(values).all()
        ):
            raise TargetError(
                f"{target.name}: {name} has numbers of {HUGE:g} and more, whose squares are infinite"
            )
    return Scene(
        engine.configured(target.model),
        Source.of(target.path, target.model, target.texts),
        engine,
    )


def as_json(report: Report) -> dict[str, Any]:
    """Return what ``--json`` prints; docs/lint.md is its schema."""
    return {
        "schema": 2,
        **{
            name: getattr(report, name)
            for name in ("target", "newton", "dt_s", "shape_count", "pair_count")
        },
        "findings": [_finding_json(finding) for finding in report.findings],
        "creep": [vars(report.load) | vars(prediction) for prediction in report.creep],
        "hold": report.hold.as_json() if report.hold else None,
    }


def _finding_json(finding: Finding) -> dict[str, Any]:
    names = (
        "rule",
        "shape",
        "against",
        "parameter",
        "value",
        "used",
        "unit",
        "message",
        "severity",
    )
    return {
        **{name: getattr(finding, name) for name in names},
        **_location(finding.element),
        "advice": str(finding.advice) if finding.advice else None,
        "changes": [
            {
                "subject": change.subject,
                "attributes": dict(change.attributes),
                **_location(change.element),
            }
            for change in (finding.advice.changes if finding.advice else ())
        ],
    }


def _location(element: Element | None) -> dict[str, Any]:
    return {
        "file": str(element.file) if element else None,
        "line": element.line if element else None,
    }
