"""What is said of a target: its size, what was found in it and the creep to expect."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from newton_lint.findings import SEVERITIES, Finding
from newton_lint.grip import SLIP_MM_S, gripped
from newton_lint.prediction import Load, Prediction, predictions
from newton_lint.rules import lint
from newton_lint.scene import Engine, Scene
from newton_lint.settings import is_ignored
from newton_lint.settle import Hold, Work, held
from newton_lint.source import Element, Source
from newton_lint.step_rules import stepped
from newton_lint.stepped import runs_of
from newton_lint.target import READER, Target, TargetError, newtons

NEWTONS = "newton_lint.newton_models.report"


@dataclass(frozen=True)
class Asked:
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
        return max((SEVERITIES.index(finding.severity) for finding in self.findings), default=-1)


def report_of(target: Target, asked: Asked) -> Report:
    """Lint a target.

    Raises:
        TargetError: It has no such body as is to be held, or Newton is needed and is not there.
    """
    if target.newton_model is not None:
        return newtons(target.name, NEWTONS, "report_of", target, asked)
    scene = scene_of(target, asked.engine)
    found = lint(scene)
    refused = any(each.rule == "engine" and each.severity == "error" for each in found)  # nothing creeps there
    hold = held(scene, target, asked.work) if asked.work and not refused else None
    found += hold.findings(scene, asked.below_mm_s or SLIP_MM_S) if hold else []
    runs = runs_of(scene.model, target) if asked.step else []
    deep = [{each.shape, *each.against} for each in found if each.rule == "depth"]
    more = stepped(scene, target, runs) if asked.step else []
    found += [each for each in more if each.rule != "depth" or not any(known >= {each.shape} for known in deep)]
    found += [] if refused else gripped(scene, runs, asked.work.body if asked.work else "")
    if asked.work and not hold and not refused:
        told = ("slides", asked.work.body, (), "settle", asked.work.settle_s, None, "s")
        message = "passed and nothing touched it: a keyframe, or a function that returns model and data, has to grip it"
        found.append(Finding(*told, message, "error"))
    if asked.engine.name == "newton" and target.path:
        theirs = replace(target, newton_model=newtons(target.name, READER, "imported", target.path))
        known = {each.rule for each in found}
        more = newtons(target.name, NEWTONS, "report_of", theirs, asked).findings
        found += [each for each in more if each.rule not in known]
    return Report(
        target=target.name,
        dt_s=scene.option.timestep_s,
        shape_count=scene.colliding,
        pair_count=len(scene.contacts),
        load=asked.load,
        findings=[each for each in found if not is_ignored(each, scene.source, asked.ignore)],
        creep=[] if refused else predictions(scene, asked.load),
        hold=hold,
        source=scene.source,
    )


def scene_of(target: Target, engine: Engine | None = None) -> Scene:
    engine = engine or Engine()
    if target.model.opt.timestep > 10.0:
        raise TargetError(f"{target.name}: a time step of {target.model.opt.timestep:g} s is too long to simulate")
    return Scene(engine.asked(target.model), Source.of(target.path, target.model, target.texts), engine)


def as_json(report: Report) -> dict[str, Any]:
    """Return what ``--json`` prints; docs/lint.md is its schema."""
    told = ("target", "newton", "dt_s", "shape_count", "pair_count")
    return {
        "schema": 2,
        **{name: getattr(report, name) for name in told},
        "findings": [_finding_json(finding) for finding in report.findings],
        "creep": [_creep_json(prediction, report.load) for prediction in report.creep],
        "hold": report.hold.as_json() if report.hold else None,
    }


def _finding_json(finding: Finding) -> dict[str, Any]:
    names = ("rule", "shape", "against", "parameter", "value", "used", "unit", "message", "severity")
    changes = finding.advice.changes if finding.advice else ()
    return {
        **{name: getattr(finding, name) for name in names},
        **_place(finding.element),
        "advice": str(finding.advice) if finding.advice else None,
        "changes": [
            {"subject": change.subject, "attributes": dict(change.attributes), **_place(change.element)}
            for change in changes
        ],
    }


def _place(element: Element | None) -> dict[str, Any]:
    return {"file": str(element.file) if element else None, "line": element.line if element else None}


def _creep_json(prediction: Prediction, load: Load) -> dict[str, Any]:
    own = vars(prediction) | {"pairs": [list(pair) for pair in prediction.pairs]}
    own["load_deep_mm_s"], own["load_shallow_mm_s"] = prediction.load_mm_s
    names = ("pairs", "timeconst_s", "dmax", "response_s", "acceleration_m_s2", "acceleration_mm_s", "load_n")
    more = ("load_deep_mm_s", "load_shallow_mm_s", "acceleration_s", "is_free")
    told = {name: (own | vars(load))[name] for name in (*names, *more)}
    return {"acceleration_response_s" if name == "acceleration_s" else name: each for name, each in told.items()}
