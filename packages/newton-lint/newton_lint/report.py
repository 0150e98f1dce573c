"""Makes the report on a target: its size, its findings and its predicted creep."""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import mujoco
import numpy as np

from newton_lint.findings import SEVERITIES, Finding, sentence
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
"""Rules whose findings only matter if the shapes touch something soon."""
# Numbers above this have infinite squares.
HUGE = 1e100
MUJOCO_C = Engine()
# Fields of the model with these prefixes are checked for such numbers.
NUMBERS = ("geom_", "pair_", "body_", "dof_", "actuator_gain", "actuator_bias")


@dataclass(frozen=True)
class Request:
    """Options of the command other than the targets."""

    engine: Engine = field(default_factory=Engine)
    load: Load = field(default_factory=Load)
    work: Work | None = None
    below_mm_s: float | None = None
    """The creep of a held body is a finding above this speed."""
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
    hold: Hold | None = None
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
        TargetError: The body to hold does not exist, MuJoCo aborts, or Newton is needed
            but missing.
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
    findings = lint(scene)
    # Creep is undefined if the engine refuses the scene or throws bodies off.
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
                message="Nothing touches $shape within $value: grip it in a keyframe,"
                " or in the data that the function returns",
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
    """Return the findings, with those on shapes that touch nothing as notes."""
    touched = {
        scene.names[geom]
        for run in runs
        for pair in (*run.first, *run.data.contact.geom.tolist())
        for geom in pair
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
    taken = float(np.ravel(imported.newton_model.gravity.numpy())[2])
    if not np.isclose(gravity, taken, rtol=1e-3):
        yield Finding(
            "importer",
            "",
            "gravity",
            gravity,
            message="The scene has a gravity of $value m/s², but Newton's importer"
            " reads $used m/s²",
            used=taken,
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
    # mj_step accepts any time step, but the number of steps would round to 0.
    if target.model.opt.timestep > 10.0:
        raise TargetError(
            f"{target.name}: the time step of {target.model.opt.timestep:g} s is too"
            " long: use at most 10 s"
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
    )
    return {
        **{name: getattr(finding, name) for name in names},
        "message": sentence([finding]),
        "severity": finding.severity,
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
